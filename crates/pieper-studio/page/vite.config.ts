import { defineConfig } from 'vitest/config';

// The built page is embedded in the program: hashed names, no source maps, nothing inlined that the page's policy forbids.
export default defineConfig({
  base: './',
  esbuild: { jsx: 'automatic', jsxImportSource: 'preact', legalComments: 'none' },
  build: { target: 'es2022', assetsInlineLimit: 0, modulePreload: { polyfill: false }, chunkSizeWarningLimit: 900 },
  test: { include: ['tests/unit/**/*.test.ts'] },
});
