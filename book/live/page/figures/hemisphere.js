// Directions of a hemisphere, even and by the cosine, and the noise of each.
{
    const counts = [1, 4, 16, 64, 256];
    const curves = {};

    live.figure('hemisphere', {
        below: 'hemisphere.svg',
        title: 'Which directions are worth a ray?',
        hint: 'Left: the hemisphere over a white floor, seen from straight above, with as many random directions twice; full dots bring light. Right: the noise, the root mean square error of 1,000 pixels (± 4.5 %), for 1 to 256 directions, on logarithmic axes, with 0 at the lower edge. Dots are measured, lines are the closed form.',
        question: {
            text: 'Under a sky that is 1 everywhere, how large is the noise of directions by the cosine, compared with that of even ones?',
            choices: ['the same', 'half', 'none'],
            right: 2,
            because: 'each direction brings exactly 1, its weight cos θ/π over its density cos θ/π. Even directions bring 2 cos θ, from 0 to 2.',
        },
        area: { x: [0, 7], y: [-0.5, 2.45] },
        state: { samples: 64, sky: 0, seed: 0 },
        sliders: {
            samples: { label: 'directions', min: 1, max: 256, step: 1 },
            sky: { label: 'the sky is 1', choices: ['everywhere', 'on the right half'] },
            seed: { label: 'seed', min: 0, max: 20, step: 1 },
        },
        values: {
            even_noise: 'noise of even directions: measured',
            even_exact: 'closed form',
            cosine_noise: 'by the cosine: measured',
            cosine_exact: 'closed form',
        },
        more: async ({ sky, seed }) => {
            curves[[sky, seed]] ??= Promise.all(counts.map((count) => live.ask('hemisphere', [count, sky, seed])));
            return { curve: await curves[[sky, seed]] };
        },
        draw(pen, { samples, sky }, answer) {
            // The least noise of the plot, which stands for all that is below it.
            const least = 0.01;
            const log = (count, noise) => [5.1 + 0.42 * (Math.log(count) / Math.log(4)), 2 + Math.log10(Math.max(noise, least))];
            pen.line(log(1, least), log(256, least), 'ink');
            pen.line(log(1, least), log(1, 1), 'ink');
            pen.text([4.95, -0.45], '1');
            pen.text([6.95, -0.45], '256', '', 'end');
            pen.text([5.02, -0.25], '0.01', '', 'end');
            pen.text([5.02, 1.75], '1', '', 'end');
            pen.text([5.1, 1.9], 'noise');
            for (const [name, title, kind, x] of [['even', 'even', 'b', 1.05], ['cosine', 'by the cosine', 'c', 3.15]]) {
                pen.circle([x, 1], 1, 'ink');
                pen.text([x, 1.95], title, kind, 'middle');
                const places = answer[name];
                for (let index = 0; index < places.length; index += 2) {
                    const [right, up] = [places[index], places[index + 1]];
                    pen.dot([x + right, 1 + up], sky === 0 || right > 0 ? kind : 'none', samples > 64 ? 1.5 : 2.5);
                }
                const [exact] = answer[`${name}_exact`];
                const ends = [1, 256].map((count) => log(count, exact * Math.sqrt(samples / count)));
                pen.path(ends, `${kind} live-known`);
                answer.curve.forEach((measured, index) => pen.dot(log(counts[index], measured[`${name}_noise`][0]), `${kind} live-known`, 3));
                pen.dot(log(samples, answer[`${name}_noise`][0]), `${kind} live-known`, 5);
            }
        },
    });
}
