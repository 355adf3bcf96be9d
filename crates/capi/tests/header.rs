//! The header says what the library does: it is written from the sources and compared.

use std::path::Path;

fn written() -> String {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let config = cbindgen::Config::from_file(root.join("cbindgen.toml")).expect("a configuration");
    let bindings =
        cbindgen::Builder::new().with_crate(root).with_config(config).generate().expect("sources that cbindgen reads");
    let mut text = Vec::new();
    bindings.write(&mut text);
    String::from_utf8(text).expect("text")
}

#[test]
fn the_header_is_the_one_that_the_sources_give() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("include/slideway.h");
    let text = written();
    if std::env::var_os("SLIDEWAY_WRITE_HEADER").is_some() {
        std::fs::write(&path, &text).expect("a writable folder");
    }
    let kept = std::fs::read_to_string(&path).expect("the header");
    let differs = kept.lines().zip(text.lines()).position(|(a, b)| a != b);
    assert!(
        kept == text,
        "line {:?} differs; SLIDEWAY_WRITE_HEADER=1 cargo test -p slideway-capi --test header writes it anew",
        differs.map(|line| line + 1)
    );
}
