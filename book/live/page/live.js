// Shared by live pictures and figures: the module, loaded at the first request, and
// requests that do not fall behind the reader.
const live = {
    // The module lies beside this script.
    folder: new URL('.', document.currentScript.src),

    // Whether this browser can run the module; if not, each picture stands as it is. The smallest
    // module that uses 128-bit lanes: a function that returns i8x16.popcnt(i8x16.splat(0)).
    works: typeof WebAssembly === 'object' && typeof DecompressionStream === 'function'
        && WebAssembly.validate(new Uint8Array([0, 97, 115, 109, 1, 0, 0, 0, 1, 5, 1, 96, 0, 1, 123, 3, 2, 1, 0, 10, 10, 1, 8, 0, 65, 0, 253, 15, 253, 98, 11])),

    // The modules that are compiled, or will be, by their files.
    compiled: {},
};

// The file of a module calls this with the module, compressed, as base64.
live.receive = (base64) => {
    live.compressed = Uint8Array.from(atob(base64), (character) => character.charCodeAt(0));
};

live.load = (file) =>
    new Promise((resolve, reject) => {
        const script = document.createElement('script');
        script.src = new URL(file, live.folder);
        script.onload = resolve;
        script.onerror = () => reject(new Error('the module of the live pictures is missing'));
        document.head.append(script);
    });

// Compiles the module of a file, once for all workers.
live.compile = async (file) => {
    await live.load(file);
    const stream = new Blob([live.compressed]).stream().pipeThrough(new DecompressionStream('gzip'));
    delete live.compressed;
    return WebAssembly.compile(await new Response(stream).arrayBuffer());
};

// Starts a module in a worker: a function that posts messages to it, and one that stops it.
live.start = async (file = 'live-module.js') => {
    const module = await (live.compiled[file] ??= live.compile(file));
    const source = `${bindModule}\n(${liveWorker})()`;
    const worker = new Worker(URL.createObjectURL(new Blob([source])));
    const open = new Map();
    let last = 0;
    const refuse = (reason) => open.forEach(({ reject }) => reject(new Error(reason)));
    worker.onerror = () => refuse('the browser starts no worker here; the server of this page may forbid it');
    worker.onmessage = ({ data: { id, answer, error } }) => {
        const { resolve, reject } = open.get(id);
        open.delete(id);
        error === undefined ? resolve(answer) : reject(new Error(error));
    };
    const post = (message) =>
        new Promise((resolve, reject) => {
            open.set(++last, { resolve, reject });
            worker.postMessage({ id: last, ...message });
        });
    await post({ module });
    post.isBusy = () => open.size > 0;
    post.stop = (reason) => {
        worker.terminate();
        refuse(reason);
    };
    return post;
};

// The module in a worker of its own.
live.Module = class {
    // The answer to a message.
    async post(message) {
        this.started ??= live.start();
        const post = await this.started;
        return post(message);
    }

    // The answer to a request with numbers.
    ask(request, numbers = []) {
        return this.post({ request, numbers });
    }

    // Stops the module if it computes; the next request starts it anew.
    async stop(reason) {
        const post = await this.started;
        if (post?.isBusy()) {
            this.started = undefined;
            post.stop(reason);
        }
    }
};

// The one of all pictures and figures.
live.module = new live.Module();
live.ask = (...request) => live.module.ask(...request);
live.stop = (reason) => live.module.stop(reason);

// `work`, called with the newest arguments only while an earlier call still runs: a
// drag sends requests faster than answers come. `complain` gets the error of a call.
// Resolves when nothing is left to do; `forget` leaves out the call that waits.
live.newest = (work, complain) => {
    let waiting;
    let running;
    const run = async () => {
        while (waiting) {
            const now = waiting;
            waiting = undefined;
            await work(...now).catch(complain);
        }
    };
    const start = (...now) => {
        waiting = now;
        running ??= run().finally(() => (running = undefined));
        return running;
    };
    start.forget = () => (waiting = undefined);
    return start;
};

// Shows errors at the end of a figure.
live.failure = (figure) => ({ message }) => (figure.root.dataset.error = message);

// Shows errors in an element.
live.complain = (element) => ({ message }) => (element.textContent = message);

// The rows of a text: lines of cells, below a line of their names.
live.lines = (text) => {
    const [names, ...rows] = text.split('\n').map((line) => line.split('\t'));
    return rows.map((row) => Object.fromEntries(names.map((name, at) => [name, row[at]])));
};

// The rows of a table of an answer, whose columns are the lists `TABLE.NAME`.
live.rows = (answer, table) => {
    const columns = Object.keys(answer).filter((list) => list.startsWith(`${table}.`));
    const row = (at) => Object.fromEntries(columns.map((list) => [list.slice(table.length + 1), answer[list][at]]));
    return (answer[columns[0]] ?? []).map((_, at) => row(at));
};

// Says when an element is about to be seen, and when it no longer is. The module is loaded for one that is.
live.seen = (element, say) =>
    new IntersectionObserver(([{ isIntersecting }]) => say(isIntersecting), { rootMargin: '100%' }).observe(element);

// An HTML element with attributes and children.
live.element = (name, attributes = {}, ...children) => {
    const element = document.createElement(name);
    for (const [key, value] of Object.entries(attributes)) {
        key in element ? (element[key] = value) : element.setAttribute(key, value);
    }
    element.append(...children);
    return element;
};

live.div = (className, ...children) => live.element('div', { className }, ...children);

// A shape of a drawing, with attributes and children.
live.svg = (name, attributes, ...children) => {
    const element = document.createElementNS('http://www.w3.org/2000/svg', name);
    Object.entries(attributes).forEach(([key, value]) => element.setAttribute(key, value));
    element.append(...children);
    return element;
};

// A panel with a title and an explanation.
live.panel = (title, hint, ...children) =>
    live.element('figure', { className: 'live-figure' }, live.element('strong', {}, title), ...children, live.element('figcaption', {}, hint));

// A button that acts on a click.
live.button = (words, onclick) => live.element('button', { type: 'button', onclick }, words);

// A list to choose from, each choice with its value and its words.
live.select = (label, choices, onchange) =>
    live.element('select', { 'aria-label': label, onchange }, ...choices.map(([value, words]) => live.element('option', { value }, words)));

// Words that a reader unfolds.
live.fold = (summary, ...content) => live.element('details', {}, live.element('summary', {}, summary), ...content);

// A question with a button for each choice. `answer` gets the number of the choice; what it says ends the question,
// and the choice alone remains. It keeps the focus.
live.question = (text, choices, answer) => {
    const verdict = live.element('output');
    const buttons = choices.map((choice, chosen) => live.button(choice, () => {
        if (verdict.value) {
            return;
        }
        verdict.value = answer(chosen) ?? '';
        buttons.forEach((button, index) => {
            button.hidden = verdict.value !== '' && index !== chosen;
            button.classList.toggle('live-chosen', index === chosen);
        });
    }));
    return live.div('live-question', text, ' ', ...buttons, verdict);
};

// A recorded picture, which stands over a drawing until the module has come.
live.poster = (src) =>
    live.element('span', { className: 'live-poster' }, live.element('img', { src, alt: '' }), live.element('em', {}, 'loading …'));

// A slider, or a list of choices, with its label. `show` gives it a value, and another text.
live.control = (label, { choices, ...range }, change) => {
    const input = choices
        ? live.element('select', {}, ...choices.map((choice, value) => live.element('option', { value }, choice)))
        : live.element('input', { type: 'range', step: 1, ...range });
    const output = live.element('output');
    input.oninput = () => change(Number(input.value));
    const show = (value, text = value) => {
        input.value = value;
        output.value = choices ? '' : text;
    };
    return { show, element: live.element('label', {}, `${label} `, input, ' ', output) };
};

// The scene of the editor, as a picture's name, in a link that leads to a tool; none in one that is damaged.
live.linkedScene = () => {
    const [, scene] = location.hash.split('#scene=');
    try {
        return scene && `file\n${decodeURIComponent(scene)}`;
    } catch {
        return undefined;
    }
};

// Makes a tool before a heading, on the page that has it.
live.tool = (heading, make) => {
    const place = live.works && document.querySelector(`main #${heading}`);
    return place && make(place);
};

// The pictures of the page that a selector finds, without the copies that mdBook enlarges.
live.images = (selector) =>
    live.works ? [...document.querySelectorAll(`main ${selector}:not(.img-wrapper > img)`)] : [];

// The caption of a picture, or else its paragraph.
live.caption = (image) => {
    const paragraph = image.closest('p');
    const caption = paragraph.nextElementSibling;
    return caption?.matches('p') ? caption : paragraph;
};

// A figure takes the place of a still picture, which paper keeps.
live.stillOf = (image) => image.closest('p').classList.add('live-still');

// The book turns pages with the arrow keys; in a slider, a list or a text they belong to it. Escape
// closes what it is in.
addEventListener(
    'keydown',
    (event) => {
        if (event.key !== 'Escape' && event.target.closest?.('.live-controls, .live-question, .live-pair, .live-editor textarea')) {
            event.stopPropagation();
        }
    },
    true,
);

// Calls `move` with the event, and how far to the right and down, while an element is dragged;
// and `tap` if it is only touched.
live.drag = (element, move, tap = () => {}) => {
    let last;
    let moved;
    element.addEventListener('pointerdown', (event) => {
        if (event.target === element) {
            last = event;
            moved = false;
            element.setPointerCapture(event.pointerId);
        }
    });
    // The browser releases the pointer after `pointerup`, and at a gesture of its own.
    element.addEventListener('pointermove', (event) => {
        if (element.hasPointerCapture(event.pointerId)) {
            const by = [event.clientX - last.clientX, event.clientY - last.clientY];
            // A finger that touches moves a little.
            moved ||= Math.hypot(...by) > 3;
            if (moved) {
                move(event, ...by);
                last = event;
            }
        }
    });
    element.addEventListener('pointerup', (event) => {
        if (element.hasPointerCapture(event.pointerId) && !moved) {
            tap(event);
        }
    });
};

// Acts on keys. The book turns pages with arrows, and handles lie in figures that turn.
live.keys = (element, actions) => {
    element.addEventListener('keydown', (event) => {
        if (actions[event.key]) {
            event.preventDefault();
            event.stopPropagation();
            actions[event.key](event);
        }
    });
};

// Arrow keys that move by 1 to the right and upwards, with Shift by 5.
live.arrows = (move) => {
    const by = ({ shiftKey }, right, up) => {
        const steps = shiftKey ? 5 : 1;
        move(steps * right, steps * up);
    };
    return {
        ArrowLeft: (event) => by(event, -1, 0),
        ArrowRight: (event) => by(event, 1, 0),
        ArrowUp: (event) => by(event, 0, 1),
        ArrowDown: (event) => by(event, 0, -1),
    };
};

// Puts the pixels of an answer on a canvas.
live.paint = (canvas, { size: [width, height], pixels }) => {
    Object.assign(canvas, { width, height });
    const image = new ImageData(new Uint8ClampedArray(pixels), width, height);
    canvas.getContext('2d').putImageData(image, 0, 0);
};

// A number as the reader sees it: six digits at most.
live.show = (number) => {
    if (number === undefined || Number.isNaN(number)) {
        return 'none';
    }
    if (!Number.isFinite(number)) {
        return number < 0 ? '-∞' : '∞';
    }
    const short = Number(number.toPrecision(6));
    const exponent = Math.abs(short);
    const small = short !== 0 && (exponent < 1e-4 || exponent >= 1e7);
    return small ? short.toExponential().replace('e+', 'e') : String(short);
};
