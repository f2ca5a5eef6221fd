// Opens files of one's own: picked, dropped, with one missing that comes later. The folder is that of the project's scenes.

import { readFile } from 'node:fs/promises';
import { checksum, demand, rest, sit } from './sitting.mjs';

const [, , , folder] = process.argv;
const SKY = ['x', 'y', 'z'].flatMap((axis) => ['low', 'high'].map((side) => `environment-${side}-${axis}.png`));
const at = (name) => `${folder}/${name}`;

/** Drops files on the page as a hand does: over it, then down. */
async function drop(page, names) {
  const files = await Promise.all(
    names.map(async (name) => ({ name, content: [...(await readFile(at(name)))] })),
  );
  const transfer = await page.evaluateHandle((files) => {
    const transfer = new DataTransfer();
    for (const { name, content } of files) transfer.items.add(new File([new Uint8Array(content)], name.split('/').pop()));
    return transfer;
  }, files);
  for (const type of ['dragover', 'drop']) await page.dispatchEvent('#controls', type, { dataTransfer: transfer });
}

await sit(
  async (page) => {
    const [form, text, fault] = ['#controls', '#text', '#fault'].map((place) => page.locator(place));
    const opened = (name) =>
      page.waitForFunction((name) => document.querySelector('[name=scene]').selectedOptions[0].text === name, name);
    // The browser hands over no chooser that it is asked for too late.
    const chooser = page.waitForEvent('filechooser');
    await rest(page, { scene: 'simple' });
    const before = await checksum(page);

    // By keys alone: the button asks for files.
    await page.locator('#pick').focus();
    await page.keyboard.press('Enter');
    await (await chooser).setFiles(['planets.ron', 'craters.png', ...SKY].map(at));
    await fault.getByText('cannot read the image').waitFor();
    const said = await fault.textContent();
    demand(/(world|peel|dimples)\.png: there is no such file/.test(said), `which is missing is not told: ${said}`);
    demand((await checksum(page)) === before, 'a scene that lacks a file takes the picture away');

    await drop(page, ['world.png', 'peel.png', 'dimples.png']);
    await opened('planets.ron (yours)');
    await rest(page, { scene: '' });
    demand((await text.inputValue()) === (await readFile(at('planets.ron'), 'utf8')), 'the text is another');
    console.log('planets', await checksum(page));
    demand(await fault.isHidden(), 'a scene that has all its files is still complained of');

    // A text that is changed still has its files.
    const planets = await checksum(page);
    await text.fill((await text.inputValue()).replace('eye: (1.6,', 'eye: (1.7,'));
    for (let tries = 0; (await checksum(page)) === planets; tries++) {
      demand(tries < 400, 'another place shows the same picture');
      await page.waitForTimeout(50);
    }

    await drop(page, ['nff/balls1.nff']);
    await opened('balls1.nff (yours)');
    await rest(page, { scene: '' });
    console.log('balls1', await checksum(page));
    // Corners on a line are no triangle.
    await text.fill(`${await text.inputValue()}\np 3\n0 0 0\n1 0 0\n2 0 0\n`);
    await page.locator('#notes li').getByText('its corners lie on a line: left out').waitFor();

    // A scene that lacks something does not stand in the way of a model.
    await drop(page, ['planets.ron']);
    await fault.getByText('cannot read the image').waitFor();
    await drop(page, ['teapot.obj']);
    await opened('teapot.obj (yours)');
    await rest(page, { scene: '' });
    console.log('teapot', await checksum(page));
    demand((await text.inputValue()).includes('teapot-mesh.obj'), 'the text of the model is not there');
    await text.fill((await text.inputValue()).replace(/size: .*/, 'size: (60, 45),'));
    await rest(page, { scene: '', columns: 60, rows: 45 });

    // What a scene names may come before it.
    await drop(page, ['world.png', 'peel.png', 'dimples.png', 'craters.png', ...SKY]);
    await fault.getByText('None of these files is a scene').waitFor();
    await drop(page, ['planets.ron']);
    await opened('planets.ron (yours)');

    await drop(page, ['world.png']);
    await fault.getByText('None of these files is a scene').waitFor();
    await form.locator('[name=scene]').selectOption('simple');
    await rest(page, { scene: 'simple' });
    demand((await checksum(page)) === before, 'the gallery is another after files of one’s own');
    demand((await form.locator('[name=scene] option[value=""]').count()) === 0, 'a closed file is still listed');
  },
  { hash: '#scene=simple&number=fixed' },
);
