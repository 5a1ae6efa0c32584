//! Equations, oracle, physics and the house's rules, in one program: each program is linked with
//! all models.

mod catalogue;
mod chain;
mod common;
mod conditions;
mod constant_angles;
mod contact_cost;
mod derived;
mod digits;
mod emission;
mod equations;
mod far;
mod floors;
mod forms;
mod held;
mod interpreted;
mod kernel;
mod long;
mod oracle;
mod paper;
mod random;
mod read_back;
mod release;
mod runs;
mod scenes;
mod series;
mod typeset;
