//! A scene set up for judging: exact instances, free symbols, or the numbers of an example.

use std::cell::OnceCell;
use std::collections::HashMap;
use std::rc::Rc;

use super::Example;
use crate::formula::Bindings;
use crate::number::decimal::{Machine, Rounding};
use crate::number::poly::Fraction;
use crate::number::{Ball, Decimal, Surd, count};
use crate::scenes::free::{Given, Random, Symbols};
use crate::scenes::{Scene, Unbuilt};

/// How many random parameters are tried for each configuration that is wanted.
const TRIES: u64 = 100;

/// How often a machine's computation is emulated, each time with other rounding errors.
const EMULATIONS: u64 = 100;

/// How many inputs are tried within the digits of measured ones.
const SAMPLES: u64 = 40;
/// Their precision.
const SAMPLE_BITS: u32 = 128;

/// A scene and, where the statement belongs to one, an example; builds what is asked for, once.
pub struct Stage {
    scene: &'static Scene,
    example: Option<Example>,
    instances: Vec<Bindings<Surd>>,
    next_seed: u64,
    symbolic: OnceCell<Result<Bindings<Fraction>, Unbuilt>>,
    enclosed: HashMap<u32, Rc<Bindings<Ball>>>,
    emulated: OnceCell<Vec<Bindings<Decimal>>>,
    sampled: Vec<Option<Rc<Bindings<Ball>>>>,
}

impl Stage {
    /// Sets up nothing yet.
    pub fn new(scene: &'static Scene, example: Option<Example>) -> Self {
        Stage {
            scene,
            example,
            instances: Vec::new(),
            next_seed: 0,
            symbolic: OnceCell::new(),
            enclosed: HashMap::new(),
            emulated: OnceCell::new(),
            sampled: Vec::new(),
        }
    }

    /// The scene.
    pub fn scene(&self) -> &'static Scene {
        self.scene
    }

    /// The example, if the stage has one.
    pub fn example(&self) -> Option<&Example> {
        self.example.as_ref()
    }

    /// So many exact configurations: random ones, or the one of the example. Fewer where the scene
    /// has no more that exact numbers hold.
    pub fn instances(&mut self, wanted: usize) -> Result<&[Bindings<Surd>], Unbuilt> {
        if let Some(example) = &self.example {
            if self.instances.is_empty() {
                match (self.scene.exact)(&mut Given::new(&example.given, ())) {
                    Ok(bindings) => self.instances.push(bindings),
                    Err(Unbuilt::NotHeld(_)) => {}
                    Err(other) => return Err(other),
                }
            }
            return Ok(&self.instances);
        }
        let last_seed = TRIES * count::to_u64(wanted);
        while self.instances.len() < wanted && self.next_seed < last_seed {
            let seed = self.next_seed;
            self.next_seed += 1;
            match (self.scene.exact)(&mut Random::new(seed)) {
                Ok(bindings) => self.instances.push(bindings),
                Err(Unbuilt::NotReal(_) | Unbuilt::NotHeld(_)) => {}
                Err(wrong) => return Err(wrong),
            }
        }
        let found = self.instances.len().min(wanted);
        Ok(self.instances.get(..found).unwrap_or(&self.instances))
    }

    /// The scene with free symbols, where it is rational in them.
    pub fn symbolic(&self) -> Result<&Bindings<Fraction>, &Unbuilt> {
        self.symbolic
            .get_or_init(|| (self.scene.symbolic)(&mut Symbols::default()))
            .as_ref()
    }

    /// The example in enclosures of this many bits.
    pub fn certified(&mut self, bits: u32) -> Result<Rc<Bindings<Ball>>, Unbuilt> {
        if let Some(known) = self.enclosed.get(&bits) {
            return Ok(known.clone());
        }
        let Some(example) = &self.example else {
            return Err(Unbuilt::NotHeld("enclosures without an example".to_owned()));
        };
        let bindings = Rc::new((self.scene.certified)(&mut Given::new(
            &example.given,
            bits,
        ))?);
        self.enclosed.insert(bits, bindings.clone());
        Ok(bindings)
    }

    /// The example as the machine may have computed it that printed its numbers, several times; empty
    /// where there is no machine.
    pub fn emulated(&self) -> &[Bindings<Decimal>] {
        let build = || {
            let (Some(example), Some(machine)) = (&self.example, &self.scene.machine) else {
                return Vec::new();
            };
            let run = |seed| {
                let machine_of_seed = Machine::new(machine.digits, Rounding::Scattered(seed))?;
                let built = (machine.build)(&mut Given::new(&example.given, machine_of_seed));
                built.ok().filter(Bindings::is_complete)
            };
            (0..EMULATIONS).filter_map(run).collect()
        };
        self.emulated.get_or_init(build)
    }

    /// The example with its measured parameters somewhere within their printed digits, a number of times,
    /// as they are asked for; none where nothing is measured.
    pub fn samples(&mut self) -> impl Iterator<Item = Rc<Bindings<Ball>>> + '_ {
        let is_measured = self
            .example
            .as_ref()
            .is_some_and(|example| !example.measured.is_empty());
        let count = if is_measured { SAMPLES } else { 0 };
        (0..count).filter_map(move |seed| {
            let known = usize::try_from(seed).ok()?;
            if self.sampled.len() <= known {
                let given = self.example.as_ref()?.sample(seed);
                let built = (self.scene.certified)(&mut Given::new(&given, SAMPLE_BITS));
                self.sampled.push(built.ok().map(Rc::new));
            }
            self.sampled.get(known).cloned().flatten()
        })
    }
}
