// Clicks pixels and reads how they come by their light, while pictures are drawn too.

import { demand, rest, sit } from './sitting.mjs';

await sit(
  async (page) => {
    await rest(page, { scene: 'glass' });
    const [figures, tree] = ['#figures', '#tree'].map((place) => page.locator(place));
    demand(await figures.isHidden(), 'rays are told of no pixel');
    const click = async (x, y) => {
      const box = await page.locator('#panel').boundingBox();
      const { columns, rows } = await page.evaluate(() => {
        const { width, height } = document.querySelector('#panel');
        return { columns: width, rows: height };
      });
      const [left, top] = [((x + 0.5) * box.width) / columns, ((y + 0.5) * box.height) / rows];
      await page.mouse.click(box.x + left, box.y + top);
    };
    await click(140, 140);
    await tree.locator('svg').waitFor();
    console.log(await figures.textContent());
    demand((await tree.textContent()).includes('T1'), 'the tree has no ray through glass');

    await page.locator('[name=number][value=fixed]').check();
    await rest(page, { scene: 'glass', number: 'fixed' });
    demand((await tree.textContent()).includes('glass 140,140 in fixed'), 'the tree is of another number');

    // A click on a picture that is still coarse, in the reference's patience.
    await page.locator('[name=number][value=oracle]').check();
    await page.locator('#spin').click();
    await page.waitForFunction(() => document.querySelector('#panel').width < 240);
    await click(10, 10);
    await page.locator('#spin').click();
    await rest(page, { scene: 'glass', number: 'oracle' });
    await figures.getByText(/pixel \d+,\d+ of/).waitFor();
    const told = await page.locator('#account dd').first().textContent();
    demand(told !== '140, 140', 'a click on a coarse picture is dropped');

    await page.locator('[name=number][value=f32]').check();
    await page.locator('[name=approach]').selectOption('raster');
    await rest(page, { scene: 'glass', approach: 'raster' });
    demand((await figures.isHidden()) && (await tree.isHidden()), 'the z-buffer sends rays');
    demand(await page.locator('#heat').isDisabled(), 'a heat map of no rays is offered');
  },
  { hash: '#scene=glass&columns=240&rows=240' },
);
