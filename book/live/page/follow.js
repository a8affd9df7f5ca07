// A handle whose place follows from numbers of the state by any function: while it is
// dragged, steps of Newton's method for one number after the other move the handle to the
// pointer. `limits` has the least and the greatest value of each number.
live.follow = (label, at, limits) => ({
    label,
    at,
    move(state, ...place) {
        const found = { ...state };
        const dot = (a, b) => a[0] * b[0] + a[1] * b[1];
        for (let step = 0; step < 100; step += 1) {
            for (const [name, [low, high]] of Object.entries(limits)) {
                const here = at(found);
                const miss = here.map((x, i) => place[i] - x);
                const slope = at({ ...found, [name]: found[name] + 1e-3 }).map((x, i) => (x - here[i]) / 1e-3);
                // Damped where the drawing hardly moves, as for a gaze towards the reader.
                const change = dot(slope, miss) / (dot(slope, slope) + 1e-4);
                found[name] = Math.min(Math.max(found[name] + change, low), high);
            }
        }
        return Object.fromEntries(Object.keys(limits).map((name) => [name, found[name]]));
    },
});
