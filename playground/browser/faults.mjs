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
  },
  { hash: '#scene=simple&columns=120&rows=90' },
);
