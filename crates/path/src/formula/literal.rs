use exmex::MatchLiteral;

/// Numbers as people write them: `3`, `.5`, `2.5e-3`. The parser's own matcher does not know exponents.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Literal;

impl MatchLiteral for Literal {
    fn is_literal(text: &str) -> Option<&str> {
        let digits = |from: usize| text[from..].bytes().take_while(u8::is_ascii_digit).count();
        let whole = digits(0);
        let fraction = if text[whole..].starts_with('.') { digits(whole + 1) } else { 0 };
        if whole + fraction == 0 {
            return None;
        }
        let mut end = whole + if text[whole..].starts_with('.') { 1 + fraction } else { 0 };
        if text[end..].starts_with(['e', 'E']) {
            let sign = usize::from(text[end + 1..].starts_with(['+', '-']));
            let exponent = digits(end + 1 + sign);
            if exponent > 0 {
                end += 1 + sign + exponent;
            }
        }
        Some(&text[..end])
    }
}
