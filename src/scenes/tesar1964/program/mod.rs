//! Chapter VI: the representative program, and what it computed.
//!
//! The scenes carry the program's statements out, with enclosures for what it computes in exact
//! arithmetic, and in decimal numbers of eight digits for the errors of the machine that printed the
//! results. What it approximates, the exact arc and its derivatives, comes from the library's own
//! designs and closure.

mod level;
mod linkage;
mod listing;
mod row;
mod truth;

pub(in crate::scenes) use level::SCENE as LEVEL;
pub(in crate::scenes) use linkage::SCENE as LINKAGE;
pub(in crate::scenes) use row::SCENE as ROW;
