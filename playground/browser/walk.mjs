// Walks by keys and by mouse, and back to the same bits.

import { checksum, demand, rest, sit } from './sitting.mjs';

await sit(
  async (page) => {
    const panel = page.locator('#panel');
    await rest(page, { scene: 'three-spheres', number: 'fixed' });
    const home = await checksum(page);

    const press = async (keys, walk) => {
      await panel.focus();
      for (const key of keys) await page.keyboard.press(key);
      await rest(page, { walk });
      return checksum(page);
    };
    const right = await press(['ArrowRight', 'ArrowRight'], '2048 0 0');
    demand(right !== home, 'two steps to the right show the same picture');
    const up = await press(['ArrowUp', '+'], '2048 1024 1');
    demand(up !== right, 'a step up and closer shows the same picture');
    const back = await press(['-', 'ArrowDown', 'ArrowLeft', 'ArrowLeft'], '');
    demand(back === home, 'the way back ends on other bits');
    demand((await press(Array(48).fill('ArrowLeft'), '')) === home, 'a walk around ends on other bits');

    const box = await panel.boundingBox();
    await page.mouse.move(box.x + 100, box.y + 100);
    await page.mouse.down();
    await page.mouse.move(box.x + 160, box.y + 120, { steps: 5 });
    await page.mouse.up();
    await page.waitForFunction(() => location.hash.includes('walk='));
    demand((await checksum(page)) !== home, 'a drag shows the same picture');
    demand((await press(['Home'], '')) === home, 'Home leads elsewhere');

    await page.mouse.click(box.x + box.width / 2, box.y + box.height / 2);
    const told = page.locator('#account');
    await told.getByText('object').first().waitFor();
    await panel.focus();
    await page.keyboard.press('Shift+ArrowRight');
    await told.getByText(/^121, 120$/).waitFor();
  },
  { hash: '#scene=three-spheres&number=fixed&columns=240&rows=240' },
);
