// Prints number, pictures in a second of a turning camera, and milliseconds of the fastest of them.

import { rest, sit } from './sitting.mjs';

for (const number of ['f32', 'fixed']) {
  await sit(
    async (page) => {
      await rest(page, { scene: 'three-spheres', number });
      const counted = page.evaluate(async () => {
        const said = document.querySelector('#said');
        const times = [];
        new MutationObserver(() => {
          const [, size, time] = said.textContent.match(/^(\d+) ×.*: ([\d.]+) ms/);
          if (size === '240') times.push(Number(time));
        }).observe(said, { childList: true });
        await new Promise((resolve) => setTimeout(resolve, 4000));
        return times;
      });
      await page.locator('#spin').click();
      const times = await counted;
      console.log(number, (times.length / 4).toFixed(1), Math.min(...times).toFixed(1));
    },
    { hash: `#scene=three-spheres&number=${number}&columns=240&rows=240` },
  );
}
