//! How a command ends.

use std::io::{self, Write};
use std::process::ExitCode;

/// Why a command ended early.
pub enum Failure {
    /// A wrong call, input or file: one line on standard error, status 2.
    Wrong(String),
    /// Whoever read standard output has gone: nothing is left to say.
    Closed,
}

impl Failure {
    /// A wrong call or input; the message is folded into one line.
    pub fn wrong(message: impl AsRef<str>) -> Self {
        let line: Vec<&str> = message.as_ref().split_whitespace().collect();
        Failure::Wrong(line.join(" "))
    }

    /// Says what is wrong, as far as anybody listens.
    pub fn report(self) -> ExitCode {
        match self {
            Failure::Wrong(line) => {
                // Where standard error is closed too, the status alone must do.
                let _ = writeln!(io::stderr(), "burmester: {line}");
                ExitCode::from(2)
            }
            Failure::Closed => ExitCode::SUCCESS,
        }
    }
}

/// Writes to standard output, without colours where it is no terminal.
pub fn print(text: &str) -> Result<(), Failure> {
    let mut output = anstream::AutoStream::auto(io::stdout().lock());
    output
        .write_all(text.as_bytes())
        .and_then(|()| output.flush())
        .map_err(|error| match error.kind() {
            io::ErrorKind::BrokenPipe => Failure::Closed,
            _ => Failure::wrong(format!("standard output: {error}")),
        })
}
