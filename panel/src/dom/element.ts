/** Small tools for the page's elements. They write to the page only what has changed. */

type Attributes = Record<string, string | number | boolean | undefined>;
type Child = Node | string;

/** Makes an element; `class`, `data-...`, `aria-...` and all other attributes are given by name. */
export function element<Name extends keyof HTMLElementTagNameMap>(
  name: Name,
  attributes: Attributes = {},
  ...children: Child[]
): HTMLElementTagNameMap[Name] {
  const made = document.createElement(name);
  for (const [attribute, value] of Object.entries(attributes)) {
    if (value === undefined || value === false) continue;
    made.setAttribute(attribute, value === true ? '' : String(value));
  }
  made.append(...children);
  return made;
}

export function button(text: string, attributes: Attributes = {}, click?: () => void): HTMLButtonElement {
  const made = element('button', { type: 'button', ...attributes }, text);
  if (click) made.addEventListener('click', click);
  return made;
}

export function set_text(target: Element, text: string): void {
  if (target.textContent !== text) target.textContent = text;
}

export function set_attribute(target: Element, name: string, value: string | null): void {
  if (target.getAttribute(name) === value) return;
  if (value === null) target.removeAttribute(name);
  else target.setAttribute(name, value);
}

export function set_class(target: Element, name: string, on: boolean): void {
  if (target.classList.contains(name) !== on) target.classList.toggle(name, on);
}

export function set_hidden(target: HTMLElement, hidden: boolean): void {
  if (target.hidden !== hidden) target.hidden = hidden;
}

/** Disables a control without taking it out of the tab order: `reason` is its description. Empty: enabled. */
export function set_refusal(target: HTMLElement, reason: string): void {
  set_attribute(target, 'aria-disabled', reason ? 'true' : null);
  set_attribute(target, 'title', reason || (target.dataset['title'] ?? null));
}

export function is_refused(target: Element): boolean {
  return target.getAttribute('aria-disabled') === 'true';
}

export function by_id(id: string): HTMLElement {
  const found = document.getElementById(id);
  if (!found) throw new Error(`the page has no element '${id}'`);
  return found;
}

/** True where a space is text: the space bar is then not the emergency stop. A number has no spaces. */
export function is_text_field(target: EventTarget | null): boolean {
  if (!(target instanceof HTMLElement)) return false;
  if (target instanceof HTMLTextAreaElement || target.isContentEditable) return true;
  if (!(target instanceof HTMLInputElement)) return false;
  return target.type === 'search' || (target.type === 'text' && target.inputMode !== 'decimal');
}
