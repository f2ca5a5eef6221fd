// Prints name, number and checksum of every scene of the gallery, as the page shows it in 48 x 36 pixels.

import { checksum, rest, sit } from './sitting.mjs';

const SIZE = { columns: 48, rows: 36 };

await sit(
  async (page) => {
    const form = page.locator('#controls');
    await rest(page, { scene: 'simple', ...SIZE });
    const names = await form.locator('[name=scene] option').allTextContents();
    for (const scene of names) {
      await form.locator('[name=scene]').selectOption(scene);
      await rest(page, { scene });
      for (const [name, value] of Object.entries(SIZE)) {
        await form.locator(`[name=${name}]`).fill(String(value));
        await form.locator(`[name=${name}]`).press('Enter');
      }
      for (const number of ['fixed', 'f32']) {
        await form.locator(`[value=${number}]`).check();
        await rest(page, { scene, number, ...SIZE });
        console.log(scene, number, await checksum(page));
      }
    }
  },
  { hash: '#scene=simple&columns=48&rows=36' },
);
