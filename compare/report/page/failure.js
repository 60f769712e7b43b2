// SPDX-License-Identifier: MIT
// A page that cannot be put together says so, instead of staying empty.
window.addEventListener('error', (event) => {
  if ('ready' in document.documentElement.dataset) return;
  const text = document.createElement('p');
  text.className = 'warning';
  text.textContent = `This report cannot be shown in full: ${event.message}`;
  document.getElementById('notices').append(text);
});
