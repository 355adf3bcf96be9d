//! Prints the state machine of the supervisor: `cargo run -p slideway-motion --example supervisor_diagram > crates/motion/docs/supervisor.md`.

fn main() {
    print!("{}", slideway_motion::supervisor::diagram());
}
