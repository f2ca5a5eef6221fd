// Looks at the page on a narrow screen, in light and dark, and takes pictures of it if a folder is named.

import { demand, rest, sit } from './sitting.mjs';

const [, , , folder] = process.argv;
const SCREENS = [
  { name: 'phone', viewport: { width: 360, height: 740 }, colorScheme: 'light', deviceScaleFactor: 2 },
  { name: 'dark', viewport: { width: 1280, height: 900 }, colorScheme: 'dark' },
  { name: 'light', viewport: { width: 1280, height: 900 }, colorScheme: 'light' },
];

for (const { name, ...screen } of SCREENS) {
  await sit(
    async (page) => {
      await rest(page, { scene: 'glass' });
      await page.locator('#panel').click({ position: { x: 90, y: 90 } });
      await page.locator('#account dt').first().waitFor();
      const [whole, seen] = await page.evaluate(() => {
        const { scrollWidth, clientWidth } = document.documentElement;
        return [scrollWidth, clientWidth];
      });
      demand(whole <= seen, `${name}: ${whole} pixels wide on a screen of ${seen}`);
      const unnamed = await page.evaluate(() =>
        [...document.querySelectorAll('button, select, input, textarea')]
          .filter((field) => !(field.labels?.length || field.textContent.trim() || field.ariaLabel))
          .map((field) => field.outerHTML),
      );
      demand(unnamed.length === 0, `${name}: nobody can tell what these are: ${unnamed.join(' ')}`);
      if (folder) await page.screenshot({ path: `${folder}/${name}.png`, fullPage: true });
    },
    { hash: '#scene=glass', ...screen },
  );
}
