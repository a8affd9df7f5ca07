// Shared by live pictures and figures: the module, loaded at the first request, and
// requests that do not fall behind the reader.
const live = {
    // The module lies beside this script.
    folder: new URL('.', document.currentScript.src),

    // Whether this browser can run the module; if not, each picture stands as it is.
    works: typeof WebAssembly === 'object' && typeof DecompressionStream === 'function',
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

// Starts a module: a function that posts messages to it, and one that stops it.
live.start = async (file = 'live-module.js') => {
    await live.load(file);
    const source = `${bindModule}\n(${liveWorker})()`;
    const worker = new Worker(URL.createObjectURL(new Blob([source])));
    const open = new Map();
    let last = 0;
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
    const compiled = post({ compressed: live.compressed });
    delete live.compressed;
    await compiled;
    post.stop = (reason) => {
        worker.terminate();
        open.forEach(({ reject }) => reject(new Error(reason)));
    };
    return post;
};

// The module's answer to a request with numbers.
live.ask = async (request, numbers = []) => {
    live.started ??= live.start();
    const post = await live.started;
    return post({ request, numbers });
};

// `work`, called with the newest arguments only while an earlier call still runs: a
// drag sends requests faster than answers come. Resolves when nothing is left to do.
live.newest = (work) => {
    let waiting;
    let running;
    const run = async () => {
        while (waiting) {
            const now = waiting;
            waiting = undefined;
            await work(...now);
        }
    };
    return (...now) => {
        waiting = now;
        running ??= run().finally(() => {
            running = undefined;
        });
        return running;
    };
};

// An HTML element with attributes and children.
live.element = (name, attributes = {}, ...children) => {
    const element = document.createElement(name);
    for (const [key, value] of Object.entries(attributes)) {
        key in element ? (element[key] = value) : element.setAttribute(key, value);
    }
    element.append(...children);
    return element;
};

// The book turns pages with the arrow keys; in a slider or a list they belong to it.
addEventListener(
    'keydown',
    (event) => {
        if (event.target.closest?.('.live-controls, .live-pair')) {
            event.stopPropagation();
        }
    },
    true,
);

// Calls `move` with the event, and how far to the right and down, while an element is dragged.
live.drag = (element, move) => {
    let last;
    element.addEventListener('pointerdown', (event) => {
        if (event.target === element) {
            last = event;
            element.setPointerCapture(event.pointerId);
        }
    });
    element.addEventListener('pointermove', (event) => {
        if (last) {
            move(event, event.clientX - last.clientX, event.clientY - last.clientY);
            last = event;
        }
    });
    const end = () => (last = undefined);
    element.addEventListener('pointerup', end);
    element.addEventListener('pointercancel', end);
};

// Acts on keys. The book turns pages with arrows, and handles lie in figures that turn.
live.keys = (element, actions) => {
    element.addEventListener('keydown', (event) => {
        if (actions[event.key]) {
            event.preventDefault();
            event.stopPropagation();
            actions[event.key]();
        }
    });
};

// Arrow keys that move by 1 to the right and upwards.
live.arrows = (move) => ({
    ArrowLeft: () => move(-1, 0),
    ArrowRight: () => move(1, 0),
    ArrowUp: () => move(0, 1),
    ArrowDown: () => move(0, -1),
});

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
