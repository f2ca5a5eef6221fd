// Prints name, number or `raster`, and all levels of every scene of the gallery, as the page shows it in 48 x 36 pixels.
// What the page refuses is a word.

import { levels, rest, sit } from './sitting.mjs';

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
      for (const number of ['oracle', 'exact', 'fixed', 'f32']) {
        await form.locator(`[name=number][value=${number}]`).check();
        await rest(page, { scene, number, ...SIZE });
        console.log(scene, number, await levels(page));
      }
      await form.locator('[name=approach]').selectOption('raster');
      await rest(page, { scene, approach: 'raster', ...SIZE });
      console.log(scene, 'raster', (await page.locator('#fault').isHidden()) ? await levels(page) : 'refused');
      await form.locator('[name=approach]').selectOption('trace');
    }
  },
  { hash: '#scene=simple&columns=48&rows=36' },
);
