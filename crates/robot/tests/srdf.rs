//! Groups and named configurations of SRDF files.

use proptest::prelude::*;
use slideway_robot::srdf::{Srdf, SrdfFault};
use slideway_robot::{ChainEnds, RobotDescription};

const SEVEN: &str = include_str!("urdf/seven_axis.urdf");
const SRDF: &str = r#"<?xml version="1.0"?>
<robot name="seven_axis">
  <group name="arm"><chain base_link="link0" tip_link="flange"/></group>
  <group name="listed"><joint name="joint3"/><joint name="joint2"/><joint name="joint1"/></group>
  <group name="by_links"><link name="link4"/><link name="link5"/></group>
  <group name="all"><group name="listed"/><group name="by_links"/><joint name="tcp_joint"/></group>
  <group name="fingers"><joint name="finger1"/><joint name="finger2"/></group>
  <group name="ring"><group name="gnir"/></group>
  <group name="gnir"><group name="ring"/></group>
  <group name="empty"/>
  <group name="stranger"><joint name="knee"/></group>
  <group_state name="home" group="arm">
    <joint name="joint2" value="-0.5"/><joint name="joint1" value="0.25"/><joint name="joint3" value="0"/>
    <joint name="joint4" value=" -2 "/><joint name="joint5" value="1e-1"/><joint name="joint6" value="1.5"/>
    <joint name="joint7" value="0.7"/><joint name="finger1" value="0.04"/>
  </group_state>
  <group_state name="home" group="fingers"><joint name="finger1" value="0.01"/></group_state>
  <end_effector name="hand" parent_link="flange" group="fingers"/>
  <virtual_joint name="v" type="planar" parent_frame="w" child_link="link0"/>
  <disable_collisions link1="link0" link2="link1" reason="Adjacent"/>
</robot>"#;

fn ends(base: &str, tip: &str) -> ChainEnds {
    ChainEnds { base: Some(base.into()), tip: Some(tip.into()) }
}

#[test]
fn a_group_gives_base_and_tip_by_chain_joints_links_or_other_groups() {
    let srdf = Srdf::parse(SRDF).expect("an SRDF");
    for (group, base, tip) in [
        ("arm", "link0", "flange"),
        ("listed", "link0", "link3"),
        ("by_links", "link3", "link5"),
        ("all", "link0", "hand_tcp"),
    ] {
        assert_eq!(srdf.chain_ends(group, SEVEN).expect(group), ends(base, tip), "{group}");
    }
}

#[test]
fn a_configuration_is_put_in_the_order_of_the_arm() {
    let srdf = Srdf::parse(SRDF).expect("an SRDF");
    let arm = RobotDescription::parse_urdf(SEVEN, &srdf.chain_ends("arm", SEVEN).expect("a chain")).expect("an arm");
    let home = srdf.state("home", Some("arm")).expect("there");
    assert_eq!(home.positions(&arm).expect("complete"), [0.25, -0.5, 0.0, -2.0, 0.1, 1.5, 0.7]);
    let part = srdf.state("home", Some("fingers")).expect("there").positions(&arm).expect_err("of another group");
    assert!(part.to_string().contains("configuration `home` has no position of joint `joint1`"));
    assert!(matches!(srdf.state("home", None).expect_err("two").fault, SrdfFault::SeveralStates { .. }));
    assert!(srdf.state("rest", None).expect_err("none").remedy().contains("`home` of `arm`"));
}

#[test]
fn what_is_no_arm_or_no_srdf_is_refused_with_a_remedy() {
    let srdf = Srdf::parse(SRDF).expect("an SRDF");
    for (group, says) in [
        ("leg", "no group called `leg`"),
        ("fingers", "not a chain: joint `finger"),
        ("ring", "group `ring` contains itself"),
        ("empty", "group `empty` has no joint"),
        ("stranger", "the URDF has no joint called `knee`"),
    ] {
        let error = srdf.chain_ends(group, SEVEN).expect_err(says);
        assert!(error.to_string().contains(says) && error.remedy().len() > 10, "{error}");
    }
    for (text, says) in [
        (SEVEN, "line 3: this is not an SRDF but a URDF"),
        ("<sdf/>", "a file with the root `<sdf>`"),
        ("<robot>\n<group/></robot>", "line 2: a `<group>` has no `name`"),
        ("<robot>\n<group name='g'><chain base_link='a'/></group></robot>", "a `<chain>` has no `tip_link`"),
        ("<robot>\n<group name='g'>\n</robot>", "line 2: this is not an SRDF"),
        (
            "<robot><group_state name='s' group='g'><joint name='j' value='x'/></group_state></robot>",
            "joint `j` of the configuration `s`: `x` is not a finite number",
        ),
    ] {
        let error = Srdf::parse(text).expect_err(says);
        assert!(error.to_string().contains(says) && error.remedy().len() > 10, "{error}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 1000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn spoiled_srdfs_never_panic(at in any::<prop::sample::Index>(), length in 0..40_usize, bytes in prop::collection::vec(any::<u8>(), 0..12)) {
        let mut text = SRDF.as_bytes().to_vec();
        let at = at.index(text.len());
        let end = (at + length).min(text.len());
        text.splice(at..end, bytes);
        if let Ok(srdf) = Srdf::parse(&String::from_utf8_lossy(&text)) {
            for group in &srdf.groups {
                let _ = srdf.chain_ends(&group.name, SEVEN).map_err(|error| (error.to_string(), error.remedy()));
            }
        }
    }
}
