import type { ErrorReport } from '../protocol/messages';

/** The class of an error code, as in docs/reference/errors.md. */
export function class_of(error: ErrorReport): string {
  if (error.code >= 200) return 'system error';
  return error.code >= 100 ? 'hardware error' : 'non-fatal error';
}

export function error_text(error: ErrorReport): string {
  return error.detail ? `${error.text}: ${error.detail}` : error.text;
}
