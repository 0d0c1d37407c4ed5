export type MessageKind = 'message' | 'command' | 'answer' | 'refusal' | 'question' | 'error';

export interface Message {
  number: number;
  tick: number;
  kind: MessageKind;
  text: string;
}

/** The newest messages; the oldest are dropped. */
export class MessageBuffer {
  private readonly kept: Message[] = [];
  private next = 0;

  constructor(private readonly capacity = 2000) {}

  add(tick: number, kind: MessageKind, text: string): Message {
    const message = { number: this.next++, tick, kind, text };
    this.kept.push(message);
    if (this.kept.length > this.capacity * 1.25) this.kept.splice(0, this.kept.length - this.capacity);
    return message;
  }

  /** Messages that contain every word of `filter`, in any case; at most `count`, the newest. */
  newest(filter: string, count: number): Message[] {
    const words = filter
      .toLowerCase()
      .split(/\s+/)
      .filter((word) => word !== '');
    const found: Message[] = [];
    for (let i = this.kept.length - 1; i >= 0 && found.length < Math.min(count, this.capacity); --i) {
      const message = this.kept[i];
      if (message && matches(message, words)) found.push(message);
    }
    return found.reverse();
  }

  /** Number of the newest message, or -1. */
  get last(): number {
    return this.next - 1;
  }
}

function matches(message: Message, words: string[]): boolean {
  if (words.length === 0) return true;
  const text = `${message.kind} ${message.text}`.toLowerCase();
  return words.every((word) => text.includes(word));
}

/** The file of a black box that a message names, or an empty text. */
export function black_box_of(text: string): string {
  return /black box: (\S+\.mcap)/.exec(text)?.[1] ?? '';
}
