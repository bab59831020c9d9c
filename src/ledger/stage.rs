//! A scene set up for judging: exact instances, free symbols, or the numbers of an example.

use std::cell::OnceCell;

use super::Example;
use crate::formula::Bindings;
use crate::number::poly::Fraction;
use crate::number::{Ball, Surd};
use crate::scenes::free::{Given, Random, Symbols};
use crate::scenes::{Scene, Unbuilt};

/// How many random parameters are tried for each configuration that is wanted.
const TRIES: u64 = 100;

/// A scene and, where the statement belongs to one, an example; builds what is asked for, once.
pub struct Stage {
    scene: &'static Scene,
    example: Option<Example>,
    instances: Vec<Bindings<Surd>>,
    next_seed: u64,
    symbolic: OnceCell<Result<Bindings<Fraction>, Unbuilt>>,
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
        let last_seed = TRIES * wanted as u64;
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
    pub fn certified(&self, bits: u32) -> Result<Bindings<Ball>, Unbuilt> {
        match &self.example {
            Some(example) => (self.scene.certified)(&mut Given::new(&example.given, bits)),
            None => Err(Unbuilt::NotHeld("enclosures without an example".to_owned())),
        }
    }
}
