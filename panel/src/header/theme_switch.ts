import { button, set_attribute, set_text } from '../dom/element';

type Theme = 'system' | 'light' | 'dark';
const ORDER: Theme[] = ['system', 'light', 'dark'];
const KEY = 'mrroc-panel-theme';

function stored(): Theme {
  try {
    const text = localStorage.getItem(KEY);
    return ORDER.find((theme) => theme === text) ?? 'system';
  } catch {
    return 'system'; // storage is blocked in this browser
  }
}

function store(theme: Theme): void {
  try {
    localStorage.setItem(KEY, theme);
  } catch {
    // the choice is then valid until the page is closed
  }
}

/** Light, dark or as the system has it. `changed` is called after every change. Hook: `#theme`. */
export function theme_switch(changed: () => void): HTMLElement {
  let theme = stored();
  const node = button('', { id: 'theme', class: 'plain' });
  const dark = matchMedia('(prefers-color-scheme: dark)');
  const show = () => {
    const shown = theme === 'system' ? (dark.matches ? 'dark' : 'light') : theme;
    set_attribute(document.documentElement, 'data-theme', shown);
    set_text(node, `Theme: ${theme}`);
    changed();
  };
  node.addEventListener('click', () => {
    theme = ORDER[(ORDER.indexOf(theme) + 1) % ORDER.length] ?? 'system';
    store(theme);
    show();
  });
  dark.addEventListener('change', show);
  show();
  return node;
}

export function is_dark(): boolean {
  return document.documentElement.dataset['theme'] === 'dark';
}
