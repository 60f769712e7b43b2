// SPDX-License-Identifier: MIT
// Before everything else on the page: notes whatever goes wrong.
window.noted = [];
(() => {
  const note = (kind, text) => window.noted.push(`${kind}: ${text}`);
  const original = console.error;
  console.error = (...args) => {
    note('console.error', args.map(String).join(' '));
    original.apply(console, args);
  };
  window.addEventListener('error', (event) => note('error', event.message));
  window.addEventListener('unhandledrejection', (event) => note('unhandledrejection', String(event.reason)));
  document.addEventListener('securitypolicyviolation',
                            (event) => note('blocked', `${event.violatedDirective} ${event.blockedURI}`));
})();
