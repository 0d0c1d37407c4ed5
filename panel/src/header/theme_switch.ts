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
  const show = () => {
    if (theme === 'system') set_attribute(document.documentElement, 'data-theme', null);
    else set_attribute(document.documentElement, 'data-theme', theme);
    set_text(node, `Theme: ${theme}`);
    changed();
  };
  node.addEventListener('click', () => {
    theme = ORDER[(ORDER.indexOf(theme) + 1) % ORDER.length] ?? 'system';
    store(theme);
    show();
  });
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', changed);
  show();
  return node;
}

export function is_dark(): boolean {
  const chosen = document.documentElement.dataset['theme'];
  return chosen ? chosen === 'dark' : matchMedia('(prefers-color-scheme: dark)').matches;
}
