use super::{Chain, Group, GroupState, JointState, Srdf, SrdfError, SrdfFault};
use crate::xml::{self, Element, TextFault};
use std::path::Path;

impl Srdf {
    /// Reads an SRDF file.
    ///
    /// # Errors
    ///
    /// The file cannot be read, or the reasons of [`Srdf::parse`].
    pub fn read(path: &Path) -> Result<Self, SrdfError> {
        let text = xml::read_text(path).map_err(|fault| match fault {
            TextFault::Read(message) => SrdfFault::Read { message }.into(),
            TextFault::Encoding { line, .. } => {
                SrdfError { fault: SrdfFault::Read { message: "its bytes are not UTF-8".into() }, line: Some(line) }
            }
        });
        Self::parse(&text?)
    }

    /// Reads the text of an SRDF. Collision pairs, end effectors and virtual joints are not looked at.
    ///
    /// # Errors
    ///
    /// The text is not XML or not an SRDF, an attribute is missing, or a position is not a finite number.
    pub fn parse(text: &str) -> Result<Self, SrdfError> {
        let root = xml::read(text, wanted).map_err(|fault| SrdfError {
            fault: SrdfFault::Malformed { message: fault.message },
            line: Some(xml::line(text, fault.bytes.start)),
        })?;
        let reader = Reader { text };
        reader.check_format(&root)?;
        Ok(Self {
            name: root.value("name").unwrap_or_default().to_owned(),
            groups: root.children("group").map(|group| reader.group(group)).collect::<Result<_, _>>()?,
            states: root.children("group_state").map(|state| reader.state(state)).collect::<Result<_, _>>()?,
        })
    }
}

fn wanted(depth: usize, name: &str) -> bool {
    let known: &[&str] = match depth {
        1 => &["group", "group_state", "link"],
        2 => &["chain", "joint", "link", "group"],
        _ => &[],
    };
    known.contains(&name)
}

struct Reader<'a> {
    text: &'a str,
}

impl Reader<'_> {
    fn at(&self, element: &Element, fault: SrdfFault) -> SrdfError {
        SrdfError { fault, line: Some(xml::line(self.text, element.tag.start)) }
    }

    fn check_format(&self, root: &Element) -> Result<(), SrdfError> {
        let found = match root.name.as_str() {
            "robot" if root.child("link").is_none() => return Ok(()),
            "robot" => "a URDF, for it has links".to_owned(),
            name => format!("a file with the root `<{name}>`"),
        };
        Err(self.at(root, SrdfFault::NotSrdf { found }))
    }

    fn value(&self, element: &Element, attribute: &'static str) -> Result<String, SrdfError> {
        let missing = || self.at(element, SrdfFault::Missing { element: element.name.clone(), attribute });
        element.value(attribute).map(str::to_owned).ok_or_else(missing)
    }

    fn names(&self, element: &Element, children: &str) -> Result<Vec<String>, SrdfError> {
        element.children(children).map(|child| self.value(child, "name")).collect()
    }

    fn group(&self, element: &Element) -> Result<Group, SrdfError> {
        let chain =
            |chain: &Element| Ok(Chain { base: self.value(chain, "base_link")?, tip: self.value(chain, "tip_link")? });
        Ok(Group {
            name: self.value(element, "name")?,
            chains: element.children("chain").map(chain).collect::<Result<_, SrdfError>>()?,
            joints: self.names(element, "joint")?,
            links: self.names(element, "link")?,
            groups: self.names(element, "group")?,
        })
    }

    fn state(&self, element: &Element) -> Result<GroupState, SrdfError> {
        let name = self.value(element, "name")?;
        let joint = |joint: &Element| self.joint(joint, &name);
        let joints = element.children("joint").map(joint).collect::<Result<_, _>>()?;
        Ok(GroupState { group: self.value(element, "group")?, joints, name })
    }

    fn joint(&self, element: &Element, state: &str) -> Result<JointState, SrdfError> {
        let (name, value) = (self.value(element, "name")?, self.value(element, "value")?);
        let number = |word: &str| word.parse().ok().filter(|x: &f64| x.is_finite());
        let values: Option<Vec<f64>> = value.split_whitespace().map(number).collect();
        match values.filter(|values| !values.is_empty()) {
            Some(values) => Ok(JointState { name, values }),
            None => Err(self.at(element, SrdfFault::Number { state: state.to_owned(), joint: name, value })),
        }
    }
}
