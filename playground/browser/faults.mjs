// Writes scenes that are wrong, and one that is right.

import { checksum, demand, rest, sit } from './sitting.mjs';

/** Is the word at which the core of this sitting stops. */
const TRAP = 'here be dragons';

/** Gives the page a core that stops at a word. */
async function setTrap(page) {
  await page.route('**/core.js', async (route) => {
    const response = await route.fetch();
    const stop = `if (request.text?.includes('${TRAP}')) throw new WebAssembly.RuntimeError('unreachable');`;
    const body = (await response.text()).replace('ask(request) {', (begin) => begin + stop);
    await route.fulfill({ response, body });
  });
}

await sit(
  async (page) => {
    await rest(page, { scene: 'simple' });
    const before = await checksum(page);
    const text = page.locator('#text');
    const wrong = page.locator('#wrong');
    const good = await text.inputValue();
    demand(good.includes('Sphere('), 'the text of the scene is not there');

    await text.fill(good.replace('radius:', 'radios:'));
    await wrong.getByText('unknown field `radios`, did you mean `radius`?').waitFor();
    demand((await wrong.textContent()).includes('simple.ron:'), 'the line is not told');
    await text.fill(good.replace(/radius: [0-9.]+/, 'radius: -1.0'));
    await wrong.getByText(/its radius is not above zero/).waitFor();
    demand((await checksum(page)) === before, 'a wrong scene takes the picture away');

    await text.fill(good.replace(/size: .*/, 'size: (60, 45),'));
    await rest(page, { scene: 'simple', columns: 60, rows: 45 });
    await text.fill(good.replace(/size: .*/, 'size: (120, 90),'));
    await rest(page, { scene: 'simple', columns: 120, rows: 90 });
    demand((await checksum(page)) === before, 'the size as it was shows another picture');

    await text.fill(good.replace(/size: .*/, 'size: (120, 90),').replace(/radius: [0-9.]+/, 'radius: 0.25'));
    for (let tries = 0; (await checksum(page)) === before; tries++) {
      demand(tries < 100, 'a smaller ball shows the same picture');
      await page.waitForTimeout(50);
    }
    demand(await wrong.isHidden(), 'a right scene is still complained of');

    // A text at which the core stops costs the core that took it, not the one with the scene.
    const last = await checksum(page);
    await text.fill(`${good}// ${TRAP}`);
    await wrong.getByText('The core has stopped at this scene').waitFor();
    await page.locator('#panel').press('ArrowRight');
    await rest(page, { walk: '1024 0 0' });
    demand((await checksum(page)) !== last, 'nobody draws after the core has stopped');
    demand(await page.locator('#fault').isHidden(), 'the scene before is lost');
  },
  { hash: '#scene=simple&columns=120&rows=90', prepare: setTrap },
);
