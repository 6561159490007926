// Drives Debian's Chromium through chromedriver (packages chromium and
// chromium-driver) by the W3C WebDriver protocol, with nothing but Node's own
// modules.
import {spawn} from 'node:child_process';
import {mkdtempSync, rmSync, writeFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';

const chromiumArguments = [
  '--headless=new', '--no-sandbox', '--disable-gpu', '--use-angle=swiftshader',
  '--enable-unsafe-swiftshader', '--in-process-gpu', '--disable-quic', '--no-first-run',
  '--disable-background-networking', '--disable-component-update', '--disable-sync',
  '--hide-scrollbars', '--force-device-scale-factor=1',
];

// Resolves with the port that the driver has chosen.
function waitForPort(driver) {
  return new Promise((resolve, reject) => {
    let text = '';
    driver.stdout.on('data', data => {
      text += data;
      const match = text.match(/successfully on port (\d+)/);
      if (match) {
        resolve(Number(match[1]));
      }
    });
    driver.on('exit', code => reject(new Error('chromedriver ended with ' + code + ': ' + text)));
  });
}

export class Browser {
  static async start(width, height) {
    const browser = new Browser();
    browser.folder = mkdtempSync(join(tmpdir(), 'octacut-chromium-'));
    browser.driver = spawn('chromedriver', ['--port=0'], {stdio: ['ignore', 'pipe', 'ignore']});
    browser.base = 'http://127.0.0.1:' + await waitForPort(browser.driver);
    const capabilities = {alwaysMatch: {
      browserName: 'chrome',
      'goog:loggingPrefs': {browser: 'ALL'},
      'goog:chromeOptions': {
        args: [...chromiumArguments, '--user-data-dir=' + browser.folder,
          `--window-size=${width},${height}`],
      },
    }};
    const session = await browser.call('POST', '/session', {capabilities});
    browser.base += '/session/' + session.sessionId;
    return browser;
  }

  async call(method, path, body) {
    const response = await fetch(this.base + path, {
      method, body: body === undefined ? undefined : JSON.stringify(body),
      headers: {'Content-Type': 'application/json'},
    });
    const {value} = await response.json();
    if (!response.ok) {
      throw new Error(`${method} ${path}: ${value.error}: ${value.message.split('\n')[0]}`);
    }
    return value;
  }

  open(url) {
    return this.call('POST', '/url', {url});
  }

  // The body of a function of the page, with `arguments`.
  run(script, ...args) {
    return this.call('POST', '/execute/sync', {script, args});
  }

  async find(selector) {
    const found = await this.call('POST', '/element', {using: 'css selector', value: selector});
    return Object.values(found)[0];
  }

  async click(selector) {
    return this.call('POST', `/element/${await this.find(selector)}/click`, {});
  }

  // WebDriver's codes of keys, or characters.
  async press(selector, keys) {
    return this.call('POST', `/element/${await this.find(selector)}/value`, {text: keys});
  }

  // With the mouse, from the middle of an element.
  async drag(selector, dx, dy) {
    const id = await this.find(selector);
    const origin = {'element-6066-11e4-a52e-4f735466cecf': id};
    const move = (x, y) => ({type: 'pointerMove', duration: 50, origin, x, y});
    return this.call('POST', '/actions', {actions: [{
      type: 'pointer', id: 'mouse', parameters: {pointerType: 'mouse'},
      actions: [move(0, 0), {type: 'pointerDown', button: 0}, move(dx / 2, dy / 2),
        move(dx, dy), {type: 'pointerUp', button: 0}],
    }]});
  }

  async wheel(selector, deltaY) {
    const origin = {'element-6066-11e4-a52e-4f735466cecf': await this.find(selector)};
    return this.call('POST', '/actions', {actions: [{
      type: 'wheel', id: 'wheel',
      actions: [{type: 'scroll', origin, x: 0, y: 0, deltaX: 0, deltaY, duration: 0}],
    }]});
  }

  // As a phone would have it, which a window cannot be narrow enough for.
  emulate(width, height) {
    return this.call('POST', '/goog/cdp/execute', {
      cmd: 'Emulation.setDeviceMetricsOverride',
      params: {width, height, deviceScaleFactor: 1, mobile: width < 600},
    });
  }

  async screenshot(path) {
    writeFileSync(path, Buffer.from(await this.call('GET', '/screenshot'), 'base64'));
  }

  // Warnings and errors that the console has got since the last call, but for what the
  // graphics driver says of its own speed.
  async consoleErrors() {
    const entries = await this.call('POST', '/se/log', {type: 'browser'});
    return entries.filter(entry => entry.level === 'SEVERE' || (entry.level === 'WARNING'
      && !entry.message.includes('GL Driver Message')))
      .map(entry => `${entry.level}: ${entry.message}`);
  }

  async waitFor(what, script, ...args) {
    const end = Date.now() + 60000;
    while (Date.now() < end) {
      if (await this.run(script, ...args)) {
        return;
      }
      await new Promise(resolve => setTimeout(resolve, 50));
    }
    throw new Error('never happened: ' + what);
  }

  async stop() {
    try {
      await this.call('DELETE', '');
    } finally {
      this.driver.removeAllListeners('exit');
      this.driver.kill();
      rmSync(this.folder, {recursive: true, force: true, maxRetries: 10, retryDelay: 100});
    }
  }
}
