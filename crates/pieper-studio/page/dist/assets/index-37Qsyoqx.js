var At,Lm,Im,Fs,Iu,zl,Um,wl,Nm,Gh,Uu,Da=Symbol.for("pv"),Hl={},Vl=[],s0=/^m(i|n|o|s|text|space)$/,Wh=Array.isArray,Xh=Vl.slice,Mr=Object.assign;function vr(n){n&&n.parentNode&&n.remove()}function r0(n,e,t){var i,s,r,o={},a=arguments.length;for(r in e)r=="key"?i=e[r]:r=="ref"&&typeof n!="function"?s=e[r]:o[r]=e[r];return a>2&&(o.children=a>3?Xh.call(arguments,2):t),ma(n,o,i,s,null)}function ma(n,e,t,i,s){var r={type:n,props:e,key:t,ref:i,__k:null,__:null,__b:0,__e:null,__c:null,constructor:Da,__v:s||++Lm,__i:-1,__u:0};return!s&&At.vnode&&At.vnode(r),r}function jn(n){return n.children}function _a(n,e){this.props=n,this.context=e,this.__g=0}function Gs(n,e){if(e==null)return n.__&&Gs(n.__,n.__i+1);for(var t;e<n.__k.length;e++)if((t=n.__k[e])&&t.__e)return t.__e;return typeof n.type!="function"||n.props.__P?null:Gs(n)}function o0(n){var e,t=n.__v,i=t.__e,s=[],r=[],o=n.__P;o&&((e=Mr({constructor:Da},t)).__v=t.__v+1,At.vnode&&At.vnode(e),Yh(o,e,t,n.__n,o.namespaceURI,32&t.__u?[i]:null,s,i||Gs(t),32&t.__u,r),e.__v=t.__v,e.__.__k[e.__i]=e,Hm(s,e,r),t.__=t.__e=null,e.__e!=i&&Fm(e))}function Fm(n){if((n=n.__)&&n.__c&&!n.props.__P)return n.__e=null,n.__k.some(function(e){return e&&(n.__e=e.__e)}),Fm(n)}function od(n){(8&n.__g||(n.__g|=8,Fs.push(n),zl++))&&Iu==At.debounceRendering||((Iu=At.debounceRendering)||queueMicrotask)(Om)}function Om(){try{for(var n,e=1;Fs.length;)Fs.length>e&&Fs.sort(Um),n=Fs.shift(),e=Fs.length,8&n.__g&&o0(n)}finally{(zl=Fs.length)&&(Iu||queueMicrotask)(Om)}}function km(n,e,t,i,s,r,o,a,l,c,u){var h,f,d,_,x,m,p=i.__k||Vl,S=e.length;for(l=a0(t,e,p,l,S),h=0;h<S;h++)(d=t.__k[h])!=null&&(f=~d.__i&&p[d.__i]||Hl,d.__i=h,m=Yh(n,d,f,s,r,o,a,l,c,u),_=d.__e,(f.ref!=d.ref||8&f.__u)&&(f.ref&&qh(f.ref,null,d,f),d.ref&&u.push(d.ref,d.__c||_,d)),x=x||_,4&d.__u?(l=Bm(d,l,n,!f.__v),f.__e&&(f.__e=null)):typeof d.type=="function"&&m!==void 0?l=m:_&&(l=_.nextSibling),d.__u&=-21);return t.__e=x,l}function a0(n,e,t,i,s){var r,o,a,l,c,u,h,f,d,_=t.length,x=_,m=0,p=0,S=n.__k=Array(s);for(r=0;r<s;r++)(o=e[r])!=null&&typeof o!="boolean"&&typeof o!="function"?(typeof o!="object"||o.constructor===String?o=S[r]=ma(null,o):Wh(o)?o=S[r]=ma(jn,{children:o}):o.constructor===Da&&o.__b?o=S[r]=ma(o.type,o.props,o.key,o.ref,o.__v):S[r]=o,l=r+m,o.__=n,o.__b=n.__b+1,a=null,~(c=o.__i=l0(o,t,l,x))&&(x--,(a=t[c])&&(a.__u|=2)),a&&a.__v?(o.__u|=16,c==l-1?m--:c==l+1?m++:c!=l&&(c>l?m--:m++,p=1)):(~c||(s>_?m--:s<_&&m++),typeof o.type!="function"&&(o.__u|=4))):S[r]=null;if(p){for(u=[],h=[],r=0;r<s;r++)if((o=S[r])&&16&o.__u){for(m=0,f=u.length;m<f;)u[d=m+f>>1]<o.__i?m=d+1:f=d;u[m]=o.__i,h[r]=m+1}for(m=u.length;r--;)h[r]&&(h[r]==m?m--:S[r].__u|=4)}if(x)for(r=0;r<_;r++)!(a=t[r])||2&a.__u||(a.__e==i&&(i=Gs(a)),$h(a,a));return i}function Bm(n,e,t,i){var s,r,o,a;if(typeof n.type=="function"){if(n.props.__P)return e;if(s=n.__k)for(r=0;r<s.length;r++)s[r]&&(s[r].__=n,e=Bm(s[r],e,t,!1));return e}for(e&&!e.parentNode&&(e=Gs(n))&&!e.parentNode&&(e=null),o=n.__e,a=e;a&&a.nodeType==8;)a=a.nextSibling;for(o!=a&&(!i&&t.moveBefore&&o.parentNode?t.moveBefore(o,e):t.insertBefore(o,e||null)),e=o;(e=e&&e.nextSibling)&&e.nodeType==8&&!e.data.startsWith("$s"););return e}function l0(n,e,t,i){var s,r=n.key,o=n.type,a=e[t],l=a&&!(2&a.__u);if(a===null&&r==null||l&&r==a.key&&o==a.type)return t;if(i>(l?1:0)){for(s=t-1;s>=0;s--)if((a=e[s])&&!(2&a.__u)&&r==a.key&&o==a.type)return s;for(s=t+1;s<e.length;s++)if((a=e[s])&&!(2&a.__u)&&r==a.key&&o==a.type)return s}return-1}function ad(n,e,t){t==null&&(t=""),e[0]=="-"?n.setProperty(e,t):n[e]=t}function Va(n,e,t,i,s){var r,o;if(e=="style")if(typeof t=="string")n.style.cssText=t;else{if(typeof i=="string"&&(n.style.cssText=i=""),i)for(e in i)t&&e in t||ad(n.style,e);if(t)for(e in t)i&&t[e]==i[e]||ad(n.style,e,t[e])}else if(e[0]=="o"&&e[1]=="n")typeof t!="function"&&(t=null),typeof i!="function"&&(i=null),(n.__e||(n.__e={}))[e]=t,t&&i||(o=Uu[e]||(Uu[e]=c0(e)),(n.__a||(n.__a={}))[e]=Gh,r=e!=(e=e.replace(Nm,"$1")),(e=e.slice(2))[0]<"a"&&(e=e.toLowerCase()),t?n.addEventListener(e,o,r):n.removeEventListener(e,o,r));else{if(s=="http://www.w3.org/2000/svg")e=e.replace(/xlink(H|:h)/,"h").replace(/sName$/,"s");else if(e!="width"&&e!="height"&&e!="href"&&e!="list"&&e!="form"&&e!="tabIndex"&&e!="download"&&e!="rowSpan"&&e!="colSpan"&&e!="role"&&e!="popover"&&e in n)try{return void(n[e]=t??"")}catch{}if(typeof t=="function")return;t==null||t===!1&&e[4]!="-"?n.removeAttribute(e):n.setAttribute(e,e=="popover"&&t==1?"":t)}}function c0(n){return function(e){var t=this.__e;if(t){if(t=t[n],e[wl]==null)e[wl]=Gh++;else if(e[wl]<this.__a[n])return;return t(At.event?At.event(e):e)}}}function Yh(n,e,t,i,s,r,o,a,l,c){var u,h,f,d,_,x,m,p,S,w,y,L,R,U,N,T,b,C,B=e.type;if(e.constructor!==Da)return null;128&t.__u&&(l=32&t.__u,u=t.__c.__z)&&(e.__u|=l,h=r=[],u.nodeType==8?a=Tl(u,r):r.push(u),a=r[0]||a),(u=At.__b)&&u(e);e:if(typeof B=="function"){f=o.length;try{if(p=e.props,S=(u=B.prototype)&&u.render,w=(u=B.contextType)&&i[u.__c],y=u?w?w.props.value:u.__:i,(d=t.__c)?(e.__c=d,2&d.__g&&(d.__g|=1)):(S?e.__c=d=new B(p,y):(e.__c=d=new _a(p,y),d.constructor=B,d.render=h0),w&&w.sub(d),d.state||(d.state={}),d.__n=i,d.__g|=8,d.__h=[],d.__k=[]),S&&(d.__s||(d.__s=d.state),B.getDerivedStateFromProps&&(d.__s==d.state&&(d.__s=Mr({},d.__s)),Mr(d.__s,B.getDerivedStateFromProps(p,d.__s)))),_=d.props,x=d.state,d.__v=e,t.__c){if(p!==_&&S&&!B.getDerivedStateFromProps&&d.componentWillReceiveProps&&d.componentWillReceiveProps(p,y),e.__v==t.__v&&!(8&d.__g)||!(4&d.__g)&&d.shouldComponentUpdate&&d.shouldComponentUpdate(p,d.__s,y)===!1){e.__v!=t.__v&&(d.props=p,d.state=d.__s,d.__g&=-9),e.__e=t.__e,e.__k=t.__k,e.__k.some(function(z){z&&(z.__=e)}),Vl.push.apply(d.__h,d.__k),d.__k=[],d.__h.length&&o.push(d),a=Gs(t);break e}d.componentWillUpdate&&d.componentWillUpdate(p,d.__s,y),S&&d.componentDidUpdate&&d.__h.push(function(){d.componentDidUpdate(_,x,m)})}else S&&!B.getDerivedStateFromProps&&d.componentWillMount&&d.componentWillMount(),S&&d.componentDidMount&&d.__h.push(d.componentDidMount);d.context=y,d.props=p,d.__P=n,d.__g&=-5,L=At.__r,R=S?25:0;do d.__g&=-9,L&&L(e),u=d.render(d.props,d.state=d.__s,d.context);while(8&d.__g&&++R<25);S&&(Vl.push.apply(d.__h,d.__k),d.__k=[]),d.state=d.__s,d.getChildContext&&(i=Mr({},i,d.getChildContext())),S&&t.__c&&d.getSnapshotBeforeUpdate&&(m=d.getSnapshotBeforeUpdate(_,x)),U=u&&u.type===jn&&u.key==null?u.props.children:u,p.__P&&(u=a,s=(n=p.__P).namespaceURI,l=r=null,t.props&&t.props.__P!=n&&(t.__k.some(function(z){z&&$h(z,z)}),t.__k=null),a=t.__k?Gs(t,0):null),a=km(n,Wh(U)?U:[U],e,t,i,s,r,o,a,l,c),p.__P&&(e.__e=null,a=u),e.__u&=-161,h&&h.some(vr),d.__h.length&&o.push(d),1&d.__g&&(d.__g&=-4)}catch(z){if(o.length=f,e.__v=null,l||r)if(z&&z.then){if(e.__u|=128|l,r){for(~(b=r.indexOf(a||void 0))||(b=r.length);(C=r[b-1])&&C.nodeType==8;)b--;for(;b<r.length;b++)if(C=r[b])if(r[b]=null,N){if(C==T)break}else{if(C.nodeType!=8)break;C.data.startsWith("$s")&&(T=Tl(N=C))}}if(!N){for(;a&&a.nodeType==8&&a.nextSibling;)a=a.nextSibling;N=a}(u=Tl(N=e.__c.__z||(e.__c.__z=N)))?(e.__e=N,a=u):e.__e=a,a=a&&a.nextSibling}else r&&r.some(vr);else e.__e=t.__e;e.__k||(e.__k=t.__k||[]),z&&z.then||zm(e),At.__e(z,e,t)}}else a=e.__e=u0(t.__e,e,t,i,s,r,o,l,c,n);return(u=At.diffed)&&u(e),a}function Tl(n,e){if(n&&n.nodeType==8&&n.data.startsWith("$s"))for(var t=1;n=n.nextSibling;){if(n.nodeType==8){if(n.data.startsWith("$s"))t++;else if(n.data.startsWith("/$s")&&!--t)return n}e&&e.push(n)}}function zm(n){n&&(n.__c&&(n.__c.__g|=4),n.__k&&n.__k.some(zm))}function Hm(n,e,t){for(var i=0;i<t.length;)qh(t[i++],t[i++],t[i++]);At.__c&&At.__c(e,n),n.some(function(s){try{n=s.__h,s.__h=[],n.some(function(r){r.call(s)})}catch(r){At.__e(r,s.__v)}})}function u0(n,e,t,i,s,r,o,a,l,c){var u,h,f,d,_,x,m,p,S=t.props||Hl,w=e.props,y=e.type;if(y=="svg"?s="http://www.w3.org/2000/svg":y=="math"?s="http://www.w3.org/1998/Math/MathML":s||(s="http://www.w3.org/1999/xhtml"),r){for(u=0;u<r.length;u++)if((_=r[u])&&(y?_.localName==y:_.nodeType==3)){n=_,r[u]=null;break}}if(!n){if(p=c.ownerDocument||document,!y)return p.createTextNode(w);n=p.createElementNS(s,y,w.is?w:c),a&&(At.__m&&At.__m(e,r),a=!1),r=null}if(y){if(c=y=="template"&&n.content||n,r=y=="textarea"&&w.defaultValue!=null?null:r&&Xh.call(c.childNodes),!a&&r)for(S={},u=0;u<n.attributes.length;u++)S[(_=n.attributes[u]).name]=_.value;for(u in S)_=S[u],u=="dangerouslySetInnerHTML"?f=_:u=="children"||u in w||u=="value"&&"defaultValue"in w||u=="checked"&&"defaultChecked"in w||Va(n,u,null,_,s);for(u in w)_=w[u],u=="children"?d=_:u=="dangerouslySetInnerHTML"?h=_:u=="value"?x=_:u=="checked"?m=_:a&&typeof _!="function"||S[u]===_||Va(n,u,_,S[u],s);h?(a||f&&(h.__html==f.__html||h.__html==n.innerHTML)||(n.innerHTML=h.__html),e.__k=[]):(f&&(n.textContent=""),(y=="foreignObject"||s=="http://www.w3.org/1998/Math/MathML"&&s0.test(y))&&(s="http://www.w3.org/1999/xhtml"),km(c,Wh(d)?d:[d],e,t,i,s,r,o,r?r[0]:t.__k&&Gs(t,0),a,l),r&&r.some(vr)),a&&y!="textarea"||(u="value",y=="progress"&&x==null?n.removeAttribute(u):x==null||x===n[u]&&(y!="progress"||x)||Va(n,u,x,S[u],s),u="checked",m!=null&&m!=n[u]&&Va(n,u,m,S[u],s))}else S===w||a&&n.data==w||(n.data=w);return n}function qh(n,e,t,i){try{typeof n=="function"?e?e.__x=n(e)||1:i&&(i=i.__c||i.__e)&&(e=i.__x)&&(i.__x=null,typeof e=="function"?e():n(null)):n.current=e}catch(s){At.__e(s,t)}}function $h(n,e,t){var i,s,r,o;if(At.unmount&&At.unmount(n),!(i=n.ref)||i.current&&i.current!=n.__e||qh(i,null,e,n),i=n.__c){if(i.componentWillUnmount)try{i.componentWillUnmount()}catch(a){At.__e(a,e)}i.__P=i.__n=null}if(i=n.__k)for(o=0;o<i.length;o++)i[o]&&$h(i[o],e,typeof n.type!="function"||t&&!n.props.__P);!t&&(i=n.__c)&&(i=i.__z)&&(s=Tl(i,r=[]))&&(i==n.__e&&r.some(vr),vr(s),vr(i)),t||vr(n.__e),n.__e=n.__c=n.__=null}function h0(n,e,t){return this.constructor(n,t)}function f0(n,e){var t,i,s,r;At.__&&At.__(n,e),e.nodeType==9&&(e=e.documentElement),i=(t=n&&32&n.__u)?null:e.__k,e.__k=ma(jn,{children:[n]}),s=[],r=[],Yh(e,e.__k,i||Hl,Hl,e.namespaceURI,i?null:e.firstChild?Xh.call(e.childNodes):null,s,i?i.__e:e.firstChild,t,r),Hm(s,e.__k,r),e.__k.props.children=null}At={__e:function(n,e,t,i){for(var s,r,o;e=e.__;)if((s=e.__c)&&!(1&s.__g)){s.__g|=4;try{if((o=(r=s.constructor)&&r.getDerivedStateFromError)&&s.setState(r.getDerivedStateFromError(n)),s.componentDidCatch&&(s.componentDidCatch(n,i||{}),o=1),o&&8&s.__g)return void(s.__g|=2)}catch(a){n=a}}throw zl=0,n}},Lm=0,Im=function(n){return n!=null&&n.constructor===Da},_a.prototype.setState=function(n,e){var t=this.__s;t&&t!=this.state||(t=this.__s=Mr({},this.state)),typeof n=="function"&&(n=n(Mr({},t),this.props)),n&&(Mr(t,n),this.__v&&(e&&this.__k.push(e),od(this)))},_a.prototype.forceUpdate=function(n){this.__v&&(this.__g|=4,n&&this.__h.push(n),od(this))},_a.prototype.render=jn,Fs=[],zl=0,Um=function(n,e){return n.__v.__b-e.__v.__b},wl=Symbol(),Nm=/(PointerCapture)$|Capture$/i,Gh=0,Uu={};var d0=Symbol.for("pv"),p0=0;function v(n,e,t,i,s,r){e||(e={});var o,a,l=e;if("ref"in l&&typeof n!="function")for(a in l={},e)a=="ref"?o=e[a]:l[a]=e[a];var c={type:n,props:l,key:t,ref:o,__k:null,__:null,__b:0,__e:null,__c:null,constructor:d0,__v:--p0,__i:-1,__u:0};return At.vnode&&At.vnode(c),c}var go,hn,Nc,ld,Nu=Object.is,Gl=0,Vm=[],Fu=[],sn=At,cd=sn.__b,ud=sn.__r,hd=sn.diffed,fd=sn.__c,dd=sn.unmount,pd=sn.__;function ac(n,e){sn.__h&&sn.__h(hn,n,Gl||e),Gl=0;var t=hn.__H||(hn.__H={__:[],__h:[]});return n>=t.__.length&&t.__.push({}),t.__[n]}function vo(n){return Gl=1,m0(Gm,n)}function m0(n,e,t){var i=ac(go++,2);if(i.t=n,!i.__c&&(i.__=[Gm(void 0,e),function(r){var o=(i.__N||i.__)[0],a=i.t(o,r);Nu(o,a)||(i.__N=[a,i.__[1]],i.__c.setState({}))}],i.__c=hn,!hn.__f)){hn.__f=!0;var s=hn.shouldComponentUpdate;hn.shouldComponentUpdate=function(r,o,a){var l=this.__H;if(!l)return!0;var c=!1,u=this.props!=r;if(l.__.some(function(f){f.__N&&(c=!0,Nu(f.__[0],f.__N[0])||(u=!0))}),s){var h=s.call(this,r,o,a);return c?h||u:h}return!c||u}}return i.__}function br(n,e){var t=ac(go++,3);!sn.__s&&Kh(t.__H,e)&&(t.__P=!0,t.__=n,t.u=e,hn.__H.__h.push(t))}function _0(n,e){var t=ac(go++,4);!sn.__s&&Kh(t.__H,e)&&(t.__P=!1,t.__=n,t.u=e,hn.__h.push(t))}function ui(n){return Gl=5,jh(function(){return{current:n}},[])}function jh(n,e){var t=ac(go++,7);return Kh(t.__H,e)&&(t.__=n(),t.__H=e),t.__}function g0(){var n;do{for(;n=Fu.shift();)try{ga(n)}catch(t){sn.__e(t,{__:(n=n.__P)&&n.__v})}for(;n=Vm.shift();){var e=n.__H;if(n.__P&&e)try{e.__h.some(ga),e.__h.some(Ou),e.__h=[]}catch(t){e.__h=[],sn.__e(t,n.__v)}}}while(Fu.length)}sn.__b=function(n){hn=null,cd&&cd(n)},sn.__=function(n,e){n&&e.__k&&e.__k.__m&&(n.__m=e.__k.__m),pd&&pd(n,e)},sn.__r=function(n){ud&&ud(n),go=0;var e=(hn=n.__c).__H;e&&(Nc==hn?hn.__h=[]:(e.__h.some(ga),e.__h.some(Ou),go=0),e.__h=[],e.__.some(function(t){t.__N&&(t.__=t.__N),t.u=t.__N=void 0})),Nc=hn},sn.diffed=function(n){hd&&hd(n);var e=n.__c;e&&e.__H&&(e.__H.__h.length&&_d(Vm.push(e)),e.__H.__.some(function(t){t.u&&(t.__H=t.u)})),Nc=hn=null},sn.__c=function(n,e){e.some(function(t){try{t.__h.some(ga),t.__h=t.__h.filter(function(i){return!i.__||Ou(i)})}catch(i){t.__h=[function(){throw i}]}}),fd&&fd(n,e)},sn.unmount=function(n){dd&&dd(n);var e,t,i=n.__c;i&&i.__H&&(i.__H.__.some(function(s){try{if(s.__P&&s.__c){if(t===void 0){for(t=n.__;t&&(!t.__c||!t.__c.__P);)t=t.__;t=t&&t.__c}s.__P=t,_d(Fu.push(s))}else ga(s)}catch(r){e=r}}),i.__H=void 0,e&&sn.__e(e,i.__v))};var md=typeof requestAnimationFrame=="function";function v0(n){var e,t=function(){clearTimeout(i),md&&cancelAnimationFrame(e),setTimeout(n)},i=setTimeout(t,35);md&&(e=requestAnimationFrame(t))}function _d(n){n!=1&&ld==sn.requestAnimationFrame||((ld=sn.requestAnimationFrame)||v0)(g0)}function ga(n){var e=hn,t=n.__c;typeof t=="function"&&(n.__c=void 0,t()),hn=e}function Ou(n){var e=hn;n.__c=n.__(),hn=e}function Kh(n,e){return!n||n.length!=e.length||e.some(function(t,i){return!Nu(t,n[i])})}function Gm(n,e){return typeof e=="function"?e(n):e}var x0=Symbol.for("preact-signals");function lc(){if(fs>1)fs--;else{var n,e=!1;for((function(){var s=Xl;for(Xl=void 0;s!==void 0;){var r=s.S;if(r.v===s.v)for(var o=r.t;o!==void 0;o=o.x)o.i===s.i&&(o.i=r.i);s=s.o}})();xa!==void 0;){var t=xa;for(xa=void 0,Wl++;t!==void 0;){var i=t.u;if(t.u=void 0,t.f&=-3,!(8&t.f)&&Xm(t))try{t.c()}catch(s){e||(n=s,e=!0)}t=i}}if(Wl=0,fs--,e)throw n}}function y0(n){if(fs>0)return n();ku=++M0,fs++;try{return n()}finally{lc()}}var va,Zt=void 0;function cc(n){var e=Zt,t=va;Zt=void 0,va=void 0;try{return n()}finally{Zt=e,va=t}}var xa=void 0,fs=0,Wl=0,M0=0,ku=0,Xl=void 0,Yl=0;function Wm(n){if(Zt!==void 0){var e=n.n;if(e===void 0||e.t!==Zt)return e={i:0,S:n,p:Zt.s,n:void 0,t:Zt,e:void 0,x:void 0,r:e},Zt.s!==void 0&&(Zt.s.n=e),Zt.s=e,n.n=e,32&Zt.f&&n.S(e),e;if(e.i===-1)return e.i=0,e.n!==void 0&&(e.n.p=e.p,e.p!==void 0&&(e.p.n=e.n),e.p=Zt.s,e.n=void 0,Zt.s.n=e,Zt.s=e),e}}function Ln(n,e){this.v=n,this.i=0,this.n=void 0,this.t=void 0,this.l=0,this.W=e?.watched,this.Z=e?.unwatched,this.name=e?.name}Ln.prototype.brand=x0;Ln.prototype.h=function(){return!0};Ln.prototype.S=function(n){var e=this,t=this.t;t!==n&&n.e===void 0&&(n.x=t,this.t=n,t!==void 0?t.e=n:cc(function(){var i;(i=e.W)==null||i.call(e)}))};Ln.prototype.U=function(n){var e=this;if(this.t!==void 0){var t=n.e,i=n.x;t!==void 0&&(t.x=i,n.e=void 0),i!==void 0&&(i.e=t,n.x=void 0),n===this.t&&(this.t=i,i===void 0&&cc(function(){var s;(s=e.Z)==null||s.call(e)}))}};Ln.prototype.subscribe=function(n){var e=this;return Jt(function(){var t=e.value;cc(function(){return n(t)})},{name:"sub"})};Ln.prototype.valueOf=function(){return this.value};Ln.prototype.toString=function(){return this.value+""};Ln.prototype.toJSON=function(){return this.value};Ln.prototype.peek=function(){var n=this;return cc(function(){return n.value})};Object.defineProperty(Ln.prototype,"value",{get:function(){var n=Wm(this);return n!==void 0&&(n.i=this.i),this.v},set:function(n){if(n!==this.v){if(Wl>100)throw new Error("Cycle detected");(function(t){fs!==0&&Wl===0&&t.l!==ku&&(t.l=ku,Xl={S:t,v:t.v,i:t.i,o:Xl})})(this),this.v=n,this.i++,Yl++,fs++;try{for(var e=this.t;e!==void 0;e=e.x)e.t.N()}finally{lc()}}}});function Xe(n,e){return new Ln(n,e)}function Xm(n){for(var e=n.s;e!==void 0;e=e.n)if(e.S.i!==e.i||!e.S.h()||e.S.i!==e.i)return!0;return!1}function Ym(n){for(var e=n.s;e!==void 0;e=e.n){var t=e.S.n;if(t!==void 0&&(e.r=t),e.S.n=e,e.i=-1,e.n===void 0){n.s=e;break}}}function qm(n){for(var e=n.s,t=void 0;e!==void 0;){var i=e.p;e.i===-1?(e.S.U(e),i!==void 0&&(i.n=e.n),e.n!==void 0&&(e.n.p=i)):t=e,e.S.n=e.r,e.r!==void 0&&(e.r=void 0),e=i}n.s=t}function Cr(n,e){Ln.call(this,void 0,e),this.x=n,this.s=void 0,this.g=Yl-1,this.f=4}Cr.prototype=new Ln;Cr.prototype.h=function(){if(this.f&=-3,1&this.f)return!1;if((36&this.f)==32||(this.f&=-5,this.g===Yl))return!0;if(this.g=Yl,this.f|=1,this.i>0&&!Xm(this))return this.f&=-2,!0;var n=Zt;try{Ym(this),Zt=this;var e=this.x();(16&this.f||this.v!==e||this.i===0)&&(this.v=e,this.f&=-17,this.i++)}catch(t){this.v=t,this.f|=16,this.i++}return Zt=n,qm(this),this.f&=-2,!0};Cr.prototype.S=function(n){if(this.t===void 0){this.f|=36;for(var e=this.s;e!==void 0;e=e.n)e.S.S(e)}Ln.prototype.S.call(this,n)};Cr.prototype.U=function(n){if(this.t!==void 0&&(Ln.prototype.U.call(this,n),this.t===void 0)){this.f&=-33;for(var e=this.s;e!==void 0;e=e.n)e.S.U(e)}};Cr.prototype.N=function(){if(!(2&this.f)){this.f|=6;for(var n=this.t;n!==void 0;n=n.x)n.t.N()}};Object.defineProperty(Cr.prototype,"value",{get:function(){if(1&this.f)throw new Error("Cycle detected");var n=Wm(this);if(this.h(),n!==void 0&&(n.i=this.i),16&this.f)throw this.v;return this.v}});function Bu(n,e){return new Cr(n,e)}function $m(n){var e=n.j;if(n.j=void 0,typeof e=="function"){fs++;var t=Zt;Zt=void 0;try{e()}catch(i){throw n.f&=-2,n.f|=8,Zh(n),i}finally{Zt=t,lc()}}}function Zh(n){for(var e=n.s;e!==void 0;e=e.n)e.S.U(e);n.x=void 0,n.s=void 0,$m(n)}function S0(n){if(Zt!==this)throw new Error("Out-of-order effect");qm(this),Zt=n,this.f&=-2;try{8&this.f&&Zh(this)}finally{lc()}}function Po(n,e){this.x=n,this.j=void 0,this.s=void 0,this.u=void 0,this.f=32,this.name=e?.name,va&&va.push(this)}Po.prototype.c=function(){var n=this.S();try{if(8&this.f||this.x===void 0)return;var e=this.x();typeof e=="function"&&(this.j=e)}finally{n()}};Po.prototype.S=function(){if(1&this.f)throw new Error("Cycle detected");this.f|=1,this.f&=-9,$m(this),Ym(this),fs++;var n=Zt;return Zt=this,S0.bind(this,n)};Po.prototype.N=function(){2&this.f||(this.f|=2,this.u=xa,xa=this)};Po.prototype.d=function(){this.f|=8,1&this.f||Zh(this)};Po.prototype.dispose=function(){this.d()};function Jt(n,e){var t=new Po(n,e);try{t.c()}catch(s){throw t.d(),s}var i=t.d.bind(t);return i[Symbol.dispose]=i,i}var jm,Ga,E0=typeof window<"u"&&!!window.__PREACT_SIGNALS_DEVTOOLS__,Km=[];Jt(function(){jm=this.N})();function Do(n,e){At[n]=e.bind(null,At[n]||function(){})}function Ea(n){if(Ga){var e=Ga;Ga=void 0,e()}Ga=n&&n.S()}function Zm(n){var e=this,t=n.data,i=w0(t);i.name="ReactiveDom",i.value=t;var s=jh(function(){for(var a=e,l=e.__v;l=l.__;)if(l.__c){l.__c.__$f|=4;break}var c=Bu(function(){var d=i.value.value;return d===0?0:d===!0?"":d||""}),u=Bu(function(){return!Array.isArray(c.value)&&!Im(c.value)}),h=Jt(function(){if(this.N=Jm,u.value){var d=c.value;a.__v&&a.__v.__e&&a.__v.__e.nodeType===3&&(a.__v.__e.data=d)}}),f=e.__$u.d;return e.__$u.d=function(){h(),f.call(this)},[u,c]},[]),r=s[0],o=s[1];return r.value?o.peek():o.value}Zm.displayName="ReactiveTextNode";Object.defineProperties(Ln.prototype,{constructor:{configurable:!0,value:r0(jn,null).constructor},type:{configurable:!0,value:Zm},props:{configurable:!0,get:function(){var n=this;return{data:{get value(){return n.value}}}}},__b:{configurable:!0,value:1}});Do("__b",function(n,e){if(Ea(),typeof e.type=="string"){var t,i=e.props;for(var s in i)if(s!=="children"){var r=i[s];r instanceof Ln&&(t||(e.__np=t={}),t[s]=r,i[s]=r.peek())}}n(e)});Do("__r",function(n,e){if(n(e),e.type!==jn){Ea();var t,i=e.__c;i&&(i.__$f&=-2,(t=i.__$u)===void 0&&(i.__$u=t=(function(s,r){var o;return Jt(function(){o=this},{name:r}),o.c=s,o})((function(s){return function(){var r;E0&&((r=this.y)==null||r.call(this)),s.__$f|=1,s.setState({})}})(i),typeof e.type=="function"?e.type.displayName||e.type.name:""))),Ea(t)}});Do("__e",function(n,e,t,i){Ea(),n(e,t,i)});Do("diffed",function(n,e){Ea();var t;if(typeof e.type=="string"&&(t=e.__e)){var i=e.__np,s=e.props,r=t.U;if(r)for(var o in r){var a=r[o];a===void 0||i&&o in i||(a.d(),r[o]=void 0)}if(i){r||(r={},t.U=r);for(var l in i){var c=r[l],u=i[l];c===void 0?(c=b0(t,l,u,s),r[l]=c):c.o(u,s)}}}n(e)});function b0(n,e,t,i){var s=e in n&&n.ownerSVGElement===void 0,r=Xe(t);return{o:function(o,a){r.value=o,i=a},d:Jt(function(){this.N=Jm;var o=r.value.value;i[e]!==o&&(i[e]=o,s?n[e]=o:o!=null&&(o!==!1||e[4]==="-")?n.setAttribute(e,o):n.removeAttribute(e))})}}Do("unmount",function(n,e){if(typeof e.type=="string"){var t=e.__e;if(t){var i=t.U;if(i){t.U=void 0;for(var s in i){var r=i[s];r&&r.d()}}}var o=e.__np;if(o){var a=e.props;for(var l in o)a[l]=o[l]}e.__np=void 0}else{var c=e.__c;if(c){c.__$f|=8;var u=c.__$u;u&&(c.__$u=void 0,u.d())}}n(e)});Do("__h",function(n,e,t,i){i<3&&(e.__$f|=2),n(e,t,i)});_a.prototype.shouldComponentUpdate=function(n,e){if(this.__R)return!0;var t=this.__$u,i=t&&t.s!==void 0;for(var s in e)return!0;if(this.__f||typeof this.u=="boolean"&&this.u===!0){var r=2&this.__$f;if(!(i||r||4&this.__$f)||1&this.__$f)return!0}else if(!(i||4&this.__$f)||3&this.__$f)return!0;for(var o in n)if(o!=="__source"&&n[o]!==this.props[o])return!0;for(var a in this.props)if(!(a in n))return!0;return!1};function w0(n,e){return jh(function(){return Xe(n,e)},[])}var T0=function(n){queueMicrotask(function(){queueMicrotask(n)})};function A0(){y0(function(){for(var n;n=Km.shift();)jm.call(n)})}function Jm(){Km.push(this)===1&&(At.requestAnimationFrame||T0)(A0)}const gd=250,R0=5e3;class C0{constructor(e){this.listener=e}listener;socket=null;waiting=new Map;next=1;wait=gd;async open(){const e=/(?:^#|&)token=([0-9a-f]+)/.exec(location.hash)?.[1];if(e){const t=await fetch("/api/session",{method:"POST",body:JSON.stringify({token:e})}).catch(()=>null);if(history.replaceState(null,"",location.pathname+location.search),t&&!t.ok)return this.listener.phase("refused",await t.text())}this.connect(),setInterval(()=>this.post({ping:performance.now()}),2e3)}connect(){this.listener.phase("connecting","");const e=new WebSocket(`ws://${location.host}/ws`);e.binaryType="arraybuffer",this.socket=e,e.onopen=()=>{this.wait=gd,this.listener.phase("open",""),this.post({ping:performance.now()})},e.onmessage=t=>{typeof t.data=="string"?this.text(JSON.parse(t.data)):this.listener.frame(t.data)},e.onclose=()=>{this.lost()}}async lost(){for(const t of this.waiting.values())t.reject(new Error("the connection was lost"));if(this.waiting.clear(),(await fetch("/api/project.json").catch(()=>null))?.status===401)return this.listener.phase("refused","This window is not signed in: open the address that the program printed.");this.listener.phase("lost",""),setTimeout(()=>this.connect(),this.wait),this.wait=Math.min(2*this.wait,R0)}text(e){if(typeof e.section=="string")return this.listener.section(e.section,e.value);if(typeof e.pong=="number")return this.listener.roundTrip(performance.now()-e.pong);if(typeof e.ack=="number"){const t=this.waiting.get(e.ack);this.waiting.delete(e.ack),typeof e.error=="string"?t?.reject(new Error(e.error)):t?.resolve(e.value);return}typeof e.event=="string"&&this.listener.event(e)}post(e){return this.socket?.readyState!==WebSocket.OPEN?!1:(this.socket.send(JSON.stringify(e)),!0)}send(e){const t=this.next++;return new Promise((i,s)=>{this.post({...e,id:t})?this.waiting.set(t,{resolve:i,reject:s}):s(new Error("not connected"))})}drop(){this.socket?.close()}}class wr{constructor(e,t=()=>{},i=()=>{}){this.send=e,this.answered=t,this.failed=i}send;answered;failed;busy=!1;latest=null;push(e){this.latest=e,this.busy||this.drain()}async drain(){for(this.busy=!0;this.latest;){const e=this.latest;this.latest=null;try{this.answered(await this.send(e))}catch(t){this.failed(t)}}this.busy=!1,this.idle.splice(0).forEach(e=>e())}idle=[];settled(){return this.busy?new Promise(e=>this.idle.push(e)):Promise.resolve()}}const vd=document.getElementById("snapshot"),Jh=vd?JSON.parse(vd.textContent??"null"):null,Lo=Jh!==null;function Al(n){const e=atob(n),t=new Uint8Array(e.length);for(let i=0;i<e.length;i++)t[i]=e.charCodeAt(i);return t.buffer}function P0(n){const e=Jh?.meshes[n];return e===void 0?null:Al(e)}class D0{constructor(e){this.listener=e}listener;data=Jh;motion=this.data.sections.motion;pictures=this.data.pictures.map(Al);last=0;open(){for(const[e,t]of Object.entries(this.data.sections))this.listener.section(e,t);return this.listener.frame(Al(this.data.frame)),this.listener.frame(Al(this.data.ghosts)),this.listener.phase("open","shared"),Promise.resolve()}drop(){}send(e){const{motion:t}=this;if(e.do==="samples")return Promise.resolve(this.data.samples);if(e.do==="ghosts"||e.do==="pick")return Promise.resolve(null);if(t)switch(e.do){case"play":return t.time>=t.duration&&(t.time=0),this.change({playing:!0}),this.last=performance.now(),requestAnimationFrame(()=>this.advance()),Promise.resolve(null);case"pause":return this.change({playing:!1}),Promise.resolve(null);case"seek":return this.show(Number(e.t)),this.change({}),Promise.resolve(null);case"step":return this.change({playing:!1}),this.show(t.time+Number(e.by)/30),this.change({}),Promise.resolve(null);case"loop":return this.change({loop:e.on===!0}),Promise.resolve(null);case"speed":return this.change({speed:Number(e.to)}),Promise.resolve(null)}return Promise.reject(new Error("This is a shared file: there is no program behind it."))}change(e){this.motion&&(this.motion={...this.motion,...e},this.listener.section("motion",this.motion))}show(e){const{motion:t}=this;if(!t)return;t.time=Math.min(t.duration,Math.max(0,e));const i=Math.round(t.time/t.duration*(this.pictures.length-1)),s=this.pictures[i];s&&this.listener.frame(s)}advance(){const{motion:e}=this;if(!e?.playing)return;const t=performance.now();let i=e.time+e.speed*(t-this.last)/1e3;if(this.last=t,i>e.duration&&e.loop&&(i%=e.duration),this.show(i),i>e.duration)return this.change({playing:!1});requestAnimationFrame(()=>this.advance())}}const Vr=16;function L0(n){if(n.byteLength<Vr+4)return null;const e=new DataView(n),t=e.getUint8(0),i=e.getUint16(2,!0),s=e.getUint32(4,!0),r=e.getUint32(Vr,!0);if(t===1){const o=Vr+4+4*r;return n.byteLength<o+64*i?null:{kind:"pose",playing:(e.getUint8(1)&1)===1,sequence:s,links:i,time:e.getFloat64(8,!0),q:new Float32Array(n,Vr+4,r),matrices:new Float32Array(n,o,16*i)}}return t===2||t===3?n.byteLength<Vr+4+64*i*r?null:{kind:t===2?"ghosts":"real",sequence:s,links:i,count:r,matrices:new Float32Array(n,Vr+4,16*i*r)}:null}function I0(n){if(n.byteLength<12)return null;const e=new DataView(n);if(e.getUint32(0,!0)!==827150416)return null;const t=e.getUint32(4,!0),i=e.getUint32(8,!0);return n.byteLength!==12+24*t+4*i?null:{positions:new Float32Array(n,12,3*t),normals:new Float32Array(n,12+12*t,3*t),indices:new Uint32Array(n,12+24*t,i)}}const ql=Xe([]),rn=Xe(null),ns=Xe(null),gs=Xe(null),vs=Xe(null),Qm=Xe({undo:null,redo:null}),oa=Xe([]),ya=Xe(null),Ms=Xe({phase:"off",said:[]}),ba=Xe([]),La=Xe(null),uc=Xe(new Float32Array),Ui=Xe(0),co=Xe("connecting"),e_=Xe(""),t_=Xe(null),aa=Xe([]),n_=Xe("");function xo(n,e,t){const i=Qh(()=>localStorage.getItem(`pieper.${n}`));return i&&e.includes(i)?i:t}function Fc(n,e){const t=Number(Qh(()=>localStorage.getItem(`pieper.${n}`)));return Number.isFinite(t)&&t>0?t:e}function Qh(n){try{return n()}catch{return null}}function xs(n,e){Qh(()=>localStorage.setItem(`pieper.${n}`,e))}const Oc=Xe("joints"),gi=Xe(null),zs=Xe(!0),$l={panel:Xe(Fc("panel",336)),drawer:Xe(Fc("drawer",236)),tall:Xe(Fc("tall",Math.min(420,Math.round(.46*innerHeight))))},li=Xe(xo("theme",["system","light","dark"],"system")),_t=Xe({angle:xo("angle",["deg","rad"],"deg"),length:xo("length",["mm","m"],"mm")}),Rl=Xe(xo("letters",["on","off"],"on")==="on"),hc=Xe(xo("tumble",["on","off"],"off")==="on"),ef=Xe(Lo||xo("hint",["seen","new"],"new")==="seen");function i_(){ef.value=!0,xs("hint","seen")}const Si=Xe(null),ot={ghosts:Xe(!1),frames:Xe(!1),trail:Xe(!0),outline:Xe(!1),gizmo:Xe("off"),local:Xe(!1),collision:Xe(!1)},Rs=Xe(null),la=Xe(null),Cl=Xe(!1),Sr=Bu(()=>li.value==="dark"||li.value==="system"&&r_.value),s_=matchMedia("(prefers-color-scheme: dark)"),r_=Xe(s_.matches);s_.addEventListener("change",n=>r_.value=n.matches);const o_=[];function U0(n){o_.push(n)}const N0={robots:n=>ql.value=n,robot:n=>rn.value=n,pose:n=>ns.value=n,ik:n=>gs.value=n,motion:n=>{const e=n.samples!==vs.value?.samples||!La.value;vs.value=n,n.playing||(Ui.value=n.time),e&&F0()},script:n=>ya.value=n,controller:n=>Ms.value=n,history:n=>Qm.value=n,log:n=>oa.value=n};async function F0(){La.value=await bi.send({do:"samples",rate:60})}const xd={section:(n,e)=>N0[n]?.(e),event:n=>{if(n.event!=="console")return;const e={stream:n.stream,text:n.text};ba.value=[...ba.value,e].slice(-500)},frame:n=>{const e=L0(n);if(e){e.kind==="pose"&&(uc.value=e.q,e.playing&&(Ui.value=e.time));for(const t of o_)t(e)}},phase:(n,e)=>{co.value=n,e_.value=e},roundTrip:n=>t_.value=n},bi=Lo?new D0(xd):new C0(xd);let O0=0;function gn(n,e="error"){const t=++O0;aa.value=[...aa.value.filter(i=>i.text!==n),{id:t,text:n,kind:e}].slice(-3),setTimeout(()=>aa.value=aa.value.filter(i=>i.id!==t),e==="error"?7e3:3500)}async function Ge(n){try{return await bi.send(n)}catch(e){gn(e.message);return}}let k0=0;function Tr(n){return`${n}-${++k0}-${Date.now()}`}const a_=Math.PI/180;function jl(n,e){return n==="angle"?e.angle==="deg"?"°":"rad":e.length}function Ws(n,e,t){if(!Number.isFinite(n))return"–";const[i,s]=e==="angle"?t.angle==="deg"?[n/a_,2]:[n,4]:t.length==="mm"?[n*1e3,2]:[n,5],r=i.toFixed(s);return Number(r)===0?0 .toFixed(s):r}function l_(n,e,t){const i=n.trim().replace(",",".");return/^[-+]?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?$/i.test(i)?`${i} ${e==="angle"?t.angle:t.length}`:i}function B0(n,e){return e==="angle"?`${(n/a_).toFixed(1)} degrees`:`${(n*1e3).toFixed(1)} millimetres`}function yo(n){return n.kind==="prismatic"?"length":"angle"}function c_(n){return n===0?"0":n.toExponential(1).replace("e+","e")}const zu=Xe({ports:[],protocols:[]}),kc=Xe("simulated"),Wa=Xe("packets"),fr=Xe(!1),ji=Xe(null);let Hu=!1;function tf(){const{live:n}=Ms.value;Hu&&!n&&(fr.value=!1),Hu=n===!0,!(!fr.value||!n)&&Ge({do:"controller_beat",hold:ji.value==="move",run:ji.value==="run"})}setInterval(tf,80);const nf=()=>{ji.value=null,Ge({do:"controller_stop"})},Kl=()=>{ji.value!==null&&(ji.value=null,tf())};for(const n of["blur","pointerup","pointercancel"])addEventListener(n,Kl);document.addEventListener("visibilitychange",Kl);function yd({what:n,text:e,disabled:t,begin:i}){const s=async()=>{ji.value||(ji.value=n,i&&await i(),tf())};return v("button",{type:"button",class:`hold ${ji.value===n?"held":""}`,disabled:t,"aria-pressed":ji.value===n,onPointerDown:()=>{s()},onKeyDown:r=>{[" ","Enter"].includes(r.key)&&!r.repeat&&(r.preventDefault(),s())},onKeyUp:r=>{[" ","Enter"].includes(r.key)&&(r.preventDefault(),Kl())},onBlur:()=>{ji.value===n&&Kl()},children:e})}function z0(){const n=Ms.value;return br(()=>{Ge({do:"controller_ports"}).then(e=>{e&&(zu.value=e)})},[]),n.phase==="off"||n.phase==="connecting"?v(H0,{}):v(V0,{})}function H0(){const n=Ms.value;return v("form",{class:"controller",onSubmit:t=>{t.preventDefault(),xs("protocol",Wa.value),Ge({do:"controller_connect",address:kc.value.trim(),protocol:Wa.value})},children:[v("p",{class:"quiet",children:["A connection shows the real arm beside the one in the picture, and moves nothing. ",v("code",{children:"simulated"})," is a controller that is not there."]}),v("div",{class:"row",children:[v("label",{class:"field",children:["Protocol ",v("select",{value:Wa.value,onChange:t=>Wa.value=t.currentTarget.value,children:zu.value.protocols.map(({name:t,summary:i})=>v("option",{value:t,children:[t,": ",i]},t))})]}),v("label",{class:"field",children:["At ",v("input",{class:"address",value:kc.value,list:"ports",spellcheck:!1,onInput:t=>kc.value=t.currentTarget.value})]}),v("datalist",{id:"ports",children:[v("option",{value:"simulated"}),zu.value.ports.map(({path:t,what:i})=>v("option",{value:t,children:i},t))]}),v("button",{type:"submit",class:"text-button go",disabled:n.phase==="connecting",children:n.phase==="connecting"?"Connecting…":"Connect"}),n.phase==="connecting"&&v("button",{type:"button",class:"text-button",onClick:()=>{Ge({do:"controller_disconnect"})},children:"Give up"})]}),v(u_,{})]})}function V0(){const n=Ms.value,e=n.phase==="lost",t=()=>{Hu=!1,fr.value=!0,Ge({do:"controller_arm"})},i=()=>Ge({do:"controller_play"}),s=(vs.value?.keyframes.length??0)>1;return v("div",{class:"controller",children:[v("div",{class:"row",children:[v("strong",{class:`phase ${n.live?"live":""}`,children:n.phase}),v("span",{class:"quiet",children:[n.protocol," at ",n.address,": ",n.controller]})]}),v("div",{class:"row",children:[!n.live&&v("button",{type:"button",class:"text-button go",disabled:e||n.phase==="arming",onClick:t,children:"Arm"}),n.live&&v("button",{type:"button",class:"text-button",disabled:!fr.value,onClick:()=>{Ge({do:"controller_disarm"})},children:"Disarm"}),v(yd,{what:"move",text:"Hold to move here",disabled:!n.live||!fr.value||n.phase==="playing"}),v(yd,{what:"run",text:"Hold to run the motion",disabled:!n.live||!fr.value||!s||n.phase==="moving",begin:i}),n.live&&!fr.value&&v("span",{class:"quiet small",children:"Another window has armed it."}),n.progress&&v("span",{class:"time",children:[n.progress[0].toFixed(1)," / ",n.progress[1].toFixed(1)," s"]}),v("span",{class:"grow"}),v("button",{type:"button",class:"text-button",onClick:()=>{Ge({do:"controller_disconnect"})},children:"Disconnect"})]}),v(u_,{}),v(G0,{})]})}function u_(){const{said:n,sentence:e}=Ms.value,t=e??n[n.length-1];return t?v("p",{class:"banner",role:"status",children:t}):null}function G0(){const{measured:n,commanded:e,error:t,lag:i,latency:s,dropped:r,late:o}=Ms.value,a=rn.value?.joints??[];if(!n)return null;const l=h=>a[h]?.kind==="prismatic"?"length":"angle",c=(h,f)=>h?Ws(h[f],l(f),_t.value):"–",u=[["farthest off",t?`${a[t.joint]?.label??""} ${Ws(Math.abs(t.error),l(t.joint),_t.value)}`:"–"],["lag",i==null?"–":`${Math.round(1e3*i)} ms`],["answers after",s==null?"–":`${(1e3*s).toFixed(1)} ms`],["late cycles",`${o??0}`],["dropped",`${r??0}`]];return v("div",{class:"mirror",children:[v("table",{class:"dh",children:[v("caption",{children:["Joints in ",_t.value.angle==="deg"?"degrees":"radians"]}),v("thead",{children:v("tr",{children:[v("th",{}),a.map(({label:h})=>v("th",{scope:"col",children:h},h))]})}),v("tbody",{children:[v("tr",{children:[v("th",{scope:"row",children:"sent"}),a.map((h,f)=>v("td",{children:c(e,f)},f))]}),v("tr",{children:[v("th",{scope:"row",children:"measured"}),a.map((h,f)=>v("td",{class:"real",children:c(n,f)},f))]})]})]}),v("dl",{class:"facts",children:u.map(([h,f])=>v(jn,{children:[v("dt",{children:h},h),v("dd",{children:f})]}))})]})}function W0(){return Ms.value.live?v(jn,{children:[v("div",{class:"live-frame","aria-hidden":"true"}),v("button",{type:"button",class:"stop-arm",onClick:nf,children:"Stop the arm"})]}):null}const X0={undo:"M7 5 3.5 8.5 7 12M4 8.5h7.5a4.5 4.5 0 0 1 0 9H9",redo:"M13 5l3.5 3.5L13 12M16 8.5H8.5a4.5 4.5 0 0 0 0 9H11",play:"M6 4.5v11l9-5.5z",pause:"M6.5 4.5v11M13.5 4.5v11",back:"M14 5v10l-6-5zM5.5 5v10",forward:"M6 5v10l6-5zM14.5 5v10",stop:"M5.5 5.5h9v9h-9z",loop:"M4 10a5 5 0 0 1 5-5h6M12.5 2.5 15 5l-2.5 2.5M16 10a5 5 0 0 1-5 5H5M7.5 17.5 5 15l2.5-2.5",sun:"M10 6.2a3.8 3.8 0 1 0 0 7.6 3.8 3.8 0 0 0 0-7.6M10 1.5v2M10 16.5v2M1.5 10h2M16.5 10h2M4 4l1.4 1.4M14.6 14.6 16 16M16 4l-1.4 1.4M5.4 14.6 4 16",moon:"M16 11.8A6.5 6.5 0 0 1 8.2 4 6.5 6.5 0 1 0 16 11.8z",auto:"M10 3a7 7 0 1 0 0 14zM10 3a7 7 0 0 1 0 14",camera:"M3 6.5h3l1.3-2h5.4l1.3 2h3v9H3zM10 8.2a2.6 2.6 0 1 0 0 5.2 2.6 2.6 0 0 0 0-5.2",home:"M3.5 9.5 10 4l6.5 5.5M5.5 8.5V16h9V8.5",ghost:"M4.5 16V9a5.5 5.5 0 0 1 11 0v7l-2-1.5-1.8 1.5L10 14.5 8.3 16l-1.8-1.5zM8 9v.01M12 9v.01",axes:"M6 14V4M6 14h10M6 14l-3 3M4.3 5.7 6 4l1.7 1.7M14.3 12.3 16 14l-1.7 1.7",trail:"M3 15c4 0 3-9 7-9s3 7 7 4",reach:"M3 16a7 7 0 0 1 14 0M6.5 16a3.5 3.5 0 0 1 7 0",move:"M10 2.5v15M2.5 10h15M7.8 4.7 10 2.5l2.2 2.2M7.8 15.3 10 17.5l2.2-2.2M4.7 7.8 2.5 10l2.2 2.2M15.3 7.8 17.5 10l-2.2 2.2",rotate:"M15.5 7A6.5 6.5 0 1 0 16.5 11M16 3v4h-4",plus:"M10 4v12M4 10h12",close:"M5 5l10 10M15 5 5 15",lock:"M5.5 9h9v7.5h-9zM7 9V6.5a3 3 0 0 1 6 0V9",unlock:"M5.5 9h9v7.5h-9zM7 9V6.5a3 3 0 0 1 5.8-1",warn:"M10 3.5 17.5 16h-15zM10 8v4M10 14v.01",check:"M4.5 10.5 8.5 14.5 15.5 6",help:"M7.5 7.5a2.5 2.5 0 1 1 3.6 2.2c-.7.4-1.1.9-1.1 1.8M10 14.5v.01",down:"M5 7.5 10 12.5 15 7.5",panel:"M3 4.5h14v11H3zM12.5 4.5v11",download:"M10 3.5v9M6.5 9.5 10 13l3.5-3.5M4 16h12",upload:"M10 13V4M6.5 7.5 10 4l3.5 3.5M4 16h12",dice:"M4 4h12v12H4zM7.5 7.5v.01M12.5 7.5v.01M10 10v.01M7.5 12.5v.01M12.5 12.5v.01",copy:"M7 7h9v9H7zM13 7V4H4v9h3",paste:"M7 4.5H4.5V17h11V4.5H13M7.5 3h5v3h-5zM10 8.5v5M7.8 11.3 10 13.5l2.2-2.2",fit:"M3 7V3h4M13 3h4v4M17 13v4h-4M7 17H3v-4"};function Ei({name:n}){return v("svg",{class:"icon",viewBox:"0 0 20 20","aria-hidden":"true",children:v("path",{d:X0[n]})})}function yt({icon:n,label:e,onClick:t,pressed:i,disabled:s,keys:r,text:o,class:a}){const l=r?`${e} (${r})`:e;return v("button",{type:"button",class:`icon-button ${a??""}`,title:l,"aria-label":e,disabled:s??!1,onClick:t,...i===void 0?{}:{"aria-pressed":i},children:[v(Ei,{name:n}),o&&v("span",{children:o})]})}function dr({value:n,kind:e,label:t,onCommit:i,id:s}){const[r,o]=vo(null),a=e==="plain"?n.toFixed(4):Ws(n,e,_t.value),l=()=>{r!==null&&r.trim()!==""&&r!==a&&i(e==="plain"?r.trim():l_(r,e,_t.value)),o(null)};return v("span",{class:"number",children:[v("input",{id:s,type:"text",inputMode:"text",spellcheck:!1,autocomplete:"off","aria-label":t,value:r??a,onFocus:c=>{o(a),c.currentTarget.select()},onInput:c=>o(c.currentTarget.value),onBlur:l,onKeyDown:c=>{c.key==="Enter"&&(l(),c.currentTarget.blur()),c.key==="Escape"&&(o(null),c.currentTarget.blur()),c.stopPropagation()}}),e!=="plain"&&v("span",{class:"unit","aria-hidden":"true",children:jl(e,_t.value)})]})}const Go=Xe("rpy"),Wo=Xe("base");async function Xo(n){const e=await Ge({do:"tool",...n});e&&!e.reached&&gn(e.sentence)}function uo({label:n,value:e,options:t,onChange:i}){return v("div",{class:"segments",role:"radiogroup","aria-label":n,children:t.map(([s,r])=>v("button",{type:"button",role:"radio","aria-checked":s===e,onClick:()=>i(s),children:r},s))})}function Y0(){const n=ns.value;if(!n)return null;const{tool:e,methods:t}=n,i=Wo.value==="tool",s=i?[0,0,0]:e.position,r=i?[0,0,0]:e.rpy,o=(l,c,u)=>l.map((h,f)=>f===c?u:h),a=n.method==="matrix"?t?.matrix:t?.quaternion;return v("section",{"aria-label":"Tool pose",children:[v("div",{class:"row spread",children:[v("span",{class:"quiet",children:"Frame"}),v(uo,{label:"Frame",value:Wo.value,options:[["base","Base"],["tool","Tool"]],onChange:l=>{Wo.value=l,ot.local.value=l==="tool"}})]}),v("div",{class:"triple",children:["X","Y","Z"].map((l,c)=>v("label",{children:[v("span",{children:[v("span",{class:`axis axis-${l.toLowerCase()}`,children:l})," ",v("span",{class:"quiet",children:jl("length",_t.value)})]}),v(dr,{value:s[c],kind:"length",label:`Tool ${l}`,onCommit:u=>{Xo({position:o(s,c,u),frame:Wo.value})}})]},l))}),v("div",{class:"row spread",children:[v("span",{class:"quiet",children:"Orientation"}),v(uo,{label:"Orientation as",value:Go.value,options:[["rpy","RPY"],["quaternion","Quaternion"],["axis","Axis"]],onChange:l=>Go.value=l})]}),Go.value==="rpy"&&v("div",{class:"triple",children:["Roll","Pitch","Yaw"].map((l,c)=>v("label",{children:[v("span",{children:[v("span",{class:"axis",children:l})," ",v("span",{class:"quiet",children:jl("angle",_t.value)})]}),v(dr,{value:r[c],kind:"angle",label:l,onCommit:u=>{Xo({rpy:o(r,c,u),frame:Wo.value})}})]},l))}),Go.value==="quaternion"&&v("div",{class:"triple four",children:["w","x","y","z"].map((l,c)=>v("label",{children:[v("span",{class:"axis",children:l}),v(dr,{value:e.quaternion[c],kind:"plain",label:`Quaternion ${l}`,onCommit:u=>{Xo({quaternion:e.quaternion.map((h,f)=>f===c?Number(u):h)})}})]},l))}),Go.value==="axis"&&v("div",{class:"triple four",children:[["x","y","z"].map((l,c)=>v("label",{children:[v("span",{class:"axis",children:l}),v(dr,{value:e.axis[c],kind:"plain",label:`Axis ${l}`,onCommit:u=>{Xo({axis_angle:[...o(e.axis,c,u),e.angle]})}})]},l)),v("label",{children:[v("span",{class:"axis",children:"angle"}),v(dr,{value:e.angle,kind:"angle",label:"Angle",onCommit:l=>{Xo({axis_angle:[...e.axis,l]})}})]})]}),gs.value?.missed&&v("p",{class:"banner",children:[v(Ei,{name:"warn"})," Not reached: ",gs.value.reason??"every solution lies outside the limits",". The arm stands at the nearest pose."]}),v("div",{class:"row spread",children:[v("span",{class:"quiet",children:"Computed by"}),v(uo,{label:"Computed by",value:n.method,options:[["matrix","Matrices"],["quaternion","Quaternions"]],onChange:l=>{Ge({do:"method",to:l})}})]}),a&&v("table",{class:"matrix","aria-label":"Tool pose as a matrix",children:v("tbody",{children:a.map((l,c)=>v("tr",{children:l.map((u,h)=>v("td",{children:u.toFixed(5)},h))},c))})}),t&&v("p",{class:"quiet small",children:["The two ways differ by ",c_(t.difference)," at most."]}),n.measures&&v("dl",{class:"facts",children:[v("dt",{children:"Manipulability"}),v("dd",{children:n.measures.manipulability.toPrecision(3)}),v("dt",{children:"Smallest singular value"}),v("dd",{children:[n.measures.smallest_singular_value.toPrecision(3),n.measures.smallest_singular_value<.001&&" – singular"]}),v("dt",{children:"Condition"}),v("dd",{children:n.measures.condition===null?"∞":n.measures.condition.toPrecision(3)})]})]})}const Bc=Xe("forward");function q0(){const n=ui(null),[e,t]=vo("");return br(()=>{const i=a=>{const l=n.current?.querySelectorAll("output.value");a.forEach((c,u)=>{const h=l?.[u];h&&(h.textContent=c===null?"":`= ${Number(c.toFixed(5))}`)})},s=new wr(a=>bi.send(a),i,()=>{});let r="";return Jt(()=>{const[a,l]=[Bc.value,rn.value?.revision];ns.value;const c=`${a} ${l}`;if(c===r)return s.push({do:"formula_values",scope:a});r=c,bi.send({do:"formulas",scope:a}).then(u=>{n.current&&(n.current.innerHTML=u.html),t(""),s.push({do:"formula_values",scope:a})},u=>{n.current&&(n.current.textContent=""),t(u.message)})})},[]),v("div",{class:"formulas",children:[v(uo,{label:"Which way",value:Bc.value,onChange:i=>Bc.value=i,options:[["forward","Forward"],["inverse","Inverse"]]}),e&&v("p",{class:"quiet",children:e}),v("div",{class:"sheet-body",ref:n,tabIndex:0,role:"region","aria-label":"Formulas of the arm"})]})}const $0=!0,yn="u-",j0="uplot",K0=yn+"hz",Z0=yn+"vt",J0=yn+"title",Q0=yn+"wrap",ev=yn+"under",tv=yn+"over",nv=yn+"axis",pr=yn+"off",iv=yn+"select",sv=yn+"cursor-x",rv=yn+"cursor-y",ov=yn+"cursor-pt",av=yn+"legend",lv=yn+"live",cv=yn+"inline",uv=yn+"series",hv=yn+"marker",Md=yn+"label",fv=yn+"value",ca="width",ua="height",Yo="top",Sd="bottom",Gr="left",zc="right",sf="#000",Ed=sf+"0",Hc="mousemove",bd="mousedown",Vc="mouseup",wd="mouseenter",Td="mouseleave",Ad="dblclick",dv="resize",pv="scroll",Rd="change",Zl="dppxchange",rf="--",Io=typeof window<"u",Vu=Io?document:null,ho=Io?window:null,mv=Io?navigator:null;let wt,Xa;function Gu(){let n=devicePixelRatio;wt!=n&&(wt=n,Xa&&Xu(Rd,Xa,Gu),Xa=matchMedia(`(min-resolution: ${wt-.001}dppx) and (max-resolution: ${wt+.001}dppx)`),Er(Rd,Xa,Gu),ho.dispatchEvent(new CustomEvent(Zl)))}function ai(n,e){if(e!=null){let t=n.classList;!t.contains(e)&&t.add(e)}}function Wu(n,e){let t=n.classList;t.contains(e)&&t.remove(e)}function qt(n,e,t){n.style[e]=t+"px"}function Li(n,e,t,i){let s=Vu.createElement(n);return e!=null&&ai(s,e),t?.insertBefore(s,i),s}function _i(n,e){return Li("div",n,e)}const Cd=new WeakMap;function Xi(n,e,t,i,s){let r="translate("+e+"px,"+t+"px)",o=Cd.get(n);r!=o&&(n.style.transform=r,Cd.set(n,r),e<0||t<0||e>i||t>s?ai(n,pr):Wu(n,pr))}const Pd=new WeakMap;function Dd(n,e,t){let i=e+t,s=Pd.get(n);i!=s&&(Pd.set(n,i),n.style.background=e,n.style.borderColor=t)}const Ld=new WeakMap;function Id(n,e,t,i){let s=e+""+t,r=Ld.get(n);s!=r&&(Ld.set(n,s),n.style.height=t+"px",n.style.width=e+"px",n.style.marginLeft=i?-e/2+"px":0,n.style.marginTop=i?-t/2+"px":0)}const of={passive:!0},_v={...of,capture:!0};function Er(n,e,t,i){e.addEventListener(n,t,i?_v:of)}function Xu(n,e,t,i){e.removeEventListener(n,t,of)}Io&&Gu();function Ii(n,e,t,i){let s;t=t||0,i=i||e.length-1;let r=i<=2147483647;for(;i-t>1;)s=r?t+i>>1:ci((t+i)/2),e[s]<n?t=s:i=s;return n-e[t]<=e[i]-n?t:i}function h_(n){return(t,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(t[a])){r=a;break}for(let a=s;a>=i;a--)if(n(t[a])){o=a;break}return[r,o]}}const f_=n=>n!=null,d_=n=>n!=null&&n>0,fc=h_(f_),gv=h_(d_);function vv(n,e,t,i=0,s=!1){let r=s?gv:fc,o=s?d_:f_;[e,t]=r(n,e,t);let a=n[e],l=n[e];if(e>-1)if(i==1)a=n[e],l=n[t];else if(i==-1)a=n[t],l=n[e];else for(let c=e;c<=t;c++){let u=n[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??Ot,l??-Ot]}function dc(n,e,t,i){let s=Fd(n),r=Fd(e);n==e&&(s==-1?(n*=t,e/=t):(n/=t,e*=t));let o=t==10?ds:p_,a=s==1?ci:xi,l=r==1?xi:ci,c=a(o(mn(n))),u=l(o(mn(e))),h=Mo(t,c),f=Mo(t,u);return t==10&&(c<0&&(h=kt(h,-c)),u<0&&(f=kt(f,-u))),i||t==2?(n=h*s,e=f*r):(n=v_(n,h),e=pc(e,f)),[n,e]}function af(n,e,t,i){let s=dc(n,e,t,i);return n==0&&(s[0]=0),e==0&&(s[1]=0),s}const lf=.1,Ud={mode:3,pad:lf},Ma={pad:0,soft:null,mode:0},xv={min:Ma,max:Ma};function Jl(n,e,t,i){return mc(t)?Nd(n,e,t):(Ma.pad=t,Ma.soft=i?0:null,Ma.mode=i?3:0,Nd(n,e,xv))}function St(n,e){return n??e}function yv(n,e,t){for(e=St(e,0),t=St(t,n.length-1);e<=t;){if(n[e]!=null)return!0;e++}return!1}function Nd(n,e,t){let i=t.min,s=t.max,r=St(i.pad,0),o=St(s.pad,0),a=St(i.hard,-Ot),l=St(s.hard,Ot),c=St(i.soft,Ot),u=St(s.soft,-Ot),h=St(i.mode,0),f=St(s.mode,0),d=e-n,_=ds(d),x=Yn(mn(n),mn(e)),m=ds(x),p=mn(m-_);(d<1e-24||p>10)&&(d=0,(n==0||e==0)&&(d=1e-24,h==2&&c!=Ot&&(r=0),f==2&&u!=-Ot&&(o=0)));let S=d||x||1e3,w=ds(S),y=Mo(10,ci(w)),L=S*(d==0?n==0?.1:1:r),R=kt(v_(n-L,y/10),24),U=n>=c&&(h==1||h==3&&R<=c||h==2&&R>=c)?c:Ot,N=Yn(a,R<U&&n>=U?U:Ni(U,R)),T=S*(d==0?e==0?.1:1:o),b=kt(pc(e+T,y/10),24),C=e<=u&&(f==1||f==3&&b>=u||f==2&&b<=u)?u:-Ot,B=Ni(l,b>C&&e<=C?C:Yn(C,b));return N==B&&N==0&&(B=100),[N,B]}const Mv=new Intl.NumberFormat(Io?mv.language:"en-US"),cf=n=>Mv.format(n),hi=Math,Pl=hi.PI,mn=hi.abs,ci=hi.floor,pn=hi.round,xi=hi.ceil,Ni=hi.min,Yn=hi.max,Mo=hi.pow,Fd=hi.sign,ds=hi.log10,p_=hi.log2,Sv=(n,e=1)=>hi.sinh(n)*e,Gc=(n,e=1)=>hi.asinh(n/e),Ot=1/0;function Od(n){return(ds((n^n>>31)-(n>>31))|0)+1}function Yu(n,e,t){return Ni(Yn(n,e),t)}function m_(n){return typeof n=="function"}function pt(n){return m_(n)?n:()=>n}const Ev=()=>{},__=n=>n,g_=(n,e)=>e,bv=n=>null,kd=n=>!0,Bd=(n,e)=>n==e,wv=/\.\d*?(?=9{6,}|0{6,})/gm,Ar=n=>{if(y_(n)||Xs.has(n))return n;const e=`${n}`,t=e.match(wv);if(t==null)return n;let i=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${Ar(s)}e${r}`}return kt(n,i)};function lr(n,e){return Ar(kt(Ar(n/e))*e)}function pc(n,e){return Ar(xi(Ar(n/e))*e)}function v_(n,e){return Ar(ci(Ar(n/e))*e)}function kt(n,e=0){if(y_(n))return n;let t=10**e,i=n*t*(1+Number.EPSILON);return pn(i)/t}const Xs=new Map;function x_(n){return((""+n).split(".")[1]||"").length}function wa(n,e,t,i){let s=[],r=i.map(x_);for(let o=e;o<t;o++){let a=mn(o),l=kt(Mo(n,o),a);for(let c=0;c<i.length;c++){let u=n==10?+`${i[c]}e${o}`:i[c]*l,h=(o>=0?0:a)+(o>=r[c]?0:r[c]),f=n==10?u:kt(u,h);s.push(f),Xs.set(f,h)}}return s}const Sa={},uf=[],So=[null,null],Os=Array.isArray,y_=Number.isInteger,Tv=n=>n===void 0;function zd(n){return typeof n=="string"}function mc(n){let e=!1;if(n!=null){let t=n.constructor;e=t==null||t==Object}return e}function Av(n){return n!=null&&typeof n=="object"}const Rv=Object.getPrototypeOf(Uint8Array),M_="__proto__";function Eo(n,e=mc){let t;if(Os(n)){let i=n.find(s=>s!=null);if(Os(i)||e(i)){t=Array(n.length);for(let s=0;s<n.length;s++)t[s]=Eo(n[s],e)}else t=n.slice()}else if(n instanceof Rv)t=n.slice();else if(e(n)){t={};for(let i in n)i!=M_&&(t[i]=Eo(n[i],e))}else t=n;return t}function un(n){let e=arguments;for(let t=1;t<e.length;t++){let i=e[t];for(let s in i)s!=M_&&(mc(n[s])?un(n[s],Eo(i[s])):n[s]=Eo(i[s]))}return n}const Cv=0,Pv=1,Dv=2;function Lv(n,e,t){for(let i=0,s,r=-1;i<e.length;i++){let o=e[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<t&&n[s]==null;)n[r=s++]=null}}}function Iv(n,e){if(Fv(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return Ov(o[0])||(o=Nv(o)),o}let t=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let u=0;u<c;u++)t.add(l[u])}let i=[Array.from(t).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],h=Array(s).fill(void 0),f=e?e[o][c]:Pv,d=[];for(let _=0;_<u.length;_++){let x=u[_],m=r.get(l[_]);x===null?f!=Cv&&(h[m]=x,f==Dv&&d.push(m)):h[m]=x}Lv(h,d,s),i.push(h)}}return i}const Uv=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function Nv(n){let e=n[0],t=e.length,i=Array(t);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>e[r]-e[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(t);for(let l=0;l<t;l++)a[l]=o[i[l]];s.push(a)}return s}function Fv(n){let e=n[0][0],t=e.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function Ov(n,e=100){const t=n.length;if(t<=1)return!0;let i=0,s=t-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;const r=Yn(1,ci((s-i+1)/e));for(let o=n[i],a=i+r;a<=s;a+=r){const l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}const S_=["January","February","March","April","May","June","July","August","September","October","November","December"],E_=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function b_(n){return n.slice(0,3)}const kv=E_.map(b_),Bv=S_.map(b_),zv={MMMM:S_,MMM:Bv,WWWW:E_,WWW:kv};function qo(n){return(n<10?"0":"")+n}function Hv(n){return(n<10?"00":n<100?"0":"")+n}const Vv={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,e)=>e.MMMM[n.getMonth()],MMM:(n,e)=>e.MMM[n.getMonth()],MM:n=>qo(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>qo(n.getDate()),D:n=>n.getDate(),WWWW:(n,e)=>e.WWWW[n.getDay()],WWW:(n,e)=>e.WWW[n.getDay()],HH:n=>qo(n.getHours()),H:n=>n.getHours(),h:n=>{let e=n.getHours();return e==0?12:e>12?e-12:e},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>qo(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>qo(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>Hv(n.getMilliseconds())};function hf(n,e){e=e||zv;let t=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)t.push(s[0][0]=="{"?Vv[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](r,e);return o}}const Gv=new Intl.DateTimeFormat().resolvedOptions().timeZone;function Wv(n,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+n+n.getTimezoneOffset()*6e4):e==Gv?t=n:(t=new Date(n.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(n.getMilliseconds())),t}const w_=n=>n%1==0,Ql=[1,2,2.5,5],Xv=wa(10,-32,0,Ql),T_=wa(10,0,32,Ql),Yv=T_.filter(w_),cr=Xv.concat(T_),ff=`
`,A_="{YYYY}",Hd=ff+A_,R_="{M}/{D}",ha=ff+R_,Ya=ha+"/{YY}",C_="{aa}",qv="{h}:{mm}",ro=qv+C_,Vd=ff+ro,Gd=":{ss}",Tt=null;function P_(n){let e=n*1e3,t=e*60,i=t*60,s=i*24,r=s*30,o=s*365,l=(n==1?wa(10,0,3,Ql).filter(w_):wa(10,-3,0,Ql)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]);const c=[[o,A_,Tt,Tt,Tt,Tt,Tt,Tt,1],[s*28,"{MMM}",Hd,Tt,Tt,Tt,Tt,Tt,1],[s,R_,Hd,Tt,Tt,Tt,Tt,Tt,1],[i,"{h}"+C_,Ya,Tt,ha,Tt,Tt,Tt,1],[t,ro,Ya,Tt,ha,Tt,Tt,Tt,1],[e,Gd,Ya+" "+ro,Tt,ha+" "+ro,Tt,Vd,Tt,1],[n,Gd+".{fff}",Ya+" "+ro,Tt,ha+" "+ro,Tt,Vd,Tt,1]];function u(h){return(f,d,_,x,m,p)=>{let S=[],w=m>=o,y=m>=r&&m<o,L=h(_),R=kt(L*n,3),U=Wc(L.getFullYear(),w?0:L.getMonth(),y||w?1:L.getDate()),N=kt(U*n,3);if(y||w){let T=y?m/r:0,b=w?m/o:0,C=R==N?R:kt(Wc(U.getFullYear()+b,U.getMonth()+T,1)*n,3),B=new Date(pn(C/n)),z=B.getFullYear(),X=B.getMonth();for(let W=0;C<=x;W++){let q=Wc(z+b*W,X+T*W,1),j=q-h(kt(q*n,3));C=kt((+q+j)*n,3),C<=x&&S.push(C)}}else{let T=m>=s?s:m,b=ci(_)-ci(R),C=N+b+pc(R-N,T);S.push(C);let B=h(C),z=B.getHours()+B.getMinutes()/t+B.getSeconds()/i,X=m/i,W=f.axes[d]._space,q=p/W;for(;C=kt(C+m,n==1?0:3),!(C>x);)if(X>1){let j=ci(kt(z+X,6))%24,ae=h(C).getHours()-j;ae>1&&(ae=-1),C-=ae*i,z=(z+X)%24;let me=S[S.length-1];kt((C-me)/m,3)*q>=.7&&S.push(C)}else S.push(C)}return S}}return[l,c,u]}const[$v,jv,Kv]=P_(1),[Zv,Jv,Qv]=P_(.001);wa(2,-53,53,[1]);function Wd(n,e){return n.map(t=>t.map((i,s)=>s==0||s==8||i==null?i:e(s==1||t[8]==0?i:t[1]+i)))}function Xd(n,e){return(t,i,s,r,o)=>{let a=e.find(_=>o>=_[0])||e[e.length-1],l,c,u,h,f,d;return i.map(_=>{let x=n(_),m=x.getFullYear(),p=x.getMonth(),S=x.getDate(),w=x.getHours(),y=x.getMinutes(),L=x.getSeconds(),R=m!=l&&a[2]||p!=c&&a[3]||S!=u&&a[4]||w!=h&&a[5]||y!=f&&a[6]||L!=d&&a[7]||a[1];return l=m,c=p,u=S,h=w,f=y,d=L,R(x)})}}function ex(n,e){let t=hf(e);return(i,s,r,o,a)=>s.map(l=>t(n(l)))}function Wc(n,e,t){return new Date(n,e,t)}function Yd(n,e){return e(n)}const tx="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function qd(n,e){return(t,i,s,r)=>r==null?rf:e(n(i))}function nx(n,e){let t=n.series[e];return t.width?t.stroke(n,e):t.points.width?t.points.stroke(n,e):null}function ix(n,e){return n.series[e].fill(n,e)}const sx={show:!0,live:!0,isolate:!1,mount:Ev,markers:{show:!0,width:2,stroke:nx,fill:ix,dash:"solid"},idx:null,idxs:null,values:[]};function rx(n,e){let t=n.cursor.points,i=_i(),s=t.size(n,e);qt(i,ca,s),qt(i,ua,s);let r=s/-2;qt(i,"marginLeft",r),qt(i,"marginTop",r);let o=t.width(n,e,s);return o&&qt(i,"borderWidth",o),i}function ox(n,e){let t=n.series[e].points;return t._fill||t._stroke}function ax(n,e){let t=n.series[e].points;return t._stroke||t._fill}function lx(n,e){return n.series[e].points.size}const Xc=[0,0];function cx(n,e,t){return Xc[0]=e,Xc[1]=t,Xc}function qa(n,e,t,i=!0){return s=>{s.button==0&&(!i||s.target==e)&&t(s)}}function Yc(n,e,t,i=!0){return s=>{(!i||s.target==e)&&t(s)}}const ux={show:!0,x:!0,y:!0,lock:!1,move:cx,points:{one:!1,show:rx,size:lx,width:0,stroke:ax,fill:ox},bind:{mousedown:qa,mouseup:qa,click:qa,dblclick:qa,mousemove:Yc,mouseleave:Yc,mouseenter:Yc},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,e,t,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},D_={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},df=un({},D_,{filter:g_}),L_=un({},df,{size:10}),I_=un({},D_,{show:!1}),pf='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',U_="bold "+pf,N_=1.5,$d={show:!0,scale:"x",stroke:sf,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:U_,side:2,grid:df,ticks:L_,border:I_,font:pf,lineGap:N_,rotate:0},hx="Value",fx="Time",jd={show:!0,scale:"x",auto:!1,sorted:1,min:Ot,max:-Ot,idxs:[]};function dx(n,e,t,i,s){return e.map(r=>r==null?"":cf(r))}function px(n,e,t,i,s,r,o){let a=[],l=Xs.get(s)||0;t=o?t:kt(pc(t,s),l);for(let c=t;c<=i;c=kt(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function qu(n,e,t,i,s,r,o){const a=[],l=n.scales[n.axes[e].scale].log,c=l==10?ds:p_,u=ci(c(t));s=Mo(l,u),l==10&&(s=cr[Ii(s,cr)]);let h=t,f=s*l;l==10&&(f=cr[Ii(f,cr)]);do a.push(h),h=h+s,l==10&&!Xs.has(h)&&(h=kt(h,Xs.get(s))),h>=f&&(s=h,f=s*l,l==10&&(f=cr[Ii(f,cr)]));while(h<=i);return a}function mx(n,e,t,i,s,r,o){let l=n.scales[n.axes[e].scale].asinh,c=i>l?qu(n,e,Yn(l,t),i,s):[l],u=i>=0&&t<=0?[0]:[];return(t<-l?qu(n,e,Yn(l,-i),-t,s):[l]).reverse().map(f=>-f).concat(u,c)}const F_=/./,_x=/[12357]/,gx=/[125]/,Kd=/1/,$u=(n,e,t,i)=>n.map((s,r)=>e==4&&s==0||r%i==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function vx(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=n.scales[o],l=n.valToPos,c=r._space,u=l(10,o),h=l(9,o)-u>=c?F_:l(7,o)-u>=c?_x:l(5,o)-u>=c?gx:Kd;if(h==Kd){let f=mn(l(1,o)-u);if(f<c)return $u(e.slice().reverse(),a.distr,h,xi(c/f)).reverse()}return $u(e,a.distr,h,1)}function xx(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=r._space,l=n.valToPos,c=mn(l(1,o)-l(2,o));return c<a?$u(e.slice().reverse(),3,F_,xi(a/c)).reverse():e}function yx(n,e,t,i){return i==null?rf:e==null?"":cf(e)}const Zd={show:!0,scale:"y",stroke:sf,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:U_,side:3,grid:df,ticks:L_,border:I_,font:pf,lineGap:N_,rotate:0};function Mx(n,e){let t=3+(n||1)*2;return kt(t*e,3)}function Sx(n,e){let{scale:t,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],t,!0),o=n.valToPos(s[i[1]],t,!0),a=mn(o-r),l=n.series[e],c=a/(l.points.space*wt);return i[1]-i[0]<=c}const Jd={scale:null,auto:!0,sorted:0,min:Ot,max:-Ot},O_=(n,e,t,i,s)=>s,Qd={show:!0,auto:!0,sorted:0,gaps:O_,alpha:1,facets:[un({},Jd,{scale:"x"}),un({},Jd,{scale:"y"})]},ep={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:O_,alpha:1,points:{show:Sx,filter:null},values:null,min:Ot,max:-Ot,idxs:[],path:null,clip:null};function Ex(n,e,t,i,s){return t/10}const k_={time:$0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},bx=un({},k_,{time:!1,ori:1}),tp={};function B_(n,e){let t=tp[n];return t||(t={key:n,plots:[],sub(i){t.plots.push(i)},unsub(i){t.plots=t.plots.filter(s=>s!=i)},pub(i,s,r,o,a,l,c){for(let u=0;u<t.plots.length;u++)t.plots[u]!=s&&t.plots[u].pub(i,s,r,o,a,l,c)}},n!=null&&(tp[n]=t)),t}const bo=1,ju=2;function Pr(n,e,t){const i=n.mode,s=n.series[e],r=i==2?n._data[e]:n._data,o=n.scales,a=n.bbox;let l=r[0],c=i==2?r[1]:r[e],u=i==2?o[s.facets[0].scale]:o[n.series[0].scale],h=i==2?o[s.facets[1].scale]:o[s.scale],f=a.left,d=a.top,_=a.width,x=a.height,m=n.valToPosH,p=n.valToPosV;return u.ori==0?t(s,l,c,u,h,m,p,f,d,_,x,gc,Uo,xc,H_,G_):t(s,l,c,u,h,p,m,d,f,x,_,vc,No,gf,V_,W_)}function mf(n,e){let t=0,i=0,s=St(n.bands,uf);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?i|=1:i|=2)}return[t,i==1?-1:i==2?1:i==3?2:0]}function wx(n,e,t,i,s){let r=n.mode,o=n.series[e],a=r==2?o.facets[1].scale:o.scale,l=n.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function ps(n,e,t,i,s,r){return Pr(n,e,(o,a,l,c,u,h,f,d,_,x,m)=>{let p=o.pxRound;const S=c.dir*(c.ori==0?1:-1),w=c.ori==0?Uo:No;let y,L;S==1?(y=t,L=i):(y=i,L=t);let R=p(h(a[y],c,x,d)),U=p(f(l[y],u,m,_)),N=p(h(a[L],c,x,d)),T=p(f(r==1?u.max:u.min,u,m,_)),b=new Path2D(s);return w(b,N,T),w(b,R,T),w(b,R,U),b})}function _c(n,e,t,i,s,r){let o=null;if(n.length>0){o=new Path2D;const a=e==0?xc:gf;let l=t;for(let h=0;h<n.length;h++){let f=n[h];if(f[1]>f[0]){let d=f[0]-l;d>0&&a(o,l,i,d,i+r),l=f[1]}}let c=t+s-l,u=10;c>0&&a(o,l,i-u/2,c,i+r+u)}return o}function Tx(n,e,t){let i=n[n.length-1];i&&i[0]==e?i[1]=t:n.push([e,t])}function _f(n,e,t,i,s,r,o){let a=[],l=n.length;for(let c=s==1?t:i;c>=t&&c<=i;c+=s)if(e[c]===null){let h=c,f=c;if(s==1)for(;++c<=i&&e[c]===null;)f=c;else for(;--c>=t&&e[c]===null;)f=c;let d=r(n[h]),_=f==h?d:r(n[f]),x=h-s;d=o<=0&&x>=0&&x<l?r(n[x]):d;let p=f+s;_=o>=0&&p>=0&&p<l?r(n[p]):_,_>=d&&a.push([d,_])}return a}function np(n){return n==0?__:n==1?pn:e=>lr(e,n)}function z_(n){let e=n==0?gc:vc,t=n==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},i=n==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,u=0)=>{c==0&&u==0?i(s,r,o,a,l):(c=Ni(c,a/2,l/2),u=Ni(u,a/2,l/2),e(s,r+c,o),t(s,r+a,o,r+a,o+l,c),t(s,r+a,o+l,r,o+l,u),t(s,r,o+l,r,o,u),t(s,r,o,r+a,o,c),s.closePath())}}const gc=(n,e,t)=>{n.moveTo(e,t)},vc=(n,e,t)=>{n.moveTo(t,e)},Uo=(n,e,t)=>{n.lineTo(e,t)},No=(n,e,t)=>{n.lineTo(t,e)},xc=z_(0),gf=z_(1),H_=(n,e,t,i,s,r)=>{n.arc(e,t,i,s,r)},V_=(n,e,t,i,s,r)=>{n.arc(t,e,i,s,r)},G_=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(e,t,i,s,r,o)},W_=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(t,e,s,i,o,r)};function X_(n){return(e,t,i,s,r)=>Pr(e,t,(o,a,l,c,u,h,f,d,_,x,m)=>{let{pxRound:p,points:S}=o,w,y;c.ori==0?(w=gc,y=H_):(w=vc,y=V_);const L=kt(S.width*wt,3);let R=(S.size-S.width)/2*wt,U=kt(R*2,3),N=new Path2D,T=new Path2D,{left:b,top:C,width:B,height:z}=e.bbox;xc(T,b-U,C-U,B+U*2,z+U*2);const X=W=>{if(l[W]!=null){let q=p(h(a[W],c,x,d)),j=p(f(l[W],u,m,_));w(N,q+R,j),y(N,q,j,R,0,Pl*2)}};if(r)r.forEach(X);else for(let W=i;W<=s;W++)X(W);return{stroke:L>0?N:null,fill:N,clip:T,flags:bo|ju}})}function Y_(n){return(e,t,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(e,t,i),r!=s&&o!=s&&n(e,t,s),n(e,t,o))}}const Ax=Y_(Uo),Rx=Y_(No);function q_(n){const e=St(n?.alignGaps,0);return(t,i,s,r)=>Pr(t,i,(o,a,l,c,u,h,f,d,_,x,m)=>{[s,r]=fc(l,s,r);let p=o.pxRound,S=z=>p(h(z,c,x,d)),w=z=>p(f(z,u,m,_)),y,L;c.ori==0?(y=Uo,L=Ax):(y=No,L=Rx);const R=c.dir*(c.ori==0?1:-1),U={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:bo},N=U.stroke;let T=!1;if(r-s>=x*4){let z=ge=>t.posToVal(ge,c.key,!0),X=null,W=null,q,j,Z,re=S(a[R==1?s:r]),ae=S(a[s]),me=S(a[r]),xe=z(R==1?ae+1:me-1);for(let ge=R==1?s:r;ge>=s&&ge<=r;ge+=R){let tt=a[ge],ee=(R==1?tt<xe:tt>xe)?re:S(tt),ne=l[ge];ee==re?ne!=null?(j=ne,X==null?(y(N,ee,w(j)),q=X=W=j):j<X?X=j:j>W&&(W=j)):ne===null&&(T=!0):(X!=null&&L(N,re,w(X),w(W),w(q),w(j)),ne!=null?(j=ne,y(N,ee,w(j)),X=W=q=j):(X=W=null,ne===null&&(T=!0)),re=ee,xe=z(re+R))}X!=null&&X!=W&&Z!=re&&L(N,re,w(X),w(W),w(q),w(j))}else for(let z=R==1?s:r;z>=s&&z<=r;z+=R){let X=l[z];X===null?T=!0:X!=null&&y(N,S(a[z]),w(X))}let[C,B]=mf(t,i);if(o.fill!=null||C!=0){let z=U.fill=new Path2D(N),X=o.fillTo(t,i,o.min,o.max,C),W=w(X),q=S(a[s]),j=S(a[r]);R==-1&&([j,q]=[q,j]),y(z,j,W),y(z,q,W)}if(!o.spanGaps){let z=[];T&&z.push(..._f(a,l,s,r,R,S,e)),U.gaps=z=o.gaps(t,i,s,r,z),U.clip=_c(z,c.ori,d,_,x,m)}return B!=0&&(U.band=B==2?[ps(t,i,s,r,N,-1),ps(t,i,s,r,N,1)]:ps(t,i,s,r,N,B)),U})}function Cx(n){const e=St(n.align,1),t=St(n.ascDesc,!1),i=St(n.alignGaps,0),s=St(n.extend,!1);return(r,o,a,l)=>Pr(r,o,(c,u,h,f,d,_,x,m,p,S,w)=>{[a,l]=fc(h,a,l);let y=c.pxRound,{left:L,width:R}=r.bbox,U=ae=>y(_(ae,f,S,m)),N=ae=>y(x(ae,d,w,p)),T=f.ori==0?Uo:No;const b={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:bo},C=b.stroke,B=f.dir*(f.ori==0?1:-1);let z=N(h[B==1?a:l]),X=U(u[B==1?a:l]),W=X,q=X;s&&e==-1&&(q=L,T(C,q,z)),T(C,X,z);for(let ae=B==1?a:l;ae>=a&&ae<=l;ae+=B){let me=h[ae];if(me==null)continue;let xe=U(u[ae]),ge=N(me);e==1?T(C,xe,z):T(C,W,ge),T(C,xe,ge),z=ge,W=xe}let j=W;s&&e==1&&(j=L+R,T(C,j,z));let[Z,re]=mf(r,o);if(c.fill!=null||Z!=0){let ae=b.fill=new Path2D(C),me=c.fillTo(r,o,c.min,c.max,Z),xe=N(me);T(ae,j,xe),T(ae,q,xe)}if(!c.spanGaps){let ae=[];ae.push(..._f(u,h,a,l,B,U,i));let me=c.width*wt/2,xe=t||e==1?me:-me,ge=t||e==-1?-me:me;ae.forEach(tt=>{tt[0]+=xe,tt[1]+=ge}),b.gaps=ae=c.gaps(r,o,a,l,ae),b.clip=_c(ae,f.ori,m,p,S,w)}return re!=0&&(b.band=re==2?[ps(r,o,a,l,C,-1),ps(r,o,a,l,C,1)]:ps(r,o,a,l,C,re)),b})}function ip(n,e,t,i,s,r,o=Ot){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(e[l]!==void 0){if(a!=null){let u=mn(n[l]-n[a]);u<c&&(c=u,o=mn(t(n[l],i,s,r)-t(n[a],i,s,r)))}a=l}}return o}function Px(n){n=n||Sa;const e=St(n.size,[.6,Ot,1]),t=n.align||0,i=n.gap||0;let s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;const r=pt(s),o=1-e[0],a=St(e[1],Ot),l=St(e[2],1),c=St(n.disp,Sa),u=St(n.each,d=>{}),{fill:h,stroke:f}=c;return(d,_,x,m)=>Pr(d,_,(p,S,w,y,L,R,U,N,T,b,C)=>{let B=p.pxRound,z=t,X=i*wt,W=a*wt,q=l*wt,j,Z;y.ori==0?[j,Z]=r(d,_):[Z,j]=r(d,_);const re=y.dir*(y.ori==0?1:-1);let ae=y.ori==0?xc:gf,me=y.ori==0?u:(O,J,ie,te,Fe,he,Le)=>{u(O,J,ie,Fe,te,Le,he)},xe=St(d.bands,uf).find(O=>O.series[0]==_),ge=xe!=null?xe.dir:0,tt=p.fillTo(d,_,p.min,p.max,ge),nt=B(U(tt,L,C,T)),ee,ne,we,ze=b,ye=B(p.width*wt),it=!1,Bt=null,F=null,mt=null,Ze=null;h!=null&&(ye==0||f!=null)&&(it=!0,Bt=h.values(d,_,x,m),F=new Map,new Set(Bt).forEach(O=>{O!=null&&F.set(O,new Path2D)}),ye>0&&(mt=f.values(d,_,x,m),Ze=new Map,new Set(mt).forEach(O=>{O!=null&&Ze.set(O,new Path2D)})));let{x0:Ye,size:Ne}=c;if(Ye!=null&&Ne!=null){z=1,S=Ye.values(d,_,x,m),Ye.unit==2&&(S=S.map(ie=>d.posToVal(N+ie*b,y.key,!0)));let O=Ne.values(d,_,x,m);Ne.unit==2?ne=O[0]*b:ne=R(O[0],y,b,N)-R(0,y,b,N),ze=ip(S,w,R,y,b,N,ze),we=ze-ne+X}else ze=ip(S,w,R,y,b,N,ze),we=ze*o+X,ne=ze-we;we<1&&(we=0),ye>=ne/2&&(ye=0),we<5&&(B=__);let Rt=we>0,Pe=ze-we-(Rt?ye:0);ne=B(Yu(Pe,q,W)),ee=(z==0?ne/2:z==re?0:ne)-z*re*((z==0?X/2:0)+(Rt?ye/2:0));const We={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},Gt=it?null:new Path2D;let Et=null;if(xe!=null)Et=d.data[xe.series[1]];else{let{y0:O,y1:J}=c;O!=null&&J!=null&&(w=J.values(d,_,x,m),Et=O.values(d,_,x,m))}let D=j*ne,M=Z*ne;for(let O=re==1?x:m;O>=x&&O<=m;O+=re){let J=w[O];if(J==null)continue;if(Et!=null){let ve=Et[O]??0;if(J-ve==0)continue;nt=U(ve,L,C,T)}let ie=y.distr!=2||c!=null?S[O]:O,te=R(ie,y,b,N),Fe=U(St(J,tt),L,C,T),he=B(te-ee),Le=B(Yn(Fe,nt)),Re=B(Ni(Fe,nt)),le=Le-Re;if(J!=null){let ve=J<0?M:D,Be=J<0?D:M;it?(ye>0&&mt[O]!=null&&ae(Ze.get(mt[O]),he,Re+ci(ye/2),ne,Yn(0,le-ye),ve,Be),Bt[O]!=null&&ae(F.get(Bt[O]),he,Re+ci(ye/2),ne,Yn(0,le-ye),ve,Be)):ae(Gt,he,Re+ci(ye/2),ne,Yn(0,le-ye),ve,Be),me(d,_,O,he-ye/2,Re,ne+ye,le)}}return ye>0?We.stroke=it?Ze:Gt:it||(We._fill=p.width==0?p._fill:p._stroke??p._fill,We.width=0),We.fill=it?F:Gt,We})}function Dx(n,e){const t=St(e?.alignGaps,0);return(i,s,r,o)=>Pr(i,s,(a,l,c,u,h,f,d,_,x,m,p)=>{[r,o]=fc(c,r,o);let S=a.pxRound,w=j=>S(f(j,u,m,_)),y=j=>S(d(j,h,p,x)),L,R,U;u.ori==0?(L=gc,U=Uo,R=G_):(L=vc,U=No,R=W_);const N=u.dir*(u.ori==0?1:-1);let T=w(l[N==1?r:o]),b=T,C=[],B=[];for(let j=N==1?r:o;j>=r&&j<=o;j+=N)if(c[j]!=null){let re=l[j],ae=w(re);C.push(b=ae),B.push(y(c[j]))}const z={stroke:n(C,B,L,U,R,S),fill:null,clip:null,band:null,gaps:null,flags:bo},X=z.stroke;let[W,q]=mf(i,s);if(a.fill!=null||W!=0){let j=z.fill=new Path2D(X),Z=a.fillTo(i,s,a.min,a.max,W),re=y(Z);U(j,b,re),U(j,T,re)}if(!a.spanGaps){let j=[];j.push(..._f(l,c,r,o,N,w,t)),z.gaps=j=a.gaps(i,s,r,o,j),z.clip=_c(j,u.ori,_,x,m,p)}return q!=0&&(z.band=q==2?[ps(i,s,r,o,X,-1),ps(i,s,r,o,X,1)]:ps(i,s,r,o,X,q)),z})}function Lx(n){return Dx(Ix,n)}function Ix(n,e,t,i,s,r){const o=n.length;if(o<2)return null;const a=new Path2D;if(t(a,n[0],e[0]),o==2)i(a,n[1],e[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),h=Array(o-1);for(let f=0;f<o-1;f++)u[f]=e[f+1]-e[f],h[f]=n[f+1]-n[f],c[f]=u[f]/h[f];l[0]=c[0];for(let f=1;f<o-1;f++)c[f]===0||c[f-1]===0||c[f-1]>0!=c[f]>0?l[f]=0:(l[f]=3*(h[f-1]+h[f])/((2*h[f]+h[f-1])/c[f-1]+(h[f]+2*h[f-1])/c[f]),isFinite(l[f])||(l[f]=0));l[o-1]=c[o-2];for(let f=0;f<o-1;f++)s(a,n[f]+h[f]/3,e[f]+l[f]*h[f]/3,n[f+1]-h[f]/3,e[f+1]-l[f+1]*h[f]/3,n[f+1],e[f+1])}return a}const Ku=new Set;function sp(){for(let n of Ku)n.syncRect(!0)}Io&&(Er(dv,ho,sp),Er(pv,ho,sp,!0),Er(Zl,ho,()=>{kn.pxRatio=wt}));const Ux=q_(),Nx=X_();function rp(n,e,t,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>Zu(r,o,e,t))}function Fx(n,e){return n.map((t,i)=>i==0?{}:un({},e,t))}function Zu(n,e,t,i){return un({},e==0?t:i,n)}function $_(n,e,t){return e==null?So:[e,t]}const Ox=$_;function kx(n,e,t){return e==null?So:Jl(e,t,lf,!0)}function j_(n,e,t,i){return e==null?So:dc(e,t,n.scales[i].log,!1)}const Bx=j_;function K_(n,e,t,i){return e==null?So:af(e,t,n.scales[i].log,!1)}const zx=K_;function Hx(n,e,t,i,s){let r=Yn(Od(n),Od(e)),o=e-n,a=Ii(s/i*o,t);do{let l=t[a],c=i*l/o;if(c>=s&&r+(l<5?Xs.get(l):0)<=17)return[l,c]}while(++a<t.length);return[0,0]}function op(n){let e,t;return n=n.replace(/(\d+)px/,(i,s)=>(e=pn((t=+s)*wt))+"px"),[n,e,t]}function Vx(n){n.show&&[n.font,n.labelFont].forEach(e=>{let t=kt(e[2]*wt,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function kn(n,e,t){const i={mode:St(n.mode,1)},s=i.mode;function r(g,E,P,I){let V=E.valToPct(g);return I+P*(E.dir==-1?1-V:V)}function o(g,E,P,I){let V=E.valToPct(g);return I+P*(E.dir==-1?V:1-V)}function a(g,E,P,I){return E.ori==0?r(g,E,P,I):o(g,E,P,I)}i.valToPosH=r,i.valToPosV=o;let l=!1;i.status=0;const c=i.root=_i(j0);if(n.id!=null&&(c.id=n.id),ai(c,n.class),n.title){let g=_i(J0,c);g.textContent=n.title}const u=Li("canvas"),h=i.ctx=u.getContext("2d"),f=_i(Q0,c);Er("click",f,g=>{g.target===_&&(Wt!=Or||jt!=kr)&&Pn.click(i,g)},!0);const d=i.under=_i(ev,f);f.appendChild(u);const _=i.over=_i(tv,f);n=Eo(n);const x=+St(n.pxAlign,1),m=np(x);(n.plugins||[]).forEach(g=>{g.opts&&(n=g.opts(i,n)||n)});const p=n.ms||.001,S=i.series=s==1?rp(n.series||[],jd,ep,!1):Fx(n.series||[null],Qd),w=i.axes=rp(n.axes||[],$d,Zd,!0),y=i.scales={},L=i.bands=n.bands||[];L.forEach(g=>{g.fill=pt(g.fill||null),g.dir=St(g.dir,-1)});const R=s==2?S[1].facets[0].scale:S[0].scale,U={axes:Gg,series:Zs},N=(n.drawOrder||["axes","series"]).map(g=>U[g]);function T(g){const E=g.distr==3?P=>ds(P>0?P:g.clamp(i,P,g.min,g.max,g.key)):g.distr==4?P=>Gc(P,g.asinh):g.distr==100?P=>g.fwd(P):P=>P;return P=>{let I=E(P),{_min:V,_max:$}=g,se=$-V;return(I-V)/se}}function b(g){let E=y[g];if(E==null){let P=(n.scales||Sa)[g]||Sa;if(P.from!=null){b(P.from);let I=un({},y[P.from],P,{key:g});I.valToPct=T(I),y[g]=I}else{E=y[g]=un({},g==R?k_:bx,P),E.key=g;let I=E.time,V=E.range,$=Os(V);if((g!=R||s==2&&!I)&&($&&(V[0]==null||V[1]==null)&&(V={min:V[0]==null?Ud:{mode:1,hard:V[0],soft:V[0]},max:V[1]==null?Ud:{mode:1,hard:V[1],soft:V[1]}},$=!1),!$&&mc(V))){let se=V;V=(ce,_e,Ae)=>_e==null?So:Jl(_e,Ae,se)}E.range=pt(V||(I?Ox:g==R?E.distr==3?Bx:E.distr==4?zx:$_:E.distr==3?j_:E.distr==4?K_:kx)),E.auto=pt($?!1:E.auto),E.clamp=pt(E.clamp||Ex),E._min=E._max=null,E.valToPct=T(E)}}}b("x"),b("y"),s==1&&S.forEach(g=>{b(g.scale)}),w.forEach(g=>{b(g.scale)});for(let g in n.scales)b(g);const C=y[R],B=C.distr;let z,X;C.ori==0?(ai(c,K0),z=r,X=o):(ai(c,Z0),z=o,X=r);const W={};for(let g in y){let E=y[g];(E.min!=null||E.max!=null)&&(W[g]={min:E.min,max:E.max},E.min=E.max=null)}const q=n.tzDate||(g=>new Date(pn(g/p))),j=n.fmtDate||hf,Z=p==1?Kv(q):Qv(q),re=Xd(q,Wd(p==1?jv:Jv,j)),ae=qd(q,Yd(tx,j)),me=[],xe=i.legend=un({},sx,n.legend),ge=i.cursor=un({},ux,{drag:{y:s==2}},n.cursor),tt=xe.show,nt=ge.show,ee=xe.markers;xe.idxs=me,ee.width=pt(ee.width),ee.dash=pt(ee.dash),ee.stroke=pt(ee.stroke),ee.fill=pt(ee.fill);let ne,we,ze,ye=[],it=[],Bt,F=!1,mt={};if(xe.live){const g=S[1]?S[1].values:null;F=g!=null,Bt=F?g(i,1,0):{_:0};for(let E in Bt)mt[E]=rf}if(tt)if(ne=Li("table",av,c),ze=Li("tbody",null,ne),xe.mount(i,ne),F){we=Li("thead",null,ne,ze);let g=Li("tr",null,we);Li("th",null,g);for(var Ze in Bt)Li("th",Md,g).textContent=Ze}else ai(ne,cv),xe.live&&ai(ne,lv);const Ye={show:!0},Ne={show:!1};function Rt(g,E){if(E==0&&(F||!xe.live||s==2))return So;let P=[],I=Li("tr",uv,ze,ze.childNodes[E]);ai(I,g.class),g.show||ai(I,pr);let V=Li("th",null,I);if(ee.show){let ce=_i(hv,V);if(E>0){let _e=ee.width(i,E);_e&&(ce.style.border=_e+"px "+ee.dash(i,E)+" "+ee.stroke(i,E)),ce.style.background=ee.fill(i,E)}}let $=_i(Md,V);g.label instanceof HTMLElement?$.appendChild(g.label):$.textContent=g.label,E>0&&(ee.show||($.style.color=g.width>0?ee.stroke(i,E):ee.fill(i,E)),We("click",V,ce=>{if(ge._lock)return;Cn(ce);let _e=S.indexOf(g);if((ce.ctrlKey||ce.metaKey)!=xe.isolate){let Ae=S.some((Ce,Ue)=>Ue>0&&Ue!=_e&&Ce.show);S.forEach((Ce,Ue)=>{Ue>0&&Hi(Ue,Ae?Ue==_e?Ye:Ne:Ye,!0,an.setSeries)})}else Hi(_e,{show:!g.show},!0,an.setSeries)},!1),Kn&&We(wd,V,ce=>{ge._lock||(Cn(ce),Hi(S.indexOf(g),zr,!0,an.setSeries))},!1));for(var se in Bt){let ce=Li("td",fv,I);ce.textContent="--",P.push(ce)}return[I,P]}const Pe=new Map;function We(g,E,P,I=!0){const V=Pe.get(E)||{},$=ge.bind[g](i,E,P,I);$&&(Er(g,E,V[g]=$),Pe.set(E,V))}function Gt(g,E,P){const I=Pe.get(E)||{};for(let V in I)(g==null||V==g)&&(Xu(V,E,I[V]),delete I[V]);g==null&&Pe.delete(E)}let Et=0,D=0,M=0,O=0,J=0,ie=0,te=J,Fe=ie,he=M,Le=O,Re=0,le=0,ve=0,Be=0;i.bbox={};let ke=!1,Me=!1,et=!1,H=!1,fe=!1,pe=!1;function De(g,E,P){(P||g!=i.width||E!=i.height)&&ue(g,E),Ir(!1),et=!0,Me=!0,Ur()}function ue(g,E){i.width=Et=M=g,i.height=D=O=E,J=ie=0,Dt(),gt();let P=i.bbox;Re=P.left=lr(J*wt,.5),le=P.top=lr(ie*wt,.5),ve=P.width=lr(M*wt,.5),Be=P.height=lr(O*wt,.5)}const oe=3;function Oe(){let g=!1,E=0;for(;!g;){E++;let P=Hg(E),I=Vg(E);g=E==oe||P&&I,g||(ue(i.width,i.height),Me=!0)}}function st({width:g,height:E}){De(g,E)}i.setSize=st;function Dt(){let g=!1,E=!1,P=!1,I=!1;w.forEach((V,$)=>{if(V.show&&V._show){let{side:se,_size:ce}=V,_e=se%2,Ae=V.label!=null?V.labelSize:0,Ce=ce+Ae;Ce>0&&(_e?(M-=Ce,se==3?(J+=Ce,I=!0):P=!0):(O-=Ce,se==0?(ie+=Ce,g=!0):E=!0))}}),ss[0]=g,ss[1]=P,ss[2]=E,ss[3]=I,M-=zi[1]+zi[3],J+=zi[3],O-=zi[2]+zi[0],ie+=zi[0]}function gt(){let g=J+M,E=ie+O,P=J,I=ie;function V($,se){switch($){case 1:return g+=se,g-se;case 2:return E+=se,E-se;case 3:return P-=se,P+se;case 0:return I-=se,I+se}}w.forEach(($,se)=>{if($.show&&$._show){let ce=$.side;$._pos=V(ce,$._size),$.label!=null&&($._lpos=V(ce,$.labelSize))}})}if(ge.dataIdx==null){let g=ge.hover,E=g.skip=new Set(g.skip??[]);E.add(void 0);let P=g.prox=pt(g.prox),I=g.bias??=0;ge.dataIdx=(V,$,se,ce)=>{if($==0)return se;let _e=se,Ae=P(V,$,se,ce)??Ot,Ce=Ae>=0&&Ae<Ot,Ue=C.ori==0?M:O,rt=ge.left,bt=e[0],xt=e[$];if(E.has(xt[se])){_e=null;let ht=null,Je=null,Ve;if(I==0||I==-1)for(Ve=se;ht==null&&Ve-- >0;)E.has(xt[Ve])||(ht=Ve);if(I==0||I==1)for(Ve=se;Je==null&&Ve++<xt.length;)E.has(xt[Ve])||(Je=Ve);if(ht!=null||Je!=null)if(Ce){let Yt=ht==null?-1/0:z(bt[ht],C,Ue,0),Qt=Je==null?1/0:z(bt[Je],C,Ue,0),Tn=rt-Yt,Lt=Qt-rt;Tn<=Lt?Tn<=Ae&&(_e=ht):Lt<=Ae&&(_e=Je)}else _e=Je==null?ht:ht==null?Je:se-ht<=Je-se?ht:Je}else Ce&&mn(rt-z(bt[se],C,Ue,0))>Ae&&(_e=null);return _e}}const Cn=g=>{ge.event=g};ge.idxs=me,ge._lock=!1;let Nt=ge.points;Nt.show=pt(Nt.show),Nt.size=pt(Nt.size),Nt.stroke=pt(Nt.stroke),Nt.width=pt(Nt.width),Nt.fill=pt(Nt.fill);const ti=i.focus=un({},n.focus||{alpha:.3},ge.focus),Kn=ti.prox>=0,Bi=Kn&&Nt.one;let Bn=[],is=[],Ti=[];function Oo(g,E){let P=Nt.show(i,E);if(P instanceof HTMLElement)return ai(P,ov),ai(P,g.class),Xi(P,-10,-10,M,O),_.insertBefore(P,Bn[E]),P}function js(g,E){if(s==1||E>0){let P=s==1&&y[g.scale].time,I=g.value;g.value=P?zd(I)?qd(q,Yd(I,j)):I||ae:I||yx,g.label=g.label||(P?fx:hx)}if(Bi||E>0){g.width=g.width==null?1:g.width,g.paths=g.paths||Ux||bv,g.fillTo=pt(g.fillTo||wx),g.pxAlign=+St(g.pxAlign,x),g.pxRound=np(g.pxAlign),g.stroke=pt(g.stroke||null),g.fill=pt(g.fill||null),g._stroke=g._fill=g._paths=g._focus=null;let P=Mx(Yn(1,g.width),1),I=g.points=un({},{size:P,width:Yn(1,P*.2),stroke:g.stroke,space:P*2,paths:Nx,_stroke:null,_fill:null},g.points);I.show=pt(I.show),I.filter=pt(I.filter),I.fill=pt(I.fill),I.stroke=pt(I.stroke),I.paths=pt(I.paths),I.pxAlign=g.pxAlign}if(tt){let P=Rt(g,E);ye.splice(E,0,P[0]),it.splice(E,0,P[1]),xe.values.push(null)}if(nt){me.splice(E,0,null);let P=null;Bi?E==0&&(P=Oo(g,E)):E>0&&(P=Oo(g,E)),Bn.splice(E,0,P),is.splice(E,0,0),Ti.splice(E,0,0)}wn("addSeries",E)}function Fa(g,E){E=E??S.length,g=s==1?Zu(g,E,jd,ep):Zu(g,E,{},Qd),S.splice(E,0,g),js(S[E],E)}i.addSeries=Fa;function Oa(g){if(S.splice(g,1),tt){xe.values.splice(g,1),it.splice(g,1);let E=ye.splice(g,1)[0];Gt(null,E.firstChild),E.remove()}nt&&(me.splice(g,1),Bn.splice(g,1)[0].remove(),is.splice(g,1),Ti.splice(g,1)),wn("delSeries",g)}i.delSeries=Oa;const ss=[!1,!1,!1,!1];function Ec(g,E){if(g._show=g.show,g.show){let P=g.side%2,I=y[g.scale];I==null&&(g.scale=P?S[1].scale:R,I=y[g.scale]);let V=I.time;g.size=pt(g.size),g.space=pt(g.space),g.rotate=pt(g.rotate),Os(g.incrs)&&g.incrs.forEach(se=>{!Xs.has(se)&&Xs.set(se,x_(se))}),g.incrs=pt(g.incrs||(I.distr==2?Yv:V?p==1?$v:Zv:cr)),g.splits=pt(g.splits||(V&&I.distr==1?Z:I.distr==3?qu:I.distr==4?mx:px)),g.stroke=pt(g.stroke),g.grid.stroke=pt(g.grid.stroke),g.ticks.stroke=pt(g.ticks.stroke),g.border.stroke=pt(g.border.stroke);let $=g.values;g.values=Os($)&&!Os($[0])?pt($):V?Os($)?Xd(q,Wd($,j)):zd($)?ex(q,$):$||re:$||dx,g.filter=pt(g.filter||(I.distr>=3&&I.log==10?vx:I.distr==3&&I.log==2?xx:g_)),g.font=op(g.font),g.labelFont=op(g.labelFont),g._size=g.size(i,null,E,0),g._space=g._rotate=g._incrs=g._found=g._splits=g._values=null,g._size>0&&(ss[E]=!0,g._el=_i(nv,f))}}function Ks(g,E,P,I){let[V,$,se,ce]=P,_e=E%2,Ae=0;return _e==0&&(ce||$)&&(Ae=E==0&&!V||E==2&&!se?pn($d.size/3):0),_e==1&&(V||se)&&(Ae=E==1&&!$||E==3&&!ce?pn(Zd.size/2):0),Ae}const ka=i.padding=(n.padding||[Ks,Ks,Ks,Ks]).map(g=>pt(St(g,Ks))),zi=i._padding=ka.map((g,E)=>g(i,E,ss,0));let fn,A=null,G=null;const Q=s==1?S[0].idxs:null;let K=null,Y=!1;function de(g,E){if(e=g??[],i.data=i._data=e,s==2){fn=0;for(let P=1;P<S.length;P++)fn+=e[P][0].length}else{e.length==0&&(i.data=i._data=e=[[]]),K=e[0],fn=K.length;let P=e;if(B==2){P=e.slice();let I=P[0]=Array(fn);for(let V=0;V<fn;V++)I[V]=V}i._data=e=P}if(Ir(!0),wn("setData"),B==2&&(et=!0),E!==!1){let P=C;P.auto(i,Y)?Se():ws(R,P.min,P.max),H=H||ge.left>=0,pe=!0,Ur()}}i.setData=de;function Se(){Y=!0;let g,E;s==1&&(fn>0?(A=Q[0]=0,G=Q[1]=fn-1,g=e[0][A],E=e[0][G],B==2?(g=A,E=G):g==E&&(B==3?[g,E]=dc(g,g,C.log,!1):B==4?[g,E]=af(g,g,C.log,!1):C.time?E=g+pn(86400/p):[g,E]=Jl(g,E,lf,!0))):(A=Q[0]=g=null,G=Q[1]=E=null)),ws(R,g,E)}let Ie,Te,$e,je,He,ct,vt,zt,Ct,at;function qe(g,E,P,I,V,$){g??=Ed,P??=uf,I??="butt",V??=Ed,$??="round",g!=Ie&&(h.strokeStyle=Ie=g),V!=Te&&(h.fillStyle=Te=V),E!=$e&&(h.lineWidth=$e=E),$!=He&&(h.lineJoin=He=$),I!=ct&&(h.lineCap=ct=I),P!=je&&h.setLineDash(je=P)}function Ht(g,E,P,I){E!=Te&&(h.fillStyle=Te=E),g!=vt&&(h.font=vt=g),P!=zt&&(h.textAlign=zt=P),I!=Ct&&(h.textBaseline=Ct=I)}function dt(g,E,P,I,V=0){if(I.length>0&&g.auto(i,Y)&&(E==null||E.min==null)){let $=St(A,0),se=St(G,I.length-1),ce=P.min==null?vv(I,$,se,V,g.distr==3):[P.min,P.max];g.min=Ni(g.min,P.min=ce[0]),g.max=Yn(g.max,P.max=ce[1])}}const In={min:null,max:null};function Ss(){for(let I in y){let V=y[I];W[I]==null&&(V.min==null||W[R]!=null&&V.auto(i,Y))&&(W[I]=In)}for(let I in y){let V=y[I];W[I]==null&&V.from!=null&&W[V.from]!=null&&(W[I]=In)}W[R]!=null&&Ir(!0);let g={};for(let I in W){let V=W[I];if(V!=null){let $=g[I]=Eo(y[I],Av);if(V.min!=null)un($,V);else if(I!=R||s==2)if(fn==0&&$.from==null){let se=$.range(i,null,null,I);$.min=se[0],$.max=se[1]}else $.min=Ot,$.max=-Ot}}if(fn>0){S.forEach((I,V)=>{if(s==1){let $=I.scale,se=W[$];if(se==null)return;let ce=g[$];if(V==0){let _e=ce.range(i,ce.min,ce.max,$);ce.min=_e[0],ce.max=_e[1],A=Ii(ce.min,e[0]),G=Ii(ce.max,e[0]),G-A>1&&(e[0][A]<ce.min&&A++,e[0][G]>ce.max&&G--),I.min=K[A],I.max=K[G]}else I.show&&I.auto&&dt(ce,se,I,e[V],I.sorted);I.idxs[0]=A,I.idxs[1]=G}else if(V>0&&I.show&&I.auto){let[$,se]=I.facets,ce=$.scale,_e=se.scale,[Ae,Ce]=e[V],Ue=g[ce],rt=g[_e];Ue!=null&&dt(Ue,W[ce],$,Ae,$.sorted),rt!=null&&dt(rt,W[_e],se,Ce,se.sorted),I.min=se.min,I.max=se.max}});for(let I in g){let V=g[I],$=W[I];if(V.from==null&&($==null||$.min==null)){let se=V.range(i,V.min==Ot?null:V.min,V.max==-Ot?null:V.max,I);V.min=se[0],V.max=se[1]}}}for(let I in g){let V=g[I];if(V.from!=null){let $=g[V.from];if($.min==null)V.min=V.max=null;else{let se=V.range(i,$.min,$.max,I);V.min=se[0],V.max=se[1]}}}let E={},P=!1;for(let I in g){let V=g[I],$=y[I];if($.min!=V.min||$.max!=V.max){$.min=V.min,$.max=V.max;let se=$.distr;$._min=se==3?ds($.min):se==4?Gc($.min,$.asinh):se==100?$.fwd($.min):$.min,$._max=se==3?ds($.max):se==4?Gc($.max,$.asinh):se==100?$.fwd($.max):$.max,E[I]=P=!0}}if(P){S.forEach((I,V)=>{s==2?V>0&&E.y&&(I._paths=null):E[I.scale]&&(I._paths=null)});for(let I in E)et=!0,wn("setScale",I);nt&&ge.left>=0&&(H=pe=!0)}for(let I in W)W[I]=null}function zn(g){let E=Yu(A-1,0,fn-1),P=Yu(G+1,0,fn-1);for(;g[E]==null&&E>0;)E--;for(;g[P]==null&&P<fn-1;)P++;return[E,P]}function Zs(){if(fn>0){let g=S.some(E=>E._focus)&&at!=ti.alpha;g&&(h.globalAlpha=at=ti.alpha),S.forEach((E,P)=>{if(P>0&&E.show&&(Vt(P,!1),Vt(P,!0),E._paths==null)){let I=at;at!=E.alpha&&(h.globalAlpha=at=E.alpha);let V=s==2?[0,e[P][0].length-1]:zn(e[P]);E._paths=E.paths(i,P,V[0],V[1]),at!=I&&(h.globalAlpha=at=I)}}),S.forEach((E,P)=>{if(P>0&&E.show){let I=at;at!=E.alpha&&(h.globalAlpha=at=E.alpha),E._paths!=null&&Hn(P,!1);{let V=E._paths!=null?E._paths.gaps:null,$=E.points.show(i,P,A,G,V),se=E.points.filter(i,P,$,V);($||se)&&(E.points._paths=E.points.paths(i,P,A,G,se),Hn(P,!0))}at!=I&&(h.globalAlpha=at=I),wn("drawSeries",P)}}),g&&(h.globalAlpha=at=1)}}function Vt(g,E){let P=E?S[g].points:S[g];P._stroke=P.stroke(i,g),P._fill=P.fill(i,g)}function Hn(g,E){let P=E?S[g].points:S[g],{stroke:I,fill:V,clip:$,flags:se,_stroke:ce=P._stroke,_fill:_e=P._fill,_width:Ae=P.width}=P._paths;Ae=kt(Ae*wt,3);let Ce=null,Ue=Ae%2/2;E&&_e==null&&(_e=Ae>0?"#fff":ce);let rt=P.pxAlign==1&&Ue>0;if(rt&&h.translate(Ue,Ue),!E){let bt=Re-Ae/2,xt=le-Ae/2,ht=ve+Ae,Je=Be+Ae;Ce=new Path2D,Ce.rect(bt,xt,ht,Je)}E?Sn(ce,Ae,P.dash,P.cap,_e,I,V,se,$):Zn(g,ce,Ae,P.dash,P.cap,_e,I,V,se,Ce,$),rt&&h.translate(-Ue,-Ue)}function Zn(g,E,P,I,V,$,se,ce,_e,Ae,Ce){let Ue=!1;_e!=0&&L.forEach((rt,bt)=>{if(rt.series[0]==g){let xt=S[rt.series[1]],ht=e[rt.series[1]],Je=(xt._paths||Sa).band;Os(Je)&&(Je=rt.dir==1?Je[0]:Je[1]);let Ve,Yt=null;xt.show&&Je&&yv(ht,A,G)?(Yt=rt.fill(i,bt)||$,Ve=xt._paths.clip):Je=null,Sn(E,P,I,V,Yt,se,ce,_e,Ae,Ce,Ve,Je),Ue=!0}}),Ue||Sn(E,P,I,V,$,se,ce,_e,Ae,Ce)}const Mn=bo|ju;function Sn(g,E,P,I,V,$,se,ce,_e,Ae,Ce,Ue){qe(g,E,P,I,V),(_e||Ae||Ue)&&(h.save(),_e&&h.clip(_e),Ae&&h.clip(Ae)),Ue?(ce&Mn)==Mn?(h.clip(Ue),Ce&&h.clip(Ce),fi(V,se),Es(g,$,E)):ce&ju?(fi(V,se),h.clip(Ue),Es(g,$,E)):ce&bo&&(h.save(),h.clip(Ue),Ce&&h.clip(Ce),fi(V,se),h.restore(),Es(g,$,E)):(fi(V,se),Es(g,$,E)),(_e||Ae||Ue)&&h.restore()}function Es(g,E,P){P>0&&(E instanceof Map?E.forEach((I,V)=>{h.strokeStyle=Ie=V,h.stroke(I)}):E!=null&&g&&h.stroke(E))}function fi(g,E){E instanceof Map?E.forEach((P,I)=>{h.fillStyle=Te=I,h.fill(P)}):E!=null&&g&&h.fill(E)}function zg(g,E,P,I){let V=w[g],$;if(I<=0)$=[0,0];else{let se=V._space=V.space(i,g,E,P,I),ce=V._incrs=V.incrs(i,g,E,P,I,se);$=Hx(E,P,ce,I,se)}return V._found=$}function bc(g,E,P,I,V,$,se,ce,_e,Ae){let Ce=se%2/2;x==1&&h.translate(Ce,Ce),qe(ce,se,_e,Ae,ce),h.beginPath();let Ue,rt,bt,xt,ht=V+(I==0||I==3?-$:$);P==0?(rt=V,xt=ht):(Ue=V,bt=ht);for(let Je=0;Je<g.length;Je++)E[Je]!=null&&(P==0?Ue=bt=g[Je]:rt=xt=g[Je],h.moveTo(Ue,rt),h.lineTo(bt,xt));h.stroke(),x==1&&h.translate(-Ce,-Ce)}function Hg(g){let E=!0;return w.forEach((P,I)=>{if(!P.show)return;let V=y[P.scale];if(V.min==null){P._show&&(E=!1,P._show=!1,Ir(!1));return}else P._show||(E=!1,P._show=!0,Ir(!1));let $=P.side,se=$%2,{min:ce,max:_e}=V,[Ae,Ce]=zg(I,ce,_e,se==0?M:O);if(Ce==0)return;let Ue=V.distr==2,rt=P._splits=P.splits(i,I,ce,_e,Ae,Ce,Ue),bt=V.distr==2?rt.map(Ve=>K[Ve]):rt,xt=V.distr==2?K[rt[1]]-K[rt[0]]:Ae,ht=P._values=P.values(i,P.filter(i,bt,I,Ce,xt),I,Ce,xt);P._rotate=$==2?P.rotate(i,ht,I,Ce):0;let Je=P._size;P._size=xi(P.size(i,ht,I,g)),Je!=null&&P._size!=Je&&(E=!1)}),E}function Vg(g){let E=!0;return ka.forEach((P,I)=>{let V=P(i,I,ss,g);V!=zi[I]&&(E=!1),zi[I]=V}),E}function Gg(){for(let g=0;g<w.length;g++){let E=w[g];if(!E.show||!E._show)continue;let P=E.side,I=P%2,V,$,se=E.stroke(i,g),ce=P==0||P==3?-1:1,[_e,Ae]=E._found;if(E.label!=null){let Gn=E.labelGap*ce,si=pn((E._lpos+Gn)*wt);Ht(E.labelFont[0],se,"center",P==2?Yo:Sd),h.save(),I==1?(V=$=0,h.translate(si,pn(le+Be/2)),h.rotate((P==3?-Pl:Pl)/2)):(V=pn(Re+ve/2),$=si);let er=m_(E.label)?E.label(i,g,_e,Ae):E.label;h.fillText(er,V,$),h.restore()}if(Ae==0)continue;let Ce=y[E.scale],Ue=I==0?ve:Be,rt=I==0?Re:le,bt=E._splits,xt=Ce.distr==2?bt.map(Gn=>K[Gn]):bt,ht=Ce.distr==2?K[bt[1]]-K[bt[0]]:_e,Je=E.ticks,Ve=E.border,Yt=Je.show?Je.size:0,Qt=pn(Yt*wt),Tn=pn((E.alignTo==2?E._size-Yt-E.gap:E.gap)*wt),Lt=E._rotate*-Pl/180,en=m(E._pos*wt),ni=(Qt+Tn)*ce,Vn=en+ni;$=I==0?Vn:0,V=I==1?Vn:0;let di=E.font[0],Ai=E.align==1?Gr:E.align==2?zc:Lt>0?Gr:Lt<0?zc:I==0?"center":P==3?zc:Gr,Gi=Lt||I==1?"middle":P==2?Yo:Sd;Ht(di,se,Ai,Gi);let ii=E.font[1]*E.lineGap,pi=bt.map(Gn=>m(a(Gn,Ce,Ue,rt))),Ri=E._values;for(let Gn=0;Gn<Ri.length;Gn++){let si=Ri[Gn];if(si!=null){I==0?V=pi[Gn]:$=pi[Gn],si=""+si;let er=si.indexOf(`
`)==-1?[si]:si.split(/\n/gm);for(let Wn=0;Wn<er.length;Wn++){let rd=er[Wn];Lt?(h.save(),h.translate(V,$+Wn*ii),h.rotate(Lt),h.fillText(rd,0,0),h.restore()):h.fillText(rd,V,$+Wn*ii)}}}Je.show&&bc(pi,Je.filter(i,xt,g,Ae,ht),I,P,en,Qt,kt(Je.width*wt,3),Je.stroke(i,g),Je.dash,Je.cap);let Wi=E.grid;Wi.show&&bc(pi,Wi.filter(i,xt,g,Ae,ht),I,I==0?2:1,I==0?le:Re,I==0?Be:ve,kt(Wi.width*wt,3),Wi.stroke(i,g),Wi.dash,Wi.cap),Ve.show&&bc([en],[1],I==0?1:0,I==0?1:2,I==1?le:Re,I==1?Be:ve,kt(Ve.width*wt,3),Ve.stroke(i,g),Ve.dash,Ve.cap)}wn("drawAxes")}function Ir(g){S.forEach((E,P)=>{P>0&&(E._paths=null,g&&(s==1?(E.min=null,E.max=null):E.facets.forEach(I=>{I.min=null,I.max=null})))})}let Ba=!1,wc=!1,ko=[];function Wg(){wc=!1;for(let g=0;g<ko.length;g++)wn(...ko[g]);ko.length=0}function Ur(){Ba||(Uv(Hf),Ba=!0)}function Xg(g,E=!1){Ba=!0,wc=E,g(i),Hf(),E&&ko.length>0&&queueMicrotask(Wg)}i.batch=Xg;function Hf(){if(ke&&(Ss(),ke=!1),et&&(Oe(),et=!1),Me){if(qt(d,Gr,J),qt(d,Yo,ie),qt(d,ca,M),qt(d,ua,O),qt(_,Gr,J),qt(_,Yo,ie),qt(_,ca,M),qt(_,ua,O),qt(f,ca,Et),qt(f,ua,D),u.width=pn(Et*wt),u.height=pn(D*wt),w.forEach(({_el:g,_show:E,_size:P,_pos:I,side:V})=>{if(g!=null)if(E){let $=V===3||V===0?P:0,se=V%2==1;qt(g,se?"left":"top",I-$),qt(g,se?"width":"height",P),qt(g,se?"top":"left",se?ie:J),qt(g,se?"height":"width",se?O:M),Wu(g,pr)}else ai(g,pr)}),Ie=Te=$e=He=ct=vt=zt=Ct=je=null,at=1,Ho(!0),J!=te||ie!=Fe||M!=he||O!=Le){Ir(!1);let g=M/he,E=O/Le;if(nt&&!H&&ge.left>=0){ge.left*=g,ge.top*=E,Nr&&Xi(Nr,pn(ge.left),0,M,O),Fr&&Xi(Fr,0,pn(ge.top),M,O);for(let P=0;P<Bn.length;P++){let I=Bn[P];I!=null&&(is[P]*=g,Ti[P]*=E,Xi(I,xi(is[P]),xi(Ti[P]),M,O))}}if(Xt.show&&!fe&&Xt.left>=0&&Xt.width>0){Xt.left*=g,Xt.width*=g,Xt.top*=E,Xt.height*=E;for(let P in Dc)qt(Br,P,Xt[P])}te=J,Fe=ie,he=M,Le=O}wn("setSize"),Me=!1}Et>0&&D>0&&(h.clearRect(0,0,u.width,u.height),wn("drawClear"),N.forEach(g=>g()),wn("draw")),Xt.show&&fe&&(za(Xt),fe=!1),nt&&H&&(Qs(null,!0,!1),H=!1),xe.show&&xe.live&&pe&&(Cc(),pe=!1),l||(l=!0,i.status=1,wn("ready")),Y=!1,Ba=!1}i.redraw=(g,E)=>{et=E||!1,g!==!1?ws(R,C.min,C.max):Ur()};function Tc(g,E){let P=y[g];if(P.from==null){if(fn==0){let I=P.range(i,E.min,E.max,g);E.min=I[0],E.max=I[1]}if(E.min>E.max){let I=E.min;E.min=E.max,E.max=I}if(fn>1&&E.min!=null&&E.max!=null&&E.max-E.min<1e-16)return;g==R&&P.distr==2&&fn>0&&(E.min=Ii(E.min,e[0]),E.max=Ii(E.max,e[0]),E.min==E.max&&E.max++),W[g]=E,ke=!0,Ur()}}i.setScale=Tc;let Ac,Rc,Nr,Fr,Vf,Gf,Or,kr,Wf,Xf,Wt,jt,bs=!1;const Pn=ge.drag;let En=Pn.x,bn=Pn.y;nt&&(ge.x&&(Ac=_i(sv,_)),ge.y&&(Rc=_i(rv,_)),C.ori==0?(Nr=Ac,Fr=Rc):(Nr=Rc,Fr=Ac),Wt=ge.left,jt=ge.top);const Xt=i.select=un({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),Br=Xt.show?_i(iv,Xt.over?_:d):null;function za(g,E){if(Xt.show){for(let P in g)Xt[P]=g[P],P in Dc&&qt(Br,P,g[P]);E!==!1&&wn("setSelect")}}i.setSelect=za;function Yg(g){if(S[g].show)tt&&Wu(ye[g],pr);else if(tt&&ai(ye[g],pr),nt){let P=Bi?Bn[0]:Bn[g];P!=null&&Xi(P,-10,-10,M,O)}}function ws(g,E,P){Tc(g,{min:E,max:P})}function Hi(g,E,P,I){E.focus!=null&&Zg(g),E.show!=null&&S.forEach((V,$)=>{$>0&&(g==$||g==null)&&(V.show=E.show,Yg($),s==2?(ws(V.facets[0].scale,null,null),ws(V.facets[1].scale,null,null)):ws(V.scale,null,null),Ur())}),P!==!1&&wn("setSeries",g,E),I&&Vo("setSeries",i,g,E)}i.setSeries=Hi;function qg(g,E){un(L[g],E)}function $g(g,E){g.fill=pt(g.fill||null),g.dir=St(g.dir,-1),E=E??L.length,L.splice(E,0,g)}function jg(g){g==null?L.length=0:L.splice(g,1)}i.addBand=$g,i.setBand=qg,i.delBand=jg;function Kg(g,E){S[g].alpha=E,nt&&Bn[g]!=null&&(Bn[g].style.opacity=E),tt&&ye[g]&&(ye[g].style.opacity=E)}let rs,Ts,Js;const zr={focus:!0};function Zg(g){if(g!=Js){let E=g==null,P=ti.alpha!=1;S.forEach((I,V)=>{if(s==1||V>0){let $=E||V==0||V==g;I._focus=E?null:$,P&&Kg(V,$?1:ti.alpha)}}),Js=g,P&&Ur()}}tt&&Kn&&We(Td,ne,g=>{ge._lock||(Cn(g),Js!=null&&Hi(null,zr,!0,an.setSeries))});function Vi(g,E,P){let I=y[E];P&&(g=g/wt-(I.ori==1?ie:J));let V=M;I.ori==1&&(V=O,g=V-g),I.dir==-1&&(g=V-g);let $=I._min,se=I._max,ce=g/V,_e=$+(se-$)*ce,Ae=I.distr;return Ae==3?Mo(10,_e):Ae==4?Sv(_e,I.asinh):Ae==100?I.bwd(_e):_e}function Jg(g,E){let P=Vi(g,R,E);return Ii(P,e[0],A,G)}i.valToIdx=g=>Ii(g,e[0]),i.posToIdx=Jg,i.posToVal=Vi,i.valToPos=(g,E,P)=>y[E].ori==0?r(g,y[E],P?ve:M,P?Re:0):o(g,y[E],P?Be:O,P?le:0),i.setCursor=(g,E,P)=>{Wt=g.left,jt=g.top,Qs(null,E,P)};function Yf(g,E){qt(Br,Gr,Xt.left=g),qt(Br,ca,Xt.width=E)}function qf(g,E){qt(Br,Yo,Xt.top=g),qt(Br,ua,Xt.height=E)}let Bo=C.ori==0?Yf:qf,zo=C.ori==1?Yf:qf;function Qg(){if(tt&&xe.live)for(let g=s==2?1:0;g<S.length;g++){if(g==0&&F)continue;let E=xe.values[g],P=0;for(let I in E)it[g][P++].firstChild.nodeValue=E[I]}}function Cc(g,E){if(g!=null&&(g.idxs?g.idxs.forEach((P,I)=>{me[I]=P}):Tv(g.idx)||me.fill(g.idx),xe.idx=me[0]),tt&&xe.live){for(let P=0;P<S.length;P++)(P>0||s==1&&!F)&&e0(P,me[P]);Qg()}pe=!1,E!==!1&&wn("setLegend")}i.setLegend=Cc;function e0(g,E){let P=S[g],I=g==0&&B==2?K:e[g],V;F?V=P.values(i,g,E)??mt:(V=P.value(i,E==null?null:I[E],g,E),V=V==null?mt:{_:V}),xe.values[g]=V}function Qs(g,E,P){Wf=Wt,Xf=jt,[Wt,jt]=ge.move(i,Wt,jt),ge.left=Wt,ge.top=jt,nt&&(Nr&&Xi(Nr,pn(Wt),0,M,O),Fr&&Xi(Fr,0,pn(jt),M,O));let I,V=A>G;rs=Ot,Ts=null;let $=C.ori==0?M:O,se=C.ori==1?M:O;if(Wt<0||fn==0||V){I=ge.idx=null;for(let ce=0;ce<S.length;ce++){let _e=Bn[ce];_e!=null&&Xi(_e,-10,-10,M,O)}Kn&&Hi(null,zr,!0,g==null&&an.setSeries),xe.live&&(me.fill(I),pe=!0)}else{let ce,_e,Ae;s==1&&(ce=C.ori==0?Wt:jt,_e=Vi(ce,R),I=ge.idx=Ii(_e,e[0],A,G),Ae=z(e[0][I],C,$,0));let Ce=-10,Ue=-10,rt=0,bt=0,xt=!0,ht="",Je="";for(let Ve=s==2?1:0;Ve<S.length;Ve++){let Yt=S[Ve],Qt=me[Ve],Tn=Qt==null?null:s==1?e[Ve][Qt]:e[Ve][1][Qt],Lt=ge.dataIdx(i,Ve,I,_e),en=Lt==null?null:s==1?e[Ve][Lt]:e[Ve][1][Lt];if(pe=pe||en!=Tn||Lt!=Qt,me[Ve]=Lt,Ve>0&&Yt.show){let ni=Lt==null?-10:Lt==I?Ae:z(s==1?e[0][Lt]:e[Ve][0][Lt],C,$,0),Vn=en==null?-10:X(en,s==1?y[Yt.scale]:y[Yt.facets[1].scale],se,0);if(Kn&&en!=null){let di=C.ori==1?Wt:jt,Ai=mn(ti.dist(i,Ve,Lt,Vn,di));if(Ai<rs){let Gi=ti.bias;if(Gi!=0){let ii=Vi(di,Yt.scale),pi=en>=0?1:-1,Ri=ii>=0?1:-1;Ri==pi&&(Ri==1?Gi==1?en>=ii:en<=ii:Gi==1?en<=ii:en>=ii)&&(rs=Ai,Ts=Ve)}else rs=Ai,Ts=Ve}}if(pe||Bi){let di,Ai;C.ori==0?(di=ni,Ai=Vn):(di=Vn,Ai=ni);let Gi,ii,pi,Ri,Wi,Gn,si=!0,er=Nt.bbox;if(er!=null){si=!1;let Wn=er(i,Ve);pi=Wn.left,Ri=Wn.top,Gi=Wn.width,ii=Wn.height}else pi=di,Ri=Ai,Gi=ii=Nt.size(i,Ve);if(Gn=Nt.fill(i,Ve),Wi=Nt.stroke(i,Ve),Bi)Ve==Ts&&rs<=ti.prox&&(Ce=pi,Ue=Ri,rt=Gi,bt=ii,xt=si,ht=Gn,Je=Wi);else{let Wn=Bn[Ve];Wn!=null&&(is[Ve]=pi,Ti[Ve]=Ri,Id(Wn,Gi,ii,si),Dd(Wn,Gn,Wi),Xi(Wn,xi(pi),xi(Ri),M,O))}}}}if(Bi){let Ve=ti.prox,Yt=Js==null?rs<=Ve:rs>Ve||Ts!=Js;if(pe||Yt){let Qt=Bn[0];Qt!=null&&(is[0]=Ce,Ti[0]=Ue,Id(Qt,rt,bt,xt),Dd(Qt,ht,Je),Xi(Qt,xi(Ce),xi(Ue),M,O))}}}if(Xt.show&&bs)if(g!=null){let[ce,_e]=an.scales,[Ae,Ce]=an.match,[Ue,rt]=g.cursor.sync.scales,bt=g.cursor.drag;if(En=bt._x,bn=bt._y,En||bn){let{left:xt,top:ht,width:Je,height:Ve}=g.select,Yt=g.scales[Ue].ori,Qt=g.posToVal,Tn,Lt,en,ni,Vn,di=ce!=null&&Ae(ce,Ue),Ai=_e!=null&&Ce(_e,rt);di&&En?(Yt==0?(Tn=xt,Lt=Je):(Tn=ht,Lt=Ve),en=y[ce],ni=z(Qt(Tn,Ue),en,$,0),Vn=z(Qt(Tn+Lt,Ue),en,$,0),Bo(Ni(ni,Vn),mn(Vn-ni))):Bo(0,$),Ai&&bn?(Yt==1?(Tn=xt,Lt=Je):(Tn=ht,Lt=Ve),en=y[_e],ni=X(Qt(Tn,rt),en,se,0),Vn=X(Qt(Tn+Lt,rt),en,se,0),zo(Ni(ni,Vn),mn(Vn-ni))):zo(0,se)}else Lc()}else{let ce=mn(Wf-Vf),_e=mn(Xf-Gf);if(C.ori==1){let rt=ce;ce=_e,_e=rt}En=Pn.x&&ce>=Pn.dist,bn=Pn.y&&_e>=Pn.dist;let Ae=Pn.uni;Ae!=null?En&&bn&&(En=ce>=Ae,bn=_e>=Ae,!En&&!bn&&(_e>ce?bn=!0:En=!0)):Pn.x&&Pn.y&&(En||bn)&&(En=bn=!0);let Ce,Ue;En&&(C.ori==0?(Ce=Or,Ue=Wt):(Ce=kr,Ue=jt),Bo(Ni(Ce,Ue),mn(Ue-Ce)),bn||zo(0,se)),bn&&(C.ori==1?(Ce=Or,Ue=Wt):(Ce=kr,Ue=jt),zo(Ni(Ce,Ue),mn(Ue-Ce)),En||Bo(0,$)),!En&&!bn&&(Bo(0,0),zo(0,0))}if(Pn._x=En,Pn._y=bn,g==null){if(P){if(sd!=null){let[ce,_e]=an.scales;an.values[0]=ce!=null?Vi(C.ori==0?Wt:jt,ce):null,an.values[1]=_e!=null?Vi(C.ori==1?Wt:jt,_e):null}Vo(Hc,i,Wt,jt,M,O,I)}if(Kn){let ce=P&&an.setSeries,_e=ti.prox;Js==null?rs<=_e&&Hi(Ts,zr,!0,ce):rs>_e?Hi(null,zr,!0,ce):Ts!=Js&&Hi(Ts,zr,!0,ce)}}pe&&(xe.idx=I,Cc()),E!==!1&&wn("setCursor")}let As=null;Object.defineProperty(i,"rect",{get(){return As==null&&Ho(!1),As}});function Ho(g=!1){g?As=null:(As=_.getBoundingClientRect(),wn("syncRect",As))}function $f(g,E,P,I,V,$,se){ge._lock||bs&&g!=null&&g.movementX==0&&g.movementY==0||(Pc(g,E,P,I,V,$,se,!1,g!=null),g!=null?Qs(null,!0,!0):Qs(E,!0,!1))}function Pc(g,E,P,I,V,$,se,ce,_e){if(As==null&&Ho(!1),Cn(g),g!=null)P=g.clientX-As.left,I=g.clientY-As.top;else{if(P<0||I<0){Wt=-10,jt=-10;return}let[Ae,Ce]=an.scales,Ue=E.cursor.sync,[rt,bt]=Ue.values,[xt,ht]=Ue.scales,[Je,Ve]=an.match,Yt=E.axes[0].side%2==1,Qt=C.ori==0?M:O,Tn=C.ori==1?M:O,Lt=Yt?$:V,en=Yt?V:$,ni=Yt?I:P,Vn=Yt?P:I;if(xt!=null?P=Je(Ae,xt)?a(rt,y[Ae],Qt,0):-10:P=Qt*(ni/Lt),ht!=null?I=Ve(Ce,ht)?a(bt,y[Ce],Tn,0):-10:I=Tn*(Vn/en),C.ori==1){let di=P;P=I,I=di}}_e&&(E==null||E.cursor.event.type==Hc)&&((P<=1||P>=M-1)&&(P=lr(P,M)),(I<=1||I>=O-1)&&(I=lr(I,O))),ce?(Vf=P,Gf=I,[Or,kr]=ge.move(i,P,I)):(Wt=P,jt=I)}const Dc={width:0,height:0,left:0,top:0};function Lc(){za(Dc,!1)}let jf,Kf,Zf,Jf;function Qf(g,E,P,I,V,$,se){bs=!0,En=bn=Pn._x=Pn._y=!1,Pc(g,E,P,I,V,$,se,!0,!1),g!=null&&(We(Vc,Vu,ed,!1),Vo(bd,i,Or,kr,M,O,null));let{left:ce,top:_e,width:Ae,height:Ce}=Xt;jf=ce,Kf=_e,Zf=Ae,Jf=Ce}function ed(g,E,P,I,V,$,se){bs=Pn._x=Pn._y=!1,Pc(g,E,P,I,V,$,se,!1,!0);let{left:ce,top:_e,width:Ae,height:Ce}=Xt,Ue=Ae>0||Ce>0,rt=jf!=ce||Kf!=_e||Zf!=Ae||Jf!=Ce;if(Ue&&rt&&za(Xt),Pn.setScale&&Ue&&rt){let bt=ce,xt=Ae,ht=_e,Je=Ce;if(C.ori==1&&(bt=_e,xt=Ce,ht=ce,Je=Ae),En&&ws(R,Vi(bt,R),Vi(bt+xt,R)),bn)for(let Ve in y){let Yt=y[Ve];Ve!=R&&Yt.from==null&&Yt.min!=Ot&&ws(Ve,Vi(ht+Je,Ve),Vi(ht,Ve))}Lc()}else ge.lock&&(ge._lock=!ge._lock,Qs(E,!0,g!=null));g!=null&&(Gt(Vc,Vu),Vo(Vc,i,Wt,jt,M,O,null))}function t0(g,E,P,I,V,$,se){if(ge._lock)return;Cn(g);let ce=bs;if(bs){let _e=!0,Ae=!0,Ce=10,Ue,rt;C.ori==0?(Ue=En,rt=bn):(Ue=bn,rt=En),Ue&&rt&&(_e=Wt<=Ce||Wt>=M-Ce,Ae=jt<=Ce||jt>=O-Ce),Ue&&_e&&(Wt=Wt<Or?0:M),rt&&Ae&&(jt=jt<kr?0:O),Qs(null,!0,!0),bs=!1}Wt=-10,jt=-10,me.fill(null),Qs(null,!0,!0),ce&&(bs=ce)}function td(g,E,P,I,V,$,se){ge._lock||(Cn(g),Se(),Lc(),g!=null&&Vo(Ad,i,Wt,jt,M,O,null))}function nd(){w.forEach(Vx),De(i.width,i.height,!0)}Er(Zl,ho,nd);const Hr={};Hr.mousedown=Qf,Hr.mousemove=$f,Hr.mouseup=ed,Hr.dblclick=td,Hr.setSeries=(g,E,P,I)=>{let V=an.match[2];P=V(i,E,P),P!=-1&&Hi(P,I,!0,!1)},nt&&(We(bd,_,Qf),We(Hc,_,$f),We(wd,_,g=>{Cn(g),Ho(!1)}),We(Td,_,t0),We(Ad,_,td),Ku.add(i),i.syncRect=Ho);const Ha=i.hooks=n.hooks||{};function wn(g,E,P){wc?ko.push([g,E,P]):g in Ha&&Ha[g].forEach(I=>{I.call(null,i,E,P)})}(n.plugins||[]).forEach(g=>{for(let E in g.hooks)Ha[E]=(Ha[E]||[]).concat(g.hooks[E])});const id=(g,E,P)=>P,an=un({key:null,setSeries:!1,filters:{pub:kd,sub:kd},scales:[R,S[1]?S[1].scale:null],match:[Bd,Bd,id],values:[null,null]},ge.sync);an.match.length==2&&an.match.push(id),ge.sync=an;const sd=an.key,Ic=B_(sd);function Vo(g,E,P,I,V,$,se){an.filters.pub(g,E,P,I,V,$,se)&&Ic.pub(g,E,P,I,V,$,se)}Ic.sub(i);function n0(g,E,P,I,V,$,se){an.filters.sub(g,E,P,I,V,$,se)&&Hr[g](null,E,P,I,V,$,se)}i.pub=n0;function i0(){Ic.unsub(i),Ku.delete(i),Pe.clear(),Xu(Zl,ho,nd),c.remove(),ne?.remove(),wn("destroy")}i.destroy=i0;function Uc(){wn("init",n,e),de(e||n.data,!1),W[R]?Tc(R,W[R]):Se(),fe=Xt.show&&(Xt.width>0||Xt.height>0),H=pe=!0,De(n.width,n.height)}return S.forEach(js),w.forEach(Ec),t?t instanceof HTMLElement?(t.appendChild(c),Uc()):t(i,Uc):Uc(),i}kn.assign=un;kn.fmtNum=cf;kn.rangeNum=Jl;kn.rangeLog=dc;kn.rangeAsinh=af;kn.orient=Pr;kn.pxRatio=wt;kn.join=Iv;kn.fmtDate=hf,kn.tzDate=Wv;kn.sync=B_;{kn.addGap=Tx,kn.clipGaps=_c;let n=kn.paths={points:X_};n.linear=q_,n.stepped=Cx,n.bars=Px,n.spline=Lx}const $a=Xe("q"),Gx={light:["#0072b2","#b35c00","#007a5a","#a8327d","#5b4bd6","#1f1f1f","#8a6d00"],dark:["#56b4e9","#f5a742","#3fd6a5","#f08cc8","#b3a5ff","#e8e8e8","#f0e442"]},Z_=30;function Wx(){const n=ui(null);br(()=>{let t=null;const i=Jt(()=>{t?.destroy(),t=n.current?Xx(n.current,$a.value):null}),s=Jt(()=>{Ui.value,t?.redraw(!1,!1)}),r=new ResizeObserver(()=>n.current&&t?.setSize({width:n.current.clientWidth,height:n.current.clientHeight-Z_}));return n.current&&r.observe(n.current),()=>{i(),s(),r.disconnect(),t?.destroy()}},[]);const e=(La.value?.t.length??0)===0;return v("div",{class:"plots",children:[v(uo,{label:"What is plotted",value:$a.value,onChange:t=>$a.value=t,options:[["q","Joints"],["qd","Rates"],["qdd","Accelerations"],["tool_speed","Tool speed"]]}),e&&v("p",{class:"quiet",children:"A motion shows its joints, rates and the tool's speed here."}),v("div",{class:"plot",ref:n,hidden:e,role:"img","aria-label":`Plot of ${$a.value} over time`})]})}function Xx(n,e){const t=La.value,i=rn.value?.joints??[];if(!t||t.t.length===0)return null;const s=Sr.value?"#c9cfdb":"#3a4150",r=Sr.value?"#2c313c":"#e4e7ed",o=Gx[Sr.value?"dark":"light"],a=_t.value.angle==="deg",l=d=>yo(i[d])==="angle"?a?180/Math.PI:1:_t.value.length==="mm"?1e3:1,c={q:"",qd:"/s",qdd:"/s²",tool_speed:""}[e],u=[{label:"t",value:(d,_)=>_===null?"–":`${_.toFixed(2)} s`}],h=[t.t];if(e==="tool_speed"){const d=_t.value.length==="mm"?1e3:1;h.push(t.tool_speed.map(_=>_*d)),u.push({label:`tool, ${_t.value.length}/s`,stroke:o[4],width:1.75,pxAlign:0})}else t[e].forEach((d,_)=>{if(!i[_])return;const x=yo(i[_])==="angle"?a?"°":"rad":_t.value.length;h.push(d.map(m=>m*l(_))),u.push({label:`${i[_].label}, ${x}${c}`,stroke:o[_%o.length],width:1.75,pxAlign:0,..._>3?{dash:[6,3]}:{}})});const f={stroke:s,grid:{stroke:r,width:1},ticks:{stroke:r},font:"12px system-ui, sans-serif"};return new kn({width:n.clientWidth||600,height:(n.clientHeight||180)-Z_,series:u,scales:{x:{time:!1}},legend:{live:!0},axes:[f,{...f,size:56}],cursor:{drag:{x:!1,y:!1}},hooks:{ready:[d=>d.over.addEventListener("click",()=>{const _=d.cursor.left;_!==void 0&&Ge({do:"seek",t:d.posToVal(_,"x")})})],draw:[d=>{const _=Math.round(d.valToPos(Ui.peek(),"x",!0));d.ctx.save(),d.ctx.strokeStyle="#7c3aed",d.ctx.lineWidth=2,d.ctx.beginPath(),d.ctx.moveTo(_,d.bbox.top),d.ctx.lineTo(_,d.bbox.top+d.bbox.height),d.ctx.stroke(),d.ctx.restore()}]}},h,n)}const Yx=(function(){const e=typeof document<"u"&&document.createElement("link").relList;return e&&e.supports&&e.supports("modulepreload")?"modulepreload":"preload"})(),qx=function(n,e){return new URL(n,e).href},ap={},$x=function(e,t,i){let s=Promise.resolve();if(t&&t.length>0){let c=function(u){return Promise.all(u.map(h=>Promise.resolve(h).then(f=>({status:"fulfilled",value:f}),f=>({status:"rejected",reason:f}))))};const o=document.getElementsByTagName("link"),a=document.querySelector("meta[property=csp-nonce]"),l=a?.nonce||a?.getAttribute("nonce");s=c(t.map(u=>{if(u=qx(u,i),u in ap)return;ap[u]=!0;const h=u.endsWith(".css"),f=h?'[rel="stylesheet"]':"";if(i)for(let _=o.length-1;_>=0;_--){const x=o[_];if(x.href===u&&(!h||x.rel==="stylesheet"))return}else if(document.querySelector(`link[href="${u}"]${f}`))return;const d=document.createElement("link");if(d.rel=h?"stylesheet":Yx,h||(d.as="script"),d.crossOrigin="",d.href=u,l&&d.setAttribute("nonce",l),document.head.appendChild(d),h)return new Promise((_,x)=>{d.addEventListener("load",_),d.addEventListener("error",()=>x(new Error(`Unable to preload CSS for ${u}`)))})}))}function r(o){const a=new Event("vite:preloadError",{cancelable:!0});if(a.payload=o,window.dispatchEvent(a),!a.defaultPrevented)throw o}return s.then(o=>{for(const a of o||[])a.status==="rejected"&&r(a.reason);return e().catch(r)})};let qi=null,ja=0;function lp(){!qi||ya.value?.running||(ba.value=[],qi.markLine(null),Ge({do:"script_run",text:qi.text()}))}function Ju(){Ge({do:"script_stop"})}function jx(){const n=ui(null),e=ui(null),[t,i]=vo([]),[s,r]=vo(null),o=ya.value;return br(()=>{let l=!1,c;Promise.all([$x(()=>import("./editor-CusletEg.js"),[],import.meta.url),Ge({do:"script_examples"})]).then(([{makeEditor:h},f])=>{if(l||!n.current)return;i(f??[]);const d=ya.value?.text||f?.[0]?.text||"";qi=h(n.current,d,lp,_=>{clearTimeout(c),c=setTimeout(()=>{Ge({do:"script_save",text:_})},800)}),qi.setDark(Sr.value)});const u=[Jt(()=>{const h=Sr.value;qi?.setDark(h)}),Jt(()=>{const h=ya.value?.error?.line??null;qi?.markLine(h)}),Jt(()=>{ba.value,requestAnimationFrame(()=>e.current?.scrollTo(0,e.current.scrollHeight))})];return()=>{l=!0,u.forEach(h=>h()),qi?.destroy(),qi=null}},[]),v("div",{class:"script",onKeyDown:l=>{ja=l.key==="Escape"?ja+1:0,ja>=2&&o?.running&&(ja=0,Ju())},children:[v("div",{class:"script-edit",children:[v("div",{class:"row",children:[v("button",{type:"button",class:"text-button go",disabled:o?.running||!o?.python?.found,onClick:lp,title:"Ctrl+Enter",children:"Run"}),v("button",{type:"button",class:"text-button",disabled:!o?.running,onClick:Ju,title:"Esc twice",children:"Stop"}),v("label",{class:"field",children:["Examples ",v("select",{value:"",onChange:l=>{const c=t.find(u=>u.name===l.currentTarget.value);c&&qi?.setText(c.text),l.currentTarget.value=""},children:[v("option",{value:"",children:"choose…"}),t.map(l=>v("option",{children:l.name},l.name))]})]}),v("button",{type:"button",class:"text-button","aria-expanded":s!==null,onClick:()=>{s?r(null):Ge({do:"script_help"}).then(l=>r(l))},children:"mathmodel"}),v("span",{class:"grow"}),v("span",{class:o?.python?.found?"quiet small":"banner",children:o?.python?.sentence??"Looking for Python…"})]}),v("div",{class:"editor",ref:n})]}),v("div",{class:"script-side",children:s?v("div",{class:"scroll-box",role:"region",tabIndex:0,"aria-label":"What mathmodel offers",children:[v("div",{class:"row spread",children:[v("strong",{children:"import mathmodel"}),v(yt,{icon:"close",label:"Close",onClick:()=>r(null)})]}),v("dl",{class:"help",children:s.map(l=>v(jn,{children:[v("dt",{children:v("code",{children:l.name})},l.name),v("dd",{children:[l.does,v("br",{}),v("code",{class:"quiet",children:l.example})]})]}))})]}):v("div",{class:"console",ref:e,role:"log",tabIndex:0,"aria-label":"Output of the script",children:[ba.value.map((l,c)=>v("span",{class:l.stream,children:l.text},c)),o?.ended&&!o.running&&v("span",{class:o.error?"err":"note",children:[o.ended,`
`]})]})})]})}const Kx=16;function J_({label:n,size:e,name:t,from:i,least:s,most:r}){const o=ui(null),a=u=>i==="right"?u.clientX:u.clientY,l=u=>{e.value=Math.round(Math.min(r(),Math.max(s,u)))},c=()=>{o.current&&xs(t,String(e.value)),o.current=null};return v("div",{class:`splitter ${i}`,role:"separator",tabIndex:0,"aria-label":n,"aria-orientation":i==="right"?"vertical":"horizontal","aria-valuenow":e.value,"aria-valuemin":s,"aria-valuemax":r(),"aria-valuetext":`${e.value} pixels`,title:`${n}: drag, or arrow keys`,onPointerDown:u=>{u.currentTarget.setPointerCapture(u.pointerId),o.current={at:a(u),size:e.value}},onPointerMove:u=>{o.current&&l(o.current.size+o.current.at-a(u))},onPointerUp:c,onPointerCancel:c,onKeyDown:u=>{const h={ArrowLeft:1,ArrowUp:1,ArrowRight:-1,ArrowDown:-1}[u.key];h!==void 0&&(u.preventDefault(),l(e.value+h*Kx),xs(t,String(e.value)))}})}const Zx=new wr(n=>bi.send(n),()=>{},n=>gn(n.message)),Jx=.12,ec=.01,cp=n=>Math.max(0,Math.round(n/ec)*ec);function Qx(n){const e=n/8,t=10**Math.floor(Math.log10(e));return t*([1,2,5,10].find(i=>i*t>=e*(1-1e-9))??10)}function ey(){const n=vs.value,e=ui(null),t=ui(null),i=t.current?.span??Math.max(1,n.duration)*(1+Jx),s=u=>`${100*Math.min(u,i)/i}%`,r=u=>{const h=e.current.getBoundingClientRect();return(u-h.left)/h.width*i},o=(u,h,f)=>{n.keyframes.some(d=>d.id!==u.id&&Math.abs(d.t-h)<ec/2)||Zx.push({do:"keyframe",op:"move",keyframe:u.id,t:h,gesture:f})},a=(u,h)=>{const f={ArrowRight:1,ArrowUp:1,ArrowLeft:-1,ArrowDown:-1}[u.key];f!==void 0&&(u.preventDefault(),u.stopPropagation(),o(h,cp(h.t+f*(u.shiftKey?1:u.altKey?ec:.1)),Tr("keyframe")))},l=Qx(i),c=Array.from({length:Math.floor(i/l)+1},(u,h)=>h*l);return v("div",{class:"timeline",ref:e,role:"group","aria-label":"Keyframes in time",onPointerDown:u=>{u.target===e.current&&Ge({do:"seek",t:Math.min(n.duration,Math.max(0,r(u.clientX)))})},children:[c.map(u=>v("span",{class:"tick","aria-hidden":"true",ref:qc("left",s(u)),children:[Number(u.toPrecision(6))," s"]},u)),v("span",{class:"clock","aria-hidden":"true",ref:qc("left",s(Ui.value))}),n.keyframes.map(u=>v("button",{type:"button",class:"mark",role:"slider",ref:qc("left",s(u.t)),"aria-label":`Keyframe ${u.label||u.id}`,"aria-valuenow":u.t,"aria-valuemin":0,"aria-valuemax":i,"aria-valuetext":`${u.t.toFixed(2)} seconds`,title:`${u.label||u.id} at ${u.t.toFixed(2)} s: drag to another time, double-click to go there`,onPointerDown:h=>{h.currentTarget.setPointerCapture(h.pointerId),t.current={id:u.id,name:Tr("keyframe"),span:i,from:u.t,x:h.clientX}},onPointerMove:h=>{const f=t.current;if(f?.id!==u.id)return;const d=f.from+r(h.clientX)-r(f.x);o(u,cp(Math.min(d,f.span)),f.name)},onPointerUp:()=>t.current=null,onPointerCancel:()=>t.current=null,onDblClick:()=>{Ge({do:"keyframe",op:"goto",keyframe:u.id})},onKeyDown:h=>a(h,u),children:v("span",{children:u.label||u.id})},u.id))]})}function qc(n,e){return t=>t?.style.setProperty(n,e)}const ty=[["motion","Motion"],["plots","Plots"],["formulas","Formulas"],["script","Script"],["controller","Controller"],["log","Log"]];function Dl(){return gi.value==="script"||gi.value==="formulas"?"tall":"drawer"}function ny(){const n=gi.value,e=vs.value;return v("footer",{class:`drawer ${n?"open":""}`,children:[n&&v(J_,{label:"Height of the drawer",size:$l[Dl()],name:Dl(),from:"bottom",least:120,most:()=>Math.max(120,Math.round(.7*innerHeight))},Dl()),v("div",{class:"drawer-bar",children:[v(iy,{}),v("span",{class:"grow"}),v("div",{class:"tabs",role:"tablist","aria-label":"Drawer",children:ty.filter(([t])=>!Lo||t==="plots").map(([t,i])=>v("button",{type:"button",role:"tab",id:`drawer-tab-${t}`,"aria-selected":n===t,"aria-controls":"drawer-body",onClick:()=>gi.value=n===t?null:t,children:[i,t==="log"&&oa.value.some(s=>s.level!=="info")&&v("span",{class:"badge",children:oa.value.length})]},t))})]}),v("div",{class:"drawer-body",id:"drawer-body",role:"tabpanel",hidden:!n,...n?{"aria-labelledby":`drawer-tab-${n}`}:{},children:[n==="motion"&&e&&v(ry,{}),n==="plots"&&v(Wx,{}),n==="formulas"&&v(q0,{}),n==="script"&&v(jx,{}),n==="controller"&&v(z0,{}),n==="log"&&(oa.value.length===0?v("p",{class:"quiet",children:"Nothing has happened that needs telling."}):v("ol",{class:"log",children:oa.value.map((t,i)=>v("li",{class:t.level,children:t.text},i))}))]})]})}function iy(){const n=vs.value;if(!n)return null;const e=n.keyframes.length>1;return v("div",{class:"transport",role:"group","aria-label":"Playback",children:[!Lo&&v(yt,{icon:"plus",label:"Add this posture as a keyframe",keys:"K",text:e?void 0:"Keyframe",onClick:Q_}),v(yt,{icon:"back",label:"A step back",disabled:!e,onClick:()=>{Ge({do:"step",by:-1})}}),v(yt,{icon:n.playing?"pause":"play",class:"primary",label:n.playing?"Pause":"Play",keys:"Space",disabled:!e,onClick:eg}),v(yt,{icon:"forward",label:"A step on",disabled:!e,onClick:()=>{Ge({do:"step",by:1})}}),v(yt,{icon:"loop",label:"Again and again",pressed:n.loop,disabled:!e,onClick:()=>{Ge({do:"loop",on:!n.loop})}}),e&&v(jn,{children:[v("input",{class:"scrub",type:"range",min:0,max:n.duration,step:n.duration/1e3,value:Ui.value,"aria-label":"Time","aria-valuetext":`${Ui.value.toFixed(2)} of ${n.duration.toFixed(2)} seconds`,onInput:t=>{Ui.value=Number(t.currentTarget.value),Ge({do:"seek",t:Ui.value})}}),v("span",{class:"time",children:[Ui.value.toFixed(2)," / ",n.duration.toFixed(2)," s"]})]}),!e&&v("span",{class:"quiet small wide",children:"Two keyframes or a table make a motion."})]})}function Q_(){Ge({do:"keyframe",op:"add"}).then(n=>{n&&gn("Keyframe added","note")})}function eg(){Ge({do:vs.value?.playing?"pause":"play"})}const sy=["motion.csv","motion.json",...["joints","rates","accelerations","path"].flatMap(n=>[`${n}.svg`,`${n}.png`])];function ry(){const n=vs.value,e=async i=>{const s=await Ge({do:"motion_table",name:i.name,text:await i.text()});s&&gn(`${i.name}: ${s.rows} rows`,"note")},t=n.keyframes.length>60;return v("div",{class:"motion",children:[v("div",{class:"row",children:[v("label",{class:"text-button",children:[v("span",{children:"Open a table…"}),v("input",{type:"file",class:"visually-hidden",accept:".csv",onChange:i=>{const s=i.currentTarget.files?.[0];s&&e(s),i.currentTarget.value=""}})]}),v("label",{class:"field",children:["Law ",v("select",{value:n.law,onChange:i=>{Ge({do:"law",to:i.currentTarget.value})},children:n.laws.map(i=>v("option",{children:i},i))})]}),v("label",{class:"field",children:["Speed ",v("input",{type:"range",min:.1,max:4,step:.1,value:n.speed,"aria-valuetext":`${n.speed} times`,onInput:i=>{Ge({do:"speed",to:Number(i.currentTarget.value)})}})," ",v("span",{class:"time",children:[n.speed.toFixed(1),"×"]})]}),v("span",{class:"grow"}),v("label",{class:"field",children:["Export ",v("select",{value:"",disabled:n.keyframes.length<2,onChange:i=>{location.assign(`/api/export/${i.currentTarget.value}`),i.currentTarget.value=""},children:[v("option",{value:"",children:"choose…"}),sy.map(i=>v("option",{children:i},i))]})]}),v("button",{type:"button",class:"text-button",disabled:n.keyframes.length===0,onClick:()=>{Ge({do:"keyframe",op:"clear"})},children:"Clear"})]}),n.problem&&v("p",{class:"banner",children:n.problem}),n.name&&v("p",{class:"quiet small",children:[n.name,": ",n.keyframes.length," rows"]}),n.keyframes.length===0&&v("p",{class:"quiet",children:["Bring the arm to a posture and press ",v("kbd",{children:"K"}),"; move it and press ",v("kbd",{children:"K"})," again; ",v("kbd",{children:"Space"})," plays."]}),!t&&n.keyframes.length>0&&v(ey,{}),!t&&n.keyframes.length>0&&v("ol",{class:"keyframes",children:n.keyframes.map(i=>v("li",{class:Math.abs(Ui.value-i.t)<1e-6?"here":"",children:[v("button",{type:"button",class:"keyframe-name",onClick:()=>{Ge({do:"keyframe",op:"goto",keyframe:i.id})},children:i.label||i.id}),v("label",{class:"field",children:[v(dr,{value:i.t,kind:"plain",label:`Time of keyframe ${i.label}`,onCommit:s=>{Ge({do:"keyframe",op:"move",keyframe:i.id,t:s.replace(/s$/,"")})}})," s"]}),v("button",{type:"button",class:"text-button",title:"Takes the present posture",onClick:()=>{Ge({do:"keyframe",op:"set",keyframe:i.id})},children:"Set"}),v(yt,{icon:"close",label:`Remove keyframe ${i.label}`,onClick:()=>{Ge({do:"keyframe",op:"remove",keyframe:i.id})}})]},i.id))})]})}function oy(n){const e=n.trim().replace(/^[^[{]*[[{]/,"").replace(/[\]}].*$/s,"").replace(/^\((.*)\)$/s,"$1");return(/[,;\t\n]/.test(e)?e.split(/[,;\t\n]+/):e.split(/\s+/)).map(i=>i.trim()).filter(i=>i!=="")}async function tg(n){const e=rn.value?.joints??[],t=oy(n);if(t.length!==e.length){const s=n.trim().slice(0,40);return gn(`${s===""?"The clipboard is empty":`"${s}" has ${t.length} value${t.length===1?"":"s"}`}: ${e.length} were expected, one for each joint, as in ${e.map(()=>"0").join(", ")}`)}const i=t.map((s,r)=>l_(s,yo(e[r]),_t.value));await Ge({do:"joints",q:i})!==void 0&&gn("Joint values pasted","note")}function ng(){const n=navigator.clipboard?.readText();if(!n)return gn("The clipboard is closed to this page: press Ctrl+V over the view instead");n.then(tg,()=>gn("The clipboard is closed to this page: press Ctrl+V over the view instead"))}function ay(){addEventListener("paste",n=>{const e=n.target instanceof HTMLElement&&n.target.closest("input:not([type=range]), textarea, .cm-editor, dialog"),t=n.clipboardData?.getData("text/plain");e||t===void 0||(n.preventDefault(),tg(t))})}const $c=Math.PI/180,ly=.04,cy=new wr(n=>bi.send(n),()=>{},n=>gn(n.message));function uy({joint:n,index:e}){const t=ui(""),i=yo(n),s=uc.value[e]??0,{lower:r,upper:o}=n,a=o-r,l=i==="angle"?.1*$c:5e-4,c=!n.unlimited&&Math.min(s-r,o-s)<ly*a,u=ns.value?.over_limit[e]??!1,h=ui({value:s,at:0}),f=m=>{h.current={value:m,at:performance.now()},cy.push({do:"joint",joint:e,value:m,gesture:t.current})},d=m=>{const p={ArrowUp:1,ArrowRight:1,ArrowDown:-1,ArrowLeft:-1}[m.key];if(p===void 0)return;m.preventDefault(),m.stopPropagation(),m.repeat||(t.current=Tr(`key-${e}`));const S=performance.now()-h.current.at<200?h.current.value:s,w=m.shiftKey?10:m.altKey?.1:1;f(Math.min(o,Math.max(r,S+p*w*(i==="angle"?$c:.001))))},_=i==="angle"?[-90,-45,0,45,90].map(m=>m*$c).filter(m=>m>r&&m<o):r<0&&o>0?[0]:[],x=n.unlimited?"no limits":`limits ${Ws(r,i,_t.value)} to ${Ws(o,i,_t.value)}`;return v("li",{class:`joint ${u?"over":c?"near":""}`,children:[v("button",{type:"button",class:"joint-name",title:`${n.name}: ${x}. Double-click for zero.`,onDblClick:()=>{Ge({do:"joint",joint:e,value:0})},"aria-label":`${n.label}, ${n.name}, ${x}`,children:n.label}),v("span",{class:"track",children:[v("input",{type:"range",min:r,max:o,step:l,value:s,"aria-label":`${n.label} slider`,"aria-valuetext":`${n.label}, ${B0(s,i)}, ${u?"over its limit":c?"near its limit":x}`,onPointerDown:()=>t.current=Tr(`slider-${e}`),onKeyDown:d,onInput:m=>f(Number(m.currentTarget.value))}),v("svg",{class:"ticks",viewBox:"0 0 100 4",preserveAspectRatio:"none","aria-hidden":"true",children:_.map(m=>{const p=100*(m-r)/a;return v("line",{x1:p,x2:p,y1:"0",y2:"4"},m)})})]}),v(dr,{value:s,kind:i,label:`${n.label} value`,onCommit:m=>{Ge({do:"joint",joint:e,value:m})}}),v("span",{class:"joint-state",title:u?"over its limit":c?"near its limit":"",children:(u||c)&&v(Ei,{name:"warn"})})]})}function hy(){const n=rn.value?.joints??[],e=ns.value?.unlocked??!1,t=()=>{const i=Array.from(uc.value,(s,r)=>Ws(s,yo(n[r]),_t.value)).join(", ");navigator.clipboard?.writeText(i).then(()=>gn("Joint values copied","note"),()=>gn("The clipboard is closed to this page"))};return v("section",{"aria-label":"Joints",children:[v("ul",{class:"joints",children:n.map((i,s)=>v(uy,{joint:i,index:s},`${rn.value?.revision}-${s}`))}),e&&v("p",{class:"banner",children:[v(Ei,{name:"warn"})," Limits are unlocked: joints may go where the arm cannot."]}),v("div",{class:"buttons",children:[v(yt,{icon:"home",label:"Home",keys:"H",text:"Home",onClick:()=>{Ge({do:"named",to:"home"})}}),v(yt,{icon:"fit",label:"Zero",keys:"0",text:"Zero",onClick:()=>{Ge({do:"named",to:"zero"})}}),v(yt,{icon:"dice",label:"Random posture within the limits",text:"Random",onClick:()=>{Ge({do:"named",to:"random"})}}),v(yt,{icon:"copy",label:"Copy the joint values",text:"Copy",onClick:t}),v(yt,{icon:"paste",label:"Paste joint values, as Copy or a table gives them",keys:"Ctrl+V",text:"Paste",onClick:ng}),v(yt,{icon:e?"unlock":"lock",label:e?"Lock the limits":"Unlock the limits",pressed:e,onClick:()=>{Ge({do:"unlock",on:!e})},text:"Limits"})]}),v("button",{type:"button",class:"link",onClick:()=>{Ge({do:"set_home"}).then(()=>gn("This posture is home now","note"))},children:"Make this posture home"})]})}const vf="180",fo={ROTATE:0,DOLLY:1,PAN:2},oo={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},fy=0,up=1,dy=2,ig=1,sg=2,hs=3,ys=0,ei=1,Fi=2,Hs=0,po=1,hp=2,fp=3,dp=4,py=5,mr=100,my=101,_y=102,gy=103,vy=104,xy=200,yy=201,My=202,Sy=203,Qu=204,eh=205,Ey=206,by=207,wy=208,Ty=209,Ay=210,Ry=211,Cy=212,Py=213,Dy=214,th=0,nh=1,ih=2,wo=3,sh=4,rh=5,oh=6,ah=7,xf=0,Ly=1,Iy=2,Vs=0,Uy=1,Ny=2,Fy=3,rg=4,Oy=5,ky=6,By=7,og=300,To=301,Ao=302,lh=303,ch=304,yc=306,uh=1e3,xr=1001,hh=1002,qn=1003,zy=1004,Ka=1005,Ki=1006,jc=1007,yr=1008,es=1009,ag=1010,lg=1011,Ta=1012,yf=1013,Rr=1014,Zi=1015,Ia=1016,Mf=1017,Sf=1018,Aa=1020,cg=35902,ug=35899,hg=1021,fg=1022,ki=1023,Ra=1026,Ca=1027,Ef=1028,bf=1029,dg=1030,wf=1031,Tf=1033,Ll=33776,Il=33777,Ul=33778,Nl=33779,fh=35840,dh=35841,ph=35842,mh=35843,_h=36196,gh=37492,vh=37496,xh=37808,yh=37809,Mh=37810,Sh=37811,Eh=37812,bh=37813,wh=37814,Th=37815,Ah=37816,Rh=37817,Ch=37818,Ph=37819,Dh=37820,Lh=37821,Ih=36492,Uh=36494,Nh=36495,Fh=36283,Oh=36284,kh=36285,Bh=36286,Hy=3200,Vy=3201,Af=0,Gy=1,Bs="",yi="srgb",Ro="srgb-linear",tc="linear",It="srgb",Wr=7680,pp=519,Wy=512,Xy=513,Yy=514,pg=515,qy=516,$y=517,jy=518,Ky=519,mp=35044,Zy=35048,_p="300 es",Ji=2e3,nc=2001;class Dr{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});const i=this._listeners;i[e]===void 0&&(i[e]=[]),i[e].indexOf(t)===-1&&i[e].push(t)}hasEventListener(e,t){const i=this._listeners;return i===void 0?!1:i[e]!==void 0&&i[e].indexOf(t)!==-1}removeEventListener(e,t){const i=this._listeners;if(i===void 0)return;const s=i[e];if(s!==void 0){const r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){const t=this._listeners;if(t===void 0)return;const i=t[e.type];if(i!==void 0){e.target=this;const s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}}const Un=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],Fl=Math.PI/180,zh=180/Math.PI;function Ua(){const n=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(Un[n&255]+Un[n>>8&255]+Un[n>>16&255]+Un[n>>24&255]+"-"+Un[e&255]+Un[e>>8&255]+"-"+Un[e>>16&15|64]+Un[e>>24&255]+"-"+Un[t&63|128]+Un[t>>8&255]+"-"+Un[t>>16&255]+Un[t>>24&255]+Un[i&255]+Un[i>>8&255]+Un[i>>16&255]+Un[i>>24&255]).toLowerCase()}function ft(n,e,t){return Math.max(e,Math.min(t,n))}function Jy(n,e){return(n%e+e)%e}function Kc(n,e,t){return(1-t)*n+t*e}function $o(n,e){switch(e.constructor){case Float32Array:return n;case Uint32Array:return n/4294967295;case Uint16Array:return n/65535;case Uint8Array:return n/255;case Int32Array:return Math.max(n/2147483647,-1);case Int16Array:return Math.max(n/32767,-1);case Int8Array:return Math.max(n/127,-1);default:throw new Error("Invalid component type.")}}function Jn(n,e){switch(e.constructor){case Float32Array:return n;case Uint32Array:return Math.round(n*4294967295);case Uint16Array:return Math.round(n*65535);case Uint8Array:return Math.round(n*255);case Int32Array:return Math.round(n*2147483647);case Int16Array:return Math.round(n*32767);case Int8Array:return Math.round(n*127);default:throw new Error("Invalid component type.")}}const Qy={DEG2RAD:Fl};class Ke{constructor(e=0,t=0){Ke.prototype.isVector2=!0,this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){const t=this.x,i=this.y,s=e.elements;return this.x=s[0]*t+s[3]*i+s[6],this.y=s[1]*t+s[4]*i+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=ft(this.x,e.x,t.x),this.y=ft(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=ft(this.x,e,t),this.y=ft(this.y,e,t),this}clampLength(e,t){const i=this.length();return this.divideScalar(i||1).multiplyScalar(ft(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){const t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;const i=this.dot(e)/t;return Math.acos(ft(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){const t=this.x-e.x,i=this.y-e.y;return t*t+i*i}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){const i=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*i-o*s+e.x,this.y=r*s+o*i+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}}class _n{constructor(e=0,t=0,i=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=i,this._w=s}static slerpFlat(e,t,i,s,r,o,a){let l=i[s+0],c=i[s+1],u=i[s+2],h=i[s+3];const f=r[o+0],d=r[o+1],_=r[o+2],x=r[o+3];if(a===0){e[t+0]=l,e[t+1]=c,e[t+2]=u,e[t+3]=h;return}if(a===1){e[t+0]=f,e[t+1]=d,e[t+2]=_,e[t+3]=x;return}if(h!==x||l!==f||c!==d||u!==_){let m=1-a;const p=l*f+c*d+u*_+h*x,S=p>=0?1:-1,w=1-p*p;if(w>Number.EPSILON){const L=Math.sqrt(w),R=Math.atan2(L,p*S);m=Math.sin(m*R)/L,a=Math.sin(a*R)/L}const y=a*S;if(l=l*m+f*y,c=c*m+d*y,u=u*m+_*y,h=h*m+x*y,m===1-a){const L=1/Math.sqrt(l*l+c*c+u*u+h*h);l*=L,c*=L,u*=L,h*=L}}e[t]=l,e[t+1]=c,e[t+2]=u,e[t+3]=h}static multiplyQuaternionsFlat(e,t,i,s,r,o){const a=i[s],l=i[s+1],c=i[s+2],u=i[s+3],h=r[o],f=r[o+1],d=r[o+2],_=r[o+3];return e[t]=a*_+u*h+l*d-c*f,e[t+1]=l*_+u*f+c*h-a*d,e[t+2]=c*_+u*d+a*f-l*h,e[t+3]=u*_-a*h-l*f-c*d,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,i,s){return this._x=e,this._y=t,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){const i=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(i/2),u=a(s/2),h=a(r/2),f=l(i/2),d=l(s/2),_=l(r/2);switch(o){case"XYZ":this._x=f*u*h+c*d*_,this._y=c*d*h-f*u*_,this._z=c*u*_+f*d*h,this._w=c*u*h-f*d*_;break;case"YXZ":this._x=f*u*h+c*d*_,this._y=c*d*h-f*u*_,this._z=c*u*_-f*d*h,this._w=c*u*h+f*d*_;break;case"ZXY":this._x=f*u*h-c*d*_,this._y=c*d*h+f*u*_,this._z=c*u*_+f*d*h,this._w=c*u*h-f*d*_;break;case"ZYX":this._x=f*u*h-c*d*_,this._y=c*d*h+f*u*_,this._z=c*u*_-f*d*h,this._w=c*u*h+f*d*_;break;case"YZX":this._x=f*u*h+c*d*_,this._y=c*d*h+f*u*_,this._z=c*u*_-f*d*h,this._w=c*u*h-f*d*_;break;case"XZY":this._x=f*u*h-c*d*_,this._y=c*d*h-f*u*_,this._z=c*u*_+f*d*h,this._w=c*u*h+f*d*_;break;default:console.warn("THREE.Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){const i=t/2,s=Math.sin(i);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(e){const t=e.elements,i=t[0],s=t[4],r=t[8],o=t[1],a=t[5],l=t[9],c=t[2],u=t[6],h=t[10],f=i+a+h;if(f>0){const d=.5/Math.sqrt(f+1);this._w=.25/d,this._x=(u-l)*d,this._y=(r-c)*d,this._z=(o-s)*d}else if(i>a&&i>h){const d=2*Math.sqrt(1+i-a-h);this._w=(u-l)/d,this._x=.25*d,this._y=(s+o)/d,this._z=(r+c)/d}else if(a>h){const d=2*Math.sqrt(1+a-i-h);this._w=(r-c)/d,this._x=(s+o)/d,this._y=.25*d,this._z=(l+u)/d}else{const d=2*Math.sqrt(1+h-i-a);this._w=(o-s)/d,this._x=(r+c)/d,this._y=(l+u)/d,this._z=.25*d}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let i=e.dot(t)+1;return i<1e-8?(i=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=i):(this._x=0,this._y=-e.z,this._z=e.y,this._w=i)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=i),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(ft(this.dot(e),-1,1)))}rotateTowards(e,t){const i=this.angleTo(e);if(i===0)return this;const s=Math.min(1,t/i);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){const i=e._x,s=e._y,r=e._z,o=e._w,a=t._x,l=t._y,c=t._z,u=t._w;return this._x=i*u+o*a+s*c-r*l,this._y=s*u+o*l+r*a-i*c,this._z=r*u+o*c+i*l-s*a,this._w=o*u-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){if(t===0)return this;if(t===1)return this.copy(e);const i=this._x,s=this._y,r=this._z,o=this._w;let a=o*e._w+i*e._x+s*e._y+r*e._z;if(a<0?(this._w=-e._w,this._x=-e._x,this._y=-e._y,this._z=-e._z,a=-a):this.copy(e),a>=1)return this._w=o,this._x=i,this._y=s,this._z=r,this;const l=1-a*a;if(l<=Number.EPSILON){const d=1-t;return this._w=d*o+t*this._w,this._x=d*i+t*this._x,this._y=d*s+t*this._y,this._z=d*r+t*this._z,this.normalize(),this}const c=Math.sqrt(l),u=Math.atan2(c,a),h=Math.sin((1-t)*u)/c,f=Math.sin(t*u)/c;return this._w=o*h+this._w*f,this._x=i*h+this._x*f,this._y=s*h+this._y*f,this._z=r*h+this._z*f,this._onChangeCallback(),this}slerpQuaternions(e,t,i){return this.copy(e).slerp(t,i)}random(){const e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}}class k{constructor(e=0,t=0,i=0){k.prototype.isVector3=!0,this.x=e,this.y=t,this.z=i}set(e,t,i){return i===void 0&&(i=this.z),this.x=e,this.y=t,this.z=i,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(gp.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(gp.setFromAxisAngle(e,t))}applyMatrix3(e){const t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*i+r[6]*s,this.y=r[1]*t+r[4]*i+r[7]*s,this.z=r[2]*t+r[5]*i+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){const t=this.x,i=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(e){const t=this.x,i=this.y,s=this.z,r=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*s-a*i),u=2*(a*t-r*s),h=2*(r*i-o*t);return this.x=t+l*c+o*h-a*u,this.y=i+l*u+a*c-r*h,this.z=s+l*h+r*u-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){const t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*i+r[8]*s,this.y=r[1]*t+r[5]*i+r[9]*s,this.z=r[2]*t+r[6]*i+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=ft(this.x,e.x,t.x),this.y=ft(this.y,e.y,t.y),this.z=ft(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=ft(this.x,e,t),this.y=ft(this.y,e,t),this.z=ft(this.z,e,t),this}clampLength(e,t){const i=this.length();return this.divideScalar(i||1).multiplyScalar(ft(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){const i=e.x,s=e.y,r=e.z,o=t.x,a=t.y,l=t.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(e){const t=e.lengthSq();if(t===0)return this.set(0,0,0);const i=e.dot(this)/t;return this.copy(e).multiplyScalar(i)}projectOnPlane(e){return Zc.copy(this).projectOnVector(e),this.sub(Zc)}reflect(e){return this.sub(Zc.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){const t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;const i=this.dot(e)/t;return Math.acos(ft(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){const t=this.x-e.x,i=this.y-e.y,s=this.z-e.z;return t*t+i*i+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,i){const s=Math.sin(t)*e;return this.x=s*Math.sin(i),this.y=Math.cos(t)*e,this.z=s*Math.cos(i),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,i){return this.x=e*Math.sin(t),this.y=i,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){const t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){const t=this.setFromMatrixColumn(e,0).length(),i=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=i,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){const e=Math.random()*Math.PI*2,t=Math.random()*2-1,i=Math.sqrt(1-t*t);return this.x=i*Math.cos(e),this.y=t,this.z=i*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}}const Zc=new k,gp=new _n;class lt{constructor(e,t,i,s,r,o,a,l,c){lt.prototype.isMatrix3=!0,this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c)}set(e,t,i,s,r,o,a,l,c){const u=this.elements;return u[0]=e,u[1]=s,u[2]=a,u[3]=t,u[4]=r,u[5]=l,u[6]=i,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){const t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],this}extractBasis(e,t,i){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(e){const t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){const i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],u=i[4],h=i[7],f=i[2],d=i[5],_=i[8],x=s[0],m=s[3],p=s[6],S=s[1],w=s[4],y=s[7],L=s[2],R=s[5],U=s[8];return r[0]=o*x+a*S+l*L,r[3]=o*m+a*w+l*R,r[6]=o*p+a*y+l*U,r[1]=c*x+u*S+h*L,r[4]=c*m+u*w+h*R,r[7]=c*p+u*y+h*U,r[2]=f*x+d*S+_*L,r[5]=f*m+d*w+_*R,r[8]=f*p+d*y+_*U,this}multiplyScalar(e){const t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){const e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8];return t*o*u-t*a*c-i*r*u+i*a*l+s*r*c-s*o*l}invert(){const e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],h=u*o-a*c,f=a*l-u*r,d=c*r-o*l,_=t*h+i*f+s*d;if(_===0)return this.set(0,0,0,0,0,0,0,0,0);const x=1/_;return e[0]=h*x,e[1]=(s*c-u*i)*x,e[2]=(a*i-s*o)*x,e[3]=f*x,e[4]=(u*t-s*l)*x,e[5]=(s*r-a*t)*x,e[6]=d*x,e[7]=(i*l-c*t)*x,e[8]=(o*t-i*r)*x,this}transpose(){let e;const t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){const t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,i,s,r,o,a){const l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+e,-s*c,s*l,-s*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return this.premultiply(Jc.makeScale(e,t)),this}rotate(e){return this.premultiply(Jc.makeRotation(-e)),this}translate(e,t){return this.premultiply(Jc.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){const t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,i,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){const t=this.elements,i=e.elements;for(let s=0;s<9;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<9;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){const i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e}clone(){return new this.constructor().fromArray(this.elements)}}const Jc=new lt;function mg(n){for(let e=n.length-1;e>=0;--e)if(n[e]>=65535)return!0;return!1}function ic(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function eM(){const n=ic("canvas");return n.style.display="block",n}const vp={};function Pa(n){n in vp||(vp[n]=!0,console.warn(n))}function tM(n,e,t){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(e,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:i()}}setTimeout(r,t)})}const xp=new lt().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),yp=new lt().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function nM(){const n={enabled:!0,workingColorSpace:Ro,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===It&&(s.r=ms(s.r),s.g=ms(s.g),s.b=ms(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===It&&(s.r=mo(s.r),s.g=mo(s.g),s.b=mo(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Bs?tc:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[r].toXYZ).multiply(this.spaces[o].fromXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace},fromWorkingColorSpace:function(s,r){return Pa("THREE.ColorManagement: .fromWorkingColorSpace() has been renamed to .workingToColorSpace()."),n.workingToColorSpace(s,r)},toWorkingColorSpace:function(s,r){return Pa("THREE.ColorManagement: .toWorkingColorSpace() has been renamed to .colorSpaceToWorking()."),n.colorSpaceToWorking(s,r)}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[Ro]:{primaries:e,whitePoint:i,transfer:tc,toXYZ:xp,fromXYZ:yp,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:yi},outputColorSpaceConfig:{drawingBufferColorSpace:yi}},[yi]:{primaries:e,whitePoint:i,transfer:It,toXYZ:xp,fromXYZ:yp,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:yi}}}),n}const Mt=nM();function ms(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function mo(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}let Xr;class iM{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let i;if(e instanceof HTMLCanvasElement)i=e;else{Xr===void 0&&(Xr=ic("canvas")),Xr.width=e.width,Xr.height=e.height;const s=Xr.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),i=Xr}return i.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){const t=ic("canvas");t.width=e.width,t.height=e.height;const i=t.getContext("2d");i.drawImage(e,0,0,e.width,e.height);const s=i.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=ms(r[o]/255)*255;return i.putImageData(s,0,0),t}else if(e.data){const t=e.data.slice(0);for(let i=0;i<t.length;i++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[i]=Math.floor(ms(t[i]/255)*255):t[i]=ms(t[i]);return{data:t,width:e.width,height:e.height}}else return console.warn("THREE.ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}}let sM=0;class Rf{constructor(e=null){this.isSource=!0,Object.defineProperty(this,"id",{value:sM++}),this.uuid=Ua(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){const t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):t instanceof VideoFrame?e.set(t.displayHeight,t.displayWidth,0):t!==null?e.set(t.width,t.height,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){const t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];const i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Qc(s[o].image)):r.push(Qc(s[o]))}else r=Qc(s);i.url=r}return t||(e.images[this.uuid]=i),i}}function Qc(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?iM.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(console.warn("THREE.Texture: Unable to serialize Texture."),{})}let rM=0;const eu=new k;class $n extends Dr{constructor(e=$n.DEFAULT_IMAGE,t=$n.DEFAULT_MAPPING,i=xr,s=xr,r=Ki,o=yr,a=ki,l=es,c=$n.DEFAULT_ANISOTROPY,u=Bs){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:rM++}),this.uuid=Ua(),this.name="",this.source=new Rf(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new Ke(0,0),this.repeat=new Ke(1,1),this.center=new Ke(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new lt,this.generateMipmaps=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0}get width(){return this.source.getSize(eu).x}get height(){return this.source.getSize(eu).y}get depth(){return this.source.getSize(eu).z}get image(){return this.source.data}set image(e=null){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(const t in e){const i=e[t];if(i===void 0){console.warn(`THREE.Texture.setValues(): parameter '${t}' has value of undefined.`);continue}const s=this[t];if(s===void 0){console.warn(`THREE.Texture.setValues(): property '${t}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[t]=i}}toJSON(e){const t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];const i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),t||(e.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==og)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case uh:e.x=e.x-Math.floor(e.x);break;case xr:e.x=e.x<0?0:1;break;case hh:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case uh:e.y=e.y-Math.floor(e.y);break;case xr:e.y=e.y<0?0:1;break;case hh:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}}$n.DEFAULT_IMAGE=null;$n.DEFAULT_MAPPING=og;$n.DEFAULT_ANISOTROPY=1;class tn{constructor(e=0,t=0,i=0,s=1){tn.prototype.isVector4=!0,this.x=e,this.y=t,this.z=i,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,i,s){return this.x=e,this.y=t,this.z=i,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){const t=this.x,i=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*i+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);const t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,i,s,r;const l=e.elements,c=l[0],u=l[4],h=l[8],f=l[1],d=l[5],_=l[9],x=l[2],m=l[6],p=l[10];if(Math.abs(u-f)<.01&&Math.abs(h-x)<.01&&Math.abs(_-m)<.01){if(Math.abs(u+f)<.1&&Math.abs(h+x)<.1&&Math.abs(_+m)<.1&&Math.abs(c+d+p-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;const w=(c+1)/2,y=(d+1)/2,L=(p+1)/2,R=(u+f)/4,U=(h+x)/4,N=(_+m)/4;return w>y&&w>L?w<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(w),s=R/i,r=U/i):y>L?y<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(y),i=R/s,r=N/s):L<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(L),i=U/r,s=N/r),this.set(i,s,r,t),this}let S=Math.sqrt((m-_)*(m-_)+(h-x)*(h-x)+(f-u)*(f-u));return Math.abs(S)<.001&&(S=1),this.x=(m-_)/S,this.y=(h-x)/S,this.z=(f-u)/S,this.w=Math.acos((c+d+p-1)/2),this}setFromMatrixPosition(e){const t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=ft(this.x,e.x,t.x),this.y=ft(this.y,e.y,t.y),this.z=ft(this.z,e.z,t.z),this.w=ft(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=ft(this.x,e,t),this.y=ft(this.y,e,t),this.z=ft(this.z,e,t),this.w=ft(this.w,e,t),this}clampLength(e,t){const i=this.length();return this.divideScalar(i||1).multiplyScalar(ft(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this.w=e.w+(t.w-e.w)*i,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}}class oM extends Dr{constructor(e=1,t=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Ki,depthBuffer:!0,stencilBuffer:!1,resolveDepthBuffer:!0,resolveStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1},i),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=i.depth,this.scissor=new tn(0,0,e,t),this.scissorTest=!1,this.viewport=new tn(0,0,e,t);const s={width:e,height:t,depth:i.depth},r=new $n(s);this.textures=[];const o=i.count;for(let a=0;a<o;a++)this.textures[a]=r.clone(),this.textures[a].isRenderTargetTexture=!0,this.textures[a].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview}_setTextureOptions(e={}){const t={minFilter:Ki,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&(this._depthTexture.renderTarget=null),e!==null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,i=1){if(this.width!==e||this.height!==t||this.depth!==i){this.width=e,this.height=t,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=i,this.textures[s].isArrayTexture=this.textures[s].image.depth>1;this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,i=e.textures.length;t<i;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;const s=Object.assign({},e.textures[t].image);this.textures[t].source=new Rf(s)}return this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,e.depthTexture!==null&&(this.depthTexture=e.depthTexture.clone()),this.samples=e.samples,this}dispose(){this.dispatchEvent({type:"dispose"})}}class Ys extends oM{constructor(e=1,t=1,i={}){super(e,t,i),this.isWebGLRenderTarget=!0}}class _g extends $n{constructor(e=null,t=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=qn,this.minFilter=qn,this.wrapR=xr,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}}class aM extends $n{constructor(e=null,t=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=qn,this.minFilter=qn,this.wrapR=xr,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}}class qs{constructor(e=new k(1/0,1/0,1/0),t=new k(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t+=3)this.expandByPoint(Ci.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,i=e.count;t<i;t++)this.expandByPoint(Ci.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){const i=Ci.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(i),this.max.copy(e).add(i),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);const i=e.geometry;if(i!==void 0){const r=i.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,Ci):Ci.fromBufferAttribute(r,o),Ci.applyMatrix4(e.matrixWorld),this.expandByPoint(Ci);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),Za.copy(e.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),Za.copy(i.boundingBox)),Za.applyMatrix4(e.matrixWorld),this.union(Za)}const s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,Ci),Ci.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,i;return e.normal.x>0?(t=e.normal.x*this.min.x,i=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,i=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,i+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,i+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,i+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,i+=e.normal.z*this.min.z),t<=-e.constant&&i>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(jo),Ja.subVectors(this.max,jo),Yr.subVectors(e.a,jo),qr.subVectors(e.b,jo),$r.subVectors(e.c,jo),Cs.subVectors(qr,Yr),Ps.subVectors($r,qr),tr.subVectors(Yr,$r);let t=[0,-Cs.z,Cs.y,0,-Ps.z,Ps.y,0,-tr.z,tr.y,Cs.z,0,-Cs.x,Ps.z,0,-Ps.x,tr.z,0,-tr.x,-Cs.y,Cs.x,0,-Ps.y,Ps.x,0,-tr.y,tr.x,0];return!tu(t,Yr,qr,$r,Ja)||(t=[1,0,0,0,1,0,0,0,1],!tu(t,Yr,qr,$r,Ja))?!1:(Qa.crossVectors(Cs,Ps),t=[Qa.x,Qa.y,Qa.z],tu(t,Yr,qr,$r,Ja))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,Ci).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(Ci).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(os[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),os[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),os[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),os[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),os[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),os[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),os[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),os[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(os),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}}const os=[new k,new k,new k,new k,new k,new k,new k,new k],Ci=new k,Za=new qs,Yr=new k,qr=new k,$r=new k,Cs=new k,Ps=new k,tr=new k,jo=new k,Ja=new k,Qa=new k,nr=new k;function tu(n,e,t,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){nr.fromArray(n,r);const a=s.x*Math.abs(nr.x)+s.y*Math.abs(nr.y)+s.z*Math.abs(nr.z),l=e.dot(nr),c=t.dot(nr),u=i.dot(nr);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}const lM=new qs,Ko=new k,nu=new k;class Lr{constructor(e=new k,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){const i=this.center;t!==void 0?i.copy(t):lM.setFromPoints(e).getCenter(i);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,i.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){const t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){const i=this.center.distanceToSquared(e);return t.copy(e),i>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;Ko.subVectors(e,this.center);const t=Ko.lengthSq();if(t>this.radius*this.radius){const i=Math.sqrt(t),s=(i-this.radius)*.5;this.center.addScaledVector(Ko,s/i),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(nu.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(Ko.copy(e.center).add(nu)),this.expandByPoint(Ko.copy(e.center).sub(nu))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}}const as=new k,iu=new k,el=new k,Ds=new k,su=new k,tl=new k,ru=new k;class Mc{constructor(e=new k,t=new k(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,as)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);const i=t.dot(this.direction);return i<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){const t=as.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(as.copy(this.origin).addScaledVector(this.direction,t),as.distanceToSquared(e))}distanceSqToSegment(e,t,i,s){iu.copy(e).add(t).multiplyScalar(.5),el.copy(t).sub(e).normalize(),Ds.copy(this.origin).sub(iu);const r=e.distanceTo(t)*.5,o=-this.direction.dot(el),a=Ds.dot(this.direction),l=-Ds.dot(el),c=Ds.lengthSq(),u=Math.abs(1-o*o);let h,f,d,_;if(u>0)if(h=o*l-a,f=o*a-l,_=r*u,h>=0)if(f>=-_)if(f<=_){const x=1/u;h*=x,f*=x,d=h*(h+o*f+2*a)+f*(o*h+f+2*l)+c}else f=r,h=Math.max(0,-(o*f+a)),d=-h*h+f*(f+2*l)+c;else f=-r,h=Math.max(0,-(o*f+a)),d=-h*h+f*(f+2*l)+c;else f<=-_?(h=Math.max(0,-(-o*r+a)),f=h>0?-r:Math.min(Math.max(-r,-l),r),d=-h*h+f*(f+2*l)+c):f<=_?(h=0,f=Math.min(Math.max(-r,-l),r),d=f*(f+2*l)+c):(h=Math.max(0,-(o*r+a)),f=h>0?r:Math.min(Math.max(-r,-l),r),d=-h*h+f*(f+2*l)+c);else f=o>0?-r:r,h=Math.max(0,-(o*f+a)),d=-h*h+f*(f+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,h),s&&s.copy(iu).addScaledVector(el,f),d}intersectSphere(e,t){as.subVectors(e.center,this.origin);const i=as.dot(this.direction),s=as.dot(as)-i*i,r=e.radius*e.radius;if(s>r)return null;const o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){const t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;const i=-(this.origin.dot(e.normal)+e.constant)/t;return i>=0?i:null}intersectPlane(e,t){const i=this.distanceToPlane(e);return i===null?null:this.at(i,t)}intersectsPlane(e){const t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let i,s,r,o,a,l;const c=1/this.direction.x,u=1/this.direction.y,h=1/this.direction.z,f=this.origin;return c>=0?(i=(e.min.x-f.x)*c,s=(e.max.x-f.x)*c):(i=(e.max.x-f.x)*c,s=(e.min.x-f.x)*c),u>=0?(r=(e.min.y-f.y)*u,o=(e.max.y-f.y)*u):(r=(e.max.y-f.y)*u,o=(e.min.y-f.y)*u),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),h>=0?(a=(e.min.z-f.z)*h,l=(e.max.z-f.z)*h):(a=(e.max.z-f.z)*h,l=(e.min.z-f.z)*h),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,t)}intersectsBox(e){return this.intersectBox(e,as)!==null}intersectTriangle(e,t,i,s,r){su.subVectors(t,e),tl.subVectors(i,e),ru.crossVectors(su,tl);let o=this.direction.dot(ru),a;if(o>0){if(s)return null;a=1}else if(o<0)a=-1,o=-o;else return null;Ds.subVectors(this.origin,e);const l=a*this.direction.dot(tl.crossVectors(Ds,tl));if(l<0)return null;const c=a*this.direction.dot(su.cross(Ds));if(c<0||l+c>o)return null;const u=-a*Ds.dot(ru);return u<0?null:this.at(u/o,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}}class Pt{constructor(e,t,i,s,r,o,a,l,c,u,h,f,d,_,x,m){Pt.prototype.isMatrix4=!0,this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c,u,h,f,d,_,x,m)}set(e,t,i,s,r,o,a,l,c,u,h,f,d,_,x,m){const p=this.elements;return p[0]=e,p[4]=t,p[8]=i,p[12]=s,p[1]=r,p[5]=o,p[9]=a,p[13]=l,p[2]=c,p[6]=u,p[10]=h,p[14]=f,p[3]=d,p[7]=_,p[11]=x,p[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new Pt().fromArray(this.elements)}copy(e){const t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],t[9]=i[9],t[10]=i[10],t[11]=i[11],t[12]=i[12],t[13]=i[13],t[14]=i[14],t[15]=i[15],this}copyPosition(e){const t=this.elements,i=e.elements;return t[12]=i[12],t[13]=i[13],t[14]=i[14],this}setFromMatrix3(e){const t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,i){return e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this}makeBasis(e,t,i){return this.set(e.x,t.x,i.x,0,e.y,t.y,i.y,0,e.z,t.z,i.z,0,0,0,0,1),this}extractRotation(e){const t=this.elements,i=e.elements,s=1/jr.setFromMatrixColumn(e,0).length(),r=1/jr.setFromMatrixColumn(e,1).length(),o=1/jr.setFromMatrixColumn(e,2).length();return t[0]=i[0]*s,t[1]=i[1]*s,t[2]=i[2]*s,t[3]=0,t[4]=i[4]*r,t[5]=i[5]*r,t[6]=i[6]*r,t[7]=0,t[8]=i[8]*o,t[9]=i[9]*o,t[10]=i[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){const t=this.elements,i=e.x,s=e.y,r=e.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),h=Math.sin(r);if(e.order==="XYZ"){const f=o*u,d=o*h,_=a*u,x=a*h;t[0]=l*u,t[4]=-l*h,t[8]=c,t[1]=d+_*c,t[5]=f-x*c,t[9]=-a*l,t[2]=x-f*c,t[6]=_+d*c,t[10]=o*l}else if(e.order==="YXZ"){const f=l*u,d=l*h,_=c*u,x=c*h;t[0]=f+x*a,t[4]=_*a-d,t[8]=o*c,t[1]=o*h,t[5]=o*u,t[9]=-a,t[2]=d*a-_,t[6]=x+f*a,t[10]=o*l}else if(e.order==="ZXY"){const f=l*u,d=l*h,_=c*u,x=c*h;t[0]=f-x*a,t[4]=-o*h,t[8]=_+d*a,t[1]=d+_*a,t[5]=o*u,t[9]=x-f*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){const f=o*u,d=o*h,_=a*u,x=a*h;t[0]=l*u,t[4]=_*c-d,t[8]=f*c+x,t[1]=l*h,t[5]=x*c+f,t[9]=d*c-_,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){const f=o*l,d=o*c,_=a*l,x=a*c;t[0]=l*u,t[4]=x-f*h,t[8]=_*h+d,t[1]=h,t[5]=o*u,t[9]=-a*u,t[2]=-c*u,t[6]=d*h+_,t[10]=f-x*h}else if(e.order==="XZY"){const f=o*l,d=o*c,_=a*l,x=a*c;t[0]=l*u,t[4]=-h,t[8]=c*u,t[1]=f*h+x,t[5]=o*u,t[9]=d*h-_,t[2]=_*h-d,t[6]=a*u,t[10]=x*h+f}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(cM,e,uM)}lookAt(e,t,i){const s=this.elements;return ri.subVectors(e,t),ri.lengthSq()===0&&(ri.z=1),ri.normalize(),Ls.crossVectors(i,ri),Ls.lengthSq()===0&&(Math.abs(i.z)===1?ri.x+=1e-4:ri.z+=1e-4,ri.normalize(),Ls.crossVectors(i,ri)),Ls.normalize(),nl.crossVectors(ri,Ls),s[0]=Ls.x,s[4]=nl.x,s[8]=ri.x,s[1]=Ls.y,s[5]=nl.y,s[9]=ri.y,s[2]=Ls.z,s[6]=nl.z,s[10]=ri.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){const i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],u=i[1],h=i[5],f=i[9],d=i[13],_=i[2],x=i[6],m=i[10],p=i[14],S=i[3],w=i[7],y=i[11],L=i[15],R=s[0],U=s[4],N=s[8],T=s[12],b=s[1],C=s[5],B=s[9],z=s[13],X=s[2],W=s[6],q=s[10],j=s[14],Z=s[3],re=s[7],ae=s[11],me=s[15];return r[0]=o*R+a*b+l*X+c*Z,r[4]=o*U+a*C+l*W+c*re,r[8]=o*N+a*B+l*q+c*ae,r[12]=o*T+a*z+l*j+c*me,r[1]=u*R+h*b+f*X+d*Z,r[5]=u*U+h*C+f*W+d*re,r[9]=u*N+h*B+f*q+d*ae,r[13]=u*T+h*z+f*j+d*me,r[2]=_*R+x*b+m*X+p*Z,r[6]=_*U+x*C+m*W+p*re,r[10]=_*N+x*B+m*q+p*ae,r[14]=_*T+x*z+m*j+p*me,r[3]=S*R+w*b+y*X+L*Z,r[7]=S*U+w*C+y*W+L*re,r[11]=S*N+w*B+y*q+L*ae,r[15]=S*T+w*z+y*j+L*me,this}multiplyScalar(e){const t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){const e=this.elements,t=e[0],i=e[4],s=e[8],r=e[12],o=e[1],a=e[5],l=e[9],c=e[13],u=e[2],h=e[6],f=e[10],d=e[14],_=e[3],x=e[7],m=e[11],p=e[15];return _*(+r*l*h-s*c*h-r*a*f+i*c*f+s*a*d-i*l*d)+x*(+t*l*d-t*c*f+r*o*f-s*o*d+s*c*u-r*l*u)+m*(+t*c*h-t*a*d-r*o*h+i*o*d+r*a*u-i*c*u)+p*(-s*a*u-t*l*h+t*a*f+s*o*h-i*o*f+i*l*u)}transpose(){const e=this.elements;let t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,i){const s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=i),this}invert(){const e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],h=e[9],f=e[10],d=e[11],_=e[12],x=e[13],m=e[14],p=e[15],S=h*m*c-x*f*c+x*l*d-a*m*d-h*l*p+a*f*p,w=_*f*c-u*m*c-_*l*d+o*m*d+u*l*p-o*f*p,y=u*x*c-_*h*c+_*a*d-o*x*d-u*a*p+o*h*p,L=_*h*l-u*x*l-_*a*f+o*x*f+u*a*m-o*h*m,R=t*S+i*w+s*y+r*L;if(R===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);const U=1/R;return e[0]=S*U,e[1]=(x*f*r-h*m*r-x*s*d+i*m*d+h*s*p-i*f*p)*U,e[2]=(a*m*r-x*l*r+x*s*c-i*m*c-a*s*p+i*l*p)*U,e[3]=(h*l*r-a*f*r-h*s*c+i*f*c+a*s*d-i*l*d)*U,e[4]=w*U,e[5]=(u*m*r-_*f*r+_*s*d-t*m*d-u*s*p+t*f*p)*U,e[6]=(_*l*r-o*m*r-_*s*c+t*m*c+o*s*p-t*l*p)*U,e[7]=(o*f*r-u*l*r+u*s*c-t*f*c-o*s*d+t*l*d)*U,e[8]=y*U,e[9]=(_*h*r-u*x*r-_*i*d+t*x*d+u*i*p-t*h*p)*U,e[10]=(o*x*r-_*a*r+_*i*c-t*x*c-o*i*p+t*a*p)*U,e[11]=(u*a*r-o*h*r-u*i*c+t*h*c+o*i*d-t*a*d)*U,e[12]=L*U,e[13]=(u*x*s-_*h*s+_*i*f-t*x*f-u*i*m+t*h*m)*U,e[14]=(_*a*s-o*x*s-_*i*l+t*x*l+o*i*m-t*a*m)*U,e[15]=(o*h*s-u*a*s+u*i*l-t*h*l-o*i*f+t*a*f)*U,this}scale(e){const t=this.elements,i=e.x,s=e.y,r=e.z;return t[0]*=i,t[4]*=s,t[8]*=r,t[1]*=i,t[5]*=s,t[9]*=r,t[2]*=i,t[6]*=s,t[10]*=r,t[3]*=i,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){const e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],i=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,i,s))}makeTranslation(e,t,i){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,i,0,0,0,1),this}makeRotationX(e){const t=Math.cos(e),i=Math.sin(e);return this.set(1,0,0,0,0,t,-i,0,0,i,t,0,0,0,0,1),this}makeRotationY(e){const t=Math.cos(e),i=Math.sin(e);return this.set(t,0,i,0,0,1,0,0,-i,0,t,0,0,0,0,1),this}makeRotationZ(e){const t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,0,i,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){const i=Math.cos(t),s=Math.sin(t),r=1-i,o=e.x,a=e.y,l=e.z,c=r*o,u=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,u*a+i,u*l-s*o,0,c*l-s*a,u*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(e,t,i){return this.set(e,0,0,0,0,t,0,0,0,0,i,0,0,0,0,1),this}makeShear(e,t,i,s,r,o){return this.set(1,i,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,i){const s=this.elements,r=t._x,o=t._y,a=t._z,l=t._w,c=r+r,u=o+o,h=a+a,f=r*c,d=r*u,_=r*h,x=o*u,m=o*h,p=a*h,S=l*c,w=l*u,y=l*h,L=i.x,R=i.y,U=i.z;return s[0]=(1-(x+p))*L,s[1]=(d+y)*L,s[2]=(_-w)*L,s[3]=0,s[4]=(d-y)*R,s[5]=(1-(f+p))*R,s[6]=(m+S)*R,s[7]=0,s[8]=(_+w)*U,s[9]=(m-S)*U,s[10]=(1-(f+x))*U,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,i){const s=this.elements;let r=jr.set(s[0],s[1],s[2]).length();const o=jr.set(s[4],s[5],s[6]).length(),a=jr.set(s[8],s[9],s[10]).length();this.determinant()<0&&(r=-r),e.x=s[12],e.y=s[13],e.z=s[14],Pi.copy(this);const c=1/r,u=1/o,h=1/a;return Pi.elements[0]*=c,Pi.elements[1]*=c,Pi.elements[2]*=c,Pi.elements[4]*=u,Pi.elements[5]*=u,Pi.elements[6]*=u,Pi.elements[8]*=h,Pi.elements[9]*=h,Pi.elements[10]*=h,t.setFromRotationMatrix(Pi),i.x=r,i.y=o,i.z=a,this}makePerspective(e,t,i,s,r,o,a=Ji,l=!1){const c=this.elements,u=2*r/(t-e),h=2*r/(i-s),f=(t+e)/(t-e),d=(i+s)/(i-s);let _,x;if(l)_=r/(o-r),x=o*r/(o-r);else if(a===Ji)_=-(o+r)/(o-r),x=-2*o*r/(o-r);else if(a===nc)_=-o/(o-r),x=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=f,c[12]=0,c[1]=0,c[5]=h,c[9]=d,c[13]=0,c[2]=0,c[6]=0,c[10]=_,c[14]=x,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,i,s,r,o,a=Ji,l=!1){const c=this.elements,u=2/(t-e),h=2/(i-s),f=-(t+e)/(t-e),d=-(i+s)/(i-s);let _,x;if(l)_=1/(o-r),x=o/(o-r);else if(a===Ji)_=-2/(o-r),x=-(o+r)/(o-r);else if(a===nc)_=-1/(o-r),x=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=f,c[1]=0,c[5]=h,c[9]=0,c[13]=d,c[2]=0,c[6]=0,c[10]=_,c[14]=x,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){const t=this.elements,i=e.elements;for(let s=0;s<16;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<16;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){const i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e[t+9]=i[9],e[t+10]=i[10],e[t+11]=i[11],e[t+12]=i[12],e[t+13]=i[13],e[t+14]=i[14],e[t+15]=i[15],e}}const jr=new k,Pi=new Pt,cM=new k(0,0,0),uM=new k(1,1,1),Ls=new k,nl=new k,ri=new k,Mp=new Pt,Sp=new _n;class wi{constructor(e=0,t=0,i=0,s=wi.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=i,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,i,s=this._order){return this._x=e,this._y=t,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,i=!0){const s=e.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],u=s[9],h=s[2],f=s[6],d=s[10];switch(t){case"XYZ":this._y=Math.asin(ft(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,d),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(f,c),this._z=0);break;case"YXZ":this._x=Math.asin(-ft(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,d),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-h,r),this._z=0);break;case"ZXY":this._x=Math.asin(ft(f,-1,1)),Math.abs(f)<.9999999?(this._y=Math.atan2(-h,d),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-ft(h,-1,1)),Math.abs(h)<.9999999?(this._x=Math.atan2(f,d),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(ft(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-h,r)):(this._x=0,this._y=Math.atan2(a,d));break;case"XZY":this._z=Math.asin(-ft(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(f,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,d),this._y=0);break;default:console.warn("THREE.Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,i===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,i){return Mp.makeRotationFromQuaternion(e),this.setFromRotationMatrix(Mp,t,i)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return Sp.setFromEuler(this),this.setFromQuaternion(Sp,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}}wi.DEFAULT_ORDER="XYZ";class Cf{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}}let hM=0;const Ep=new k,Kr=new _n,ls=new Pt,il=new k,Zo=new k,fM=new k,dM=new _n,bp=new k(1,0,0),wp=new k(0,1,0),Tp=new k(0,0,1),Ap={type:"added"},pM={type:"removed"},Zr={type:"childadded",child:null},ou={type:"childremoved",child:null};class nn extends Dr{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:hM++}),this.uuid=Ua(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=nn.DEFAULT_UP.clone();const e=new k,t=new wi,i=new _n,s=new k(1,1,1);function r(){i.setFromEuler(t,!1)}function o(){t.setFromQuaternion(i,void 0,!1)}t._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Pt},normalMatrix:{value:new lt}}),this.matrix=new Pt,this.matrixWorld=new Pt,this.matrixAutoUpdate=nn.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=nn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Cf,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.userData={}}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return Kr.setFromAxisAngle(e,t),this.quaternion.multiply(Kr),this}rotateOnWorldAxis(e,t){return Kr.setFromAxisAngle(e,t),this.quaternion.premultiply(Kr),this}rotateX(e){return this.rotateOnAxis(bp,e)}rotateY(e){return this.rotateOnAxis(wp,e)}rotateZ(e){return this.rotateOnAxis(Tp,e)}translateOnAxis(e,t){return Ep.copy(e).applyQuaternion(this.quaternion),this.position.add(Ep.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(bp,e)}translateY(e){return this.translateOnAxis(wp,e)}translateZ(e){return this.translateOnAxis(Tp,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(ls.copy(this.matrixWorld).invert())}lookAt(e,t,i){e.isVector3?il.copy(e):il.set(e,t,i);const s=this.parent;this.updateWorldMatrix(!0,!1),Zo.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?ls.lookAt(Zo,il,this.up):ls.lookAt(il,Zo,this.up),this.quaternion.setFromRotationMatrix(ls),s&&(ls.extractRotation(s.matrixWorld),Kr.setFromRotationMatrix(ls),this.quaternion.premultiply(Kr.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(console.error("THREE.Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(Ap),Zr.child=e,this.dispatchEvent(Zr),Zr.child=null):console.error("THREE.Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}const t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(pM),ou.child=e,this.dispatchEvent(ou),ou.child=null),this}removeFromParent(){const e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),ls.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),ls.multiply(e.parent.matrixWorld)),e.applyMatrix4(ls),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(Ap),Zr.child=e,this.dispatchEvent(Zr),Zr.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let i=0,s=this.children.length;i<s;i++){const o=this.children[i].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,i=[]){this[e]===t&&i.push(this);const s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,i);return i}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Zo,e,fM),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Zo,dM,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);const t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}traverse(e){e(this);const t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);const t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverseVisible(e)}traverseAncestors(e){const t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale),this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);const t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].updateMatrixWorld(e)}updateWorldMatrix(e,t){const i=this.parent;if(e===!0&&i!==null&&i.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),t===!0){const s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].updateWorldMatrix(!1,!0)}}toJSON(e){const t=e===void 0||typeof e=="string",i={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});const s={};s.uuid=this.uuid,s.type=this.type,this.name!==""&&(s.name=this.name),this.castShadow===!0&&(s.castShadow=!0),this.receiveShadow===!0&&(s.receiveShadow=!0),this.visible===!1&&(s.visible=!1),this.frustumCulled===!1&&(s.frustumCulled=!1),this.renderOrder!==0&&(s.renderOrder=this.renderOrder),Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.matrixAutoUpdate===!1&&(s.matrixAutoUpdate=!1),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);const a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){const l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){const h=l[c];r(e.shapes,h)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){const a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(e.materials,this.material[l]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){const l=this.animations[a];s.animations.push(r(e.animations,l))}}if(t){const a=o(e.geometries),l=o(e.materials),c=o(e.textures),u=o(e.images),h=o(e.shapes),f=o(e.skeletons),d=o(e.animations),_=o(e.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),u.length>0&&(i.images=u),h.length>0&&(i.shapes=h),f.length>0&&(i.skeletons=f),d.length>0&&(i.animations=d),_.length>0&&(i.nodes=_)}return i.object=s,i;function o(a){const l=[];for(const c in a){const u=a[c];delete u.metadata,l.push(u)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let i=0;i<e.children.length;i++){const s=e.children[i];this.add(s.clone())}return this}}nn.DEFAULT_UP=new k(0,1,0);nn.DEFAULT_MATRIX_AUTO_UPDATE=!0;nn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;const Di=new k,cs=new k,au=new k,us=new k,Jr=new k,Qr=new k,Rp=new k,lu=new k,cu=new k,uu=new k,hu=new tn,fu=new tn,du=new tn;class Oi{constructor(e=new k,t=new k,i=new k){this.a=e,this.b=t,this.c=i}static getNormal(e,t,i,s){s.subVectors(i,t),Di.subVectors(e,t),s.cross(Di);const r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,i,s,r){Di.subVectors(s,t),cs.subVectors(i,t),au.subVectors(e,t);const o=Di.dot(Di),a=Di.dot(cs),l=Di.dot(au),c=cs.dot(cs),u=cs.dot(au),h=o*c-a*a;if(h===0)return r.set(0,0,0),null;const f=1/h,d=(c*l-a*u)*f,_=(o*u-a*l)*f;return r.set(1-d-_,_,d)}static containsPoint(e,t,i,s){return this.getBarycoord(e,t,i,s,us)===null?!1:us.x>=0&&us.y>=0&&us.x+us.y<=1}static getInterpolation(e,t,i,s,r,o,a,l){return this.getBarycoord(e,t,i,s,us)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,us.x),l.addScaledVector(o,us.y),l.addScaledVector(a,us.z),l)}static getInterpolatedAttribute(e,t,i,s,r,o){return hu.setScalar(0),fu.setScalar(0),du.setScalar(0),hu.fromBufferAttribute(e,t),fu.fromBufferAttribute(e,i),du.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(hu,r.x),o.addScaledVector(fu,r.y),o.addScaledVector(du,r.z),o}static isFrontFacing(e,t,i,s){return Di.subVectors(i,t),cs.subVectors(e,t),Di.cross(cs).dot(s)<0}set(e,t,i){return this.a.copy(e),this.b.copy(t),this.c.copy(i),this}setFromPointsAndIndices(e,t,i,s){return this.a.copy(e[t]),this.b.copy(e[i]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,i,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,i),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return Di.subVectors(this.c,this.b),cs.subVectors(this.a,this.b),Di.cross(cs).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return Oi.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return Oi.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,i,s,r){return Oi.getInterpolation(e,this.a,this.b,this.c,t,i,s,r)}containsPoint(e){return Oi.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return Oi.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){const i=this.a,s=this.b,r=this.c;let o,a;Jr.subVectors(s,i),Qr.subVectors(r,i),lu.subVectors(e,i);const l=Jr.dot(lu),c=Qr.dot(lu);if(l<=0&&c<=0)return t.copy(i);cu.subVectors(e,s);const u=Jr.dot(cu),h=Qr.dot(cu);if(u>=0&&h<=u)return t.copy(s);const f=l*h-u*c;if(f<=0&&l>=0&&u<=0)return o=l/(l-u),t.copy(i).addScaledVector(Jr,o);uu.subVectors(e,r);const d=Jr.dot(uu),_=Qr.dot(uu);if(_>=0&&d<=_)return t.copy(r);const x=d*c-l*_;if(x<=0&&c>=0&&_<=0)return a=c/(c-_),t.copy(i).addScaledVector(Qr,a);const m=u*_-d*h;if(m<=0&&h-u>=0&&d-_>=0)return Rp.subVectors(r,s),a=(h-u)/(h-u+(d-_)),t.copy(s).addScaledVector(Rp,a);const p=1/(m+x+f);return o=x*p,a=f*p,t.copy(i).addScaledVector(Jr,o).addScaledVector(Qr,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}}const gg={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Is={h:0,s:0,l:0},sl={h:0,s:0,l:0};function pu(n,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?n+(e-n)*6*t:t<1/2?e:t<2/3?n+(e-n)*6*(2/3-t):n}class Qe{constructor(e,t,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,i)}set(e,t,i){if(t===void 0&&i===void 0){const s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,i);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=yi){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,Mt.colorSpaceToWorking(this,t),this}setRGB(e,t,i,s=Mt.workingColorSpace){return this.r=e,this.g=t,this.b=i,Mt.colorSpaceToWorking(this,s),this}setHSL(e,t,i,s=Mt.workingColorSpace){if(e=Jy(e,1),t=ft(t,0,1),i=ft(i,0,1),t===0)this.r=this.g=this.b=i;else{const r=i<=.5?i*(1+t):i+t-i*t,o=2*i-r;this.r=pu(o,r,e+1/3),this.g=pu(o,r,e),this.b=pu(o,r,e-1/3)}return Mt.colorSpaceToWorking(this,s),this}setStyle(e,t=yi){function i(r){r!==void 0&&parseFloat(r)<1&&console.warn("THREE.Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r;const o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+)\%\s*,\s*(\d+)\%\s*,\s*(\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseInt(r[1],10))/100,Math.min(100,parseInt(r[2],10))/100,Math.min(100,parseInt(r[3],10))/100,t);break;case"hsl":case"hsla":if(r=/^\s*(\d*\.?\d+)\s*,\s*(\d*\.?\d+)\%\s*,\s*(\d*\.?\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:console.warn("THREE.Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){const r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);console.warn("THREE.Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=yi){const i=gg[e.toLowerCase()];return i!==void 0?this.setHex(i,t):console.warn("THREE.Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=ms(e.r),this.g=ms(e.g),this.b=ms(e.b),this}copyLinearToSRGB(e){return this.r=mo(e.r),this.g=mo(e.g),this.b=mo(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=yi){return Mt.workingToColorSpace(Nn.copy(this),e),Math.round(ft(Nn.r*255,0,255))*65536+Math.round(ft(Nn.g*255,0,255))*256+Math.round(ft(Nn.b*255,0,255))}getHexString(e=yi){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=Mt.workingColorSpace){Mt.workingToColorSpace(Nn.copy(this),t);const i=Nn.r,s=Nn.g,r=Nn.b,o=Math.max(i,s,r),a=Math.min(i,s,r);let l,c;const u=(a+o)/2;if(a===o)l=0,c=0;else{const h=o-a;switch(c=u<=.5?h/(o+a):h/(2-o-a),o){case i:l=(s-r)/h+(s<r?6:0);break;case s:l=(r-i)/h+2;break;case r:l=(i-s)/h+4;break}l/=6}return e.h=l,e.s=c,e.l=u,e}getRGB(e,t=Mt.workingColorSpace){return Mt.workingToColorSpace(Nn.copy(this),t),e.r=Nn.r,e.g=Nn.g,e.b=Nn.b,e}getStyle(e=yi){Mt.workingToColorSpace(Nn.copy(this),e);const t=Nn.r,i=Nn.g,s=Nn.b;return e!==yi?`color(${e} ${t.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(e,t,i){return this.getHSL(Is),this.setHSL(Is.h+e,Is.s+t,Is.l+i)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,i){return this.r=e.r+(t.r-e.r)*i,this.g=e.g+(t.g-e.g)*i,this.b=e.b+(t.b-e.b)*i,this}lerpHSL(e,t){this.getHSL(Is),e.getHSL(sl);const i=Kc(Is.h,sl.h,t),s=Kc(Is.s,sl.s,t),r=Kc(Is.l,sl.l,t);return this.setHSL(i,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){const t=this.r,i=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*i+r[6]*s,this.g=r[1]*t+r[4]*i+r[7]*s,this.b=r[2]*t+r[5]*i+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}}const Nn=new Qe;Qe.NAMES=gg;let mM=0;class $s extends Dr{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:mM++}),this.uuid=Ua(),this.name="",this.type="Material",this.blending=po,this.side=ys,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Qu,this.blendDst=eh,this.blendEquation=mr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new Qe(0,0,0),this.blendAlpha=0,this.depthFunc=wo,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=pp,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Wr,this.stencilZFail=Wr,this.stencilZPass=Wr,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(const t in e){const i=e[t];if(i===void 0){console.warn(`THREE.Material: parameter '${t}' has value of undefined.`);continue}const s=this[t];if(s===void 0){console.warn(`THREE.Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[t]=i}}toJSON(e){const t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});const i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,this.name!==""&&(i.name=this.name),this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&this.emissiveIntensity!==1&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessRange!==void 0&&(i.iridescenceThicknessRange=this.iridescenceThicknessRange),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(e).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(e).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(e).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(e).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(e).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&this.attenuationDistance!==1/0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.shadowSide!==null&&(i.shadowSide=this.shadowSide),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),this.blending!==po&&(i.blending=this.blending),this.side!==ys&&(i.side=this.side),this.vertexColors===!0&&(i.vertexColors=!0),this.opacity<1&&(i.opacity=this.opacity),this.transparent===!0&&(i.transparent=!0),this.blendSrc!==Qu&&(i.blendSrc=this.blendSrc),this.blendDst!==eh&&(i.blendDst=this.blendDst),this.blendEquation!==mr&&(i.blendEquation=this.blendEquation),this.blendSrcAlpha!==null&&(i.blendSrcAlpha=this.blendSrcAlpha),this.blendDstAlpha!==null&&(i.blendDstAlpha=this.blendDstAlpha),this.blendEquationAlpha!==null&&(i.blendEquationAlpha=this.blendEquationAlpha),this.blendColor&&this.blendColor.isColor&&(i.blendColor=this.blendColor.getHex()),this.blendAlpha!==0&&(i.blendAlpha=this.blendAlpha),this.depthFunc!==wo&&(i.depthFunc=this.depthFunc),this.depthTest===!1&&(i.depthTest=this.depthTest),this.depthWrite===!1&&(i.depthWrite=this.depthWrite),this.colorWrite===!1&&(i.colorWrite=this.colorWrite),this.stencilWriteMask!==255&&(i.stencilWriteMask=this.stencilWriteMask),this.stencilFunc!==pp&&(i.stencilFunc=this.stencilFunc),this.stencilRef!==0&&(i.stencilRef=this.stencilRef),this.stencilFuncMask!==255&&(i.stencilFuncMask=this.stencilFuncMask),this.stencilFail!==Wr&&(i.stencilFail=this.stencilFail),this.stencilZFail!==Wr&&(i.stencilZFail=this.stencilZFail),this.stencilZPass!==Wr&&(i.stencilZPass=this.stencilZPass),this.stencilWrite===!0&&(i.stencilWrite=this.stencilWrite),this.rotation!==void 0&&this.rotation!==0&&(i.rotation=this.rotation),this.polygonOffset===!0&&(i.polygonOffset=!0),this.polygonOffsetFactor!==0&&(i.polygonOffsetFactor=this.polygonOffsetFactor),this.polygonOffsetUnits!==0&&(i.polygonOffsetUnits=this.polygonOffsetUnits),this.linewidth!==void 0&&this.linewidth!==1&&(i.linewidth=this.linewidth),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.dithering===!0&&(i.dithering=!0),this.alphaTest>0&&(i.alphaTest=this.alphaTest),this.alphaHash===!0&&(i.alphaHash=!0),this.alphaToCoverage===!0&&(i.alphaToCoverage=!0),this.premultipliedAlpha===!0&&(i.premultipliedAlpha=!0),this.forceSinglePass===!0&&(i.forceSinglePass=!0),this.wireframe===!0&&(i.wireframe=!0),this.wireframeLinewidth>1&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!=="round"&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!=="round"&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading===!0&&(i.flatShading=!0),this.visible===!1&&(i.visible=!1),this.toneMapped===!1&&(i.toneMapped=!1),this.fog===!1&&(i.fog=!1),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){const o=[];for(const a in r){const l=r[a];delete l.metadata,o.push(l)}return o}if(t){const r=s(e.textures),o=s(e.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;const t=e.clippingPlanes;let i=null;if(t!==null){const s=t.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=t[r].clone()}return this.clippingPlanes=i,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}}class Na extends $s{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new Qe(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new wi,this.combine=xf,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}}const ln=new k,rl=new Ke;let _M=0;class Dn{constructor(e,t,i=!1){if(Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:_M++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=i,this.usage=mp,this.updateRanges=[],this.gpuType=Zi,this.version=0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this}copyAt(e,t,i){e*=this.itemSize,i*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[i+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,i=this.count;t<i;t++)rl.fromBufferAttribute(this,t),rl.applyMatrix3(e),this.setXY(t,rl.x,rl.y);else if(this.itemSize===3)for(let t=0,i=this.count;t<i;t++)ln.fromBufferAttribute(this,t),ln.applyMatrix3(e),this.setXYZ(t,ln.x,ln.y,ln.z);return this}applyMatrix4(e){for(let t=0,i=this.count;t<i;t++)ln.fromBufferAttribute(this,t),ln.applyMatrix4(e),this.setXYZ(t,ln.x,ln.y,ln.z);return this}applyNormalMatrix(e){for(let t=0,i=this.count;t<i;t++)ln.fromBufferAttribute(this,t),ln.applyNormalMatrix(e),this.setXYZ(t,ln.x,ln.y,ln.z);return this}transformDirection(e){for(let t=0,i=this.count;t<i;t++)ln.fromBufferAttribute(this,t),ln.transformDirection(e),this.setXYZ(t,ln.x,ln.y,ln.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let i=this.array[e*this.itemSize+t];return this.normalized&&(i=$o(i,this.array)),i}setComponent(e,t,i){return this.normalized&&(i=Jn(i,this.array)),this.array[e*this.itemSize+t]=i,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=$o(t,this.array)),t}setX(e,t){return this.normalized&&(t=Jn(t,this.array)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=$o(t,this.array)),t}setY(e,t){return this.normalized&&(t=Jn(t,this.array)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=$o(t,this.array)),t}setZ(e,t){return this.normalized&&(t=Jn(t,this.array)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=$o(t,this.array)),t}setW(e,t){return this.normalized&&(t=Jn(t,this.array)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,i){return e*=this.itemSize,this.normalized&&(t=Jn(t,this.array),i=Jn(i,this.array)),this.array[e+0]=t,this.array[e+1]=i,this}setXYZ(e,t,i,s){return e*=this.itemSize,this.normalized&&(t=Jn(t,this.array),i=Jn(i,this.array),s=Jn(s,this.array)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this}setXYZW(e,t,i,s,r){return e*=this.itemSize,this.normalized&&(t=Jn(t,this.array),i=Jn(i,this.array),s=Jn(s,this.array),r=Jn(r,this.array)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){const e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return this.name!==""&&(e.name=this.name),this.usage!==mp&&(e.usage=this.usage),e}}class vg extends Dn{constructor(e,t,i){super(new Uint16Array(e),t,i)}}class xg extends Dn{constructor(e,t,i){super(new Uint32Array(e),t,i)}}class $t extends Dn{constructor(e,t,i){super(new Float32Array(e),t,i)}}let gM=0;const mi=new Pt,mu=new nn,eo=new k,oi=new qs,Jo=new qs,An=new k;class on extends Dr{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:gM++}),this.uuid=Ua(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={}}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(mg(e)?xg:vg)(e,1):this.index=e,this}setIndirect(e){return this.indirect=e,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,i=0){this.groups.push({start:e,count:t,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){const t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);const i=this.attributes.normal;if(i!==void 0){const r=new lt().getNormalMatrix(e);i.applyNormalMatrix(r),i.needsUpdate=!0}const s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this}applyQuaternion(e){return mi.makeRotationFromQuaternion(e),this.applyMatrix4(mi),this}rotateX(e){return mi.makeRotationX(e),this.applyMatrix4(mi),this}rotateY(e){return mi.makeRotationY(e),this.applyMatrix4(mi),this}rotateZ(e){return mi.makeRotationZ(e),this.applyMatrix4(mi),this}translate(e,t,i){return mi.makeTranslation(e,t,i),this.applyMatrix4(mi),this}scale(e,t,i){return mi.makeScale(e,t,i),this.applyMatrix4(mi),this}lookAt(e){return mu.lookAt(e),mu.updateMatrix(),this.applyMatrix4(mu.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(eo).negate(),this.translate(eo.x,eo.y,eo.z),this}setFromPoints(e){const t=this.getAttribute("position");if(t===void 0){const i=[];for(let s=0,r=e.length;s<r;s++){const o=e[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new $t(i,3))}else{const i=Math.min(e.length,t.count);for(let s=0;s<i;s++){const r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&console.warn("THREE.BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new qs);const e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){console.error("THREE.BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new k(-1/0,-1/0,-1/0),new k(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let i=0,s=t.length;i<s;i++){const r=t[i];oi.setFromBufferAttribute(r),this.morphTargetsRelative?(An.addVectors(this.boundingBox.min,oi.min),this.boundingBox.expandByPoint(An),An.addVectors(this.boundingBox.max,oi.max),this.boundingBox.expandByPoint(An)):(this.boundingBox.expandByPoint(oi.min),this.boundingBox.expandByPoint(oi.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&console.error('THREE.BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Lr);const e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){console.error("THREE.BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new k,1/0);return}if(e){const i=this.boundingSphere.center;if(oi.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){const a=t[r];Jo.setFromBufferAttribute(a),this.morphTargetsRelative?(An.addVectors(oi.min,Jo.min),oi.expandByPoint(An),An.addVectors(oi.max,Jo.max),oi.expandByPoint(An)):(oi.expandByPoint(Jo.min),oi.expandByPoint(Jo.max))}oi.getCenter(i);let s=0;for(let r=0,o=e.count;r<o;r++)An.fromBufferAttribute(e,r),s=Math.max(s,i.distanceToSquared(An));if(t)for(let r=0,o=t.length;r<o;r++){const a=t[r],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)An.fromBufferAttribute(a,c),l&&(eo.fromBufferAttribute(e,c),An.add(eo)),s=Math.max(s,i.distanceToSquared(An))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&console.error('THREE.BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){const e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){console.error("THREE.BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}const i=t.position,s=t.normal,r=t.uv;this.hasAttribute("tangent")===!1&&this.setAttribute("tangent",new Dn(new Float32Array(4*i.count),4));const o=this.getAttribute("tangent"),a=[],l=[];for(let N=0;N<i.count;N++)a[N]=new k,l[N]=new k;const c=new k,u=new k,h=new k,f=new Ke,d=new Ke,_=new Ke,x=new k,m=new k;function p(N,T,b){c.fromBufferAttribute(i,N),u.fromBufferAttribute(i,T),h.fromBufferAttribute(i,b),f.fromBufferAttribute(r,N),d.fromBufferAttribute(r,T),_.fromBufferAttribute(r,b),u.sub(c),h.sub(c),d.sub(f),_.sub(f);const C=1/(d.x*_.y-_.x*d.y);isFinite(C)&&(x.copy(u).multiplyScalar(_.y).addScaledVector(h,-d.y).multiplyScalar(C),m.copy(h).multiplyScalar(d.x).addScaledVector(u,-_.x).multiplyScalar(C),a[N].add(x),a[T].add(x),a[b].add(x),l[N].add(m),l[T].add(m),l[b].add(m))}let S=this.groups;S.length===0&&(S=[{start:0,count:e.count}]);for(let N=0,T=S.length;N<T;++N){const b=S[N],C=b.start,B=b.count;for(let z=C,X=C+B;z<X;z+=3)p(e.getX(z+0),e.getX(z+1),e.getX(z+2))}const w=new k,y=new k,L=new k,R=new k;function U(N){L.fromBufferAttribute(s,N),R.copy(L);const T=a[N];w.copy(T),w.sub(L.multiplyScalar(L.dot(T))).normalize(),y.crossVectors(R,T);const C=y.dot(l[N])<0?-1:1;o.setXYZW(N,w.x,w.y,w.z,C)}for(let N=0,T=S.length;N<T;++N){const b=S[N],C=b.start,B=b.count;for(let z=C,X=C+B;z<X;z+=3)U(e.getX(z+0)),U(e.getX(z+1)),U(e.getX(z+2))}}computeVertexNormals(){const e=this.index,t=this.getAttribute("position");if(t!==void 0){let i=this.getAttribute("normal");if(i===void 0)i=new Dn(new Float32Array(t.count*3),3),this.setAttribute("normal",i);else for(let f=0,d=i.count;f<d;f++)i.setXYZ(f,0,0,0);const s=new k,r=new k,o=new k,a=new k,l=new k,c=new k,u=new k,h=new k;if(e)for(let f=0,d=e.count;f<d;f+=3){const _=e.getX(f+0),x=e.getX(f+1),m=e.getX(f+2);s.fromBufferAttribute(t,_),r.fromBufferAttribute(t,x),o.fromBufferAttribute(t,m),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),a.fromBufferAttribute(i,_),l.fromBufferAttribute(i,x),c.fromBufferAttribute(i,m),a.add(u),l.add(u),c.add(u),i.setXYZ(_,a.x,a.y,a.z),i.setXYZ(x,l.x,l.y,l.z),i.setXYZ(m,c.x,c.y,c.z)}else for(let f=0,d=t.count;f<d;f+=3)s.fromBufferAttribute(t,f+0),r.fromBufferAttribute(t,f+1),o.fromBufferAttribute(t,f+2),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),i.setXYZ(f+0,u.x,u.y,u.z),i.setXYZ(f+1,u.x,u.y,u.z),i.setXYZ(f+2,u.x,u.y,u.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){const e=this.attributes.normal;for(let t=0,i=e.count;t<i;t++)An.fromBufferAttribute(e,t),An.normalize(),e.setXYZ(t,An.x,An.y,An.z)}toNonIndexed(){function e(a,l){const c=a.array,u=a.itemSize,h=a.normalized,f=new c.constructor(l.length*u);let d=0,_=0;for(let x=0,m=l.length;x<m;x++){a.isInterleavedBufferAttribute?d=l[x]*a.data.stride+a.offset:d=l[x]*u;for(let p=0;p<u;p++)f[_++]=c[d++]}return new Dn(f,u,h)}if(this.index===null)return console.warn("THREE.BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;const t=new on,i=this.index.array,s=this.attributes;for(const a in s){const l=s[a],c=e(l,i);t.setAttribute(a,c)}const r=this.morphAttributes;for(const a in r){const l=[],c=r[a];for(let u=0,h=c.length;u<h;u++){const f=c[u],d=e(f,i);l.push(d)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;const o=this.groups;for(let a=0,l=o.length;a<l;a++){const c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){const e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.type,this.name!==""&&(e.name=this.name),Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0){const l=this.parameters;for(const c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};const t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});const i=this.attributes;for(const l in i){const c=i[l];e.data.attributes[l]=c.toJSON(e.data)}const s={};let r=!1;for(const l in this.morphAttributes){const c=this.morphAttributes[l],u=[];for(let h=0,f=c.length;h<f;h++){const d=c[h];u.push(d.toJSON(e.data))}u.length>0&&(s[l]=u,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);const o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));const a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;const t={};this.name=e.name;const i=e.index;i!==null&&this.setIndex(i.clone());const s=e.attributes;for(const c in s){const u=s[c];this.setAttribute(c,u.clone(t))}const r=e.morphAttributes;for(const c in r){const u=[],h=r[c];for(let f=0,d=h.length;f<d;f++)u.push(h[f].clone(t));this.morphAttributes[c]=u}this.morphTargetsRelative=e.morphTargetsRelative;const o=e.groups;for(let c=0,u=o.length;c<u;c++){const h=o[c];this.addGroup(h.start,h.count,h.materialIndex)}const a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());const l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this}dispose(){this.dispatchEvent({type:"dispose"})}}const Cp=new Pt,ir=new Mc,ol=new Lr,Pp=new k,al=new k,ll=new k,cl=new k,_u=new k,ul=new k,Dp=new k,hl=new k;class Ee extends nn{constructor(e=new on,t=new Na){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0&&(this.morphTargetInfluences=e.morphTargetInfluences.slice()),e.morphTargetDictionary!==void 0&&(this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary)),this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){const t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){const s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){const a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){const i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;t.fromBufferAttribute(s,e);const a=this.morphTargetInfluences;if(r&&a){ul.set(0,0,0);for(let l=0,c=r.length;l<c;l++){const u=a[l],h=r[l];u!==0&&(_u.fromBufferAttribute(h,e),o?ul.addScaledVector(_u,u):ul.addScaledVector(_u.sub(t),u))}t.add(ul)}return t}raycast(e,t){const i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),ol.copy(i.boundingSphere),ol.applyMatrix4(r),ir.copy(e.ray).recast(e.near),!(ol.containsPoint(ir.origin)===!1&&(ir.intersectSphere(ol,Pp)===null||ir.origin.distanceToSquared(Pp)>(e.far-e.near)**2))&&(Cp.copy(r).invert(),ir.copy(e.ray).applyMatrix4(Cp),!(i.boundingBox!==null&&ir.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(e,t,ir)))}_computeIntersections(e,t,i){let s;const r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,h=r.attributes.normal,f=r.groups,d=r.drawRange;if(a!==null)if(Array.isArray(o))for(let _=0,x=f.length;_<x;_++){const m=f[_],p=o[m.materialIndex],S=Math.max(m.start,d.start),w=Math.min(a.count,Math.min(m.start+m.count,d.start+d.count));for(let y=S,L=w;y<L;y+=3){const R=a.getX(y),U=a.getX(y+1),N=a.getX(y+2);s=fl(this,p,e,i,c,u,h,R,U,N),s&&(s.faceIndex=Math.floor(y/3),s.face.materialIndex=m.materialIndex,t.push(s))}}else{const _=Math.max(0,d.start),x=Math.min(a.count,d.start+d.count);for(let m=_,p=x;m<p;m+=3){const S=a.getX(m),w=a.getX(m+1),y=a.getX(m+2);s=fl(this,o,e,i,c,u,h,S,w,y),s&&(s.faceIndex=Math.floor(m/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let _=0,x=f.length;_<x;_++){const m=f[_],p=o[m.materialIndex],S=Math.max(m.start,d.start),w=Math.min(l.count,Math.min(m.start+m.count,d.start+d.count));for(let y=S,L=w;y<L;y+=3){const R=y,U=y+1,N=y+2;s=fl(this,p,e,i,c,u,h,R,U,N),s&&(s.faceIndex=Math.floor(y/3),s.face.materialIndex=m.materialIndex,t.push(s))}}else{const _=Math.max(0,d.start),x=Math.min(l.count,d.start+d.count);for(let m=_,p=x;m<p;m+=3){const S=m,w=m+1,y=m+2;s=fl(this,o,e,i,c,u,h,S,w,y),s&&(s.faceIndex=Math.floor(m/3),t.push(s))}}}}function vM(n,e,t,i,s,r,o,a){let l;if(e.side===ei?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,e.side===ys,a),l===null)return null;hl.copy(a),hl.applyMatrix4(n.matrixWorld);const c=t.ray.origin.distanceTo(hl);return c<t.near||c>t.far?null:{distance:c,point:hl.clone(),object:n}}function fl(n,e,t,i,s,r,o,a,l,c){n.getVertexPosition(a,al),n.getVertexPosition(l,ll),n.getVertexPosition(c,cl);const u=vM(n,e,t,i,al,ll,cl,Dp);if(u){const h=new k;Oi.getBarycoord(Dp,al,ll,cl,h),s&&(u.uv=Oi.getInterpolatedAttribute(s,a,l,c,h,new Ke)),r&&(u.uv1=Oi.getInterpolatedAttribute(r,a,l,c,h,new Ke)),o&&(u.normal=Oi.getInterpolatedAttribute(o,a,l,c,h,new k),u.normal.dot(i.direction)>0&&u.normal.multiplyScalar(-1));const f={a,b:l,c,normal:new k,materialIndex:0};Oi.getNormal(al,ll,cl,f.normal),u.face=f,u.barycoord=h}return u}class cn extends on{constructor(e=1,t=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};const a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);const l=[],c=[],u=[],h=[];let f=0,d=0;_("z","y","x",-1,-1,i,t,e,o,r,0),_("z","y","x",1,-1,i,t,-e,o,r,1),_("x","z","y",1,1,e,i,t,s,o,2),_("x","z","y",1,-1,e,i,-t,s,o,3),_("x","y","z",1,-1,e,t,i,s,r,4),_("x","y","z",-1,-1,e,t,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new $t(c,3)),this.setAttribute("normal",new $t(u,3)),this.setAttribute("uv",new $t(h,2));function _(x,m,p,S,w,y,L,R,U,N,T){const b=y/U,C=L/N,B=y/2,z=L/2,X=R/2,W=U+1,q=N+1;let j=0,Z=0;const re=new k;for(let ae=0;ae<q;ae++){const me=ae*C-z;for(let xe=0;xe<W;xe++){const ge=xe*b-B;re[x]=ge*S,re[m]=me*w,re[p]=X,c.push(re.x,re.y,re.z),re[x]=0,re[m]=0,re[p]=R>0?1:-1,u.push(re.x,re.y,re.z),h.push(xe/U),h.push(1-ae/N),j+=1}}for(let ae=0;ae<N;ae++)for(let me=0;me<U;me++){const xe=f+me+W*ae,ge=f+me+W*(ae+1),tt=f+(me+1)+W*(ae+1),nt=f+(me+1)+W*ae;l.push(xe,ge,nt),l.push(ge,tt,nt),Z+=6}a.addGroup(d,Z,T),d+=Z,f+=j}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new cn(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}}function Co(n){const e={};for(const t in n){e[t]={};for(const i in n[t]){const s=n[t][i];s&&(s.isColor||s.isMatrix3||s.isMatrix4||s.isVector2||s.isVector3||s.isVector4||s.isTexture||s.isQuaternion)?s.isRenderTargetTexture?(console.warn("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][i]=null):e[t][i]=s.clone():Array.isArray(s)?e[t][i]=s.slice():e[t][i]=s}}return e}function Xn(n){const e={};for(let t=0;t<n.length;t++){const i=Co(n[t]);for(const s in i)e[s]=i[s]}return e}function xM(n){const e=[];for(let t=0;t<n.length;t++)e.push(n[t].clone());return e}function yg(n){const e=n.getRenderTarget();return e===null?n.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:Mt.workingColorSpace}const yM={clone:Co,merge:Xn};var MM=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,SM=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`;class ts extends $s{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=MM,this.fragmentShader=SM,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=Co(e.uniforms),this.uniformsGroups=xM(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this}toJSON(e){const t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(const s in this.uniforms){const o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;const i={};for(const s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(t.extensions=i),t}}class Pf extends nn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Pt,this.projectionMatrix=new Pt,this.projectionMatrixInverse=new Pt,this.coordinateSystem=Ji,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorldInverse.copy(this.matrixWorld).invert()}updateWorldMatrix(e,t){super.updateWorldMatrix(e,t),this.matrixWorldInverse.copy(this.matrixWorld).invert()}clone(){return new this.constructor().copy(this)}}const Us=new k,Lp=new Ke,Ip=new Ke;class Mi extends Pf{constructor(e=50,t=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){const t=.5*this.getFilmHeight()/e;this.fov=zh*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){const e=Math.tan(Fl*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return zh*2*Math.atan(Math.tan(Fl*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,i){Us.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(Us.x,Us.y).multiplyScalar(-e/Us.z),Us.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(Us.x,Us.y).multiplyScalar(-e/Us.z)}getViewSize(e,t){return this.getViewBounds(e,Lp,Ip),t.subVectors(Ip,Lp)}setViewOffset(e,t,i,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){const e=this.near;let t=e*Math.tan(Fl*.5*this.fov)/this.zoom,i=2*t,s=this.aspect*i,r=-.5*s;const o=this.view;if(this.view!==null&&this.view.enabled){const l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,t-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}const a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-i,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){const t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}}const to=-90,no=1;class EM extends nn{constructor(e,t,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;const s=new Mi(to,no,e,t);s.layers=this.layers,this.add(s);const r=new Mi(to,no,e,t);r.layers=this.layers,this.add(r);const o=new Mi(to,no,e,t);o.layers=this.layers,this.add(o);const a=new Mi(to,no,e,t);a.layers=this.layers,this.add(a);const l=new Mi(to,no,e,t);l.layers=this.layers,this.add(l);const c=new Mi(to,no,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){const e=this.coordinateSystem,t=this.children.concat(),[i,s,r,o,a,l]=t;for(const c of t)this.remove(c);if(e===Ji)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===nc)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(const c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();const{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());const[r,o,a,l,c,u]=this.children,h=e.getRenderTarget(),f=e.getActiveCubeFace(),d=e.getActiveMipmapLevel(),_=e.xr.enabled;e.xr.enabled=!1;const x=i.texture.generateMipmaps;i.texture.generateMipmaps=!1,e.setRenderTarget(i,0,s),e.render(t,r),e.setRenderTarget(i,1,s),e.render(t,o),e.setRenderTarget(i,2,s),e.render(t,a),e.setRenderTarget(i,3,s),e.render(t,l),e.setRenderTarget(i,4,s),e.render(t,c),i.texture.generateMipmaps=x,e.setRenderTarget(i,5,s),e.render(t,u),e.setRenderTarget(h,f,d),e.xr.enabled=_,i.texture.needsPMREMUpdate=!0}}class Mg extends $n{constructor(e=[],t=To,i,s,r,o,a,l,c,u){super(e,t,i,s,r,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}}class bM extends Ys{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;const i={width:e,height:e,depth:1},s=[i,i,i,i,i,i];this.texture=new Mg(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;const i={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new cn(5,5,5),r=new ts({name:"CubemapFromEquirect",uniforms:Co(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:ei,blending:Hs});r.uniforms.tEquirect.value=t;const o=new Ee(s,r),a=t.minFilter;return t.minFilter===yr&&(t.minFilter=Ki),new EM(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,i=!0,s=!0){const r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,i,s);e.setRenderTarget(r)}}class Qi extends nn{constructor(){super(),this.isGroup=!0,this.type="Group"}}const wM={type:"move"};class gu{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Qi,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Qi,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new k,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new k),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Qi,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new k,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new k),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){const t=this._hand;if(t)for(const i of e.hand.values())this._getHandJoint(t,i)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,i){let s=null,r=null,o=null;const a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(const x of e.hand.values()){const m=t.getJointPose(x,i),p=this._getHandJoint(c,x);m!==null&&(p.matrix.fromArray(m.transform.matrix),p.matrix.decompose(p.position,p.rotation,p.scale),p.matrixWorldNeedsUpdate=!0,p.jointRadius=m.radius),p.visible=m!==null}const u=c.joints["index-finger-tip"],h=c.joints["thumb-tip"],f=u.position.distanceTo(h.position),d=.02,_=.005;c.inputState.pinching&&f>d+_?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&f<=d-_&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.rotation,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1));a!==null&&(s=t.getPose(e.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.rotation,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(wM)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){const i=new Qi;i.matrixAutoUpdate=!1,i.visible=!1,e.joints[t.jointName]=i,e.add(i)}return e.joints[t.jointName]}}class Sg extends nn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new wi,this.environmentIntensity=1,this.environmentRotation=new wi,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),e.background!==null&&(this.background=e.background.clone()),e.environment!==null&&(this.environment=e.environment.clone()),e.fog!==null&&(this.fog=e.fog.clone()),this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),e.overrideMaterial!==null&&(this.overrideMaterial=e.overrideMaterial.clone()),this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){const t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),this.backgroundBlurriness>0&&(t.object.backgroundBlurriness=this.backgroundBlurriness),this.backgroundIntensity!==1&&(t.object.backgroundIntensity=this.backgroundIntensity),t.object.backgroundRotation=this.backgroundRotation.toArray(),this.environmentIntensity!==1&&(t.object.environmentIntensity=this.environmentIntensity),t.object.environmentRotation=this.environmentRotation.toArray(),t}}class TM extends $n{constructor(e=null,t=1,i=1,s,r,o,a,l,c=qn,u=qn,h,f){super(null,o,a,l,c,u,s,r,h,f),this.isDataTexture=!0,this.image={data:e,width:t,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}}class Up extends Dn{constructor(e,t,i,s=1){super(e,t,i),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}toJSON(){const e=super.toJSON();return e.meshPerAttribute=this.meshPerAttribute,e.isInstancedBufferAttribute=!0,e}}const io=new Pt,Np=new Pt,dl=[],Fp=new qs,AM=new Pt,Qo=new Ee,ea=new Lr;class RM extends Ee{constructor(e,t,i){super(e,t),this.isInstancedMesh=!0,this.instanceMatrix=new Up(new Float32Array(i*16),16),this.instanceColor=null,this.morphTexture=null,this.count=i,this.boundingBox=null,this.boundingSphere=null;for(let s=0;s<i;s++)this.setMatrixAt(s,AM)}computeBoundingBox(){const e=this.geometry,t=this.count;this.boundingBox===null&&(this.boundingBox=new qs),e.boundingBox===null&&e.computeBoundingBox(),this.boundingBox.makeEmpty();for(let i=0;i<t;i++)this.getMatrixAt(i,io),Fp.copy(e.boundingBox).applyMatrix4(io),this.boundingBox.union(Fp)}computeBoundingSphere(){const e=this.geometry,t=this.count;this.boundingSphere===null&&(this.boundingSphere=new Lr),e.boundingSphere===null&&e.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let i=0;i<t;i++)this.getMatrixAt(i,io),ea.copy(e.boundingSphere).applyMatrix4(io),this.boundingSphere.union(ea)}copy(e,t){return super.copy(e,t),this.instanceMatrix.copy(e.instanceMatrix),e.morphTexture!==null&&(this.morphTexture=e.morphTexture.clone()),e.instanceColor!==null&&(this.instanceColor=e.instanceColor.clone()),this.count=e.count,e.boundingBox!==null&&(this.boundingBox=e.boundingBox.clone()),e.boundingSphere!==null&&(this.boundingSphere=e.boundingSphere.clone()),this}getColorAt(e,t){t.fromArray(this.instanceColor.array,e*3)}getMatrixAt(e,t){t.fromArray(this.instanceMatrix.array,e*16)}getMorphAt(e,t){const i=t.morphTargetInfluences,s=this.morphTexture.source.data.data,r=i.length+1,o=e*r+1;for(let a=0;a<i.length;a++)i[a]=s[o+a]}raycast(e,t){const i=this.matrixWorld,s=this.count;if(Qo.geometry=this.geometry,Qo.material=this.material,Qo.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),ea.copy(this.boundingSphere),ea.applyMatrix4(i),e.ray.intersectsSphere(ea)!==!1))for(let r=0;r<s;r++){this.getMatrixAt(r,io),Np.multiplyMatrices(i,io),Qo.matrixWorld=Np,Qo.raycast(e,dl);for(let o=0,a=dl.length;o<a;o++){const l=dl[o];l.instanceId=r,l.object=this,t.push(l)}dl.length=0}}setColorAt(e,t){this.instanceColor===null&&(this.instanceColor=new Up(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),t.toArray(this.instanceColor.array,e*3)}setMatrixAt(e,t){t.toArray(this.instanceMatrix.array,e*16)}setMorphAt(e,t){const i=t.morphTargetInfluences,s=i.length+1;this.morphTexture===null&&(this.morphTexture=new TM(new Float32Array(s*this.count),s,this.count,Ef,Zi));const r=this.morphTexture.source.data.data;let o=0;for(let c=0;c<i.length;c++)o+=i[c];const a=this.geometry.morphTargetsRelative?1:1-o,l=s*e;r[l]=a,r.set(i,l+1)}updateMorphTargets(){}dispose(){this.dispatchEvent({type:"dispose"}),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}}const vu=new k,CM=new k,PM=new lt;class ks{constructor(e=new k(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,i,s){return this.normal.set(e,t,i),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,i){const s=vu.subVectors(i,t).cross(CM.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){const e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t){const i=e.delta(vu),s=this.normal.dot(i);if(s===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;const r=-(e.start.dot(this.normal)+this.constant)/s;return r<0||r>1?null:t.copy(e.start).addScaledVector(i,r)}intersectsLine(e){const t=this.distanceToPoint(e.start),i=this.distanceToPoint(e.end);return t<0&&i>0||i<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){const i=t||PM.getNormalMatrix(e),s=this.coplanarPoint(vu).applyMatrix4(e),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}}const sr=new Lr,DM=new Ke(.5,.5),pl=new k;class Df{constructor(e=new ks,t=new ks,i=new ks,s=new ks,r=new ks,o=new ks){this.planes=[e,t,i,s,r,o]}set(e,t,i,s,r,o){const a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){const t=this.planes;for(let i=0;i<6;i++)t[i].copy(e.planes[i]);return this}setFromProjectionMatrix(e,t=Ji,i=!1){const s=this.planes,r=e.elements,o=r[0],a=r[1],l=r[2],c=r[3],u=r[4],h=r[5],f=r[6],d=r[7],_=r[8],x=r[9],m=r[10],p=r[11],S=r[12],w=r[13],y=r[14],L=r[15];if(s[0].setComponents(c-o,d-u,p-_,L-S).normalize(),s[1].setComponents(c+o,d+u,p+_,L+S).normalize(),s[2].setComponents(c+a,d+h,p+x,L+w).normalize(),s[3].setComponents(c-a,d-h,p-x,L-w).normalize(),i)s[4].setComponents(l,f,m,y).normalize(),s[5].setComponents(c-l,d-f,p-m,L-y).normalize();else if(s[4].setComponents(c-l,d-f,p-m,L-y).normalize(),t===Ji)s[5].setComponents(c+l,d+f,p+m,L+y).normalize();else if(t===nc)s[5].setComponents(l,f,m,y).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),sr.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{const t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),sr.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(sr)}intersectsSprite(e){sr.center.set(0,0,0);const t=DM.distanceTo(e.center);return sr.radius=.7071067811865476+t,sr.applyMatrix4(e.matrixWorld),this.intersectsSphere(sr)}intersectsSphere(e){const t=this.planes,i=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(e){const t=this.planes;for(let i=0;i<6;i++){const s=t[i];if(pl.x=s.normal.x>0?e.max.x:e.min.x,pl.y=s.normal.y>0?e.max.y:e.min.y,pl.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(pl)<0)return!1}return!0}containsPoint(e){const t=this.planes;for(let i=0;i<6;i++)if(t[i].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}}class _o extends $s{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new Qe(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}}const sc=new k,rc=new k,Op=new Pt,ta=new Mc,ml=new Lr,xu=new k,kp=new k;class vi extends nn{constructor(e=new on,t=new _o){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){const e=this.geometry;if(e.index===null){const t=e.attributes.position,i=[0];for(let s=1,r=t.count;s<r;s++)sc.fromBufferAttribute(t,s-1),rc.fromBufferAttribute(t,s),i[s]=i[s-1],i[s]+=sc.distanceTo(rc);e.setAttribute("lineDistance",new $t(i,1))}else console.warn("THREE.Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}raycast(e,t){const i=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),ml.copy(i.boundingSphere),ml.applyMatrix4(s),ml.radius+=r,e.ray.intersectsSphere(ml)===!1)return;Op.copy(s).invert(),ta.copy(e.ray).applyMatrix4(Op);const a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=i.index,f=i.attributes.position;if(u!==null){const d=Math.max(0,o.start),_=Math.min(u.count,o.start+o.count);for(let x=d,m=_-1;x<m;x+=c){const p=u.getX(x),S=u.getX(x+1),w=_l(this,e,ta,l,p,S,x);w&&t.push(w)}if(this.isLineLoop){const x=u.getX(_-1),m=u.getX(d),p=_l(this,e,ta,l,x,m,_-1);p&&t.push(p)}}else{const d=Math.max(0,o.start),_=Math.min(f.count,o.start+o.count);for(let x=d,m=_-1;x<m;x+=c){const p=_l(this,e,ta,l,x,x+1,x);p&&t.push(p)}if(this.isLineLoop){const x=_l(this,e,ta,l,_-1,d,_-1);x&&t.push(x)}}}updateMorphTargets(){const t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){const s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){const a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}}function _l(n,e,t,i,s,r,o){const a=n.geometry.attributes.position;if(sc.fromBufferAttribute(a,s),rc.fromBufferAttribute(a,r),t.distanceSqToSegment(sc,rc,xu,kp)>i)return;xu.applyMatrix4(n.matrixWorld);const c=e.ray.origin.distanceTo(xu);if(!(c<e.near||c>e.far))return{distance:c,point:kp.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}const Bp=new k,zp=new k;class LM extends vi{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){const e=this.geometry;if(e.index===null){const t=e.attributes.position,i=[];for(let s=0,r=t.count;s<r;s+=2)Bp.fromBufferAttribute(t,s),zp.fromBufferAttribute(t,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+Bp.distanceTo(zp);e.setAttribute("lineDistance",new $t(i,1))}else console.warn("THREE.LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}}class IM extends vi{constructor(e,t){super(e,t),this.isLineLoop=!0,this.type="LineLoop"}}class Eg extends $n{constructor(e,t,i=Rr,s,r,o,a=qn,l=qn,c,u=Ra,h=1){if(u!==Ra&&u!==Ca)throw new Error("DepthTexture format must be either THREE.DepthFormat or THREE.DepthStencilFormat");const f={width:e,height:t,depth:h};super(f,s,r,o,a,l,u,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new Rf(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){const t=super.toJSON(e);return this.compareFunction!==null&&(t.compareFunction=this.compareFunction),t}}class bg extends $n{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}}class Fn extends on{constructor(e=1,t=1,i=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:e,radiusBottom:t,height:i,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};const c=this;s=Math.floor(s),r=Math.floor(r);const u=[],h=[],f=[],d=[];let _=0;const x=[],m=i/2;let p=0;S(),o===!1&&(e>0&&w(!0),t>0&&w(!1)),this.setIndex(u),this.setAttribute("position",new $t(h,3)),this.setAttribute("normal",new $t(f,3)),this.setAttribute("uv",new $t(d,2));function S(){const y=new k,L=new k;let R=0;const U=(t-e)/i;for(let N=0;N<=r;N++){const T=[],b=N/r,C=b*(t-e)+e;for(let B=0;B<=s;B++){const z=B/s,X=z*l+a,W=Math.sin(X),q=Math.cos(X);L.x=C*W,L.y=-b*i+m,L.z=C*q,h.push(L.x,L.y,L.z),y.set(W,U,q).normalize(),f.push(y.x,y.y,y.z),d.push(z,1-b),T.push(_++)}x.push(T)}for(let N=0;N<s;N++)for(let T=0;T<r;T++){const b=x[T][N],C=x[T+1][N],B=x[T+1][N+1],z=x[T][N+1];(e>0||T!==0)&&(u.push(b,C,z),R+=3),(t>0||T!==r-1)&&(u.push(C,B,z),R+=3)}c.addGroup(p,R,0),p+=R}function w(y){const L=_,R=new Ke,U=new k;let N=0;const T=y===!0?e:t,b=y===!0?1:-1;for(let B=1;B<=s;B++)h.push(0,m*b,0),f.push(0,b,0),d.push(.5,.5),_++;const C=_;for(let B=0;B<=s;B++){const X=B/s*l+a,W=Math.cos(X),q=Math.sin(X);U.x=T*q,U.y=m*b,U.z=T*W,h.push(U.x,U.y,U.z),f.push(0,b,0),R.x=W*.5+.5,R.y=q*.5*b+.5,d.push(R.x,R.y),_++}for(let B=0;B<s;B++){const z=L+B,X=C+B;y===!0?u.push(X,X+1,z):u.push(X+1,X,z),N+=3}c.addGroup(p,N,y===!0?1:2),p+=N}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new Fn(e.radiusTop,e.radiusBottom,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}}class Lf extends on{constructor(e=[],t=[],i=1,s=0){super(),this.type="PolyhedronGeometry",this.parameters={vertices:e,indices:t,radius:i,detail:s};const r=[],o=[];a(s),c(i),u(),this.setAttribute("position",new $t(r,3)),this.setAttribute("normal",new $t(r.slice(),3)),this.setAttribute("uv",new $t(o,2)),s===0?this.computeVertexNormals():this.normalizeNormals();function a(S){const w=new k,y=new k,L=new k;for(let R=0;R<t.length;R+=3)d(t[R+0],w),d(t[R+1],y),d(t[R+2],L),l(w,y,L,S)}function l(S,w,y,L){const R=L+1,U=[];for(let N=0;N<=R;N++){U[N]=[];const T=S.clone().lerp(y,N/R),b=w.clone().lerp(y,N/R),C=R-N;for(let B=0;B<=C;B++)B===0&&N===R?U[N][B]=T:U[N][B]=T.clone().lerp(b,B/C)}for(let N=0;N<R;N++)for(let T=0;T<2*(R-N)-1;T++){const b=Math.floor(T/2);T%2===0?(f(U[N][b+1]),f(U[N+1][b]),f(U[N][b])):(f(U[N][b+1]),f(U[N+1][b+1]),f(U[N+1][b]))}}function c(S){const w=new k;for(let y=0;y<r.length;y+=3)w.x=r[y+0],w.y=r[y+1],w.z=r[y+2],w.normalize().multiplyScalar(S),r[y+0]=w.x,r[y+1]=w.y,r[y+2]=w.z}function u(){const S=new k;for(let w=0;w<r.length;w+=3){S.x=r[w+0],S.y=r[w+1],S.z=r[w+2];const y=m(S)/2/Math.PI+.5,L=p(S)/Math.PI+.5;o.push(y,1-L)}_(),h()}function h(){for(let S=0;S<o.length;S+=6){const w=o[S+0],y=o[S+2],L=o[S+4],R=Math.max(w,y,L),U=Math.min(w,y,L);R>.9&&U<.1&&(w<.2&&(o[S+0]+=1),y<.2&&(o[S+2]+=1),L<.2&&(o[S+4]+=1))}}function f(S){r.push(S.x,S.y,S.z)}function d(S,w){const y=S*3;w.x=e[y+0],w.y=e[y+1],w.z=e[y+2]}function _(){const S=new k,w=new k,y=new k,L=new k,R=new Ke,U=new Ke,N=new Ke;for(let T=0,b=0;T<r.length;T+=9,b+=6){S.set(r[T+0],r[T+1],r[T+2]),w.set(r[T+3],r[T+4],r[T+5]),y.set(r[T+6],r[T+7],r[T+8]),R.set(o[b+0],o[b+1]),U.set(o[b+2],o[b+3]),N.set(o[b+4],o[b+5]),L.copy(S).add(w).add(y).divideScalar(3);const C=m(L);x(R,b+0,S,C),x(U,b+2,w,C),x(N,b+4,y,C)}}function x(S,w,y,L){L<0&&S.x===1&&(o[w]=S.x-1),y.x===0&&y.z===0&&(o[w]=L/2/Math.PI+.5)}function m(S){return Math.atan2(S.z,-S.x)}function p(S){return Math.atan2(-S.y,Math.sqrt(S.x*S.x+S.z*S.z))}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new Lf(e.vertices,e.indices,e.radius,e.details)}}class ao extends Lf{constructor(e=1,t=0){const i=[1,0,0,-1,0,0,0,1,0,0,-1,0,0,0,1,0,0,-1],s=[0,2,4,0,4,3,0,3,5,0,5,2,1,2,5,1,5,3,1,3,4,1,4,2];super(i,s,e,t),this.type="OctahedronGeometry",this.parameters={radius:e,detail:t}}static fromJSON(e){return new ao(e.radius,e.detail)}}class _s extends on{constructor(e=1,t=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:i,heightSegments:s};const r=e/2,o=t/2,a=Math.floor(i),l=Math.floor(s),c=a+1,u=l+1,h=e/a,f=t/l,d=[],_=[],x=[],m=[];for(let p=0;p<u;p++){const S=p*f-o;for(let w=0;w<c;w++){const y=w*h-r;_.push(y,-S,0),x.push(0,0,1),m.push(w/a),m.push(1-p/l)}}for(let p=0;p<l;p++)for(let S=0;S<a;S++){const w=S+c*p,y=S+c*(p+1),L=S+1+c*(p+1),R=S+1+c*p;d.push(w,y,R),d.push(y,L,R)}this.setIndex(d),this.setAttribute("position",new $t(_,3)),this.setAttribute("normal",new $t(x,3)),this.setAttribute("uv",new $t(m,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new _s(e.width,e.height,e.widthSegments,e.heightSegments)}}class If extends on{constructor(e=1,t=32,i=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:e,widthSegments:t,heightSegments:i,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},t=Math.max(3,Math.floor(t)),i=Math.max(2,Math.floor(i));const l=Math.min(o+a,Math.PI);let c=0;const u=[],h=new k,f=new k,d=[],_=[],x=[],m=[];for(let p=0;p<=i;p++){const S=[],w=p/i;let y=0;p===0&&o===0?y=.5/t:p===i&&l===Math.PI&&(y=-.5/t);for(let L=0;L<=t;L++){const R=L/t;h.x=-e*Math.cos(s+R*r)*Math.sin(o+w*a),h.y=e*Math.cos(o+w*a),h.z=e*Math.sin(s+R*r)*Math.sin(o+w*a),_.push(h.x,h.y,h.z),f.copy(h).normalize(),x.push(f.x,f.y,f.z),m.push(R+y,1-w),S.push(c++)}u.push(S)}for(let p=0;p<i;p++)for(let S=0;S<t;S++){const w=u[p][S+1],y=u[p][S],L=u[p+1][S],R=u[p+1][S+1];(p!==0||o>0)&&d.push(w,y,R),(p!==i-1||l<Math.PI)&&d.push(y,L,R)}this.setIndex(d),this.setAttribute("position",new $t(_,3)),this.setAttribute("normal",new $t(x,3)),this.setAttribute("uv",new $t(m,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new If(e.radius,e.widthSegments,e.heightSegments,e.phiStart,e.phiLength,e.thetaStart,e.thetaLength)}}class _r extends on{constructor(e=1,t=.4,i=12,s=48,r=Math.PI*2){super(),this.type="TorusGeometry",this.parameters={radius:e,tube:t,radialSegments:i,tubularSegments:s,arc:r},i=Math.floor(i),s=Math.floor(s);const o=[],a=[],l=[],c=[],u=new k,h=new k,f=new k;for(let d=0;d<=i;d++)for(let _=0;_<=s;_++){const x=_/s*r,m=d/i*Math.PI*2;h.x=(e+t*Math.cos(m))*Math.cos(x),h.y=(e+t*Math.cos(m))*Math.sin(x),h.z=t*Math.sin(m),a.push(h.x,h.y,h.z),u.x=e*Math.cos(x),u.y=e*Math.sin(x),f.subVectors(h,u).normalize(),l.push(f.x,f.y,f.z),c.push(_/s),c.push(d/i)}for(let d=1;d<=i;d++)for(let _=1;_<=s;_++){const x=(s+1)*d+_-1,m=(s+1)*(d-1)+_-1,p=(s+1)*(d-1)+_,S=(s+1)*d+_;o.push(x,m,S),o.push(m,p,S)}this.setIndex(o),this.setAttribute("position",new $t(a,3)),this.setAttribute("normal",new $t(l,3)),this.setAttribute("uv",new $t(c,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new _r(e.radius,e.tube,e.radialSegments,e.tubularSegments,e.arc)}}class UM extends $s{constructor(e){super(),this.isShadowMaterial=!0,this.type="ShadowMaterial",this.color=new Qe(0),this.transparent=!0,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.fog=e.fog,this}}class NM extends $s{constructor(e){super(),this.isMeshStandardMaterial=!0,this.type="MeshStandardMaterial",this.defines={STANDARD:""},this.color=new Qe(16777215),this.roughness=1,this.metalness=0,this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new Qe(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Af,this.normalScale=new Ke(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.roughnessMap=null,this.metalnessMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new wi,this.envMapIntensity=1,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.defines={STANDARD:""},this.color.copy(e.color),this.roughness=e.roughness,this.metalness=e.metalness,this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.roughnessMap=e.roughnessMap,this.metalnessMap=e.metalnessMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.envMapIntensity=e.envMapIntensity,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}}class FM extends $s{constructor(e){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new Qe(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new Qe(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Af,this.normalScale=new Ke(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new wi,this.combine=xf,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}}class OM extends $s{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Hy,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}}class kM extends $s{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}}class wg extends nn{constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new Qe(e),this.intensity=t}dispose(){}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){const t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,this.groundColor!==void 0&&(t.object.groundColor=this.groundColor.getHex()),this.distance!==void 0&&(t.object.distance=this.distance),this.angle!==void 0&&(t.object.angle=this.angle),this.decay!==void 0&&(t.object.decay=this.decay),this.penumbra!==void 0&&(t.object.penumbra=this.penumbra),this.shadow!==void 0&&(t.object.shadow=this.shadow.toJSON()),this.target!==void 0&&(t.object.target=this.target.uuid),t}}class BM extends wg{constructor(e,t,i){super(e,i),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(nn.DEFAULT_UP),this.updateMatrix(),this.groundColor=new Qe(t)}copy(e,t){return super.copy(e,t),this.groundColor.copy(e.groundColor),this}}const yu=new Pt,Hp=new k,Vp=new k;class zM{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Ke(512,512),this.mapType=es,this.map=null,this.mapPass=null,this.matrix=new Pt,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new Df,this._frameExtents=new Ke(1,1),this._viewportCount=1,this._viewports=[new tn(0,0,1,1)]}getViewportCount(){return this._viewportCount}getFrustum(){return this._frustum}updateMatrices(e){const t=this.camera,i=this.matrix;Hp.setFromMatrixPosition(e.matrixWorld),t.position.copy(Hp),Vp.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(Vp),t.updateMatrixWorld(),yu.multiplyMatrices(t.projectionMatrix,t.matrixWorldInverse),this._frustum.setFromProjectionMatrix(yu,t.coordinateSystem,t.reversedDepth),t.reversedDepth?i.set(.5,0,0,.5,0,.5,0,.5,0,0,1,0,0,0,0,1):i.set(.5,0,0,.5,0,.5,0,.5,0,0,.5,.5,0,0,0,1),i.multiply(yu)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this}clone(){return new this.constructor().copy(this)}toJSON(){const e={};return this.intensity!==1&&(e.intensity=this.intensity),this.bias!==0&&(e.bias=this.bias),this.normalBias!==0&&(e.normalBias=this.normalBias),this.radius!==1&&(e.radius=this.radius),(this.mapSize.x!==512||this.mapSize.y!==512)&&(e.mapSize=this.mapSize.toArray()),e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}}class Uf extends Pf{constructor(e=-1,t=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){const e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2;let r=i-e,o=i+e,a=s+t,l=s-t;if(this.view!==null&&this.view.enabled){const c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){const t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}}class HM extends zM{constructor(){super(new Uf(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}}class Gp extends wg{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(nn.DEFAULT_UP),this.updateMatrix(),this.target=new nn,this.shadow=new HM}dispose(){this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}}class VM extends Mi{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e}}const Wp=new Pt;class Tg{constructor(e,t,i=0,s=1/0){this.ray=new Mc(e,t),this.near=i,this.far=s,this.camera=null,this.layers=new Cf,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(e,t){this.ray.set(e,t)}setFromCamera(e,t){t.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(e.x,e.y,.5).unproject(t).sub(this.ray.origin).normalize(),this.camera=t):t.isOrthographicCamera?(this.ray.origin.set(e.x,e.y,(t.near+t.far)/(t.near-t.far)).unproject(t),this.ray.direction.set(0,0,-1).transformDirection(t.matrixWorld),this.camera=t):console.error("THREE.Raycaster: Unsupported camera type: "+t.type)}setFromXRController(e){return Wp.identity().extractRotation(e.matrixWorld),this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(Wp),this}intersectObject(e,t=!0,i=[]){return Hh(e,this,i,t),i.sort(Xp),i}intersectObjects(e,t=!0,i=[]){for(let s=0,r=e.length;s<r;s++)Hh(e[s],this,i,t);return i.sort(Xp),i}}function Xp(n,e){return n.distance-e.distance}function Hh(n,e,t,i){let s=!0;if(n.layers.test(e.layers)&&n.raycast(e,t)===!1&&(s=!1),s===!0&&i===!0){const r=n.children;for(let o=0,a=r.length;o<a;o++)Hh(r[o],e,t,!0)}}class Yp{constructor(e=1,t=0,i=0){this.radius=e,this.phi=t,this.theta=i}set(e,t,i){return this.radius=e,this.phi=t,this.theta=i,this}copy(e){return this.radius=e.radius,this.phi=e.phi,this.theta=e.theta,this}makeSafe(){return this.phi=ft(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(e){return this.setFromCartesianCoords(e.x,e.y,e.z)}setFromCartesianCoords(e,t,i){return this.radius=Math.sqrt(e*e+t*t+i*i),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(e,i),this.phi=Math.acos(ft(t/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}}class Ag extends LM{constructor(e=1){const t=[0,0,0,e,0,0,0,0,0,0,e,0,0,0,0,0,0,e],i=[1,0,0,1,.6,0,0,1,0,.6,1,0,0,0,1,0,.6,1],s=new on;s.setAttribute("position",new $t(t,3)),s.setAttribute("color",new $t(i,3));const r=new _o({vertexColors:!0,toneMapped:!1});super(s,r),this.type="AxesHelper"}setColors(e,t,i){const s=new Qe,r=this.geometry.attributes.color.array;return s.set(e),s.toArray(r,0),s.toArray(r,3),s.set(t),s.toArray(r,6),s.toArray(r,9),s.set(i),s.toArray(r,12),s.toArray(r,15),this.geometry.attributes.color.needsUpdate=!0,this}dispose(){this.geometry.dispose(),this.material.dispose()}}class Rg extends Dr{constructor(e,t=null){super(),this.object=e,this.domElement=t,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(e){if(e===void 0){console.warn("THREE.Controls: connect() now requires an element.");return}this.domElement!==null&&this.disconnect(),this.domElement=e}disconnect(){}dispose(){}update(){}}function qp(n,e,t,i){const s=GM(i);switch(t){case hg:return n*e;case Ef:return n*e/s.components*s.byteLength;case bf:return n*e/s.components*s.byteLength;case dg:return n*e*2/s.components*s.byteLength;case wf:return n*e*2/s.components*s.byteLength;case fg:return n*e*3/s.components*s.byteLength;case ki:return n*e*4/s.components*s.byteLength;case Tf:return n*e*4/s.components*s.byteLength;case Ll:case Il:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case Ul:case Nl:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case dh:case mh:return Math.max(n,16)*Math.max(e,8)/4;case fh:case ph:return Math.max(n,8)*Math.max(e,8)/2;case _h:case gh:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case vh:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case xh:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case yh:return Math.floor((n+4)/5)*Math.floor((e+3)/4)*16;case Mh:return Math.floor((n+4)/5)*Math.floor((e+4)/5)*16;case Sh:return Math.floor((n+5)/6)*Math.floor((e+4)/5)*16;case Eh:return Math.floor((n+5)/6)*Math.floor((e+5)/6)*16;case bh:return Math.floor((n+7)/8)*Math.floor((e+4)/5)*16;case wh:return Math.floor((n+7)/8)*Math.floor((e+5)/6)*16;case Th:return Math.floor((n+7)/8)*Math.floor((e+7)/8)*16;case Ah:return Math.floor((n+9)/10)*Math.floor((e+4)/5)*16;case Rh:return Math.floor((n+9)/10)*Math.floor((e+5)/6)*16;case Ch:return Math.floor((n+9)/10)*Math.floor((e+7)/8)*16;case Ph:return Math.floor((n+9)/10)*Math.floor((e+9)/10)*16;case Dh:return Math.floor((n+11)/12)*Math.floor((e+9)/10)*16;case Lh:return Math.floor((n+11)/12)*Math.floor((e+11)/12)*16;case Ih:case Uh:case Nh:return Math.ceil(n/4)*Math.ceil(e/4)*16;case Fh:case Oh:return Math.ceil(n/4)*Math.ceil(e/4)*8;case kh:case Bh:return Math.ceil(n/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function GM(n){switch(n){case es:case ag:return{byteLength:1,components:1};case Ta:case lg:case Ia:return{byteLength:2,components:1};case Mf:case Sf:return{byteLength:2,components:4};case Rr:case yf:case Zi:return{byteLength:4,components:1};case cg:case ug:return{byteLength:4,components:3}}throw new Error(`Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:vf}}));typeof window<"u"&&(window.__THREE__?console.warn("WARNING: Multiple instances of Three.js being imported."):window.__THREE__=vf);function Cg(){let n=null,e=!1,t=null,i=null;function s(r,o){t(r,o),i=n.requestAnimationFrame(s)}return{start:function(){e!==!0&&t!==null&&(i=n.requestAnimationFrame(s),e=!0)},stop:function(){n.cancelAnimationFrame(i),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){n=r}}}function WM(n){const e=new WeakMap;function t(a,l){const c=a.array,u=a.usage,h=c.byteLength,f=n.createBuffer();n.bindBuffer(l,f),n.bufferData(l,c,u),a.onUploadCallback();let d;if(c instanceof Float32Array)d=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)d=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?d=n.HALF_FLOAT:d=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)d=n.SHORT;else if(c instanceof Uint32Array)d=n.UNSIGNED_INT;else if(c instanceof Int32Array)d=n.INT;else if(c instanceof Int8Array)d=n.BYTE;else if(c instanceof Uint8Array)d=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)d=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:f,type:d,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:h}}function i(a,l,c){const u=l.array,h=l.updateRanges;if(n.bindBuffer(c,a),h.length===0)n.bufferSubData(c,0,u);else{h.sort((d,_)=>d.start-_.start);let f=0;for(let d=1;d<h.length;d++){const _=h[f],x=h[d];x.start<=_.start+_.count+1?_.count=Math.max(_.count,x.start+x.count-_.start):(++f,h[f]=x)}h.length=f+1;for(let d=0,_=h.length;d<_;d++){const x=h[d];n.bufferSubData(c,x.start*u.BYTES_PER_ELEMENT,u,x.start,x.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);const l=e.get(a);l&&(n.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){const u=e.get(a);(!u||u.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}const c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var XM=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,YM=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,qM=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,$M=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,jM=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,KM=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,ZM=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,JM=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,QM=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec3 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 ).rgb;
	}
#endif`,eS=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,tS=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,nS=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,iS=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,sS=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,rS=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,oS=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,aS=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,lS=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,cS=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,uS=`#if defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#elif defined( USE_COLOR )
	diffuseColor.rgb *= vColor;
#endif`,hS=`#if defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#elif defined( USE_COLOR )
	varying vec3 vColor;
#endif`,fS=`#if defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#elif defined( USE_COLOR ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec3 vColor;
#endif`,dS=`#if defined( USE_COLOR_ALPHA )
	vColor = vec4( 1.0 );
#elif defined( USE_COLOR ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec3( 1.0 );
#endif
#ifdef USE_COLOR
	vColor *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.xyz *= instanceColor.xyz;
#endif
#ifdef USE_BATCHING_COLOR
	vec3 batchingColor = getBatchingColor( getIndirectIndex( gl_DrawID ) );
	vColor.xyz *= batchingColor.xyz;
#endif`,pS=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
vec3 inverseTransformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( vec4( dir, 0.0 ) * matrix ).xyz );
}
mat3 transposeMat3( const in mat3 m ) {
	mat3 tmp;
	tmp[ 0 ] = vec3( m[ 0 ].x, m[ 1 ].x, m[ 2 ].x );
	tmp[ 1 ] = vec3( m[ 0 ].y, m[ 1 ].y, m[ 2 ].y );
	tmp[ 2 ] = vec3( m[ 0 ].z, m[ 1 ].z, m[ 2 ].z );
	return tmp;
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,mS=`#ifdef ENVMAP_TYPE_CUBE_UV
	#define cubeUV_minMipLevel 4.0
	#define cubeUV_minTileSize 16.0
	float getFace( vec3 direction ) {
		vec3 absDirection = abs( direction );
		float face = - 1.0;
		if ( absDirection.x > absDirection.z ) {
			if ( absDirection.x > absDirection.y )
				face = direction.x > 0.0 ? 0.0 : 3.0;
			else
				face = direction.y > 0.0 ? 1.0 : 4.0;
		} else {
			if ( absDirection.z > absDirection.y )
				face = direction.z > 0.0 ? 2.0 : 5.0;
			else
				face = direction.y > 0.0 ? 1.0 : 4.0;
		}
		return face;
	}
	vec2 getUV( vec3 direction, float face ) {
		vec2 uv;
		if ( face == 0.0 ) {
			uv = vec2( direction.z, direction.y ) / abs( direction.x );
		} else if ( face == 1.0 ) {
			uv = vec2( - direction.x, - direction.z ) / abs( direction.y );
		} else if ( face == 2.0 ) {
			uv = vec2( - direction.x, direction.y ) / abs( direction.z );
		} else if ( face == 3.0 ) {
			uv = vec2( - direction.z, direction.y ) / abs( direction.x );
		} else if ( face == 4.0 ) {
			uv = vec2( - direction.x, direction.z ) / abs( direction.y );
		} else {
			uv = vec2( direction.x, direction.y ) / abs( direction.z );
		}
		return 0.5 * ( uv + 1.0 );
	}
	vec3 bilinearCubeUV( sampler2D envMap, vec3 direction, float mipInt ) {
		float face = getFace( direction );
		float filterInt = max( cubeUV_minMipLevel - mipInt, 0.0 );
		mipInt = max( mipInt, cubeUV_minMipLevel );
		float faceSize = exp2( mipInt );
		highp vec2 uv = getUV( direction, face ) * ( faceSize - 2.0 ) + 1.0;
		if ( face > 2.0 ) {
			uv.y += faceSize;
			face -= 3.0;
		}
		uv.x += face * faceSize;
		uv.x += filterInt * 3.0 * cubeUV_minTileSize;
		uv.y += 4.0 * ( exp2( CUBEUV_MAX_MIP ) - faceSize );
		uv.x *= CUBEUV_TEXEL_WIDTH;
		uv.y *= CUBEUV_TEXEL_HEIGHT;
		#ifdef texture2DGradEXT
			return texture2DGradEXT( envMap, uv, vec2( 0.0 ), vec2( 0.0 ) ).rgb;
		#else
			return texture2D( envMap, uv ).rgb;
		#endif
	}
	#define cubeUV_r0 1.0
	#define cubeUV_m0 - 2.0
	#define cubeUV_r1 0.8
	#define cubeUV_m1 - 1.0
	#define cubeUV_r4 0.4
	#define cubeUV_m4 2.0
	#define cubeUV_r5 0.305
	#define cubeUV_m5 3.0
	#define cubeUV_r6 0.21
	#define cubeUV_m6 4.0
	float roughnessToMip( float roughness ) {
		float mip = 0.0;
		if ( roughness >= cubeUV_r1 ) {
			mip = ( cubeUV_r0 - roughness ) * ( cubeUV_m1 - cubeUV_m0 ) / ( cubeUV_r0 - cubeUV_r1 ) + cubeUV_m0;
		} else if ( roughness >= cubeUV_r4 ) {
			mip = ( cubeUV_r1 - roughness ) * ( cubeUV_m4 - cubeUV_m1 ) / ( cubeUV_r1 - cubeUV_r4 ) + cubeUV_m1;
		} else if ( roughness >= cubeUV_r5 ) {
			mip = ( cubeUV_r4 - roughness ) * ( cubeUV_m5 - cubeUV_m4 ) / ( cubeUV_r4 - cubeUV_r5 ) + cubeUV_m4;
		} else if ( roughness >= cubeUV_r6 ) {
			mip = ( cubeUV_r5 - roughness ) * ( cubeUV_m6 - cubeUV_m5 ) / ( cubeUV_r5 - cubeUV_r6 ) + cubeUV_m5;
		} else {
			mip = - 2.0 * log2( 1.16 * roughness );		}
		return mip;
	}
	vec4 textureCubeUV( sampler2D envMap, vec3 sampleDir, float roughness ) {
		float mip = clamp( roughnessToMip( roughness ), cubeUV_m0, CUBEUV_MAX_MIP );
		float mipF = fract( mip );
		float mipInt = floor( mip );
		vec3 color0 = bilinearCubeUV( envMap, sampleDir, mipInt );
		if ( mipF == 0.0 ) {
			return vec4( color0, 1.0 );
		} else {
			vec3 color1 = bilinearCubeUV( envMap, sampleDir, mipInt + 1.0 );
			return vec4( mix( color0, color1, mipF ), 1.0 );
		}
	}
#endif`,_S=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
	#ifdef FLIP_SIDED
		transformedTangent = - transformedTangent;
	#endif
#endif`,gS=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,vS=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,xS=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,yS=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,MS="gl_FragColor = linearToOutputTexel( gl_FragColor );",SS=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,ES=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = inverseTransformDirection( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * vec3( flipEnvMap * reflectVec.x, reflectVec.yz ) );
	#else
		vec4 envColor = vec4( 0.0 );
	#endif
	#ifdef ENVMAP_BLENDING_MULTIPLY
		outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
	#elif defined( ENVMAP_BLENDING_MIX )
		outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
	#elif defined( ENVMAP_BLENDING_ADD )
		outgoingLight += envColor.xyz * specularStrength * reflectivity;
	#endif
#endif`,bS=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform float flipEnvMap;
	uniform mat3 envMapRotation;
	#ifdef ENVMAP_TYPE_CUBE
		uniform samplerCube envMap;
	#else
		uniform sampler2D envMap;
	#endif
	
#endif`,wS=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,TS=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,AS=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = inverseTransformDirection( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,RS=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,CS=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,PS=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,DS=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,LS=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,IS=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,US=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,NS=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,FS=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = inverseTransformDirection( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif`,OS=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_CUBE_UV
			vec3 worldNormal = inverseTransformDirection( normal, viewMatrix );
			vec4 envMapColor = textureCubeUV( envMap, envMapRotation * worldNormal, 1.0 );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_CUBE_UV
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, roughness * roughness) );
			reflectVec = inverseTransformDirection( reflectVec, viewMatrix );
			vec4 envMapColor = textureCubeUV( envMap, envMapRotation * reflectVec, roughness );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_CUBE_UV
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
#endif`,kS=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,BS=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,zS=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,HS=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,VS=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb * ( 1.0 - metalnessFactor );
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.0525 );material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = mix( min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = mix( vec3( 0.04 ), diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.0525 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.07, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,GS=`struct PhysicalMaterial {
	vec3 diffuseColor;
	float roughness;
	vec3 specularColor;
	float specularF90;
	float dispersion;
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		float v = 0.5 / ( gv + gl );
		return saturate(v);
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = material.clearcoatRoughness;
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColor;
	float f90 = material.specularF90;
	float roughness = material.roughness;
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float V = V_GGX_SmithCorrelated_Anisotropic( material.alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( material.alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transposeMat3( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float a = roughness < 0.25 ? -339.2 * r2 + 161.4 * roughness - 25.9 : -8.48 * r2 + 14.3 * roughness - 9.95;
	float b = roughness < 0.25 ? 44.0 * r2 - 23.7 * roughness + 3.26 : 1.97 * r2 - 3.27 * roughness + 0.72;
	float DG = exp( a * dotNV + b ) + ( roughness < 0.25 ? 0.0 : 0.1 * ( roughness - 0.25 ) );
	return saturate( DG * RECIPROCAL_PI );
}
vec2 DFGApprox( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	const vec4 c0 = vec4( - 1, - 0.0275, - 0.572, 0.022 );
	const vec4 c1 = vec4( 1, 0.0425, 1.04, - 0.04 );
	vec4 r = roughness * c0 + c1;
	float a004 = min( r.x * r.x, exp2( - 9.28 * dotNV ) ) * r.x + r.y;
	vec2 fab = vec2( - 1.04, 1.04 ) * a004 + r.zw;
	return fab;
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	vec2 fab = DFGApprox( normal, viewDir, roughness );
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, const in float roughness, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	vec2 fab = DFGApprox( normal, viewDir, roughness );
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColor * t2.x + ( vec3( 1.0 ) - material.specularColor ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseColor * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
	#endif
	reflectedLight.directSpecular += irradiance * BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
	#endif
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( geometryNormal, geometryViewDir, material.specularColor, material.specularF90, material.iridescence, material.iridescenceFresnel, material.roughness, singleScattering, multiScattering );
	#else
		computeMultiscattering( geometryNormal, geometryViewDir, material.specularColor, material.specularF90, material.roughness, singleScattering, multiScattering );
	#endif
	vec3 totalScattering = singleScattering + multiScattering;
	vec3 diffuse = material.diffuseColor * ( 1.0 - max( max( totalScattering.r, totalScattering.g ), totalScattering.b ) );
	reflectedLight.indirectSpecular += radiance * singleScattering;
	reflectedLight.indirectSpecular += multiScattering * cosineWeightedIrradiance;
	reflectedLight.indirectDiffuse += diffuse * cosineWeightedIrradiance;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,WS=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		material.iridescenceFresnel = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		material.iridescenceF0 = Schlick_to_F0( material.iridescenceFresnel, 1.0, dotNVi );
	}
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,XS=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD ) && defined( ENVMAP_TYPE_CUBE_UV )
		iblIrradiance += getIBLIrradiance( geometryNormal );
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		radiance += getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		radiance += getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,YS=`#if defined( RE_IndirectDiffuse )
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,qS=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,$S=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,jS=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,KS=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,ZS=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,JS=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,QS=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,eE=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,tE=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,nE=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,iE=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,sE=`#if defined( USE_MORPHCOLORS )
	vColor *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,rE=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,oE=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,aE=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,lE=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#if defined( DOUBLE_SIDED ) && ! defined( FLAT_SHADED )
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#if defined( DOUBLE_SIDED ) && ! defined( FLAT_SHADED )
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,cE=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,uE=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,hE=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,fE=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
	#endif
#endif`,dE=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,pE=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,mE=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,_E=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,gE=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,vE=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,xE=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	return depth * ( near - far ) - near;
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	return ( near * far ) / ( ( far - near ) * depth - far );
}`,yE=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,ME=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,SE=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,EE=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,bE=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,wE=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,TE=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform sampler2D pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	float texture2DCompare( sampler2D depths, vec2 uv, float compare ) {
		float depth = unpackRGBAToDepth( texture2D( depths, uv ) );
		#ifdef USE_REVERSED_DEPTH_BUFFER
			return step( depth, compare );
		#else
			return step( compare, depth );
		#endif
	}
	vec2 texture2DDistribution( sampler2D shadow, vec2 uv ) {
		return unpackRGBATo2Half( texture2D( shadow, uv ) );
	}
	float VSMShadow( sampler2D shadow, vec2 uv, float compare ) {
		float occlusion = 1.0;
		vec2 distribution = texture2DDistribution( shadow, uv );
		#ifdef USE_REVERSED_DEPTH_BUFFER
			float hard_shadow = step( distribution.x, compare );
		#else
			float hard_shadow = step( compare, distribution.x );
		#endif
		if ( hard_shadow != 1.0 ) {
			float distance = compare - distribution.x;
			float variance = max( 0.00000, distribution.y * distribution.y );
			float softness_probability = variance / (variance + distance * distance );			softness_probability = clamp( ( softness_probability - 0.3 ) / ( 0.95 - 0.3 ), 0.0, 1.0 );			occlusion = clamp( max( hard_shadow, softness_probability ), 0.0, 1.0 );
		}
		return occlusion;
	}
	float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
		float shadow = 1.0;
		shadowCoord.xyz /= shadowCoord.w;
		shadowCoord.z += shadowBias;
		bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
		bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
		if ( frustumTest ) {
		#if defined( SHADOWMAP_TYPE_PCF )
			vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
			float dx0 = - texelSize.x * shadowRadius;
			float dy0 = - texelSize.y * shadowRadius;
			float dx1 = + texelSize.x * shadowRadius;
			float dy1 = + texelSize.y * shadowRadius;
			float dx2 = dx0 / 2.0;
			float dy2 = dy0 / 2.0;
			float dx3 = dx1 / 2.0;
			float dy3 = dy1 / 2.0;
			shadow = (
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx0, dy0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( 0.0, dy0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx1, dy0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx2, dy2 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( 0.0, dy2 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx3, dy2 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx0, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx2, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy, shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx3, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx1, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx2, dy3 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( 0.0, dy3 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx3, dy3 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx0, dy1 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( 0.0, dy1 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx1, dy1 ), shadowCoord.z )
			) * ( 1.0 / 17.0 );
		#elif defined( SHADOWMAP_TYPE_PCF_SOFT )
			vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
			float dx = texelSize.x;
			float dy = texelSize.y;
			vec2 uv = shadowCoord.xy;
			vec2 f = fract( uv * shadowMapSize + 0.5 );
			uv -= f * texelSize;
			shadow = (
				texture2DCompare( shadowMap, uv, shadowCoord.z ) +
				texture2DCompare( shadowMap, uv + vec2( dx, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, uv + vec2( 0.0, dy ), shadowCoord.z ) +
				texture2DCompare( shadowMap, uv + texelSize, shadowCoord.z ) +
				mix( texture2DCompare( shadowMap, uv + vec2( -dx, 0.0 ), shadowCoord.z ),
					 texture2DCompare( shadowMap, uv + vec2( 2.0 * dx, 0.0 ), shadowCoord.z ),
					 f.x ) +
				mix( texture2DCompare( shadowMap, uv + vec2( -dx, dy ), shadowCoord.z ),
					 texture2DCompare( shadowMap, uv + vec2( 2.0 * dx, dy ), shadowCoord.z ),
					 f.x ) +
				mix( texture2DCompare( shadowMap, uv + vec2( 0.0, -dy ), shadowCoord.z ),
					 texture2DCompare( shadowMap, uv + vec2( 0.0, 2.0 * dy ), shadowCoord.z ),
					 f.y ) +
				mix( texture2DCompare( shadowMap, uv + vec2( dx, -dy ), shadowCoord.z ),
					 texture2DCompare( shadowMap, uv + vec2( dx, 2.0 * dy ), shadowCoord.z ),
					 f.y ) +
				mix( mix( texture2DCompare( shadowMap, uv + vec2( -dx, -dy ), shadowCoord.z ),
						  texture2DCompare( shadowMap, uv + vec2( 2.0 * dx, -dy ), shadowCoord.z ),
						  f.x ),
					 mix( texture2DCompare( shadowMap, uv + vec2( -dx, 2.0 * dy ), shadowCoord.z ),
						  texture2DCompare( shadowMap, uv + vec2( 2.0 * dx, 2.0 * dy ), shadowCoord.z ),
						  f.x ),
					 f.y )
			) * ( 1.0 / 9.0 );
		#elif defined( SHADOWMAP_TYPE_VSM )
			shadow = VSMShadow( shadowMap, shadowCoord.xy, shadowCoord.z );
		#else
			shadow = texture2DCompare( shadowMap, shadowCoord.xy, shadowCoord.z );
		#endif
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	vec2 cubeToUV( vec3 v, float texelSizeY ) {
		vec3 absV = abs( v );
		float scaleToCube = 1.0 / max( absV.x, max( absV.y, absV.z ) );
		absV *= scaleToCube;
		v *= scaleToCube * ( 1.0 - 2.0 * texelSizeY );
		vec2 planar = v.xy;
		float almostATexel = 1.5 * texelSizeY;
		float almostOne = 1.0 - almostATexel;
		if ( absV.z >= almostOne ) {
			if ( v.z > 0.0 )
				planar.x = 4.0 - v.x;
		} else if ( absV.x >= almostOne ) {
			float signX = sign( v.x );
			planar.x = v.z * signX + 2.0 * signX;
		} else if ( absV.y >= almostOne ) {
			float signY = sign( v.y );
			planar.x = v.x + 2.0 * signY + 2.0;
			planar.y = v.z * signY - 2.0;
		}
		return vec2( 0.125, 0.25 ) * planar + vec2( 0.375, 0.75 );
	}
	float getPointShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		
		float lightToPositionLength = length( lightToPosition );
		if ( lightToPositionLength - shadowCameraFar <= 0.0 && lightToPositionLength - shadowCameraNear >= 0.0 ) {
			float dp = ( lightToPositionLength - shadowCameraNear ) / ( shadowCameraFar - shadowCameraNear );			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			vec2 texelSize = vec2( 1.0 ) / ( shadowMapSize * vec2( 4.0, 2.0 ) );
			#if defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_PCF_SOFT ) || defined( SHADOWMAP_TYPE_VSM )
				vec2 offset = vec2( - 1, 1 ) * shadowRadius * texelSize.y;
				shadow = (
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.xyy, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.yyy, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.xyx, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.yyx, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.xxy, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.yxy, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.xxx, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.yxx, texelSize.y ), dp )
				) * ( 1.0 / 9.0 );
			#else
				shadow = texture2DCompare( shadowMap, cubeToUV( bd3D, texelSize.y ), dp );
			#endif
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
#endif`,AE=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,RE=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	vec3 shadowWorldNormal = inverseTransformDirection( transformedNormal, viewMatrix );
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,CE=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,PE=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,DE=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,LE=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,IE=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,UE=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,NE=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,FE=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,OE=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,kE=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = inverseTransformDirection( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseColor, material.specularColor, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,BE=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,zE=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,HE=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,VE=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,GE=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`;const WE=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,XE=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,YE=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,qE=`#ifdef ENVMAP_TYPE_CUBE
	uniform samplerCube envMap;
#elif defined( ENVMAP_TYPE_CUBE_UV )
	uniform sampler2D envMap;
#endif
uniform float flipEnvMap;
uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <cube_uv_reflection_fragment>
void main() {
	#ifdef ENVMAP_TYPE_CUBE
		vec4 texColor = textureCube( envMap, backgroundRotation * vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) );
	#elif defined( ENVMAP_TYPE_CUBE_UV )
		vec4 texColor = textureCubeUV( envMap, backgroundRotation * vWorldDirection, backgroundBlurriness );
	#else
		vec4 texColor = vec4( 0.0, 0.0, 0.0, 1.0 );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,$E=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,jE=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,KE=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,ZE=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,JE=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,QE=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main () {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = packDepthToRGBA( dist );
}`,eb=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,tb=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,nb=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,ib=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,sb=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,rb=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,ob=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,ab=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <packing>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,lb=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,cb=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,ub=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,hb=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <packing>
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( packNormalToRGB( normal ), diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,fb=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,db=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <packing>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,pb=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,mb=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <packing>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <cube_uv_reflection_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
		float sheenEnergyComp = 1.0 - 0.157 * max3( material.sheenColor );
		outgoingLight = outgoingLight * sheenEnergyComp + sheenSpecularDirect + sheenSpecularIndirect;
	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,_b=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,gb=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <packing>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,vb=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,xb=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,yb=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Mb=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <packing>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,Sb=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,Eb=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,ut={alphahash_fragment:XM,alphahash_pars_fragment:YM,alphamap_fragment:qM,alphamap_pars_fragment:$M,alphatest_fragment:jM,alphatest_pars_fragment:KM,aomap_fragment:ZM,aomap_pars_fragment:JM,batching_pars_vertex:QM,batching_vertex:eS,begin_vertex:tS,beginnormal_vertex:nS,bsdfs:iS,iridescence_fragment:sS,bumpmap_pars_fragment:rS,clipping_planes_fragment:oS,clipping_planes_pars_fragment:aS,clipping_planes_pars_vertex:lS,clipping_planes_vertex:cS,color_fragment:uS,color_pars_fragment:hS,color_pars_vertex:fS,color_vertex:dS,common:pS,cube_uv_reflection_fragment:mS,defaultnormal_vertex:_S,displacementmap_pars_vertex:gS,displacementmap_vertex:vS,emissivemap_fragment:xS,emissivemap_pars_fragment:yS,colorspace_fragment:MS,colorspace_pars_fragment:SS,envmap_fragment:ES,envmap_common_pars_fragment:bS,envmap_pars_fragment:wS,envmap_pars_vertex:TS,envmap_physical_pars_fragment:OS,envmap_vertex:AS,fog_vertex:RS,fog_pars_vertex:CS,fog_fragment:PS,fog_pars_fragment:DS,gradientmap_pars_fragment:LS,lightmap_pars_fragment:IS,lights_lambert_fragment:US,lights_lambert_pars_fragment:NS,lights_pars_begin:FS,lights_toon_fragment:kS,lights_toon_pars_fragment:BS,lights_phong_fragment:zS,lights_phong_pars_fragment:HS,lights_physical_fragment:VS,lights_physical_pars_fragment:GS,lights_fragment_begin:WS,lights_fragment_maps:XS,lights_fragment_end:YS,logdepthbuf_fragment:qS,logdepthbuf_pars_fragment:$S,logdepthbuf_pars_vertex:jS,logdepthbuf_vertex:KS,map_fragment:ZS,map_pars_fragment:JS,map_particle_fragment:QS,map_particle_pars_fragment:eE,metalnessmap_fragment:tE,metalnessmap_pars_fragment:nE,morphinstance_vertex:iE,morphcolor_vertex:sE,morphnormal_vertex:rE,morphtarget_pars_vertex:oE,morphtarget_vertex:aE,normal_fragment_begin:lE,normal_fragment_maps:cE,normal_pars_fragment:uE,normal_pars_vertex:hE,normal_vertex:fE,normalmap_pars_fragment:dE,clearcoat_normal_fragment_begin:pE,clearcoat_normal_fragment_maps:mE,clearcoat_pars_fragment:_E,iridescence_pars_fragment:gE,opaque_fragment:vE,packing:xE,premultiplied_alpha_fragment:yE,project_vertex:ME,dithering_fragment:SE,dithering_pars_fragment:EE,roughnessmap_fragment:bE,roughnessmap_pars_fragment:wE,shadowmap_pars_fragment:TE,shadowmap_pars_vertex:AE,shadowmap_vertex:RE,shadowmask_pars_fragment:CE,skinbase_vertex:PE,skinning_pars_vertex:DE,skinning_vertex:LE,skinnormal_vertex:IE,specularmap_fragment:UE,specularmap_pars_fragment:NE,tonemapping_fragment:FE,tonemapping_pars_fragment:OE,transmission_fragment:kE,transmission_pars_fragment:BE,uv_pars_fragment:zE,uv_pars_vertex:HE,uv_vertex:VE,worldpos_vertex:GE,background_vert:WE,background_frag:XE,backgroundCube_vert:YE,backgroundCube_frag:qE,cube_vert:$E,cube_frag:jE,depth_vert:KE,depth_frag:ZE,distanceRGBA_vert:JE,distanceRGBA_frag:QE,equirect_vert:eb,equirect_frag:tb,linedashed_vert:nb,linedashed_frag:ib,meshbasic_vert:sb,meshbasic_frag:rb,meshlambert_vert:ob,meshlambert_frag:ab,meshmatcap_vert:lb,meshmatcap_frag:cb,meshnormal_vert:ub,meshnormal_frag:hb,meshphong_vert:fb,meshphong_frag:db,meshphysical_vert:pb,meshphysical_frag:mb,meshtoon_vert:_b,meshtoon_frag:gb,points_vert:vb,points_frag:xb,shadow_vert:yb,shadow_frag:Mb,sprite_vert:Sb,sprite_frag:Eb},be={common:{diffuse:{value:new Qe(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new lt},alphaMap:{value:null},alphaMapTransform:{value:new lt},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new lt}},envmap:{envMap:{value:null},envMapRotation:{value:new lt},flipEnvMap:{value:-1},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new lt}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new lt}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new lt},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new lt},normalScale:{value:new Ke(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new lt},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new lt}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new lt}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new lt}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new Qe(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMap:{value:[]},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotShadowMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMap:{value:[]},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null}},points:{diffuse:{value:new Qe(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new lt},alphaTest:{value:0},uvTransform:{value:new lt}},sprite:{diffuse:{value:new Qe(16777215)},opacity:{value:1},center:{value:new Ke(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new lt},alphaMap:{value:null},alphaMapTransform:{value:new lt},alphaTest:{value:0}}},$i={basic:{uniforms:Xn([be.common,be.specularmap,be.envmap,be.aomap,be.lightmap,be.fog]),vertexShader:ut.meshbasic_vert,fragmentShader:ut.meshbasic_frag},lambert:{uniforms:Xn([be.common,be.specularmap,be.envmap,be.aomap,be.lightmap,be.emissivemap,be.bumpmap,be.normalmap,be.displacementmap,be.fog,be.lights,{emissive:{value:new Qe(0)}}]),vertexShader:ut.meshlambert_vert,fragmentShader:ut.meshlambert_frag},phong:{uniforms:Xn([be.common,be.specularmap,be.envmap,be.aomap,be.lightmap,be.emissivemap,be.bumpmap,be.normalmap,be.displacementmap,be.fog,be.lights,{emissive:{value:new Qe(0)},specular:{value:new Qe(1118481)},shininess:{value:30}}]),vertexShader:ut.meshphong_vert,fragmentShader:ut.meshphong_frag},standard:{uniforms:Xn([be.common,be.envmap,be.aomap,be.lightmap,be.emissivemap,be.bumpmap,be.normalmap,be.displacementmap,be.roughnessmap,be.metalnessmap,be.fog,be.lights,{emissive:{value:new Qe(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:ut.meshphysical_vert,fragmentShader:ut.meshphysical_frag},toon:{uniforms:Xn([be.common,be.aomap,be.lightmap,be.emissivemap,be.bumpmap,be.normalmap,be.displacementmap,be.gradientmap,be.fog,be.lights,{emissive:{value:new Qe(0)}}]),vertexShader:ut.meshtoon_vert,fragmentShader:ut.meshtoon_frag},matcap:{uniforms:Xn([be.common,be.bumpmap,be.normalmap,be.displacementmap,be.fog,{matcap:{value:null}}]),vertexShader:ut.meshmatcap_vert,fragmentShader:ut.meshmatcap_frag},points:{uniforms:Xn([be.points,be.fog]),vertexShader:ut.points_vert,fragmentShader:ut.points_frag},dashed:{uniforms:Xn([be.common,be.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:ut.linedashed_vert,fragmentShader:ut.linedashed_frag},depth:{uniforms:Xn([be.common,be.displacementmap]),vertexShader:ut.depth_vert,fragmentShader:ut.depth_frag},normal:{uniforms:Xn([be.common,be.bumpmap,be.normalmap,be.displacementmap,{opacity:{value:1}}]),vertexShader:ut.meshnormal_vert,fragmentShader:ut.meshnormal_frag},sprite:{uniforms:Xn([be.sprite,be.fog]),vertexShader:ut.sprite_vert,fragmentShader:ut.sprite_frag},background:{uniforms:{uvTransform:{value:new lt},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:ut.background_vert,fragmentShader:ut.background_frag},backgroundCube:{uniforms:{envMap:{value:null},flipEnvMap:{value:-1},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new lt}},vertexShader:ut.backgroundCube_vert,fragmentShader:ut.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:ut.cube_vert,fragmentShader:ut.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:ut.equirect_vert,fragmentShader:ut.equirect_frag},distanceRGBA:{uniforms:Xn([be.common,be.displacementmap,{referencePosition:{value:new k},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:ut.distanceRGBA_vert,fragmentShader:ut.distanceRGBA_frag},shadow:{uniforms:Xn([be.lights,be.fog,{color:{value:new Qe(0)},opacity:{value:1}}]),vertexShader:ut.shadow_vert,fragmentShader:ut.shadow_frag}};$i.physical={uniforms:Xn([$i.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new lt},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new lt},clearcoatNormalScale:{value:new Ke(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new lt},dispersion:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new lt},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new lt},sheen:{value:0},sheenColor:{value:new Qe(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new lt},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new lt},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new lt},transmissionSamplerSize:{value:new Ke},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new lt},attenuationDistance:{value:0},attenuationColor:{value:new Qe(0)},specularColor:{value:new Qe(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new lt},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new lt},anisotropyVector:{value:new Ke},anisotropyMap:{value:null},anisotropyMapTransform:{value:new lt}}]),vertexShader:ut.meshphysical_vert,fragmentShader:ut.meshphysical_frag};const gl={r:0,b:0,g:0},rr=new wi,bb=new Pt;function wb(n,e,t,i,s,r,o){const a=new Qe(0);let l=r===!0?0:1,c,u,h=null,f=0,d=null;function _(w){let y=w.isScene===!0?w.background:null;return y&&y.isTexture&&(y=(w.backgroundBlurriness>0?t:e).get(y)),y}function x(w){let y=!1;const L=_(w);L===null?p(a,l):L&&L.isColor&&(p(L,1),y=!0);const R=n.xr.getEnvironmentBlendMode();R==="additive"?i.buffers.color.setClear(0,0,0,1,o):R==="alpha-blend"&&i.buffers.color.setClear(0,0,0,0,o),(n.autoClear||y)&&(i.buffers.depth.setTest(!0),i.buffers.depth.setMask(!0),i.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function m(w,y){const L=_(y);L&&(L.isCubeTexture||L.mapping===yc)?(u===void 0&&(u=new Ee(new cn(1,1,1),new ts({name:"BackgroundCubeMaterial",uniforms:Co($i.backgroundCube.uniforms),vertexShader:$i.backgroundCube.vertexShader,fragmentShader:$i.backgroundCube.fragmentShader,side:ei,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),u.geometry.deleteAttribute("normal"),u.geometry.deleteAttribute("uv"),u.onBeforeRender=function(R,U,N){this.matrixWorld.copyPosition(N.matrixWorld)},Object.defineProperty(u.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),s.update(u)),rr.copy(y.backgroundRotation),rr.x*=-1,rr.y*=-1,rr.z*=-1,L.isCubeTexture&&L.isRenderTargetTexture===!1&&(rr.y*=-1,rr.z*=-1),u.material.uniforms.envMap.value=L,u.material.uniforms.flipEnvMap.value=L.isCubeTexture&&L.isRenderTargetTexture===!1?-1:1,u.material.uniforms.backgroundBlurriness.value=y.backgroundBlurriness,u.material.uniforms.backgroundIntensity.value=y.backgroundIntensity,u.material.uniforms.backgroundRotation.value.setFromMatrix4(bb.makeRotationFromEuler(rr)),u.material.toneMapped=Mt.getTransfer(L.colorSpace)!==It,(h!==L||f!==L.version||d!==n.toneMapping)&&(u.material.needsUpdate=!0,h=L,f=L.version,d=n.toneMapping),u.layers.enableAll(),w.unshift(u,u.geometry,u.material,0,0,null)):L&&L.isTexture&&(c===void 0&&(c=new Ee(new _s(2,2),new ts({name:"BackgroundMaterial",uniforms:Co($i.background.uniforms),vertexShader:$i.background.vertexShader,fragmentShader:$i.background.fragmentShader,side:ys,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),Object.defineProperty(c.material,"map",{get:function(){return this.uniforms.t2D.value}}),s.update(c)),c.material.uniforms.t2D.value=L,c.material.uniforms.backgroundIntensity.value=y.backgroundIntensity,c.material.toneMapped=Mt.getTransfer(L.colorSpace)!==It,L.matrixAutoUpdate===!0&&L.updateMatrix(),c.material.uniforms.uvTransform.value.copy(L.matrix),(h!==L||f!==L.version||d!==n.toneMapping)&&(c.material.needsUpdate=!0,h=L,f=L.version,d=n.toneMapping),c.layers.enableAll(),w.unshift(c,c.geometry,c.material,0,0,null))}function p(w,y){w.getRGB(gl,yg(n)),i.buffers.color.setClear(gl.r,gl.g,gl.b,y,o)}function S(){u!==void 0&&(u.geometry.dispose(),u.material.dispose(),u=void 0),c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0)}return{getClearColor:function(){return a},setClearColor:function(w,y=1){a.set(w),l=y,p(a,l)},getClearAlpha:function(){return l},setClearAlpha:function(w){l=w,p(a,l)},render:x,addToRenderList:m,dispose:S}}function Tb(n,e){const t=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=f(null);let r=s,o=!1;function a(b,C,B,z,X){let W=!1;const q=h(z,B,C);r!==q&&(r=q,c(r.object)),W=d(b,z,B,X),W&&_(b,z,B,X),X!==null&&e.update(X,n.ELEMENT_ARRAY_BUFFER),(W||o)&&(o=!1,y(b,C,B,z),X!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,e.get(X).buffer))}function l(){return n.createVertexArray()}function c(b){return n.bindVertexArray(b)}function u(b){return n.deleteVertexArray(b)}function h(b,C,B){const z=B.wireframe===!0;let X=i[b.id];X===void 0&&(X={},i[b.id]=X);let W=X[C.id];W===void 0&&(W={},X[C.id]=W);let q=W[z];return q===void 0&&(q=f(l()),W[z]=q),q}function f(b){const C=[],B=[],z=[];for(let X=0;X<t;X++)C[X]=0,B[X]=0,z[X]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:C,enabledAttributes:B,attributeDivisors:z,object:b,attributes:{},index:null}}function d(b,C,B,z){const X=r.attributes,W=C.attributes;let q=0;const j=B.getAttributes();for(const Z in j)if(j[Z].location>=0){const ae=X[Z];let me=W[Z];if(me===void 0&&(Z==="instanceMatrix"&&b.instanceMatrix&&(me=b.instanceMatrix),Z==="instanceColor"&&b.instanceColor&&(me=b.instanceColor)),ae===void 0||ae.attribute!==me||me&&ae.data!==me.data)return!0;q++}return r.attributesNum!==q||r.index!==z}function _(b,C,B,z){const X={},W=C.attributes;let q=0;const j=B.getAttributes();for(const Z in j)if(j[Z].location>=0){let ae=W[Z];ae===void 0&&(Z==="instanceMatrix"&&b.instanceMatrix&&(ae=b.instanceMatrix),Z==="instanceColor"&&b.instanceColor&&(ae=b.instanceColor));const me={};me.attribute=ae,ae&&ae.data&&(me.data=ae.data),X[Z]=me,q++}r.attributes=X,r.attributesNum=q,r.index=z}function x(){const b=r.newAttributes;for(let C=0,B=b.length;C<B;C++)b[C]=0}function m(b){p(b,0)}function p(b,C){const B=r.newAttributes,z=r.enabledAttributes,X=r.attributeDivisors;B[b]=1,z[b]===0&&(n.enableVertexAttribArray(b),z[b]=1),X[b]!==C&&(n.vertexAttribDivisor(b,C),X[b]=C)}function S(){const b=r.newAttributes,C=r.enabledAttributes;for(let B=0,z=C.length;B<z;B++)C[B]!==b[B]&&(n.disableVertexAttribArray(B),C[B]=0)}function w(b,C,B,z,X,W,q){q===!0?n.vertexAttribIPointer(b,C,B,X,W):n.vertexAttribPointer(b,C,B,z,X,W)}function y(b,C,B,z){x();const X=z.attributes,W=B.getAttributes(),q=C.defaultAttributeValues;for(const j in W){const Z=W[j];if(Z.location>=0){let re=X[j];if(re===void 0&&(j==="instanceMatrix"&&b.instanceMatrix&&(re=b.instanceMatrix),j==="instanceColor"&&b.instanceColor&&(re=b.instanceColor)),re!==void 0){const ae=re.normalized,me=re.itemSize,xe=e.get(re);if(xe===void 0)continue;const ge=xe.buffer,tt=xe.type,nt=xe.bytesPerElement,ee=tt===n.INT||tt===n.UNSIGNED_INT||re.gpuType===yf;if(re.isInterleavedBufferAttribute){const ne=re.data,we=ne.stride,ze=re.offset;if(ne.isInstancedInterleavedBuffer){for(let ye=0;ye<Z.locationSize;ye++)p(Z.location+ye,ne.meshPerAttribute);b.isInstancedMesh!==!0&&z._maxInstanceCount===void 0&&(z._maxInstanceCount=ne.meshPerAttribute*ne.count)}else for(let ye=0;ye<Z.locationSize;ye++)m(Z.location+ye);n.bindBuffer(n.ARRAY_BUFFER,ge);for(let ye=0;ye<Z.locationSize;ye++)w(Z.location+ye,me/Z.locationSize,tt,ae,we*nt,(ze+me/Z.locationSize*ye)*nt,ee)}else{if(re.isInstancedBufferAttribute){for(let ne=0;ne<Z.locationSize;ne++)p(Z.location+ne,re.meshPerAttribute);b.isInstancedMesh!==!0&&z._maxInstanceCount===void 0&&(z._maxInstanceCount=re.meshPerAttribute*re.count)}else for(let ne=0;ne<Z.locationSize;ne++)m(Z.location+ne);n.bindBuffer(n.ARRAY_BUFFER,ge);for(let ne=0;ne<Z.locationSize;ne++)w(Z.location+ne,me/Z.locationSize,tt,ae,me*nt,me/Z.locationSize*ne*nt,ee)}}else if(q!==void 0){const ae=q[j];if(ae!==void 0)switch(ae.length){case 2:n.vertexAttrib2fv(Z.location,ae);break;case 3:n.vertexAttrib3fv(Z.location,ae);break;case 4:n.vertexAttrib4fv(Z.location,ae);break;default:n.vertexAttrib1fv(Z.location,ae)}}}}S()}function L(){N();for(const b in i){const C=i[b];for(const B in C){const z=C[B];for(const X in z)u(z[X].object),delete z[X];delete C[B]}delete i[b]}}function R(b){if(i[b.id]===void 0)return;const C=i[b.id];for(const B in C){const z=C[B];for(const X in z)u(z[X].object),delete z[X];delete C[B]}delete i[b.id]}function U(b){for(const C in i){const B=i[C];if(B[b.id]===void 0)continue;const z=B[b.id];for(const X in z)u(z[X].object),delete z[X];delete B[b.id]}}function N(){T(),o=!0,r!==s&&(r=s,c(r.object))}function T(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:N,resetDefaultState:T,dispose:L,releaseStatesOfGeometry:R,releaseStatesOfProgram:U,initAttributes:x,enableAttribute:m,disableUnusedAttributes:S}}function Ab(n,e,t){let i;function s(c){i=c}function r(c,u){n.drawArrays(i,c,u),t.update(u,i,1)}function o(c,u,h){h!==0&&(n.drawArraysInstanced(i,c,u,h),t.update(u,i,h))}function a(c,u,h){if(h===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,c,0,u,0,h);let d=0;for(let _=0;_<h;_++)d+=u[_];t.update(d,i,1)}function l(c,u,h,f){if(h===0)return;const d=e.get("WEBGL_multi_draw");if(d===null)for(let _=0;_<c.length;_++)o(c[_],u[_],f[_]);else{d.multiDrawArraysInstancedWEBGL(i,c,0,u,0,f,0,h);let _=0;for(let x=0;x<h;x++)_+=u[x]*f[x];t.update(_,i,1)}}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a,this.renderMultiDrawInstances=l}function Rb(n,e,t,i){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){const U=e.get("EXT_texture_filter_anisotropic");s=n.getParameter(U.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(U){return!(U!==ki&&i.convert(U)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(U){const N=U===Ia&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(U!==es&&i.convert(U)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE)&&U!==Zi&&!N)}function l(U){if(U==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";U="mediump"}return U==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp";const u=l(c);u!==c&&(console.warn("THREE.WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);const h=t.logarithmicDepthBuffer===!0,f=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),d=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),_=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),x=n.getParameter(n.MAX_TEXTURE_SIZE),m=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),p=n.getParameter(n.MAX_VERTEX_ATTRIBS),S=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),w=n.getParameter(n.MAX_VARYING_VECTORS),y=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),L=_>0,R=n.getParameter(n.MAX_SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:h,reversedDepthBuffer:f,maxTextures:d,maxVertexTextures:_,maxTextureSize:x,maxCubemapSize:m,maxAttributes:p,maxVertexUniforms:S,maxVaryings:w,maxFragmentUniforms:y,vertexTextures:L,maxSamples:R}}function Cb(n){const e=this;let t=null,i=0,s=!1,r=!1;const o=new ks,a=new lt,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(h,f){const d=h.length!==0||f||i!==0||s;return s=f,i=h.length,d},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(h,f){t=u(h,f,0)},this.setState=function(h,f,d){const _=h.clippingPlanes,x=h.clipIntersection,m=h.clipShadows,p=n.get(h);if(!s||_===null||_.length===0||r&&!m)r?u(null):c();else{const S=r?0:i,w=S*4;let y=p.clippingState||null;l.value=y,y=u(_,f,w,d);for(let L=0;L!==w;++L)y[L]=t[L];p.clippingState=y,this.numIntersection=x?this.numPlanes:0,this.numPlanes+=S}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=i>0),e.numPlanes=i,e.numIntersection=0}function u(h,f,d,_){const x=h!==null?h.length:0;let m=null;if(x!==0){if(m=l.value,_!==!0||m===null){const p=d+x*4,S=f.matrixWorldInverse;a.getNormalMatrix(S),(m===null||m.length<p)&&(m=new Float32Array(p));for(let w=0,y=d;w!==x;++w,y+=4)o.copy(h[w]).applyMatrix4(S,a),o.normal.toArray(m,y),m[y+3]=o.constant}l.value=m,l.needsUpdate=!0}return e.numPlanes=x,e.numIntersection=0,m}}function Pb(n){let e=new WeakMap;function t(o,a){return a===lh?o.mapping=To:a===ch&&(o.mapping=Ao),o}function i(o){if(o&&o.isTexture){const a=o.mapping;if(a===lh||a===ch)if(e.has(o)){const l=e.get(o).texture;return t(l,o.mapping)}else{const l=o.image;if(l&&l.height>0){const c=new bM(l.height);return c.fromEquirectangularTexture(n,o),e.set(o,c),o.addEventListener("dispose",s),t(c.texture,o.mapping)}else return null}}return o}function s(o){const a=o.target;a.removeEventListener("dispose",s);const l=e.get(a);l!==void 0&&(e.delete(a),l.dispose())}function r(){e=new WeakMap}return{get:i,dispose:r}}const lo=4,$p=[.125,.215,.35,.446,.526,.582],gr=20,Mu=new Uf,jp=new Qe;let Su=null,Eu=0,bu=0,wu=!1;const ur=(1+Math.sqrt(5))/2,so=1/ur,Kp=[new k(-ur,so,0),new k(ur,so,0),new k(-so,0,ur),new k(so,0,ur),new k(0,ur,-so),new k(0,ur,so),new k(-1,1,-1),new k(1,1,-1),new k(-1,1,1),new k(1,1,1)],Db=new k;class Zp{constructor(e){this._renderer=e,this._pingPongRenderTarget=null,this._lodMax=0,this._cubeSize=0,this._lodPlanes=[],this._sizeLods=[],this._sigmas=[],this._blurMaterial=null,this._cubemapMaterial=null,this._equirectMaterial=null,this._compileMaterial(this._blurMaterial)}fromScene(e,t=0,i=.1,s=100,r={}){const{size:o=256,position:a=Db}=r;Su=this._renderer.getRenderTarget(),Eu=this._renderer.getActiveCubeFace(),bu=this._renderer.getActiveMipmapLevel(),wu=this._renderer.xr.enabled,this._renderer.xr.enabled=!1,this._setSize(o);const l=this._allocateTargets();return l.depthBuffer=!0,this._sceneToCubeUV(e,i,s,l,a),t>0&&this._blur(l,0,0,t),this._applyPMREM(l),this._cleanup(l),l}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=em(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=Qp(),this._compileMaterial(this._equirectMaterial))}dispose(){this._dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose()}_setSize(e){this._lodMax=Math.floor(Math.log2(e)),this._cubeSize=Math.pow(2,this._lodMax)}_dispose(){this._blurMaterial!==null&&this._blurMaterial.dispose(),this._pingPongRenderTarget!==null&&this._pingPongRenderTarget.dispose();for(let e=0;e<this._lodPlanes.length;e++)this._lodPlanes[e].dispose()}_cleanup(e){this._renderer.setRenderTarget(Su,Eu,bu),this._renderer.xr.enabled=wu,e.scissorTest=!1,vl(e,0,0,e.width,e.height)}_fromTexture(e,t){e.mapping===To||e.mapping===Ao?this._setSize(e.image.length===0?16:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4),Su=this._renderer.getRenderTarget(),Eu=this._renderer.getActiveCubeFace(),bu=this._renderer.getActiveMipmapLevel(),wu=this._renderer.xr.enabled,this._renderer.xr.enabled=!1;const i=t||this._allocateTargets();return this._textureToCubeUV(e,i),this._applyPMREM(i),this._cleanup(i),i}_allocateTargets(){const e=3*Math.max(this._cubeSize,112),t=4*this._cubeSize,i={magFilter:Ki,minFilter:Ki,generateMipmaps:!1,type:Ia,format:ki,colorSpace:Ro,depthBuffer:!1},s=Jp(e,t,i);if(this._pingPongRenderTarget===null||this._pingPongRenderTarget.width!==e||this._pingPongRenderTarget.height!==t){this._pingPongRenderTarget!==null&&this._dispose(),this._pingPongRenderTarget=Jp(e,t,i);const{_lodMax:r}=this;({sizeLods:this._sizeLods,lodPlanes:this._lodPlanes,sigmas:this._sigmas}=Lb(r)),this._blurMaterial=Ib(r,e,t)}return s}_compileMaterial(e){const t=new Ee(this._lodPlanes[0],e);this._renderer.compile(t,Mu)}_sceneToCubeUV(e,t,i,s,r){const l=new Mi(90,1,t,i),c=[1,-1,1,1,1,1],u=[1,1,1,-1,-1,-1],h=this._renderer,f=h.autoClear,d=h.toneMapping;h.getClearColor(jp),h.toneMapping=Vs,h.autoClear=!1,h.state.buffers.depth.getReversed()&&(h.setRenderTarget(s),h.clearDepth(),h.setRenderTarget(null));const x=new Na({name:"PMREM.Background",side:ei,depthWrite:!1,depthTest:!1}),m=new Ee(new cn,x);let p=!1;const S=e.background;S?S.isColor&&(x.color.copy(S),e.background=null,p=!0):(x.color.copy(jp),p=!0);for(let w=0;w<6;w++){const y=w%3;y===0?(l.up.set(0,c[w],0),l.position.set(r.x,r.y,r.z),l.lookAt(r.x+u[w],r.y,r.z)):y===1?(l.up.set(0,0,c[w]),l.position.set(r.x,r.y,r.z),l.lookAt(r.x,r.y+u[w],r.z)):(l.up.set(0,c[w],0),l.position.set(r.x,r.y,r.z),l.lookAt(r.x,r.y,r.z+u[w]));const L=this._cubeSize;vl(s,y*L,w>2?L:0,L,L),h.setRenderTarget(s),p&&h.render(m,l),h.render(e,l)}m.geometry.dispose(),m.material.dispose(),h.toneMapping=d,h.autoClear=f,e.background=S}_textureToCubeUV(e,t){const i=this._renderer,s=e.mapping===To||e.mapping===Ao;s?(this._cubemapMaterial===null&&(this._cubemapMaterial=em()),this._cubemapMaterial.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):this._equirectMaterial===null&&(this._equirectMaterial=Qp());const r=s?this._cubemapMaterial:this._equirectMaterial,o=new Ee(this._lodPlanes[0],r),a=r.uniforms;a.envMap.value=e;const l=this._cubeSize;vl(t,0,0,3*l,2*l),i.setRenderTarget(t),i.render(o,Mu)}_applyPMREM(e){const t=this._renderer,i=t.autoClear;t.autoClear=!1;const s=this._lodPlanes.length;for(let r=1;r<s;r++){const o=Math.sqrt(this._sigmas[r]*this._sigmas[r]-this._sigmas[r-1]*this._sigmas[r-1]),a=Kp[(s-r-1)%Kp.length];this._blur(e,r-1,r,o,a)}t.autoClear=i}_blur(e,t,i,s,r){const o=this._pingPongRenderTarget;this._halfBlur(e,o,t,i,s,"latitudinal",r),this._halfBlur(o,e,i,i,s,"longitudinal",r)}_halfBlur(e,t,i,s,r,o,a){const l=this._renderer,c=this._blurMaterial;o!=="latitudinal"&&o!=="longitudinal"&&console.error("blur direction must be either latitudinal or longitudinal!");const u=3,h=new Ee(this._lodPlanes[s],c),f=c.uniforms,d=this._sizeLods[i]-1,_=isFinite(r)?Math.PI/(2*d):2*Math.PI/(2*gr-1),x=r/_,m=isFinite(r)?1+Math.floor(u*x):gr;m>gr&&console.warn(`sigmaRadians, ${r}, is too large and will clip, as it requested ${m} samples when the maximum is set to ${gr}`);const p=[];let S=0;for(let U=0;U<gr;++U){const N=U/x,T=Math.exp(-N*N/2);p.push(T),U===0?S+=T:U<m&&(S+=2*T)}for(let U=0;U<p.length;U++)p[U]=p[U]/S;f.envMap.value=e.texture,f.samples.value=m,f.weights.value=p,f.latitudinal.value=o==="latitudinal",a&&(f.poleAxis.value=a);const{_lodMax:w}=this;f.dTheta.value=_,f.mipInt.value=w-i;const y=this._sizeLods[s],L=3*y*(s>w-lo?s-w+lo:0),R=4*(this._cubeSize-y);vl(t,L,R,3*y,2*y),l.setRenderTarget(t),l.render(h,Mu)}}function Lb(n){const e=[],t=[],i=[];let s=n;const r=n-lo+1+$p.length;for(let o=0;o<r;o++){const a=Math.pow(2,s);t.push(a);let l=1/a;o>n-lo?l=$p[o-n+lo-1]:o===0&&(l=0),i.push(l);const c=1/(a-2),u=-c,h=1+c,f=[u,u,h,u,h,h,u,u,h,h,u,h],d=6,_=6,x=3,m=2,p=1,S=new Float32Array(x*_*d),w=new Float32Array(m*_*d),y=new Float32Array(p*_*d);for(let R=0;R<d;R++){const U=R%3*2/3-1,N=R>2?0:-1,T=[U,N,0,U+2/3,N,0,U+2/3,N+1,0,U,N,0,U+2/3,N+1,0,U,N+1,0];S.set(T,x*_*R),w.set(f,m*_*R);const b=[R,R,R,R,R,R];y.set(b,p*_*R)}const L=new on;L.setAttribute("position",new Dn(S,x)),L.setAttribute("uv",new Dn(w,m)),L.setAttribute("faceIndex",new Dn(y,p)),e.push(L),s>lo&&s--}return{lodPlanes:e,sizeLods:t,sigmas:i}}function Jp(n,e,t){const i=new Ys(n,e,t);return i.texture.mapping=yc,i.texture.name="PMREM.cubeUv",i.scissorTest=!0,i}function vl(n,e,t,i,s){n.viewport.set(e,t,i,s),n.scissor.set(e,t,i,s)}function Ib(n,e,t){const i=new Float32Array(gr),s=new k(0,1,0);return new ts({name:"SphericalGaussianBlur",defines:{n:gr,CUBEUV_TEXEL_WIDTH:1/e,CUBEUV_TEXEL_HEIGHT:1/t,CUBEUV_MAX_MIP:`${n}.0`},uniforms:{envMap:{value:null},samples:{value:1},weights:{value:i},latitudinal:{value:!1},dTheta:{value:0},mipInt:{value:0},poleAxis:{value:s}},vertexShader:Nf(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			varying vec3 vOutputDirection;

			uniform sampler2D envMap;
			uniform int samples;
			uniform float weights[ n ];
			uniform bool latitudinal;
			uniform float dTheta;
			uniform float mipInt;
			uniform vec3 poleAxis;

			#define ENVMAP_TYPE_CUBE_UV
			#include <cube_uv_reflection_fragment>

			vec3 getSample( float theta, vec3 axis ) {

				float cosTheta = cos( theta );
				// Rodrigues' axis-angle rotation
				vec3 sampleDirection = vOutputDirection * cosTheta
					+ cross( axis, vOutputDirection ) * sin( theta )
					+ axis * dot( axis, vOutputDirection ) * ( 1.0 - cosTheta );

				return bilinearCubeUV( envMap, sampleDirection, mipInt );

			}

			void main() {

				vec3 axis = latitudinal ? poleAxis : cross( poleAxis, vOutputDirection );

				if ( all( equal( axis, vec3( 0.0 ) ) ) ) {

					axis = vec3( vOutputDirection.z, 0.0, - vOutputDirection.x );

				}

				axis = normalize( axis );

				gl_FragColor = vec4( 0.0, 0.0, 0.0, 1.0 );
				gl_FragColor.rgb += weights[ 0 ] * getSample( 0.0, axis );

				for ( int i = 1; i < n; i++ ) {

					if ( i >= samples ) {

						break;

					}

					float theta = dTheta * float( i );
					gl_FragColor.rgb += weights[ i ] * getSample( -1.0 * theta, axis );
					gl_FragColor.rgb += weights[ i ] * getSample( theta, axis );

				}

			}
		`,blending:Hs,depthTest:!1,depthWrite:!1})}function Qp(){return new ts({name:"EquirectangularToCubeUV",uniforms:{envMap:{value:null}},vertexShader:Nf(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			varying vec3 vOutputDirection;

			uniform sampler2D envMap;

			#include <common>

			void main() {

				vec3 outputDirection = normalize( vOutputDirection );
				vec2 uv = equirectUv( outputDirection );

				gl_FragColor = vec4( texture2D ( envMap, uv ).rgb, 1.0 );

			}
		`,blending:Hs,depthTest:!1,depthWrite:!1})}function em(){return new ts({name:"CubemapToCubeUV",uniforms:{envMap:{value:null},flipEnvMap:{value:-1}},vertexShader:Nf(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			uniform float flipEnvMap;

			varying vec3 vOutputDirection;

			uniform samplerCube envMap;

			void main() {

				gl_FragColor = textureCube( envMap, vec3( flipEnvMap * vOutputDirection.x, vOutputDirection.yz ) );

			}
		`,blending:Hs,depthTest:!1,depthWrite:!1})}function Nf(){return`

		precision mediump float;
		precision mediump int;

		attribute float faceIndex;

		varying vec3 vOutputDirection;

		// RH coordinate system; PMREM face-indexing convention
		vec3 getDirection( vec2 uv, float face ) {

			uv = 2.0 * uv - 1.0;

			vec3 direction = vec3( uv, 1.0 );

			if ( face == 0.0 ) {

				direction = direction.zyx; // ( 1, v, u ) pos x

			} else if ( face == 1.0 ) {

				direction = direction.xzy;
				direction.xz *= -1.0; // ( -u, 1, -v ) pos y

			} else if ( face == 2.0 ) {

				direction.x *= -1.0; // ( -u, v, 1 ) pos z

			} else if ( face == 3.0 ) {

				direction = direction.zyx;
				direction.xz *= -1.0; // ( -1, v, -u ) neg x

			} else if ( face == 4.0 ) {

				direction = direction.xzy;
				direction.xy *= -1.0; // ( -u, -1, v ) neg y

			} else if ( face == 5.0 ) {

				direction.z *= -1.0; // ( u, v, -1 ) neg z

			}

			return direction;

		}

		void main() {

			vOutputDirection = getDirection( uv, faceIndex );
			gl_Position = vec4( position, 1.0 );

		}
	`}function Ub(n){let e=new WeakMap,t=null;function i(a){if(a&&a.isTexture){const l=a.mapping,c=l===lh||l===ch,u=l===To||l===Ao;if(c||u){let h=e.get(a);const f=h!==void 0?h.texture.pmremVersion:0;if(a.isRenderTargetTexture&&a.pmremVersion!==f)return t===null&&(t=new Zp(n)),h=c?t.fromEquirectangular(a,h):t.fromCubemap(a,h),h.texture.pmremVersion=a.pmremVersion,e.set(a,h),h.texture;if(h!==void 0)return h.texture;{const d=a.image;return c&&d&&d.height>0||u&&d&&s(d)?(t===null&&(t=new Zp(n)),h=c?t.fromEquirectangular(a):t.fromCubemap(a),h.texture.pmremVersion=a.pmremVersion,e.set(a,h),a.addEventListener("dispose",r),h.texture):null}}}return a}function s(a){let l=0;const c=6;for(let u=0;u<c;u++)a[u]!==void 0&&l++;return l===c}function r(a){const l=a.target;l.removeEventListener("dispose",r);const c=e.get(l);c!==void 0&&(e.delete(l),c.dispose())}function o(){e=new WeakMap,t!==null&&(t.dispose(),t=null)}return{get:i,dispose:o}}function Nb(n){const e={};function t(i){if(e[i]!==void 0)return e[i];let s;switch(i){case"WEBGL_depth_texture":s=n.getExtension("WEBGL_depth_texture")||n.getExtension("MOZ_WEBGL_depth_texture")||n.getExtension("WEBKIT_WEBGL_depth_texture");break;case"EXT_texture_filter_anisotropic":s=n.getExtension("EXT_texture_filter_anisotropic")||n.getExtension("MOZ_EXT_texture_filter_anisotropic")||n.getExtension("WEBKIT_EXT_texture_filter_anisotropic");break;case"WEBGL_compressed_texture_s3tc":s=n.getExtension("WEBGL_compressed_texture_s3tc")||n.getExtension("MOZ_WEBGL_compressed_texture_s3tc")||n.getExtension("WEBKIT_WEBGL_compressed_texture_s3tc");break;case"WEBGL_compressed_texture_pvrtc":s=n.getExtension("WEBGL_compressed_texture_pvrtc")||n.getExtension("WEBKIT_WEBGL_compressed_texture_pvrtc");break;default:s=n.getExtension(i)}return e[i]=s,s}return{has:function(i){return t(i)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(i){const s=t(i);return s===null&&Pa("THREE.WebGLRenderer: "+i+" extension not supported."),s}}}function Fb(n,e,t,i){const s={},r=new WeakMap;function o(h){const f=h.target;f.index!==null&&e.remove(f.index);for(const _ in f.attributes)e.remove(f.attributes[_]);f.removeEventListener("dispose",o),delete s[f.id];const d=r.get(f);d&&(e.remove(d),r.delete(f)),i.releaseStatesOfGeometry(f),f.isInstancedBufferGeometry===!0&&delete f._maxInstanceCount,t.memory.geometries--}function a(h,f){return s[f.id]===!0||(f.addEventListener("dispose",o),s[f.id]=!0,t.memory.geometries++),f}function l(h){const f=h.attributes;for(const d in f)e.update(f[d],n.ARRAY_BUFFER)}function c(h){const f=[],d=h.index,_=h.attributes.position;let x=0;if(d!==null){const S=d.array;x=d.version;for(let w=0,y=S.length;w<y;w+=3){const L=S[w+0],R=S[w+1],U=S[w+2];f.push(L,R,R,U,U,L)}}else if(_!==void 0){const S=_.array;x=_.version;for(let w=0,y=S.length/3-1;w<y;w+=3){const L=w+0,R=w+1,U=w+2;f.push(L,R,R,U,U,L)}}else return;const m=new(mg(f)?xg:vg)(f,1);m.version=x;const p=r.get(h);p&&e.remove(p),r.set(h,m)}function u(h){const f=r.get(h);if(f){const d=h.index;d!==null&&f.version<d.version&&c(h)}else c(h);return r.get(h)}return{get:a,update:l,getWireframeAttribute:u}}function Ob(n,e,t){let i;function s(f){i=f}let r,o;function a(f){r=f.type,o=f.bytesPerElement}function l(f,d){n.drawElements(i,d,r,f*o),t.update(d,i,1)}function c(f,d,_){_!==0&&(n.drawElementsInstanced(i,d,r,f*o,_),t.update(d,i,_))}function u(f,d,_){if(_===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,d,0,r,f,0,_);let m=0;for(let p=0;p<_;p++)m+=d[p];t.update(m,i,1)}function h(f,d,_,x){if(_===0)return;const m=e.get("WEBGL_multi_draw");if(m===null)for(let p=0;p<f.length;p++)c(f[p]/o,d[p],x[p]);else{m.multiDrawElementsInstancedWEBGL(i,d,0,r,f,0,x,0,_);let p=0;for(let S=0;S<_;S++)p+=d[S]*x[S];t.update(p,i,1)}}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u,this.renderMultiDrawInstances=h}function kb(n){const e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(t.calls++,o){case n.TRIANGLES:t.triangles+=a*(r/3);break;case n.LINES:t.lines+=a*(r/2);break;case n.LINE_STRIP:t.lines+=a*(r-1);break;case n.LINE_LOOP:t.lines+=a*r;break;case n.POINTS:t.points+=a*r;break;default:console.error("THREE.WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:i}}function Bb(n,e,t){const i=new WeakMap,s=new tn;function r(o,a,l){const c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,h=u!==void 0?u.length:0;let f=i.get(a);if(f===void 0||f.count!==h){let T=function(){U.dispose(),i.delete(a),a.removeEventListener("dispose",T)};f!==void 0&&f.texture.dispose();const d=a.morphAttributes.position!==void 0,_=a.morphAttributes.normal!==void 0,x=a.morphAttributes.color!==void 0,m=a.morphAttributes.position||[],p=a.morphAttributes.normal||[],S=a.morphAttributes.color||[];let w=0;d===!0&&(w=1),_===!0&&(w=2),x===!0&&(w=3);let y=a.attributes.position.count*w,L=1;y>e.maxTextureSize&&(L=Math.ceil(y/e.maxTextureSize),y=e.maxTextureSize);const R=new Float32Array(y*L*4*h),U=new _g(R,y,L,h);U.type=Zi,U.needsUpdate=!0;const N=w*4;for(let b=0;b<h;b++){const C=m[b],B=p[b],z=S[b],X=y*L*4*b;for(let W=0;W<C.count;W++){const q=W*N;d===!0&&(s.fromBufferAttribute(C,W),R[X+q+0]=s.x,R[X+q+1]=s.y,R[X+q+2]=s.z,R[X+q+3]=0),_===!0&&(s.fromBufferAttribute(B,W),R[X+q+4]=s.x,R[X+q+5]=s.y,R[X+q+6]=s.z,R[X+q+7]=0),x===!0&&(s.fromBufferAttribute(z,W),R[X+q+8]=s.x,R[X+q+9]=s.y,R[X+q+10]=s.z,R[X+q+11]=z.itemSize===4?s.w:1)}}f={count:h,texture:U,size:new Ke(y,L)},i.set(a,f),a.addEventListener("dispose",T)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,t);else{let d=0;for(let x=0;x<c.length;x++)d+=c[x];const _=a.morphTargetsRelative?1:1-d;l.getUniforms().setValue(n,"morphTargetBaseInfluence",_),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",f.texture,t),l.getUniforms().setValue(n,"morphTargetsTextureSize",f.size)}return{update:r}}function zb(n,e,t,i){let s=new WeakMap;function r(l){const c=i.render.frame,u=l.geometry,h=e.get(l,u);if(s.get(h)!==c&&(e.update(h),s.set(h,c)),l.isInstancedMesh&&(l.hasEventListener("dispose",a)===!1&&l.addEventListener("dispose",a),s.get(l)!==c&&(t.update(l.instanceMatrix,n.ARRAY_BUFFER),l.instanceColor!==null&&t.update(l.instanceColor,n.ARRAY_BUFFER),s.set(l,c))),l.isSkinnedMesh){const f=l.skeleton;s.get(f)!==c&&(f.update(),s.set(f,c))}return h}function o(){s=new WeakMap}function a(l){const c=l.target;c.removeEventListener("dispose",a),t.remove(c.instanceMatrix),c.instanceColor!==null&&t.remove(c.instanceColor)}return{update:r,dispose:o}}const Pg=new $n,tm=new Eg(1,1),Dg=new _g,Lg=new aM,Ig=new Mg,nm=[],im=[],sm=new Float32Array(16),rm=new Float32Array(9),om=new Float32Array(4);function Fo(n,e,t){const i=n[0];if(i<=0||i>0)return n;const s=e*t;let r=nm[s];if(r===void 0&&(r=new Float32Array(s),nm[s]=r),e!==0){i.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,n[o].toArray(r,a)}return r}function vn(n,e){if(n.length!==e.length)return!1;for(let t=0,i=n.length;t<i;t++)if(n[t]!==e[t])return!1;return!0}function xn(n,e){for(let t=0,i=e.length;t<i;t++)n[t]=e[t]}function Sc(n,e){let t=im[e];t===void 0&&(t=new Int32Array(e),im[e]=t);for(let i=0;i!==e;++i)t[i]=n.allocateTextureUnit();return t}function Hb(n,e){const t=this.cache;t[0]!==e&&(n.uniform1f(this.addr,e),t[0]=e)}function Vb(n,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(vn(t,e))return;n.uniform2fv(this.addr,e),xn(t,e)}}function Gb(n,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(n.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(vn(t,e))return;n.uniform3fv(this.addr,e),xn(t,e)}}function Wb(n,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(vn(t,e))return;n.uniform4fv(this.addr,e),xn(t,e)}}function Xb(n,e){const t=this.cache,i=e.elements;if(i===void 0){if(vn(t,e))return;n.uniformMatrix2fv(this.addr,!1,e),xn(t,e)}else{if(vn(t,i))return;om.set(i),n.uniformMatrix2fv(this.addr,!1,om),xn(t,i)}}function Yb(n,e){const t=this.cache,i=e.elements;if(i===void 0){if(vn(t,e))return;n.uniformMatrix3fv(this.addr,!1,e),xn(t,e)}else{if(vn(t,i))return;rm.set(i),n.uniformMatrix3fv(this.addr,!1,rm),xn(t,i)}}function qb(n,e){const t=this.cache,i=e.elements;if(i===void 0){if(vn(t,e))return;n.uniformMatrix4fv(this.addr,!1,e),xn(t,e)}else{if(vn(t,i))return;sm.set(i),n.uniformMatrix4fv(this.addr,!1,sm),xn(t,i)}}function $b(n,e){const t=this.cache;t[0]!==e&&(n.uniform1i(this.addr,e),t[0]=e)}function jb(n,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(vn(t,e))return;n.uniform2iv(this.addr,e),xn(t,e)}}function Kb(n,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(vn(t,e))return;n.uniform3iv(this.addr,e),xn(t,e)}}function Zb(n,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(vn(t,e))return;n.uniform4iv(this.addr,e),xn(t,e)}}function Jb(n,e){const t=this.cache;t[0]!==e&&(n.uniform1ui(this.addr,e),t[0]=e)}function Qb(n,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(vn(t,e))return;n.uniform2uiv(this.addr,e),xn(t,e)}}function ew(n,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(vn(t,e))return;n.uniform3uiv(this.addr,e),xn(t,e)}}function tw(n,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(vn(t,e))return;n.uniform4uiv(this.addr,e),xn(t,e)}}function nw(n,e,t){const i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?(tm.compareFunction=pg,r=tm):r=Pg,t.setTexture2D(e||r,s)}function iw(n,e,t){const i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture3D(e||Lg,s)}function sw(n,e,t){const i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTextureCube(e||Ig,s)}function rw(n,e,t){const i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture2DArray(e||Dg,s)}function ow(n){switch(n){case 5126:return Hb;case 35664:return Vb;case 35665:return Gb;case 35666:return Wb;case 35674:return Xb;case 35675:return Yb;case 35676:return qb;case 5124:case 35670:return $b;case 35667:case 35671:return jb;case 35668:case 35672:return Kb;case 35669:case 35673:return Zb;case 5125:return Jb;case 36294:return Qb;case 36295:return ew;case 36296:return tw;case 35678:case 36198:case 36298:case 36306:case 35682:return nw;case 35679:case 36299:case 36307:return iw;case 35680:case 36300:case 36308:case 36293:return sw;case 36289:case 36303:case 36311:case 36292:return rw}}function aw(n,e){n.uniform1fv(this.addr,e)}function lw(n,e){const t=Fo(e,this.size,2);n.uniform2fv(this.addr,t)}function cw(n,e){const t=Fo(e,this.size,3);n.uniform3fv(this.addr,t)}function uw(n,e){const t=Fo(e,this.size,4);n.uniform4fv(this.addr,t)}function hw(n,e){const t=Fo(e,this.size,4);n.uniformMatrix2fv(this.addr,!1,t)}function fw(n,e){const t=Fo(e,this.size,9);n.uniformMatrix3fv(this.addr,!1,t)}function dw(n,e){const t=Fo(e,this.size,16);n.uniformMatrix4fv(this.addr,!1,t)}function pw(n,e){n.uniform1iv(this.addr,e)}function mw(n,e){n.uniform2iv(this.addr,e)}function _w(n,e){n.uniform3iv(this.addr,e)}function gw(n,e){n.uniform4iv(this.addr,e)}function vw(n,e){n.uniform1uiv(this.addr,e)}function xw(n,e){n.uniform2uiv(this.addr,e)}function yw(n,e){n.uniform3uiv(this.addr,e)}function Mw(n,e){n.uniform4uiv(this.addr,e)}function Sw(n,e,t){const i=this.cache,s=e.length,r=Sc(t,s);vn(i,r)||(n.uniform1iv(this.addr,r),xn(i,r));for(let o=0;o!==s;++o)t.setTexture2D(e[o]||Pg,r[o])}function Ew(n,e,t){const i=this.cache,s=e.length,r=Sc(t,s);vn(i,r)||(n.uniform1iv(this.addr,r),xn(i,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||Lg,r[o])}function bw(n,e,t){const i=this.cache,s=e.length,r=Sc(t,s);vn(i,r)||(n.uniform1iv(this.addr,r),xn(i,r));for(let o=0;o!==s;++o)t.setTextureCube(e[o]||Ig,r[o])}function ww(n,e,t){const i=this.cache,s=e.length,r=Sc(t,s);vn(i,r)||(n.uniform1iv(this.addr,r),xn(i,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||Dg,r[o])}function Tw(n){switch(n){case 5126:return aw;case 35664:return lw;case 35665:return cw;case 35666:return uw;case 35674:return hw;case 35675:return fw;case 35676:return dw;case 5124:case 35670:return pw;case 35667:case 35671:return mw;case 35668:case 35672:return _w;case 35669:case 35673:return gw;case 5125:return vw;case 36294:return xw;case 36295:return yw;case 36296:return Mw;case 35678:case 36198:case 36298:case 36306:case 35682:return Sw;case 35679:case 36299:case 36307:return Ew;case 35680:case 36300:case 36308:case 36293:return bw;case 36289:case 36303:case 36311:case 36292:return ww}}class Aw{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.setValue=ow(t.type)}}class Rw{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=Tw(t.type)}}class Cw{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,i){const s=this.seq;for(let r=0,o=s.length;r!==o;++r){const a=s[r];a.setValue(e,t[a.id],i)}}}const Tu=/(\w+)(\])?(\[|\.)?/g;function am(n,e){n.seq.push(e),n.map[e.id]=e}function Pw(n,e,t){const i=n.name,s=i.length;for(Tu.lastIndex=0;;){const r=Tu.exec(i),o=Tu.lastIndex;let a=r[1];const l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){am(t,c===void 0?new Aw(a,n,e):new Rw(a,n,e));break}else{let h=t.map[a];h===void 0&&(h=new Cw(a),am(t,h)),t=h}}}class Ol{constructor(e,t){this.seq=[],this.map={};const i=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let s=0;s<i;++s){const r=e.getActiveUniform(t,s),o=e.getUniformLocation(t,r.name);Pw(r,o,this)}}setValue(e,t,i,s){const r=this.map[t];r!==void 0&&r.setValue(e,i,s)}setOptional(e,t,i){const s=t[i];s!==void 0&&this.setValue(e,i,s)}static upload(e,t,i,s){for(let r=0,o=t.length;r!==o;++r){const a=t[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,s)}}static seqWithValue(e,t){const i=[];for(let s=0,r=e.length;s!==r;++s){const o=e[s];o.id in t&&i.push(o)}return i}}function lm(n,e,t){const i=n.createShader(e);return n.shaderSource(i,t),n.compileShader(i),i}const Dw=37297;let Lw=0;function Iw(n,e){const t=n.split(`
`),i=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){const a=o+1;i.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return i.join(`
`)}const cm=new lt;function Uw(n){Mt._getMatrix(cm,Mt.workingColorSpace,n);const e=`mat3( ${cm.elements.map(t=>t.toFixed(4))} )`;switch(Mt.getTransfer(n)){case tc:return[e,"LinearTransferOETF"];case It:return[e,"sRGBTransferOETF"];default:return console.warn("THREE.WebGLProgram: Unsupported color space: ",n),[e,"LinearTransferOETF"]}}function um(n,e,t){const i=n.getShaderParameter(e,n.COMPILE_STATUS),r=(n.getShaderInfoLog(e)||"").trim();if(i&&r==="")return"";const o=/ERROR: 0:(\d+)/.exec(r);if(o){const a=parseInt(o[1]);return t.toUpperCase()+`

`+r+`

`+Iw(n.getShaderSource(e),a)}else return r}function Nw(n,e){const t=Uw(e);return[`vec4 ${n}( vec4 value ) {`,`	return ${t[1]}( vec4( value.rgb * ${t[0]}, value.a ) );`,"}"].join(`
`)}function Fw(n,e){let t;switch(e){case Uy:t="Linear";break;case Ny:t="Reinhard";break;case Fy:t="Cineon";break;case rg:t="ACESFilmic";break;case ky:t="AgX";break;case By:t="Neutral";break;case Oy:t="Custom";break;default:console.warn("THREE.WebGLProgram: Unsupported toneMapping:",e),t="Linear"}return"vec3 "+n+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}const xl=new k;function Ow(){Mt.getLuminanceCoefficients(xl);const n=xl.x.toFixed(4),e=xl.y.toFixed(4),t=xl.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function kw(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(fa).join(`
`)}function Bw(n){const e=[];for(const t in n){const i=n[t];i!==!1&&e.push("#define "+t+" "+i)}return e.join(`
`)}function zw(n,e){const t={},i=n.getProgramParameter(e,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){const r=n.getActiveAttrib(e,s),o=r.name;let a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:n.getAttribLocation(e,o),locationSize:a}}return t}function fa(n){return n!==""}function hm(n,e){const t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return n.replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows)}function fm(n,e){return n.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}const Hw=/^[ \t]*#include +<([\w\d./]+)>/gm;function Vh(n){return n.replace(Hw,Gw)}const Vw=new Map;function Gw(n,e){let t=ut[e];if(t===void 0){const i=Vw.get(e);if(i!==void 0)t=ut[i],console.warn('THREE.WebGLRenderer: Shader chunk "%s" has been deprecated. Use "%s" instead.',e,i);else throw new Error("Can not resolve #include <"+e+">")}return Vh(t)}const Ww=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function dm(n){return n.replace(Ww,Xw)}function Xw(n,e,t,i){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function pm(n){let e=`precision ${n.precision} float;
	precision ${n.precision} int;
	precision ${n.precision} sampler2D;
	precision ${n.precision} samplerCube;
	precision ${n.precision} sampler3D;
	precision ${n.precision} sampler2DArray;
	precision ${n.precision} sampler2DShadow;
	precision ${n.precision} samplerCubeShadow;
	precision ${n.precision} sampler2DArrayShadow;
	precision ${n.precision} isampler2D;
	precision ${n.precision} isampler3D;
	precision ${n.precision} isamplerCube;
	precision ${n.precision} isampler2DArray;
	precision ${n.precision} usampler2D;
	precision ${n.precision} usampler3D;
	precision ${n.precision} usamplerCube;
	precision ${n.precision} usampler2DArray;
	`;return n.precision==="highp"?e+=`
#define HIGH_PRECISION`:n.precision==="mediump"?e+=`
#define MEDIUM_PRECISION`:n.precision==="lowp"&&(e+=`
#define LOW_PRECISION`),e}function Yw(n){let e="SHADOWMAP_TYPE_BASIC";return n.shadowMapType===ig?e="SHADOWMAP_TYPE_PCF":n.shadowMapType===sg?e="SHADOWMAP_TYPE_PCF_SOFT":n.shadowMapType===hs&&(e="SHADOWMAP_TYPE_VSM"),e}function qw(n){let e="ENVMAP_TYPE_CUBE";if(n.envMap)switch(n.envMapMode){case To:case Ao:e="ENVMAP_TYPE_CUBE";break;case yc:e="ENVMAP_TYPE_CUBE_UV";break}return e}function $w(n){let e="ENVMAP_MODE_REFLECTION";return n.envMap&&n.envMapMode===Ao&&(e="ENVMAP_MODE_REFRACTION"),e}function jw(n){let e="ENVMAP_BLENDING_NONE";if(n.envMap)switch(n.combine){case xf:e="ENVMAP_BLENDING_MULTIPLY";break;case Ly:e="ENVMAP_BLENDING_MIX";break;case Iy:e="ENVMAP_BLENDING_ADD";break}return e}function Kw(n){const e=n.envMapCubeUVHeight;if(e===null)return null;const t=Math.log2(e)-2,i=1/e;return{texelWidth:1/(3*Math.max(Math.pow(2,t),112)),texelHeight:i,maxMip:t}}function Zw(n,e,t,i){const s=n.getContext(),r=t.defines;let o=t.vertexShader,a=t.fragmentShader;const l=Yw(t),c=qw(t),u=$w(t),h=jw(t),f=Kw(t),d=kw(t),_=Bw(r),x=s.createProgram();let m,p,S=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(m=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,_].filter(fa).join(`
`),m.length>0&&(m+=`
`),p=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,_].filter(fa).join(`
`),p.length>0&&(p+=`
`)):(m=[pm(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,_,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+u:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(fa).join(`
`),p=[pm(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,_,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+u:"",t.envMap?"#define "+h:"",f?"#define CUBEUV_TEXEL_WIDTH "+f.texelWidth:"",f?"#define CUBEUV_TEXEL_HEIGHT "+f.texelHeight:"",f?"#define CUBEUV_MAX_MIP "+f.maxMip+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor||t.batchingColor?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==Vs?"#define TONE_MAPPING":"",t.toneMapping!==Vs?ut.tonemapping_pars_fragment:"",t.toneMapping!==Vs?Fw("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",ut.colorspace_pars_fragment,Nw("linearToOutputTexel",t.outputColorSpace),Ow(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(fa).join(`
`)),o=Vh(o),o=hm(o,t),o=fm(o,t),a=Vh(a),a=hm(a,t),a=fm(a,t),o=dm(o),a=dm(a),t.isRawShaderMaterial!==!0&&(S=`#version 300 es
`,m=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+m,p=["#define varying in",t.glslVersion===_p?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===_p?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+p);const w=S+m+o,y=S+p+a,L=lm(s,s.VERTEX_SHADER,w),R=lm(s,s.FRAGMENT_SHADER,y);s.attachShader(x,L),s.attachShader(x,R),t.index0AttributeName!==void 0?s.bindAttribLocation(x,0,t.index0AttributeName):t.morphTargets===!0&&s.bindAttribLocation(x,0,"position"),s.linkProgram(x);function U(C){if(n.debug.checkShaderErrors){const B=s.getProgramInfoLog(x)||"",z=s.getShaderInfoLog(L)||"",X=s.getShaderInfoLog(R)||"",W=B.trim(),q=z.trim(),j=X.trim();let Z=!0,re=!0;if(s.getProgramParameter(x,s.LINK_STATUS)===!1)if(Z=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,x,L,R);else{const ae=um(s,L,"vertex"),me=um(s,R,"fragment");console.error("THREE.WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(x,s.VALIDATE_STATUS)+`

Material Name: `+C.name+`
Material Type: `+C.type+`

Program Info Log: `+W+`
`+ae+`
`+me)}else W!==""?console.warn("THREE.WebGLProgram: Program Info Log:",W):(q===""||j==="")&&(re=!1);re&&(C.diagnostics={runnable:Z,programLog:W,vertexShader:{log:q,prefix:m},fragmentShader:{log:j,prefix:p}})}s.deleteShader(L),s.deleteShader(R),N=new Ol(s,x),T=zw(s,x)}let N;this.getUniforms=function(){return N===void 0&&U(this),N};let T;this.getAttributes=function(){return T===void 0&&U(this),T};let b=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return b===!1&&(b=s.getProgramParameter(x,Dw)),b},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(x),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=Lw++,this.cacheKey=e,this.usedTimes=1,this.program=x,this.vertexShader=L,this.fragmentShader=R,this}let Jw=0;class Qw{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e){const t=e.vertexShader,i=e.fragmentShader,s=this._getShaderStage(t),r=this._getShaderStage(i),o=this._getShaderCacheForMaterial(e);return o.has(s)===!1&&(o.add(s),s.usedTimes++),o.has(r)===!1&&(o.add(r),r.usedTimes++),this}remove(e){const t=this.materialCache.get(e);for(const i of t)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(e),this}getVertexShaderID(e){return this._getShaderStage(e.vertexShader).id}getFragmentShaderID(e){return this._getShaderStage(e.fragmentShader).id}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){const t=this.materialCache;let i=t.get(e);return i===void 0&&(i=new Set,t.set(e,i)),i}_getShaderStage(e){const t=this.shaderCache;let i=t.get(e);return i===void 0&&(i=new eT(e),t.set(e,i)),i}}class eT{constructor(e){this.id=Jw++,this.code=e,this.usedTimes=0}}function tT(n,e,t,i,s,r,o){const a=new Cf,l=new Qw,c=new Set,u=[],h=s.logarithmicDepthBuffer,f=s.vertexTextures;let d=s.precision;const _={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distanceRGBA",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function x(T){return c.add(T),T===0?"uv":`uv${T}`}function m(T,b,C,B,z){const X=B.fog,W=z.geometry,q=T.isMeshStandardMaterial?B.environment:null,j=(T.isMeshStandardMaterial?t:e).get(T.envMap||q),Z=j&&j.mapping===yc?j.image.height:null,re=_[T.type];T.precision!==null&&(d=s.getMaxPrecision(T.precision),d!==T.precision&&console.warn("THREE.WebGLProgram.getParameters:",T.precision,"not supported, using",d,"instead."));const ae=W.morphAttributes.position||W.morphAttributes.normal||W.morphAttributes.color,me=ae!==void 0?ae.length:0;let xe=0;W.morphAttributes.position!==void 0&&(xe=1),W.morphAttributes.normal!==void 0&&(xe=2),W.morphAttributes.color!==void 0&&(xe=3);let ge,tt,nt,ee;if(re){const gt=$i[re];ge=gt.vertexShader,tt=gt.fragmentShader}else ge=T.vertexShader,tt=T.fragmentShader,l.update(T),nt=l.getVertexShaderID(T),ee=l.getFragmentShaderID(T);const ne=n.getRenderTarget(),we=n.state.buffers.depth.getReversed(),ze=z.isInstancedMesh===!0,ye=z.isBatchedMesh===!0,it=!!T.map,Bt=!!T.matcap,F=!!j,mt=!!T.aoMap,Ze=!!T.lightMap,Ye=!!T.bumpMap,Ne=!!T.normalMap,Rt=!!T.displacementMap,Pe=!!T.emissiveMap,We=!!T.metalnessMap,Gt=!!T.roughnessMap,Et=T.anisotropy>0,D=T.clearcoat>0,M=T.dispersion>0,O=T.iridescence>0,J=T.sheen>0,ie=T.transmission>0,te=Et&&!!T.anisotropyMap,Fe=D&&!!T.clearcoatMap,he=D&&!!T.clearcoatNormalMap,Le=D&&!!T.clearcoatRoughnessMap,Re=O&&!!T.iridescenceMap,le=O&&!!T.iridescenceThicknessMap,ve=J&&!!T.sheenColorMap,Be=J&&!!T.sheenRoughnessMap,ke=!!T.specularMap,Me=!!T.specularColorMap,et=!!T.specularIntensityMap,H=ie&&!!T.transmissionMap,fe=ie&&!!T.thicknessMap,pe=!!T.gradientMap,De=!!T.alphaMap,ue=T.alphaTest>0,oe=!!T.alphaHash,Oe=!!T.extensions;let st=Vs;T.toneMapped&&(ne===null||ne.isXRRenderTarget===!0)&&(st=n.toneMapping);const Dt={shaderID:re,shaderType:T.type,shaderName:T.name,vertexShader:ge,fragmentShader:tt,defines:T.defines,customVertexShaderID:nt,customFragmentShaderID:ee,isRawShaderMaterial:T.isRawShaderMaterial===!0,glslVersion:T.glslVersion,precision:d,batching:ye,batchingColor:ye&&z._colorsTexture!==null,instancing:ze,instancingColor:ze&&z.instanceColor!==null,instancingMorph:ze&&z.morphTexture!==null,supportsVertexTextures:f,outputColorSpace:ne===null?n.outputColorSpace:ne.isXRRenderTarget===!0?ne.texture.colorSpace:Ro,alphaToCoverage:!!T.alphaToCoverage,map:it,matcap:Bt,envMap:F,envMapMode:F&&j.mapping,envMapCubeUVHeight:Z,aoMap:mt,lightMap:Ze,bumpMap:Ye,normalMap:Ne,displacementMap:f&&Rt,emissiveMap:Pe,normalMapObjectSpace:Ne&&T.normalMapType===Gy,normalMapTangentSpace:Ne&&T.normalMapType===Af,metalnessMap:We,roughnessMap:Gt,anisotropy:Et,anisotropyMap:te,clearcoat:D,clearcoatMap:Fe,clearcoatNormalMap:he,clearcoatRoughnessMap:Le,dispersion:M,iridescence:O,iridescenceMap:Re,iridescenceThicknessMap:le,sheen:J,sheenColorMap:ve,sheenRoughnessMap:Be,specularMap:ke,specularColorMap:Me,specularIntensityMap:et,transmission:ie,transmissionMap:H,thicknessMap:fe,gradientMap:pe,opaque:T.transparent===!1&&T.blending===po&&T.alphaToCoverage===!1,alphaMap:De,alphaTest:ue,alphaHash:oe,combine:T.combine,mapUv:it&&x(T.map.channel),aoMapUv:mt&&x(T.aoMap.channel),lightMapUv:Ze&&x(T.lightMap.channel),bumpMapUv:Ye&&x(T.bumpMap.channel),normalMapUv:Ne&&x(T.normalMap.channel),displacementMapUv:Rt&&x(T.displacementMap.channel),emissiveMapUv:Pe&&x(T.emissiveMap.channel),metalnessMapUv:We&&x(T.metalnessMap.channel),roughnessMapUv:Gt&&x(T.roughnessMap.channel),anisotropyMapUv:te&&x(T.anisotropyMap.channel),clearcoatMapUv:Fe&&x(T.clearcoatMap.channel),clearcoatNormalMapUv:he&&x(T.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:Le&&x(T.clearcoatRoughnessMap.channel),iridescenceMapUv:Re&&x(T.iridescenceMap.channel),iridescenceThicknessMapUv:le&&x(T.iridescenceThicknessMap.channel),sheenColorMapUv:ve&&x(T.sheenColorMap.channel),sheenRoughnessMapUv:Be&&x(T.sheenRoughnessMap.channel),specularMapUv:ke&&x(T.specularMap.channel),specularColorMapUv:Me&&x(T.specularColorMap.channel),specularIntensityMapUv:et&&x(T.specularIntensityMap.channel),transmissionMapUv:H&&x(T.transmissionMap.channel),thicknessMapUv:fe&&x(T.thicknessMap.channel),alphaMapUv:De&&x(T.alphaMap.channel),vertexTangents:!!W.attributes.tangent&&(Ne||Et),vertexColors:T.vertexColors,vertexAlphas:T.vertexColors===!0&&!!W.attributes.color&&W.attributes.color.itemSize===4,pointsUvs:z.isPoints===!0&&!!W.attributes.uv&&(it||De),fog:!!X,useFog:T.fog===!0,fogExp2:!!X&&X.isFogExp2,flatShading:T.flatShading===!0&&T.wireframe===!1,sizeAttenuation:T.sizeAttenuation===!0,logarithmicDepthBuffer:h,reversedDepthBuffer:we,skinning:z.isSkinnedMesh===!0,morphTargets:W.morphAttributes.position!==void 0,morphNormals:W.morphAttributes.normal!==void 0,morphColors:W.morphAttributes.color!==void 0,morphTargetsCount:me,morphTextureStride:xe,numDirLights:b.directional.length,numPointLights:b.point.length,numSpotLights:b.spot.length,numSpotLightMaps:b.spotLightMap.length,numRectAreaLights:b.rectArea.length,numHemiLights:b.hemi.length,numDirLightShadows:b.directionalShadowMap.length,numPointLightShadows:b.pointShadowMap.length,numSpotLightShadows:b.spotShadowMap.length,numSpotLightShadowsWithMaps:b.numSpotLightShadowsWithMaps,numLightProbes:b.numLightProbes,numClippingPlanes:o.numPlanes,numClipIntersection:o.numIntersection,dithering:T.dithering,shadowMapEnabled:n.shadowMap.enabled&&C.length>0,shadowMapType:n.shadowMap.type,toneMapping:st,decodeVideoTexture:it&&T.map.isVideoTexture===!0&&Mt.getTransfer(T.map.colorSpace)===It,decodeVideoTextureEmissive:Pe&&T.emissiveMap.isVideoTexture===!0&&Mt.getTransfer(T.emissiveMap.colorSpace)===It,premultipliedAlpha:T.premultipliedAlpha,doubleSided:T.side===Fi,flipSided:T.side===ei,useDepthPacking:T.depthPacking>=0,depthPacking:T.depthPacking||0,index0AttributeName:T.index0AttributeName,extensionClipCullDistance:Oe&&T.extensions.clipCullDistance===!0&&i.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Oe&&T.extensions.multiDraw===!0||ye)&&i.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:i.has("KHR_parallel_shader_compile"),customProgramCacheKey:T.customProgramCacheKey()};return Dt.vertexUv1s=c.has(1),Dt.vertexUv2s=c.has(2),Dt.vertexUv3s=c.has(3),c.clear(),Dt}function p(T){const b=[];if(T.shaderID?b.push(T.shaderID):(b.push(T.customVertexShaderID),b.push(T.customFragmentShaderID)),T.defines!==void 0)for(const C in T.defines)b.push(C),b.push(T.defines[C]);return T.isRawShaderMaterial===!1&&(S(b,T),w(b,T),b.push(n.outputColorSpace)),b.push(T.customProgramCacheKey),b.join()}function S(T,b){T.push(b.precision),T.push(b.outputColorSpace),T.push(b.envMapMode),T.push(b.envMapCubeUVHeight),T.push(b.mapUv),T.push(b.alphaMapUv),T.push(b.lightMapUv),T.push(b.aoMapUv),T.push(b.bumpMapUv),T.push(b.normalMapUv),T.push(b.displacementMapUv),T.push(b.emissiveMapUv),T.push(b.metalnessMapUv),T.push(b.roughnessMapUv),T.push(b.anisotropyMapUv),T.push(b.clearcoatMapUv),T.push(b.clearcoatNormalMapUv),T.push(b.clearcoatRoughnessMapUv),T.push(b.iridescenceMapUv),T.push(b.iridescenceThicknessMapUv),T.push(b.sheenColorMapUv),T.push(b.sheenRoughnessMapUv),T.push(b.specularMapUv),T.push(b.specularColorMapUv),T.push(b.specularIntensityMapUv),T.push(b.transmissionMapUv),T.push(b.thicknessMapUv),T.push(b.combine),T.push(b.fogExp2),T.push(b.sizeAttenuation),T.push(b.morphTargetsCount),T.push(b.morphAttributeCount),T.push(b.numDirLights),T.push(b.numPointLights),T.push(b.numSpotLights),T.push(b.numSpotLightMaps),T.push(b.numHemiLights),T.push(b.numRectAreaLights),T.push(b.numDirLightShadows),T.push(b.numPointLightShadows),T.push(b.numSpotLightShadows),T.push(b.numSpotLightShadowsWithMaps),T.push(b.numLightProbes),T.push(b.shadowMapType),T.push(b.toneMapping),T.push(b.numClippingPlanes),T.push(b.numClipIntersection),T.push(b.depthPacking)}function w(T,b){a.disableAll(),b.supportsVertexTextures&&a.enable(0),b.instancing&&a.enable(1),b.instancingColor&&a.enable(2),b.instancingMorph&&a.enable(3),b.matcap&&a.enable(4),b.envMap&&a.enable(5),b.normalMapObjectSpace&&a.enable(6),b.normalMapTangentSpace&&a.enable(7),b.clearcoat&&a.enable(8),b.iridescence&&a.enable(9),b.alphaTest&&a.enable(10),b.vertexColors&&a.enable(11),b.vertexAlphas&&a.enable(12),b.vertexUv1s&&a.enable(13),b.vertexUv2s&&a.enable(14),b.vertexUv3s&&a.enable(15),b.vertexTangents&&a.enable(16),b.anisotropy&&a.enable(17),b.alphaHash&&a.enable(18),b.batching&&a.enable(19),b.dispersion&&a.enable(20),b.batchingColor&&a.enable(21),b.gradientMap&&a.enable(22),T.push(a.mask),a.disableAll(),b.fog&&a.enable(0),b.useFog&&a.enable(1),b.flatShading&&a.enable(2),b.logarithmicDepthBuffer&&a.enable(3),b.reversedDepthBuffer&&a.enable(4),b.skinning&&a.enable(5),b.morphTargets&&a.enable(6),b.morphNormals&&a.enable(7),b.morphColors&&a.enable(8),b.premultipliedAlpha&&a.enable(9),b.shadowMapEnabled&&a.enable(10),b.doubleSided&&a.enable(11),b.flipSided&&a.enable(12),b.useDepthPacking&&a.enable(13),b.dithering&&a.enable(14),b.transmission&&a.enable(15),b.sheen&&a.enable(16),b.opaque&&a.enable(17),b.pointsUvs&&a.enable(18),b.decodeVideoTexture&&a.enable(19),b.decodeVideoTextureEmissive&&a.enable(20),b.alphaToCoverage&&a.enable(21),T.push(a.mask)}function y(T){const b=_[T.type];let C;if(b){const B=$i[b];C=yM.clone(B.uniforms)}else C=T.uniforms;return C}function L(T,b){let C;for(let B=0,z=u.length;B<z;B++){const X=u[B];if(X.cacheKey===b){C=X,++C.usedTimes;break}}return C===void 0&&(C=new Zw(n,b,T,r),u.push(C)),C}function R(T){if(--T.usedTimes===0){const b=u.indexOf(T);u[b]=u[u.length-1],u.pop(),T.destroy()}}function U(T){l.remove(T)}function N(){l.dispose()}return{getParameters:m,getProgramCacheKey:p,getUniforms:y,acquireProgram:L,releaseProgram:R,releaseShaderCache:U,programs:u,dispose:N}}function nT(){let n=new WeakMap;function e(o){return n.has(o)}function t(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:e,get:t,remove:i,update:s,dispose:r}}function iT(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.material.id!==e.material.id?n.material.id-e.material.id:n.z!==e.z?n.z-e.z:n.id-e.id}function mm(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.z!==e.z?e.z-n.z:n.id-e.id}function _m(){const n=[];let e=0;const t=[],i=[],s=[];function r(){e=0,t.length=0,i.length=0,s.length=0}function o(h,f,d,_,x,m){let p=n[e];return p===void 0?(p={id:h.id,object:h,geometry:f,material:d,groupOrder:_,renderOrder:h.renderOrder,z:x,group:m},n[e]=p):(p.id=h.id,p.object=h,p.geometry=f,p.material=d,p.groupOrder=_,p.renderOrder=h.renderOrder,p.z=x,p.group=m),e++,p}function a(h,f,d,_,x,m){const p=o(h,f,d,_,x,m);d.transmission>0?i.push(p):d.transparent===!0?s.push(p):t.push(p)}function l(h,f,d,_,x,m){const p=o(h,f,d,_,x,m);d.transmission>0?i.unshift(p):d.transparent===!0?s.unshift(p):t.unshift(p)}function c(h,f){t.length>1&&t.sort(h||iT),i.length>1&&i.sort(f||mm),s.length>1&&s.sort(f||mm)}function u(){for(let h=e,f=n.length;h<f;h++){const d=n[h];if(d.id===null)break;d.id=null,d.object=null,d.geometry=null,d.material=null,d.group=null}}return{opaque:t,transmissive:i,transparent:s,init:r,push:a,unshift:l,finish:u,sort:c}}function sT(){let n=new WeakMap;function e(i,s){const r=n.get(i);let o;return r===void 0?(o=new _m,n.set(i,[o])):s>=r.length?(o=new _m,r.push(o)):o=r[s],o}function t(){n=new WeakMap}return{get:e,dispose:t}}function rT(){const n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"DirectionalLight":t={direction:new k,color:new Qe};break;case"SpotLight":t={position:new k,direction:new k,color:new Qe,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new k,color:new Qe,distance:0,decay:0};break;case"HemisphereLight":t={direction:new k,skyColor:new Qe,groundColor:new Qe};break;case"RectAreaLight":t={color:new Qe,position:new k,halfWidth:new k,halfHeight:new k};break}return n[e.id]=t,t}}}function oT(){const n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ke};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ke};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ke,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[e.id]=t,t}}}let aT=0;function lT(n,e){return(e.castShadow?2:0)-(n.castShadow?2:0)+(e.map?1:0)-(n.map?1:0)}function cT(n){const e=new rT,t=oT(),i={version:0,hash:{directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new k);const s=new k,r=new Pt,o=new Pt;function a(c){let u=0,h=0,f=0;for(let T=0;T<9;T++)i.probe[T].set(0,0,0);let d=0,_=0,x=0,m=0,p=0,S=0,w=0,y=0,L=0,R=0,U=0;c.sort(lT);for(let T=0,b=c.length;T<b;T++){const C=c[T],B=C.color,z=C.intensity,X=C.distance,W=C.shadow&&C.shadow.map?C.shadow.map.texture:null;if(C.isAmbientLight)u+=B.r*z,h+=B.g*z,f+=B.b*z;else if(C.isLightProbe){for(let q=0;q<9;q++)i.probe[q].addScaledVector(C.sh.coefficients[q],z);U++}else if(C.isDirectionalLight){const q=e.get(C);if(q.color.copy(C.color).multiplyScalar(C.intensity),C.castShadow){const j=C.shadow,Z=t.get(C);Z.shadowIntensity=j.intensity,Z.shadowBias=j.bias,Z.shadowNormalBias=j.normalBias,Z.shadowRadius=j.radius,Z.shadowMapSize=j.mapSize,i.directionalShadow[d]=Z,i.directionalShadowMap[d]=W,i.directionalShadowMatrix[d]=C.shadow.matrix,S++}i.directional[d]=q,d++}else if(C.isSpotLight){const q=e.get(C);q.position.setFromMatrixPosition(C.matrixWorld),q.color.copy(B).multiplyScalar(z),q.distance=X,q.coneCos=Math.cos(C.angle),q.penumbraCos=Math.cos(C.angle*(1-C.penumbra)),q.decay=C.decay,i.spot[x]=q;const j=C.shadow;if(C.map&&(i.spotLightMap[L]=C.map,L++,j.updateMatrices(C),C.castShadow&&R++),i.spotLightMatrix[x]=j.matrix,C.castShadow){const Z=t.get(C);Z.shadowIntensity=j.intensity,Z.shadowBias=j.bias,Z.shadowNormalBias=j.normalBias,Z.shadowRadius=j.radius,Z.shadowMapSize=j.mapSize,i.spotShadow[x]=Z,i.spotShadowMap[x]=W,y++}x++}else if(C.isRectAreaLight){const q=e.get(C);q.color.copy(B).multiplyScalar(z),q.halfWidth.set(C.width*.5,0,0),q.halfHeight.set(0,C.height*.5,0),i.rectArea[m]=q,m++}else if(C.isPointLight){const q=e.get(C);if(q.color.copy(C.color).multiplyScalar(C.intensity),q.distance=C.distance,q.decay=C.decay,C.castShadow){const j=C.shadow,Z=t.get(C);Z.shadowIntensity=j.intensity,Z.shadowBias=j.bias,Z.shadowNormalBias=j.normalBias,Z.shadowRadius=j.radius,Z.shadowMapSize=j.mapSize,Z.shadowCameraNear=j.camera.near,Z.shadowCameraFar=j.camera.far,i.pointShadow[_]=Z,i.pointShadowMap[_]=W,i.pointShadowMatrix[_]=C.shadow.matrix,w++}i.point[_]=q,_++}else if(C.isHemisphereLight){const q=e.get(C);q.skyColor.copy(C.color).multiplyScalar(z),q.groundColor.copy(C.groundColor).multiplyScalar(z),i.hemi[p]=q,p++}}m>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=be.LTC_FLOAT_1,i.rectAreaLTC2=be.LTC_FLOAT_2):(i.rectAreaLTC1=be.LTC_HALF_1,i.rectAreaLTC2=be.LTC_HALF_2)),i.ambient[0]=u,i.ambient[1]=h,i.ambient[2]=f;const N=i.hash;(N.directionalLength!==d||N.pointLength!==_||N.spotLength!==x||N.rectAreaLength!==m||N.hemiLength!==p||N.numDirectionalShadows!==S||N.numPointShadows!==w||N.numSpotShadows!==y||N.numSpotMaps!==L||N.numLightProbes!==U)&&(i.directional.length=d,i.spot.length=x,i.rectArea.length=m,i.point.length=_,i.hemi.length=p,i.directionalShadow.length=S,i.directionalShadowMap.length=S,i.pointShadow.length=w,i.pointShadowMap.length=w,i.spotShadow.length=y,i.spotShadowMap.length=y,i.directionalShadowMatrix.length=S,i.pointShadowMatrix.length=w,i.spotLightMatrix.length=y+L-R,i.spotLightMap.length=L,i.numSpotLightShadowsWithMaps=R,i.numLightProbes=U,N.directionalLength=d,N.pointLength=_,N.spotLength=x,N.rectAreaLength=m,N.hemiLength=p,N.numDirectionalShadows=S,N.numPointShadows=w,N.numSpotShadows=y,N.numSpotMaps=L,N.numLightProbes=U,i.version=aT++)}function l(c,u){let h=0,f=0,d=0,_=0,x=0;const m=u.matrixWorldInverse;for(let p=0,S=c.length;p<S;p++){const w=c[p];if(w.isDirectionalLight){const y=i.directional[h];y.direction.setFromMatrixPosition(w.matrixWorld),s.setFromMatrixPosition(w.target.matrixWorld),y.direction.sub(s),y.direction.transformDirection(m),h++}else if(w.isSpotLight){const y=i.spot[d];y.position.setFromMatrixPosition(w.matrixWorld),y.position.applyMatrix4(m),y.direction.setFromMatrixPosition(w.matrixWorld),s.setFromMatrixPosition(w.target.matrixWorld),y.direction.sub(s),y.direction.transformDirection(m),d++}else if(w.isRectAreaLight){const y=i.rectArea[_];y.position.setFromMatrixPosition(w.matrixWorld),y.position.applyMatrix4(m),o.identity(),r.copy(w.matrixWorld),r.premultiply(m),o.extractRotation(r),y.halfWidth.set(w.width*.5,0,0),y.halfHeight.set(0,w.height*.5,0),y.halfWidth.applyMatrix4(o),y.halfHeight.applyMatrix4(o),_++}else if(w.isPointLight){const y=i.point[f];y.position.setFromMatrixPosition(w.matrixWorld),y.position.applyMatrix4(m),f++}else if(w.isHemisphereLight){const y=i.hemi[x];y.direction.setFromMatrixPosition(w.matrixWorld),y.direction.transformDirection(m),x++}}}return{setup:a,setupView:l,state:i}}function gm(n){const e=new cT(n),t=[],i=[];function s(u){c.camera=u,t.length=0,i.length=0}function r(u){t.push(u)}function o(u){i.push(u)}function a(){e.setup(t)}function l(u){e.setupView(t,u)}const c={lightsArray:t,shadowsArray:i,camera:null,lights:e,transmissionRenderTarget:{}};return{init:s,state:c,setupLights:a,setupLightsView:l,pushLight:r,pushShadow:o}}function uT(n){let e=new WeakMap;function t(s,r=0){const o=e.get(s);let a;return o===void 0?(a=new gm(n),e.set(s,[a])):r>=o.length?(a=new gm(n),o.push(a)):a=o[r],a}function i(){e=new WeakMap}return{get:t,dispose:i}}const hT=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,fT=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
#include <packing>
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = unpackRGBATo2Half( texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ) );
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = unpackRGBAToDepth( texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ) );
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( squared_mean - mean * mean );
	gl_FragColor = pack2HalfToRGBA( vec2( mean, std_dev ) );
}`;function dT(n,e,t){let i=new Df;const s=new Ke,r=new Ke,o=new tn,a=new OM({depthPacking:Vy}),l=new kM,c={},u=t.maxTextureSize,h={[ys]:ei,[ei]:ys,[Fi]:Fi},f=new ts({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Ke},radius:{value:4}},vertexShader:hT,fragmentShader:fT}),d=f.clone();d.defines.HORIZONTAL_PASS=1;const _=new on;_.setAttribute("position",new Dn(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));const x=new Ee(_,f),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=ig;let p=this.type;this.render=function(R,U,N){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||R.length===0)return;const T=n.getRenderTarget(),b=n.getActiveCubeFace(),C=n.getActiveMipmapLevel(),B=n.state;B.setBlending(Hs),B.buffers.depth.getReversed()===!0?B.buffers.color.setClear(0,0,0,0):B.buffers.color.setClear(1,1,1,1),B.buffers.depth.setTest(!0),B.setScissorTest(!1);const z=p!==hs&&this.type===hs,X=p===hs&&this.type!==hs;for(let W=0,q=R.length;W<q;W++){const j=R[W],Z=j.shadow;if(Z===void 0){console.warn("THREE.WebGLShadowMap:",j,"has no shadow.");continue}if(Z.autoUpdate===!1&&Z.needsUpdate===!1)continue;s.copy(Z.mapSize);const re=Z.getFrameExtents();if(s.multiply(re),r.copy(Z.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/re.x),s.x=r.x*re.x,Z.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/re.y),s.y=r.y*re.y,Z.mapSize.y=r.y)),Z.map===null||z===!0||X===!0){const me=this.type!==hs?{minFilter:qn,magFilter:qn}:{};Z.map!==null&&Z.map.dispose(),Z.map=new Ys(s.x,s.y,me),Z.map.texture.name=j.name+".shadowMap",Z.camera.updateProjectionMatrix()}n.setRenderTarget(Z.map),n.clear();const ae=Z.getViewportCount();for(let me=0;me<ae;me++){const xe=Z.getViewport(me);o.set(r.x*xe.x,r.y*xe.y,r.x*xe.z,r.y*xe.w),B.viewport(o),Z.updateMatrices(j,me),i=Z.getFrustum(),y(U,N,Z.camera,j,this.type)}Z.isPointLightShadow!==!0&&this.type===hs&&S(Z,N),Z.needsUpdate=!1}p=this.type,m.needsUpdate=!1,n.setRenderTarget(T,b,C)};function S(R,U){const N=e.update(x);f.defines.VSM_SAMPLES!==R.blurSamples&&(f.defines.VSM_SAMPLES=R.blurSamples,d.defines.VSM_SAMPLES=R.blurSamples,f.needsUpdate=!0,d.needsUpdate=!0),R.mapPass===null&&(R.mapPass=new Ys(s.x,s.y)),f.uniforms.shadow_pass.value=R.map.texture,f.uniforms.resolution.value=R.mapSize,f.uniforms.radius.value=R.radius,n.setRenderTarget(R.mapPass),n.clear(),n.renderBufferDirect(U,null,N,f,x,null),d.uniforms.shadow_pass.value=R.mapPass.texture,d.uniforms.resolution.value=R.mapSize,d.uniforms.radius.value=R.radius,n.setRenderTarget(R.map),n.clear(),n.renderBufferDirect(U,null,N,d,x,null)}function w(R,U,N,T){let b=null;const C=N.isPointLight===!0?R.customDistanceMaterial:R.customDepthMaterial;if(C!==void 0)b=C;else if(b=N.isPointLight===!0?l:a,n.localClippingEnabled&&U.clipShadows===!0&&Array.isArray(U.clippingPlanes)&&U.clippingPlanes.length!==0||U.displacementMap&&U.displacementScale!==0||U.alphaMap&&U.alphaTest>0||U.map&&U.alphaTest>0||U.alphaToCoverage===!0){const B=b.uuid,z=U.uuid;let X=c[B];X===void 0&&(X={},c[B]=X);let W=X[z];W===void 0&&(W=b.clone(),X[z]=W,U.addEventListener("dispose",L)),b=W}if(b.visible=U.visible,b.wireframe=U.wireframe,T===hs?b.side=U.shadowSide!==null?U.shadowSide:U.side:b.side=U.shadowSide!==null?U.shadowSide:h[U.side],b.alphaMap=U.alphaMap,b.alphaTest=U.alphaToCoverage===!0?.5:U.alphaTest,b.map=U.map,b.clipShadows=U.clipShadows,b.clippingPlanes=U.clippingPlanes,b.clipIntersection=U.clipIntersection,b.displacementMap=U.displacementMap,b.displacementScale=U.displacementScale,b.displacementBias=U.displacementBias,b.wireframeLinewidth=U.wireframeLinewidth,b.linewidth=U.linewidth,N.isPointLight===!0&&b.isMeshDistanceMaterial===!0){const B=n.properties.get(b);B.light=N}return b}function y(R,U,N,T,b){if(R.visible===!1)return;if(R.layers.test(U.layers)&&(R.isMesh||R.isLine||R.isPoints)&&(R.castShadow||R.receiveShadow&&b===hs)&&(!R.frustumCulled||i.intersectsObject(R))){R.modelViewMatrix.multiplyMatrices(N.matrixWorldInverse,R.matrixWorld);const z=e.update(R),X=R.material;if(Array.isArray(X)){const W=z.groups;for(let q=0,j=W.length;q<j;q++){const Z=W[q],re=X[Z.materialIndex];if(re&&re.visible){const ae=w(R,re,T,b);R.onBeforeShadow(n,R,U,N,z,ae,Z),n.renderBufferDirect(N,null,z,ae,R,Z),R.onAfterShadow(n,R,U,N,z,ae,Z)}}}else if(X.visible){const W=w(R,X,T,b);R.onBeforeShadow(n,R,U,N,z,W,null),n.renderBufferDirect(N,null,z,W,R,null),R.onAfterShadow(n,R,U,N,z,W,null)}}const B=R.children;for(let z=0,X=B.length;z<X;z++)y(B[z],U,N,T,b)}function L(R){R.target.removeEventListener("dispose",L);for(const N in c){const T=c[N],b=R.target.uuid;b in T&&(T[b].dispose(),delete T[b])}}}const pT={[th]:nh,[ih]:oh,[sh]:ah,[wo]:rh,[nh]:th,[oh]:ih,[ah]:sh,[rh]:wo};function mT(n,e){function t(){let H=!1;const fe=new tn;let pe=null;const De=new tn(0,0,0,0);return{setMask:function(ue){pe!==ue&&!H&&(n.colorMask(ue,ue,ue,ue),pe=ue)},setLocked:function(ue){H=ue},setClear:function(ue,oe,Oe,st,Dt){Dt===!0&&(ue*=st,oe*=st,Oe*=st),fe.set(ue,oe,Oe,st),De.equals(fe)===!1&&(n.clearColor(ue,oe,Oe,st),De.copy(fe))},reset:function(){H=!1,pe=null,De.set(-1,0,0,0)}}}function i(){let H=!1,fe=!1,pe=null,De=null,ue=null;return{setReversed:function(oe){if(fe!==oe){const Oe=e.get("EXT_clip_control");oe?Oe.clipControlEXT(Oe.LOWER_LEFT_EXT,Oe.ZERO_TO_ONE_EXT):Oe.clipControlEXT(Oe.LOWER_LEFT_EXT,Oe.NEGATIVE_ONE_TO_ONE_EXT),fe=oe;const st=ue;ue=null,this.setClear(st)}},getReversed:function(){return fe},setTest:function(oe){oe?ne(n.DEPTH_TEST):we(n.DEPTH_TEST)},setMask:function(oe){pe!==oe&&!H&&(n.depthMask(oe),pe=oe)},setFunc:function(oe){if(fe&&(oe=pT[oe]),De!==oe){switch(oe){case th:n.depthFunc(n.NEVER);break;case nh:n.depthFunc(n.ALWAYS);break;case ih:n.depthFunc(n.LESS);break;case wo:n.depthFunc(n.LEQUAL);break;case sh:n.depthFunc(n.EQUAL);break;case rh:n.depthFunc(n.GEQUAL);break;case oh:n.depthFunc(n.GREATER);break;case ah:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}De=oe}},setLocked:function(oe){H=oe},setClear:function(oe){ue!==oe&&(fe&&(oe=1-oe),n.clearDepth(oe),ue=oe)},reset:function(){H=!1,pe=null,De=null,ue=null,fe=!1}}}function s(){let H=!1,fe=null,pe=null,De=null,ue=null,oe=null,Oe=null,st=null,Dt=null;return{setTest:function(gt){H||(gt?ne(n.STENCIL_TEST):we(n.STENCIL_TEST))},setMask:function(gt){fe!==gt&&!H&&(n.stencilMask(gt),fe=gt)},setFunc:function(gt,Cn,Nt){(pe!==gt||De!==Cn||ue!==Nt)&&(n.stencilFunc(gt,Cn,Nt),pe=gt,De=Cn,ue=Nt)},setOp:function(gt,Cn,Nt){(oe!==gt||Oe!==Cn||st!==Nt)&&(n.stencilOp(gt,Cn,Nt),oe=gt,Oe=Cn,st=Nt)},setLocked:function(gt){H=gt},setClear:function(gt){Dt!==gt&&(n.clearStencil(gt),Dt=gt)},reset:function(){H=!1,fe=null,pe=null,De=null,ue=null,oe=null,Oe=null,st=null,Dt=null}}}const r=new t,o=new i,a=new s,l=new WeakMap,c=new WeakMap;let u={},h={},f=new WeakMap,d=[],_=null,x=!1,m=null,p=null,S=null,w=null,y=null,L=null,R=null,U=new Qe(0,0,0),N=0,T=!1,b=null,C=null,B=null,z=null,X=null;const W=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS);let q=!1,j=0;const Z=n.getParameter(n.VERSION);Z.indexOf("WebGL")!==-1?(j=parseFloat(/^WebGL (\d)/.exec(Z)[1]),q=j>=1):Z.indexOf("OpenGL ES")!==-1&&(j=parseFloat(/^OpenGL ES (\d)/.exec(Z)[1]),q=j>=2);let re=null,ae={};const me=n.getParameter(n.SCISSOR_BOX),xe=n.getParameter(n.VIEWPORT),ge=new tn().fromArray(me),tt=new tn().fromArray(xe);function nt(H,fe,pe,De){const ue=new Uint8Array(4),oe=n.createTexture();n.bindTexture(H,oe),n.texParameteri(H,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(H,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let Oe=0;Oe<pe;Oe++)H===n.TEXTURE_3D||H===n.TEXTURE_2D_ARRAY?n.texImage3D(fe,0,n.RGBA,1,1,De,0,n.RGBA,n.UNSIGNED_BYTE,ue):n.texImage2D(fe+Oe,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,ue);return oe}const ee={};ee[n.TEXTURE_2D]=nt(n.TEXTURE_2D,n.TEXTURE_2D,1),ee[n.TEXTURE_CUBE_MAP]=nt(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),ee[n.TEXTURE_2D_ARRAY]=nt(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),ee[n.TEXTURE_3D]=nt(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),ne(n.DEPTH_TEST),o.setFunc(wo),Ye(!1),Ne(up),ne(n.CULL_FACE),mt(Hs);function ne(H){u[H]!==!0&&(n.enable(H),u[H]=!0)}function we(H){u[H]!==!1&&(n.disable(H),u[H]=!1)}function ze(H,fe){return h[H]!==fe?(n.bindFramebuffer(H,fe),h[H]=fe,H===n.DRAW_FRAMEBUFFER&&(h[n.FRAMEBUFFER]=fe),H===n.FRAMEBUFFER&&(h[n.DRAW_FRAMEBUFFER]=fe),!0):!1}function ye(H,fe){let pe=d,De=!1;if(H){pe=f.get(fe),pe===void 0&&(pe=[],f.set(fe,pe));const ue=H.textures;if(pe.length!==ue.length||pe[0]!==n.COLOR_ATTACHMENT0){for(let oe=0,Oe=ue.length;oe<Oe;oe++)pe[oe]=n.COLOR_ATTACHMENT0+oe;pe.length=ue.length,De=!0}}else pe[0]!==n.BACK&&(pe[0]=n.BACK,De=!0);De&&n.drawBuffers(pe)}function it(H){return _!==H?(n.useProgram(H),_=H,!0):!1}const Bt={[mr]:n.FUNC_ADD,[my]:n.FUNC_SUBTRACT,[_y]:n.FUNC_REVERSE_SUBTRACT};Bt[gy]=n.MIN,Bt[vy]=n.MAX;const F={[xy]:n.ZERO,[yy]:n.ONE,[My]:n.SRC_COLOR,[Qu]:n.SRC_ALPHA,[Ay]:n.SRC_ALPHA_SATURATE,[wy]:n.DST_COLOR,[Ey]:n.DST_ALPHA,[Sy]:n.ONE_MINUS_SRC_COLOR,[eh]:n.ONE_MINUS_SRC_ALPHA,[Ty]:n.ONE_MINUS_DST_COLOR,[by]:n.ONE_MINUS_DST_ALPHA,[Ry]:n.CONSTANT_COLOR,[Cy]:n.ONE_MINUS_CONSTANT_COLOR,[Py]:n.CONSTANT_ALPHA,[Dy]:n.ONE_MINUS_CONSTANT_ALPHA};function mt(H,fe,pe,De,ue,oe,Oe,st,Dt,gt){if(H===Hs){x===!0&&(we(n.BLEND),x=!1);return}if(x===!1&&(ne(n.BLEND),x=!0),H!==py){if(H!==m||gt!==T){if((p!==mr||y!==mr)&&(n.blendEquation(n.FUNC_ADD),p=mr,y=mr),gt)switch(H){case po:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case hp:n.blendFunc(n.ONE,n.ONE);break;case fp:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case dp:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:console.error("THREE.WebGLState: Invalid blending: ",H);break}else switch(H){case po:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case hp:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case fp:console.error("THREE.WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case dp:console.error("THREE.WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:console.error("THREE.WebGLState: Invalid blending: ",H);break}S=null,w=null,L=null,R=null,U.set(0,0,0),N=0,m=H,T=gt}return}ue=ue||fe,oe=oe||pe,Oe=Oe||De,(fe!==p||ue!==y)&&(n.blendEquationSeparate(Bt[fe],Bt[ue]),p=fe,y=ue),(pe!==S||De!==w||oe!==L||Oe!==R)&&(n.blendFuncSeparate(F[pe],F[De],F[oe],F[Oe]),S=pe,w=De,L=oe,R=Oe),(st.equals(U)===!1||Dt!==N)&&(n.blendColor(st.r,st.g,st.b,Dt),U.copy(st),N=Dt),m=H,T=!1}function Ze(H,fe){H.side===Fi?we(n.CULL_FACE):ne(n.CULL_FACE);let pe=H.side===ei;fe&&(pe=!pe),Ye(pe),H.blending===po&&H.transparent===!1?mt(Hs):mt(H.blending,H.blendEquation,H.blendSrc,H.blendDst,H.blendEquationAlpha,H.blendSrcAlpha,H.blendDstAlpha,H.blendColor,H.blendAlpha,H.premultipliedAlpha),o.setFunc(H.depthFunc),o.setTest(H.depthTest),o.setMask(H.depthWrite),r.setMask(H.colorWrite);const De=H.stencilWrite;a.setTest(De),De&&(a.setMask(H.stencilWriteMask),a.setFunc(H.stencilFunc,H.stencilRef,H.stencilFuncMask),a.setOp(H.stencilFail,H.stencilZFail,H.stencilZPass)),Pe(H.polygonOffset,H.polygonOffsetFactor,H.polygonOffsetUnits),H.alphaToCoverage===!0?ne(n.SAMPLE_ALPHA_TO_COVERAGE):we(n.SAMPLE_ALPHA_TO_COVERAGE)}function Ye(H){b!==H&&(H?n.frontFace(n.CW):n.frontFace(n.CCW),b=H)}function Ne(H){H!==fy?(ne(n.CULL_FACE),H!==C&&(H===up?n.cullFace(n.BACK):H===dy?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):we(n.CULL_FACE),C=H}function Rt(H){H!==B&&(q&&n.lineWidth(H),B=H)}function Pe(H,fe,pe){H?(ne(n.POLYGON_OFFSET_FILL),(z!==fe||X!==pe)&&(n.polygonOffset(fe,pe),z=fe,X=pe)):we(n.POLYGON_OFFSET_FILL)}function We(H){H?ne(n.SCISSOR_TEST):we(n.SCISSOR_TEST)}function Gt(H){H===void 0&&(H=n.TEXTURE0+W-1),re!==H&&(n.activeTexture(H),re=H)}function Et(H,fe,pe){pe===void 0&&(re===null?pe=n.TEXTURE0+W-1:pe=re);let De=ae[pe];De===void 0&&(De={type:void 0,texture:void 0},ae[pe]=De),(De.type!==H||De.texture!==fe)&&(re!==pe&&(n.activeTexture(pe),re=pe),n.bindTexture(H,fe||ee[H]),De.type=H,De.texture=fe)}function D(){const H=ae[re];H!==void 0&&H.type!==void 0&&(n.bindTexture(H.type,null),H.type=void 0,H.texture=void 0)}function M(){try{n.compressedTexImage2D(...arguments)}catch(H){console.error("THREE.WebGLState:",H)}}function O(){try{n.compressedTexImage3D(...arguments)}catch(H){console.error("THREE.WebGLState:",H)}}function J(){try{n.texSubImage2D(...arguments)}catch(H){console.error("THREE.WebGLState:",H)}}function ie(){try{n.texSubImage3D(...arguments)}catch(H){console.error("THREE.WebGLState:",H)}}function te(){try{n.compressedTexSubImage2D(...arguments)}catch(H){console.error("THREE.WebGLState:",H)}}function Fe(){try{n.compressedTexSubImage3D(...arguments)}catch(H){console.error("THREE.WebGLState:",H)}}function he(){try{n.texStorage2D(...arguments)}catch(H){console.error("THREE.WebGLState:",H)}}function Le(){try{n.texStorage3D(...arguments)}catch(H){console.error("THREE.WebGLState:",H)}}function Re(){try{n.texImage2D(...arguments)}catch(H){console.error("THREE.WebGLState:",H)}}function le(){try{n.texImage3D(...arguments)}catch(H){console.error("THREE.WebGLState:",H)}}function ve(H){ge.equals(H)===!1&&(n.scissor(H.x,H.y,H.z,H.w),ge.copy(H))}function Be(H){tt.equals(H)===!1&&(n.viewport(H.x,H.y,H.z,H.w),tt.copy(H))}function ke(H,fe){let pe=c.get(fe);pe===void 0&&(pe=new WeakMap,c.set(fe,pe));let De=pe.get(H);De===void 0&&(De=n.getUniformBlockIndex(fe,H.name),pe.set(H,De))}function Me(H,fe){const De=c.get(fe).get(H);l.get(fe)!==De&&(n.uniformBlockBinding(fe,De,H.__bindingPointIndex),l.set(fe,De))}function et(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),u={},re=null,ae={},h={},f=new WeakMap,d=[],_=null,x=!1,m=null,p=null,S=null,w=null,y=null,L=null,R=null,U=new Qe(0,0,0),N=0,T=!1,b=null,C=null,B=null,z=null,X=null,ge.set(0,0,n.canvas.width,n.canvas.height),tt.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:ne,disable:we,bindFramebuffer:ze,drawBuffers:ye,useProgram:it,setBlending:mt,setMaterial:Ze,setFlipSided:Ye,setCullFace:Ne,setLineWidth:Rt,setPolygonOffset:Pe,setScissorTest:We,activeTexture:Gt,bindTexture:Et,unbindTexture:D,compressedTexImage2D:M,compressedTexImage3D:O,texImage2D:Re,texImage3D:le,updateUBOMapping:ke,uniformBlockBinding:Me,texStorage2D:he,texStorage3D:Le,texSubImage2D:J,texSubImage3D:ie,compressedTexSubImage2D:te,compressedTexSubImage3D:Fe,scissor:ve,viewport:Be,reset:et}}function _T(n,e,t,i,s,r,o){const a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Ke,u=new WeakMap;let h;const f=new WeakMap;let d=!1;try{d=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function _(D,M){return d?new OffscreenCanvas(D,M):ic("canvas")}function x(D,M,O){let J=1;const ie=Et(D);if((ie.width>O||ie.height>O)&&(J=O/Math.max(ie.width,ie.height)),J<1)if(typeof HTMLImageElement<"u"&&D instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&D instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&D instanceof ImageBitmap||typeof VideoFrame<"u"&&D instanceof VideoFrame){const te=Math.floor(J*ie.width),Fe=Math.floor(J*ie.height);h===void 0&&(h=_(te,Fe));const he=M?_(te,Fe):h;return he.width=te,he.height=Fe,he.getContext("2d").drawImage(D,0,0,te,Fe),console.warn("THREE.WebGLRenderer: Texture has been resized from ("+ie.width+"x"+ie.height+") to ("+te+"x"+Fe+")."),he}else return"data"in D&&console.warn("THREE.WebGLRenderer: Image in DataTexture is too big ("+ie.width+"x"+ie.height+")."),D;return D}function m(D){return D.generateMipmaps}function p(D){n.generateMipmap(D)}function S(D){return D.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:D.isWebGL3DRenderTarget?n.TEXTURE_3D:D.isWebGLArrayRenderTarget||D.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function w(D,M,O,J,ie=!1){if(D!==null){if(n[D]!==void 0)return n[D];console.warn("THREE.WebGLRenderer: Attempt to use non-existing WebGL internal format '"+D+"'")}let te=M;if(M===n.RED&&(O===n.FLOAT&&(te=n.R32F),O===n.HALF_FLOAT&&(te=n.R16F),O===n.UNSIGNED_BYTE&&(te=n.R8)),M===n.RED_INTEGER&&(O===n.UNSIGNED_BYTE&&(te=n.R8UI),O===n.UNSIGNED_SHORT&&(te=n.R16UI),O===n.UNSIGNED_INT&&(te=n.R32UI),O===n.BYTE&&(te=n.R8I),O===n.SHORT&&(te=n.R16I),O===n.INT&&(te=n.R32I)),M===n.RG&&(O===n.FLOAT&&(te=n.RG32F),O===n.HALF_FLOAT&&(te=n.RG16F),O===n.UNSIGNED_BYTE&&(te=n.RG8)),M===n.RG_INTEGER&&(O===n.UNSIGNED_BYTE&&(te=n.RG8UI),O===n.UNSIGNED_SHORT&&(te=n.RG16UI),O===n.UNSIGNED_INT&&(te=n.RG32UI),O===n.BYTE&&(te=n.RG8I),O===n.SHORT&&(te=n.RG16I),O===n.INT&&(te=n.RG32I)),M===n.RGB_INTEGER&&(O===n.UNSIGNED_BYTE&&(te=n.RGB8UI),O===n.UNSIGNED_SHORT&&(te=n.RGB16UI),O===n.UNSIGNED_INT&&(te=n.RGB32UI),O===n.BYTE&&(te=n.RGB8I),O===n.SHORT&&(te=n.RGB16I),O===n.INT&&(te=n.RGB32I)),M===n.RGBA_INTEGER&&(O===n.UNSIGNED_BYTE&&(te=n.RGBA8UI),O===n.UNSIGNED_SHORT&&(te=n.RGBA16UI),O===n.UNSIGNED_INT&&(te=n.RGBA32UI),O===n.BYTE&&(te=n.RGBA8I),O===n.SHORT&&(te=n.RGBA16I),O===n.INT&&(te=n.RGBA32I)),M===n.RGB&&(O===n.UNSIGNED_INT_5_9_9_9_REV&&(te=n.RGB9_E5),O===n.UNSIGNED_INT_10F_11F_11F_REV&&(te=n.R11F_G11F_B10F)),M===n.RGBA){const Fe=ie?tc:Mt.getTransfer(J);O===n.FLOAT&&(te=n.RGBA32F),O===n.HALF_FLOAT&&(te=n.RGBA16F),O===n.UNSIGNED_BYTE&&(te=Fe===It?n.SRGB8_ALPHA8:n.RGBA8),O===n.UNSIGNED_SHORT_4_4_4_4&&(te=n.RGBA4),O===n.UNSIGNED_SHORT_5_5_5_1&&(te=n.RGB5_A1)}return(te===n.R16F||te===n.R32F||te===n.RG16F||te===n.RG32F||te===n.RGBA16F||te===n.RGBA32F)&&e.get("EXT_color_buffer_float"),te}function y(D,M){let O;return D?M===null||M===Rr||M===Aa?O=n.DEPTH24_STENCIL8:M===Zi?O=n.DEPTH32F_STENCIL8:M===Ta&&(O=n.DEPTH24_STENCIL8,console.warn("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):M===null||M===Rr||M===Aa?O=n.DEPTH_COMPONENT24:M===Zi?O=n.DEPTH_COMPONENT32F:M===Ta&&(O=n.DEPTH_COMPONENT16),O}function L(D,M){return m(D)===!0||D.isFramebufferTexture&&D.minFilter!==qn&&D.minFilter!==Ki?Math.log2(Math.max(M.width,M.height))+1:D.mipmaps!==void 0&&D.mipmaps.length>0?D.mipmaps.length:D.isCompressedTexture&&Array.isArray(D.image)?M.mipmaps.length:1}function R(D){const M=D.target;M.removeEventListener("dispose",R),N(M),M.isVideoTexture&&u.delete(M)}function U(D){const M=D.target;M.removeEventListener("dispose",U),b(M)}function N(D){const M=i.get(D);if(M.__webglInit===void 0)return;const O=D.source,J=f.get(O);if(J){const ie=J[M.__cacheKey];ie.usedTimes--,ie.usedTimes===0&&T(D),Object.keys(J).length===0&&f.delete(O)}i.remove(D)}function T(D){const M=i.get(D);n.deleteTexture(M.__webglTexture);const O=D.source,J=f.get(O);delete J[M.__cacheKey],o.memory.textures--}function b(D){const M=i.get(D);if(D.depthTexture&&(D.depthTexture.dispose(),i.remove(D.depthTexture)),D.isWebGLCubeRenderTarget)for(let J=0;J<6;J++){if(Array.isArray(M.__webglFramebuffer[J]))for(let ie=0;ie<M.__webglFramebuffer[J].length;ie++)n.deleteFramebuffer(M.__webglFramebuffer[J][ie]);else n.deleteFramebuffer(M.__webglFramebuffer[J]);M.__webglDepthbuffer&&n.deleteRenderbuffer(M.__webglDepthbuffer[J])}else{if(Array.isArray(M.__webglFramebuffer))for(let J=0;J<M.__webglFramebuffer.length;J++)n.deleteFramebuffer(M.__webglFramebuffer[J]);else n.deleteFramebuffer(M.__webglFramebuffer);if(M.__webglDepthbuffer&&n.deleteRenderbuffer(M.__webglDepthbuffer),M.__webglMultisampledFramebuffer&&n.deleteFramebuffer(M.__webglMultisampledFramebuffer),M.__webglColorRenderbuffer)for(let J=0;J<M.__webglColorRenderbuffer.length;J++)M.__webglColorRenderbuffer[J]&&n.deleteRenderbuffer(M.__webglColorRenderbuffer[J]);M.__webglDepthRenderbuffer&&n.deleteRenderbuffer(M.__webglDepthRenderbuffer)}const O=D.textures;for(let J=0,ie=O.length;J<ie;J++){const te=i.get(O[J]);te.__webglTexture&&(n.deleteTexture(te.__webglTexture),o.memory.textures--),i.remove(O[J])}i.remove(D)}let C=0;function B(){C=0}function z(){const D=C;return D>=s.maxTextures&&console.warn("THREE.WebGLTextures: Trying to use "+D+" texture units while this GPU supports only "+s.maxTextures),C+=1,D}function X(D){const M=[];return M.push(D.wrapS),M.push(D.wrapT),M.push(D.wrapR||0),M.push(D.magFilter),M.push(D.minFilter),M.push(D.anisotropy),M.push(D.internalFormat),M.push(D.format),M.push(D.type),M.push(D.generateMipmaps),M.push(D.premultiplyAlpha),M.push(D.flipY),M.push(D.unpackAlignment),M.push(D.colorSpace),M.join()}function W(D,M){const O=i.get(D);if(D.isVideoTexture&&We(D),D.isRenderTargetTexture===!1&&D.isExternalTexture!==!0&&D.version>0&&O.__version!==D.version){const J=D.image;if(J===null)console.warn("THREE.WebGLRenderer: Texture marked for update but no image data found.");else if(J.complete===!1)console.warn("THREE.WebGLRenderer: Texture marked for update but image is incomplete");else{ee(O,D,M);return}}else D.isExternalTexture&&(O.__webglTexture=D.sourceTexture?D.sourceTexture:null);t.bindTexture(n.TEXTURE_2D,O.__webglTexture,n.TEXTURE0+M)}function q(D,M){const O=i.get(D);if(D.isRenderTargetTexture===!1&&D.version>0&&O.__version!==D.version){ee(O,D,M);return}t.bindTexture(n.TEXTURE_2D_ARRAY,O.__webglTexture,n.TEXTURE0+M)}function j(D,M){const O=i.get(D);if(D.isRenderTargetTexture===!1&&D.version>0&&O.__version!==D.version){ee(O,D,M);return}t.bindTexture(n.TEXTURE_3D,O.__webglTexture,n.TEXTURE0+M)}function Z(D,M){const O=i.get(D);if(D.version>0&&O.__version!==D.version){ne(O,D,M);return}t.bindTexture(n.TEXTURE_CUBE_MAP,O.__webglTexture,n.TEXTURE0+M)}const re={[uh]:n.REPEAT,[xr]:n.CLAMP_TO_EDGE,[hh]:n.MIRRORED_REPEAT},ae={[qn]:n.NEAREST,[zy]:n.NEAREST_MIPMAP_NEAREST,[Ka]:n.NEAREST_MIPMAP_LINEAR,[Ki]:n.LINEAR,[jc]:n.LINEAR_MIPMAP_NEAREST,[yr]:n.LINEAR_MIPMAP_LINEAR},me={[Wy]:n.NEVER,[Ky]:n.ALWAYS,[Xy]:n.LESS,[pg]:n.LEQUAL,[Yy]:n.EQUAL,[jy]:n.GEQUAL,[qy]:n.GREATER,[$y]:n.NOTEQUAL};function xe(D,M){if(M.type===Zi&&e.has("OES_texture_float_linear")===!1&&(M.magFilter===Ki||M.magFilter===jc||M.magFilter===Ka||M.magFilter===yr||M.minFilter===Ki||M.minFilter===jc||M.minFilter===Ka||M.minFilter===yr)&&console.warn("THREE.WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(D,n.TEXTURE_WRAP_S,re[M.wrapS]),n.texParameteri(D,n.TEXTURE_WRAP_T,re[M.wrapT]),(D===n.TEXTURE_3D||D===n.TEXTURE_2D_ARRAY)&&n.texParameteri(D,n.TEXTURE_WRAP_R,re[M.wrapR]),n.texParameteri(D,n.TEXTURE_MAG_FILTER,ae[M.magFilter]),n.texParameteri(D,n.TEXTURE_MIN_FILTER,ae[M.minFilter]),M.compareFunction&&(n.texParameteri(D,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(D,n.TEXTURE_COMPARE_FUNC,me[M.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(M.magFilter===qn||M.minFilter!==Ka&&M.minFilter!==yr||M.type===Zi&&e.has("OES_texture_float_linear")===!1)return;if(M.anisotropy>1||i.get(M).__currentAnisotropy){const O=e.get("EXT_texture_filter_anisotropic");n.texParameterf(D,O.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(M.anisotropy,s.getMaxAnisotropy())),i.get(M).__currentAnisotropy=M.anisotropy}}}function ge(D,M){let O=!1;D.__webglInit===void 0&&(D.__webglInit=!0,M.addEventListener("dispose",R));const J=M.source;let ie=f.get(J);ie===void 0&&(ie={},f.set(J,ie));const te=X(M);if(te!==D.__cacheKey){ie[te]===void 0&&(ie[te]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,O=!0),ie[te].usedTimes++;const Fe=ie[D.__cacheKey];Fe!==void 0&&(ie[D.__cacheKey].usedTimes--,Fe.usedTimes===0&&T(M)),D.__cacheKey=te,D.__webglTexture=ie[te].texture}return O}function tt(D,M,O){return Math.floor(Math.floor(D/O)/M)}function nt(D,M,O,J){const te=D.updateRanges;if(te.length===0)t.texSubImage2D(n.TEXTURE_2D,0,0,0,M.width,M.height,O,J,M.data);else{te.sort((le,ve)=>le.start-ve.start);let Fe=0;for(let le=1;le<te.length;le++){const ve=te[Fe],Be=te[le],ke=ve.start+ve.count,Me=tt(Be.start,M.width,4),et=tt(ve.start,M.width,4);Be.start<=ke+1&&Me===et&&tt(Be.start+Be.count-1,M.width,4)===Me?ve.count=Math.max(ve.count,Be.start+Be.count-ve.start):(++Fe,te[Fe]=Be)}te.length=Fe+1;const he=n.getParameter(n.UNPACK_ROW_LENGTH),Le=n.getParameter(n.UNPACK_SKIP_PIXELS),Re=n.getParameter(n.UNPACK_SKIP_ROWS);n.pixelStorei(n.UNPACK_ROW_LENGTH,M.width);for(let le=0,ve=te.length;le<ve;le++){const Be=te[le],ke=Math.floor(Be.start/4),Me=Math.ceil(Be.count/4),et=ke%M.width,H=Math.floor(ke/M.width),fe=Me,pe=1;n.pixelStorei(n.UNPACK_SKIP_PIXELS,et),n.pixelStorei(n.UNPACK_SKIP_ROWS,H),t.texSubImage2D(n.TEXTURE_2D,0,et,H,fe,pe,O,J,M.data)}D.clearUpdateRanges(),n.pixelStorei(n.UNPACK_ROW_LENGTH,he),n.pixelStorei(n.UNPACK_SKIP_PIXELS,Le),n.pixelStorei(n.UNPACK_SKIP_ROWS,Re)}}function ee(D,M,O){let J=n.TEXTURE_2D;(M.isDataArrayTexture||M.isCompressedArrayTexture)&&(J=n.TEXTURE_2D_ARRAY),M.isData3DTexture&&(J=n.TEXTURE_3D);const ie=ge(D,M),te=M.source;t.bindTexture(J,D.__webglTexture,n.TEXTURE0+O);const Fe=i.get(te);if(te.version!==Fe.__version||ie===!0){t.activeTexture(n.TEXTURE0+O);const he=Mt.getPrimaries(Mt.workingColorSpace),Le=M.colorSpace===Bs?null:Mt.getPrimaries(M.colorSpace),Re=M.colorSpace===Bs||he===Le?n.NONE:n.BROWSER_DEFAULT_WEBGL;n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,M.flipY),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,M.premultiplyAlpha),n.pixelStorei(n.UNPACK_ALIGNMENT,M.unpackAlignment),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,Re);let le=x(M.image,!1,s.maxTextureSize);le=Gt(M,le);const ve=r.convert(M.format,M.colorSpace),Be=r.convert(M.type);let ke=w(M.internalFormat,ve,Be,M.colorSpace,M.isVideoTexture);xe(J,M);let Me;const et=M.mipmaps,H=M.isVideoTexture!==!0,fe=Fe.__version===void 0||ie===!0,pe=te.dataReady,De=L(M,le);if(M.isDepthTexture)ke=y(M.format===Ca,M.type),fe&&(H?t.texStorage2D(n.TEXTURE_2D,1,ke,le.width,le.height):t.texImage2D(n.TEXTURE_2D,0,ke,le.width,le.height,0,ve,Be,null));else if(M.isDataTexture)if(et.length>0){H&&fe&&t.texStorage2D(n.TEXTURE_2D,De,ke,et[0].width,et[0].height);for(let ue=0,oe=et.length;ue<oe;ue++)Me=et[ue],H?pe&&t.texSubImage2D(n.TEXTURE_2D,ue,0,0,Me.width,Me.height,ve,Be,Me.data):t.texImage2D(n.TEXTURE_2D,ue,ke,Me.width,Me.height,0,ve,Be,Me.data);M.generateMipmaps=!1}else H?(fe&&t.texStorage2D(n.TEXTURE_2D,De,ke,le.width,le.height),pe&&nt(M,le,ve,Be)):t.texImage2D(n.TEXTURE_2D,0,ke,le.width,le.height,0,ve,Be,le.data);else if(M.isCompressedTexture)if(M.isCompressedArrayTexture){H&&fe&&t.texStorage3D(n.TEXTURE_2D_ARRAY,De,ke,et[0].width,et[0].height,le.depth);for(let ue=0,oe=et.length;ue<oe;ue++)if(Me=et[ue],M.format!==ki)if(ve!==null)if(H){if(pe)if(M.layerUpdates.size>0){const Oe=qp(Me.width,Me.height,M.format,M.type);for(const st of M.layerUpdates){const Dt=Me.data.subarray(st*Oe/Me.data.BYTES_PER_ELEMENT,(st+1)*Oe/Me.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ue,0,0,st,Me.width,Me.height,1,ve,Dt)}M.clearLayerUpdates()}else t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ue,0,0,0,Me.width,Me.height,le.depth,ve,Me.data)}else t.compressedTexImage3D(n.TEXTURE_2D_ARRAY,ue,ke,Me.width,Me.height,le.depth,0,Me.data,0,0);else console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else H?pe&&t.texSubImage3D(n.TEXTURE_2D_ARRAY,ue,0,0,0,Me.width,Me.height,le.depth,ve,Be,Me.data):t.texImage3D(n.TEXTURE_2D_ARRAY,ue,ke,Me.width,Me.height,le.depth,0,ve,Be,Me.data)}else{H&&fe&&t.texStorage2D(n.TEXTURE_2D,De,ke,et[0].width,et[0].height);for(let ue=0,oe=et.length;ue<oe;ue++)Me=et[ue],M.format!==ki?ve!==null?H?pe&&t.compressedTexSubImage2D(n.TEXTURE_2D,ue,0,0,Me.width,Me.height,ve,Me.data):t.compressedTexImage2D(n.TEXTURE_2D,ue,ke,Me.width,Me.height,0,Me.data):console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):H?pe&&t.texSubImage2D(n.TEXTURE_2D,ue,0,0,Me.width,Me.height,ve,Be,Me.data):t.texImage2D(n.TEXTURE_2D,ue,ke,Me.width,Me.height,0,ve,Be,Me.data)}else if(M.isDataArrayTexture)if(H){if(fe&&t.texStorage3D(n.TEXTURE_2D_ARRAY,De,ke,le.width,le.height,le.depth),pe)if(M.layerUpdates.size>0){const ue=qp(le.width,le.height,M.format,M.type);for(const oe of M.layerUpdates){const Oe=le.data.subarray(oe*ue/le.data.BYTES_PER_ELEMENT,(oe+1)*ue/le.data.BYTES_PER_ELEMENT);t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,oe,le.width,le.height,1,ve,Be,Oe)}M.clearLayerUpdates()}else t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,le.width,le.height,le.depth,ve,Be,le.data)}else t.texImage3D(n.TEXTURE_2D_ARRAY,0,ke,le.width,le.height,le.depth,0,ve,Be,le.data);else if(M.isData3DTexture)H?(fe&&t.texStorage3D(n.TEXTURE_3D,De,ke,le.width,le.height,le.depth),pe&&t.texSubImage3D(n.TEXTURE_3D,0,0,0,0,le.width,le.height,le.depth,ve,Be,le.data)):t.texImage3D(n.TEXTURE_3D,0,ke,le.width,le.height,le.depth,0,ve,Be,le.data);else if(M.isFramebufferTexture){if(fe)if(H)t.texStorage2D(n.TEXTURE_2D,De,ke,le.width,le.height);else{let ue=le.width,oe=le.height;for(let Oe=0;Oe<De;Oe++)t.texImage2D(n.TEXTURE_2D,Oe,ke,ue,oe,0,ve,Be,null),ue>>=1,oe>>=1}}else if(et.length>0){if(H&&fe){const ue=Et(et[0]);t.texStorage2D(n.TEXTURE_2D,De,ke,ue.width,ue.height)}for(let ue=0,oe=et.length;ue<oe;ue++)Me=et[ue],H?pe&&t.texSubImage2D(n.TEXTURE_2D,ue,0,0,ve,Be,Me):t.texImage2D(n.TEXTURE_2D,ue,ke,ve,Be,Me);M.generateMipmaps=!1}else if(H){if(fe){const ue=Et(le);t.texStorage2D(n.TEXTURE_2D,De,ke,ue.width,ue.height)}pe&&t.texSubImage2D(n.TEXTURE_2D,0,0,0,ve,Be,le)}else t.texImage2D(n.TEXTURE_2D,0,ke,ve,Be,le);m(M)&&p(J),Fe.__version=te.version,M.onUpdate&&M.onUpdate(M)}D.__version=M.version}function ne(D,M,O){if(M.image.length!==6)return;const J=ge(D,M),ie=M.source;t.bindTexture(n.TEXTURE_CUBE_MAP,D.__webglTexture,n.TEXTURE0+O);const te=i.get(ie);if(ie.version!==te.__version||J===!0){t.activeTexture(n.TEXTURE0+O);const Fe=Mt.getPrimaries(Mt.workingColorSpace),he=M.colorSpace===Bs?null:Mt.getPrimaries(M.colorSpace),Le=M.colorSpace===Bs||Fe===he?n.NONE:n.BROWSER_DEFAULT_WEBGL;n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,M.flipY),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,M.premultiplyAlpha),n.pixelStorei(n.UNPACK_ALIGNMENT,M.unpackAlignment),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,Le);const Re=M.isCompressedTexture||M.image[0].isCompressedTexture,le=M.image[0]&&M.image[0].isDataTexture,ve=[];for(let oe=0;oe<6;oe++)!Re&&!le?ve[oe]=x(M.image[oe],!0,s.maxCubemapSize):ve[oe]=le?M.image[oe].image:M.image[oe],ve[oe]=Gt(M,ve[oe]);const Be=ve[0],ke=r.convert(M.format,M.colorSpace),Me=r.convert(M.type),et=w(M.internalFormat,ke,Me,M.colorSpace),H=M.isVideoTexture!==!0,fe=te.__version===void 0||J===!0,pe=ie.dataReady;let De=L(M,Be);xe(n.TEXTURE_CUBE_MAP,M);let ue;if(Re){H&&fe&&t.texStorage2D(n.TEXTURE_CUBE_MAP,De,et,Be.width,Be.height);for(let oe=0;oe<6;oe++){ue=ve[oe].mipmaps;for(let Oe=0;Oe<ue.length;Oe++){const st=ue[Oe];M.format!==ki?ke!==null?H?pe&&t.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+oe,Oe,0,0,st.width,st.height,ke,st.data):t.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+oe,Oe,et,st.width,st.height,0,st.data):console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):H?pe&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+oe,Oe,0,0,st.width,st.height,ke,Me,st.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+oe,Oe,et,st.width,st.height,0,ke,Me,st.data)}}}else{if(ue=M.mipmaps,H&&fe){ue.length>0&&De++;const oe=Et(ve[0]);t.texStorage2D(n.TEXTURE_CUBE_MAP,De,et,oe.width,oe.height)}for(let oe=0;oe<6;oe++)if(le){H?pe&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+oe,0,0,0,ve[oe].width,ve[oe].height,ke,Me,ve[oe].data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+oe,0,et,ve[oe].width,ve[oe].height,0,ke,Me,ve[oe].data);for(let Oe=0;Oe<ue.length;Oe++){const Dt=ue[Oe].image[oe].image;H?pe&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+oe,Oe+1,0,0,Dt.width,Dt.height,ke,Me,Dt.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+oe,Oe+1,et,Dt.width,Dt.height,0,ke,Me,Dt.data)}}else{H?pe&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+oe,0,0,0,ke,Me,ve[oe]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+oe,0,et,ke,Me,ve[oe]);for(let Oe=0;Oe<ue.length;Oe++){const st=ue[Oe];H?pe&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+oe,Oe+1,0,0,ke,Me,st.image[oe]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+oe,Oe+1,et,ke,Me,st.image[oe])}}}m(M)&&p(n.TEXTURE_CUBE_MAP),te.__version=ie.version,M.onUpdate&&M.onUpdate(M)}D.__version=M.version}function we(D,M,O,J,ie,te){const Fe=r.convert(O.format,O.colorSpace),he=r.convert(O.type),Le=w(O.internalFormat,Fe,he,O.colorSpace),Re=i.get(M),le=i.get(O);if(le.__renderTarget=M,!Re.__hasExternalTextures){const ve=Math.max(1,M.width>>te),Be=Math.max(1,M.height>>te);ie===n.TEXTURE_3D||ie===n.TEXTURE_2D_ARRAY?t.texImage3D(ie,te,Le,ve,Be,M.depth,0,Fe,he,null):t.texImage2D(ie,te,Le,ve,Be,0,Fe,he,null)}t.bindFramebuffer(n.FRAMEBUFFER,D),Pe(M)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,J,ie,le.__webglTexture,0,Rt(M)):(ie===n.TEXTURE_2D||ie>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&ie<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,J,ie,le.__webglTexture,te),t.bindFramebuffer(n.FRAMEBUFFER,null)}function ze(D,M,O){if(n.bindRenderbuffer(n.RENDERBUFFER,D),M.depthBuffer){const J=M.depthTexture,ie=J&&J.isDepthTexture?J.type:null,te=y(M.stencilBuffer,ie),Fe=M.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,he=Rt(M);Pe(M)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,he,te,M.width,M.height):O?n.renderbufferStorageMultisample(n.RENDERBUFFER,he,te,M.width,M.height):n.renderbufferStorage(n.RENDERBUFFER,te,M.width,M.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,Fe,n.RENDERBUFFER,D)}else{const J=M.textures;for(let ie=0;ie<J.length;ie++){const te=J[ie],Fe=r.convert(te.format,te.colorSpace),he=r.convert(te.type),Le=w(te.internalFormat,Fe,he,te.colorSpace),Re=Rt(M);O&&Pe(M)===!1?n.renderbufferStorageMultisample(n.RENDERBUFFER,Re,Le,M.width,M.height):Pe(M)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,Re,Le,M.width,M.height):n.renderbufferStorage(n.RENDERBUFFER,Le,M.width,M.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function ye(D,M){if(M&&M.isWebGLCubeRenderTarget)throw new Error("Depth Texture with cube render targets is not supported");if(t.bindFramebuffer(n.FRAMEBUFFER,D),!(M.depthTexture&&M.depthTexture.isDepthTexture))throw new Error("renderTarget.depthTexture must be an instance of THREE.DepthTexture");const J=i.get(M.depthTexture);J.__renderTarget=M,(!J.__webglTexture||M.depthTexture.image.width!==M.width||M.depthTexture.image.height!==M.height)&&(M.depthTexture.image.width=M.width,M.depthTexture.image.height=M.height,M.depthTexture.needsUpdate=!0),W(M.depthTexture,0);const ie=J.__webglTexture,te=Rt(M);if(M.depthTexture.format===Ra)Pe(M)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,n.DEPTH_ATTACHMENT,n.TEXTURE_2D,ie,0,te):n.framebufferTexture2D(n.FRAMEBUFFER,n.DEPTH_ATTACHMENT,n.TEXTURE_2D,ie,0);else if(M.depthTexture.format===Ca)Pe(M)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,n.DEPTH_STENCIL_ATTACHMENT,n.TEXTURE_2D,ie,0,te):n.framebufferTexture2D(n.FRAMEBUFFER,n.DEPTH_STENCIL_ATTACHMENT,n.TEXTURE_2D,ie,0);else throw new Error("Unknown depthTexture format")}function it(D){const M=i.get(D),O=D.isWebGLCubeRenderTarget===!0;if(M.__boundDepthTexture!==D.depthTexture){const J=D.depthTexture;if(M.__depthDisposeCallback&&M.__depthDisposeCallback(),J){const ie=()=>{delete M.__boundDepthTexture,delete M.__depthDisposeCallback,J.removeEventListener("dispose",ie)};J.addEventListener("dispose",ie),M.__depthDisposeCallback=ie}M.__boundDepthTexture=J}if(D.depthTexture&&!M.__autoAllocateDepthBuffer){if(O)throw new Error("target.depthTexture not supported in Cube render targets");const J=D.texture.mipmaps;J&&J.length>0?ye(M.__webglFramebuffer[0],D):ye(M.__webglFramebuffer,D)}else if(O){M.__webglDepthbuffer=[];for(let J=0;J<6;J++)if(t.bindFramebuffer(n.FRAMEBUFFER,M.__webglFramebuffer[J]),M.__webglDepthbuffer[J]===void 0)M.__webglDepthbuffer[J]=n.createRenderbuffer(),ze(M.__webglDepthbuffer[J],D,!1);else{const ie=D.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,te=M.__webglDepthbuffer[J];n.bindRenderbuffer(n.RENDERBUFFER,te),n.framebufferRenderbuffer(n.FRAMEBUFFER,ie,n.RENDERBUFFER,te)}}else{const J=D.texture.mipmaps;if(J&&J.length>0?t.bindFramebuffer(n.FRAMEBUFFER,M.__webglFramebuffer[0]):t.bindFramebuffer(n.FRAMEBUFFER,M.__webglFramebuffer),M.__webglDepthbuffer===void 0)M.__webglDepthbuffer=n.createRenderbuffer(),ze(M.__webglDepthbuffer,D,!1);else{const ie=D.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,te=M.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,te),n.framebufferRenderbuffer(n.FRAMEBUFFER,ie,n.RENDERBUFFER,te)}}t.bindFramebuffer(n.FRAMEBUFFER,null)}function Bt(D,M,O){const J=i.get(D);M!==void 0&&we(J.__webglFramebuffer,D,D.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),O!==void 0&&it(D)}function F(D){const M=D.texture,O=i.get(D),J=i.get(M);D.addEventListener("dispose",U);const ie=D.textures,te=D.isWebGLCubeRenderTarget===!0,Fe=ie.length>1;if(Fe||(J.__webglTexture===void 0&&(J.__webglTexture=n.createTexture()),J.__version=M.version,o.memory.textures++),te){O.__webglFramebuffer=[];for(let he=0;he<6;he++)if(M.mipmaps&&M.mipmaps.length>0){O.__webglFramebuffer[he]=[];for(let Le=0;Le<M.mipmaps.length;Le++)O.__webglFramebuffer[he][Le]=n.createFramebuffer()}else O.__webglFramebuffer[he]=n.createFramebuffer()}else{if(M.mipmaps&&M.mipmaps.length>0){O.__webglFramebuffer=[];for(let he=0;he<M.mipmaps.length;he++)O.__webglFramebuffer[he]=n.createFramebuffer()}else O.__webglFramebuffer=n.createFramebuffer();if(Fe)for(let he=0,Le=ie.length;he<Le;he++){const Re=i.get(ie[he]);Re.__webglTexture===void 0&&(Re.__webglTexture=n.createTexture(),o.memory.textures++)}if(D.samples>0&&Pe(D)===!1){O.__webglMultisampledFramebuffer=n.createFramebuffer(),O.__webglColorRenderbuffer=[],t.bindFramebuffer(n.FRAMEBUFFER,O.__webglMultisampledFramebuffer);for(let he=0;he<ie.length;he++){const Le=ie[he];O.__webglColorRenderbuffer[he]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,O.__webglColorRenderbuffer[he]);const Re=r.convert(Le.format,Le.colorSpace),le=r.convert(Le.type),ve=w(Le.internalFormat,Re,le,Le.colorSpace,D.isXRRenderTarget===!0),Be=Rt(D);n.renderbufferStorageMultisample(n.RENDERBUFFER,Be,ve,D.width,D.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+he,n.RENDERBUFFER,O.__webglColorRenderbuffer[he])}n.bindRenderbuffer(n.RENDERBUFFER,null),D.depthBuffer&&(O.__webglDepthRenderbuffer=n.createRenderbuffer(),ze(O.__webglDepthRenderbuffer,D,!0)),t.bindFramebuffer(n.FRAMEBUFFER,null)}}if(te){t.bindTexture(n.TEXTURE_CUBE_MAP,J.__webglTexture),xe(n.TEXTURE_CUBE_MAP,M);for(let he=0;he<6;he++)if(M.mipmaps&&M.mipmaps.length>0)for(let Le=0;Le<M.mipmaps.length;Le++)we(O.__webglFramebuffer[he][Le],D,M,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+he,Le);else we(O.__webglFramebuffer[he],D,M,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+he,0);m(M)&&p(n.TEXTURE_CUBE_MAP),t.unbindTexture()}else if(Fe){for(let he=0,Le=ie.length;he<Le;he++){const Re=ie[he],le=i.get(Re);let ve=n.TEXTURE_2D;(D.isWebGL3DRenderTarget||D.isWebGLArrayRenderTarget)&&(ve=D.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(ve,le.__webglTexture),xe(ve,Re),we(O.__webglFramebuffer,D,Re,n.COLOR_ATTACHMENT0+he,ve,0),m(Re)&&p(ve)}t.unbindTexture()}else{let he=n.TEXTURE_2D;if((D.isWebGL3DRenderTarget||D.isWebGLArrayRenderTarget)&&(he=D.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(he,J.__webglTexture),xe(he,M),M.mipmaps&&M.mipmaps.length>0)for(let Le=0;Le<M.mipmaps.length;Le++)we(O.__webglFramebuffer[Le],D,M,n.COLOR_ATTACHMENT0,he,Le);else we(O.__webglFramebuffer,D,M,n.COLOR_ATTACHMENT0,he,0);m(M)&&p(he),t.unbindTexture()}D.depthBuffer&&it(D)}function mt(D){const M=D.textures;for(let O=0,J=M.length;O<J;O++){const ie=M[O];if(m(ie)){const te=S(D),Fe=i.get(ie).__webglTexture;t.bindTexture(te,Fe),p(te),t.unbindTexture()}}}const Ze=[],Ye=[];function Ne(D){if(D.samples>0){if(Pe(D)===!1){const M=D.textures,O=D.width,J=D.height;let ie=n.COLOR_BUFFER_BIT;const te=D.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,Fe=i.get(D),he=M.length>1;if(he)for(let Re=0;Re<M.length;Re++)t.bindFramebuffer(n.FRAMEBUFFER,Fe.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+Re,n.RENDERBUFFER,null),t.bindFramebuffer(n.FRAMEBUFFER,Fe.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+Re,n.TEXTURE_2D,null,0);t.bindFramebuffer(n.READ_FRAMEBUFFER,Fe.__webglMultisampledFramebuffer);const Le=D.texture.mipmaps;Le&&Le.length>0?t.bindFramebuffer(n.DRAW_FRAMEBUFFER,Fe.__webglFramebuffer[0]):t.bindFramebuffer(n.DRAW_FRAMEBUFFER,Fe.__webglFramebuffer);for(let Re=0;Re<M.length;Re++){if(D.resolveDepthBuffer&&(D.depthBuffer&&(ie|=n.DEPTH_BUFFER_BIT),D.stencilBuffer&&D.resolveStencilBuffer&&(ie|=n.STENCIL_BUFFER_BIT)),he){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,Fe.__webglColorRenderbuffer[Re]);const le=i.get(M[Re]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,le,0)}n.blitFramebuffer(0,0,O,J,0,0,O,J,ie,n.NEAREST),l===!0&&(Ze.length=0,Ye.length=0,Ze.push(n.COLOR_ATTACHMENT0+Re),D.depthBuffer&&D.resolveDepthBuffer===!1&&(Ze.push(te),Ye.push(te),n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,Ye)),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Ze))}if(t.bindFramebuffer(n.READ_FRAMEBUFFER,null),t.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),he)for(let Re=0;Re<M.length;Re++){t.bindFramebuffer(n.FRAMEBUFFER,Fe.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+Re,n.RENDERBUFFER,Fe.__webglColorRenderbuffer[Re]);const le=i.get(M[Re]).__webglTexture;t.bindFramebuffer(n.FRAMEBUFFER,Fe.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+Re,n.TEXTURE_2D,le,0)}t.bindFramebuffer(n.DRAW_FRAMEBUFFER,Fe.__webglMultisampledFramebuffer)}else if(D.depthBuffer&&D.resolveDepthBuffer===!1&&l){const M=D.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[M])}}}function Rt(D){return Math.min(s.maxSamples,D.samples)}function Pe(D){const M=i.get(D);return D.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&M.__useRenderToTexture!==!1}function We(D){const M=o.render.frame;u.get(D)!==M&&(u.set(D,M),D.update())}function Gt(D,M){const O=D.colorSpace,J=D.format,ie=D.type;return D.isCompressedTexture===!0||D.isVideoTexture===!0||O!==Ro&&O!==Bs&&(Mt.getTransfer(O)===It?(J!==ki||ie!==es)&&console.warn("THREE.WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):console.error("THREE.WebGLTextures: Unsupported texture color space:",O)),M}function Et(D){return typeof HTMLImageElement<"u"&&D instanceof HTMLImageElement?(c.width=D.naturalWidth||D.width,c.height=D.naturalHeight||D.height):typeof VideoFrame<"u"&&D instanceof VideoFrame?(c.width=D.displayWidth,c.height=D.displayHeight):(c.width=D.width,c.height=D.height),c}this.allocateTextureUnit=z,this.resetTextureUnits=B,this.setTexture2D=W,this.setTexture2DArray=q,this.setTexture3D=j,this.setTextureCube=Z,this.rebindTextures=Bt,this.setupRenderTarget=F,this.updateRenderTargetMipmap=mt,this.updateMultisampleRenderTarget=Ne,this.setupDepthRenderbuffer=it,this.setupFrameBufferTexture=we,this.useMultisampledRTT=Pe}function gT(n,e){function t(i,s=Bs){let r;const o=Mt.getTransfer(s);if(i===es)return n.UNSIGNED_BYTE;if(i===Mf)return n.UNSIGNED_SHORT_4_4_4_4;if(i===Sf)return n.UNSIGNED_SHORT_5_5_5_1;if(i===cg)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===ug)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===ag)return n.BYTE;if(i===lg)return n.SHORT;if(i===Ta)return n.UNSIGNED_SHORT;if(i===yf)return n.INT;if(i===Rr)return n.UNSIGNED_INT;if(i===Zi)return n.FLOAT;if(i===Ia)return n.HALF_FLOAT;if(i===hg)return n.ALPHA;if(i===fg)return n.RGB;if(i===ki)return n.RGBA;if(i===Ra)return n.DEPTH_COMPONENT;if(i===Ca)return n.DEPTH_STENCIL;if(i===Ef)return n.RED;if(i===bf)return n.RED_INTEGER;if(i===dg)return n.RG;if(i===wf)return n.RG_INTEGER;if(i===Tf)return n.RGBA_INTEGER;if(i===Ll||i===Il||i===Ul||i===Nl)if(o===It)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===Ll)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===Il)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===Ul)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===Nl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===Ll)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===Il)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===Ul)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===Nl)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===fh||i===dh||i===ph||i===mh)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===fh)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===dh)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===ph)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===mh)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===_h||i===gh||i===vh)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(i===_h||i===gh)return o===It?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===vh)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC}else return null;if(i===xh||i===yh||i===Mh||i===Sh||i===Eh||i===bh||i===wh||i===Th||i===Ah||i===Rh||i===Ch||i===Ph||i===Dh||i===Lh)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(i===xh)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===yh)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===Mh)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===Sh)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===Eh)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===bh)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===wh)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===Th)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===Ah)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===Rh)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===Ch)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===Ph)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===Dh)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===Lh)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===Ih||i===Uh||i===Nh)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(i===Ih)return o===It?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===Uh)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===Nh)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===Fh||i===Oh||i===kh||i===Bh)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(i===Fh)return r.COMPRESSED_RED_RGTC1_EXT;if(i===Oh)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===kh)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===Bh)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===Aa?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:t}}const vT=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,xT=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`;class yT{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){const i=new bg(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=i}}getMesh(e){if(this.texture!==null&&this.mesh===null){const t=e.cameras[0].viewport,i=new ts({vertexShader:vT,fragmentShader:xT,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new Ee(new _s(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}}class MT extends Dr{constructor(e,t){super();const i=this;let s=null,r=1,o=null,a="local-floor",l=1,c=null,u=null,h=null,f=null,d=null,_=null;const x=typeof XRWebGLBinding<"u",m=new yT,p={},S=t.getContextAttributes();let w=null,y=null;const L=[],R=[],U=new Ke;let N=null;const T=new Mi;T.viewport=new tn;const b=new Mi;b.viewport=new tn;const C=[T,b],B=new VM;let z=null,X=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(ee){let ne=L[ee];return ne===void 0&&(ne=new gu,L[ee]=ne),ne.getTargetRaySpace()},this.getControllerGrip=function(ee){let ne=L[ee];return ne===void 0&&(ne=new gu,L[ee]=ne),ne.getGripSpace()},this.getHand=function(ee){let ne=L[ee];return ne===void 0&&(ne=new gu,L[ee]=ne),ne.getHandSpace()};function W(ee){const ne=R.indexOf(ee.inputSource);if(ne===-1)return;const we=L[ne];we!==void 0&&(we.update(ee.inputSource,ee.frame,c||o),we.dispatchEvent({type:ee.type,data:ee.inputSource}))}function q(){s.removeEventListener("select",W),s.removeEventListener("selectstart",W),s.removeEventListener("selectend",W),s.removeEventListener("squeeze",W),s.removeEventListener("squeezestart",W),s.removeEventListener("squeezeend",W),s.removeEventListener("end",q),s.removeEventListener("inputsourceschange",j);for(let ee=0;ee<L.length;ee++){const ne=R[ee];ne!==null&&(R[ee]=null,L[ee].disconnect(ne))}z=null,X=null,m.reset();for(const ee in p)delete p[ee];e.setRenderTarget(w),d=null,f=null,h=null,s=null,y=null,nt.stop(),i.isPresenting=!1,e.setPixelRatio(N),e.setSize(U.width,U.height,!1),i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(ee){r=ee,i.isPresenting===!0&&console.warn("THREE.WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(ee){a=ee,i.isPresenting===!0&&console.warn("THREE.WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(ee){c=ee},this.getBaseLayer=function(){return f!==null?f:d},this.getBinding=function(){return h===null&&x&&(h=new XRWebGLBinding(s,t)),h},this.getFrame=function(){return _},this.getSession=function(){return s},this.setSession=async function(ee){if(s=ee,s!==null){if(w=e.getRenderTarget(),s.addEventListener("select",W),s.addEventListener("selectstart",W),s.addEventListener("selectend",W),s.addEventListener("squeeze",W),s.addEventListener("squeezestart",W),s.addEventListener("squeezeend",W),s.addEventListener("end",q),s.addEventListener("inputsourceschange",j),S.xrCompatible!==!0&&await t.makeXRCompatible(),N=e.getPixelRatio(),e.getSize(U),x&&"createProjectionLayer"in XRWebGLBinding.prototype){let we=null,ze=null,ye=null;S.depth&&(ye=S.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,we=S.stencil?Ca:Ra,ze=S.stencil?Aa:Rr);const it={colorFormat:t.RGBA8,depthFormat:ye,scaleFactor:r};h=this.getBinding(),f=h.createProjectionLayer(it),s.updateRenderState({layers:[f]}),e.setPixelRatio(1),e.setSize(f.textureWidth,f.textureHeight,!1),y=new Ys(f.textureWidth,f.textureHeight,{format:ki,type:es,depthTexture:new Eg(f.textureWidth,f.textureHeight,ze,void 0,void 0,void 0,void 0,void 0,void 0,we),stencilBuffer:S.stencil,colorSpace:e.outputColorSpace,samples:S.antialias?4:0,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1})}else{const we={antialias:S.antialias,alpha:!0,depth:S.depth,stencil:S.stencil,framebufferScaleFactor:r};d=new XRWebGLLayer(s,t,we),s.updateRenderState({baseLayer:d}),e.setPixelRatio(1),e.setSize(d.framebufferWidth,d.framebufferHeight,!1),y=new Ys(d.framebufferWidth,d.framebufferHeight,{format:ki,type:es,colorSpace:e.outputColorSpace,stencilBuffer:S.stencil,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1})}y.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),nt.setContext(s),nt.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return m.getDepthTexture()};function j(ee){for(let ne=0;ne<ee.removed.length;ne++){const we=ee.removed[ne],ze=R.indexOf(we);ze>=0&&(R[ze]=null,L[ze].disconnect(we))}for(let ne=0;ne<ee.added.length;ne++){const we=ee.added[ne];let ze=R.indexOf(we);if(ze===-1){for(let it=0;it<L.length;it++)if(it>=R.length){R.push(we),ze=it;break}else if(R[it]===null){R[it]=we,ze=it;break}if(ze===-1)break}const ye=L[ze];ye&&ye.connect(we)}}const Z=new k,re=new k;function ae(ee,ne,we){Z.setFromMatrixPosition(ne.matrixWorld),re.setFromMatrixPosition(we.matrixWorld);const ze=Z.distanceTo(re),ye=ne.projectionMatrix.elements,it=we.projectionMatrix.elements,Bt=ye[14]/(ye[10]-1),F=ye[14]/(ye[10]+1),mt=(ye[9]+1)/ye[5],Ze=(ye[9]-1)/ye[5],Ye=(ye[8]-1)/ye[0],Ne=(it[8]+1)/it[0],Rt=Bt*Ye,Pe=Bt*Ne,We=ze/(-Ye+Ne),Gt=We*-Ye;if(ne.matrixWorld.decompose(ee.position,ee.quaternion,ee.scale),ee.translateX(Gt),ee.translateZ(We),ee.matrixWorld.compose(ee.position,ee.quaternion,ee.scale),ee.matrixWorldInverse.copy(ee.matrixWorld).invert(),ye[10]===-1)ee.projectionMatrix.copy(ne.projectionMatrix),ee.projectionMatrixInverse.copy(ne.projectionMatrixInverse);else{const Et=Bt+We,D=F+We,M=Rt-Gt,O=Pe+(ze-Gt),J=mt*F/D*Et,ie=Ze*F/D*Et;ee.projectionMatrix.makePerspective(M,O,J,ie,Et,D),ee.projectionMatrixInverse.copy(ee.projectionMatrix).invert()}}function me(ee,ne){ne===null?ee.matrixWorld.copy(ee.matrix):ee.matrixWorld.multiplyMatrices(ne.matrixWorld,ee.matrix),ee.matrixWorldInverse.copy(ee.matrixWorld).invert()}this.updateCamera=function(ee){if(s===null)return;let ne=ee.near,we=ee.far;m.texture!==null&&(m.depthNear>0&&(ne=m.depthNear),m.depthFar>0&&(we=m.depthFar)),B.near=b.near=T.near=ne,B.far=b.far=T.far=we,(z!==B.near||X!==B.far)&&(s.updateRenderState({depthNear:B.near,depthFar:B.far}),z=B.near,X=B.far),B.layers.mask=ee.layers.mask|6,T.layers.mask=B.layers.mask&3,b.layers.mask=B.layers.mask&5;const ze=ee.parent,ye=B.cameras;me(B,ze);for(let it=0;it<ye.length;it++)me(ye[it],ze);ye.length===2?ae(B,T,b):B.projectionMatrix.copy(T.projectionMatrix),xe(ee,B,ze)};function xe(ee,ne,we){we===null?ee.matrix.copy(ne.matrixWorld):(ee.matrix.copy(we.matrixWorld),ee.matrix.invert(),ee.matrix.multiply(ne.matrixWorld)),ee.matrix.decompose(ee.position,ee.quaternion,ee.scale),ee.updateMatrixWorld(!0),ee.projectionMatrix.copy(ne.projectionMatrix),ee.projectionMatrixInverse.copy(ne.projectionMatrixInverse),ee.isPerspectiveCamera&&(ee.fov=zh*2*Math.atan(1/ee.projectionMatrix.elements[5]),ee.zoom=1)}this.getCamera=function(){return B},this.getFoveation=function(){if(!(f===null&&d===null))return l},this.setFoveation=function(ee){l=ee,f!==null&&(f.fixedFoveation=ee),d!==null&&d.fixedFoveation!==void 0&&(d.fixedFoveation=ee)},this.hasDepthSensing=function(){return m.texture!==null},this.getDepthSensingMesh=function(){return m.getMesh(B)},this.getCameraTexture=function(ee){return p[ee]};let ge=null;function tt(ee,ne){if(u=ne.getViewerPose(c||o),_=ne,u!==null){const we=u.views;d!==null&&(e.setRenderTargetFramebuffer(y,d.framebuffer),e.setRenderTarget(y));let ze=!1;we.length!==B.cameras.length&&(B.cameras.length=0,ze=!0);for(let F=0;F<we.length;F++){const mt=we[F];let Ze=null;if(d!==null)Ze=d.getViewport(mt);else{const Ne=h.getViewSubImage(f,mt);Ze=Ne.viewport,F===0&&(e.setRenderTargetTextures(y,Ne.colorTexture,Ne.depthStencilTexture),e.setRenderTarget(y))}let Ye=C[F];Ye===void 0&&(Ye=new Mi,Ye.layers.enable(F),Ye.viewport=new tn,C[F]=Ye),Ye.matrix.fromArray(mt.transform.matrix),Ye.matrix.decompose(Ye.position,Ye.quaternion,Ye.scale),Ye.projectionMatrix.fromArray(mt.projectionMatrix),Ye.projectionMatrixInverse.copy(Ye.projectionMatrix).invert(),Ye.viewport.set(Ze.x,Ze.y,Ze.width,Ze.height),F===0&&(B.matrix.copy(Ye.matrix),B.matrix.decompose(B.position,B.quaternion,B.scale)),ze===!0&&B.cameras.push(Ye)}const ye=s.enabledFeatures;if(ye&&ye.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&x){h=i.getBinding();const F=h.getDepthInformation(we[0]);F&&F.isValid&&F.texture&&m.init(F,s.renderState)}if(ye&&ye.includes("camera-access")&&x){e.state.unbindTexture(),h=i.getBinding();for(let F=0;F<we.length;F++){const mt=we[F].camera;if(mt){let Ze=p[mt];Ze||(Ze=new bg,p[mt]=Ze);const Ye=h.getCameraImage(mt);Ze.sourceTexture=Ye}}}}for(let we=0;we<L.length;we++){const ze=R[we],ye=L[we];ze!==null&&ye!==void 0&&ye.update(ze,ne,c||o)}ge&&ge(ee,ne),ne.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:ne}),_=null}const nt=new Cg;nt.setAnimationLoop(tt),this.setAnimationLoop=function(ee){ge=ee},this.dispose=function(){}}}const or=new wi,ST=new Pt;function ET(n,e){function t(m,p){m.matrixAutoUpdate===!0&&m.updateMatrix(),p.value.copy(m.matrix)}function i(m,p){p.color.getRGB(m.fogColor.value,yg(n)),p.isFog?(m.fogNear.value=p.near,m.fogFar.value=p.far):p.isFogExp2&&(m.fogDensity.value=p.density)}function s(m,p,S,w,y){p.isMeshBasicMaterial||p.isMeshLambertMaterial?r(m,p):p.isMeshToonMaterial?(r(m,p),h(m,p)):p.isMeshPhongMaterial?(r(m,p),u(m,p)):p.isMeshStandardMaterial?(r(m,p),f(m,p),p.isMeshPhysicalMaterial&&d(m,p,y)):p.isMeshMatcapMaterial?(r(m,p),_(m,p)):p.isMeshDepthMaterial?r(m,p):p.isMeshDistanceMaterial?(r(m,p),x(m,p)):p.isMeshNormalMaterial?r(m,p):p.isLineBasicMaterial?(o(m,p),p.isLineDashedMaterial&&a(m,p)):p.isPointsMaterial?l(m,p,S,w):p.isSpriteMaterial?c(m,p):p.isShadowMaterial?(m.color.value.copy(p.color),m.opacity.value=p.opacity):p.isShaderMaterial&&(p.uniformsNeedUpdate=!1)}function r(m,p){m.opacity.value=p.opacity,p.color&&m.diffuse.value.copy(p.color),p.emissive&&m.emissive.value.copy(p.emissive).multiplyScalar(p.emissiveIntensity),p.map&&(m.map.value=p.map,t(p.map,m.mapTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,t(p.alphaMap,m.alphaMapTransform)),p.bumpMap&&(m.bumpMap.value=p.bumpMap,t(p.bumpMap,m.bumpMapTransform),m.bumpScale.value=p.bumpScale,p.side===ei&&(m.bumpScale.value*=-1)),p.normalMap&&(m.normalMap.value=p.normalMap,t(p.normalMap,m.normalMapTransform),m.normalScale.value.copy(p.normalScale),p.side===ei&&m.normalScale.value.negate()),p.displacementMap&&(m.displacementMap.value=p.displacementMap,t(p.displacementMap,m.displacementMapTransform),m.displacementScale.value=p.displacementScale,m.displacementBias.value=p.displacementBias),p.emissiveMap&&(m.emissiveMap.value=p.emissiveMap,t(p.emissiveMap,m.emissiveMapTransform)),p.specularMap&&(m.specularMap.value=p.specularMap,t(p.specularMap,m.specularMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest);const S=e.get(p),w=S.envMap,y=S.envMapRotation;w&&(m.envMap.value=w,or.copy(y),or.x*=-1,or.y*=-1,or.z*=-1,w.isCubeTexture&&w.isRenderTargetTexture===!1&&(or.y*=-1,or.z*=-1),m.envMapRotation.value.setFromMatrix4(ST.makeRotationFromEuler(or)),m.flipEnvMap.value=w.isCubeTexture&&w.isRenderTargetTexture===!1?-1:1,m.reflectivity.value=p.reflectivity,m.ior.value=p.ior,m.refractionRatio.value=p.refractionRatio),p.lightMap&&(m.lightMap.value=p.lightMap,m.lightMapIntensity.value=p.lightMapIntensity,t(p.lightMap,m.lightMapTransform)),p.aoMap&&(m.aoMap.value=p.aoMap,m.aoMapIntensity.value=p.aoMapIntensity,t(p.aoMap,m.aoMapTransform))}function o(m,p){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,p.map&&(m.map.value=p.map,t(p.map,m.mapTransform))}function a(m,p){m.dashSize.value=p.dashSize,m.totalSize.value=p.dashSize+p.gapSize,m.scale.value=p.scale}function l(m,p,S,w){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,m.size.value=p.size*S,m.scale.value=w*.5,p.map&&(m.map.value=p.map,t(p.map,m.uvTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,t(p.alphaMap,m.alphaMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest)}function c(m,p){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,m.rotation.value=p.rotation,p.map&&(m.map.value=p.map,t(p.map,m.mapTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,t(p.alphaMap,m.alphaMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest)}function u(m,p){m.specular.value.copy(p.specular),m.shininess.value=Math.max(p.shininess,1e-4)}function h(m,p){p.gradientMap&&(m.gradientMap.value=p.gradientMap)}function f(m,p){m.metalness.value=p.metalness,p.metalnessMap&&(m.metalnessMap.value=p.metalnessMap,t(p.metalnessMap,m.metalnessMapTransform)),m.roughness.value=p.roughness,p.roughnessMap&&(m.roughnessMap.value=p.roughnessMap,t(p.roughnessMap,m.roughnessMapTransform)),p.envMap&&(m.envMapIntensity.value=p.envMapIntensity)}function d(m,p,S){m.ior.value=p.ior,p.sheen>0&&(m.sheenColor.value.copy(p.sheenColor).multiplyScalar(p.sheen),m.sheenRoughness.value=p.sheenRoughness,p.sheenColorMap&&(m.sheenColorMap.value=p.sheenColorMap,t(p.sheenColorMap,m.sheenColorMapTransform)),p.sheenRoughnessMap&&(m.sheenRoughnessMap.value=p.sheenRoughnessMap,t(p.sheenRoughnessMap,m.sheenRoughnessMapTransform))),p.clearcoat>0&&(m.clearcoat.value=p.clearcoat,m.clearcoatRoughness.value=p.clearcoatRoughness,p.clearcoatMap&&(m.clearcoatMap.value=p.clearcoatMap,t(p.clearcoatMap,m.clearcoatMapTransform)),p.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=p.clearcoatRoughnessMap,t(p.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),p.clearcoatNormalMap&&(m.clearcoatNormalMap.value=p.clearcoatNormalMap,t(p.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(p.clearcoatNormalScale),p.side===ei&&m.clearcoatNormalScale.value.negate())),p.dispersion>0&&(m.dispersion.value=p.dispersion),p.iridescence>0&&(m.iridescence.value=p.iridescence,m.iridescenceIOR.value=p.iridescenceIOR,m.iridescenceThicknessMinimum.value=p.iridescenceThicknessRange[0],m.iridescenceThicknessMaximum.value=p.iridescenceThicknessRange[1],p.iridescenceMap&&(m.iridescenceMap.value=p.iridescenceMap,t(p.iridescenceMap,m.iridescenceMapTransform)),p.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=p.iridescenceThicknessMap,t(p.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),p.transmission>0&&(m.transmission.value=p.transmission,m.transmissionSamplerMap.value=S.texture,m.transmissionSamplerSize.value.set(S.width,S.height),p.transmissionMap&&(m.transmissionMap.value=p.transmissionMap,t(p.transmissionMap,m.transmissionMapTransform)),m.thickness.value=p.thickness,p.thicknessMap&&(m.thicknessMap.value=p.thicknessMap,t(p.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=p.attenuationDistance,m.attenuationColor.value.copy(p.attenuationColor)),p.anisotropy>0&&(m.anisotropyVector.value.set(p.anisotropy*Math.cos(p.anisotropyRotation),p.anisotropy*Math.sin(p.anisotropyRotation)),p.anisotropyMap&&(m.anisotropyMap.value=p.anisotropyMap,t(p.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=p.specularIntensity,m.specularColor.value.copy(p.specularColor),p.specularColorMap&&(m.specularColorMap.value=p.specularColorMap,t(p.specularColorMap,m.specularColorMapTransform)),p.specularIntensityMap&&(m.specularIntensityMap.value=p.specularIntensityMap,t(p.specularIntensityMap,m.specularIntensityMapTransform))}function _(m,p){p.matcap&&(m.matcap.value=p.matcap)}function x(m,p){const S=e.get(p).light;m.referencePosition.value.setFromMatrixPosition(S.matrixWorld),m.nearDistance.value=S.shadow.camera.near,m.farDistance.value=S.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function bT(n,e,t,i){let s={},r={},o=[];const a=n.getParameter(n.MAX_UNIFORM_BUFFER_BINDINGS);function l(S,w){const y=w.program;i.uniformBlockBinding(S,y)}function c(S,w){let y=s[S.id];y===void 0&&(_(S),y=u(S),s[S.id]=y,S.addEventListener("dispose",m));const L=w.program;i.updateUBOMapping(S,L);const R=e.render.frame;r[S.id]!==R&&(f(S),r[S.id]=R)}function u(S){const w=h();S.__bindingPointIndex=w;const y=n.createBuffer(),L=S.__size,R=S.usage;return n.bindBuffer(n.UNIFORM_BUFFER,y),n.bufferData(n.UNIFORM_BUFFER,L,R),n.bindBuffer(n.UNIFORM_BUFFER,null),n.bindBufferBase(n.UNIFORM_BUFFER,w,y),y}function h(){for(let S=0;S<a;S++)if(o.indexOf(S)===-1)return o.push(S),S;return console.error("THREE.WebGLRenderer: Maximum number of simultaneously usable uniforms groups reached."),0}function f(S){const w=s[S.id],y=S.uniforms,L=S.__cache;n.bindBuffer(n.UNIFORM_BUFFER,w);for(let R=0,U=y.length;R<U;R++){const N=Array.isArray(y[R])?y[R]:[y[R]];for(let T=0,b=N.length;T<b;T++){const C=N[T];if(d(C,R,T,L)===!0){const B=C.__offset,z=Array.isArray(C.value)?C.value:[C.value];let X=0;for(let W=0;W<z.length;W++){const q=z[W],j=x(q);typeof q=="number"||typeof q=="boolean"?(C.__data[0]=q,n.bufferSubData(n.UNIFORM_BUFFER,B+X,C.__data)):q.isMatrix3?(C.__data[0]=q.elements[0],C.__data[1]=q.elements[1],C.__data[2]=q.elements[2],C.__data[3]=0,C.__data[4]=q.elements[3],C.__data[5]=q.elements[4],C.__data[6]=q.elements[5],C.__data[7]=0,C.__data[8]=q.elements[6],C.__data[9]=q.elements[7],C.__data[10]=q.elements[8],C.__data[11]=0):(q.toArray(C.__data,X),X+=j.storage/Float32Array.BYTES_PER_ELEMENT)}n.bufferSubData(n.UNIFORM_BUFFER,B,C.__data)}}}n.bindBuffer(n.UNIFORM_BUFFER,null)}function d(S,w,y,L){const R=S.value,U=w+"_"+y;if(L[U]===void 0)return typeof R=="number"||typeof R=="boolean"?L[U]=R:L[U]=R.clone(),!0;{const N=L[U];if(typeof R=="number"||typeof R=="boolean"){if(N!==R)return L[U]=R,!0}else if(N.equals(R)===!1)return N.copy(R),!0}return!1}function _(S){const w=S.uniforms;let y=0;const L=16;for(let U=0,N=w.length;U<N;U++){const T=Array.isArray(w[U])?w[U]:[w[U]];for(let b=0,C=T.length;b<C;b++){const B=T[b],z=Array.isArray(B.value)?B.value:[B.value];for(let X=0,W=z.length;X<W;X++){const q=z[X],j=x(q),Z=y%L,re=Z%j.boundary,ae=Z+re;y+=re,ae!==0&&L-ae<j.storage&&(y+=L-ae),B.__data=new Float32Array(j.storage/Float32Array.BYTES_PER_ELEMENT),B.__offset=y,y+=j.storage}}}const R=y%L;return R>0&&(y+=L-R),S.__size=y,S.__cache={},this}function x(S){const w={boundary:0,storage:0};return typeof S=="number"||typeof S=="boolean"?(w.boundary=4,w.storage=4):S.isVector2?(w.boundary=8,w.storage=8):S.isVector3||S.isColor?(w.boundary=16,w.storage=12):S.isVector4?(w.boundary=16,w.storage=16):S.isMatrix3?(w.boundary=48,w.storage=48):S.isMatrix4?(w.boundary=64,w.storage=64):S.isTexture?console.warn("THREE.WebGLRenderer: Texture samplers can not be part of an uniforms group."):console.warn("THREE.WebGLRenderer: Unsupported uniform value type.",S),w}function m(S){const w=S.target;w.removeEventListener("dispose",m);const y=o.indexOf(w.__bindingPointIndex);o.splice(y,1),n.deleteBuffer(s[w.id]),delete s[w.id],delete r[w.id]}function p(){for(const S in s)n.deleteBuffer(s[S]);o=[],s={},r={}}return{bind:l,update:c,dispose:p}}class wT{constructor(e={}){const{canvas:t=eM(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:h=!1,reversedDepthBuffer:f=!1}=e;this.isWebGLRenderer=!0;let d;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");d=i.getContextAttributes().alpha}else d=o;const _=new Uint32Array(4),x=new Int32Array(4);let m=null,p=null;const S=[],w=[];this.domElement=t,this.debug={checkShaderErrors:!0,onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=Vs,this.toneMappingExposure=1,this.transmissionResolutionScale=1;const y=this;let L=!1;this._outputColorSpace=yi;let R=0,U=0,N=null,T=-1,b=null;const C=new tn,B=new tn;let z=null;const X=new Qe(0);let W=0,q=t.width,j=t.height,Z=1,re=null,ae=null;const me=new tn(0,0,q,j),xe=new tn(0,0,q,j);let ge=!1;const tt=new Df;let nt=!1,ee=!1;const ne=new Pt,we=new k,ze=new tn,ye={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0};let it=!1;function Bt(){return N===null?Z:1}let F=i;function mt(A,G){return t.getContext(A,G)}try{const A={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:h};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${vf}`),t.addEventListener("webglcontextlost",pe,!1),t.addEventListener("webglcontextrestored",De,!1),t.addEventListener("webglcontextcreationerror",ue,!1),F===null){const G="webgl2";if(F=mt(G,A),F===null)throw mt(G)?new Error("Error creating WebGL context with your selected attributes."):new Error("Error creating WebGL context.")}}catch(A){throw console.error("THREE.WebGLRenderer: "+A.message),A}let Ze,Ye,Ne,Rt,Pe,We,Gt,Et,D,M,O,J,ie,te,Fe,he,Le,Re,le,ve,Be,ke,Me,et;function H(){Ze=new Nb(F),Ze.init(),ke=new gT(F,Ze),Ye=new Rb(F,Ze,e,ke),Ne=new mT(F,Ze),Ye.reversedDepthBuffer&&f&&Ne.buffers.depth.setReversed(!0),Rt=new kb(F),Pe=new nT,We=new _T(F,Ze,Ne,Pe,Ye,ke,Rt),Gt=new Pb(y),Et=new Ub(y),D=new WM(F),Me=new Tb(F,D),M=new Fb(F,D,Rt,Me),O=new zb(F,M,D,Rt),le=new Bb(F,Ye,We),he=new Cb(Pe),J=new tT(y,Gt,Et,Ze,Ye,Me,he),ie=new ET(y,Pe),te=new sT,Fe=new uT(Ze),Re=new wb(y,Gt,Et,Ne,O,d,l),Le=new dT(y,O,Ye),et=new bT(F,Rt,Ye,Ne),ve=new Ab(F,Ze,Rt),Be=new Ob(F,Ze,Rt),Rt.programs=J.programs,y.capabilities=Ye,y.extensions=Ze,y.properties=Pe,y.renderLists=te,y.shadowMap=Le,y.state=Ne,y.info=Rt}H();const fe=new MT(y,F);this.xr=fe,this.getContext=function(){return F},this.getContextAttributes=function(){return F.getContextAttributes()},this.forceContextLoss=function(){const A=Ze.get("WEBGL_lose_context");A&&A.loseContext()},this.forceContextRestore=function(){const A=Ze.get("WEBGL_lose_context");A&&A.restoreContext()},this.getPixelRatio=function(){return Z},this.setPixelRatio=function(A){A!==void 0&&(Z=A,this.setSize(q,j,!1))},this.getSize=function(A){return A.set(q,j)},this.setSize=function(A,G,Q=!0){if(fe.isPresenting){console.warn("THREE.WebGLRenderer: Can't change size while VR device is presenting.");return}q=A,j=G,t.width=Math.floor(A*Z),t.height=Math.floor(G*Z),Q===!0&&(t.style.width=A+"px",t.style.height=G+"px"),this.setViewport(0,0,A,G)},this.getDrawingBufferSize=function(A){return A.set(q*Z,j*Z).floor()},this.setDrawingBufferSize=function(A,G,Q){q=A,j=G,Z=Q,t.width=Math.floor(A*Q),t.height=Math.floor(G*Q),this.setViewport(0,0,A,G)},this.getCurrentViewport=function(A){return A.copy(C)},this.getViewport=function(A){return A.copy(me)},this.setViewport=function(A,G,Q,K){A.isVector4?me.set(A.x,A.y,A.z,A.w):me.set(A,G,Q,K),Ne.viewport(C.copy(me).multiplyScalar(Z).round())},this.getScissor=function(A){return A.copy(xe)},this.setScissor=function(A,G,Q,K){A.isVector4?xe.set(A.x,A.y,A.z,A.w):xe.set(A,G,Q,K),Ne.scissor(B.copy(xe).multiplyScalar(Z).round())},this.getScissorTest=function(){return ge},this.setScissorTest=function(A){Ne.setScissorTest(ge=A)},this.setOpaqueSort=function(A){re=A},this.setTransparentSort=function(A){ae=A},this.getClearColor=function(A){return A.copy(Re.getClearColor())},this.setClearColor=function(){Re.setClearColor(...arguments)},this.getClearAlpha=function(){return Re.getClearAlpha()},this.setClearAlpha=function(){Re.setClearAlpha(...arguments)},this.clear=function(A=!0,G=!0,Q=!0){let K=0;if(A){let Y=!1;if(N!==null){const de=N.texture.format;Y=de===Tf||de===wf||de===bf}if(Y){const de=N.texture.type,Se=de===es||de===Rr||de===Ta||de===Aa||de===Mf||de===Sf,Ie=Re.getClearColor(),Te=Re.getClearAlpha(),$e=Ie.r,je=Ie.g,He=Ie.b;Se?(_[0]=$e,_[1]=je,_[2]=He,_[3]=Te,F.clearBufferuiv(F.COLOR,0,_)):(x[0]=$e,x[1]=je,x[2]=He,x[3]=Te,F.clearBufferiv(F.COLOR,0,x))}else K|=F.COLOR_BUFFER_BIT}G&&(K|=F.DEPTH_BUFFER_BIT),Q&&(K|=F.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),F.clear(K)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.dispose=function(){t.removeEventListener("webglcontextlost",pe,!1),t.removeEventListener("webglcontextrestored",De,!1),t.removeEventListener("webglcontextcreationerror",ue,!1),Re.dispose(),te.dispose(),Fe.dispose(),Pe.dispose(),Gt.dispose(),Et.dispose(),O.dispose(),Me.dispose(),et.dispose(),J.dispose(),fe.dispose(),fe.removeEventListener("sessionstart",Nt),fe.removeEventListener("sessionend",ti),Kn.stop()};function pe(A){A.preventDefault(),console.log("THREE.WebGLRenderer: Context Lost."),L=!0}function De(){console.log("THREE.WebGLRenderer: Context Restored."),L=!1;const A=Rt.autoReset,G=Le.enabled,Q=Le.autoUpdate,K=Le.needsUpdate,Y=Le.type;H(),Rt.autoReset=A,Le.enabled=G,Le.autoUpdate=Q,Le.needsUpdate=K,Le.type=Y}function ue(A){console.error("THREE.WebGLRenderer: A WebGL context could not be created. Reason: ",A.statusMessage)}function oe(A){const G=A.target;G.removeEventListener("dispose",oe),Oe(G)}function Oe(A){st(A),Pe.remove(A)}function st(A){const G=Pe.get(A).programs;G!==void 0&&(G.forEach(function(Q){J.releaseProgram(Q)}),A.isShaderMaterial&&J.releaseShaderCache(A))}this.renderBufferDirect=function(A,G,Q,K,Y,de){G===null&&(G=ye);const Se=Y.isMesh&&Y.matrixWorld.determinant()<0,Ie=ss(A,G,Q,K,Y);Ne.setMaterial(K,Se);let Te=Q.index,$e=1;if(K.wireframe===!0){if(Te=M.getWireframeAttribute(Q),Te===void 0)return;$e=2}const je=Q.drawRange,He=Q.attributes.position;let ct=je.start*$e,vt=(je.start+je.count)*$e;de!==null&&(ct=Math.max(ct,de.start*$e),vt=Math.min(vt,(de.start+de.count)*$e)),Te!==null?(ct=Math.max(ct,0),vt=Math.min(vt,Te.count)):He!=null&&(ct=Math.max(ct,0),vt=Math.min(vt,He.count));const zt=vt-ct;if(zt<0||zt===1/0)return;Me.setup(Y,K,Ie,Q,Te);let Ct,at=ve;if(Te!==null&&(Ct=D.get(Te),at=Be,at.setIndex(Ct)),Y.isMesh)K.wireframe===!0?(Ne.setLineWidth(K.wireframeLinewidth*Bt()),at.setMode(F.LINES)):at.setMode(F.TRIANGLES);else if(Y.isLine){let qe=K.linewidth;qe===void 0&&(qe=1),Ne.setLineWidth(qe*Bt()),Y.isLineSegments?at.setMode(F.LINES):Y.isLineLoop?at.setMode(F.LINE_LOOP):at.setMode(F.LINE_STRIP)}else Y.isPoints?at.setMode(F.POINTS):Y.isSprite&&at.setMode(F.TRIANGLES);if(Y.isBatchedMesh)if(Y._multiDrawInstances!==null)Pa("THREE.WebGLRenderer: renderMultiDrawInstances has been deprecated and will be removed in r184. Append to renderMultiDraw arguments and use indirection."),at.renderMultiDrawInstances(Y._multiDrawStarts,Y._multiDrawCounts,Y._multiDrawCount,Y._multiDrawInstances);else if(Ze.get("WEBGL_multi_draw"))at.renderMultiDraw(Y._multiDrawStarts,Y._multiDrawCounts,Y._multiDrawCount);else{const qe=Y._multiDrawStarts,Ht=Y._multiDrawCounts,dt=Y._multiDrawCount,In=Te?D.get(Te).bytesPerElement:1,Ss=Pe.get(K).currentProgram.getUniforms();for(let zn=0;zn<dt;zn++)Ss.setValue(F,"_gl_DrawID",zn),at.render(qe[zn]/In,Ht[zn])}else if(Y.isInstancedMesh)at.renderInstances(ct,zt,Y.count);else if(Q.isInstancedBufferGeometry){const qe=Q._maxInstanceCount!==void 0?Q._maxInstanceCount:1/0,Ht=Math.min(Q.instanceCount,qe);at.renderInstances(ct,zt,Ht)}else at.render(ct,zt)};function Dt(A,G,Q){A.transparent===!0&&A.side===Fi&&A.forceSinglePass===!1?(A.side=ei,A.needsUpdate=!0,js(A,G,Q),A.side=ys,A.needsUpdate=!0,js(A,G,Q),A.side=Fi):js(A,G,Q)}this.compile=function(A,G,Q=null){Q===null&&(Q=A),p=Fe.get(Q),p.init(G),w.push(p),Q.traverseVisible(function(Y){Y.isLight&&Y.layers.test(G.layers)&&(p.pushLight(Y),Y.castShadow&&p.pushShadow(Y))}),A!==Q&&A.traverseVisible(function(Y){Y.isLight&&Y.layers.test(G.layers)&&(p.pushLight(Y),Y.castShadow&&p.pushShadow(Y))}),p.setupLights();const K=new Set;return A.traverse(function(Y){if(!(Y.isMesh||Y.isPoints||Y.isLine||Y.isSprite))return;const de=Y.material;if(de)if(Array.isArray(de))for(let Se=0;Se<de.length;Se++){const Ie=de[Se];Dt(Ie,Q,Y),K.add(Ie)}else Dt(de,Q,Y),K.add(de)}),p=w.pop(),K},this.compileAsync=function(A,G,Q=null){const K=this.compile(A,G,Q);return new Promise(Y=>{function de(){if(K.forEach(function(Se){Pe.get(Se).currentProgram.isReady()&&K.delete(Se)}),K.size===0){Y(A);return}setTimeout(de,10)}Ze.get("KHR_parallel_shader_compile")!==null?de():setTimeout(de,10)})};let gt=null;function Cn(A){gt&&gt(A)}function Nt(){Kn.stop()}function ti(){Kn.start()}const Kn=new Cg;Kn.setAnimationLoop(Cn),typeof self<"u"&&Kn.setContext(self),this.setAnimationLoop=function(A){gt=A,fe.setAnimationLoop(A),A===null?Kn.stop():Kn.start()},fe.addEventListener("sessionstart",Nt),fe.addEventListener("sessionend",ti),this.render=function(A,G){if(G!==void 0&&G.isCamera!==!0){console.error("THREE.WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(L===!0)return;if(A.matrixWorldAutoUpdate===!0&&A.updateMatrixWorld(),G.parent===null&&G.matrixWorldAutoUpdate===!0&&G.updateMatrixWorld(),fe.enabled===!0&&fe.isPresenting===!0&&(fe.cameraAutoUpdate===!0&&fe.updateCamera(G),G=fe.getCamera()),A.isScene===!0&&A.onBeforeRender(y,A,G,N),p=Fe.get(A,w.length),p.init(G),w.push(p),ne.multiplyMatrices(G.projectionMatrix,G.matrixWorldInverse),tt.setFromProjectionMatrix(ne,Ji,G.reversedDepth),ee=this.localClippingEnabled,nt=he.init(this.clippingPlanes,ee),m=te.get(A,S.length),m.init(),S.push(m),fe.enabled===!0&&fe.isPresenting===!0){const de=y.xr.getDepthSensingMesh();de!==null&&Bi(de,G,-1/0,y.sortObjects)}Bi(A,G,0,y.sortObjects),m.finish(),y.sortObjects===!0&&m.sort(re,ae),it=fe.enabled===!1||fe.isPresenting===!1||fe.hasDepthSensing()===!1,it&&Re.addToRenderList(m,A),this.info.render.frame++,nt===!0&&he.beginShadows();const Q=p.state.shadowsArray;Le.render(Q,A,G),nt===!0&&he.endShadows(),this.info.autoReset===!0&&this.info.reset();const K=m.opaque,Y=m.transmissive;if(p.setupLights(),G.isArrayCamera){const de=G.cameras;if(Y.length>0)for(let Se=0,Ie=de.length;Se<Ie;Se++){const Te=de[Se];is(K,Y,A,Te)}it&&Re.render(A);for(let Se=0,Ie=de.length;Se<Ie;Se++){const Te=de[Se];Bn(m,A,Te,Te.viewport)}}else Y.length>0&&is(K,Y,A,G),it&&Re.render(A),Bn(m,A,G);N!==null&&U===0&&(We.updateMultisampleRenderTarget(N),We.updateRenderTargetMipmap(N)),A.isScene===!0&&A.onAfterRender(y,A,G),Me.resetDefaultState(),T=-1,b=null,w.pop(),w.length>0?(p=w[w.length-1],nt===!0&&he.setGlobalState(y.clippingPlanes,p.state.camera)):p=null,S.pop(),S.length>0?m=S[S.length-1]:m=null};function Bi(A,G,Q,K){if(A.visible===!1)return;if(A.layers.test(G.layers)){if(A.isGroup)Q=A.renderOrder;else if(A.isLOD)A.autoUpdate===!0&&A.update(G);else if(A.isLight)p.pushLight(A),A.castShadow&&p.pushShadow(A);else if(A.isSprite){if(!A.frustumCulled||tt.intersectsSprite(A)){K&&ze.setFromMatrixPosition(A.matrixWorld).applyMatrix4(ne);const Se=O.update(A),Ie=A.material;Ie.visible&&m.push(A,Se,Ie,Q,ze.z,null)}}else if((A.isMesh||A.isLine||A.isPoints)&&(!A.frustumCulled||tt.intersectsObject(A))){const Se=O.update(A),Ie=A.material;if(K&&(A.boundingSphere!==void 0?(A.boundingSphere===null&&A.computeBoundingSphere(),ze.copy(A.boundingSphere.center)):(Se.boundingSphere===null&&Se.computeBoundingSphere(),ze.copy(Se.boundingSphere.center)),ze.applyMatrix4(A.matrixWorld).applyMatrix4(ne)),Array.isArray(Ie)){const Te=Se.groups;for(let $e=0,je=Te.length;$e<je;$e++){const He=Te[$e],ct=Ie[He.materialIndex];ct&&ct.visible&&m.push(A,Se,ct,Q,ze.z,He)}}else Ie.visible&&m.push(A,Se,Ie,Q,ze.z,null)}}const de=A.children;for(let Se=0,Ie=de.length;Se<Ie;Se++)Bi(de[Se],G,Q,K)}function Bn(A,G,Q,K){const Y=A.opaque,de=A.transmissive,Se=A.transparent;p.setupLightsView(Q),nt===!0&&he.setGlobalState(y.clippingPlanes,Q),K&&Ne.viewport(C.copy(K)),Y.length>0&&Ti(Y,G,Q),de.length>0&&Ti(de,G,Q),Se.length>0&&Ti(Se,G,Q),Ne.buffers.depth.setTest(!0),Ne.buffers.depth.setMask(!0),Ne.buffers.color.setMask(!0),Ne.setPolygonOffset(!1)}function is(A,G,Q,K){if((Q.isScene===!0?Q.overrideMaterial:null)!==null)return;p.state.transmissionRenderTarget[K.id]===void 0&&(p.state.transmissionRenderTarget[K.id]=new Ys(1,1,{generateMipmaps:!0,type:Ze.has("EXT_color_buffer_half_float")||Ze.has("EXT_color_buffer_float")?Ia:es,minFilter:yr,samples:4,stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,colorSpace:Mt.workingColorSpace}));const de=p.state.transmissionRenderTarget[K.id],Se=K.viewport||C;de.setSize(Se.z*y.transmissionResolutionScale,Se.w*y.transmissionResolutionScale);const Ie=y.getRenderTarget(),Te=y.getActiveCubeFace(),$e=y.getActiveMipmapLevel();y.setRenderTarget(de),y.getClearColor(X),W=y.getClearAlpha(),W<1&&y.setClearColor(16777215,.5),y.clear(),it&&Re.render(Q);const je=y.toneMapping;y.toneMapping=Vs;const He=K.viewport;if(K.viewport!==void 0&&(K.viewport=void 0),p.setupLightsView(K),nt===!0&&he.setGlobalState(y.clippingPlanes,K),Ti(A,Q,K),We.updateMultisampleRenderTarget(de),We.updateRenderTargetMipmap(de),Ze.has("WEBGL_multisampled_render_to_texture")===!1){let ct=!1;for(let vt=0,zt=G.length;vt<zt;vt++){const Ct=G[vt],at=Ct.object,qe=Ct.geometry,Ht=Ct.material,dt=Ct.group;if(Ht.side===Fi&&at.layers.test(K.layers)){const In=Ht.side;Ht.side=ei,Ht.needsUpdate=!0,Oo(at,Q,K,qe,Ht,dt),Ht.side=In,Ht.needsUpdate=!0,ct=!0}}ct===!0&&(We.updateMultisampleRenderTarget(de),We.updateRenderTargetMipmap(de))}y.setRenderTarget(Ie,Te,$e),y.setClearColor(X,W),He!==void 0&&(K.viewport=He),y.toneMapping=je}function Ti(A,G,Q){const K=G.isScene===!0?G.overrideMaterial:null;for(let Y=0,de=A.length;Y<de;Y++){const Se=A[Y],Ie=Se.object,Te=Se.geometry,$e=Se.group;let je=Se.material;je.allowOverride===!0&&K!==null&&(je=K),Ie.layers.test(Q.layers)&&Oo(Ie,G,Q,Te,je,$e)}}function Oo(A,G,Q,K,Y,de){A.onBeforeRender(y,G,Q,K,Y,de),A.modelViewMatrix.multiplyMatrices(Q.matrixWorldInverse,A.matrixWorld),A.normalMatrix.getNormalMatrix(A.modelViewMatrix),Y.onBeforeRender(y,G,Q,K,A,de),Y.transparent===!0&&Y.side===Fi&&Y.forceSinglePass===!1?(Y.side=ei,Y.needsUpdate=!0,y.renderBufferDirect(Q,G,K,Y,A,de),Y.side=ys,Y.needsUpdate=!0,y.renderBufferDirect(Q,G,K,Y,A,de),Y.side=Fi):y.renderBufferDirect(Q,G,K,Y,A,de),A.onAfterRender(y,G,Q,K,Y,de)}function js(A,G,Q){G.isScene!==!0&&(G=ye);const K=Pe.get(A),Y=p.state.lights,de=p.state.shadowsArray,Se=Y.state.version,Ie=J.getParameters(A,Y.state,de,G,Q),Te=J.getProgramCacheKey(Ie);let $e=K.programs;K.environment=A.isMeshStandardMaterial?G.environment:null,K.fog=G.fog,K.envMap=(A.isMeshStandardMaterial?Et:Gt).get(A.envMap||K.environment),K.envMapRotation=K.environment!==null&&A.envMap===null?G.environmentRotation:A.envMapRotation,$e===void 0&&(A.addEventListener("dispose",oe),$e=new Map,K.programs=$e);let je=$e.get(Te);if(je!==void 0){if(K.currentProgram===je&&K.lightsStateVersion===Se)return Oa(A,Ie),je}else Ie.uniforms=J.getUniforms(A),A.onBeforeCompile(Ie,y),je=J.acquireProgram(Ie,Te),$e.set(Te,je),K.uniforms=Ie.uniforms;const He=K.uniforms;return(!A.isShaderMaterial&&!A.isRawShaderMaterial||A.clipping===!0)&&(He.clippingPlanes=he.uniform),Oa(A,Ie),K.needsLights=Ks(A),K.lightsStateVersion=Se,K.needsLights&&(He.ambientLightColor.value=Y.state.ambient,He.lightProbe.value=Y.state.probe,He.directionalLights.value=Y.state.directional,He.directionalLightShadows.value=Y.state.directionalShadow,He.spotLights.value=Y.state.spot,He.spotLightShadows.value=Y.state.spotShadow,He.rectAreaLights.value=Y.state.rectArea,He.ltc_1.value=Y.state.rectAreaLTC1,He.ltc_2.value=Y.state.rectAreaLTC2,He.pointLights.value=Y.state.point,He.pointLightShadows.value=Y.state.pointShadow,He.hemisphereLights.value=Y.state.hemi,He.directionalShadowMap.value=Y.state.directionalShadowMap,He.directionalShadowMatrix.value=Y.state.directionalShadowMatrix,He.spotShadowMap.value=Y.state.spotShadowMap,He.spotLightMatrix.value=Y.state.spotLightMatrix,He.spotLightMap.value=Y.state.spotLightMap,He.pointShadowMap.value=Y.state.pointShadowMap,He.pointShadowMatrix.value=Y.state.pointShadowMatrix),K.currentProgram=je,K.uniformsList=null,je}function Fa(A){if(A.uniformsList===null){const G=A.currentProgram.getUniforms();A.uniformsList=Ol.seqWithValue(G.seq,A.uniforms)}return A.uniformsList}function Oa(A,G){const Q=Pe.get(A);Q.outputColorSpace=G.outputColorSpace,Q.batching=G.batching,Q.batchingColor=G.batchingColor,Q.instancing=G.instancing,Q.instancingColor=G.instancingColor,Q.instancingMorph=G.instancingMorph,Q.skinning=G.skinning,Q.morphTargets=G.morphTargets,Q.morphNormals=G.morphNormals,Q.morphColors=G.morphColors,Q.morphTargetsCount=G.morphTargetsCount,Q.numClippingPlanes=G.numClippingPlanes,Q.numIntersection=G.numClipIntersection,Q.vertexAlphas=G.vertexAlphas,Q.vertexTangents=G.vertexTangents,Q.toneMapping=G.toneMapping}function ss(A,G,Q,K,Y){G.isScene!==!0&&(G=ye),We.resetTextureUnits();const de=G.fog,Se=K.isMeshStandardMaterial?G.environment:null,Ie=N===null?y.outputColorSpace:N.isXRRenderTarget===!0?N.texture.colorSpace:Ro,Te=(K.isMeshStandardMaterial?Et:Gt).get(K.envMap||Se),$e=K.vertexColors===!0&&!!Q.attributes.color&&Q.attributes.color.itemSize===4,je=!!Q.attributes.tangent&&(!!K.normalMap||K.anisotropy>0),He=!!Q.morphAttributes.position,ct=!!Q.morphAttributes.normal,vt=!!Q.morphAttributes.color;let zt=Vs;K.toneMapped&&(N===null||N.isXRRenderTarget===!0)&&(zt=y.toneMapping);const Ct=Q.morphAttributes.position||Q.morphAttributes.normal||Q.morphAttributes.color,at=Ct!==void 0?Ct.length:0,qe=Pe.get(K),Ht=p.state.lights;if(nt===!0&&(ee===!0||A!==b)){const Mn=A===b&&K.id===T;he.setState(K,A,Mn)}let dt=!1;K.version===qe.__version?(qe.needsLights&&qe.lightsStateVersion!==Ht.state.version||qe.outputColorSpace!==Ie||Y.isBatchedMesh&&qe.batching===!1||!Y.isBatchedMesh&&qe.batching===!0||Y.isBatchedMesh&&qe.batchingColor===!0&&Y.colorTexture===null||Y.isBatchedMesh&&qe.batchingColor===!1&&Y.colorTexture!==null||Y.isInstancedMesh&&qe.instancing===!1||!Y.isInstancedMesh&&qe.instancing===!0||Y.isSkinnedMesh&&qe.skinning===!1||!Y.isSkinnedMesh&&qe.skinning===!0||Y.isInstancedMesh&&qe.instancingColor===!0&&Y.instanceColor===null||Y.isInstancedMesh&&qe.instancingColor===!1&&Y.instanceColor!==null||Y.isInstancedMesh&&qe.instancingMorph===!0&&Y.morphTexture===null||Y.isInstancedMesh&&qe.instancingMorph===!1&&Y.morphTexture!==null||qe.envMap!==Te||K.fog===!0&&qe.fog!==de||qe.numClippingPlanes!==void 0&&(qe.numClippingPlanes!==he.numPlanes||qe.numIntersection!==he.numIntersection)||qe.vertexAlphas!==$e||qe.vertexTangents!==je||qe.morphTargets!==He||qe.morphNormals!==ct||qe.morphColors!==vt||qe.toneMapping!==zt||qe.morphTargetsCount!==at)&&(dt=!0):(dt=!0,qe.__version=K.version);let In=qe.currentProgram;dt===!0&&(In=js(K,G,Y));let Ss=!1,zn=!1,Zs=!1;const Vt=In.getUniforms(),Hn=qe.uniforms;if(Ne.useProgram(In.program)&&(Ss=!0,zn=!0,Zs=!0),K.id!==T&&(T=K.id,zn=!0),Ss||b!==A){Ne.buffers.depth.getReversed()&&A.reversedDepth!==!0&&(A._reversedDepth=!0,A.updateProjectionMatrix()),Vt.setValue(F,"projectionMatrix",A.projectionMatrix),Vt.setValue(F,"viewMatrix",A.matrixWorldInverse);const Sn=Vt.map.cameraPosition;Sn!==void 0&&Sn.setValue(F,we.setFromMatrixPosition(A.matrixWorld)),Ye.logarithmicDepthBuffer&&Vt.setValue(F,"logDepthBufFC",2/(Math.log(A.far+1)/Math.LN2)),(K.isMeshPhongMaterial||K.isMeshToonMaterial||K.isMeshLambertMaterial||K.isMeshBasicMaterial||K.isMeshStandardMaterial||K.isShaderMaterial)&&Vt.setValue(F,"isOrthographic",A.isOrthographicCamera===!0),b!==A&&(b=A,zn=!0,Zs=!0)}if(Y.isSkinnedMesh){Vt.setOptional(F,Y,"bindMatrix"),Vt.setOptional(F,Y,"bindMatrixInverse");const Mn=Y.skeleton;Mn&&(Mn.boneTexture===null&&Mn.computeBoneTexture(),Vt.setValue(F,"boneTexture",Mn.boneTexture,We))}Y.isBatchedMesh&&(Vt.setOptional(F,Y,"batchingTexture"),Vt.setValue(F,"batchingTexture",Y._matricesTexture,We),Vt.setOptional(F,Y,"batchingIdTexture"),Vt.setValue(F,"batchingIdTexture",Y._indirectTexture,We),Vt.setOptional(F,Y,"batchingColorTexture"),Y._colorsTexture!==null&&Vt.setValue(F,"batchingColorTexture",Y._colorsTexture,We));const Zn=Q.morphAttributes;if((Zn.position!==void 0||Zn.normal!==void 0||Zn.color!==void 0)&&le.update(Y,Q,In),(zn||qe.receiveShadow!==Y.receiveShadow)&&(qe.receiveShadow=Y.receiveShadow,Vt.setValue(F,"receiveShadow",Y.receiveShadow)),K.isMeshGouraudMaterial&&K.envMap!==null&&(Hn.envMap.value=Te,Hn.flipEnvMap.value=Te.isCubeTexture&&Te.isRenderTargetTexture===!1?-1:1),K.isMeshStandardMaterial&&K.envMap===null&&G.environment!==null&&(Hn.envMapIntensity.value=G.environmentIntensity),zn&&(Vt.setValue(F,"toneMappingExposure",y.toneMappingExposure),qe.needsLights&&Ec(Hn,Zs),de&&K.fog===!0&&ie.refreshFogUniforms(Hn,de),ie.refreshMaterialUniforms(Hn,K,Z,j,p.state.transmissionRenderTarget[A.id]),Ol.upload(F,Fa(qe),Hn,We)),K.isShaderMaterial&&K.uniformsNeedUpdate===!0&&(Ol.upload(F,Fa(qe),Hn,We),K.uniformsNeedUpdate=!1),K.isSpriteMaterial&&Vt.setValue(F,"center",Y.center),Vt.setValue(F,"modelViewMatrix",Y.modelViewMatrix),Vt.setValue(F,"normalMatrix",Y.normalMatrix),Vt.setValue(F,"modelMatrix",Y.matrixWorld),K.isShaderMaterial||K.isRawShaderMaterial){const Mn=K.uniformsGroups;for(let Sn=0,Es=Mn.length;Sn<Es;Sn++){const fi=Mn[Sn];et.update(fi,In),et.bind(fi,In)}}return In}function Ec(A,G){A.ambientLightColor.needsUpdate=G,A.lightProbe.needsUpdate=G,A.directionalLights.needsUpdate=G,A.directionalLightShadows.needsUpdate=G,A.pointLights.needsUpdate=G,A.pointLightShadows.needsUpdate=G,A.spotLights.needsUpdate=G,A.spotLightShadows.needsUpdate=G,A.rectAreaLights.needsUpdate=G,A.hemisphereLights.needsUpdate=G}function Ks(A){return A.isMeshLambertMaterial||A.isMeshToonMaterial||A.isMeshPhongMaterial||A.isMeshStandardMaterial||A.isShadowMaterial||A.isShaderMaterial&&A.lights===!0}this.getActiveCubeFace=function(){return R},this.getActiveMipmapLevel=function(){return U},this.getRenderTarget=function(){return N},this.setRenderTargetTextures=function(A,G,Q){const K=Pe.get(A);K.__autoAllocateDepthBuffer=A.resolveDepthBuffer===!1,K.__autoAllocateDepthBuffer===!1&&(K.__useRenderToTexture=!1),Pe.get(A.texture).__webglTexture=G,Pe.get(A.depthTexture).__webglTexture=K.__autoAllocateDepthBuffer?void 0:Q,K.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(A,G){const Q=Pe.get(A);Q.__webglFramebuffer=G,Q.__useDefaultFramebuffer=G===void 0};const ka=F.createFramebuffer();this.setRenderTarget=function(A,G=0,Q=0){N=A,R=G,U=Q;let K=!0,Y=null,de=!1,Se=!1;if(A){const Te=Pe.get(A);if(Te.__useDefaultFramebuffer!==void 0)Ne.bindFramebuffer(F.FRAMEBUFFER,null),K=!1;else if(Te.__webglFramebuffer===void 0)We.setupRenderTarget(A);else if(Te.__hasExternalTextures)We.rebindTextures(A,Pe.get(A.texture).__webglTexture,Pe.get(A.depthTexture).__webglTexture);else if(A.depthBuffer){const He=A.depthTexture;if(Te.__boundDepthTexture!==He){if(He!==null&&Pe.has(He)&&(A.width!==He.image.width||A.height!==He.image.height))throw new Error("WebGLRenderTarget: Attached DepthTexture is initialized to the incorrect size.");We.setupDepthRenderbuffer(A)}}const $e=A.texture;($e.isData3DTexture||$e.isDataArrayTexture||$e.isCompressedArrayTexture)&&(Se=!0);const je=Pe.get(A).__webglFramebuffer;A.isWebGLCubeRenderTarget?(Array.isArray(je[G])?Y=je[G][Q]:Y=je[G],de=!0):A.samples>0&&We.useMultisampledRTT(A)===!1?Y=Pe.get(A).__webglMultisampledFramebuffer:Array.isArray(je)?Y=je[Q]:Y=je,C.copy(A.viewport),B.copy(A.scissor),z=A.scissorTest}else C.copy(me).multiplyScalar(Z).floor(),B.copy(xe).multiplyScalar(Z).floor(),z=ge;if(Q!==0&&(Y=ka),Ne.bindFramebuffer(F.FRAMEBUFFER,Y)&&K&&Ne.drawBuffers(A,Y),Ne.viewport(C),Ne.scissor(B),Ne.setScissorTest(z),de){const Te=Pe.get(A.texture);F.framebufferTexture2D(F.FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_CUBE_MAP_POSITIVE_X+G,Te.__webglTexture,Q)}else if(Se){const Te=G;for(let $e=0;$e<A.textures.length;$e++){const je=Pe.get(A.textures[$e]);F.framebufferTextureLayer(F.FRAMEBUFFER,F.COLOR_ATTACHMENT0+$e,je.__webglTexture,Q,Te)}}else if(A!==null&&Q!==0){const Te=Pe.get(A.texture);F.framebufferTexture2D(F.FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_2D,Te.__webglTexture,Q)}T=-1},this.readRenderTargetPixels=function(A,G,Q,K,Y,de,Se,Ie=0){if(!(A&&A.isWebGLRenderTarget)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Te=Pe.get(A).__webglFramebuffer;if(A.isWebGLCubeRenderTarget&&Se!==void 0&&(Te=Te[Se]),Te){Ne.bindFramebuffer(F.FRAMEBUFFER,Te);try{const $e=A.textures[Ie],je=$e.format,He=$e.type;if(!Ye.textureFormatReadable(je)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(!Ye.textureTypeReadable(He)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}G>=0&&G<=A.width-K&&Q>=0&&Q<=A.height-Y&&(A.textures.length>1&&F.readBuffer(F.COLOR_ATTACHMENT0+Ie),F.readPixels(G,Q,K,Y,ke.convert(je),ke.convert(He),de))}finally{const $e=N!==null?Pe.get(N).__webglFramebuffer:null;Ne.bindFramebuffer(F.FRAMEBUFFER,$e)}}},this.readRenderTargetPixelsAsync=async function(A,G,Q,K,Y,de,Se,Ie=0){if(!(A&&A.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Te=Pe.get(A).__webglFramebuffer;if(A.isWebGLCubeRenderTarget&&Se!==void 0&&(Te=Te[Se]),Te)if(G>=0&&G<=A.width-K&&Q>=0&&Q<=A.height-Y){Ne.bindFramebuffer(F.FRAMEBUFFER,Te);const $e=A.textures[Ie],je=$e.format,He=$e.type;if(!Ye.textureFormatReadable(je))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(!Ye.textureTypeReadable(He))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");const ct=F.createBuffer();F.bindBuffer(F.PIXEL_PACK_BUFFER,ct),F.bufferData(F.PIXEL_PACK_BUFFER,de.byteLength,F.STREAM_READ),A.textures.length>1&&F.readBuffer(F.COLOR_ATTACHMENT0+Ie),F.readPixels(G,Q,K,Y,ke.convert(je),ke.convert(He),0);const vt=N!==null?Pe.get(N).__webglFramebuffer:null;Ne.bindFramebuffer(F.FRAMEBUFFER,vt);const zt=F.fenceSync(F.SYNC_GPU_COMMANDS_COMPLETE,0);return F.flush(),await tM(F,zt,4),F.bindBuffer(F.PIXEL_PACK_BUFFER,ct),F.getBufferSubData(F.PIXEL_PACK_BUFFER,0,de),F.deleteBuffer(ct),F.deleteSync(zt),de}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(A,G=null,Q=0){const K=Math.pow(2,-Q),Y=Math.floor(A.image.width*K),de=Math.floor(A.image.height*K),Se=G!==null?G.x:0,Ie=G!==null?G.y:0;We.setTexture2D(A,0),F.copyTexSubImage2D(F.TEXTURE_2D,Q,0,0,Se,Ie,Y,de),Ne.unbindTexture()};const zi=F.createFramebuffer(),fn=F.createFramebuffer();this.copyTextureToTexture=function(A,G,Q=null,K=null,Y=0,de=null){de===null&&(Y!==0?(Pa("WebGLRenderer: copyTextureToTexture function signature has changed to support src and dst mipmap levels."),de=Y,Y=0):de=0);let Se,Ie,Te,$e,je,He,ct,vt,zt;const Ct=A.isCompressedTexture?A.mipmaps[de]:A.image;if(Q!==null)Se=Q.max.x-Q.min.x,Ie=Q.max.y-Q.min.y,Te=Q.isBox3?Q.max.z-Q.min.z:1,$e=Q.min.x,je=Q.min.y,He=Q.isBox3?Q.min.z:0;else{const Zn=Math.pow(2,-Y);Se=Math.floor(Ct.width*Zn),Ie=Math.floor(Ct.height*Zn),A.isDataArrayTexture?Te=Ct.depth:A.isData3DTexture?Te=Math.floor(Ct.depth*Zn):Te=1,$e=0,je=0,He=0}K!==null?(ct=K.x,vt=K.y,zt=K.z):(ct=0,vt=0,zt=0);const at=ke.convert(G.format),qe=ke.convert(G.type);let Ht;G.isData3DTexture?(We.setTexture3D(G,0),Ht=F.TEXTURE_3D):G.isDataArrayTexture||G.isCompressedArrayTexture?(We.setTexture2DArray(G,0),Ht=F.TEXTURE_2D_ARRAY):(We.setTexture2D(G,0),Ht=F.TEXTURE_2D),F.pixelStorei(F.UNPACK_FLIP_Y_WEBGL,G.flipY),F.pixelStorei(F.UNPACK_PREMULTIPLY_ALPHA_WEBGL,G.premultiplyAlpha),F.pixelStorei(F.UNPACK_ALIGNMENT,G.unpackAlignment);const dt=F.getParameter(F.UNPACK_ROW_LENGTH),In=F.getParameter(F.UNPACK_IMAGE_HEIGHT),Ss=F.getParameter(F.UNPACK_SKIP_PIXELS),zn=F.getParameter(F.UNPACK_SKIP_ROWS),Zs=F.getParameter(F.UNPACK_SKIP_IMAGES);F.pixelStorei(F.UNPACK_ROW_LENGTH,Ct.width),F.pixelStorei(F.UNPACK_IMAGE_HEIGHT,Ct.height),F.pixelStorei(F.UNPACK_SKIP_PIXELS,$e),F.pixelStorei(F.UNPACK_SKIP_ROWS,je),F.pixelStorei(F.UNPACK_SKIP_IMAGES,He);const Vt=A.isDataArrayTexture||A.isData3DTexture,Hn=G.isDataArrayTexture||G.isData3DTexture;if(A.isDepthTexture){const Zn=Pe.get(A),Mn=Pe.get(G),Sn=Pe.get(Zn.__renderTarget),Es=Pe.get(Mn.__renderTarget);Ne.bindFramebuffer(F.READ_FRAMEBUFFER,Sn.__webglFramebuffer),Ne.bindFramebuffer(F.DRAW_FRAMEBUFFER,Es.__webglFramebuffer);for(let fi=0;fi<Te;fi++)Vt&&(F.framebufferTextureLayer(F.READ_FRAMEBUFFER,F.COLOR_ATTACHMENT0,Pe.get(A).__webglTexture,Y,He+fi),F.framebufferTextureLayer(F.DRAW_FRAMEBUFFER,F.COLOR_ATTACHMENT0,Pe.get(G).__webglTexture,de,zt+fi)),F.blitFramebuffer($e,je,Se,Ie,ct,vt,Se,Ie,F.DEPTH_BUFFER_BIT,F.NEAREST);Ne.bindFramebuffer(F.READ_FRAMEBUFFER,null),Ne.bindFramebuffer(F.DRAW_FRAMEBUFFER,null)}else if(Y!==0||A.isRenderTargetTexture||Pe.has(A)){const Zn=Pe.get(A),Mn=Pe.get(G);Ne.bindFramebuffer(F.READ_FRAMEBUFFER,zi),Ne.bindFramebuffer(F.DRAW_FRAMEBUFFER,fn);for(let Sn=0;Sn<Te;Sn++)Vt?F.framebufferTextureLayer(F.READ_FRAMEBUFFER,F.COLOR_ATTACHMENT0,Zn.__webglTexture,Y,He+Sn):F.framebufferTexture2D(F.READ_FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_2D,Zn.__webglTexture,Y),Hn?F.framebufferTextureLayer(F.DRAW_FRAMEBUFFER,F.COLOR_ATTACHMENT0,Mn.__webglTexture,de,zt+Sn):F.framebufferTexture2D(F.DRAW_FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_2D,Mn.__webglTexture,de),Y!==0?F.blitFramebuffer($e,je,Se,Ie,ct,vt,Se,Ie,F.COLOR_BUFFER_BIT,F.NEAREST):Hn?F.copyTexSubImage3D(Ht,de,ct,vt,zt+Sn,$e,je,Se,Ie):F.copyTexSubImage2D(Ht,de,ct,vt,$e,je,Se,Ie);Ne.bindFramebuffer(F.READ_FRAMEBUFFER,null),Ne.bindFramebuffer(F.DRAW_FRAMEBUFFER,null)}else Hn?A.isDataTexture||A.isData3DTexture?F.texSubImage3D(Ht,de,ct,vt,zt,Se,Ie,Te,at,qe,Ct.data):G.isCompressedArrayTexture?F.compressedTexSubImage3D(Ht,de,ct,vt,zt,Se,Ie,Te,at,Ct.data):F.texSubImage3D(Ht,de,ct,vt,zt,Se,Ie,Te,at,qe,Ct):A.isDataTexture?F.texSubImage2D(F.TEXTURE_2D,de,ct,vt,Se,Ie,at,qe,Ct.data):A.isCompressedTexture?F.compressedTexSubImage2D(F.TEXTURE_2D,de,ct,vt,Ct.width,Ct.height,at,Ct.data):F.texSubImage2D(F.TEXTURE_2D,de,ct,vt,Se,Ie,at,qe,Ct);F.pixelStorei(F.UNPACK_ROW_LENGTH,dt),F.pixelStorei(F.UNPACK_IMAGE_HEIGHT,In),F.pixelStorei(F.UNPACK_SKIP_PIXELS,Ss),F.pixelStorei(F.UNPACK_SKIP_ROWS,zn),F.pixelStorei(F.UNPACK_SKIP_IMAGES,Zs),de===0&&G.generateMipmaps&&F.generateMipmap(Ht),Ne.unbindTexture()},this.initRenderTarget=function(A){Pe.get(A).__webglFramebuffer===void 0&&We.setupRenderTarget(A)},this.initTexture=function(A){A.isCubeTexture?We.setTextureCube(A,0):A.isData3DTexture?We.setTexture3D(A,0):A.isDataArrayTexture||A.isCompressedArrayTexture?We.setTexture2DArray(A,0):We.setTexture2D(A,0),Ne.unbindTexture()},this.resetState=function(){R=0,U=0,N=null,Ne.reset(),Me.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Ji}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;const t=this.getContext();t.drawingBufferColorSpace=Mt._getDrawingBufferColorSpace(e),t.unpackColorSpace=Mt._getUnpackColorSpace()}}const vm={type:"change"},Ff={type:"start"},Ug={type:"end"},yl=new Mc,xm=new ks,TT=Math.cos(70*Qy.DEG2RAD),dn=new k,Qn=2*Math.PI,Ut={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},Au=1e-6;class AT extends Rg{constructor(e,t=null){super(e,t),this.state=Ut.NONE,this.target=new k,this.cursor=new k,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:fo.ROTATE,MIDDLE:fo.DOLLY,RIGHT:fo.PAN},this.touches={ONE:oo.ROTATE,TWO:oo.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._domElementKeyEvents=null,this._lastPosition=new k,this._lastQuaternion=new _n,this._lastTargetPosition=new k,this._quat=new _n().setFromUnitVectors(e.up,new k(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new Yp,this._sphericalDelta=new Yp,this._scale=1,this._panOffset=new k,this._rotateStart=new Ke,this._rotateEnd=new Ke,this._rotateDelta=new Ke,this._panStart=new Ke,this._panEnd=new Ke,this._panDelta=new Ke,this._dollyStart=new Ke,this._dollyEnd=new Ke,this._dollyDelta=new Ke,this._dollyDirection=new k,this._mouse=new Ke,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=CT.bind(this),this._onPointerDown=RT.bind(this),this._onPointerUp=PT.bind(this),this._onContextMenu=OT.bind(this),this._onMouseWheel=IT.bind(this),this._onKeyDown=UT.bind(this),this._onTouchStart=NT.bind(this),this._onTouchMove=FT.bind(this),this._onMouseDown=DT.bind(this),this._onMouseMove=LT.bind(this),this._interceptControlDown=kT.bind(this),this._interceptControlUp=BT.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}connect(e){super.connect(e),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.getRootNode().addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.removeEventListener("pointermove",this._onPointerMove),this.domElement.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.getRootNode().removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.style.touchAction="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(e){e.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=e}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(vm),this.update(),this.state=Ut.NONE}update(e=null){const t=this.object.position;dn.copy(t).sub(this.target),dn.applyQuaternion(this._quat),this._spherical.setFromVector3(dn),this.autoRotate&&this.state===Ut.NONE&&this._rotateLeft(this._getAutoRotationAngle(e)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let i=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(i)&&isFinite(s)&&(i<-Math.PI?i+=Qn:i>Math.PI&&(i-=Qn),s<-Math.PI?s+=Qn:s>Math.PI&&(s-=Qn),i<=s?this._spherical.theta=Math.max(i,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(i+s)/2?Math.max(i,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{const o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(dn.setFromSpherical(this._spherical),dn.applyQuaternion(this._quatInverse),t.copy(this.target).add(dn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){const a=dn.length();o=this._clampDistance(a*this._scale);const l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){const a=new k(this._mouse.x,this._mouse.y,0);a.unproject(this.object);const l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;const c=new k(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=dn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(yl.origin.copy(this.object.position),yl.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(yl.direction))<TT?this.object.lookAt(this.target):(xm.setFromNormalAndCoplanarPoint(this.object.up,this.target),yl.intersectPlane(xm,this.target))))}else if(this.object.isOrthographicCamera){const o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>Au||8*(1-this._lastQuaternion.dot(this.object.quaternion))>Au||this._lastTargetPosition.distanceToSquared(this.target)>Au?(this.dispatchEvent(vm),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(e){return e!==null?Qn/60*this.autoRotateSpeed*e:Qn/60/60*this.autoRotateSpeed}_getZoomScale(e){const t=Math.abs(e*.01);return Math.pow(.95,this.zoomSpeed*t)}_rotateLeft(e){this._sphericalDelta.theta-=e}_rotateUp(e){this._sphericalDelta.phi-=e}_panLeft(e,t){dn.setFromMatrixColumn(t,0),dn.multiplyScalar(-e),this._panOffset.add(dn)}_panUp(e,t){this.screenSpacePanning===!0?dn.setFromMatrixColumn(t,1):(dn.setFromMatrixColumn(t,0),dn.crossVectors(this.object.up,dn)),dn.multiplyScalar(e),this._panOffset.add(dn)}_pan(e,t){const i=this.domElement;if(this.object.isPerspectiveCamera){const s=this.object.position;dn.copy(s).sub(this.target);let r=dn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*e*r/i.clientHeight,this.object.matrix),this._panUp(2*t*r/i.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(e*(this.object.right-this.object.left)/this.object.zoom/i.clientWidth,this.object.matrix),this._panUp(t*(this.object.top-this.object.bottom)/this.object.zoom/i.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(e,t){if(!this.zoomToCursor)return;this._performCursorZoom=!0;const i=this.domElement.getBoundingClientRect(),s=e-i.left,r=t-i.top,o=i.width,a=i.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(e){return Math.max(this.minDistance,Math.min(this.maxDistance,e))}_handleMouseDownRotate(e){this._rotateStart.set(e.clientX,e.clientY)}_handleMouseDownDolly(e){this._updateZoomParameters(e.clientX,e.clientX),this._dollyStart.set(e.clientX,e.clientY)}_handleMouseDownPan(e){this._panStart.set(e.clientX,e.clientY)}_handleMouseMoveRotate(e){this._rotateEnd.set(e.clientX,e.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);const t=this.domElement;this._rotateLeft(Qn*this._rotateDelta.x/t.clientHeight),this._rotateUp(Qn*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(e){this._dollyEnd.set(e.clientX,e.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.update()}_handleMouseMovePan(e){this._panEnd.set(e.clientX,e.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(e){this._updateZoomParameters(e.clientX,e.clientY),e.deltaY<0?this._dollyIn(this._getZoomScale(e.deltaY)):e.deltaY>0&&this._dollyOut(this._getZoomScale(e.deltaY)),this.update()}_handleKeyDown(e){let t=!1;switch(e.code){case this.keys.UP:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(Qn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),t=!0;break;case this.keys.BOTTOM:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(-Qn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),t=!0;break;case this.keys.LEFT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(Qn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),t=!0;break;case this.keys.RIGHT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(-Qn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),t=!0;break}t&&(e.preventDefault(),this.update())}_handleTouchStartRotate(e){if(this._pointers.length===1)this._rotateStart.set(e.pageX,e.pageY);else{const t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._rotateStart.set(i,s)}}_handleTouchStartPan(e){if(this._pointers.length===1)this._panStart.set(e.pageX,e.pageY);else{const t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panStart.set(i,s)}}_handleTouchStartDolly(e){const t=this._getSecondPointerPosition(e),i=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(i*i+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enablePan&&this._handleTouchStartPan(e)}_handleTouchStartDollyRotate(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enableRotate&&this._handleTouchStartRotate(e)}_handleTouchMoveRotate(e){if(this._pointers.length==1)this._rotateEnd.set(e.pageX,e.pageY);else{const i=this._getSecondPointerPosition(e),s=.5*(e.pageX+i.x),r=.5*(e.pageY+i.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);const t=this.domElement;this._rotateLeft(Qn*this._rotateDelta.x/t.clientHeight),this._rotateUp(Qn*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(e){if(this._pointers.length===1)this._panEnd.set(e.pageX,e.pageY);else{const t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panEnd.set(i,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(e){const t=this._getSecondPointerPosition(e),i=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(i*i+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);const o=(e.pageX+t.x)*.5,a=(e.pageY+t.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enablePan&&this._handleTouchMovePan(e)}_handleTouchMoveDollyRotate(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enableRotate&&this._handleTouchMoveRotate(e)}_addPointer(e){this._pointers.push(e.pointerId)}_removePointer(e){delete this._pointerPositions[e.pointerId];for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId){this._pointers.splice(t,1);return}}_isTrackingPointer(e){for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId)return!0;return!1}_trackPointer(e){let t=this._pointerPositions[e.pointerId];t===void 0&&(t=new Ke,this._pointerPositions[e.pointerId]=t),t.set(e.pageX,e.pageY)}_getSecondPointerPosition(e){const t=e.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[t]}_customWheelEvent(e){const t=e.deltaMode,i={clientX:e.clientX,clientY:e.clientY,deltaY:e.deltaY};switch(t){case 1:i.deltaY*=16;break;case 2:i.deltaY*=100;break}return e.ctrlKey&&!this._controlActive&&(i.deltaY*=10),i}}function RT(n){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(n.pointerId),this.domElement.addEventListener("pointermove",this._onPointerMove),this.domElement.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(n)&&(this._addPointer(n),n.pointerType==="touch"?this._onTouchStart(n):this._onMouseDown(n)))}function CT(n){this.enabled!==!1&&(n.pointerType==="touch"?this._onTouchMove(n):this._onMouseMove(n))}function PT(n){switch(this._removePointer(n),this._pointers.length){case 0:this.domElement.releasePointerCapture(n.pointerId),this.domElement.removeEventListener("pointermove",this._onPointerMove),this.domElement.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(Ug),this.state=Ut.NONE;break;case 1:const e=this._pointers[0],t=this._pointerPositions[e];this._onTouchStart({pointerId:e,pageX:t.x,pageY:t.y});break}}function DT(n){let e;switch(n.button){case 0:e=this.mouseButtons.LEFT;break;case 1:e=this.mouseButtons.MIDDLE;break;case 2:e=this.mouseButtons.RIGHT;break;default:e=-1}switch(e){case fo.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(n),this.state=Ut.DOLLY;break;case fo.ROTATE:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Ut.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Ut.ROTATE}break;case fo.PAN:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Ut.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Ut.PAN}break;default:this.state=Ut.NONE}this.state!==Ut.NONE&&this.dispatchEvent(Ff)}function LT(n){switch(this.state){case Ut.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(n);break;case Ut.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(n);break;case Ut.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(n);break}}function IT(n){this.enabled===!1||this.enableZoom===!1||this.state!==Ut.NONE||(n.preventDefault(),this.dispatchEvent(Ff),this._handleMouseWheel(this._customWheelEvent(n)),this.dispatchEvent(Ug))}function UT(n){this.enabled!==!1&&this._handleKeyDown(n)}function NT(n){switch(this._trackPointer(n),this._pointers.length){case 1:switch(this.touches.ONE){case oo.ROTATE:if(this.enableRotate===!1)return;this._handleTouchStartRotate(n),this.state=Ut.TOUCH_ROTATE;break;case oo.PAN:if(this.enablePan===!1)return;this._handleTouchStartPan(n),this.state=Ut.TOUCH_PAN;break;default:this.state=Ut.NONE}break;case 2:switch(this.touches.TWO){case oo.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(n),this.state=Ut.TOUCH_DOLLY_PAN;break;case oo.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(n),this.state=Ut.TOUCH_DOLLY_ROTATE;break;default:this.state=Ut.NONE}break;default:this.state=Ut.NONE}this.state!==Ut.NONE&&this.dispatchEvent(Ff)}function FT(n){switch(this._trackPointer(n),this.state){case Ut.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(n),this.update();break;case Ut.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(n),this.update();break;case Ut.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(n),this.update();break;case Ut.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(n),this.update();break;default:this.state=Ut.NONE}}function OT(n){this.enabled!==!1&&n.preventDefault()}function kT(n){n.key==="Control"&&(this._controlActive=!0,this.domElement.getRootNode().addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function BT(n){n.key==="Control"&&(this._controlActive=!1,this.domElement.getRootNode().removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}async function zT(n){const e=P0(n);if(e)return e;const t=await fetch(`/mesh/${n}`);return t.ok?t.arrayBuffer():null}const ym=new Qe(8141549),HT=new Qe(0);class VT{constructor(e){this.invalidate=e}invalidate;object=new Qi;links=[];parts=[];axes=[];collision=[];cache=new Map;matrices=null;generation=0;async load(e){const t=++this.generation,i=new Map,s=new Set(e.links.flatMap(r=>r.parts.map(o=>o.mesh)));await Promise.all([...s].map(async r=>i.set(r,await this.geometry(r)))),t===this.generation&&(this.object.clear(),this.links=[],this.parts=[],this.axes=[],this.collision=[],e.links.forEach((r,o)=>{const a=new Qi;a.name=r.name,a.matrixAutoUpdate=!1;for(const c of r.parts){const u=i.get(c.mesh);if(!u)continue;const[h,f,d,_]=c.color,x=new NM({color:new Qe().setRGB(h,f,d,"srgb"),roughness:.46,metalness:.08,side:ys,opacity:_,transparent:_<1,wireframe:c.collision}),m=new Ee(u,x);m.castShadow=m.receiveShadow=!c.collision,m.visible=!c.collision,Of(m,c.placed),c.collision?this.collision.push(m):this.parts.push({geometry:u,placed:m.matrix.clone(),link:o}),a.add(m)}const l=new Ag(.11*e.reach);l.visible=!1,this.axes.push(l),a.add(l),this.links.push(a),this.object.add(a)}),this.matrices&&this.move(this.matrices),this.invalidate())}geometry(e){let t=this.cache.get(e);return t||(t=zT(e).then(i=>{const s=new on,r=i?I0(i):null;return r&&(s.setAttribute("position",new Dn(r.positions,3)),s.setAttribute("normal",new Dn(r.normals,3)),s.setIndex(new Dn(r.indices,1))),s}),this.cache.set(e,t)),t}move(e){this.matrices=e,!(e.length<16*this.links.length)&&this.links.forEach((t,i)=>{t.matrix.fromArray(e,16*i),t.matrixWorldNeedsUpdate=!0})}highlight(e){this.links.forEach((t,i)=>{for(const s of t.children)if(s instanceof Ee){const r=s.material,o=s.userData.color??=r.color.clone();r.color.copy(o).lerp(ym,i===e?.5:0),r.emissive=i===e?ym:HT,r.emissiveIntensity=i===e?.35:0}}),this.invalidate()}get framesShown(){return this.axes.some(e=>e.visible)}showFrames(e){for(const t of this.axes)t.visible=e;this.invalidate()}showCollision(e){for(const t of this.collision)t.visible=e;this.invalidate()}}const Ru=16,GT={color:new Qe(15227148),opacity:.55},WT=new Qe(8141549);class Mm{constructor(e=null){this.look=e}look;object=new Qi;meshes=[];plainColor=new Qe(7042182);frame=null;hidden=[];pointed=null;load(e){this.object.clear(),this.meshes.forEach(({mesh:t})=>t.dispose()),this.meshes=e.parts.map(t=>{const i=new FM({transparent:!0,opacity:this.opacity,depthWrite:!1,polygonOffset:!0,polygonOffsetFactor:3,polygonOffsetUnits:12}),s=new RM(t.geometry,i,Ru);return s.frustumCulled=!1,s.count=0,s.renderOrder=2,this.object.add(s),{mesh:s,part:t}}),this.frame&&this.move(this.frame,this.hidden)}setDark(e){this.plainColor=this.look?.color??new Qe(e?11187141:5989496),this.paint()}move(e,t){this.frame=e,this.hidden=t;const i=[];for(let r=0;r<Math.min(e.count,Ru);r++)t[r]||i.push(r);const s=new Pt;for(const{mesh:r,part:o}of this.meshes){r.count=0;for(const a of i){const l=16*(a*e.links+o.link);l+16>e.matrices.length||r.setMatrixAt(r.count++,s.fromArray(e.matrices,l).multiply(o.placed))}r.instanceMatrix.needsUpdate=!0}this.paint()}point(e){this.pointed=e,this.paint()}get opacity(){return this.look?.opacity??.17}paint(){if(!this.frame)return;const e=[];for(let t=0;t<Math.min(this.frame.count,Ru);t++)this.hidden[t]||e.push(t);for(const{mesh:t}of this.meshes)e.forEach((i,s)=>t.setColorAt(s,i===this.pointed?WT:this.plainColor)),t.instanceColor&&(t.instanceColor.needsUpdate=!0),t.material.opacity=this.opacity+(this.pointed===null?0:.07)}}const XT=`
varying vec2 place;
void main() { place = position.xy; gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0); }`,YT=`
varying vec2 place;
uniform vec3 ink;
uniform float strength;
uniform float span;
uniform float cell;
float lines(vec2 p, float size) {
  vec2 at = p / size;
  vec2 width = fwidth(at);
  vec2 near = abs(fract(at - 0.5) - 0.5) / max(width, vec2(1e-6));
  return (1.0 - min(min(near.x, near.y), 1.0)) * clamp(1.5 - 2.0 * max(width.x, width.y), 0.0, 1.0);
}
void main() {
  float fade = 1.0 - smoothstep(0.25 * span, span, length(place));
  float fine = 0.35 * lines(place, cell);
  float coarse = lines(place, 5.0 * cell);
  gl_FragColor = vec4(ink, max(fine, coarse) * fade * strength);
}`;class qT{object=new Qi;grid;shadow=new UM({opacity:.2,depthWrite:!1});planes;constructor(){this.grid=new ts({vertexShader:XT,fragmentShader:YT,transparent:!0,depthWrite:!1,uniforms:{ink:{value:new Qe(3883602)},strength:{value:.34},span:{value:4},cell:{value:.1}}});const e=new Ee(new _s(2,2),this.grid),t=new Ee(new _s(2,2),this.shadow);t.receiveShadow=!0,t.position.z=-5e-4,e.renderOrder=t.renderOrder=-1,this.planes=[e,t],this.object.add(e,t)}resize(e){const t=3.2*e;for(const o of this.planes)o.geometry.dispose(),o.geometry=new _s(2*t,2*t),o.position.z=-.001*e;const i=e/8,s=10**Math.floor(Math.log10(i)),r=s*([1,2,5,10].find(o=>o*s>=i)??10);this.grid.uniforms.span.value=t,this.grid.uniforms.cell.value=r/1}setDark(e){this.grid.uniforms.ink.value.set(e?11187400:3883602),this.grid.uniforms.strength.value=e?.22:.3,this.shadow.opacity=e?.42:.2}}const Cu=1,$T=2,jT=`
varying vec2 at;
void main() { at = uv; gl_Position = vec4(position.xy, 0.0, 1.0); }`,KT=`
varying vec2 at;
uniform sampler2D mask;
uniform vec2 reach;
uniform vec3 ink;
void main() {
  if (texture2D(mask, at).r > 0.5) discard;
  float near = 0.0;
  for (int ring = 1; ring <= 2; ring++) for (int k = 0; k < 16; k++) {
    float turn = 6.2831853 * (float(k) + 0.5 * float(ring)) / 16.0;
    near += texture2D(mask, at + 0.5 * float(ring) * reach * vec2(cos(turn), sin(turn))).r;
  }
  // A straight edge covers a third of the rings at the line's middle: that is where it fades.
  gl_FragColor = vec4(ink, smoothstep(0.0, 5.0, near));
}`;class ZT{target=new Ys(1,1,{minFilter:qn,magFilter:qn,depthBuffer:!1});flat=new Na({color:16777215,side:Fi,toneMapped:!1,depthTest:!1});edge=new ts({vertexShader:jT,fragmentShader:KT,transparent:!0,depthTest:!1,depthWrite:!1,toneMapped:!1,uniforms:{mask:{value:this.target.texture},reach:{value:new Ke},ink:{value:[.486,.227,.929]}}});page=new Sg;still=new Pf;link=null;constructor(){const e=new Ee(new _s(2,2),this.edge);e.frustumCulled=!1,this.page.add(e)}setDark(e){this.edge.uniforms.ink.value=e?[.77,.71,.99]:[.486,.227,.929]}around(e){const t=(i,s)=>i?.children.forEach(r=>{r instanceof Ee&&(s?r.layers.enable(Cu):r.layers.disable(Cu))});t(this.link,!1),t(e,!0),this.link=e}draw(e,t,i){if(!this.link)return;const s=e.getDrawingBufferSize(new Ke);this.target.setSize(s.x,s.y);const r=$T*e.getPixelRatio();this.edge.uniforms.reach.value.set(r/s.x,r/s.y);const{layers:o}=i,a=o.mask,l=e.shadowMap.autoUpdate;o.set(Cu),t.overrideMaterial=this.flat,e.shadowMap.autoUpdate=!1,e.setRenderTarget(this.target),e.clear(),e.render(t,i),e.setRenderTarget(null),o.mask=a,t.overrideMaterial=null,e.shadowMap.autoUpdate=l,e.autoClear=!1,e.render(this.page,this.still),e.autoClear=!0}}const Sm=600;class JT{object=new Qi;way=new vi(new on,new _o({color:8141549,transparent:!0,opacity:.85}));trail;points=new Float32Array(3*Sm);length=0;reach=new IM(new on,new _o({transparent:!0,opacity:.6}));constructor(){const e=new on;e.setAttribute("position",new Dn(this.points,3).setUsage(Zy)),e.setDrawRange(0,0),this.trail=new vi(e,new _o({color:15227148,transparent:!0,opacity:.9})),this.trail.frustumCulled=this.way.frustumCulled=!1,this.reach.visible=!1,this.object.add(this.way,this.trail,this.reach)}setDark(e){this.way.material.color=new Qe(e?10980346:7153881),this.trail.material.color=new Qe(e?16486972:14239759),this.reach.material.color=new Qe(e?6220500:1013358)}setWay(e){this.way.geometry.dispose(),this.way.geometry=new on,this.way.geometry.setAttribute("position",new Dn(new Float32Array(e.flat()),3))}add(e){const t=3*(this.length-1);if(this.length>0&&Math.hypot(...e.map((r,o)=>r-this.points[t+o]))<1e-5)return;this.length===Sm&&(this.points.copyWithin(0,3),this.length-=1),this.points.set(e,3*this.length),this.length+=1;const{geometry:i}=this.trail;i.setDrawRange(0,this.length),i.attributes.position.needsUpdate=!0}clearTrail(){this.length=0,this.trail.geometry.setDrawRange(0,0)}showTrail(e){this.trail.visible=this.way.visible=e}outline(e){const t=e.outline.map(([s,r])=>[s,0,r]),i=[...e.outline].reverse().map(([s,r])=>[-s,0,r]);this.reach.geometry.dispose(),this.reach.geometry=new on,this.reach.geometry.setAttribute("position",new Dn(new Float32Array([...t,...i].flat()),3)),Of(this.reach,e.outline_frame),this.clearTrail()}showOutline(e){this.reach.visible=e}}const na=new URLSearchParams(location.search).has("plain");class QT{constructor(e){this.canvas=e,this.renderer=new wT({canvas:e,antialias:!na,alpha:!0,preserveDrawingBuffer:na,powerPreference:"high-performance"}),this.renderer.toneMapping=rg,this.renderer.toneMappingExposure=1.05,this.renderer.shadowMap.enabled=!na,this.renderer.shadowMap.type=sg,this.renderer.info.autoReset=!1,this.controls=new AT(this.perspective,e),this.stand("z"),this.controls.zoomToCursor=!0,this.controls.enableDamping=!1,this.controls.addEventListener("change",()=>this.invalidate()),this.arm=new VT(()=>this.invalidate()),this.ghosts=new Mm,this.sun.castShadow=!na,this.sun.shadow.mapSize.set(2048,2048),this.sun.shadow.radius=6,this.sun.shadow.bias=-4e-4,this.sun.shadow.normalBias=.01,this.tool.add(this.triad),this.scene.add(this.sky,this.sun,this.sun.target,this.fill,this.ground.object,this.arm.object,this.ghosts.object,this.real.object,this.path.object,this.tool),new ResizeObserver(()=>this.resize()).observe(e.parentElement),this.resize()}canvas;renderer;scene=new Sg;perspective=new Mi(38,1,.01,200);orthographic=new Uf(-1,1,1,-1,-100,200);camera=this.perspective;controls;arm;ghosts;real=new Mm(GT);ground=new qT;path=new JT;outline=new ZT;upright=new _n;tool=new Qi;triad=new Ag(1);sun=new Gp(16777215,2.2);sky=new BM(16777215,9080730,1.5);fill=new Gp(14673663,.7);reach=1;wanted=!1;statistics={pictures:0,calls:0,triangles:0,milliseconds:0};beforeDraw=[];invalidate(){this.wanted||(this.wanted=!0,requestAnimationFrame(()=>{this.wanted=!1,this.draw()}))}onDraw(e){this.beforeDraw.push(e)}draw(){const e=performance.now();this.renderer.info.reset();for(const s of this.beforeDraw)s();this.renderer.render(this.scene,this.camera),this.outline.draw(this.renderer,this.scene,this.camera);const{calls:t,triangles:i}=this.renderer.info.render;Object.assign(this.statistics,{calls:t,triangles:i,milliseconds:performance.now()-e}),this.statistics.pictures+=1}resize(){const e=this.canvas.parentElement,[t,i]=[Math.max(1,e.clientWidth),Math.max(1,e.clientHeight)];this.renderer.setPixelRatio(na?1:Math.min(devicePixelRatio,2)),this.renderer.setSize(t,i,!1),this.perspective.aspect=t/i,this.perspective.updateProjectionMatrix(),this.matchOrthographic(),this.invalidate()}async show(e,t){this.reach=e.reach,this.perspective.near=e.reach/200,this.perspective.far=e.reach*200;const i=e.reach;this.stand(e.up),this.sun.position.set(1.2*i,-1.6*i,3.2*i).applyQuaternion(this.upright),this.fill.position.set(-2*i,1.5*i,1.2*i).applyQuaternion(this.upright);const s=this.sun.shadow.camera;Object.assign(s,{left:-1.7*i,right:1.7*i,top:1.7*i,bottom:-1.7*i,near:.2*i,far:8*i}),s.updateProjectionMatrix(),this.triad.scale.setScalar(.12*i),this.ground.resize(i),await this.arm.load(e),this.ghosts.load(this.arm),this.real.load(this.arm),this.path.outline(e),t||this.fit("home"),this.invalidate()}stand(e){const t=new k(+(e==="x"),+(e==="y"),+(e==="z"));this.upright.setFromUnitVectors(new k(0,0,1),t),this.ground.object.quaternion.copy(this.upright),this.sky.position.copy(t),this.level();const i=this.controls;i._quat.setFromUnitVectors(t,new k(0,1,0)),i._quatInverse.copy(i._quat).invert()}level(){for(const e of[this.perspective,this.orthographic])e.up.set(0,0,1).applyQuaternion(this.upright);this.controls.update()}strip(){const e=new Set([this.sky,this.sun,this.sun.target,this.fill,this.arm.object,this.real.object]),t=this.scene.children.filter(s=>s.visible&&!e.has(s)),i=this.arm.framesShown;return t.forEach(s=>s.visible=!1),this.arm.showFrames(!1),()=>{t.forEach(s=>s.visible=!0),this.arm.showFrames(i)}}setDark(e){this.scene.background=null,this.sky.intensity=e?1.05:1.5,this.sky.groundColor=new Qe(e?2764086:10133160),this.ground.setDark(e),this.path.setDark(e),this.outline.setDark(e),this.ghosts.setDark(e),this.real.setDark(e),this.invalidate()}fit(e){const t=new qs().setFromObject(this.arm.object);t.isEmpty()&&t.setFromCenterAndSize(new k(0,0,this.reach/2).applyQuaternion(this.upright),new k(1,1,1).multiplyScalar(this.reach));const i=t.getBoundingSphere(new Lr),s={home:new k(1,-1.25,.62),front:new k(1,0,0),right:new k(0,-1,0),top:new k(0,-1e-4,1)},r=e==="here"?this.camera.position.clone().sub(this.controls.target):s[e].applyQuaternion(this.upright);e!=="here"&&this.level();const o=Math.min(1,this.perspective.aspect),a=.94*i.radius/Math.sin(this.perspective.fov*Math.PI/360)/o;this.controls.target.copy(i.center),this.perspective.position.copy(i.center).addScaledVector(r.normalize(),a),this.orthographic.position.copy(this.perspective.position),this.matchOrthographic(),this.controls.update(),this.invalidate()}toggleProjection(){const e=this.camera===this.perspective?this.orthographic:this.perspective;e.position.copy(this.camera.position),e.up.copy(this.camera.up),this.camera=e,this.controls.object=e,this.matchOrthographic(),this.controls.update(),this.invalidate()}matchOrthographic(){const e=this.controls?this.camera.position.distanceTo(this.controls.target)*Math.tan(this.perspective.fov*Math.PI/360):1,{aspect:t}=this.perspective;Object.assign(this.orthographic,{left:-e*t,right:e*t,top:e,bottom:-e}),this.orthographic.updateProjectionMatrix()}ray(e){const t=this.canvas.getBoundingClientRect(),i=new Ke(2*(e.clientX-t.left)/t.width-1,1-2*(e.clientY-t.top)/t.height),s=new Tg;return s.setFromCamera(i,this.camera),{origin:s.ray.origin.toArray(),direction:s.ray.direction.toArray()}}project(e){const t=this.canvas.getBoundingClientRect(),i=new k(...e).project(this.camera);return[t.left+(i.x+1)/2*t.width,t.top+(1-i.y)/2*t.height]}setTool(e){Of(this.tool,e),this.tool.updateMatrixWorld()}get size(){return this.reach}}function Of(n,e){n.matrixAutoUpdate=!1;const t=e.flat();n.matrix.set(...t),n.matrixWorldNeedsUpdate=!0}const ar=new Tg,On=new k,Ns=new k,Kt=new _n,Em={X:new k(1,0,0),Y:new k(0,1,0),Z:new k(0,0,1)},Pu={type:"change"},bm={type:"mouseDown",mode:null},wm={type:"mouseUp",mode:null},Tm={type:"objectChange"};class e1 extends Rg{constructor(e,t=null){super(void 0,t);const i=new o1(this);this._root=i;const s=new a1;this._gizmo=s,i.add(s);const r=new l1;this._plane=r,i.add(r);const o=this;function a(w,y){let L=y;Object.defineProperty(o,w,{get:function(){return L!==void 0?L:y},set:function(R){L!==R&&(L=R,r[w]=R,s[w]=R,o.dispatchEvent({type:w+"-changed",value:R}),o.dispatchEvent(Pu))}}),o[w]=y,r[w]=y,s[w]=y}a("camera",e),a("object",void 0),a("enabled",!0),a("axis",null),a("mode","translate"),a("translationSnap",null),a("rotationSnap",null),a("scaleSnap",null),a("space","world"),a("size",1),a("dragging",!1),a("showX",!0),a("showY",!0),a("showZ",!0),a("minX",-1/0),a("maxX",1/0),a("minY",-1/0),a("maxY",1/0),a("minZ",-1/0),a("maxZ",1/0);const l=new k,c=new k,u=new _n,h=new _n,f=new k,d=new _n,_=new k,x=new k,m=new k,p=0,S=new k;a("worldPosition",l),a("worldPositionStart",c),a("worldQuaternion",u),a("worldQuaternionStart",h),a("cameraPosition",f),a("cameraQuaternion",d),a("pointStart",_),a("pointEnd",x),a("rotationAxis",m),a("rotationAngle",p),a("eye",S),this._offset=new k,this._startNorm=new k,this._endNorm=new k,this._cameraScale=new k,this._parentPosition=new k,this._parentQuaternion=new _n,this._parentQuaternionInv=new _n,this._parentScale=new k,this._worldScaleStart=new k,this._worldQuaternionInv=new _n,this._worldScale=new k,this._positionStart=new k,this._quaternionStart=new _n,this._scaleStart=new k,this._getPointer=t1.bind(this),this._onPointerDown=i1.bind(this),this._onPointerHover=n1.bind(this),this._onPointerMove=s1.bind(this),this._onPointerUp=r1.bind(this),t!==null&&this.connect(t)}connect(e){super.connect(e),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointermove",this._onPointerHover),this.domElement.addEventListener("pointerup",this._onPointerUp),this.domElement.style.touchAction="none"}disconnect(){this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.removeEventListener("pointermove",this._onPointerHover),this.domElement.removeEventListener("pointermove",this._onPointerMove),this.domElement.removeEventListener("pointerup",this._onPointerUp),this.domElement.style.touchAction="auto"}getHelper(){return this._root}pointerHover(e){if(this.object===void 0||this.dragging===!0)return;e!==null&&ar.setFromCamera(e,this.camera);const t=Du(this._gizmo.picker[this.mode],ar);t?this.axis=t.object.name:this.axis=null}pointerDown(e){if(!(this.object===void 0||this.dragging===!0||e!=null&&e.button!==0)&&this.axis!==null){e!==null&&ar.setFromCamera(e,this.camera);const t=Du(this._plane,ar,!0);t&&(this.object.updateMatrixWorld(),this.object.parent.updateMatrixWorld(),this._positionStart.copy(this.object.position),this._quaternionStart.copy(this.object.quaternion),this._scaleStart.copy(this.object.scale),this.object.matrixWorld.decompose(this.worldPositionStart,this.worldQuaternionStart,this._worldScaleStart),this.pointStart.copy(t.point).sub(this.worldPositionStart)),this.dragging=!0,bm.mode=this.mode,this.dispatchEvent(bm)}}pointerMove(e){const t=this.axis,i=this.mode,s=this.object;let r=this.space;if(i==="scale"?r="local":(t==="E"||t==="XYZE"||t==="XYZ")&&(r="world"),s===void 0||t===null||this.dragging===!1||e!==null&&e.button!==-1)return;e!==null&&ar.setFromCamera(e,this.camera);const o=Du(this._plane,ar,!0);if(o){if(this.pointEnd.copy(o.point).sub(this.worldPositionStart),i==="translate")this._offset.copy(this.pointEnd).sub(this.pointStart),r==="local"&&t!=="XYZ"&&this._offset.applyQuaternion(this._worldQuaternionInv),t.indexOf("X")===-1&&(this._offset.x=0),t.indexOf("Y")===-1&&(this._offset.y=0),t.indexOf("Z")===-1&&(this._offset.z=0),r==="local"&&t!=="XYZ"?this._offset.applyQuaternion(this._quaternionStart).divide(this._parentScale):this._offset.applyQuaternion(this._parentQuaternionInv).divide(this._parentScale),s.position.copy(this._offset).add(this._positionStart),this.translationSnap&&(r==="local"&&(s.position.applyQuaternion(Kt.copy(this._quaternionStart).invert()),t.search("X")!==-1&&(s.position.x=Math.round(s.position.x/this.translationSnap)*this.translationSnap),t.search("Y")!==-1&&(s.position.y=Math.round(s.position.y/this.translationSnap)*this.translationSnap),t.search("Z")!==-1&&(s.position.z=Math.round(s.position.z/this.translationSnap)*this.translationSnap),s.position.applyQuaternion(this._quaternionStart)),r==="world"&&(s.parent&&s.position.add(On.setFromMatrixPosition(s.parent.matrixWorld)),t.search("X")!==-1&&(s.position.x=Math.round(s.position.x/this.translationSnap)*this.translationSnap),t.search("Y")!==-1&&(s.position.y=Math.round(s.position.y/this.translationSnap)*this.translationSnap),t.search("Z")!==-1&&(s.position.z=Math.round(s.position.z/this.translationSnap)*this.translationSnap),s.parent&&s.position.sub(On.setFromMatrixPosition(s.parent.matrixWorld)))),s.position.x=Math.max(this.minX,Math.min(this.maxX,s.position.x)),s.position.y=Math.max(this.minY,Math.min(this.maxY,s.position.y)),s.position.z=Math.max(this.minZ,Math.min(this.maxZ,s.position.z));else if(i==="scale"){if(t.search("XYZ")!==-1){let a=this.pointEnd.length()/this.pointStart.length();this.pointEnd.dot(this.pointStart)<0&&(a*=-1),Ns.set(a,a,a)}else On.copy(this.pointStart),Ns.copy(this.pointEnd),On.applyQuaternion(this._worldQuaternionInv),Ns.applyQuaternion(this._worldQuaternionInv),Ns.divide(On),t.search("X")===-1&&(Ns.x=1),t.search("Y")===-1&&(Ns.y=1),t.search("Z")===-1&&(Ns.z=1);s.scale.copy(this._scaleStart).multiply(Ns),this.scaleSnap&&(t.search("X")!==-1&&(s.scale.x=Math.round(s.scale.x/this.scaleSnap)*this.scaleSnap||this.scaleSnap),t.search("Y")!==-1&&(s.scale.y=Math.round(s.scale.y/this.scaleSnap)*this.scaleSnap||this.scaleSnap),t.search("Z")!==-1&&(s.scale.z=Math.round(s.scale.z/this.scaleSnap)*this.scaleSnap||this.scaleSnap))}else if(i==="rotate"){this._offset.copy(this.pointEnd).sub(this.pointStart);const a=20/this.worldPosition.distanceTo(On.setFromMatrixPosition(this.camera.matrixWorld));let l=!1;t==="XYZE"?(this.rotationAxis.copy(this._offset).cross(this.eye).normalize(),this.rotationAngle=this._offset.dot(On.copy(this.rotationAxis).cross(this.eye))*a):(t==="X"||t==="Y"||t==="Z")&&(this.rotationAxis.copy(Em[t]),On.copy(Em[t]),r==="local"&&On.applyQuaternion(this.worldQuaternion),On.cross(this.eye),On.length()===0?l=!0:this.rotationAngle=this._offset.dot(On.normalize())*a),(t==="E"||l)&&(this.rotationAxis.copy(this.eye),this.rotationAngle=this.pointEnd.angleTo(this.pointStart),this._startNorm.copy(this.pointStart).normalize(),this._endNorm.copy(this.pointEnd).normalize(),this.rotationAngle*=this._endNorm.cross(this._startNorm).dot(this.eye)<0?1:-1),this.rotationSnap&&(this.rotationAngle=Math.round(this.rotationAngle/this.rotationSnap)*this.rotationSnap),r==="local"&&t!=="E"&&t!=="XYZE"?(s.quaternion.copy(this._quaternionStart),s.quaternion.multiply(Kt.setFromAxisAngle(this.rotationAxis,this.rotationAngle)).normalize()):(this.rotationAxis.applyQuaternion(this._parentQuaternionInv),s.quaternion.copy(Kt.setFromAxisAngle(this.rotationAxis,this.rotationAngle)),s.quaternion.multiply(this._quaternionStart).normalize())}this.dispatchEvent(Pu),this.dispatchEvent(Tm)}}pointerUp(e){e!==null&&e.button!==0||(this.dragging&&this.axis!==null&&(wm.mode=this.mode,this.dispatchEvent(wm)),this.dragging=!1,this.axis=null)}dispose(){this.disconnect(),this._root.dispose()}attach(e){return this.object=e,this._root.visible=!0,this}detach(){return this.object=void 0,this.axis=null,this._root.visible=!1,this}reset(){this.enabled&&this.dragging&&(this.object.position.copy(this._positionStart),this.object.quaternion.copy(this._quaternionStart),this.object.scale.copy(this._scaleStart),this.dispatchEvent(Pu),this.dispatchEvent(Tm),this.pointStart.copy(this.pointEnd))}getRaycaster(){return ar}getMode(){return this.mode}setMode(e){this.mode=e}setTranslationSnap(e){this.translationSnap=e}setRotationSnap(e){this.rotationSnap=e}setScaleSnap(e){this.scaleSnap=e}setSize(e){this.size=e}setSpace(e){this.space=e}setColors(e,t,i,s){const r=this._gizmo.materialLib;r.xAxis.color.set(e),r.yAxis.color.set(t),r.zAxis.color.set(i),r.active.color.set(s),r.xAxisTransparent.color.set(e),r.yAxisTransparent.color.set(t),r.zAxisTransparent.color.set(i),r.activeTransparent.color.set(s),r.xAxis._color&&r.xAxis._color.set(e),r.yAxis._color&&r.yAxis._color.set(t),r.zAxis._color&&r.zAxis._color.set(i),r.active._color&&r.active._color.set(s),r.xAxisTransparent._color&&r.xAxisTransparent._color.set(e),r.yAxisTransparent._color&&r.yAxisTransparent._color.set(t),r.zAxisTransparent._color&&r.zAxisTransparent._color.set(i),r.activeTransparent._color&&r.activeTransparent._color.set(s)}}function t1(n){if(this.domElement.ownerDocument.pointerLockElement)return{x:0,y:0,button:n.button};{const e=this.domElement.getBoundingClientRect();return{x:(n.clientX-e.left)/e.width*2-1,y:-(n.clientY-e.top)/e.height*2+1,button:n.button}}}function n1(n){if(this.enabled)switch(n.pointerType){case"mouse":case"pen":this.pointerHover(this._getPointer(n));break}}function i1(n){this.enabled&&(document.pointerLockElement||this.domElement.setPointerCapture(n.pointerId),this.domElement.addEventListener("pointermove",this._onPointerMove),this.pointerHover(this._getPointer(n)),this.pointerDown(this._getPointer(n)))}function s1(n){this.enabled&&this.pointerMove(this._getPointer(n))}function r1(n){this.enabled&&(this.domElement.releasePointerCapture(n.pointerId),this.domElement.removeEventListener("pointermove",this._onPointerMove),this.pointerUp(this._getPointer(n)))}function Du(n,e,t){const i=e.intersectObject(n,!0);for(let s=0;s<i.length;s++)if(i[s].object.visible||t)return i[s];return!1}const Ml=new wi,Ft=new k(0,1,0),Am=new k(0,0,0),Rm=new Pt,Sl=new _n,kl=new _n,Yi=new k,Cm=new Pt,da=new k(1,0,0),hr=new k(0,1,0),pa=new k(0,0,1),El=new k,ia=new k,sa=new k;class o1 extends nn{constructor(e){super(),this.isTransformControlsRoot=!0,this.controls=e,this.visible=!1}updateMatrixWorld(e){const t=this.controls;t.object!==void 0&&(t.object.updateMatrixWorld(),t.object.parent===null?console.error("TransformControls: The attached 3D object must be a part of the scene graph."):t.object.parent.matrixWorld.decompose(t._parentPosition,t._parentQuaternion,t._parentScale),t.object.matrixWorld.decompose(t.worldPosition,t.worldQuaternion,t._worldScale),t._parentQuaternionInv.copy(t._parentQuaternion).invert(),t._worldQuaternionInv.copy(t.worldQuaternion).invert()),t.camera.updateMatrixWorld(),t.camera.matrixWorld.decompose(t.cameraPosition,t.cameraQuaternion,t._cameraScale),t.camera.isOrthographicCamera?t.camera.getWorldDirection(t.eye).negate():t.eye.copy(t.cameraPosition).sub(t.worldPosition).normalize(),super.updateMatrixWorld(e)}dispose(){this.traverse(function(e){e.geometry&&e.geometry.dispose(),e.material&&e.material.dispose()})}}class a1 extends nn{constructor(){super(),this.isTransformControlsGizmo=!0,this.type="TransformControlsGizmo";const e=new Na({depthTest:!1,depthWrite:!1,fog:!1,toneMapped:!1,transparent:!0}),t=new _o({depthTest:!1,depthWrite:!1,fog:!1,toneMapped:!1,transparent:!0}),i=e.clone();i.opacity=.15;const s=t.clone();s.opacity=.5;const r=e.clone();r.color.setHex(16711680);const o=e.clone();o.color.setHex(65280);const a=e.clone();a.color.setHex(255);const l=e.clone();l.color.setHex(16711680),l.opacity=.5;const c=e.clone();c.color.setHex(65280),c.opacity=.5;const u=e.clone();u.color.setHex(255),u.opacity=.5;const h=e.clone();h.opacity=.25;const f=e.clone();f.color.setHex(16776960),f.opacity=.25;const d=e.clone();d.color.setHex(16776960);const _=e.clone();_.color.setHex(7895160),this.materialLib={xAxis:r,yAxis:o,zAxis:a,active:d,xAxisTransparent:l,yAxisTransparent:c,zAxisTransparent:u,activeTransparent:f};const x=new Fn(0,.04,.1,12);x.translate(0,.05,0);const m=new cn(.08,.08,.08);m.translate(0,.04,0);const p=new on;p.setAttribute("position",new $t([0,0,0,1,0,0],3));const S=new Fn(.0075,.0075,.5,3);S.translate(0,.25,0);function w(W,q){const j=new _r(W,.0075,3,64,q*Math.PI*2);return j.rotateY(Math.PI/2),j.rotateX(Math.PI/2),j}function y(){const W=new on;return W.setAttribute("position",new $t([0,0,0,1,1,1],3)),W}const L={X:[[new Ee(x,r),[.5,0,0],[0,0,-Math.PI/2]],[new Ee(x,r),[-.5,0,0],[0,0,Math.PI/2]],[new Ee(S,r),[0,0,0],[0,0,-Math.PI/2]]],Y:[[new Ee(x,o),[0,.5,0]],[new Ee(x,o),[0,-.5,0],[Math.PI,0,0]],[new Ee(S,o)]],Z:[[new Ee(x,a),[0,0,.5],[Math.PI/2,0,0]],[new Ee(x,a),[0,0,-.5],[-Math.PI/2,0,0]],[new Ee(S,a),null,[Math.PI/2,0,0]]],XYZ:[[new Ee(new ao(.1,0),h),[0,0,0]]],XY:[[new Ee(new cn(.15,.15,.01),u),[.15,.15,0]]],YZ:[[new Ee(new cn(.15,.15,.01),l),[0,.15,.15],[0,Math.PI/2,0]]],XZ:[[new Ee(new cn(.15,.15,.01),c),[.15,0,.15],[-Math.PI/2,0,0]]]},R={X:[[new Ee(new Fn(.2,0,.6,4),i),[.3,0,0],[0,0,-Math.PI/2]],[new Ee(new Fn(.2,0,.6,4),i),[-.3,0,0],[0,0,Math.PI/2]]],Y:[[new Ee(new Fn(.2,0,.6,4),i),[0,.3,0]],[new Ee(new Fn(.2,0,.6,4),i),[0,-.3,0],[0,0,Math.PI]]],Z:[[new Ee(new Fn(.2,0,.6,4),i),[0,0,.3],[Math.PI/2,0,0]],[new Ee(new Fn(.2,0,.6,4),i),[0,0,-.3],[-Math.PI/2,0,0]]],XYZ:[[new Ee(new ao(.2,0),i)]],XY:[[new Ee(new cn(.2,.2,.01),i),[.15,.15,0]]],YZ:[[new Ee(new cn(.2,.2,.01),i),[0,.15,.15],[0,Math.PI/2,0]]],XZ:[[new Ee(new cn(.2,.2,.01),i),[.15,0,.15],[-Math.PI/2,0,0]]]},U={START:[[new Ee(new ao(.01,2),s),null,null,null,"helper"]],END:[[new Ee(new ao(.01,2),s),null,null,null,"helper"]],DELTA:[[new vi(y(),s),null,null,null,"helper"]],X:[[new vi(p,s),[-1e3,0,0],null,[1e6,1,1],"helper"]],Y:[[new vi(p,s),[0,-1e3,0],[0,0,Math.PI/2],[1e6,1,1],"helper"]],Z:[[new vi(p,s),[0,0,-1e3],[0,-Math.PI/2,0],[1e6,1,1],"helper"]]},N={XYZE:[[new Ee(w(.5,1),_),null,[0,Math.PI/2,0]]],X:[[new Ee(w(.5,.5),r)]],Y:[[new Ee(w(.5,.5),o),null,[0,0,-Math.PI/2]]],Z:[[new Ee(w(.5,.5),a),null,[0,Math.PI/2,0]]],E:[[new Ee(w(.75,1),f),null,[0,Math.PI/2,0]]]},T={AXIS:[[new vi(p,s),[-1e3,0,0],null,[1e6,1,1],"helper"]]},b={XYZE:[[new Ee(new If(.25,10,8),i)]],X:[[new Ee(new _r(.5,.1,4,24),i),[0,0,0],[0,-Math.PI/2,-Math.PI/2]]],Y:[[new Ee(new _r(.5,.1,4,24),i),[0,0,0],[Math.PI/2,0,0]]],Z:[[new Ee(new _r(.5,.1,4,24),i),[0,0,0],[0,0,-Math.PI/2]]],E:[[new Ee(new _r(.75,.1,2,24),i)]]},C={X:[[new Ee(m,r),[.5,0,0],[0,0,-Math.PI/2]],[new Ee(S,r),[0,0,0],[0,0,-Math.PI/2]],[new Ee(m,r),[-.5,0,0],[0,0,Math.PI/2]]],Y:[[new Ee(m,o),[0,.5,0]],[new Ee(S,o)],[new Ee(m,o),[0,-.5,0],[0,0,Math.PI]]],Z:[[new Ee(m,a),[0,0,.5],[Math.PI/2,0,0]],[new Ee(S,a),[0,0,0],[Math.PI/2,0,0]],[new Ee(m,a),[0,0,-.5],[-Math.PI/2,0,0]]],XY:[[new Ee(new cn(.15,.15,.01),u),[.15,.15,0]]],YZ:[[new Ee(new cn(.15,.15,.01),l),[0,.15,.15],[0,Math.PI/2,0]]],XZ:[[new Ee(new cn(.15,.15,.01),c),[.15,0,.15],[-Math.PI/2,0,0]]],XYZ:[[new Ee(new cn(.1,.1,.1),h)]]},B={X:[[new Ee(new Fn(.2,0,.6,4),i),[.3,0,0],[0,0,-Math.PI/2]],[new Ee(new Fn(.2,0,.6,4),i),[-.3,0,0],[0,0,Math.PI/2]]],Y:[[new Ee(new Fn(.2,0,.6,4),i),[0,.3,0]],[new Ee(new Fn(.2,0,.6,4),i),[0,-.3,0],[0,0,Math.PI]]],Z:[[new Ee(new Fn(.2,0,.6,4),i),[0,0,.3],[Math.PI/2,0,0]],[new Ee(new Fn(.2,0,.6,4),i),[0,0,-.3],[-Math.PI/2,0,0]]],XY:[[new Ee(new cn(.2,.2,.01),i),[.15,.15,0]]],YZ:[[new Ee(new cn(.2,.2,.01),i),[0,.15,.15],[0,Math.PI/2,0]]],XZ:[[new Ee(new cn(.2,.2,.01),i),[.15,0,.15],[-Math.PI/2,0,0]]],XYZ:[[new Ee(new cn(.2,.2,.2),i),[0,0,0]]]},z={X:[[new vi(p,s),[-1e3,0,0],null,[1e6,1,1],"helper"]],Y:[[new vi(p,s),[0,-1e3,0],[0,0,Math.PI/2],[1e6,1,1],"helper"]],Z:[[new vi(p,s),[0,0,-1e3],[0,-Math.PI/2,0],[1e6,1,1],"helper"]]};function X(W){const q=new nn;for(const j in W)for(let Z=W[j].length;Z--;){const re=W[j][Z][0].clone(),ae=W[j][Z][1],me=W[j][Z][2],xe=W[j][Z][3],ge=W[j][Z][4];re.name=j,re.tag=ge,ae&&re.position.set(ae[0],ae[1],ae[2]),me&&re.rotation.set(me[0],me[1],me[2]),xe&&re.scale.set(xe[0],xe[1],xe[2]),re.updateMatrix();const tt=re.geometry.clone();tt.applyMatrix4(re.matrix),re.geometry=tt,re.renderOrder=1/0,re.position.set(0,0,0),re.rotation.set(0,0,0),re.scale.set(1,1,1),q.add(re)}return q}this.gizmo={},this.picker={},this.helper={},this.add(this.gizmo.translate=X(L)),this.add(this.gizmo.rotate=X(N)),this.add(this.gizmo.scale=X(C)),this.add(this.picker.translate=X(R)),this.add(this.picker.rotate=X(b)),this.add(this.picker.scale=X(B)),this.add(this.helper.translate=X(U)),this.add(this.helper.rotate=X(T)),this.add(this.helper.scale=X(z)),this.picker.translate.visible=!1,this.picker.rotate.visible=!1,this.picker.scale.visible=!1}updateMatrixWorld(e){const i=(this.mode==="scale"?"local":this.space)==="local"?this.worldQuaternion:kl;this.gizmo.translate.visible=this.mode==="translate",this.gizmo.rotate.visible=this.mode==="rotate",this.gizmo.scale.visible=this.mode==="scale",this.helper.translate.visible=this.mode==="translate",this.helper.rotate.visible=this.mode==="rotate",this.helper.scale.visible=this.mode==="scale";let s=[];s=s.concat(this.picker[this.mode].children),s=s.concat(this.gizmo[this.mode].children),s=s.concat(this.helper[this.mode].children);for(let r=0;r<s.length;r++){const o=s[r];o.visible=!0,o.rotation.set(0,0,0),o.position.copy(this.worldPosition);let a;if(this.camera.isOrthographicCamera?a=(this.camera.top-this.camera.bottom)/this.camera.zoom:a=this.worldPosition.distanceTo(this.cameraPosition)*Math.min(1.9*Math.tan(Math.PI*this.camera.fov/360)/this.camera.zoom,7),o.scale.set(1,1,1).multiplyScalar(a*this.size/4),o.tag==="helper"){o.visible=!1,o.name==="AXIS"?(o.visible=!!this.axis,this.axis==="X"&&(Kt.setFromEuler(Ml.set(0,0,0)),o.quaternion.copy(i).multiply(Kt),Math.abs(Ft.copy(da).applyQuaternion(i).dot(this.eye))>.9&&(o.visible=!1)),this.axis==="Y"&&(Kt.setFromEuler(Ml.set(0,0,Math.PI/2)),o.quaternion.copy(i).multiply(Kt),Math.abs(Ft.copy(hr).applyQuaternion(i).dot(this.eye))>.9&&(o.visible=!1)),this.axis==="Z"&&(Kt.setFromEuler(Ml.set(0,Math.PI/2,0)),o.quaternion.copy(i).multiply(Kt),Math.abs(Ft.copy(pa).applyQuaternion(i).dot(this.eye))>.9&&(o.visible=!1)),this.axis==="XYZE"&&(Kt.setFromEuler(Ml.set(0,Math.PI/2,0)),Ft.copy(this.rotationAxis),o.quaternion.setFromRotationMatrix(Rm.lookAt(Am,Ft,hr)),o.quaternion.multiply(Kt),o.visible=this.dragging),this.axis==="E"&&(o.visible=!1)):o.name==="START"?(o.position.copy(this.worldPositionStart),o.visible=this.dragging):o.name==="END"?(o.position.copy(this.worldPosition),o.visible=this.dragging):o.name==="DELTA"?(o.position.copy(this.worldPositionStart),o.quaternion.copy(this.worldQuaternionStart),On.set(1e-10,1e-10,1e-10).add(this.worldPositionStart).sub(this.worldPosition).multiplyScalar(-1),On.applyQuaternion(this.worldQuaternionStart.clone().invert()),o.scale.copy(On),o.visible=this.dragging):(o.quaternion.copy(i),this.dragging?o.position.copy(this.worldPositionStart):o.position.copy(this.worldPosition),this.axis&&(o.visible=this.axis.search(o.name)!==-1));continue}o.quaternion.copy(i),this.mode==="translate"||this.mode==="scale"?(o.name==="X"&&Math.abs(Ft.copy(da).applyQuaternion(i).dot(this.eye))>.99&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1),o.name==="Y"&&Math.abs(Ft.copy(hr).applyQuaternion(i).dot(this.eye))>.99&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1),o.name==="Z"&&Math.abs(Ft.copy(pa).applyQuaternion(i).dot(this.eye))>.99&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1),o.name==="XY"&&Math.abs(Ft.copy(pa).applyQuaternion(i).dot(this.eye))<.2&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1),o.name==="YZ"&&Math.abs(Ft.copy(da).applyQuaternion(i).dot(this.eye))<.2&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1),o.name==="XZ"&&Math.abs(Ft.copy(hr).applyQuaternion(i).dot(this.eye))<.2&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1)):this.mode==="rotate"&&(Sl.copy(i),Ft.copy(this.eye).applyQuaternion(Kt.copy(i).invert()),o.name.search("E")!==-1&&o.quaternion.setFromRotationMatrix(Rm.lookAt(this.eye,Am,hr)),o.name==="X"&&(Kt.setFromAxisAngle(da,Math.atan2(-Ft.y,Ft.z)),Kt.multiplyQuaternions(Sl,Kt),o.quaternion.copy(Kt)),o.name==="Y"&&(Kt.setFromAxisAngle(hr,Math.atan2(Ft.x,Ft.z)),Kt.multiplyQuaternions(Sl,Kt),o.quaternion.copy(Kt)),o.name==="Z"&&(Kt.setFromAxisAngle(pa,Math.atan2(Ft.y,Ft.x)),Kt.multiplyQuaternions(Sl,Kt),o.quaternion.copy(Kt))),o.visible=o.visible&&(o.name.indexOf("X")===-1||this.showX),o.visible=o.visible&&(o.name.indexOf("Y")===-1||this.showY),o.visible=o.visible&&(o.name.indexOf("Z")===-1||this.showZ),o.visible=o.visible&&(o.name.indexOf("E")===-1||this.showX&&this.showY&&this.showZ),o.material._color=o.material._color||o.material.color.clone(),o.material._opacity=o.material._opacity||o.material.opacity,o.material.color.copy(o.material._color),o.material.opacity=o.material._opacity,this.enabled&&this.axis&&(o.name===this.axis?(o.material.color.copy(this.materialLib.active.color),o.material.opacity=1):this.axis.split("").some(function(l){return o.name===l})&&(o.material.color.copy(this.materialLib.active.color),o.material.opacity=1))}super.updateMatrixWorld(e)}}class l1 extends Ee{constructor(){super(new _s(1e5,1e5,2,2),new Na({visible:!1,wireframe:!0,side:Fi,transparent:!0,opacity:.1,toneMapped:!1})),this.isTransformControlsPlane=!0,this.type="TransformControlsPlane"}updateMatrixWorld(e){let t=this.space;switch(this.position.copy(this.worldPosition),this.mode==="scale"&&(t="local"),El.copy(da).applyQuaternion(t==="local"?this.worldQuaternion:kl),ia.copy(hr).applyQuaternion(t==="local"?this.worldQuaternion:kl),sa.copy(pa).applyQuaternion(t==="local"?this.worldQuaternion:kl),Ft.copy(ia),this.mode){case"translate":case"scale":switch(this.axis){case"X":Ft.copy(this.eye).cross(El),Yi.copy(El).cross(Ft);break;case"Y":Ft.copy(this.eye).cross(ia),Yi.copy(ia).cross(Ft);break;case"Z":Ft.copy(this.eye).cross(sa),Yi.copy(sa).cross(Ft);break;case"XY":Yi.copy(sa);break;case"YZ":Yi.copy(El);break;case"XZ":Ft.copy(sa),Yi.copy(ia);break;case"XYZ":case"E":Yi.set(0,0,0);break}break;default:Yi.set(0,0,0)}Yi.length()===0?this.quaternion.copy(this.cameraQuaternion):(Cm.lookAt(On.set(0,0,0),Yi,Ft),this.quaternion.setFromRotationMatrix(Cm)),super.updateMatrixWorld(e)}}class c1{constructor(e){this.viewer=e;const{canvas:t}=e;t.addEventListener("pointerdown",s=>{!this.on||s.button!==0||s.shiftKey||s.pointerType==="touch"||!e.controls.enabled||(s.stopImmediatePropagation(),this.at={pointer:s.pointerId,x:s.clientX,y:s.clientY},t.setPointerCapture(s.pointerId))},{capture:!0}),t.addEventListener("pointermove",s=>{this.at?.pointer===s.pointerId&&(this.turn(s.clientX-this.at.x,s.clientY-this.at.y),Object.assign(this.at,{x:s.clientX,y:s.clientY}))});const i=()=>{this.at=null};t.addEventListener("pointerup",i),t.addEventListener("pointercancel",i)}viewer;on=!1;at=null;turn(e,t){const{camera:i,controls:s,canvas:r}=this.viewer,o=Math.hypot(e,t);if(o===0)return;const a=new k(t,e,0).divideScalar(o).applyQuaternion(i.quaternion),l=new _n().setFromAxisAngle(a,-2*Math.PI*o/r.clientHeight);i.position.sub(s.target).applyQuaternion(l).add(s.target),i.up.set(0,1,0).applyQuaternion(i.quaternion).applyQuaternion(l),s.update()}}const u1=420;function h1(n,e){const{canvas:t}=n;let i=null,s=0;const r=new wr(_=>bi.send(_),_=>{if(i)return;const x=_;Rs.value=x?.link??null}),o=new wr(_=>bi.send(_),()=>{},_=>gn(_.message)),a=_=>{e.style.setProperty("transform",`translate(${_.offsetX+16}px, ${_.offsetY+12}px)`),r.push({do:"pick",...n.ray(_)})};t.addEventListener("pointermove",_=>{if(i?.pointer===_.pointerId){e.style.setProperty("transform",`translate(${_.offsetX+16}px, ${_.offsetY+12}px)`),o.push({do:"drag",...n.ray(_)}),_.stopImmediatePropagation();return}_.buttons===0&&_.pointerType!=="touch"&&f.axis===null&&a(_)},{capture:!0}),t.addEventListener("pointerleave",()=>{i||(Rs.value=null)});const l=async _=>{i={pointer:_.pointerId},Cl.value=!0,n.controls.enabled=!1,t.setPointerCapture(_.pointerId);const x=await Ge({do:"grab",...n.ray(_),arm:_.ctrlKey||_.metaKey});if(!x)return c(!1);ef.value||i_(),Rs.value=x.link},c=_=>{i&&(i=null,Cl.value=!1,n.controls.enabled=!0,o.settled().then(()=>Ge({do:"release",cancel:_})).then(Ng))};let u;t.addEventListener("pointerdown",_=>{if(s=_.timeStamp,f.axis!==null)return;if(_.pointerType==="touch"){const m=_;u=setTimeout(()=>{l(m)},u1);return}const x=Rs.value!==null&&rn.value?.links[Rs.value]?.joint!==null;_.button===0&&x&&!_.shiftKey&&(_.stopImmediatePropagation(),l(_))},{capture:!0}),t.addEventListener("pointermove",_=>{u&&Math.hypot(_.movementX,_.movementY)>2&&clearTimeout(u)});const h=_=>{clearTimeout(u),i?.pointer===_.pointerId&&c(_.type==="pointercancel")};t.addEventListener("pointerup",h),t.addEventListener("pointercancel",h),addEventListener("keydown",_=>{_.key==="Escape"&&i&&c(!0)}),t.addEventListener("dblclick",()=>{const _=Rs.value===null?null:n.arm.links[Rs.value];!_||performance.now()-s>5e3||(n.controls.target.setFromMatrixPosition(_.matrixWorld),n.controls.update())}),Jt(()=>{const _=Rs.value,x=_===null?null:rn.value?.links[_]?.joint??null;n.arm.highlight(_),n.outline.around(_===null?null:n.arm.links[_]??null),t.style.setProperty("cursor",Cl.value?"grabbing":x!==null&&_!==null?"grab":"default");const m=rn.value?.joints,p=x===null?void 0:m?.[x];if(e.hidden=p===void 0,p&&x!==null){const S=yo(p);e.textContent=`${p.label}  ${Ws(uc.value[x]??0,S,_t.value)} ${jl(S,_t.value)}`}});const f=f1(n),d=new c1(n);Jt(()=>{d.on=hc.value,d.on||n.level()})}function Ng(){const n=ns.value?.tool;n&&(n_.value=`Tool at ${n.position.map(e=>`${(1e3*e).toFixed(0)}`).join(", ")} millimetres`)}function f1(n){const e=new nn;n.scene.add(e);const t=new e1(n.camera,n.canvas);t.size=.75,t.attach(e),n.scene.add(t.getHelper());let i="",s=!1;const r=new wr(l=>bi.send(l),l=>{const c=l;c.reached||gn(c.sentence)},l=>gn(l.message)),o=()=>{s||n.tool.matrix.decompose(e.position,e.quaternion,new k)};t.addEventListener("dragging-changed",l=>{s=l.value,n.controls.enabled=!s,Cl.value=s,s?i=Tr("gizmo"):r.settled().then(o).then(Ng).then(()=>n.invalidate())}),t.addEventListener("objectChange",()=>{const l=e.quaternion;r.push({do:"tool",position:e.position.toArray(),quaternion:[l.w,l.x,l.y,l.z],gesture:i})}),t.addEventListener("change",()=>n.invalidate()),n.onDraw(()=>{t.camera=n.camera,o()}),addEventListener("keydown",l=>l.key==="Control"&&a(!0)),addEventListener("keyup",l=>l.key==="Control"&&a(!1));const a=l=>{t.setTranslationSnap(l?.01:null),t.setRotationSnap(l?Math.PI/36:null)};return Jt(()=>{const l=ot.gizmo.value;t.enabled=l!=="off",t.getHelper().visible=l!=="off",l!=="off"&&t.setMode(l),t.setSpace(ot.local.value?"local":"world"),n.invalidate()}),t}const Lu=/[?&]frame=(\d+)x(\d+)/.exec(location.search);let Rn=null;function d1(){const n=ui(null),e=ui(null);return br(()=>{const t=new QT(n.current);Rn=t,window.pieperViewer=t,h1(t,e.current),p1(t)},[]),v("div",{class:"view",children:[v("canvas",{ref:n,tabIndex:0,"aria-label":"3D view of the arm. Every action is in the panels too; press ? for keys."}),v("div",{ref:e,class:"touch-label",hidden:!0})]})}function p1(n){let e=0,t=null,i="";U0(r=>{r.kind==="pose"?n.arm.move(r.matrices):r.kind==="real"?n.real.move(r,[]):(t=r,s()),n.invalidate()});const s=()=>{if(!t)return;const r=gs.value?.solutions??[];n.ghosts.move(t,Array.from({length:t.count},(o,a)=>r[a]?.current??!1)),n.invalidate()};Jt(()=>{const r=rn.value;if(!r||r.revision===e)return;e=r.revision;const o=i===r.id;i=r.id,n.show(r,o).then(()=>{document.documentElement.dataset.ready="1",Lu&&_1(Number(Lu[1]),Number(Lu[2]))})}),Jt(()=>n.setDark(Sr.value)),Jt(()=>{const r=ns.value?.matrix;r&&(n.setTool(r),ot.trail.value&&n.path.add([r[0][3],r[1][3],r[2][3]]),n.invalidate())}),Jt(()=>{n.path.setWay(La.value?.tool??[]),n.invalidate()}),Jt(()=>{n.arm.showFrames(ot.frames.value),n.arm.showCollision(ot.collision.value),n.path.showTrail(ot.trail.value),n.path.showOutline(ot.outline.value),n.ghosts.object.visible=ot.ghosts.value&&vs.value?.playing!==!0,n.invalidate()}),Jt(()=>{gs.value,s()}),Jt(()=>{n.ghosts.point(la.value),n.invalidate()})}function m1(n,e){const t=document.createElement("a");t.href=URL.createObjectURL(e),t.download=n,t.click(),setTimeout(()=>URL.revokeObjectURL(t.href),1e4)}function Fg(n){const{width:e,height:t}=n,i=document.createElement("canvas");[i.width,i.height]=[e,t];const s=i.getContext("2d"),r=getComputedStyle(document.documentElement),o=s.createRadialGradient(e/2,.35*t,0,e/2,.35*t,.75*Math.max(e,t));return o.addColorStop(0,r.getPropertyValue("--bg-1")),o.addColorStop(1,r.getPropertyValue("--bg-2")),s.fillStyle=o,s.fillRect(0,0,e,t),s.drawImage(n,0,0),i}async function _1(n,e){if(!Rn)return;const{renderer:t,canvas:i,perspective:s}=Rn;t.setPixelRatio(1),t.setSize(n,e,!1),s.aspect=n/e,s.updateProjectionMatrix(),Rn.fit("home"),t.render(Rn.scene,Rn.camera);const r=await new Promise(o=>Fg(i).toBlob(o,"image/png"));r&&await fetch("/api/picture",{method:"POST",body:r})}const Bl={scale:Xe(2),transparent:Xe(!0),overlays:Xe(!0)};async function Og(n=Bl.scale.value){if(!Rn)return;const{renderer:e,canvas:t}=Rn,i=e.getPixelRatio(),s=Bl.overlays.value?()=>{}:Rn.strip();e.setPixelRatio(n),e.render(Rn.scene,Rn.camera);const r=Bl.transparent.value?t:Fg(t),o=await new Promise(a=>r.toBlob(a,"image/png"));s(),e.setPixelRatio(i),Rn.invalidate(),o?m1(`${rn.value?.id??"arm"}.png`,o):gn("The picture could not be made")}const g1=new wr(n=>bi.send(n),()=>{},n=>gn(n.message));function v1(n){const t=[n.shoulder,n.elbow&&`elbow ${n.elbow}`,n.wrist].filter(i=>typeof i=="string");return t.length>0?t:[n.branch]}function x1({family:n,index:e}){const t=ui("");return v("div",{class:"family",children:[v("p",{children:[v("strong",{children:"Infinitely many."})," ",n.name,"."]}),v("input",{type:"range",min:0,max:1,step:1/96,value:n.at,"aria-label":`Family ${e+1}: ${n.name}`,onPointerDown:()=>t.current=Tr("family"),onKeyDown:i=>{i.repeat||(t.current=Tr("family")),i.stopPropagation()},onInput:i=>g1.push({do:"family",index:e,at:Number(i.currentTarget.value),gesture:t.current})})]})}function y1(){const n=gs.value,e=ns.value?.unlocked??!1;if(!n)return null;if(n.status==="playing")return v("p",{class:"quiet",children:"The list is made when the motion stands."});const t=n.solutions.length,i={solved:`${t} solution${t===1?"":"s"} for this pose`,singular:`A singular pose: ${n.families.length===1?"a family":`${n.families.length} families`}${t>0?` and ${t} more`:""}`,redundant:"More joints than the pose needs",unreachable:"No solution",none:"No solver takes this arm",playing:""}[n.status];return v("section",{"aria-label":"IK solutions",children:[v("div",{class:"row spread",children:[v("strong",{children:i}),v("label",{class:"check",children:[v("input",{type:"checkbox",checked:ot.ghosts.value,onChange:s=>{ot.ghosts.value=s.currentTarget.checked,Ge({do:"ghosts",on:ot.ghosts.value})}})," Ghosts"]})]}),n.missed&&v("p",{class:"banner",children:[v(Ei,{name:"warn"})," The pose asked for cannot be reached: ",n.reason??"every solution lies outside the limits",". The arm stands at the nearest."]}),n.families.map((s,r)=>v(x1,{family:s,index:r},r)),v("ol",{class:"solutions",children:n.solutions.map((s,r)=>{const o=!s.within_limits&&!e;return v("li",{children:v("button",{type:"button",class:`solution ${s.current?"current":""}`,"aria-current":s.current,disabled:o,onMouseEnter:()=>la.value=r,onMouseLeave:()=>la.value=null,onFocus:()=>la.value=r,onBlur:()=>la.value=null,onClick:()=>{Ge({do:"solution",index:r})},children:[v("span",{class:"number-of",children:r+1}),v("span",{class:"flags",children:[v1(s).map(a=>v("span",{class:"flag",children:a},a)),s.multiplicity>1&&v("span",{class:"flag",children:["×",s.multiplicity]})]}),v("span",{class:"details",children:[s.current?v("span",{class:"here",children:[v(Ei,{name:"check"})," here"]}):v("span",{children:[(s.distance*180/Math.PI).toFixed(0),"° away"]}),o&&v("span",{class:"outside",children:[v(Ei,{name:"lock"})," outside limits"]}),v("span",{class:"residual",title:"What forward kinematics misses the pose by",children:c_(s.residual)})]})]})},r)})}),n.microseconds!==void 0&&v("p",{class:"quiet small",children:["Solved by ",v("em",{children:n.solver})," in ",n.microseconds.toFixed(1)," µs. ",v("kbd",{children:"["})," ",v("kbd",{children:"]"})," step through."]})]})}function Pm(n){const e=gs.value?.solutions??[],t=ns.value?.unlocked??!1,i=Math.max(0,e.findIndex(s=>s.current));for(let s=1;s<=e.length;s++){const r=(i+n*s+e.length*s)%e.length;if(e[r].within_limits||t)return void Ge({do:"solution",index:r})}}async function M1(n){const e=ql.value.find(s=>s.id===n.value),t={};for(const s of e?.needs??[]){const r=prompt(`${e.name}: the length ${s}, as in 0.3 or 250 mm`,"0.3");if(r===null){n.value=rn.value?.id??"";return}t[s]=r}await Ge({do:"load",robot:n.value,values:t})===void 0&&(n.value=rn.value?.id??"")}async function S1(n){const e=await n.text();n.name.endsWith(".json")?await Ge({do:"open",text:e}):await Ge({do:"load",file:{name:n.name,text:e}})}function E1(){const{undo:n,redo:e}=Qm.value,t=ql.value.some(r=>r.id===rn.value?.id),i={system:"light",light:"dark",dark:"system"},s=t_.value;return Lo?v(b1,{}):v("header",{class:"top",children:[v("span",{class:"brand",children:[v("svg",{viewBox:"0 0 32 32","aria-hidden":"true",children:[v("path",{d:"M9 25h14M12 25l-1-9 9-6 4 4"}),v("circle",{cx:"11",cy:"16",r:"2.6"}),v("circle",{cx:"20",cy:"10",r:"2.6"})]}),v("span",{children:"pieper"})]}),v("div",{class:"picker",children:[v("select",{"aria-label":"Robot",value:rn.value?.id??"",onChange:r=>{M1(r.currentTarget)},children:[!t&&rn.value&&v("option",{value:rn.value.id,children:rn.value.name}),ql.value.map(r=>v("option",{value:r.id,children:r.name},r.id))]}),v(Ei,{name:"down"})]}),v("label",{class:"icon-button",title:"Open a robot (.toml, .urdf) or a project (.json)",children:[v(Ei,{name:"upload"}),v("span",{class:"visually-hidden",children:"Open a robot or project file"}),v("input",{type:"file",class:"visually-hidden",accept:".toml,.urdf,.xml,.json",onChange:r=>{const o=r.currentTarget.files?.[0];o&&S1(o),r.currentTarget.value=""}})]}),v("span",{class:"group",children:[v(yt,{icon:"undo",label:n?`Undo: ${n}`:"Nothing to undo",keys:"Ctrl+Z",disabled:!n,onClick:()=>{Ge({do:"undo"})}}),v(yt,{icon:"redo",label:e?`Redo: ${e}`:"Nothing to redo",keys:"Ctrl+Shift+Z",disabled:!e,onClick:()=>{Ge({do:"redo"})}})]}),v("span",{class:"grow"}),v("span",{class:"group wide",children:[v(yt,{icon:"move",label:"Move the tool by a gizmo",keys:"W",pressed:ot.gizmo.value==="translate",onClick:()=>ot.gizmo.value=ot.gizmo.value==="translate"?"off":"translate"}),v(yt,{icon:"rotate",label:"Turn the tool by a gizmo",keys:"E",pressed:ot.gizmo.value==="rotate",onClick:()=>ot.gizmo.value=ot.gizmo.value==="rotate"?"off":"rotate"})]}),v("span",{class:"group wide",children:[v(yt,{icon:"ghost",label:"Ghosts of all solutions",keys:"G",pressed:ot.ghosts.value,onClick:kf}),v(yt,{icon:"axes",label:"Link frames",keys:"T",pressed:ot.frames.value,onClick:()=>ot.frames.value=!ot.frames.value}),v(yt,{icon:"trail",label:"The tool's way",pressed:ot.trail.value,onClick:()=>ot.trail.value=!ot.trail.value}),v(yt,{icon:"reach",label:"Outline of the reach",keys:"O",pressed:ot.outline.value,onClick:()=>ot.outline.value=!ot.outline.value})]}),v("span",{class:"group",children:[v("button",{type:"button",class:"text-button",title:"Units (U)","aria-label":`Units: ${_t.value.angle} and ${_t.value.length}`,onClick:Bf,children:[_t.value.angle==="deg"?"°":"rad"," · ",_t.value.length]}),v(yt,{icon:"download",label:"Share: this view as one file that needs no program",onClick:()=>location.assign("/api/share.html")}),v(yt,{icon:"camera",label:"A picture of the view",onClick:()=>Si.value="picture"}),v(yt,{icon:li.value==="system"?"auto":li.value==="light"?"sun":"moon",label:`Theme: ${li.value}`,onClick:()=>{li.value=i[li.value],xs("theme",li.value)}}),v(yt,{icon:"help",label:"Keys and gestures",keys:"?",onClick:()=>Si.value="help"}),v(yt,{icon:"panel",label:"Side panel",pressed:zs.value,onClick:()=>zs.value=!zs.value})]}),v("span",{class:`connection ${co.value}`,role:"status",title:"Time for a message to the program and back",children:[v("span",{class:"dot","aria-hidden":"true"}),co.value==="open"?s===null?"connected":`${s.toFixed(1)} ms`:co.value]})]})}function b1(){const n={system:"light",light:"dark",dark:"system"};return v("header",{class:"top",children:[v("span",{class:"brand",children:v("span",{children:rn.value?.name})}),v("span",{class:"quiet small",children:"shared from pieper studio"}),v("span",{class:"grow"}),v("span",{class:"group",children:[v(yt,{icon:"ghost",label:"Ghosts of all solutions",keys:"G",pressed:ot.ghosts.value,onClick:kf}),v(yt,{icon:"axes",label:"Link frames",keys:"T",pressed:ot.frames.value,onClick:()=>ot.frames.value=!ot.frames.value}),v(yt,{icon:"reach",label:"Outline of the reach",keys:"O",pressed:ot.outline.value,onClick:()=>ot.outline.value=!ot.outline.value})]}),v("span",{class:"group",children:[v("button",{type:"button",class:"text-button",title:"Units (U)",onClick:Bf,children:[_t.value.angle==="deg"?"°":"rad"," · ",_t.value.length]}),v(yt,{icon:li.value==="system"?"auto":li.value==="light"?"sun":"moon",label:`Theme: ${li.value}`,onClick:()=>li.value=n[li.value]}),v(yt,{icon:"panel",label:"Side panel",pressed:zs.value,onClick:()=>zs.value=!zs.value})]})]})}function kf(){ot.ghosts.value=!ot.ghosts.value,Ge({do:"ghosts",on:ot.ghosts.value})}function Bf(){const{angle:n,length:e}=_t.value;_t.value=n==="deg"&&e==="mm"?{angle:"rad",length:"m"}:{angle:"deg",length:"mm"},xs("angle",_t.value.angle),xs("length",_t.value.length),gn(`Shown in ${_t.value.angle==="deg"?"degrees":"radians"} and ${_t.value.length==="mm"?"millimetres":"metres"}`,"note")}const bl=n=>()=>{n.value=!n.value},Dm=n=>()=>{ot.gizmo.value=ot.gizmo.value===n?"off":n};function kg(n){hc.value=n,xs("tumble",n?"on":"off")}const oc=[{name:"Fit the arm",keys:"F",run:()=>Rn?.fit("here")},{name:"Recentre the view",keys:"V",run:()=>Rn?.fit("home")},{name:"Front view",keys:"1",run:()=>Rn?.fit("front")},{name:"Right view",keys:"3",run:()=>Rn?.fit("right")},{name:"Top view",keys:"7",run:()=>Rn?.fit("top")},{name:"Parallel or central projection",keys:"5",run:()=>Rn?.toggleProjection()},{name:"Turn the view freely, or about the upright axis",keys:"",run:()=>kg(!hc.value)},{name:"Home posture",keys:"H",run:()=>{Ge({do:"named",to:"home"})}},{name:"Zero posture",keys:"0",run:()=>{Ge({do:"named",to:"zero"})}},{name:"Random posture",keys:"",run:()=>{Ge({do:"named",to:"random"})}},{name:"Play or pause",keys:"Space",run:eg},{name:"Add a keyframe",keys:"K",run:Q_},{name:"Ghosts of all solutions",keys:"G",run:kf},{name:"Next solution",keys:"]",run:()=>Pm(1)},{name:"Previous solution",keys:"[",run:()=>Pm(-1)},{name:"Link frames",keys:"T",run:bl(ot.frames)},{name:"Collision shapes",keys:"C",run:bl(ot.collision)},{name:"Outline of the reach",keys:"O",run:bl(ot.outline)},{name:"Move the tool by a gizmo",keys:"W",run:Dm("translate")},{name:"Turn the tool by a gizmo",keys:"E",run:Dm("rotate")},{name:"Gizmo in the tool’s or the base’s axes",keys:"X",run:bl(ot.local)},{name:"Snapshot",keys:"P",run:()=>{Og()}},{name:"Snapshot: size, background, what is in it",keys:"",run:()=>Si.value="picture"},{name:"Share this view as one file",keys:"",run:()=>location.assign("/api/share.html")},{name:"Units",keys:"U",run:Bf},{name:"Plots",keys:"",run:()=>gi.value=gi.value==="plots"?null:"plots"},{name:"Formulas",keys:"",run:()=>gi.value=gi.value==="formulas"?null:"formulas"},{name:"Script",keys:"",run:()=>gi.value=gi.value==="script"?null:"script"},{name:"Stop the script",keys:"",run:Ju},{name:"Controller of a real arm",keys:"",run:()=>gi.value=gi.value==="controller"?null:"controller"},{name:"Stop the real arm",keys:"Escape",run:nf},{name:"Paste joint values",keys:"Ctrl+V",run:ng},{name:"Undo",keys:"Ctrl+Z",run:()=>{Ge({do:"undo"})}},{name:"Redo",keys:"Ctrl+Shift+Z",run:()=>{Ge({do:"redo"})}},{name:"Save the project",keys:"Ctrl+S",run:()=>location.assign("/api/project.json?download")},{name:"All commands",keys:"Ctrl+K",run:()=>Si.value="palette"},{name:"Keys and gestures",keys:"?",run:()=>Si.value="help"}];function w1(){addEventListener("keydown",n=>{if(n.key==="Escape"&&Ms.value.live)return nf();const e=n.target instanceof HTMLElement&&n.target.closest("input:not([type=range]):not([type=checkbox]), textarea, select, .cm-editor, dialog");if(n.ctrlKey||n.metaKey){const s=`Ctrl+${n.shiftKey?"Shift+":""}${n.key.toUpperCase()}`,r=oc.find(o=>o.keys===s);return!r||s==="Ctrl+V"||e&&s!=="Ctrl+K"?void 0:(n.preventDefault(),r.run())}if(e||n.altKey||!Rl.value||Si.value)return;const t=n.key===" "?"Space":n.key.length===1?n.key.toUpperCase():"";if(t==="Space"&&n.target instanceof HTMLElement&&n.target.closest("button, input"))return;const i=oc.find(s=>s.keys===t);!i||t===""||(n.preventDefault(),i.run())})}function zf({title:n,children:e}){const t=ui(null);return _0(()=>t.current?.showModal(),[]),v("dialog",{ref:t,"aria-label":n,onClose:()=>Si.value=null,onClick:i=>{i.target===t.current&&t.current?.close()},children:v("div",{class:"dialog-body",children:[v("div",{class:"row spread",children:[v("h2",{children:n}),v(yt,{icon:"close",label:"Close",onClick:()=>t.current?.close()})]}),e]})})}const T1=[["Drag a link","turn its joint"],["Ctrl + drag a link","the whole arm follows"],["Drag empty space","turn the view"],["Right or Shift + drag","shift the view"],["Wheel, pinch","zoom to the pointer"],["Double-click a link","turn about it"],["Esc while dragging","back to where it began"],["Touch: hold, then drag","take hold of a link"]];function A1(){return v(zf,{title:"Keys and gestures",children:[v("div",{class:"sheet",children:[v("dl",{children:T1.map(([n,e])=>v(jn,{children:[v("dt",{children:n},n),v("dd",{children:e})]}))}),v("dl",{children:oc.filter(n=>n.keys).map(n=>v(jn,{children:[v("dt",{children:v("kbd",{children:n.keys})},n.name),v("dd",{children:n.name})]}))})]}),v("label",{class:"check",children:[v("input",{type:"checkbox",checked:Rl.value,onChange:n=>{Rl.value=n.currentTarget.checked,xs("letters",Rl.value?"on":"off")}})," Single letters act as keys"]}),v("label",{class:"check",children:[v("input",{type:"checkbox",checked:hc.value,onChange:n=>kg(n.currentTarget.checked)})," Dragging empty space turns the view freely, over the poles as well"]})]})}function R1(){const[n,e]=vo(""),[t,i]=vo(0),s=oc.filter(o=>o.name.toLowerCase().includes(n.toLowerCase())),r=o=>{Si.value=null,s[o]?.run()};return v(zf,{title:"Commands",children:[v("input",{class:"search",type:"text",role:"combobox","aria-expanded":"true","aria-controls":"palette-list","aria-label":"Search commands",placeholder:"Search commands",value:n,autofocus:!0,onInput:o=>{e(o.currentTarget.value),i(0)},onKeyDown:o=>{(o.key==="ArrowDown"||o.key==="ArrowUp")&&(o.preventDefault(),i((t+(o.key==="ArrowDown"?1:s.length-1))%Math.max(1,s.length))),o.key==="Enter"&&r(t)}}),v("ul",{class:"palette",id:"palette-list",role:"listbox","aria-label":"Commands",children:s.map((o,a)=>v("li",{role:"option","aria-selected":a===t,onClick:()=>r(a),children:[v("span",{children:o.name}),o.keys&&v("kbd",{children:o.keys})]},o.name))})]})}function C1(){const{scale:n,transparent:e,overlays:t}=Bl;return v(zf,{title:"A picture of the view",children:[v("div",{class:"row",children:[v("span",{class:"quiet",children:"Size"}),v(uo,{label:"Size",value:String(n.value),options:[["1","1×"],["2","2×"],["4","4×"]],onChange:i=>n.value=Number(i)})]}),v("label",{class:"check",children:[v("input",{type:"checkbox",checked:e.value,onChange:i=>e.value=i.currentTarget.checked})," Transparent background"]}),v("label",{class:"check",children:[v("input",{type:"checkbox",checked:t.value,onChange:i=>t.value=i.currentTarget.checked})," Ground, frames, ways and ghosts, as they are shown"]}),v("div",{class:"row",children:v("button",{type:"button",class:"text-button go",onClick:()=>{Si.value=null,Og()},children:"Save as PNG"})})]})}function P1(){return v(jn,{children:[Si.value==="help"&&v(A1,{}),Si.value==="palette"&&v(R1,{}),Si.value==="picture"&&v(C1,{}),co.value==="lost"&&v("div",{class:"notice",role:"alert",children:[v(Ei,{name:"warn"})," The connection to the program is lost. Trying again…"]}),co.value==="refused"&&v("div",{class:"notice",role:"alert",children:[v(Ei,{name:"warn"})," ",e_.value]}),v("div",{class:"toasts",children:aa.value.map(n=>v("div",{class:`toast ${n.kind}`,role:n.kind==="error"?"alert":"status",children:n.text},n.id))}),!ef.value&&v("div",{class:"hint",role:"note",children:[v("p",{children:[v("strong",{children:"Drag a link"})," to turn its joint."]}),v("p",{children:[v("strong",{children:"Ctrl + drag"})," pulls the whole arm."]}),v("p",{children:[v("strong",{children:"?"})," shows every key and gesture."]}),v("button",{type:"button",class:"link",onClick:i_,children:"Got it"})]}),v("div",{class:"visually-hidden","aria-live":"polite",children:n_.value})]})}const D1={theta:"θ",alpha:"α",d:"d",a:"a"};function Bg({links:n,at:e}){const t=n[e],i=n.flatMap((s,r)=>s.parent===e?[r]:[]);return v("li",{children:[v("span",{children:t.name}),t.joint&&v("span",{class:"quiet small",children:[" by ",t.joint,", ",t.how]}),i.length>0&&v("ul",{children:i.map(s=>v(Bg,{links:n,at:s},s))})]})}function L1(){const n=rn.value;return n?v("section",{"aria-label":"Robot",children:[v("h2",{children:n.name}),n.summary&&v("p",{class:"quiet",children:n.summary}),n.problems.map(e=>v("p",{class:"banner",children:[v(Ei,{name:"warn"})," ",e]},e)),n.table&&v("div",{class:"scroll",children:v("table",{class:"dh",children:[v("caption",{children:[n.table.convention==="standard"?"Standard":"Modified"," Denavit-Hartenberg"]}),v("thead",{children:v("tr",{children:[v("th",{scope:"col",children:"#"}),n.table.columns.map(e=>v("th",{scope:"col",children:D1[e]??e},e))]})}),v("tbody",{children:n.table.rows.map((e,t)=>v("tr",{children:[v("th",{scope:"row",children:t+1}),e.map((i,s)=>v("td",{children:i},s))]},t))})]})}),n.tree&&v("ul",{class:"tree","aria-label":"Links",children:n.tree.flatMap((e,t)=>e.parent===null?[v(Bg,{links:n.tree,at:t},t)]:[])}),n.parameters.length>0&&v("dl",{class:"facts",children:n.parameters.map(([e,t])=>v(jn,{children:[v("dt",{children:e},e),v("dd",{children:t??"?"})]}))}),v("dl",{class:"facts",children:n.facts.map(([e,t])=>v(jn,{children:[v("dt",{children:e},e),v("dd",{children:t})]}))}),n.source&&v("p",{class:"quiet small",children:n.source})]}):null}const ra=[["joints","Joints"],["tool","Tool"],["ik","Solutions"],["robot","Robot"]];function I1(){const n=Oc.value,e=(gs.value?.solutions.length??0)+(gs.value?.families.length??0),t=i=>{const s={ArrowRight:1,ArrowLeft:3}[i.key];if(s===void 0)return;const r=(ra.findIndex(([o])=>o===n)+s)%ra.length;Oc.value=ra[r][0],document.getElementById(`tab-${ra[r][0]}`)?.focus()};return v("aside",{class:"panel","aria-label":"Control panel",children:[v(J_,{label:"Width of the side panel",size:$l.panel,name:"panel",from:"right",least:300,most:()=>Math.max(300,Math.round(.6*innerWidth))}),v("div",{class:"tabs",role:"tablist","aria-label":"Control panel",onKeyDown:t,children:ra.map(([i,s])=>v("button",{type:"button",id:`tab-${i}`,role:"tab","aria-selected":n===i,"aria-controls":"panel-body",tabIndex:n===i?0:-1,onClick:()=>Oc.value=i,children:[s,i==="ik"&&e>0&&v("span",{class:"badge",children:e})]},i))}),v("div",{class:"panel-body",id:"panel-body",role:"tabpanel","aria-labelledby":`tab-${n}`,tabIndex:0,children:[v("fieldset",{class:"bare",disabled:Lo,children:[n==="joints"&&v(hy,{}),n==="tool"&&v(Y0,{}),n==="ik"&&v(y1,{})]}),n==="robot"&&v(L1,{})]}),v(U1,{})]})}function U1(){const n=ns.value?.tool;return n?v("dl",{class:"readout","aria-label":"Tool position",children:[["X","Y","Z"].map((e,t)=>v("div",{children:[v("dt",{class:`axis axis-${e.toLowerCase()}`,children:e}),v("dd",{children:Ws(n.position[t],"length",_t.value)})]},e)),v("div",{children:v("dt",{children:_t.value.length})})]}):null}function N1(){return br(()=>Jt(()=>{document.documentElement.dataset.theme=Sr.value?"dark":"light"}),[]),br(()=>Jt(()=>{const{style:n}=document.documentElement;n.setProperty("--panel-width",`${$l.panel.value}px`),n.setProperty("--drawer-height",`${$l[Dl()].value}px`)}),[]),v("div",{class:`app ${zs.value?"":"no-panel"}`,children:[v(E1,{}),v("main",{class:"stage","aria-label":"3D view",children:v(d1,{})}),zs.value&&v(I1,{}),v(ny,{}),v(W0,{}),v(P1,{})]})}f0(v(N1,{}),document.getElementById("app"));w1();ay();window.pieperConnection=bi;bi.open();
