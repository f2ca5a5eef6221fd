// A sitting before the playground: a browser, the page, and all that it complains of.

import { chromium } from 'playwright-core';

const QUIET = [
  '--no-sandbox',
  '--disable-gpu',
  '--disable-quic',
  '--no-first-run',
  '--disable-background-networking',
  '--disable-component-update',
  '--disable-sync',
];

/** How long anything may take, in milliseconds. */
const PATIENCE = 180_000;

/**
 * Opens the page at the address of the command line, does something there, and demands that nothing went wrong.
 * `prepare` is called with the page before it is loaded.
 */
export async function sit(
  act,
  { hash = '', viewport = { width: 1280, height: 900 }, prepare, ...options } = {},
) {
  const [address] = process.argv.slice(2);
  const browser = await chromium.launch({
    executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
    args: QUIET,
  });
  const complaints = [];
  try {
    const page = await browser.newPage({ viewport, ...options });
    // A computer that does much else at the same time is slow, not wrong.
    page.setDefaultTimeout(PATIENCE);
    page.on('console', (message) => message.type() === 'error' && complaints.push(message.text()));
    page.on('pageerror', (error) => complaints.push(String(error)));
    page.on('request', (request) => {
      if (!request.url().startsWith(address)) complaints.push(`it asks for ${request.url()}`);
    });
    await prepare?.(page);
    await page.goto(address + hash);
    await act(page);
  } catch (error) {
    complaints.push(error.message);
  } finally {
    await browser.close();
  }
  demand(complaints.length === 0, `the page complains: ${complaints.join('; ')}`);
}

/** Demands something, or ends the program with what is wrong. */
export function demand(holds, wrong) {
  if (!holds) throw new Error(wrong);
}

/** Waits until the panel has come to rest with such words in the page's address. */
export function rest(page, words) {
  return page.waitForFunction(
    (words) => {
      if (document.querySelector('#panel').ariaBusy !== 'false') return false;
      const shown = new URLSearchParams(location.hash.slice(1));
      return Object.entries(words).every(([name, word]) => (shown.get(name) ?? '') === String(word));
    },
    words,
    { timeout: PATIENCE },
  );
}

/** Answers the red, green and blue of all pixels that the panel shows, in hexadecimal. */
export function levels(page) {
  return page.evaluate(() => {
    const canvas = document.querySelector('canvas');
    const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
    const shown = data.filter((_, place) => place % 4 !== 3);
    return [...shown].map((level) => level.toString(16).padStart(2, '0')).join('');
  });
}

/** Answers the FNV-1a checksum of the red, green and blue of all pixels that the panel shows. */
export function checksum(page) {
  return page.evaluate(() => {
    const canvas = document.querySelector('canvas');
    const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
    let sum = 0x811c9dc5;
    data.forEach((level, place) => {
      if (place % 4 !== 3) sum = Math.imul(sum ^ level, 0x01000193);
    });
    return sum >>> 0;
  });
}
