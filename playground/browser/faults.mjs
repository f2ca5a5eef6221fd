// Writes scenes that are wrong, and one that is right.

import { checksum, demand, rest, sit } from './sitting.mjs';

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

    await text.fill(good.replace(/radius: [0-9.]+/, 'radius: 0.25'));
    await wrong.waitFor({ state: 'hidden' });
    await page.waitForFunction((before) => before !== document.querySelector('#said').textContent, '');
    await rest(page, { scene: 'simple' });
    const changed = page.locator('#fault');
    await changed.waitFor({ state: 'hidden' });
    for (let tries = 0; (await checksum(page)) === before; tries++) {
      demand(tries < 100, 'a smaller ball shows the same picture');
      await page.waitForTimeout(50);
    }
    await text.fill(good);
    for (let tries = 0; (await checksum(page)) !== before; tries++) {
      demand(tries < 100, 'the scene as it was shows another picture');
      await page.waitForTimeout(50);
    }
  },
  { hash: '#scene=simple&columns=120&rows=90' },
);
