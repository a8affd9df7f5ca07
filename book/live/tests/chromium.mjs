// Drives a headless Chromium over its DevTools pipe, without any package.
import { spawn } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

const flags = [
    '--headless', '--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run',
    '--disable-background-networking', '--disable-component-update', '--disable-sync',
    '--remote-debugging-pipe',
];

export class Chromium {
    constructor(program) {
        this.profile = mkdtempSync(join(tmpdir(), 'chromium-'));
        this.process = spawn(program, [...flags, `--user-data-dir=${this.profile}`], {
            stdio: ['ignore', 'ignore', 'ignore', 'pipe', 'pipe'],
        });
        this.ended = new Promise((resolve) => this.process.on('exit', resolve));
        this.waiting = new Map();
        this.last = 0;
        // Errors of the page: exceptions, and messages of the kind error.
        this.errors = [];
        let rest = '';
        this.process.stdio[4].on('data', (data) => {
            const messages = (rest + data).split('\0');
            rest = messages.pop();
            messages.forEach((message) => this.receive(JSON.parse(message)));
        });
    }

    receive({ id, result, error, method, params }) {
        if (id) {
            const { resolve, reject, sent } = this.waiting.get(id);
            this.waiting.delete(id);
            error ? reject(new Error(`${sent}: ${error.message}`)) : resolve(result);
        } else if (method === 'Runtime.exceptionThrown') {
            const { text, exception } = params.exceptionDetails;
            this.errors.push(exception?.description ?? text);
        } else if (method === 'Runtime.consoleAPICalled' && params.type === 'error') {
            this.errors.push(params.args.map((arg) => arg.value ?? arg.description).join(' '));
        } else if (method === 'Log.entryAdded' && params.entry.level === 'error') {
            this.errors.push(`${params.entry.text} ${params.entry.url ?? ''}`);
        } else if (method === 'Page.loadEventFired') {
            this.loaded?.();
        }
    }

    send(method, params = {}) {
        const id = (this.last += 1);
        this.process.stdio[3].write(`${JSON.stringify({ id, method, params, sessionId: this.session })}\0`);
        return new Promise((resolve, reject) => this.waiting.set(id, { resolve, reject, sent: method }));
    }

    // Opens a page with nothing in it, of the size of a window or a phone.
    async open(width, height) {
        const { targetId } = await this.send('Target.createTarget', { url: 'about:blank' });
        const { sessionId } = await this.send('Target.attachToTarget', { targetId, flatten: true });
        this.session = sessionId;
        await Promise.all(['Page', 'Runtime', 'Log'].map((domain) => this.send(`${domain}.enable`)));
        await this.resize(width, height);
    }

    resize(width, height) {
        return this.send('Emulation.setDeviceMetricsOverride', { width, height, deviceScaleFactor: 1, mobile: width < 600 });
    }

    async go(url) {
        const loaded = new Promise((resolve) => (this.loaded = resolve));
        await this.send('Page.navigate', { url });
        await loaded;
    }

    // The value of an expression in the page, awaited.
    async value(expression) {
        const { result, exceptionDetails } = await this.send('Runtime.evaluate', { expression, awaitPromise: true, returnByValue: true });
        if (exceptionDetails) {
            throw new Error(exceptionDetails.exception?.description ?? exceptionDetails.text);
        }
        return result.value;
    }

    // Waits until an expression is true.
    async until(expression, seconds = 60) {
        const end = Date.now() + 1000 * seconds;
        while (!(await this.value(expression))) {
            if (Date.now() > end) {
                throw new Error(`not within ${seconds} s: ${expression}`);
            }
            await new Promise((resolve) => setTimeout(resolve, 10));
        }
    }

    // The middle of an element, scrolled into view.
    middle(element) {
        return this.value(`(() => {
            const element = ${element};
            element.scrollIntoView({ block: 'center', behavior: 'instant' });
            const { x, y, width, height } = element.getBoundingClientRect();
            return [x + width / 2, y + height / 2];
        })()`);
    }

    mouse(type, x, y, pressed = {}) {
        const button = type === 'mouseMoved' ? pressed : { button: 'left', clickCount: 1 };
        return this.send('Input.dispatchMouseEvent', { type, x, y, ...button });
    }

    async click(element) {
        const [x, y] = await this.middle(element);
        await this.mouse('mousePressed', x, y);
        await this.mouse('mouseReleased', x, y);
    }

    async drag(element, right, down) {
        await this.swipe(...(await this.middle(element)), right, down);
    }

    async swipe(x, y, right, down) {
        await this.mouse('mouseMoved', x, y);
        await this.mouse('mousePressed', x, y);
        const pressed = { button: 'left', buttons: 1 };
        await this.mouse('mouseMoved', x + right / 2, y + down / 2, pressed);
        await this.mouse('mouseMoved', x + right, y + down, pressed);
        await this.mouse('mouseReleased', x + right, y + down);
    }

    // An arrow key with its code, which moves a slider.
    async arrow(key, windowsVirtualKeyCode) {
        await this.send('Input.dispatchKeyEvent', { type: 'keyDown', key, windowsVirtualKeyCode });
        await this.send('Input.dispatchKeyEvent', { type: 'keyUp', key, windowsVirtualKeyCode });
    }

    async key(key) {
        await this.send('Input.dispatchKeyEvent', { type: 'keyDown', key });
        await this.send('Input.dispatchKeyEvent', { type: 'keyUp', key });
    }

    // Return on an element that has the focus.
    async enter(element) {
        await this.value(`${element}.focus()`);
        await this.send('Input.dispatchKeyEvent', { type: 'keyDown', key: 'Enter', text: '\r', windowsVirtualKeyCode: 13 });
        await this.send('Input.dispatchKeyEvent', { type: 'keyUp', key: 'Enter', windowsVirtualKeyCode: 13 });
    }

    // An element as PNG, in base64. Only for one that is higher than the window the whole page is painted.
    async picture(element) {
        await this.middle(element);
        const [captureBeyondViewport, clip] = await this.value(`(() => {
            const { x, y, width, height } = (${element}).getBoundingClientRect();
            return [height > innerHeight, { x: x + scrollX, y: y + scrollY, width, height, scale: 1 }];
        })()`);
        const { data } = await this.send('Page.captureScreenshot', { captureBeyondViewport, clip });
        return data;
    }

    async close() {
        this.session = undefined;
        await this.send('Browser.close').catch(() => {});
        await this.ended;
        rmSync(this.profile, { recursive: true, force: true, maxRetries: 5 });
    }
}
