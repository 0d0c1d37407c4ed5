import type { PanelEvent } from '../protocol/messages';
import { MessageBuffer } from './message_buffer';

/** Which events of the run become messages of the list, and with which words. */
export class MessageLog {
  readonly buffer = new MessageBuffer();
  private tick = 0;

  event(event: PanelEvent): void {
    if ('tick' in event && event.tick > this.tick) this.tick = event.tick;
    switch (event.event) {
      case 'message':
        this.buffer.add(this.tick, /\berror\b|failed|died/.test(event.text) ? 'error' : 'message', event.text);
        break;
      case 'command':
        if (event.command !== 'jog') this.buffer.add(event.tick, 'command', `${event.command} by ${event.by}`);
        break;
      case 'commander':
        this.buffer.add(this.tick, 'command', event.commander ? `${event.commander} holds command` : 'command is free');
        break;
      case 'command_wanted':
        this.buffer.add(this.tick, 'command', `${event.by} asks for command, ${event.commander} holds it`);
        break;
      case 'question':
        this.buffer.add(this.tick, 'question', `${event.from} asks: ${event.text} (${event.expected})`);
        break;
      case 'process':
        if (event.error)
          this.buffer.add(event.tick, 'error', `${event.name}: ${event.error.text}: ${event.error.detail}`);
        break;
      case 'end':
        this.buffer.add(
          this.tick,
          event.exit_code === 0 ? 'message' : 'error',
          `the run has ended with exit code ${event.exit_code}${event.reason ? `: ${event.reason}` : ''}`,
        );
        break;
      case 'gone':
        this.buffer.add(this.tick, 'error', event.text);
        break;
      default:
        break;
    }
  }

  answer(text: string, refused: boolean): void {
    this.buffer.add(this.tick, refused ? 'refusal' : 'answer', text);
  }
}
