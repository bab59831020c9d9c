//! Random numbers, turns and points, small enough to be read.

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{RngCore, SeedableRng};
use rug::Rational;

use crate::number::{Exact, Number, count};
use crate::plane::{Angle, Point};

/// Tangents of half angles; those of the first are cosines and sines with small denominators.
const HALVES: [(i64, i64); 22] = [
    (0, 1),
    (1, 2),
    (1, 3),
    (2, 1),
    (3, 1),
    (-1, 2),
    (-1, 3),
    (-2, 1),
    (-3, 1),
    (1, 1),
    (-1, 1),
    (1, 4),
    (-1, 4),
    (4, 1),
    (2, 3),
    (-2, 3),
    (3, 2),
    (-3, 2),
    (1, 5),
    (-5, 1),
    (3, 4),
    (-4, 3),
];

/// A source of random numbers that depends on its seed alone.
pub struct Draw(ChaCha8Rng);

impl Draw {
    pub fn new(seed: u64) -> Self {
        Draw(ChaCha8Rng::seed_from_u64(seed))
    }

    /// One of 0, …, count − 1.
    pub fn below(&mut self, count: u32) -> u32 {
        // The remainder favours no number by more than count/2³².
        self.0.next_u32() % count.max(1)
    }

    /// From −most to most.
    pub fn integer(&mut self, most: u32) -> i64 {
        i64::from(self.below(2 * most + 1)) - i64::from(most)
    }

    /// From 1 to most.
    pub fn positive(&mut self, most: u32) -> i64 {
        i64::from(self.below(most)) + 1
    }

    /// Mostly an integer, else with a denominator up to 7.
    pub fn number(&mut self) -> Rational {
        let denominator = if self.below(3) == 0 {
            self.below(7) + 1
        } else {
            1
        };
        Rational::from((self.integer(9 * denominator), denominator))
    }

    /// A number that is not negative and not zero.
    pub fn length(&mut self) -> Rational {
        let denominator = if self.below(3) == 0 {
            self.below(5) + 1
        } else {
            1
        };
        Rational::from((self.positive(12 * denominator), denominator))
    }

    pub fn point(&mut self) -> Point<Exact> {
        Number::complex(self.number().into(), self.number().into())
    }

    /// A point that is not 0.
    pub fn direction(&mut self) -> Point<Exact> {
        let x = self.positive(6);
        Number::complex(x.into(), self.integer(6).into())
    }

    /// The tangent of half of an angle.
    pub fn half(&mut self) -> Rational {
        let place = count::from_u32(self.below(count::to_u32(HALVES.len())));
        let (numerator, denominator) = HALVES.get(place).copied().unwrap_or((0, 1));
        Rational::from((numerator, denominator))
    }

    pub fn turn(&mut self) -> Point<Exact> {
        turn(&self.half())
    }

    /// Different turns.
    pub fn turns(&mut self, count: usize) -> Vec<Point<Exact>> {
        let mut halves: Vec<Rational> = Vec::new();
        while halves.len() < count.min(HALVES.len()) {
            let half = self.half();
            if !halves.contains(&half) {
                halves.push(half);
            }
        }
        halves.iter().map(turn).collect()
    }
}

/// The turn of this tangent of its half.
pub fn turn(half: &Rational) -> Point<Exact> {
    Angle::from_tan_half(&Number::from(half.clone())).cis()
}
