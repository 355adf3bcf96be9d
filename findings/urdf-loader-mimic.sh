#!/usr/bin/env bash
# urdf-loader 0.13.1 with three 0.187.0 and jsdom 29.1.1 (npm), recorded 2026-11-29.
#
# One would expect: in the three.js robot viewer a joint with <mimic joint="a" multiplier="2" offset="0.3"/> is drawn at
#   2 a + 0.3, always: after loading, and wherever the leader goes.
# What happens: after loading it stands at 0, not at 0.3, until the leader is first set, be it to the 0 it has. A follower
#   that meets its own limit stays there while its leader goes on, so the picture shows a mechanism that cannot be. And
#   setJointValue on the follower moves it alone.
# Why it matters: the viewer is used to check recorded and planned motions by eye. A gripper looks closed that is not, and a player
#   that sends every joint of a /joint_states message can break the coupling it is meant to show.
set -euo pipefail
work=$(mktemp -d); trap 'rm -rf "$work"' EXIT
cd "$work"
npm init -y >/dev/null
npm install --silent --no-audit --no-fund urdf-loader@0.13.1 three@0.187.0 jsdom@29.1.1 >/dev/null
cat > mimic.mjs <<'JS'
import { readFileSync } from 'node:fs';
import { JSDOM } from 'jsdom';

const { window } = new JSDOM('');
Object.assign(globalThis, { DOMParser: window.DOMParser, Document: window.Document, Element: window.Element });
const { default: URDFLoader } = await import('urdf-loader');

const joint = (name, bound, mimic) => `<link name="${name}"/><joint name="${name}" type="revolute">
  <parent link="base"/><child link="${name}"/><axis xyz="0 0 1"/>
  <limit lower="-${bound}" upper="${bound}" effort="1" velocity="1"/>${mimic}</joint>`;
const robot = new URDFLoader().parse(`<robot name="r"><link name="base"/>${joint('a', 3, '')}
  ${joint('b', 1, '<mimic joint="a" multiplier="2" offset="0.3"/>')}</robot>`);
const pose = () => [robot.joints.a.angle, robot.joints.b.angle].map(x => Math.round(x * 1e6) / 1e6);

const version = JSON.parse(readFileSync('node_modules/urdf-loader/package.json')).version;
console.log('urdf-loader', version, '(leader, follower); b = 2 a + 0.3, |b| <= 1');
const seen = {};
const note = name => { seen[name] = pose(); console.log(`  ${name}: ${seen[name].join(', ')}`); };
note('after loading');
robot.setJointValue('a', 0);
note('leader set to 0');
robot.setJointValue('a', 0.2);
note('leader set to 0.2');
robot.setJointValue('a', 0.8);
note('leader set to 0.8');
robot.setJointValue('b', 0.1);
note('follower set to 0.1');
const recorded = [[0, 0], [0, 0.3], [0.2, 0.7], [0.8, 1], [0.8, 0.1]];
const same = JSON.stringify(Object.values(seen)) === JSON.stringify(recorded);
console.log(same ? 'as recorded' : 'CHANGED');
process.exit(same ? 0 : 1);
JS
node mimic.mjs
