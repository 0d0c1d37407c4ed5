import { element, set_attribute, set_hidden, set_text } from '../dom/element';
import { count_text, time_text } from '../format/units';
import type { Camera } from '../protocol/scene_file';
import type { Session } from '../session';

const TICK_HEADER = 'Mrroc-Tick';

/** One camera: its newest picture and the time that it shows. Hooks: `[data-camera]`, `img[data-tick]`, `.hint`. */
export class CameraView {
  readonly node: HTMLElement;
  private readonly image: HTMLImageElement;
  private readonly time = element('span', { class: 'time' });
  private readonly hint = element('p', { class: 'hint' });
  private address = '';

  constructor(
    private readonly session: Session,
    private readonly camera: Camera,
  ) {
    this.image = element('img', {
      alt: `Picture of the camera ${camera.name}`,
      width: camera.width,
      height: camera.height,
    });
    const caption = element('figcaption', {}, element('strong', {}, camera.name), this.time);
    this.node = element('figure', { class: 'camera', 'data-camera': camera.name }, this.image, this.hint, caption);
    this.show_hint(camera.reason ?? 'no picture yet');
  }

  /** Whether there can be a picture. */
  get shown(): boolean {
    return this.camera.reason === null;
  }

  /** Asks the server for the newest picture and shows it, or the reason why it is missing. */
  async update(): Promise<void> {
    try {
      const answer = await fetch(`pictures/${this.camera.name}.png`, { cache: 'no-store' });
      if (!answer.ok) this.show_hint(`no picture: ${(await answer.text()).trim()}`);
      else await this.show(await answer.blob(), Number(answer.headers.get(TICK_HEADER)));
    } catch {
      this.show_hint('no picture: the panel does not answer');
    }
  }

  private async show(picture: Blob, tick: number): Promise<void> {
    const before = this.address;
    this.address = URL.createObjectURL(picture);
    this.image.src = this.address;
    await this.image.decode();
    if (before) URL.revokeObjectURL(before);
    set_attribute(this.image, 'data-tick', String(tick));
    set_text(this.time, `${time_text(this.session.seconds(tick))} · tick ${count_text(tick)}`);
    set_hidden(this.hint, true);
    set_hidden(this.image, false);
  }

  private show_hint(text: string): void {
    set_text(this.hint, text);
    set_text(this.time, '');
    set_hidden(this.hint, false);
    set_hidden(this.image, true);
  }
}
