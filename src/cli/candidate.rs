//! A program that is scored: started once, asked line by line, started anew when it fails.

use std::io::{self, BufRead, BufReader, Read, Write};
use std::process::{Child, ChildStderr, ChildStdout, Command, ExitStatus, Stdio};
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};
use std::sync::{Arc, Mutex};
use std::thread;
use std::time::{Duration, Instant};

/// No answer is longer: 4 MiB.
const LONGEST_LINE: u64 = 1 << 22;
/// Of what a candidate says last on standard error, so much is kept.
const LONGEST_REMARK: usize = 300;
/// A candidate that is silent in so many starts, and never wrote a line, does not work.
const TRIES: usize = 3;
/// For a last line once the input is closed.
const PATIENCE: Duration = Duration::from_millis(500);

/// A command that answers problems.
pub struct Candidate {
    command: Vec<String>,
    running: Option<Running>,
    /// Whether it ever wrote a line.
    has_spoken: bool,
    /// Problems lost before that, each with a process of its own.
    silences: usize,
}

/// Why there is no answer.
pub enum Silence {
    /// The command cannot start, or never says anything.
    DoesNotWork(String),
    /// This problem is lost.
    Lost(String),
}

enum Event {
    Line(String),
    TooLong,
    NoText,
    Closed,
}

impl Candidate {
    /// Starts the command.
    pub fn start(command: &[String]) -> io::Result<Self> {
        Ok(Candidate {
            command: command.to_vec(),
            running: Some(Running::start(command)?),
            has_spoken: false,
            silences: 0,
        })
    }

    /// The line that it answers to this one, and the time that it took. After any failure the next
    /// question goes to a new process.
    pub fn ask(&mut self, line: &str, limit: Duration) -> (Result<String, Silence>, Duration) {
        let running = match self.running.take() {
            Some(running) => Ok(running),
            None => Running::start(&self.command),
        };
        let mut running = match running {
            Ok(running) => running,
            Err(error) => {
                let silence = Silence::Lost(format!("it cannot be started again: {error}"));
                return (Err(silence), Duration::ZERO);
            }
        };
        let asked = Instant::now();
        let event = running.ask(line, limit);
        let time = asked.elapsed();
        // Also what is no answer shows that it works.
        self.has_spoken |= matches!(event, Ok(Event::Line(_) | Event::TooLong | Event::NoText));
        let answer = match event {
            Ok(Event::Line(answer)) => {
                self.running = Some(running);
                Ok(answer)
            }
            Ok(Event::TooLong) => Err(format!("its line is longer than {LONGEST_LINE} bytes")),
            Ok(Event::NoText) => Err("its line is no UTF-8 text".to_owned()),
            Ok(Event::Closed) => return (Err(self.stopped(&mut running)), time),
            Err(RecvTimeoutError::Timeout) => Err(self.too_slow(&mut running, limit)),
            Err(RecvTimeoutError::Disconnected) => Err("its output cannot be read".to_owned()),
        };
        (answer.map_err(|reason| self.lost(reason)), time)
    }

    /// Gives up this process: its output is out of step with the questions.
    pub fn restart(&mut self) {
        self.running = None;
    }

    /// One problem is lost, or all where it was silent from the first.
    fn lost(&mut self, reason: String) -> Silence {
        if self.has_spoken {
            return Silence::Lost(reason);
        }
        self.silences += 1;
        if self.silences < TRIES {
            return Silence::Lost(reason);
        }
        Silence::DoesNotWork(format!(
            "started {TRIES} times, it never wrote a line; the last time {reason}"
        ))
    }

    fn stopped(&mut self, running: &mut Running) -> Silence {
        let (status, remark) = running.last_words();
        let ended = match status {
            Some(status) => format!("it stopped ({status})"),
            None => "it closed its output".to_owned(),
        };
        let reason = match remark {
            Some(remark) => format!("{ended}: {remark}"),
            None => ended,
        };
        // A shell's words for a command that it cannot find or run.
        let cannot_start = status.and_then(|status| status.code());
        if !self.has_spoken && matches!(cannot_start, Some(126 | 127)) {
            return Silence::DoesNotWork(reason);
        }
        self.lost(reason)
    }

    /// Who forgets to flush is heard when the input ends.
    fn too_slow(&self, running: &mut Running, limit: Duration) -> String {
        let reason = format!("no answer within {} s", limit.as_secs_f64());
        if !self.has_spoken && running.speaks_at_the_end() {
            format!("{reason}, but one when its input was closed: is every line flushed?")
        } else {
            reason
        }
    }
}

/// A process of the candidate's.
struct Running {
    child: Child,
    /// None once its input is closed.
    questions: Option<Sender<String>>,
    events: Receiver<Event>,
    remark: Arc<Mutex<String>>,
}

impl Running {
    fn start(command: &[String]) -> io::Result<Self> {
        let (program, arguments) = command
            .split_first()
            .ok_or_else(|| io::Error::new(io::ErrorKind::InvalidInput, "no command"))?;
        let mut command = Command::new(program);
        command
            .args(arguments)
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped());
        in_own_group(&mut command);
        let mut child = command.spawn()?;
        let (questions, to_ask) = channel::<String>();
        if let Some(mut input) = child.stdin.take() {
            // A candidate that does not read would block whoever writes.
            thread::spawn(move || {
                for line in to_ask {
                    let written = input.write_all(line.as_bytes());
                    if written.and_then(|()| input.flush()).is_err() {
                        break;
                    }
                }
            });
        }
        let (sender, events) = channel();
        if let Some(output) = child.stdout.take() {
            thread::spawn(move || listen(output, &sender));
        }
        let remark = Arc::new(Mutex::new(String::new()));
        if let Some(errors) = child.stderr.take() {
            let remark = Arc::clone(&remark);
            thread::spawn(move || keep_last_line(errors, &remark));
        }
        Ok(Running {
            child,
            questions: Some(questions),
            events,
            remark,
        })
    }

    fn ask(&mut self, line: &str, limit: Duration) -> Result<Event, RecvTimeoutError> {
        // Whatever was written unasked answers nothing; that the output closed stays known.
        while let Ok(event) = self.events.try_recv() {
            if matches!(event, Event::Closed) {
                return Ok(event);
            }
        }
        // Where nobody reads any more the output closes too.
        if let Some(questions) = &self.questions {
            let _ = questions.send(format!("{line}\n"));
        }
        self.events.recv_timeout(limit)
    }

    /// Closes its input, and says whether a line comes of it.
    fn speaks_at_the_end(&mut self) -> bool {
        self.questions = None;
        matches!(self.events.recv_timeout(PATIENCE), Ok(Event::Line(_)))
    }

    /// How it ended, and what it said last on standard error.
    fn last_words(&mut self) -> (Option<ExitStatus>, Option<String>) {
        let patience = Instant::now() + PATIENCE;
        let status = loop {
            match self.child.try_wait() {
                Ok(None) if Instant::now() < patience => thread::sleep(Duration::from_millis(2)),
                Ok(status) => break status,
                Err(_) => break None,
            }
        };
        // The last line may still be on its way.
        thread::sleep(Duration::from_millis(5));
        let remark = self.remark.lock().map(|remark| remark.clone());
        (status, remark.ok().filter(|remark| !remark.is_empty()))
    }
}

impl Drop for Running {
    fn drop(&mut self) {
        end(&mut self.child);
        // Reaps it; a process that cannot be waited for is gone.
        let _ = self.child.wait();
    }
}

/// Its children are to end with it.
#[cfg(unix)]
fn in_own_group(command: &mut Command) {
    use std::os::unix::process::CommandExt;
    command.process_group(0);
}

#[cfg(not(unix))]
fn in_own_group(_: &mut Command) {}

#[cfg(unix)]
fn end(child: &mut Child) {
    use rustix::process::{Pid, Signal, kill_process_group};
    let group = i32::try_from(child.id()).ok().and_then(Pid::from_raw);
    if let Some(group) = group {
        // A group whose members have all ended cannot be ended again.
        let _ = kill_process_group(group, Signal::KILL);
    }
    let _ = child.kill();
}

#[cfg(not(unix))]
fn end(child: &mut Child) {
    let _ = child.kill();
}

/// Sends every line; stops at one that is too long, where the rest cannot be trusted either.
fn listen(output: ChildStdout, events: &Sender<Event>) {
    let mut output = BufReader::new(output);
    loop {
        let mut line = Vec::new();
        let read = output
            .by_ref()
            .take(LONGEST_LINE + 1)
            .read_until(b'\n', &mut line);
        let event = match read {
            Err(_) | Ok(0) => Event::Closed,
            Ok(read) if u64::try_from(read).is_ok_and(|read| read > LONGEST_LINE) => Event::TooLong,
            Ok(_) => match String::from_utf8(line) {
                Ok(line) => Event::Line(line),
                Err(_) => Event::NoText,
            },
        };
        let last = !matches!(event, Event::Line(_));
        if events.send(event).is_err() || last {
            return;
        }
    }
}

fn keep_last_line(errors: ChildStderr, remark: &Mutex<String>) {
    let mut errors = BufReader::new(errors);
    let mut line = Vec::new();
    loop {
        line.clear();
        let read = errors.by_ref().take(1 << 16).read_until(b'\n', &mut line);
        if !matches!(read, Ok(1..)) {
            return;
        }
        let text = String::from_utf8_lossy(&line);
        let words: Vec<&str> = text.split_whitespace().collect();
        if words.is_empty() {
            continue;
        }
        if let Ok(mut remark) = remark.lock() {
            *remark = words.join(" ").chars().take(LONGEST_REMARK).collect();
        }
    }
}
