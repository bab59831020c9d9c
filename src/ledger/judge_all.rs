//! All statements of some papers, on all cores.

use std::collections::HashMap;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc::{self, Sender};
use std::thread;

use super::error::JudgeError;
use super::{Content, Judge, Judgement, Options, Paper, Statement};

/// Bytes of stack of a thread, as the main thread of a program has them.
const STACK: usize = 8 << 20;

/// Judges every statement of every paper, in the order of the print; `done` is told of each one that is
/// judged. On how many cores makes no difference to what is found.
pub fn judge_all(
    papers: &[Paper],
    options: Options,
    mut done: impl FnMut(),
) -> Vec<Vec<Result<Judgement, JudgeError>>> {
    let statements: Vec<&Statement> = papers.iter().flat_map(|paper| &paper.statements).collect();
    let jobs = Jobs::of(&statements);
    let (sender, receiver) = mpsc::channel();
    let mut judged: Vec<(usize, Result<Judgement, JudgeError>)> = Vec::new();
    thread::scope(|scope| {
        let cores = thread::available_parallelism().map_or(1, usize::from);
        let start = |_: &usize| {
            let sender = sender.clone();
            let thread = thread::Builder::new().stack_size(STACK);
            let judge = || jobs.judge(options, sender);
            thread.spawn_scoped(scope, judge).is_ok()
        };
        if (0..cores).filter(start).count() == 0 {
            jobs.judge(options, sender.clone());
        }
        drop(sender);
        judged.extend(receiver.iter().inspect(|_| done()));
    });
    judged.sort_by_key(|(place, _)| *place);
    let mut in_order = judged.into_iter().map(|(_, judgement)| judgement);
    let of_paper = |paper: &Paper| in_order.by_ref().take(paper.statements.len()).collect();
    papers.iter().map(of_paper).collect()
}

/// What statements may share: what is computed for one of them serves the others.
#[derive(PartialEq, Eq, Hash)]
enum Shared<'a> {
    Stage(&'static str, Option<&'a str>),
    Table(&'static str),
}

impl<'a> Shared<'a> {
    fn by(statement: &'a Statement) -> Self {
        match &statement.content {
            Content::Cell { table, .. } | Content::Table(table) => Shared::Table(table.code.name),
            _ => {
                let example = statement.example.as_ref();
                Shared::Stage(
                    statement.scene.name,
                    example.map(|example| example.name.as_str()),
                )
            }
        }
    }
}

/// Statements in groups that share nothing, each with its place.
struct Jobs<'a> {
    groups: Vec<Vec<(usize, &'a Statement)>>,
    next: AtomicUsize,
}

impl<'a> Jobs<'a> {
    fn of(statements: &[&'a Statement]) -> Self {
        let mut groups: Vec<Vec<(usize, &Statement)>> = Vec::new();
        let mut known = HashMap::new();
        for (place, statement) in statements.iter().copied().enumerate() {
            let group = *known.entry(Shared::by(statement)).or_insert(groups.len());
            match groups.get_mut(group) {
                Some(group) => group.push((place, statement)),
                None => groups.push(vec![(place, statement)]),
            }
        }
        Jobs {
            groups,
            next: AtomicUsize::new(0),
        }
    }

    /// Takes one group after the other that nobody has taken, until none is left.
    fn judge(&self, options: Options, judged: Sender<(usize, Result<Judgement, JudgeError>)>) {
        while let Some(group) = self.groups.get(self.next.fetch_add(1, Ordering::Relaxed)) {
            let mut judge = Judge::new(options);
            for (place, statement) in group {
                if judged.send((*place, judge.judge(statement))).is_err() {
                    return;
                }
            }
        }
    }
}
