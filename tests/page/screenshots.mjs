// Takes pictures of a page of mesh_comparer or mesh_evaluator:
//   node tests/page/screenshots.mjs PAGE.html FOLDER [script of the page]
// writes FOLDER/desktop.png and FOLDER/phone.png, after the script has run.
import {mkdirSync} from 'node:fs';
import {resolve} from 'node:path';
import {pathToFileURL} from 'node:url';

import {Browser} from './webdriver.mjs';

const [page, folder, script] = process.argv.slice(2);
if (!folder) {
  console.error('usage: node screenshots.mjs PAGE.html FOLDER [script]');
  process.exit(1);
}
mkdirSync(folder, {recursive: true});
const browser = await Browser.start(1440, 900);
try {
  for (const [name, width, height] of [['desktop', 1440, 1000], ['phone', 390, 844]]) {
    await browser.emulate(width, height);
    await browser.open(pathToFileURL(resolve(page)).href);
    await browser.waitFor('ready', 'return document.documentElement.dataset.ready !== undefined');
    console.log(name, 'ready after ms', await browser.run('return document.documentElement.dataset.ready'));
    if (script) {
      await browser.run(script);
      await new Promise(done => setTimeout(done, 1500));
    }
    await browser.screenshot(`${folder}/${name}.png`);
  }
  console.log((await browser.consoleErrors()).join('\n'));
} finally {
  await browser.stop();
}
