import { render } from 'preact';
import './style.css';
import { connection } from './state';
import { App } from './ui/App';
import { listen } from './ui/keys';
import { listenToPaste } from './ui/paste';

render(<App />, document.getElementById('app')!);
listen();
listenToPaste();
(window as unknown as Record<string, unknown>).pieperConnection = connection;
void connection.open();
