// Looks at a page as a person would, in headless Chromium:
//   node tests/page/page_test.mjs PAGE.html REPORT.json truth|distances|photographs|benchmark
// Exits with 1 and says what is wrong.
import assert from 'node:assert/strict';
import {readFileSync} from 'node:fs';
import {resolve} from 'node:path';
import {pathToFileURL} from 'node:url';

import {Browser} from './webdriver.mjs';

const [pagePath, reportPath, kind] = process.argv.slice(2);
const report = JSON.parse(readFileSync(reportPath, 'utf8'));
const percent = value => (100 * value).toPrecision(4);
const share = value => (100 * value).toFixed(2);
const arrowRight = '\uE014';

let browser;

async function open(width, height) {
  await browser.emulate(width, height);
  await browser.open(pathToFileURL(resolve(pagePath)).href);
  await browser.waitFor('the page is ready',
    'return document.documentElement.dataset.ready !== undefined');
}

// A small copy of the picture: the mean brightness of each of 16 x 16 parts.
function picture() {
  return browser.run(`
    const viewer = Octacut.viewer;
    viewer.draw();
    const copy = document.createElement('canvas');
    copy.width = copy.height = 16;
    const context = copy.getContext('2d');
    context.drawImage(viewer.canvas, 0, 0, 16, 16);
    return Array.from(context.getImageData(0, 0, 16, 16).data);`);
}

function difference(a, b) {
  return a.reduce((sum, v, i) => sum + Math.abs(v - b[i]), 0) / a.length;
}

function cell(table, row, column) {
  return browser.run(`
    const row = document.querySelectorAll('#' + arguments[0] + ' tbody tr')[arguments[1]];
    return row.querySelector('[data-column="' + arguments[2] + '"]').textContent;`,
  table, row, column);
}

async function settled() {
  await browser.waitFor('the camera rests', 'return !Octacut.viewer.camera.flight');
}

async function changes(what, action) {
  const before = await picture();
  await action();
  await settled();
  const after = await picture();
  assert.ok(difference(before, after) > 0.2, `${what} changes the picture`);
}

async function checkRendering() {
  const pixels = await picture();
  const values = new Set(pixels.filter((_, i) => i % 4 !== 3));
  assert.ok(values.size > 20, `the picture shows something (${values.size} values)`);
  assert.equal(await browser.run(
    'return Octacut.viewer.renderer.getContext().getContextAttributes().antialias'), false,
  'without graphics hardware there is no antialiasing');
  await changes('dragging', () => browser.drag('#viewer', 120, 40));
  await changes('an arrow key', () => browser.press('#viewer', arrowRight + arrowRight + arrowRight));
  await changes('the wheel', () => browser.wheel('#viewer', -400));
  await changes('the wireframe', () => browser.press('#viewer', 'w'));
  await browser.press('#viewer', 'w');
  await changes('the section', () => browser.press('#viewer', 's'));
  await changes('the position of the section', () => browser.run(`
    const slider = document.getElementById('section-position');
    slider.value = 0.3;
    slider.dispatchEvent(new Event('input'));`));
  await browser.press('#viewer', 's');
  await changes('the range of the colours', () => browser.press('#viewer', '[[['));
  await browser.press('#viewer', ']]]');
  if (report.meshes.length > 1) {
    await changes('the overlay', () => browser.click('#together'));
    await browser.click('#together');
  }
  await changes('plain paint', () => browser.run(`
    const select = document.getElementById('colour');
    select.value = 'plain';
    select.dispatchEvent(new Event('change'));`));
  await browser.click('#reset');
  await settled();
}

async function checkDistances() {
  for (const [i, mesh] of report.meshes.entries()) {
    if (mesh.comparison && report.meshes.filter(m => m.comparison).length === report.meshes.length) {
      for (const side of ['to_reference', 'from_reference']) {
        assert.equal(await cell('distances', i, side + '.mean'),
          percent(mesh.comparison[side].mean_over_diagonal));
        assert.equal(await cell('distances', i, side + '.max'),
          percent(mesh.comparison[side].max_over_diagonal));
      }
    }
    assert.equal(await cell('audit', i, 'triangles'),
      String(mesh.audit.triangles).replace(/\B(?=(\d{3})+(?!\d))/g, '\u202f'));
    assert.equal(await cell('audit', i, 'genus'),
      mesh.audit.genus === null ? '–' : String(mesh.audit.genus));
  }
}

// The slider's scores at a threshold of the report are the report's.
async function checkScores() {
  const curves = report.meshes[0].comparison.curves;
  const score = report.meshes[0].comparison.scores.find(s => s.threshold === 0.001);
  const index = Math.round((Math.log10(0.001) + curves.decades) * curves.steps_per_decade);
  await browser.run(`
    const slider = document.getElementById('threshold');
    slider.min = 0;
    slider.max = 240;
    slider.value = arguments[0];
    slider.dispatchEvent(new Event('input'));`, index);
  assert.equal(await cell('score-table', 0, 'precision'), share(score.precision));
  assert.equal(await cell('score-table', 0, 'recall'), share(score.recall));
  assert.equal(await cell('score-table', 0, 'f'), share(score.f_score));
}

// A benchmark's figures are the report's, and clouds are shown as points.
async function checkBenchmark() {
  for (const [i, mesh] of report.meshes.entries()) {
    for (const [k, figure] of mesh.protocol.figures.entries()) {
      if (figure.kind === 'distance') {
        assert.equal(await cell('benchmark', i, 'figure.' + k), figure.value.toPrecision(6));
      }
    }
  }
  const clouds = await browser.run(`
    return Octacut.viewer.surfaces.filter(s => s.object.isPoints).length;`);
  assert.equal(clouds, report.meshes.filter(m => m.audit.triangles === 0).length);
  assert.ok(clouds > 0, 'there is a cloud');
  // The cloud alone.
  await browser.run(`
    for (const surface of Octacut.viewer.surfaces) {
      surface.visible = Boolean(surface.object.isPoints);
    }`);
  const pixels = await picture();
  assert.ok(new Set(pixels.filter((_, i) => i % 4 !== 3)).size > 20, 'the cloud is drawn');
}

async function checkWordsWithoutTruth() {
  const text = await browser.run('return document.body.innerText');
  assert.ok(!/\berrors?\b/i.test(text), 'no word of errors without a truth');
  assert.ok(!/F, %|F-score|precision|recall/.test(text), 'no scores without a truth');
}

async function checkPhotographs() {
  await checkWordsWithoutTruth();
  for (const [i, mesh] of report.meshes.entries()) {
    assert.equal(await cell('photographs', i, 'support'), mesh.photo_support.mean.toFixed(4));
    assert.equal(await cell('photographs', i, 'covered'), share(1 - mesh.silhouettes.missed));
  }
  await changes('a photograph', () => browser.click('#next-photograph'));
  await browser.waitFor('the photograph is shown', `
    const viewer = Octacut.viewer;
    return Boolean(viewer.camera.photograph && viewer.textures.get(viewer.camera.photograph));`);
  const blend = amount => browser.run(`
    const slider = document.getElementById('blend');
    slider.value = arguments[0];
    slider.dispatchEvent(new Event('input'));`, amount);
  await blend(0);
  const photograph = await picture();
  await blend(1);
  const mesh = await picture();
  assert.ok(difference(photograph, mesh) > 1, 'the blend slider changes the picture');
  await changes('the difference', () => browser.click('#difference'));
  await browser.press('#viewer', arrowRight);
  // The list follows with the next frame.
  await browser.waitFor('turning leaves the photograph',
    'return document.getElementById("photograph").value === "";');
  if (report.ranking) {
    const names = await browser.run(`
      return [...document.querySelectorAll('#ranking li')].map(e => e.textContent);`);
    assert.deepEqual(names, report.ranking.order);
  }
}

async function checkPlaces() {
  const count = await browser.run('return document.querySelectorAll("[data-place]").length');
  assert.ok(count >= 1, 'there are places');
  await changes('a place', () => browser.click('[data-place="0"]'));
}

async function checkReport() {
  const embedded = await browser.run('return document.getElementById("report").textContent');
  const same = JSON.parse(embedded);
  assert.deepEqual(same.meshes, report.meshes, 'the embedded report is the JSON file');
  await browser.run(`
    window.saved = null;
    URL.createObjectURL = blob => { window.saved = blob; return '#'; };
    document.getElementById('download').click();`);
  await browser.waitFor('a download', 'return window.saved !== null');
}

async function checkPhone() {
  await open(390, 844);
  const [wide, page] = await browser.run(
    'return [document.documentElement.scrollWidth, window.innerWidth]');
  assert.ok(wide <= page, `no part is wider than a phone (${wide} of ${page} pixels)`);
  const canvas = await browser.run(
    'const box = document.getElementById("viewer").getBoundingClientRect();'
    + 'return [box.width, box.height]');
  assert.ok(canvas[0] > 300 && canvas[1] > 250, 'the picture is large enough on a phone');
  await changes('dragging on a phone', () => browser.drag('#viewer', 80, 20));
}

browser = await Browser.start(1440, 900);
let failed = false;
try {
  await open(1440, 900);
  if (kind === 'truth') {
    await checkRendering();  // the same on every page
  }
  await checkDistances();
  await checkPlaces();
  await {
    truth: checkScores,
    distances: checkWordsWithoutTruth,
    photographs: checkPhotographs,
    benchmark: checkBenchmark,
  }[kind]();
  await checkReport();
  if (kind === 'truth') {
    await checkPhone();
  }
  const errors = await browser.consoleErrors();
  assert.deepEqual(errors, [], 'no errors in the console');
  console.log('the page works');
} catch (error) {
  failed = true;
  console.error(error.message);
} finally {
  await browser.stop();
}
process.exit(failed ? 1 : 0);
