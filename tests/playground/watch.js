// SPDX-License-Identifier: MIT
// The first part of the page: notes whatever goes wrong, and keeps the browser from handing out the page before it has
// been exercised.
window.noted = [];
const noteError = console.error;
console.error = (...args) => {
  window.noted.push(args.map(String).join(' '));
  noteError.apply(console, args);
};
addEventListener('error', (event) => window.noted.push(event.message));
addEventListener('unhandledrejection', (event) => window.noted.push(String(event.reason)));
document.addEventListener('securitypolicyviolation', (event) => window.noted.push(`${event.violatedDirective} ${event.blockedURI}`));
window.holder = document.createElement('iframe');
window.holder.hidden = true;
document.body.append(window.holder);
window.holder.contentDocument.open();
