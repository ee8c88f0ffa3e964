// A headless Chromium without network, and what a page complains of.
import { existsSync } from 'node:fs';
import { pathToFileURL } from 'node:url';
import { resolve } from 'node:path';

export const skipped = 77;  // exit code that ctest takes for "skipped"

export function skip(reason) {
  console.log(`skipped: ${reason}`);
  process.exit(skipped);
}

/// Opens a page from a file, or ends the process as skipped where there is no browser.
export async function open(file) {
  const executablePath = ['/usr/bin/chromium', '/usr/bin/chromium-browser', '/usr/bin/google-chrome']
    .find(path => existsSync(path));
  if (!executablePath) skip('no Chromium (apt-get install chromium)');
  let playwright;
  try {
    playwright = await import('playwright-core');
  } catch {
    skip('no playwright-core (npm install --prefix tests/browser)');
  }
  const browser = await playwright.chromium.launch({ executablePath, args: ['--no-sandbox'] });
  const context = await browser.newContext({ viewport: { width: 1100, height: 900 }, offline: true });
  const page = await context.newPage();
  const complaints = [];
  page.on('console', message => {
    if (['error', 'warning'].includes(message.type())) complaints.push(message.text());
  });
  page.on('pageerror', error => complaints.push(String(error)));
  page.on('request', request => {
    if (!/^(file|data|blob):/.test(request.url())) complaints.push(`asks for ${request.url()}`);
  });
  await page.goto(pathToFileURL(resolve(file)).href);
  return { browser, page, complaints };
}
