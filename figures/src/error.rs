use slideway_lab::Method;
use slideway_lab::conditioning::PathMethod;
use std::path::PathBuf;
use thiserror::Error;

/// Reason why a study cannot be drawn.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum FigureError {
    /// There is no trace.
    #[error("there is no trace to draw")]
    NoTraces,
    /// A trace has no samples.
    #[error("the trace of {method} is empty")]
    EmptyTrace {
        /// Its method.
        method: Method,
    },
    /// A trace is not finite from its first sample on.
    #[error("the trace of {method} is not finite from its first sample on")]
    NotFinite {
        /// Its method.
        method: Method,
    },
    /// A trace of path conditioning has no samples.
    #[error("the trace of {method} is empty")]
    EmptyPathTrace {
        /// Its method.
        method: PathMethod,
    },
    /// A trace of path conditioning is not finite from its first sample on.
    #[error("the trace of {method} is not finite from its first sample on")]
    PathNotFinite {
        /// Its method.
        method: PathMethod,
    },
    /// Two lists that belong together differ in length, or a list is too short.
    #[error("{what}: {expected} values are needed, {found} were given")]
    Length {
        /// The list.
        what: &'static str,
        /// Length that it must have.
        expected: usize,
        /// Length that it has.
        found: usize,
    },
    /// A list holds a value that cannot be drawn.
    #[error("{what}: value {index} is not usable")]
    Value {
        /// The list.
        what: &'static str,
        /// Position of the first such value, from 0.
        index: usize,
    },
    /// The bundled font is unreadable.
    #[error("the bundled font cannot be read")]
    Font,
    /// The drawing library gave up.
    #[error("cannot draw `{figure}`: {message}")]
    Draw {
        /// Name of the figure.
        figure: &'static str,
        /// Message of the drawing library.
        message: String,
    },
    /// A file cannot be written.
    #[error("cannot write {}: {source}", path.display())]
    Write {
        /// The file.
        path: PathBuf,
        /// Error of the system.
        source: std::io::Error,
    },
}
