var wt,qp,$p,Ts,ch,bl,jp,ul,Zp,xu,hh,ya=Symbol.for("pv"),wl={},Tl=[],mg=/^m(i|n|o|s|text|space)$/,Mu=Array.isArray,yu=Tl.slice,hr=Object.assign;function ar(n){n&&n.parentNode&&n.remove()}function _g(n,e,t){var i,s,r,o={},a=arguments.length;for(r in e)r=="key"?i=e[r]:r=="ref"&&typeof n!="function"?s=e[r]:o[r]=e[r];return a>2&&(o.children=a>3?yu.call(arguments,2):t),Qo(n,o,i,s,null)}function Qo(n,e,t,i,s){var r={type:n,props:e,key:t,ref:i,__k:null,__:null,__b:0,__e:null,__c:null,constructor:ya,__v:s||++qp,__i:-1,__u:0};return!s&&wt.vnode&&wt.vnode(r),r}function xi(n){return n.children}function ea(n,e){this.props=n,this.context=e,this.__g=0}function Us(n,e){if(e==null)return n.__&&Us(n.__,n.__i+1);for(var t;e<n.__k.length;e++)if((t=n.__k[e])&&t.__e)return t.__e;return typeof n.type!="function"||n.props.__P?null:Us(n)}function gg(n){var e,t=n.__v,i=t.__e,s=[],r=[],o=n.__P;o&&((e=hr({constructor:ya},t)).__v=t.__v+1,wt.vnode&&wt.vnode(e),Su(o,e,t,n.__n,o.namespaceURI,32&t.__u?[i]:null,s,i||Us(t),32&t.__u,r),e.__v=t.__v,e.__.__k[e.__i]=e,nm(s,e,r),t.__=t.__e=null,e.__e!=i&&Kp(e))}function Kp(n){if((n=n.__)&&n.__c&&!n.props.__P)return n.__e=null,n.__k.some(function(e){return e&&(n.__e=e.__e)}),Kp(n)}function Rf(n){(8&n.__g||(n.__g|=8,Ts.push(n),bl++))&&ch==wt.debounceRendering||((ch=wt.debounceRendering)||queueMicrotask)(Jp)}function Jp(){try{for(var n,e=1;Ts.length;)Ts.length>e&&Ts.sort(jp),n=Ts.shift(),e=Ts.length,8&n.__g&&gg(n)}finally{(bl=Ts.length)&&(ch||queueMicrotask)(Jp)}}function Qp(n,e,t,i,s,r,o,a,l,c,h){var f,d,u,_,v,m,p=i.__k||Tl,y=e.length;for(l=vg(t,e,p,l,y),f=0;f<y;f++)(u=t.__k[f])!=null&&(d=~u.__i&&p[u.__i]||wl,u.__i=f,m=Su(n,u,d,s,r,o,a,l,c,h),_=u.__e,(d.ref!=u.ref||8&d.__u)&&(d.ref&&Eu(d.ref,null,u,d),u.ref&&h.push(u.ref,u.__c||_,u)),v=v||_,4&u.__u?(l=em(u,l,n,!d.__v),d.__e&&(d.__e=null)):typeof u.type=="function"&&m!==void 0?l=m:_&&(l=_.nextSibling),u.__u&=-21);return t.__e=v,l}function vg(n,e,t,i,s){var r,o,a,l,c,h,f,d,u,_=t.length,v=_,m=0,p=0,y=n.__k=Array(s);for(r=0;r<s;r++)(o=e[r])!=null&&typeof o!="boolean"&&typeof o!="function"?(typeof o!="object"||o.constructor===String?o=y[r]=Qo(null,o):Mu(o)?o=y[r]=Qo(xi,{children:o}):o.constructor===ya&&o.__b?o=y[r]=Qo(o.type,o.props,o.key,o.ref,o.__v):y[r]=o,l=r+m,o.__=n,o.__b=n.__b+1,a=null,~(c=o.__i=xg(o,t,l,v))&&(v--,(a=t[c])&&(a.__u|=2)),a&&a.__v?(o.__u|=16,c==l-1?m--:c==l+1?m++:c!=l&&(c>l?m--:m++,p=1)):(~c||(s>_?m--:s<_&&m++),typeof o.type!="function"&&(o.__u|=4))):y[r]=null;if(p){for(h=[],f=[],r=0;r<s;r++)if((o=y[r])&&16&o.__u){for(m=0,d=h.length;m<d;)h[u=m+d>>1]<o.__i?m=u+1:d=u;h[m]=o.__i,f[r]=m+1}for(m=h.length;r--;)f[r]&&(f[r]==m?m--:y[r].__u|=4)}if(v)for(r=0;r<_;r++)!(a=t[r])||2&a.__u||(a.__e==i&&(i=Us(a)),bu(a,a));return i}function em(n,e,t,i){var s,r,o,a;if(typeof n.type=="function"){if(n.props.__P)return e;if(s=n.__k)for(r=0;r<s.length;r++)s[r]&&(s[r].__=n,e=em(s[r],e,t,!1));return e}for(e&&!e.parentNode&&(e=Us(n))&&!e.parentNode&&(e=null),o=n.__e,a=e;a&&a.nodeType==8;)a=a.nextSibling;for(o!=a&&(!i&&t.moveBefore&&o.parentNode?t.moveBefore(o,e):t.insertBefore(o,e||null)),e=o;(e=e&&e.nextSibling)&&e.nodeType==8&&!e.data.startsWith("$s"););return e}function xg(n,e,t,i){var s,r=n.key,o=n.type,a=e[t],l=a&&!(2&a.__u);if(a===null&&r==null||l&&r==a.key&&o==a.type)return t;if(i>(l?1:0)){for(s=t-1;s>=0;s--)if((a=e[s])&&!(2&a.__u)&&r==a.key&&o==a.type)return s;for(s=t+1;s<e.length;s++)if((a=e[s])&&!(2&a.__u)&&r==a.key&&o==a.type)return s}return-1}function Cf(n,e,t){t==null&&(t=""),e[0]=="-"?n.setProperty(e,t):n[e]=t}function Pa(n,e,t,i,s){var r,o;if(e=="style")if(typeof t=="string")n.style.cssText=t;else{if(typeof i=="string"&&(n.style.cssText=i=""),i)for(e in i)t&&e in t||Cf(n.style,e);if(t)for(e in t)i&&t[e]==i[e]||Cf(n.style,e,t[e])}else if(e[0]=="o"&&e[1]=="n")typeof t!="function"&&(t=null),typeof i!="function"&&(i=null),(n.__e||(n.__e={}))[e]=t,t&&i||(o=hh[e]||(hh[e]=Mg(e)),(n.__a||(n.__a={}))[e]=xu,r=e!=(e=e.replace(Zp,"$1")),(e=e.slice(2))[0]<"a"&&(e=e.toLowerCase()),t?n.addEventListener(e,o,r):n.removeEventListener(e,o,r));else{if(s=="http://www.w3.org/2000/svg")e=e.replace(/xlink(H|:h)/,"h").replace(/sName$/,"s");else if(e!="width"&&e!="height"&&e!="href"&&e!="list"&&e!="form"&&e!="tabIndex"&&e!="download"&&e!="rowSpan"&&e!="colSpan"&&e!="role"&&e!="popover"&&e in n)try{return void(n[e]=t??"")}catch{}if(typeof t=="function")return;t==null||t===!1&&e[4]!="-"?n.removeAttribute(e):n.setAttribute(e,e=="popover"&&t==1?"":t)}}function Mg(n){return function(e){var t=this.__e;if(t){if(t=t[n],e[ul]==null)e[ul]=xu++;else if(e[ul]<this.__a[n])return;return t(wt.event?wt.event(e):e)}}}function Su(n,e,t,i,s,r,o,a,l,c){var h,f,d,u,_,v,m,p,y,w,x,L,A,U,N,b,E,C,B=e.type;if(e.constructor!==ya)return null;128&t.__u&&(l=32&t.__u,h=t.__c.__z)&&(e.__u|=l,f=r=[],h.nodeType==8?a=fl(h,r):r.push(h),a=r[0]||a),(h=wt.__b)&&h(e);e:if(typeof B=="function"){d=o.length;try{if(p=e.props,y=(h=B.prototype)&&h.render,w=(h=B.contextType)&&i[h.__c],x=h?w?w.props.value:h.__:i,(u=t.__c)?(e.__c=u,2&u.__g&&(u.__g|=1)):(y?e.__c=u=new B(p,x):(e.__c=u=new ea(p,x),u.constructor=B,u.render=Sg),w&&w.sub(u),u.state||(u.state={}),u.__n=i,u.__g|=8,u.__h=[],u.__k=[]),y&&(u.__s||(u.__s=u.state),B.getDerivedStateFromProps&&(u.__s==u.state&&(u.__s=hr({},u.__s)),hr(u.__s,B.getDerivedStateFromProps(p,u.__s)))),_=u.props,v=u.state,u.__v=e,t.__c){if(p!==_&&y&&!B.getDerivedStateFromProps&&u.componentWillReceiveProps&&u.componentWillReceiveProps(p,x),e.__v==t.__v&&!(8&u.__g)||!(4&u.__g)&&u.shouldComponentUpdate&&u.shouldComponentUpdate(p,u.__s,x)===!1){e.__v!=t.__v&&(u.props=p,u.state=u.__s,u.__g&=-9),e.__e=t.__e,e.__k=t.__k,e.__k.some(function(z){z&&(z.__=e)}),Tl.push.apply(u.__h,u.__k),u.__k=[],u.__h.length&&o.push(u),a=Us(t);break e}u.componentWillUpdate&&u.componentWillUpdate(p,u.__s,x),y&&u.componentDidUpdate&&u.__h.push(function(){u.componentDidUpdate(_,v,m)})}else y&&!B.getDerivedStateFromProps&&u.componentWillMount&&u.componentWillMount(),y&&u.componentDidMount&&u.__h.push(u.componentDidMount);u.context=x,u.props=p,u.__P=n,u.__g&=-5,L=wt.__r,A=y?25:0;do u.__g&=-9,L&&L(e),h=u.render(u.props,u.state=u.__s,u.context);while(8&u.__g&&++A<25);y&&(Tl.push.apply(u.__h,u.__k),u.__k=[]),u.state=u.__s,u.getChildContext&&(i=hr({},i,u.getChildContext())),y&&t.__c&&u.getSnapshotBeforeUpdate&&(m=u.getSnapshotBeforeUpdate(_,v)),U=h&&h.type===xi&&h.key==null?h.props.children:h,p.__P&&(h=a,s=(n=p.__P).namespaceURI,l=r=null,t.props&&t.props.__P!=n&&(t.__k.some(function(z){z&&bu(z,z)}),t.__k=null),a=t.__k?Us(t,0):null),a=Qp(n,Mu(U)?U:[U],e,t,i,s,r,o,a,l,c),p.__P&&(e.__e=null,a=h),e.__u&=-161,f&&f.some(ar),u.__h.length&&o.push(u),1&u.__g&&(u.__g&=-4)}catch(z){if(o.length=d,e.__v=null,l||r)if(z&&z.then){if(e.__u|=128|l,r){for(~(E=r.indexOf(a||void 0))||(E=r.length);(C=r[E-1])&&C.nodeType==8;)E--;for(;E<r.length;E++)if(C=r[E])if(r[E]=null,N){if(C==b)break}else{if(C.nodeType!=8)break;C.data.startsWith("$s")&&(b=fl(N=C))}}if(!N){for(;a&&a.nodeType==8&&a.nextSibling;)a=a.nextSibling;N=a}(h=fl(N=e.__c.__z||(e.__c.__z=N)))?(e.__e=N,a=h):e.__e=a,a=a&&a.nextSibling}else r&&r.some(ar);else e.__e=t.__e;e.__k||(e.__k=t.__k||[]),z&&z.then||tm(e),wt.__e(z,e,t)}}else a=e.__e=yg(t.__e,e,t,i,s,r,o,l,c,n);return(h=wt.diffed)&&h(e),a}function fl(n,e){if(n&&n.nodeType==8&&n.data.startsWith("$s"))for(var t=1;n=n.nextSibling;){if(n.nodeType==8){if(n.data.startsWith("$s"))t++;else if(n.data.startsWith("/$s")&&!--t)return n}e&&e.push(n)}}function tm(n){n&&(n.__c&&(n.__c.__g|=4),n.__k&&n.__k.some(tm))}function nm(n,e,t){for(var i=0;i<t.length;)Eu(t[i++],t[i++],t[i++]);wt.__c&&wt.__c(e,n),n.some(function(s){try{n=s.__h,s.__h=[],n.some(function(r){r.call(s)})}catch(r){wt.__e(r,s.__v)}})}function yg(n,e,t,i,s,r,o,a,l,c){var h,f,d,u,_,v,m,p,y=t.props||wl,w=e.props,x=e.type;if(x=="svg"?s="http://www.w3.org/2000/svg":x=="math"?s="http://www.w3.org/1998/Math/MathML":s||(s="http://www.w3.org/1999/xhtml"),r){for(h=0;h<r.length;h++)if((_=r[h])&&(x?_.localName==x:_.nodeType==3)){n=_,r[h]=null;break}}if(!n){if(p=c.ownerDocument||document,!x)return p.createTextNode(w);n=p.createElementNS(s,x,w.is?w:c),a&&(wt.__m&&wt.__m(e,r),a=!1),r=null}if(x){if(c=x=="template"&&n.content||n,r=x=="textarea"&&w.defaultValue!=null?null:r&&yu.call(c.childNodes),!a&&r)for(y={},h=0;h<n.attributes.length;h++)y[(_=n.attributes[h]).name]=_.value;for(h in y)_=y[h],h=="dangerouslySetInnerHTML"?d=_:h=="children"||h in w||h=="value"&&"defaultValue"in w||h=="checked"&&"defaultChecked"in w||Pa(n,h,null,_,s);for(h in w)_=w[h],h=="children"?u=_:h=="dangerouslySetInnerHTML"?f=_:h=="value"?v=_:h=="checked"?m=_:a&&typeof _!="function"||y[h]===_||Pa(n,h,_,y[h],s);f?(a||d&&(f.__html==d.__html||f.__html==n.innerHTML)||(n.innerHTML=f.__html),e.__k=[]):(d&&(n.textContent=""),(x=="foreignObject"||s=="http://www.w3.org/1998/Math/MathML"&&mg.test(x))&&(s="http://www.w3.org/1999/xhtml"),Qp(c,Mu(u)?u:[u],e,t,i,s,r,o,r?r[0]:t.__k&&Us(t,0),a,l),r&&r.some(ar)),a&&x!="textarea"||(h="value",x=="progress"&&v==null?n.removeAttribute(h):v==null||v===n[h]&&(x!="progress"||v)||Pa(n,h,v,y[h],s),h="checked",m!=null&&m!=n[h]&&Pa(n,h,m,y[h],s))}else y===w||a&&n.data==w||(n.data=w);return n}function Eu(n,e,t,i){try{typeof n=="function"?e?e.__x=n(e)||1:i&&(i=i.__c||i.__e)&&(e=i.__x)&&(i.__x=null,typeof e=="function"?e():n(null)):n.current=e}catch(s){wt.__e(s,t)}}function bu(n,e,t){var i,s,r,o;if(wt.unmount&&wt.unmount(n),!(i=n.ref)||i.current&&i.current!=n.__e||Eu(i,null,e,n),i=n.__c){if(i.componentWillUnmount)try{i.componentWillUnmount()}catch(a){wt.__e(a,e)}i.__P=i.__n=null}if(i=n.__k)for(o=0;o<i.length;o++)i[o]&&bu(i[o],e,typeof n.type!="function"||t&&!n.props.__P);!t&&(i=n.__c)&&(i=i.__z)&&(s=fl(i,r=[]))&&(i==n.__e&&r.some(ar),ar(s),ar(i)),t||ar(n.__e),n.__e=n.__c=n.__=null}function Sg(n,e,t){return this.constructor(n,t)}function Eg(n,e){var t,i,s,r;wt.__&&wt.__(n,e),e.nodeType==9&&(e=e.documentElement),i=(t=n&&32&n.__u)?null:e.__k,e.__k=Qo(xi,{children:[n]}),s=[],r=[],Su(e,e.__k,i||wl,wl,e.namespaceURI,i?null:e.firstChild?yu.call(e.childNodes):null,s,i?i.__e:e.firstChild,t,r),nm(s,e.__k,r),e.__k.props.children=null}wt={__e:function(n,e,t,i){for(var s,r,o;e=e.__;)if((s=e.__c)&&!(1&s.__g)){s.__g|=4;try{if((o=(r=s.constructor)&&r.getDerivedStateFromError)&&s.setState(r.getDerivedStateFromError(n)),s.componentDidCatch&&(s.componentDidCatch(n,i||{}),o=1),o&&8&s.__g)return void(s.__g|=2)}catch(a){n=a}}throw bl=0,n}},qp=0,$p=function(n){return n!=null&&n.constructor===ya},ea.prototype.setState=function(n,e){var t=this.__s;t&&t!=this.state||(t=this.__s=hr({},this.state)),typeof n=="function"&&(n=n(hr({},t),this.props)),n&&(hr(t,n),this.__v&&(e&&this.__k.push(e),Rf(this)))},ea.prototype.forceUpdate=function(n){this.__v&&(this.__g|=4,n&&this.__h.push(n),Rf(this))},ea.prototype.render=xi,Ts=[],bl=0,jp=function(n,e){return n.__v.__b-e.__v.__b},ul=Symbol(),Zp=/(PointerCapture)$|Capture$/i,xu=0,hh={};var bg=Symbol.for("pv"),wg=0;function R(n,e,t,i,s,r){e||(e={});var o,a,l=e;if("ref"in l&&typeof n!="function")for(a in l={},e)a=="ref"?o=e[a]:l[a]=e[a];var c={type:n,props:l,key:t,ref:o,__k:null,__:null,__b:0,__e:null,__c:null,constructor:bg,__v:--wg,__i:-1,__u:0};return wt.vnode&&wt.vnode(c),c}var la,dn,gc,Pf,uh=Object.is,Al=0,im=[],fh=[],ln=wt,Df=ln.__b,Lf=ln.__r,If=ln.diffed,Uf=ln.__c,Nf=ln.unmount,Ff=ln.__;function wu(n,e){ln.__h&&ln.__h(dn,n,Al||e),Al=0;var t=dn.__H||(dn.__H={__:[],__h:[]});return n>=t.__.length&&t.__.push({}),t.__[n]}function dh(n){return Al=1,Tg(rm,n)}function Tg(n,e,t){var i=wu(la++,2);if(i.t=n,!i.__c&&(i.__=[rm(void 0,e),function(r){var o=(i.__N||i.__)[0],a=i.t(o,r);uh(o,a)||(i.__N=[a,i.__[1]],i.__c.setState({}))}],i.__c=dn,!dn.__f)){dn.__f=!0;var s=dn.shouldComponentUpdate;dn.shouldComponentUpdate=function(r,o,a){var l=this.__H;if(!l)return!0;var c=!1,h=this.props!=r;if(l.__.some(function(d){d.__N&&(c=!0,uh(d.__[0],d.__N[0])||(h=!0))}),s){var f=s.call(this,r,o,a);return c?f||h:f}return!c||h}}return i.__}function Gl(n,e){var t=wu(la++,3);!ln.__s&&sm(t.__H,e)&&(t.__P=!0,t.__=n,t.u=e,dn.__H.__h.push(t))}function no(n){return Al=5,Tu(function(){return{current:n}},[])}function Tu(n,e){var t=wu(la++,7);return sm(t.__H,e)&&(t.__=n(),t.__H=e),t.__}function Ag(){var n;do{for(;n=fh.shift();)try{ta(n)}catch(t){ln.__e(t,{__:(n=n.__P)&&n.__v})}for(;n=im.shift();){var e=n.__H;if(n.__P&&e)try{e.__h.some(ta),e.__h.some(ph),e.__h=[]}catch(t){e.__h=[],ln.__e(t,n.__v)}}}while(fh.length)}ln.__b=function(n){dn=null,Df&&Df(n)},ln.__=function(n,e){n&&e.__k&&e.__k.__m&&(n.__m=e.__k.__m),Ff&&Ff(n,e)},ln.__r=function(n){Lf&&Lf(n),la=0;var e=(dn=n.__c).__H;e&&(gc==dn?dn.__h=[]:(e.__h.some(ta),e.__h.some(ph),la=0),e.__h=[],e.__.some(function(t){t.__N&&(t.__=t.__N),t.u=t.__N=void 0})),gc=dn},ln.diffed=function(n){If&&If(n);var e=n.__c;e&&e.__H&&(e.__H.__h.length&&kf(im.push(e)),e.__H.__.some(function(t){t.u&&(t.__H=t.u)})),gc=dn=null},ln.__c=function(n,e){e.some(function(t){try{t.__h.some(ta),t.__h=t.__h.filter(function(i){return!i.__||ph(i)})}catch(i){t.__h=[function(){throw i}]}}),Uf&&Uf(n,e)},ln.unmount=function(n){Nf&&Nf(n);var e,t,i=n.__c;i&&i.__H&&(i.__H.__.some(function(s){try{if(s.__P&&s.__c){if(t===void 0){for(t=n.__;t&&(!t.__c||!t.__c.__P);)t=t.__;t=t&&t.__c}s.__P=t,kf(fh.push(s))}else ta(s)}catch(r){e=r}}),i.__H=void 0,e&&ln.__e(e,i.__v))};var Of=typeof requestAnimationFrame=="function";function Rg(n){var e,t=function(){clearTimeout(i),Of&&cancelAnimationFrame(e),setTimeout(n)},i=setTimeout(t,35);Of&&(e=requestAnimationFrame(t))}function kf(n){n!=1&&Pf==ln.requestAnimationFrame||((Pf=ln.requestAnimationFrame)||Rg)(Ag)}function ta(n){var e=dn,t=n.__c;typeof t=="function"&&(n.__c=void 0,t()),dn=e}function ph(n){var e=dn;n.__c=n.__(),dn=e}function sm(n,e){return!n||n.length!=e.length||e.some(function(t,i){return!uh(t,n[i])})}function rm(n,e){return typeof e=="function"?e(n):e}var Cg=Symbol.for("preact-signals");function Wl(){if(is>1)is--;else{var n,e=!1;for((function(){var s=Cl;for(Cl=void 0;s!==void 0;){var r=s.S;if(r.v===s.v)for(var o=r.t;o!==void 0;o=o.x)o.i===s.i&&(o.i=r.i);s=s.o}})();ia!==void 0;){var t=ia;for(ia=void 0,Rl++;t!==void 0;){var i=t.u;if(t.u=void 0,t.f&=-3,!(8&t.f)&&am(t))try{t.c()}catch(s){e||(n=s,e=!0)}t=i}}if(Rl=0,is--,e)throw n}}function Pg(n){if(is>0)return n();mh=++Dg,is++;try{return n()}finally{Wl()}}var na,Kt=void 0;function Xl(n){var e=Kt,t=na;Kt=void 0,na=void 0;try{return n()}finally{Kt=e,na=t}}var ia=void 0,is=0,Rl=0,Dg=0,mh=0,Cl=void 0,Pl=0;function om(n){if(Kt!==void 0){var e=n.n;if(e===void 0||e.t!==Kt)return e={i:0,S:n,p:Kt.s,n:void 0,t:Kt,e:void 0,x:void 0,r:e},Kt.s!==void 0&&(Kt.s.n=e),Kt.s=e,n.n=e,32&Kt.f&&n.S(e),e;if(e.i===-1)return e.i=0,e.n!==void 0&&(e.n.p=e.p,e.p!==void 0&&(e.p.n=e.n),e.p=Kt.s,e.n=void 0,Kt.s.n=e,Kt.s=e),e}}function Pn(n,e){this.v=n,this.i=0,this.n=void 0,this.t=void 0,this.l=0,this.W=e?.watched,this.Z=e?.unwatched,this.name=e?.name}Pn.prototype.brand=Cg;Pn.prototype.h=function(){return!0};Pn.prototype.S=function(n){var e=this,t=this.t;t!==n&&n.e===void 0&&(n.x=t,this.t=n,t!==void 0?t.e=n:Xl(function(){var i;(i=e.W)==null||i.call(e)}))};Pn.prototype.U=function(n){var e=this;if(this.t!==void 0){var t=n.e,i=n.x;t!==void 0&&(t.x=i,n.e=void 0),i!==void 0&&(i.e=t,n.x=void 0),n===this.t&&(this.t=i,i===void 0&&Xl(function(){var s;(s=e.Z)==null||s.call(e)}))}};Pn.prototype.subscribe=function(n){var e=this;return An(function(){var t=e.value;Xl(function(){return n(t)})},{name:"sub"})};Pn.prototype.valueOf=function(){return this.value};Pn.prototype.toString=function(){return this.value+""};Pn.prototype.toJSON=function(){return this.value};Pn.prototype.peek=function(){var n=this;return Xl(function(){return n.value})};Object.defineProperty(Pn.prototype,"value",{get:function(){var n=om(this);return n!==void 0&&(n.i=this.i),this.v},set:function(n){if(n!==this.v){if(Rl>100)throw new Error("Cycle detected");(function(t){is!==0&&Rl===0&&t.l!==mh&&(t.l=mh,Cl={S:t,v:t.v,i:t.i,o:Cl})})(this),this.v=n,this.i++,Pl++,is++;try{for(var e=this.t;e!==void 0;e=e.x)e.t.N()}finally{Wl()}}}});function ct(n,e){return new Pn(n,e)}function am(n){for(var e=n.s;e!==void 0;e=e.n)if(e.S.i!==e.i||!e.S.h()||e.S.i!==e.i)return!0;return!1}function lm(n){for(var e=n.s;e!==void 0;e=e.n){var t=e.S.n;if(t!==void 0&&(e.r=t),e.S.n=e,e.i=-1,e.n===void 0){n.s=e;break}}}function cm(n){for(var e=n.s,t=void 0;e!==void 0;){var i=e.p;e.i===-1?(e.S.U(e),i!==void 0&&(i.n=e.n),e.n!==void 0&&(e.n.p=i)):t=e,e.S.n=e.r,e.r!==void 0&&(e.r=void 0),e=i}n.s=t}function _r(n,e){Pn.call(this,void 0,e),this.x=n,this.s=void 0,this.g=Pl-1,this.f=4}_r.prototype=new Pn;_r.prototype.h=function(){if(this.f&=-3,1&this.f)return!1;if((36&this.f)==32||(this.f&=-5,this.g===Pl))return!0;if(this.g=Pl,this.f|=1,this.i>0&&!am(this))return this.f&=-2,!0;var n=Kt;try{lm(this),Kt=this;var e=this.x();(16&this.f||this.v!==e||this.i===0)&&(this.v=e,this.f&=-17,this.i++)}catch(t){this.v=t,this.f|=16,this.i++}return Kt=n,cm(this),this.f&=-2,!0};_r.prototype.S=function(n){if(this.t===void 0){this.f|=36;for(var e=this.s;e!==void 0;e=e.n)e.S.S(e)}Pn.prototype.S.call(this,n)};_r.prototype.U=function(n){if(this.t!==void 0&&(Pn.prototype.U.call(this,n),this.t===void 0)){this.f&=-33;for(var e=this.s;e!==void 0;e=e.n)e.S.U(e)}};_r.prototype.N=function(){if(!(2&this.f)){this.f|=6;for(var n=this.t;n!==void 0;n=n.x)n.t.N()}};Object.defineProperty(_r.prototype,"value",{get:function(){if(1&this.f)throw new Error("Cycle detected");var n=om(this);if(this.h(),n!==void 0&&(n.i=this.i),16&this.f)throw this.v;return this.v}});function _h(n,e){return new _r(n,e)}function hm(n){var e=n.j;if(n.j=void 0,typeof e=="function"){is++;var t=Kt;Kt=void 0;try{e()}catch(i){throw n.f&=-2,n.f|=8,Au(n),i}finally{Kt=t,Wl()}}}function Au(n){for(var e=n.s;e!==void 0;e=e.n)e.S.U(e);n.x=void 0,n.s=void 0,hm(n)}function Lg(n){if(Kt!==this)throw new Error("Out-of-order effect");cm(this),Kt=n,this.f&=-2;try{8&this.f&&Au(this)}finally{Wl()}}function po(n,e){this.x=n,this.j=void 0,this.s=void 0,this.u=void 0,this.f=32,this.name=e?.name,na&&na.push(this)}po.prototype.c=function(){var n=this.S();try{if(8&this.f||this.x===void 0)return;var e=this.x();typeof e=="function"&&(this.j=e)}finally{n()}};po.prototype.S=function(){if(1&this.f)throw new Error("Cycle detected");this.f|=1,this.f&=-9,hm(this),lm(this),is++;var n=Kt;return Kt=this,Lg.bind(this,n)};po.prototype.N=function(){2&this.f||(this.f|=2,this.u=ia,ia=this)};po.prototype.d=function(){this.f|=8,1&this.f||Au(this)};po.prototype.dispose=function(){this.d()};function An(n,e){var t=new po(n,e);try{t.c()}catch(s){throw t.d(),s}var i=t.d.bind(t);return i[Symbol.dispose]=i,i}var um,Da,Ig=typeof window<"u"&&!!window.__PREACT_SIGNALS_DEVTOOLS__,fm=[];An(function(){um=this.N})();function mo(n,e){wt[n]=e.bind(null,wt[n]||function(){})}function ca(n){if(Da){var e=Da;Da=void 0,e()}Da=n&&n.S()}function dm(n){var e=this,t=n.data,i=Ng(t);i.name="ReactiveDom",i.value=t;var s=Tu(function(){for(var a=e,l=e.__v;l=l.__;)if(l.__c){l.__c.__$f|=4;break}var c=_h(function(){var u=i.value.value;return u===0?0:u===!0?"":u||""}),h=_h(function(){return!Array.isArray(c.value)&&!$p(c.value)}),f=An(function(){if(this.N=pm,h.value){var u=c.value;a.__v&&a.__v.__e&&a.__v.__e.nodeType===3&&(a.__v.__e.data=u)}}),d=e.__$u.d;return e.__$u.d=function(){f(),d.call(this)},[h,c]},[]),r=s[0],o=s[1];return r.value?o.peek():o.value}dm.displayName="ReactiveTextNode";Object.defineProperties(Pn.prototype,{constructor:{configurable:!0,value:_g(xi,null).constructor},type:{configurable:!0,value:dm},props:{configurable:!0,get:function(){var n=this;return{data:{get value(){return n.value}}}}},__b:{configurable:!0,value:1}});mo("__b",function(n,e){if(ca(),typeof e.type=="string"){var t,i=e.props;for(var s in i)if(s!=="children"){var r=i[s];r instanceof Pn&&(t||(e.__np=t={}),t[s]=r,i[s]=r.peek())}}n(e)});mo("__r",function(n,e){if(n(e),e.type!==xi){ca();var t,i=e.__c;i&&(i.__$f&=-2,(t=i.__$u)===void 0&&(i.__$u=t=(function(s,r){var o;return An(function(){o=this},{name:r}),o.c=s,o})((function(s){return function(){var r;Ig&&((r=this.y)==null||r.call(this)),s.__$f|=1,s.setState({})}})(i),typeof e.type=="function"?e.type.displayName||e.type.name:""))),ca(t)}});mo("__e",function(n,e,t,i){ca(),n(e,t,i)});mo("diffed",function(n,e){ca();var t;if(typeof e.type=="string"&&(t=e.__e)){var i=e.__np,s=e.props,r=t.U;if(r)for(var o in r){var a=r[o];a===void 0||i&&o in i||(a.d(),r[o]=void 0)}if(i){r||(r={},t.U=r);for(var l in i){var c=r[l],h=i[l];c===void 0?(c=Ug(t,l,h,s),r[l]=c):c.o(h,s)}}}n(e)});function Ug(n,e,t,i){var s=e in n&&n.ownerSVGElement===void 0,r=ct(t);return{o:function(o,a){r.value=o,i=a},d:An(function(){this.N=pm;var o=r.value.value;i[e]!==o&&(i[e]=o,s?n[e]=o:o!=null&&(o!==!1||e[4]==="-")?n.setAttribute(e,o):n.removeAttribute(e))})}}mo("unmount",function(n,e){if(typeof e.type=="string"){var t=e.__e;if(t){var i=t.U;if(i){t.U=void 0;for(var s in i){var r=i[s];r&&r.d()}}}var o=e.__np;if(o){var a=e.props;for(var l in o)a[l]=o[l]}e.__np=void 0}else{var c=e.__c;if(c){c.__$f|=8;var h=c.__$u;h&&(c.__$u=void 0,h.d())}}n(e)});mo("__h",function(n,e,t,i){i<3&&(e.__$f|=2),n(e,t,i)});ea.prototype.shouldComponentUpdate=function(n,e){if(this.__R)return!0;var t=this.__$u,i=t&&t.s!==void 0;for(var s in e)return!0;if(this.__f||typeof this.u=="boolean"&&this.u===!0){var r=2&this.__$f;if(!(i||r||4&this.__$f)||1&this.__$f)return!0}else if(!(i||4&this.__$f)||3&this.__$f)return!0;for(var o in n)if(o!=="__source"&&n[o]!==this.props[o])return!0;for(var a in this.props)if(!(a in n))return!0;return!1};function Ng(n,e){return Tu(function(){return ct(n,e)},[])}var Fg=function(n){queueMicrotask(function(){queueMicrotask(n)})};function Og(){Pg(function(){for(var n;n=fm.shift();)um.call(n)})}function pm(){fm.push(this)===1&&(wt.requestAnimationFrame||Fg)(Og)}const Bf=250,kg=5e3;class Bg{constructor(e){this.listener=e}listener;socket=null;waiting=new Map;next=1;wait=Bf;async open(){const e=/(?:^#|&)token=([0-9a-f]+)/.exec(location.hash)?.[1];if(e){const t=await fetch("/api/session",{method:"POST",body:JSON.stringify({token:e})}).catch(()=>null);if(history.replaceState(null,"",location.pathname+location.search),t&&!t.ok)return this.listener.phase("refused",await t.text())}this.connect(),setInterval(()=>this.post({ping:performance.now()}),2e3)}connect(){this.listener.phase("connecting","");const e=new WebSocket(`ws://${location.host}/ws`);e.binaryType="arraybuffer",this.socket=e,e.onopen=()=>{this.wait=Bf,this.listener.phase("open",""),this.post({ping:performance.now()})},e.onmessage=t=>{typeof t.data=="string"?this.text(JSON.parse(t.data)):this.listener.frame(t.data)},e.onclose=()=>{this.lost()}}async lost(){for(const t of this.waiting.values())t.reject(new Error("the connection was lost"));if(this.waiting.clear(),(await fetch("/api/project.json").catch(()=>null))?.status===401)return this.listener.phase("refused","This window is not signed in: open the address that the program printed.");this.listener.phase("lost",""),setTimeout(()=>this.connect(),this.wait),this.wait=Math.min(2*this.wait,kg)}text(e){if(typeof e.section=="string")return this.listener.section(e.section,e.value);if(typeof e.pong=="number")return this.listener.roundTrip(performance.now()-e.pong);if(typeof e.ack=="number"){const t=this.waiting.get(e.ack);this.waiting.delete(e.ack),typeof e.error=="string"?t?.reject(new Error(e.error)):t?.resolve(e.value);return}typeof e.event=="string"&&this.listener.event(e)}post(e){return this.socket?.readyState!==WebSocket.OPEN?!1:(this.socket.send(JSON.stringify(e)),!0)}send(e){const t=this.next++;return new Promise((i,s)=>{this.post({id:t,...e})?this.waiting.set(t,{resolve:i,reject:s}):s(new Error("not connected"))})}drop(){this.socket?.close()}}class ha{constructor(e,t=()=>{},i=()=>{}){this.send=e,this.answered=t,this.failed=i}send;answered;failed;busy=!1;latest=null;push(e){this.latest=e,this.busy||this.drain()}async drain(){for(this.busy=!0;this.latest;){const e=this.latest;this.latest=null;try{this.answered(await this.send(e))}catch(t){this.failed(t)}}this.busy=!1,this.idle.splice(0).forEach(e=>e())}idle=[];settled(){return this.busy?new Promise(e=>this.idle.push(e)):Promise.resolve()}}const Cr=16;function zg(n){if(n.byteLength<Cr+4)return null;const e=new DataView(n),t=e.getUint8(0),i=e.getUint16(2,!0),s=e.getUint32(4,!0),r=e.getUint32(Cr,!0);if(t===1){const o=Cr+4+4*r;return n.byteLength<o+64*i?null:{kind:"pose",playing:(e.getUint8(1)&1)===1,sequence:s,links:i,time:e.getFloat64(8,!0),q:new Float32Array(n,Cr+4,r),matrices:new Float32Array(n,o,16*i)}}return t===2?n.byteLength<Cr+4+64*i*r?null:{kind:"ghosts",sequence:s,links:i,count:r,matrices:new Float32Array(n,Cr+4,16*i*r)}:null}function Hg(n){if(n.byteLength<12)return null;const e=new DataView(n);if(e.getUint32(0,!0)!==827150416)return null;const t=e.getUint32(4,!0),i=e.getUint32(8,!0);return n.byteLength!==12+24*t+4*i?null:{positions:new Float32Array(n,12,3*t),normals:new Float32Array(n,12+12*t,3*t),indices:new Uint32Array(n,12+24*t,i)}}const Dl=ct([]),pn=ct(null),us=ct(null),as=ct(null),fr=ct(null),mm=ct({undo:null,redo:null}),Wo=ct([]),_o=ct(null),Yl=ct(new Float32Array),Hi=ct(0),Zr=ct("connecting"),_m=ct(""),gm=ct(null),Xo=ct([]),vm=ct("");function ua(n,e,t){const i=xm(()=>localStorage.getItem(`pieper.${n}`));return i&&e.includes(i)?i:t}function xm(n){try{return n()}catch{return null}}function fa(n,e){xm(()=>localStorage.setItem(`pieper.${n}`,e))}const vc=ct("joints"),Ll=ct(null),sa=ct(!0),As=ct(ua("theme",["system","light","dark"],"system")),Ot=ct({angle:ua("angle",["deg","rad"],"deg"),length:ua("length",["mm","m"],"mm")}),dl=ct(ua("letters",["on","off"],"on")==="on"),Ru=ct(ua("hint",["seen","new"],"new")==="seen");function Mm(){Ru.value=!0,fa("hint","seen")}const Ns=ct(null),ut={ghosts:ct(!1),frames:ct(!1),trail:ct(!0),outline:ct(!1),gizmo:ct("off"),local:ct(!1),collision:ct(!1)},vs=ct(null),Yo=ct(null),pl=ct(!1),ra=_h(()=>As.value==="dark"||As.value==="system"&&Sm.value),ym=matchMedia("(prefers-color-scheme: dark)"),Sm=ct(ym.matches);ym.addEventListener("change",n=>Sm.value=n.matches);const Em=[];function Vg(n){Em.push(n)}const Gg={robots:n=>Dl.value=n,robot:n=>pn.value=n,pose:n=>us.value=n,ik:n=>as.value=n,motion:n=>{const e=n.samples!==fr.value?.samples||!_o.value;fr.value=n,n.playing||(Hi.value=n.time),e&&Wg()},history:n=>mm.value=n,log:n=>Wo.value=n};async function Wg(){_o.value=await ls.send({do:"samples",rate:60})}const ls=new Bg({section:(n,e)=>Gg[n]?.(e),event:()=>{},frame:n=>{const e=zg(n);if(e){e.kind==="pose"&&(Yl.value=e.q,e.playing&&(Hi.value=e.time));for(const t of Em)t(e)}},phase:(n,e)=>{Zr.value=n,_m.value=e},roundTrip:n=>gm.value=n});let Xg=0;function Xn(n,e="error"){const t=++Xg;Xo.value=[...Xo.value.filter(i=>i.text!==n),{id:t,text:n,kind:e}].slice(-3),setTimeout(()=>Xo.value=Xo.value.filter(i=>i.id!==t),e==="error"?7e3:3500)}async function lt(n){try{return await ls.send(n)}catch(e){Xn(e.message);return}}let Yg=0;function da(n){return`${n}-${++Yg}-${Date.now()}`}const qg={undo:"M7 5 3.5 8.5 7 12M4 8.5h7.5a4.5 4.5 0 0 1 0 9H9",redo:"M13 5l3.5 3.5L13 12M16 8.5H8.5a4.5 4.5 0 0 0 0 9H11",play:"M6 4.5v11l9-5.5z",pause:"M6.5 4.5v11M13.5 4.5v11",back:"M14 5v10l-6-5zM5.5 5v10",forward:"M6 5v10l6-5zM14.5 5v10",stop:"M5.5 5.5h9v9h-9z",loop:"M4 10a5 5 0 0 1 5-5h6M12.5 2.5 15 5l-2.5 2.5M16 10a5 5 0 0 1-5 5H5M7.5 17.5 5 15l2.5-2.5",sun:"M10 6.2a3.8 3.8 0 1 0 0 7.6 3.8 3.8 0 0 0 0-7.6M10 1.5v2M10 16.5v2M1.5 10h2M16.5 10h2M4 4l1.4 1.4M14.6 14.6 16 16M16 4l-1.4 1.4M5.4 14.6 4 16",moon:"M16 11.8A6.5 6.5 0 0 1 8.2 4 6.5 6.5 0 1 0 16 11.8z",auto:"M10 3a7 7 0 1 0 0 14zM10 3a7 7 0 0 1 0 14",camera:"M3 6.5h3l1.3-2h5.4l1.3 2h3v9H3zM10 8.2a2.6 2.6 0 1 0 0 5.2 2.6 2.6 0 0 0 0-5.2",home:"M3.5 9.5 10 4l6.5 5.5M5.5 8.5V16h9V8.5",ghost:"M4.5 16V9a5.5 5.5 0 0 1 11 0v7l-2-1.5-1.8 1.5L10 14.5 8.3 16l-1.8-1.5zM8 9v.01M12 9v.01",axes:"M6 14V4M6 14h10M6 14l-3 3M4.3 5.7 6 4l1.7 1.7M14.3 12.3 16 14l-1.7 1.7",trail:"M3 15c4 0 3-9 7-9s3 7 7 4",reach:"M3 16a7 7 0 0 1 14 0M6.5 16a3.5 3.5 0 0 1 7 0",move:"M10 2.5v15M2.5 10h15M7.8 4.7 10 2.5l2.2 2.2M7.8 15.3 10 17.5l2.2-2.2M4.7 7.8 2.5 10l2.2 2.2M15.3 7.8 17.5 10l-2.2 2.2",rotate:"M15.5 7A6.5 6.5 0 1 0 16.5 11M16 3v4h-4",plus:"M10 4v12M4 10h12",close:"M5 5l10 10M15 5 5 15",lock:"M5.5 9h9v7.5h-9zM7 9V6.5a3 3 0 0 1 6 0V9",unlock:"M5.5 9h9v7.5h-9zM7 9V6.5a3 3 0 0 1 5.8-1",warn:"M10 3.5 17.5 16h-15zM10 8v4M10 14v.01",check:"M4.5 10.5 8.5 14.5 15.5 6",help:"M7.5 7.5a2.5 2.5 0 1 1 3.6 2.2c-.7.4-1.1.9-1.1 1.8M10 14.5v.01",down:"M5 7.5 10 12.5 15 7.5",panel:"M3 4.5h14v11H3zM12.5 4.5v11",download:"M10 3.5v9M6.5 9.5 10 13l3.5-3.5M4 16h12",upload:"M10 13V4M6.5 7.5 10 4l3.5 3.5M4 16h12",dice:"M4 4h12v12H4zM7.5 7.5v.01M12.5 7.5v.01M10 10v.01M7.5 12.5v.01M12.5 12.5v.01",copy:"M7 7h9v9H7zM13 7V4H4v9h3",fit:"M3 7V3h4M13 3h4v4M17 13v4h-4M7 17H3v-4"};function vi({name:n}){return R("svg",{class:"icon",viewBox:"0 0 20 20","aria-hidden":"true",children:R("path",{d:qg[n]})})}function Zt({icon:n,label:e,onClick:t,pressed:i,disabled:s,keys:r,text:o,class:a}){const l=r?`${e} (${r})`:e;return R("button",{type:"button",class:`icon-button ${a??""}`,title:l,"aria-label":e,disabled:s??!1,onClick:t,...i===void 0?{}:{"aria-pressed":i},children:[R(vi,{name:n}),o&&R("span",{children:o})]})}const bm=Math.PI/180;function Il(n,e){return n==="angle"?e.angle==="deg"?"°":"rad":e.length}function io(n,e,t){if(!Number.isFinite(n))return"–";const[i,s]=e==="angle"?t.angle==="deg"?[n/bm,2]:[n,4]:t.length==="mm"?[n*1e3,2]:[n,5],r=i.toFixed(s);return Number(r)===0?0 .toFixed(s):r}function $g(n,e,t){const i=n.trim().replace(",",".");return/^[-+]?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?$/i.test(i)?`${i} ${e==="angle"?t.angle:t.length}`:i}function jg(n,e){return e==="angle"?`${(n/bm).toFixed(1)} degrees`:`${(n*1e3).toFixed(1)} millimetres`}function pa(n){return n.kind==="prismatic"?"length":"angle"}function wm(n){if(n===0)return"0";const e=Math.floor(Math.log10(Math.abs(n)));return`${(n/10**e).toFixed(1)}e${e}`}function nr({value:n,kind:e,label:t,onCommit:i,id:s}){const[r,o]=dh(null),a=e==="plain"?n.toFixed(4):io(n,e,Ot.value),l=()=>{r!==null&&r.trim()!==""&&r!==a&&i(e==="plain"?r.trim():$g(r,e,Ot.value)),o(null)};return R("span",{class:"number",children:[R("input",{id:s,type:"text",inputMode:"text",spellcheck:!1,autocomplete:"off","aria-label":t,value:r??a,onFocus:c=>{o(a),c.currentTarget.select()},onInput:c=>o(c.currentTarget.value),onBlur:l,onKeyDown:c=>{c.key==="Enter"&&(l(),c.currentTarget.blur()),c.key==="Escape"&&(o(null),c.currentTarget.blur()),c.stopPropagation()}}),e!=="plain"&&R("span",{class:"unit","aria-hidden":"true",children:Il(e,Ot.value)})]})}const Zg=!0,gn="u-",Kg="uplot",Jg=gn+"hz",Qg=gn+"vt",e0=gn+"title",t0=gn+"wrap",n0=gn+"under",i0=gn+"over",s0=gn+"axis",ir=gn+"off",r0=gn+"select",o0=gn+"cursor-x",a0=gn+"cursor-y",l0=gn+"cursor-pt",c0=gn+"legend",h0=gn+"live",u0=gn+"inline",f0=gn+"series",d0=gn+"marker",zf=gn+"label",p0=gn+"value",qo="width",$o="height",Ao="top",Hf="bottom",Pr="left",xc="right",Cu="#000",Vf=Cu+"0",Mc="mousemove",Gf="mousedown",yc="mouseup",Wf="mouseenter",Xf="mouseleave",Yf="dblclick",m0="resize",_0="scroll",qf="change",Ul="dppxchange",Pu="--",go=typeof window<"u",gh=go?document:null,Kr=go?window:null,g0=go?navigator:null;let Et,La;function vh(){let n=devicePixelRatio;Et!=n&&(Et=n,La&&Mh(qf,La,vh),La=matchMedia(`(min-resolution: ${Et-.001}dppx) and (max-resolution: ${Et+.001}dppx)`),ur(qf,La,vh),Kr.dispatchEvent(new CustomEvent(Ul)))}function si(n,e){if(e!=null){let t=n.classList;!t.contains(e)&&t.add(e)}}function xh(n,e){let t=n.classList;t.contains(e)&&t.remove(e)}function Yt(n,e,t){n.style[e]=t+"px"}function Ai(n,e,t,i){let s=gh.createElement(n);return e!=null&&si(s,e),t?.insertBefore(s,i),s}function fi(n,e){return Ai("div",n,e)}const $f=new WeakMap;function ki(n,e,t,i,s){let r="translate("+e+"px,"+t+"px)",o=$f.get(n);r!=o&&(n.style.transform=r,$f.set(n,r),e<0||t<0||e>i||t>s?si(n,ir):xh(n,ir))}const jf=new WeakMap;function Zf(n,e,t){let i=e+t,s=jf.get(n);i!=s&&(jf.set(n,i),n.style.background=e,n.style.borderColor=t)}const Kf=new WeakMap;function Jf(n,e,t,i){let s=e+""+t,r=Kf.get(n);s!=r&&(Kf.set(n,s),n.style.height=t+"px",n.style.width=e+"px",n.style.marginLeft=i?-e/2+"px":0,n.style.marginTop=i?-t/2+"px":0)}const Du={passive:!0},v0={...Du,capture:!0};function ur(n,e,t,i){e.addEventListener(n,t,i?v0:Du)}function Mh(n,e,t,i){e.removeEventListener(n,t,Du)}go&&vh();function Ri(n,e,t,i){let s;t=t||0,i=i||e.length-1;let r=i<=2147483647;for(;i-t>1;)s=r?t+i>>1:ri((t+i)/2),e[s]<n?t=s:i=s;return n-e[t]<=e[i]-n?t:i}function Tm(n){return(t,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(t[a])){r=a;break}for(let a=s;a>=i;a--)if(n(t[a])){o=a;break}return[r,o]}}const Am=n=>n!=null,Rm=n=>n!=null&&n>0,ql=Tm(Am),x0=Tm(Rm);function M0(n,e,t,i=0,s=!1){let r=s?x0:ql,o=s?Rm:Am;[e,t]=r(n,e,t);let a=n[e],l=n[e];if(e>-1)if(i==1)a=n[e],l=n[t];else if(i==-1)a=n[t],l=n[e];else for(let c=e;c<=t;c++){let h=n[c];o(h)&&(h<a?a=h:h>l&&(l=h))}return[a??Nt,l??-Nt]}function $l(n,e,t,i){let s=td(n),r=td(e);n==e&&(s==-1?(n*=t,e/=t):(n/=t,e*=t));let o=t==10?ss:Cm,a=s==1?ri:pi,l=r==1?pi:ri,c=a(o(fn(n))),h=l(o(fn(e))),f=so(t,c),d=so(t,h);return t==10&&(c<0&&(f=Ft(f,-c)),h<0&&(d=Ft(d,-h))),i||t==2?(n=f*s,e=d*r):(n=Im(n,f),e=jl(e,d)),[n,e]}function Lu(n,e,t,i){let s=$l(n,e,t,i);return n==0&&(s[0]=0),e==0&&(s[1]=0),s}const Iu=.1,Qf={mode:3,pad:Iu},oa={pad:0,soft:null,mode:0},y0={min:oa,max:oa};function Nl(n,e,t,i){return Zl(t)?ed(n,e,t):(oa.pad=t,oa.soft=i?0:null,oa.mode=i?3:0,ed(n,e,y0))}function Mt(n,e){return n??e}function S0(n,e,t){for(e=Mt(e,0),t=Mt(t,n.length-1);e<=t;){if(n[e]!=null)return!0;e++}return!1}function ed(n,e,t){let i=t.min,s=t.max,r=Mt(i.pad,0),o=Mt(s.pad,0),a=Mt(i.hard,-Nt),l=Mt(s.hard,Nt),c=Mt(i.soft,Nt),h=Mt(s.soft,-Nt),f=Mt(i.mode,0),d=Mt(s.mode,0),u=e-n,_=ss(u),v=Wn(fn(n),fn(e)),m=ss(v),p=fn(m-_);(u<1e-24||p>10)&&(u=0,(n==0||e==0)&&(u=1e-24,f==2&&c!=Nt&&(r=0),d==2&&h!=-Nt&&(o=0)));let y=u||v||1e3,w=ss(y),x=so(10,ri(w)),L=y*(u==0?n==0?.1:1:r),A=Ft(Im(n-L,x/10),24),U=n>=c&&(f==1||f==3&&A<=c||f==2&&A>=c)?c:Nt,N=Wn(a,A<U&&n>=U?U:Ci(U,A)),b=y*(u==0?e==0?.1:1:o),E=Ft(jl(e+b,x/10),24),C=e<=h&&(d==1||d==3&&E>=h||d==2&&E<=h)?h:-Nt,B=Ci(l,E>C&&e<=C?C:Wn(C,E));return N==B&&N==0&&(B=100),[N,B]}const E0=new Intl.NumberFormat(go?g0.language:"en-US"),Uu=n=>E0.format(n),ai=Math,ml=ai.PI,fn=ai.abs,ri=ai.floor,un=ai.round,pi=ai.ceil,Ci=ai.min,Wn=ai.max,so=ai.pow,td=ai.sign,ss=ai.log10,Cm=ai.log2,b0=(n,e=1)=>ai.sinh(n)*e,Sc=(n,e=1)=>ai.asinh(n/e),Nt=1/0;function nd(n){return(ss((n^n>>31)-(n>>31))|0)+1}function yh(n,e,t){return Ci(Wn(n,e),t)}function Pm(n){return typeof n=="function"}function pt(n){return Pm(n)?n:()=>n}const w0=()=>{},Dm=n=>n,Lm=(n,e)=>e,T0=n=>null,id=n=>!0,sd=(n,e)=>n==e,A0=/\.\d*?(?=9{6,}|0{6,})/gm,dr=n=>{if(Nm(n)||Fs.has(n))return n;const e=`${n}`,t=e.match(A0);if(t==null)return n;let i=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${dr(s)}e${r}`}return Ft(n,i)};function Js(n,e){return dr(Ft(dr(n/e))*e)}function jl(n,e){return dr(pi(dr(n/e))*e)}function Im(n,e){return dr(ri(dr(n/e))*e)}function Ft(n,e=0){if(Nm(n))return n;let t=10**e,i=n*t*(1+Number.EPSILON);return un(i)/t}const Fs=new Map;function Um(n){return((""+n).split(".")[1]||"").length}function ma(n,e,t,i){let s=[],r=i.map(Um);for(let o=e;o<t;o++){let a=fn(o),l=Ft(so(n,o),a);for(let c=0;c<i.length;c++){let h=n==10?+`${i[c]}e${o}`:i[c]*l,f=(o>=0?0:a)+(o>=r[c]?0:r[c]),d=n==10?h:Ft(h,f);s.push(d),Fs.set(d,f)}}return s}const aa={},Nu=[],ro=[null,null],Rs=Array.isArray,Nm=Number.isInteger,R0=n=>n===void 0;function rd(n){return typeof n=="string"}function Zl(n){let e=!1;if(n!=null){let t=n.constructor;e=t==null||t==Object}return e}function C0(n){return n!=null&&typeof n=="object"}const P0=Object.getPrototypeOf(Uint8Array),Fm="__proto__";function oo(n,e=Zl){let t;if(Rs(n)){let i=n.find(s=>s!=null);if(Rs(i)||e(i)){t=Array(n.length);for(let s=0;s<n.length;s++)t[s]=oo(n[s],e)}else t=n.slice()}else if(n instanceof P0)t=n.slice();else if(e(n)){t={};for(let i in n)i!=Fm&&(t[i]=oo(n[i],e))}else t=n;return t}function an(n){let e=arguments;for(let t=1;t<e.length;t++){let i=e[t];for(let s in i)s!=Fm&&(Zl(n[s])?an(n[s],oo(i[s])):n[s]=oo(i[s]))}return n}const D0=0,L0=1,I0=2;function U0(n,e,t){for(let i=0,s,r=-1;i<e.length;i++){let o=e[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<t&&n[s]==null;)n[r=s++]=null}}}function N0(n,e){if(k0(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return B0(o[0])||(o=O0(o)),o}let t=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let h=0;h<c;h++)t.add(l[h])}let i=[Array.from(t).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let h=a[c],f=Array(s).fill(void 0),d=e?e[o][c]:L0,u=[];for(let _=0;_<h.length;_++){let v=h[_],m=r.get(l[_]);v===null?d!=D0&&(f[m]=v,d==I0&&u.push(m)):f[m]=v}U0(f,u,s),i.push(f)}}return i}const F0=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function O0(n){let e=n[0],t=e.length,i=Array(t);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>e[r]-e[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(t);for(let l=0;l<t;l++)a[l]=o[i[l]];s.push(a)}return s}function k0(n){let e=n[0][0],t=e.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function B0(n,e=100){const t=n.length;if(t<=1)return!0;let i=0,s=t-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;const r=Wn(1,ri((s-i+1)/e));for(let o=n[i],a=i+r;a<=s;a+=r){const l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}const Om=["January","February","March","April","May","June","July","August","September","October","November","December"],km=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function Bm(n){return n.slice(0,3)}const z0=km.map(Bm),H0=Om.map(Bm),V0={MMMM:Om,MMM:H0,WWWW:km,WWW:z0};function Ro(n){return(n<10?"0":"")+n}function G0(n){return(n<10?"00":n<100?"0":"")+n}const W0={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,e)=>e.MMMM[n.getMonth()],MMM:(n,e)=>e.MMM[n.getMonth()],MM:n=>Ro(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>Ro(n.getDate()),D:n=>n.getDate(),WWWW:(n,e)=>e.WWWW[n.getDay()],WWW:(n,e)=>e.WWW[n.getDay()],HH:n=>Ro(n.getHours()),H:n=>n.getHours(),h:n=>{let e=n.getHours();return e==0?12:e>12?e-12:e},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>Ro(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>Ro(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>G0(n.getMilliseconds())};function Fu(n,e){e=e||V0;let t=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)t.push(s[0][0]=="{"?W0[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](r,e);return o}}const X0=new Intl.DateTimeFormat().resolvedOptions().timeZone;function Y0(n,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+n+n.getTimezoneOffset()*6e4):e==X0?t=n:(t=new Date(n.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(n.getMilliseconds())),t}const zm=n=>n%1==0,Fl=[1,2,2.5,5],q0=ma(10,-32,0,Fl),Hm=ma(10,0,32,Fl),$0=Hm.filter(zm),Qs=q0.concat(Hm),Ou=`
`,Vm="{YYYY}",od=Ou+Vm,Gm="{M}/{D}",jo=Ou+Gm,Ia=jo+"/{YY}",Wm="{aa}",j0="{h}:{mm}",Yr=j0+Wm,ad=Ou+Yr,ld=":{ss}",bt=null;function Xm(n){let e=n*1e3,t=e*60,i=t*60,s=i*24,r=s*30,o=s*365,l=(n==1?ma(10,0,3,Fl).filter(zm):ma(10,-3,0,Fl)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]);const c=[[o,Vm,bt,bt,bt,bt,bt,bt,1],[s*28,"{MMM}",od,bt,bt,bt,bt,bt,1],[s,Gm,od,bt,bt,bt,bt,bt,1],[i,"{h}"+Wm,Ia,bt,jo,bt,bt,bt,1],[t,Yr,Ia,bt,jo,bt,bt,bt,1],[e,ld,Ia+" "+Yr,bt,jo+" "+Yr,bt,ad,bt,1],[n,ld+".{fff}",Ia+" "+Yr,bt,jo+" "+Yr,bt,ad,bt,1]];function h(f){return(d,u,_,v,m,p)=>{let y=[],w=m>=o,x=m>=r&&m<o,L=f(_),A=Ft(L*n,3),U=Ec(L.getFullYear(),w?0:L.getMonth(),x||w?1:L.getDate()),N=Ft(U*n,3);if(x||w){let b=x?m/r:0,E=w?m/o:0,C=A==N?A:Ft(Ec(U.getFullYear()+E,U.getMonth()+b,1)*n,3),B=new Date(un(C/n)),z=B.getFullYear(),Y=B.getMonth();for(let W=0;C<=v;W++){let j=Ec(z+E*W,Y+b*W,1),q=j-f(Ft(j*n,3));C=Ft((+j+q)*n,3),C<=v&&y.push(C)}}else{let b=m>=s?s:m,E=ri(_)-ri(A),C=N+E+jl(A-N,b);y.push(C);let B=f(C),z=B.getHours()+B.getMinutes()/t+B.getSeconds()/i,Y=m/i,W=d.axes[u]._space,j=p/W;for(;C=Ft(C+m,n==1?0:3),!(C>v);)if(Y>1){let q=ri(Ft(z+Y,6))%24,ae=f(C).getHours()-q;ae>1&&(ae=-1),C-=ae*i,z=(z+Y)%24;let me=y[y.length-1];Ft((C-me)/m,3)*j>=.7&&y.push(C)}else y.push(C)}return y}}return[l,c,h]}const[Z0,K0,J0]=Xm(1),[Q0,ev,tv]=Xm(.001);ma(2,-53,53,[1]);function cd(n,e){return n.map(t=>t.map((i,s)=>s==0||s==8||i==null?i:e(s==1||t[8]==0?i:t[1]+i)))}function hd(n,e){return(t,i,s,r,o)=>{let a=e.find(_=>o>=_[0])||e[e.length-1],l,c,h,f,d,u;return i.map(_=>{let v=n(_),m=v.getFullYear(),p=v.getMonth(),y=v.getDate(),w=v.getHours(),x=v.getMinutes(),L=v.getSeconds(),A=m!=l&&a[2]||p!=c&&a[3]||y!=h&&a[4]||w!=f&&a[5]||x!=d&&a[6]||L!=u&&a[7]||a[1];return l=m,c=p,h=y,f=w,d=x,u=L,A(v)})}}function nv(n,e){let t=Fu(e);return(i,s,r,o,a)=>s.map(l=>t(n(l)))}function Ec(n,e,t){return new Date(n,e,t)}function ud(n,e){return e(n)}const iv="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function fd(n,e){return(t,i,s,r)=>r==null?Pu:e(n(i))}function sv(n,e){let t=n.series[e];return t.width?t.stroke(n,e):t.points.width?t.points.stroke(n,e):null}function rv(n,e){return n.series[e].fill(n,e)}const ov={show:!0,live:!0,isolate:!1,mount:w0,markers:{show:!0,width:2,stroke:sv,fill:rv,dash:"solid"},idx:null,idxs:null,values:[]};function av(n,e){let t=n.cursor.points,i=fi(),s=t.size(n,e);Yt(i,qo,s),Yt(i,$o,s);let r=s/-2;Yt(i,"marginLeft",r),Yt(i,"marginTop",r);let o=t.width(n,e,s);return o&&Yt(i,"borderWidth",o),i}function lv(n,e){let t=n.series[e].points;return t._fill||t._stroke}function cv(n,e){let t=n.series[e].points;return t._stroke||t._fill}function hv(n,e){return n.series[e].points.size}const bc=[0,0];function uv(n,e,t){return bc[0]=e,bc[1]=t,bc}function Ua(n,e,t,i=!0){return s=>{s.button==0&&(!i||s.target==e)&&t(s)}}function wc(n,e,t,i=!0){return s=>{(!i||s.target==e)&&t(s)}}const fv={show:!0,x:!0,y:!0,lock:!1,move:uv,points:{one:!1,show:av,size:hv,width:0,stroke:cv,fill:lv},bind:{mousedown:Ua,mouseup:Ua,click:Ua,dblclick:Ua,mousemove:wc,mouseleave:wc,mouseenter:wc},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,e,t,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},Ym={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},ku=an({},Ym,{filter:Lm}),qm=an({},ku,{size:10}),$m=an({},Ym,{show:!1}),Bu='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',jm="bold "+Bu,Zm=1.5,dd={show:!0,scale:"x",stroke:Cu,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:jm,side:2,grid:ku,ticks:qm,border:$m,font:Bu,lineGap:Zm,rotate:0},dv="Value",pv="Time",pd={show:!0,scale:"x",auto:!1,sorted:1,min:Nt,max:-Nt,idxs:[]};function mv(n,e,t,i,s){return e.map(r=>r==null?"":Uu(r))}function _v(n,e,t,i,s,r,o){let a=[],l=Fs.get(s)||0;t=o?t:Ft(jl(t,s),l);for(let c=t;c<=i;c=Ft(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function Sh(n,e,t,i,s,r,o){const a=[],l=n.scales[n.axes[e].scale].log,c=l==10?ss:Cm,h=ri(c(t));s=so(l,h),l==10&&(s=Qs[Ri(s,Qs)]);let f=t,d=s*l;l==10&&(d=Qs[Ri(d,Qs)]);do a.push(f),f=f+s,l==10&&!Fs.has(f)&&(f=Ft(f,Fs.get(s))),f>=d&&(s=f,d=s*l,l==10&&(d=Qs[Ri(d,Qs)]));while(f<=i);return a}function gv(n,e,t,i,s,r,o){let l=n.scales[n.axes[e].scale].asinh,c=i>l?Sh(n,e,Wn(l,t),i,s):[l],h=i>=0&&t<=0?[0]:[];return(t<-l?Sh(n,e,Wn(l,-i),-t,s):[l]).reverse().map(d=>-d).concat(h,c)}const Km=/./,vv=/[12357]/,xv=/[125]/,md=/1/,Eh=(n,e,t,i)=>n.map((s,r)=>e==4&&s==0||r%i==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function Mv(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=n.scales[o],l=n.valToPos,c=r._space,h=l(10,o),f=l(9,o)-h>=c?Km:l(7,o)-h>=c?vv:l(5,o)-h>=c?xv:md;if(f==md){let d=fn(l(1,o)-h);if(d<c)return Eh(e.slice().reverse(),a.distr,f,pi(c/d)).reverse()}return Eh(e,a.distr,f,1)}function yv(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=r._space,l=n.valToPos,c=fn(l(1,o)-l(2,o));return c<a?Eh(e.slice().reverse(),3,Km,pi(a/c)).reverse():e}function Sv(n,e,t,i){return i==null?Pu:e==null?"":Uu(e)}const _d={show:!0,scale:"y",stroke:Cu,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:jm,side:3,grid:ku,ticks:qm,border:$m,font:Bu,lineGap:Zm,rotate:0};function Ev(n,e){let t=3+(n||1)*2;return Ft(t*e,3)}function bv(n,e){let{scale:t,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],t,!0),o=n.valToPos(s[i[1]],t,!0),a=fn(o-r),l=n.series[e],c=a/(l.points.space*Et);return i[1]-i[0]<=c}const gd={scale:null,auto:!0,sorted:0,min:Nt,max:-Nt},Jm=(n,e,t,i,s)=>s,vd={show:!0,auto:!0,sorted:0,gaps:Jm,alpha:1,facets:[an({},gd,{scale:"x"}),an({},gd,{scale:"y"})]},xd={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:Jm,alpha:1,points:{show:bv,filter:null},values:null,min:Nt,max:-Nt,idxs:[],path:null,clip:null};function wv(n,e,t,i,s){return t/10}const Qm={time:Zg,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},Tv=an({},Qm,{time:!1,ori:1}),Md={};function e_(n,e){let t=Md[n];return t||(t={key:n,plots:[],sub(i){t.plots.push(i)},unsub(i){t.plots=t.plots.filter(s=>s!=i)},pub(i,s,r,o,a,l,c){for(let h=0;h<t.plots.length;h++)t.plots[h]!=s&&t.plots[h].pub(i,s,r,o,a,l,c)}},n!=null&&(Md[n]=t)),t}const ao=1,bh=2;function gr(n,e,t){const i=n.mode,s=n.series[e],r=i==2?n._data[e]:n._data,o=n.scales,a=n.bbox;let l=r[0],c=i==2?r[1]:r[e],h=i==2?o[s.facets[0].scale]:o[n.series[0].scale],f=i==2?o[s.facets[1].scale]:o[s.scale],d=a.left,u=a.top,_=a.width,v=a.height,m=n.valToPosH,p=n.valToPosV;return h.ori==0?t(s,l,c,h,f,m,p,d,u,_,v,Jl,vo,ec,n_,s_):t(s,l,c,h,f,p,m,u,d,v,_,Ql,xo,Vu,i_,r_)}function zu(n,e){let t=0,i=0,s=Mt(n.bands,Nu);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?i|=1:i|=2)}return[t,i==1?-1:i==2?1:i==3?2:0]}function Av(n,e,t,i,s){let r=n.mode,o=n.series[e],a=r==2?o.facets[1].scale:o.scale,l=n.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function rs(n,e,t,i,s,r){return gr(n,e,(o,a,l,c,h,f,d,u,_,v,m)=>{let p=o.pxRound;const y=c.dir*(c.ori==0?1:-1),w=c.ori==0?vo:xo;let x,L;y==1?(x=t,L=i):(x=i,L=t);let A=p(f(a[x],c,v,u)),U=p(d(l[x],h,m,_)),N=p(f(a[L],c,v,u)),b=p(d(r==1?h.max:h.min,h,m,_)),E=new Path2D(s);return w(E,N,b),w(E,A,b),w(E,A,U),E})}function Kl(n,e,t,i,s,r){let o=null;if(n.length>0){o=new Path2D;const a=e==0?ec:Vu;let l=t;for(let f=0;f<n.length;f++){let d=n[f];if(d[1]>d[0]){let u=d[0]-l;u>0&&a(o,l,i,u,i+r),l=d[1]}}let c=t+s-l,h=10;c>0&&a(o,l,i-h/2,c,i+r+h)}return o}function Rv(n,e,t){let i=n[n.length-1];i&&i[0]==e?i[1]=t:n.push([e,t])}function Hu(n,e,t,i,s,r,o){let a=[],l=n.length;for(let c=s==1?t:i;c>=t&&c<=i;c+=s)if(e[c]===null){let f=c,d=c;if(s==1)for(;++c<=i&&e[c]===null;)d=c;else for(;--c>=t&&e[c]===null;)d=c;let u=r(n[f]),_=d==f?u:r(n[d]),v=f-s;u=o<=0&&v>=0&&v<l?r(n[v]):u;let p=d+s;_=o>=0&&p>=0&&p<l?r(n[p]):_,_>=u&&a.push([u,_])}return a}function yd(n){return n==0?Dm:n==1?un:e=>Js(e,n)}function t_(n){let e=n==0?Jl:Ql,t=n==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},i=n==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,h=0)=>{c==0&&h==0?i(s,r,o,a,l):(c=Ci(c,a/2,l/2),h=Ci(h,a/2,l/2),e(s,r+c,o),t(s,r+a,o,r+a,o+l,c),t(s,r+a,o+l,r,o+l,h),t(s,r,o+l,r,o,h),t(s,r,o,r+a,o,c),s.closePath())}}const Jl=(n,e,t)=>{n.moveTo(e,t)},Ql=(n,e,t)=>{n.moveTo(t,e)},vo=(n,e,t)=>{n.lineTo(e,t)},xo=(n,e,t)=>{n.lineTo(t,e)},ec=t_(0),Vu=t_(1),n_=(n,e,t,i,s,r)=>{n.arc(e,t,i,s,r)},i_=(n,e,t,i,s,r)=>{n.arc(t,e,i,s,r)},s_=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(e,t,i,s,r,o)},r_=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(t,e,s,i,o,r)};function o_(n){return(e,t,i,s,r)=>gr(e,t,(o,a,l,c,h,f,d,u,_,v,m)=>{let{pxRound:p,points:y}=o,w,x;c.ori==0?(w=Jl,x=n_):(w=Ql,x=i_);const L=Ft(y.width*Et,3);let A=(y.size-y.width)/2*Et,U=Ft(A*2,3),N=new Path2D,b=new Path2D,{left:E,top:C,width:B,height:z}=e.bbox;ec(b,E-U,C-U,B+U*2,z+U*2);const Y=W=>{if(l[W]!=null){let j=p(f(a[W],c,v,u)),q=p(d(l[W],h,m,_));w(N,j+A,q),x(N,j,q,A,0,ml*2)}};if(r)r.forEach(Y);else for(let W=i;W<=s;W++)Y(W);return{stroke:L>0?N:null,fill:N,clip:b,flags:ao|bh}})}function a_(n){return(e,t,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(e,t,i),r!=s&&o!=s&&n(e,t,s),n(e,t,o))}}const Cv=a_(vo),Pv=a_(xo);function l_(n){const e=Mt(n?.alignGaps,0);return(t,i,s,r)=>gr(t,i,(o,a,l,c,h,f,d,u,_,v,m)=>{[s,r]=ql(l,s,r);let p=o.pxRound,y=z=>p(f(z,c,v,u)),w=z=>p(d(z,h,m,_)),x,L;c.ori==0?(x=vo,L=Cv):(x=xo,L=Pv);const A=c.dir*(c.ori==0?1:-1),U={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:ao},N=U.stroke;let b=!1;if(r-s>=v*4){let z=ge=>t.posToVal(ge,c.key,!0),Y=null,W=null,j,q,K,re=y(a[A==1?s:r]),ae=y(a[s]),me=y(a[r]),xe=z(A==1?ae+1:me-1);for(let ge=A==1?s:r;ge>=s&&ge<=r;ge+=A){let Qe=a[ge],ee=(A==1?Qe<xe:Qe>xe)?re:y(Qe),ne=l[ge];ee==re?ne!=null?(q=ne,Y==null?(x(N,ee,w(q)),j=Y=W=q):q<Y?Y=q:q>W&&(W=q)):ne===null&&(b=!0):(Y!=null&&L(N,re,w(Y),w(W),w(j),w(q)),ne!=null?(q=ne,x(N,ee,w(q)),Y=W=j=q):(Y=W=null,ne===null&&(b=!0)),re=ee,xe=z(re+A))}Y!=null&&Y!=W&&K!=re&&L(N,re,w(Y),w(W),w(j),w(q))}else for(let z=A==1?s:r;z>=s&&z<=r;z+=A){let Y=l[z];Y===null?b=!0:Y!=null&&x(N,y(a[z]),w(Y))}let[C,B]=zu(t,i);if(o.fill!=null||C!=0){let z=U.fill=new Path2D(N),Y=o.fillTo(t,i,o.min,o.max,C),W=w(Y),j=y(a[s]),q=y(a[r]);A==-1&&([q,j]=[j,q]),x(z,q,W),x(z,j,W)}if(!o.spanGaps){let z=[];b&&z.push(...Hu(a,l,s,r,A,y,e)),U.gaps=z=o.gaps(t,i,s,r,z),U.clip=Kl(z,c.ori,u,_,v,m)}return B!=0&&(U.band=B==2?[rs(t,i,s,r,N,-1),rs(t,i,s,r,N,1)]:rs(t,i,s,r,N,B)),U})}function Dv(n){const e=Mt(n.align,1),t=Mt(n.ascDesc,!1),i=Mt(n.alignGaps,0),s=Mt(n.extend,!1);return(r,o,a,l)=>gr(r,o,(c,h,f,d,u,_,v,m,p,y,w)=>{[a,l]=ql(f,a,l);let x=c.pxRound,{left:L,width:A}=r.bbox,U=ae=>x(_(ae,d,y,m)),N=ae=>x(v(ae,u,w,p)),b=d.ori==0?vo:xo;const E={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:ao},C=E.stroke,B=d.dir*(d.ori==0?1:-1);let z=N(f[B==1?a:l]),Y=U(h[B==1?a:l]),W=Y,j=Y;s&&e==-1&&(j=L,b(C,j,z)),b(C,Y,z);for(let ae=B==1?a:l;ae>=a&&ae<=l;ae+=B){let me=f[ae];if(me==null)continue;let xe=U(h[ae]),ge=N(me);e==1?b(C,xe,z):b(C,W,ge),b(C,xe,ge),z=ge,W=xe}let q=W;s&&e==1&&(q=L+A,b(C,q,z));let[K,re]=zu(r,o);if(c.fill!=null||K!=0){let ae=E.fill=new Path2D(C),me=c.fillTo(r,o,c.min,c.max,K),xe=N(me);b(ae,q,xe),b(ae,j,xe)}if(!c.spanGaps){let ae=[];ae.push(...Hu(h,f,a,l,B,U,i));let me=c.width*Et/2,xe=t||e==1?me:-me,ge=t||e==-1?-me:me;ae.forEach(Qe=>{Qe[0]+=xe,Qe[1]+=ge}),E.gaps=ae=c.gaps(r,o,a,l,ae),E.clip=Kl(ae,d.ori,m,p,y,w)}return re!=0&&(E.band=re==2?[rs(r,o,a,l,C,-1),rs(r,o,a,l,C,1)]:rs(r,o,a,l,C,re)),E})}function Sd(n,e,t,i,s,r,o=Nt){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(e[l]!==void 0){if(a!=null){let h=fn(n[l]-n[a]);h<c&&(c=h,o=fn(t(n[l],i,s,r)-t(n[a],i,s,r)))}a=l}}return o}function Lv(n){n=n||aa;const e=Mt(n.size,[.6,Nt,1]),t=n.align||0,i=n.gap||0;let s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;const r=pt(s),o=1-e[0],a=Mt(e[1],Nt),l=Mt(e[2],1),c=Mt(n.disp,aa),h=Mt(n.each,u=>{}),{fill:f,stroke:d}=c;return(u,_,v,m)=>gr(u,_,(p,y,w,x,L,A,U,N,b,E,C)=>{let B=p.pxRound,z=t,Y=i*Et,W=a*Et,j=l*Et,q,K;x.ori==0?[q,K]=r(u,_):[K,q]=r(u,_);const re=x.dir*(x.ori==0?1:-1);let ae=x.ori==0?ec:Vu,me=x.ori==0?h:(O,J,ie,te,Fe,ue,Le)=>{h(O,J,ie,Fe,te,Le,ue)},xe=Mt(u.bands,Nu).find(O=>O.series[0]==_),ge=xe!=null?xe.dir:0,Qe=p.fillTo(u,_,p.min,p.max,ge),et=B(U(Qe,L,C,b)),ee,ne,we,ze=E,Me=B(p.width*Et),tt=!1,kt=null,F=null,mt=null,$e=null;f!=null&&(Me==0||d!=null)&&(tt=!0,kt=f.values(u,_,v,m),F=new Map,new Set(kt).forEach(O=>{O!=null&&F.set(O,new Path2D)}),Me>0&&(mt=d.values(u,_,v,m),$e=new Map,new Set(mt).forEach(O=>{O!=null&&$e.set(O,new Path2D)})));let{x0:We,size:Ne}=c;if(We!=null&&Ne!=null){z=1,y=We.values(u,_,v,m),We.unit==2&&(y=y.map(ie=>u.posToVal(N+ie*E,x.key,!0)));let O=Ne.values(u,_,v,m);Ne.unit==2?ne=O[0]*E:ne=A(O[0],x,E,N)-A(0,x,E,N),ze=Sd(y,w,A,x,E,N,ze),we=ze-ne+Y}else ze=Sd(y,w,A,x,E,N,ze),we=ze*o+Y,ne=ze-we;we<1&&(we=0),Me>=ne/2&&(Me=0),we<5&&(B=Dm);let Tt=we>0,Pe=ze-we-(Tt?Me:0);ne=B(yh(Pe,j,W)),ee=(z==0?ne/2:z==re?0:ne)-z*re*((z==0?Y/2:0)+(Tt?Me/2:0));const Ge={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},Vt=tt?null:new Path2D;let yt=null;if(xe!=null)yt=u.data[xe.series[1]];else{let{y0:O,y1:J}=c;O!=null&&J!=null&&(w=J.values(u,_,v,m),yt=O.values(u,_,v,m))}let D=q*ne,M=K*ne;for(let O=re==1?v:m;O>=v&&O<=m;O+=re){let J=w[O];if(J==null)continue;if(yt!=null){let ve=yt[O]??0;if(J-ve==0)continue;et=U(ve,L,C,b)}let ie=x.distr!=2||c!=null?y[O]:O,te=A(ie,x,E,N),Fe=U(Mt(J,Qe),L,C,b),ue=B(te-ee),Le=B(Wn(Fe,et)),Re=B(Ci(Fe,et)),le=Le-Re;if(J!=null){let ve=J<0?M:D,Be=J<0?D:M;tt?(Me>0&&mt[O]!=null&&ae($e.get(mt[O]),ue,Re+ri(Me/2),ne,Wn(0,le-Me),ve,Be),kt[O]!=null&&ae(F.get(kt[O]),ue,Re+ri(Me/2),ne,Wn(0,le-Me),ve,Be)):ae(Vt,ue,Re+ri(Me/2),ne,Wn(0,le-Me),ve,Be),me(u,_,O,ue-Me/2,Re,ne+Me,le)}}return Me>0?Ge.stroke=tt?$e:Vt:tt||(Ge._fill=p.width==0?p._fill:p._stroke??p._fill,Ge.width=0),Ge.fill=tt?F:Vt,Ge})}function Iv(n,e){const t=Mt(e?.alignGaps,0);return(i,s,r,o)=>gr(i,s,(a,l,c,h,f,d,u,_,v,m,p)=>{[r,o]=ql(c,r,o);let y=a.pxRound,w=q=>y(d(q,h,m,_)),x=q=>y(u(q,f,p,v)),L,A,U;h.ori==0?(L=Jl,U=vo,A=s_):(L=Ql,U=xo,A=r_);const N=h.dir*(h.ori==0?1:-1);let b=w(l[N==1?r:o]),E=b,C=[],B=[];for(let q=N==1?r:o;q>=r&&q<=o;q+=N)if(c[q]!=null){let re=l[q],ae=w(re);C.push(E=ae),B.push(x(c[q]))}const z={stroke:n(C,B,L,U,A,y),fill:null,clip:null,band:null,gaps:null,flags:ao},Y=z.stroke;let[W,j]=zu(i,s);if(a.fill!=null||W!=0){let q=z.fill=new Path2D(Y),K=a.fillTo(i,s,a.min,a.max,W),re=x(K);U(q,E,re),U(q,b,re)}if(!a.spanGaps){let q=[];q.push(...Hu(l,c,r,o,N,w,t)),z.gaps=q=a.gaps(i,s,r,o,q),z.clip=Kl(q,h.ori,_,v,m,p)}return j!=0&&(z.band=j==2?[rs(i,s,r,o,Y,-1),rs(i,s,r,o,Y,1)]:rs(i,s,r,o,Y,j)),z})}function Uv(n){return Iv(Nv,n)}function Nv(n,e,t,i,s,r){const o=n.length;if(o<2)return null;const a=new Path2D;if(t(a,n[0],e[0]),o==2)i(a,n[1],e[1]);else{let l=Array(o),c=Array(o-1),h=Array(o-1),f=Array(o-1);for(let d=0;d<o-1;d++)h[d]=e[d+1]-e[d],f[d]=n[d+1]-n[d],c[d]=h[d]/f[d];l[0]=c[0];for(let d=1;d<o-1;d++)c[d]===0||c[d-1]===0||c[d-1]>0!=c[d]>0?l[d]=0:(l[d]=3*(f[d-1]+f[d])/((2*f[d]+f[d-1])/c[d-1]+(f[d]+2*f[d-1])/c[d]),isFinite(l[d])||(l[d]=0));l[o-1]=c[o-2];for(let d=0;d<o-1;d++)s(a,n[d]+f[d]/3,e[d]+l[d]*f[d]/3,n[d+1]-f[d]/3,e[d+1]-l[d+1]*f[d]/3,n[d+1],e[d+1])}return a}const wh=new Set;function Ed(){for(let n of wh)n.syncRect(!0)}go&&(ur(m0,Kr,Ed),ur(_0,Kr,Ed,!0),ur(Ul,Kr,()=>{Fn.pxRatio=Et}));const Fv=l_(),Ov=o_();function bd(n,e,t,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>Th(r,o,e,t))}function kv(n,e){return n.map((t,i)=>i==0?{}:an({},e,t))}function Th(n,e,t,i){return an({},e==0?t:i,n)}function c_(n,e,t){return e==null?ro:[e,t]}const Bv=c_;function zv(n,e,t){return e==null?ro:Nl(e,t,Iu,!0)}function h_(n,e,t,i){return e==null?ro:$l(e,t,n.scales[i].log,!1)}const Hv=h_;function u_(n,e,t,i){return e==null?ro:Lu(e,t,n.scales[i].log,!1)}const Vv=u_;function Gv(n,e,t,i,s){let r=Wn(nd(n),nd(e)),o=e-n,a=Ri(s/i*o,t);do{let l=t[a],c=i*l/o;if(c>=s&&r+(l<5?Fs.get(l):0)<=17)return[l,c]}while(++a<t.length);return[0,0]}function wd(n){let e,t;return n=n.replace(/(\d+)px/,(i,s)=>(e=un((t=+s)*Et))+"px"),[n,e,t]}function Wv(n){n.show&&[n.font,n.labelFont].forEach(e=>{let t=Ft(e[2]*Et,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function Fn(n,e,t){const i={mode:Mt(n.mode,1)},s=i.mode;function r(g,S,P,I){let V=S.valToPct(g);return I+P*(S.dir==-1?1-V:V)}function o(g,S,P,I){let V=S.valToPct(g);return I+P*(S.dir==-1?V:1-V)}function a(g,S,P,I){return S.ori==0?r(g,S,P,I):o(g,S,P,I)}i.valToPosH=r,i.valToPosV=o;let l=!1;i.status=0;const c=i.root=fi(Kg);if(n.id!=null&&(c.id=n.id),si(c,n.class),n.title){let g=fi(e0,c);g.textContent=n.title}const h=Ai("canvas"),f=i.ctx=h.getContext("2d"),d=fi(t0,c);ur("click",d,g=>{g.target===_&&(Gt!=br||$t!=wr)&&Tn.click(i,g)},!0);const u=i.under=fi(n0,d);d.appendChild(h);const _=i.over=fi(i0,d);n=oo(n);const v=+Mt(n.pxAlign,1),m=yd(v);(n.plugins||[]).forEach(g=>{g.opts&&(n=g.opts(i,n)||n)});const p=n.ms||.001,y=i.series=s==1?bd(n.series||[],pd,xd,!1):kv(n.series||[null],vd),w=i.axes=bd(n.axes||[],dd,_d,!0),x=i.scales={},L=i.bands=n.bands||[];L.forEach(g=>{g.fill=pt(g.fill||null),g.dir=Mt(g.dir,-1)});const A=s==2?y[1].facets[0].scale:y[0].scale,U={axes:eg,series:Hs},N=(n.drawOrder||["axes","series"]).map(g=>U[g]);function b(g){const S=g.distr==3?P=>ss(P>0?P:g.clamp(i,P,g.min,g.max,g.key)):g.distr==4?P=>Sc(P,g.asinh):g.distr==100?P=>g.fwd(P):P=>P;return P=>{let I=S(P),{_min:V,_max:$}=g,se=$-V;return(I-V)/se}}function E(g){let S=x[g];if(S==null){let P=(n.scales||aa)[g]||aa;if(P.from!=null){E(P.from);let I=an({},x[P.from],P,{key:g});I.valToPct=b(I),x[g]=I}else{S=x[g]=an({},g==A?Qm:Tv,P),S.key=g;let I=S.time,V=S.range,$=Rs(V);if((g!=A||s==2&&!I)&&($&&(V[0]==null||V[1]==null)&&(V={min:V[0]==null?Qf:{mode:1,hard:V[0],soft:V[0]},max:V[1]==null?Qf:{mode:1,hard:V[1],soft:V[1]}},$=!1),!$&&Zl(V))){let se=V;V=(ce,_e,Ae)=>_e==null?ro:Nl(_e,Ae,se)}S.range=pt(V||(I?Bv:g==A?S.distr==3?Hv:S.distr==4?Vv:c_:S.distr==3?h_:S.distr==4?u_:zv)),S.auto=pt($?!1:S.auto),S.clamp=pt(S.clamp||wv),S._min=S._max=null,S.valToPct=b(S)}}}E("x"),E("y"),s==1&&y.forEach(g=>{E(g.scale)}),w.forEach(g=>{E(g.scale)});for(let g in n.scales)E(g);const C=x[A],B=C.distr;let z,Y;C.ori==0?(si(c,Jg),z=r,Y=o):(si(c,Qg),z=o,Y=r);const W={};for(let g in x){let S=x[g];(S.min!=null||S.max!=null)&&(W[g]={min:S.min,max:S.max},S.min=S.max=null)}const j=n.tzDate||(g=>new Date(un(g/p))),q=n.fmtDate||Fu,K=p==1?J0(j):tv(j),re=hd(j,cd(p==1?K0:ev,q)),ae=fd(j,ud(iv,q)),me=[],xe=i.legend=an({},ov,n.legend),ge=i.cursor=an({},fv,{drag:{y:s==2}},n.cursor),Qe=xe.show,et=ge.show,ee=xe.markers;xe.idxs=me,ee.width=pt(ee.width),ee.dash=pt(ee.dash),ee.stroke=pt(ee.stroke),ee.fill=pt(ee.fill);let ne,we,ze,Me=[],tt=[],kt,F=!1,mt={};if(xe.live){const g=y[1]?y[1].values:null;F=g!=null,kt=F?g(i,1,0):{_:0};for(let S in kt)mt[S]=Pu}if(Qe)if(ne=Ai("table",c0,c),ze=Ai("tbody",null,ne),xe.mount(i,ne),F){we=Ai("thead",null,ne,ze);let g=Ai("tr",null,we);Ai("th",null,g);for(var $e in kt)Ai("th",zf,g).textContent=$e}else si(ne,u0),xe.live&&si(ne,h0);const We={show:!0},Ne={show:!1};function Tt(g,S){if(S==0&&(F||!xe.live||s==2))return ro;let P=[],I=Ai("tr",f0,ze,ze.childNodes[S]);si(I,g.class),g.show||si(I,ir);let V=Ai("th",null,I);if(ee.show){let ce=fi(d0,V);if(S>0){let _e=ee.width(i,S);_e&&(ce.style.border=_e+"px "+ee.dash(i,S)+" "+ee.stroke(i,S)),ce.style.background=ee.fill(i,S)}}let $=fi(zf,V);g.label instanceof HTMLElement?$.appendChild(g.label):$.textContent=g.label,S>0&&(ee.show||($.style.color=g.width>0?ee.stroke(i,S):ee.fill(i,S)),Ge("click",V,ce=>{if(ge._lock)return;wn(ce);let _e=y.indexOf(g);if((ce.ctrlKey||ce.metaKey)!=xe.isolate){let Ae=y.some((Ce,Ue)=>Ue>0&&Ue!=_e&&Ce.show);y.forEach((Ce,Ue)=>{Ue>0&&Ui(Ue,Ae?Ue==_e?We:Ne:We,!0,sn.setSeries)})}else Ui(_e,{show:!g.show},!0,sn.setSeries)},!1),qn&&Ge(Wf,V,ce=>{ge._lock||(wn(ce),Ui(y.indexOf(g),Ar,!0,sn.setSeries))},!1));for(var se in kt){let ce=Ai("td",p0,I);ce.textContent="--",P.push(ce)}return[I,P]}const Pe=new Map;function Ge(g,S,P,I=!0){const V=Pe.get(S)||{},$=ge.bind[g](i,S,P,I);$&&(ur(g,S,V[g]=$),Pe.set(S,V))}function Vt(g,S,P){const I=Pe.get(S)||{};for(let V in I)(g==null||V==g)&&(Mh(V,S,I[V]),delete I[V]);g==null&&Pe.delete(S)}let yt=0,D=0,M=0,O=0,J=0,ie=0,te=J,Fe=ie,ue=M,Le=O,Re=0,le=0,ve=0,Be=0;i.bbox={};let ke=!1,ye=!1,Ze=!1,H=!1,fe=!1,pe=!1;function De(g,S,P){(P||g!=i.width||S!=i.height)&&he(g,S),Mr(!1),Ze=!0,ye=!0,yr()}function he(g,S){i.width=yt=M=g,i.height=D=O=S,J=ie=0,Ct(),_t();let P=i.bbox;Re=P.left=Js(J*Et,.5),le=P.top=Js(ie*Et,.5),ve=P.width=Js(M*Et,.5),Be=P.height=Js(O*Et,.5)}const oe=3;function Oe(){let g=!1,S=0;for(;!g;){S++;let P=J_(S),I=Q_(S);g=S==oe||P&&I,g||(he(i.width,i.height),ye=!0)}}function nt({width:g,height:S}){De(g,S)}i.setSize=nt;function Ct(){let g=!1,S=!1,P=!1,I=!1;w.forEach((V,$)=>{if(V.show&&V._show){let{side:se,_size:ce}=V,_e=se%2,Ae=V.label!=null?V.labelSize:0,Ce=ce+Ae;Ce>0&&(_e?(M-=Ce,se==3?(J+=Ce,I=!0):P=!0):(O-=Ce,se==0?(ie+=Ce,g=!0):S=!0))}}),ji[0]=g,ji[1]=P,ji[2]=S,ji[3]=I,M-=Ii[1]+Ii[3],J+=Ii[3],O-=Ii[2]+Ii[0],ie+=Ii[0]}function _t(){let g=J+M,S=ie+O,P=J,I=ie;function V($,se){switch($){case 1:return g+=se,g-se;case 2:return S+=se,S-se;case 3:return P-=se,P+se;case 0:return I-=se,I+se}}w.forEach(($,se)=>{if($.show&&$._show){let ce=$.side;$._pos=V(ce,$._size),$.label!=null&&($._lpos=V(ce,$.labelSize))}})}if(ge.dataIdx==null){let g=ge.hover,S=g.skip=new Set(g.skip??[]);S.add(void 0);let P=g.prox=pt(g.prox),I=g.bias??=0;ge.dataIdx=(V,$,se,ce)=>{if($==0)return se;let _e=se,Ae=P(V,$,se,ce)??Nt,Ce=Ae>=0&&Ae<Nt,Ue=C.ori==0?M:O,it=ge.left,St=e[0],vt=e[$];if(S.has(vt[se])){_e=null;let ht=null,je=null,Ve;if(I==0||I==-1)for(Ve=se;ht==null&&Ve-- >0;)S.has(vt[Ve])||(ht=Ve);if(I==0||I==1)for(Ve=se;je==null&&Ve++<vt.length;)S.has(vt[Ve])||(je=Ve);if(ht!=null||je!=null)if(Ce){let Xt=ht==null?-1/0:z(St[ht],C,Ue,0),Jt=je==null?1/0:z(St[je],C,Ue,0),En=it-Xt,Pt=Jt-it;En<=Pt?En<=Ae&&(_e=ht):Pt<=Ae&&(_e=je)}else _e=je==null?ht:ht==null?je:se-ht<=je-se?ht:je}else Ce&&fn(it-z(St[se],C,Ue,0))>Ae&&(_e=null);return _e}}const wn=g=>{ge.event=g};ge.idxs=me,ge._lock=!1;let It=ge.points;It.show=pt(It.show),It.size=pt(It.size),It.stroke=pt(It.stroke),It.width=pt(It.width),It.fill=pt(It.fill);const Jn=i.focus=an({},n.focus||{alpha:.3},ge.focus),qn=Jn.prox>=0,Li=qn&&It.one;let On=[],$i=[],yi=[];function yo(g,S){let P=It.show(i,S);if(P instanceof HTMLElement)return si(P,l0),si(P,g.class),ki(P,-10,-10,M,O),_.insertBefore(P,On[S]),P}function Bs(g,S){if(s==1||S>0){let P=s==1&&x[g.scale].time,I=g.value;g.value=P?rd(I)?fd(j,ud(I,q)):I||ae:I||Sv,g.label=g.label||(P?pv:dv)}if(Li||S>0){g.width=g.width==null?1:g.width,g.paths=g.paths||Fv||T0,g.fillTo=pt(g.fillTo||Av),g.pxAlign=+Mt(g.pxAlign,v),g.pxRound=yd(g.pxAlign),g.stroke=pt(g.stroke||null),g.fill=pt(g.fill||null),g._stroke=g._fill=g._paths=g._focus=null;let P=Ev(Wn(1,g.width),1),I=g.points=an({},{size:P,width:Wn(1,P*.2),stroke:g.stroke,space:P*2,paths:Ov,_stroke:null,_fill:null},g.points);I.show=pt(I.show),I.filter=pt(I.filter),I.fill=pt(I.fill),I.stroke=pt(I.stroke),I.paths=pt(I.paths),I.pxAlign=g.pxAlign}if(Qe){let P=Tt(g,S);Me.splice(S,0,P[0]),tt.splice(S,0,P[1]),xe.values.push(null)}if(et){me.splice(S,0,null);let P=null;Li?S==0&&(P=yo(g,S)):S>0&&(P=yo(g,S)),On.splice(S,0,P),$i.splice(S,0,0),yi.splice(S,0,0)}Sn("addSeries",S)}function ba(g,S){S=S??y.length,g=s==1?Th(g,S,pd,xd):Th(g,S,{},vd),y.splice(S,0,g),Bs(y[S],S)}i.addSeries=ba;function wa(g){if(y.splice(g,1),Qe){xe.values.splice(g,1),tt.splice(g,1);let S=Me.splice(g,1)[0];Vt(null,S.firstChild),S.remove()}et&&(me.splice(g,1),On.splice(g,1)[0].remove(),$i.splice(g,1),yi.splice(g,1)),Sn("delSeries",g)}i.delSeries=wa;const ji=[!1,!1,!1,!1];function rc(g,S){if(g._show=g.show,g.show){let P=g.side%2,I=x[g.scale];I==null&&(g.scale=P?y[1].scale:A,I=x[g.scale]);let V=I.time;g.size=pt(g.size),g.space=pt(g.space),g.rotate=pt(g.rotate),Rs(g.incrs)&&g.incrs.forEach(se=>{!Fs.has(se)&&Fs.set(se,Um(se))}),g.incrs=pt(g.incrs||(I.distr==2?$0:V?p==1?Z0:Q0:Qs)),g.splits=pt(g.splits||(V&&I.distr==1?K:I.distr==3?Sh:I.distr==4?gv:_v)),g.stroke=pt(g.stroke),g.grid.stroke=pt(g.grid.stroke),g.ticks.stroke=pt(g.ticks.stroke),g.border.stroke=pt(g.border.stroke);let $=g.values;g.values=Rs($)&&!Rs($[0])?pt($):V?Rs($)?hd(j,cd($,q)):rd($)?nv(j,$):$||re:$||mv,g.filter=pt(g.filter||(I.distr>=3&&I.log==10?Mv:I.distr==3&&I.log==2?yv:Lm)),g.font=wd(g.font),g.labelFont=wd(g.labelFont),g._size=g.size(i,null,S,0),g._space=g._rotate=g._incrs=g._found=g._splits=g._values=null,g._size>0&&(ji[S]=!0,g._el=fi(s0,d))}}function zs(g,S,P,I){let[V,$,se,ce]=P,_e=S%2,Ae=0;return _e==0&&(ce||$)&&(Ae=S==0&&!V||S==2&&!se?un(dd.size/3):0),_e==1&&(V||se)&&(Ae=S==1&&!$||S==3&&!ce?un(_d.size/2):0),Ae}const Ta=i.padding=(n.padding||[zs,zs,zs,zs]).map(g=>pt(Mt(g,zs))),Ii=i._padding=Ta.map((g,S)=>g(i,S,ji,0));let cn,T=null,G=null;const Q=s==1?y[0].idxs:null;let Z=null,X=!1;function de(g,S){if(e=g??[],i.data=i._data=e,s==2){cn=0;for(let P=1;P<y.length;P++)cn+=e[P][0].length}else{e.length==0&&(i.data=i._data=e=[[]]),Z=e[0],cn=Z.length;let P=e;if(B==2){P=e.slice();let I=P[0]=Array(cn);for(let V=0;V<cn;V++)I[V]=V}i._data=e=P}if(Mr(!0),Sn("setData"),B==2&&(Ze=!0),S!==!1){let P=C;P.auto(i,X)?Se():ms(A,P.min,P.max),H=H||ge.left>=0,pe=!0,yr()}}i.setData=de;function Se(){X=!0;let g,S;s==1&&(cn>0?(T=Q[0]=0,G=Q[1]=cn-1,g=e[0][T],S=e[0][G],B==2?(g=T,S=G):g==S&&(B==3?[g,S]=$l(g,g,C.log,!1):B==4?[g,S]=Lu(g,g,C.log,!1):C.time?S=g+un(86400/p):[g,S]=Nl(g,S,Iu,!0))):(T=Q[0]=g=null,G=Q[1]=S=null)),ms(A,g,S)}let Ie,Te,Ye,qe,He,ot,gt,Bt,At,st;function Xe(g,S,P,I,V,$){g??=Vf,P??=Nu,I??="butt",V??=Vf,$??="round",g!=Ie&&(f.strokeStyle=Ie=g),V!=Te&&(f.fillStyle=Te=V),S!=Ye&&(f.lineWidth=Ye=S),$!=He&&(f.lineJoin=He=$),I!=ot&&(f.lineCap=ot=I),P!=qe&&f.setLineDash(qe=P)}function zt(g,S,P,I){S!=Te&&(f.fillStyle=Te=S),g!=gt&&(f.font=gt=g),P!=Bt&&(f.textAlign=Bt=P),I!=At&&(f.textBaseline=At=I)}function dt(g,S,P,I,V=0){if(I.length>0&&g.auto(i,X)&&(S==null||S.min==null)){let $=Mt(T,0),se=Mt(G,I.length-1),ce=P.min==null?M0(I,$,se,V,g.distr==3):[P.min,P.max];g.min=Ci(g.min,P.min=ce[0]),g.max=Wn(g.max,P.max=ce[1])}}const Dn={min:null,max:null};function fs(){for(let I in x){let V=x[I];W[I]==null&&(V.min==null||W[A]!=null&&V.auto(i,X))&&(W[I]=Dn)}for(let I in x){let V=x[I];W[I]==null&&V.from!=null&&W[V.from]!=null&&(W[I]=Dn)}W[A]!=null&&Mr(!0);let g={};for(let I in W){let V=W[I];if(V!=null){let $=g[I]=oo(x[I],C0);if(V.min!=null)an($,V);else if(I!=A||s==2)if(cn==0&&$.from==null){let se=$.range(i,null,null,I);$.min=se[0],$.max=se[1]}else $.min=Nt,$.max=-Nt}}if(cn>0){y.forEach((I,V)=>{if(s==1){let $=I.scale,se=W[$];if(se==null)return;let ce=g[$];if(V==0){let _e=ce.range(i,ce.min,ce.max,$);ce.min=_e[0],ce.max=_e[1],T=Ri(ce.min,e[0]),G=Ri(ce.max,e[0]),G-T>1&&(e[0][T]<ce.min&&T++,e[0][G]>ce.max&&G--),I.min=Z[T],I.max=Z[G]}else I.show&&I.auto&&dt(ce,se,I,e[V],I.sorted);I.idxs[0]=T,I.idxs[1]=G}else if(V>0&&I.show&&I.auto){let[$,se]=I.facets,ce=$.scale,_e=se.scale,[Ae,Ce]=e[V],Ue=g[ce],it=g[_e];Ue!=null&&dt(Ue,W[ce],$,Ae,$.sorted),it!=null&&dt(it,W[_e],se,Ce,se.sorted),I.min=se.min,I.max=se.max}});for(let I in g){let V=g[I],$=W[I];if(V.from==null&&($==null||$.min==null)){let se=V.range(i,V.min==Nt?null:V.min,V.max==-Nt?null:V.max,I);V.min=se[0],V.max=se[1]}}}for(let I in g){let V=g[I];if(V.from!=null){let $=g[V.from];if($.min==null)V.min=V.max=null;else{let se=V.range(i,$.min,$.max,I);V.min=se[0],V.max=se[1]}}}let S={},P=!1;for(let I in g){let V=g[I],$=x[I];if($.min!=V.min||$.max!=V.max){$.min=V.min,$.max=V.max;let se=$.distr;$._min=se==3?ss($.min):se==4?Sc($.min,$.asinh):se==100?$.fwd($.min):$.min,$._max=se==3?ss($.max):se==4?Sc($.max,$.asinh):se==100?$.fwd($.max):$.max,S[I]=P=!0}}if(P){y.forEach((I,V)=>{s==2?V>0&&S.y&&(I._paths=null):S[I.scale]&&(I._paths=null)});for(let I in S)Ze=!0,Sn("setScale",I);et&&ge.left>=0&&(H=pe=!0)}for(let I in W)W[I]=null}function kn(g){let S=yh(T-1,0,cn-1),P=yh(G+1,0,cn-1);for(;g[S]==null&&S>0;)S--;for(;g[P]==null&&P<cn-1;)P++;return[S,P]}function Hs(){if(cn>0){let g=y.some(S=>S._focus)&&st!=Jn.alpha;g&&(f.globalAlpha=st=Jn.alpha),y.forEach((S,P)=>{if(P>0&&S.show&&(Ht(P,!1),Ht(P,!0),S._paths==null)){let I=st;st!=S.alpha&&(f.globalAlpha=st=S.alpha);let V=s==2?[0,e[P][0].length-1]:kn(e[P]);S._paths=S.paths(i,P,V[0],V[1]),st!=I&&(f.globalAlpha=st=I)}}),y.forEach((S,P)=>{if(P>0&&S.show){let I=st;st!=S.alpha&&(f.globalAlpha=st=S.alpha),S._paths!=null&&Bn(P,!1);{let V=S._paths!=null?S._paths.gaps:null,$=S.points.show(i,P,T,G,V),se=S.points.filter(i,P,$,V);($||se)&&(S.points._paths=S.points.paths(i,P,T,G,se),Bn(P,!0))}st!=I&&(f.globalAlpha=st=I),Sn("drawSeries",P)}}),g&&(f.globalAlpha=st=1)}}function Ht(g,S){let P=S?y[g].points:y[g];P._stroke=P.stroke(i,g),P._fill=P.fill(i,g)}function Bn(g,S){let P=S?y[g].points:y[g],{stroke:I,fill:V,clip:$,flags:se,_stroke:ce=P._stroke,_fill:_e=P._fill,_width:Ae=P.width}=P._paths;Ae=Ft(Ae*Et,3);let Ce=null,Ue=Ae%2/2;S&&_e==null&&(_e=Ae>0?"#fff":ce);let it=P.pxAlign==1&&Ue>0;if(it&&f.translate(Ue,Ue),!S){let St=Re-Ae/2,vt=le-Ae/2,ht=ve+Ae,je=Be+Ae;Ce=new Path2D,Ce.rect(St,vt,ht,je)}S?xn(ce,Ae,P.dash,P.cap,_e,I,V,se,$):$n(g,ce,Ae,P.dash,P.cap,_e,I,V,se,Ce,$),it&&f.translate(-Ue,-Ue)}function $n(g,S,P,I,V,$,se,ce,_e,Ae,Ce){let Ue=!1;_e!=0&&L.forEach((it,St)=>{if(it.series[0]==g){let vt=y[it.series[1]],ht=e[it.series[1]],je=(vt._paths||aa).band;Rs(je)&&(je=it.dir==1?je[0]:je[1]);let Ve,Xt=null;vt.show&&je&&S0(ht,T,G)?(Xt=it.fill(i,St)||$,Ve=vt._paths.clip):je=null,xn(S,P,I,V,Xt,se,ce,_e,Ae,Ce,Ve,je),Ue=!0}}),Ue||xn(S,P,I,V,$,se,ce,_e,Ae,Ce)}const vn=ao|bh;function xn(g,S,P,I,V,$,se,ce,_e,Ae,Ce,Ue){Xe(g,S,P,I,V),(_e||Ae||Ue)&&(f.save(),_e&&f.clip(_e),Ae&&f.clip(Ae)),Ue?(ce&vn)==vn?(f.clip(Ue),Ce&&f.clip(Ce),li(V,se),ds(g,$,S)):ce&bh?(li(V,se),f.clip(Ue),ds(g,$,S)):ce&ao&&(f.save(),f.clip(Ue),Ce&&f.clip(Ce),li(V,se),f.restore(),ds(g,$,S)):(li(V,se),ds(g,$,S)),(_e||Ae||Ue)&&f.restore()}function ds(g,S,P){P>0&&(S instanceof Map?S.forEach((I,V)=>{f.strokeStyle=Ie=V,f.stroke(I)}):S!=null&&g&&f.stroke(S))}function li(g,S){S instanceof Map?S.forEach((P,I)=>{f.fillStyle=Te=I,f.fill(P)}):S!=null&&g&&f.fill(S)}function K_(g,S,P,I){let V=w[g],$;if(I<=0)$=[0,0];else{let se=V._space=V.space(i,g,S,P,I),ce=V._incrs=V.incrs(i,g,S,P,I,se);$=Gv(S,P,ce,I,se)}return V._found=$}function oc(g,S,P,I,V,$,se,ce,_e,Ae){let Ce=se%2/2;v==1&&f.translate(Ce,Ce),Xe(ce,se,_e,Ae,ce),f.beginPath();let Ue,it,St,vt,ht=V+(I==0||I==3?-$:$);P==0?(it=V,vt=ht):(Ue=V,St=ht);for(let je=0;je<g.length;je++)S[je]!=null&&(P==0?Ue=St=g[je]:it=vt=g[je],f.moveTo(Ue,it),f.lineTo(St,vt));f.stroke(),v==1&&f.translate(-Ce,-Ce)}function J_(g){let S=!0;return w.forEach((P,I)=>{if(!P.show)return;let V=x[P.scale];if(V.min==null){P._show&&(S=!1,P._show=!1,Mr(!1));return}else P._show||(S=!1,P._show=!0,Mr(!1));let $=P.side,se=$%2,{min:ce,max:_e}=V,[Ae,Ce]=K_(I,ce,_e,se==0?M:O);if(Ce==0)return;let Ue=V.distr==2,it=P._splits=P.splits(i,I,ce,_e,Ae,Ce,Ue),St=V.distr==2?it.map(Ve=>Z[Ve]):it,vt=V.distr==2?Z[it[1]]-Z[it[0]]:Ae,ht=P._values=P.values(i,P.filter(i,St,I,Ce,vt),I,Ce,vt);P._rotate=$==2?P.rotate(i,ht,I,Ce):0;let je=P._size;P._size=pi(P.size(i,ht,I,g)),je!=null&&P._size!=je&&(S=!1)}),S}function Q_(g){let S=!0;return Ta.forEach((P,I)=>{let V=P(i,I,ji,g);V!=Ii[I]&&(S=!1),Ii[I]=V}),S}function eg(){for(let g=0;g<w.length;g++){let S=w[g];if(!S.show||!S._show)continue;let P=S.side,I=P%2,V,$,se=S.stroke(i,g),ce=P==0||P==3?-1:1,[_e,Ae]=S._found;if(S.label!=null){let Hn=S.labelGap*ce,ti=un((S._lpos+Hn)*Et);zt(S.labelFont[0],se,"center",P==2?Ao:Hf),f.save(),I==1?(V=$=0,f.translate(ti,un(le+Be/2)),f.rotate((P==3?-ml:ml)/2)):(V=un(Re+ve/2),$=ti);let Ws=Pm(S.label)?S.label(i,g,_e,Ae):S.label;f.fillText(Ws,V,$),f.restore()}if(Ae==0)continue;let Ce=x[S.scale],Ue=I==0?ve:Be,it=I==0?Re:le,St=S._splits,vt=Ce.distr==2?St.map(Hn=>Z[Hn]):St,ht=Ce.distr==2?Z[St[1]]-Z[St[0]]:_e,je=S.ticks,Ve=S.border,Xt=je.show?je.size:0,Jt=un(Xt*Et),En=un((S.alignTo==2?S._size-Xt-S.gap:S.gap)*Et),Pt=S._rotate*-ml/180,Qt=m(S._pos*Et),Qn=(Jt+En)*ce,zn=Qt+Qn;$=I==0?zn:0,V=I==1?zn:0;let ci=S.font[0],Si=S.align==1?Pr:S.align==2?xc:Pt>0?Pr:Pt<0?xc:I==0?"center":P==3?xc:Pr,Fi=Pt||I==1?"middle":P==2?Ao:Hf;zt(ci,se,Si,Fi);let ei=S.font[1]*S.lineGap,hi=St.map(Hn=>m(a(Hn,Ce,Ue,it))),Ei=S._values;for(let Hn=0;Hn<Ei.length;Hn++){let ti=Ei[Hn];if(ti!=null){I==0?V=hi[Hn]:$=hi[Hn],ti=""+ti;let Ws=ti.indexOf(`
`)==-1?[ti]:ti.split(/\n/gm);for(let Vn=0;Vn<Ws.length;Vn++){let Af=Ws[Vn];Pt?(f.save(),f.translate(V,$+Vn*ei),f.rotate(Pt),f.fillText(Af,0,0),f.restore()):f.fillText(Af,V,$+Vn*ei)}}}je.show&&oc(hi,je.filter(i,vt,g,Ae,ht),I,P,Qt,Jt,Ft(je.width*Et,3),je.stroke(i,g),je.dash,je.cap);let Oi=S.grid;Oi.show&&oc(hi,Oi.filter(i,vt,g,Ae,ht),I,I==0?2:1,I==0?le:Re,I==0?Be:ve,Ft(Oi.width*Et,3),Oi.stroke(i,g),Oi.dash,Oi.cap),Ve.show&&oc([Qt],[1],I==0?1:0,I==0?1:2,I==1?le:Re,I==1?Be:ve,Ft(Ve.width*Et,3),Ve.stroke(i,g),Ve.dash,Ve.cap)}Sn("drawAxes")}function Mr(g){y.forEach((S,P)=>{P>0&&(S._paths=null,g&&(s==1?(S.min=null,S.max=null):S.facets.forEach(I=>{I.min=null,I.max=null})))})}let Aa=!1,ac=!1,So=[];function tg(){ac=!1;for(let g=0;g<So.length;g++)Sn(...So[g]);So.length=0}function yr(){Aa||(F0(cf),Aa=!0)}function ng(g,S=!1){Aa=!0,ac=S,g(i),cf(),S&&So.length>0&&queueMicrotask(tg)}i.batch=ng;function cf(){if(ke&&(fs(),ke=!1),Ze&&(Oe(),Ze=!1),ye){if(Yt(u,Pr,J),Yt(u,Ao,ie),Yt(u,qo,M),Yt(u,$o,O),Yt(_,Pr,J),Yt(_,Ao,ie),Yt(_,qo,M),Yt(_,$o,O),Yt(d,qo,yt),Yt(d,$o,D),h.width=un(yt*Et),h.height=un(D*Et),w.forEach(({_el:g,_show:S,_size:P,_pos:I,side:V})=>{if(g!=null)if(S){let $=V===3||V===0?P:0,se=V%2==1;Yt(g,se?"left":"top",I-$),Yt(g,se?"width":"height",P),Yt(g,se?"top":"left",se?ie:J),Yt(g,se?"height":"width",se?O:M),xh(g,ir)}else si(g,ir)}),Ie=Te=Ye=He=ot=gt=Bt=At=qe=null,st=1,wo(!0),J!=te||ie!=Fe||M!=ue||O!=Le){Mr(!1);let g=M/ue,S=O/Le;if(et&&!H&&ge.left>=0){ge.left*=g,ge.top*=S,Sr&&ki(Sr,un(ge.left),0,M,O),Er&&ki(Er,0,un(ge.top),M,O);for(let P=0;P<On.length;P++){let I=On[P];I!=null&&($i[P]*=g,yi[P]*=S,ki(I,pi($i[P]),pi(yi[P]),M,O))}}if(Wt.show&&!fe&&Wt.left>=0&&Wt.width>0){Wt.left*=g,Wt.width*=g,Wt.top*=S,Wt.height*=S;for(let P in dc)Yt(Tr,P,Wt[P])}te=J,Fe=ie,ue=M,Le=O}Sn("setSize"),ye=!1}yt>0&&D>0&&(f.clearRect(0,0,h.width,h.height),Sn("drawClear"),N.forEach(g=>g()),Sn("draw")),Wt.show&&fe&&(Ra(Wt),fe=!1),et&&H&&(Gs(null,!0,!1),H=!1),xe.show&&xe.live&&pe&&(uc(),pe=!1),l||(l=!0,i.status=1,Sn("ready")),X=!1,Aa=!1}i.redraw=(g,S)=>{Ze=S||!1,g!==!1?ms(A,C.min,C.max):yr()};function lc(g,S){let P=x[g];if(P.from==null){if(cn==0){let I=P.range(i,S.min,S.max,g);S.min=I[0],S.max=I[1]}if(S.min>S.max){let I=S.min;S.min=S.max,S.max=I}if(cn>1&&S.min!=null&&S.max!=null&&S.max-S.min<1e-16)return;g==A&&P.distr==2&&cn>0&&(S.min=Ri(S.min,e[0]),S.max=Ri(S.max,e[0]),S.min==S.max&&S.max++),W[g]=S,ke=!0,yr()}}i.setScale=lc;let cc,hc,Sr,Er,hf,uf,br,wr,ff,df,Gt,$t,ps=!1;const Tn=ge.drag;let Mn=Tn.x,yn=Tn.y;et&&(ge.x&&(cc=fi(o0,_)),ge.y&&(hc=fi(a0,_)),C.ori==0?(Sr=cc,Er=hc):(Sr=hc,Er=cc),Gt=ge.left,$t=ge.top);const Wt=i.select=an({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),Tr=Wt.show?fi(r0,Wt.over?_:u):null;function Ra(g,S){if(Wt.show){for(let P in g)Wt[P]=g[P],P in dc&&Yt(Tr,P,g[P]);S!==!1&&Sn("setSelect")}}i.setSelect=Ra;function ig(g){if(y[g].show)Qe&&xh(Me[g],ir);else if(Qe&&si(Me[g],ir),et){let P=Li?On[0]:On[g];P!=null&&ki(P,-10,-10,M,O)}}function ms(g,S,P){lc(g,{min:S,max:P})}function Ui(g,S,P,I){S.focus!=null&&lg(g),S.show!=null&&y.forEach((V,$)=>{$>0&&(g==$||g==null)&&(V.show=S.show,ig($),s==2?(ms(V.facets[0].scale,null,null),ms(V.facets[1].scale,null,null)):ms(V.scale,null,null),yr())}),P!==!1&&Sn("setSeries",g,S),I&&To("setSeries",i,g,S)}i.setSeries=Ui;function sg(g,S){an(L[g],S)}function rg(g,S){g.fill=pt(g.fill||null),g.dir=Mt(g.dir,-1),S=S??L.length,L.splice(S,0,g)}function og(g){g==null?L.length=0:L.splice(g,1)}i.addBand=rg,i.setBand=sg,i.delBand=og;function ag(g,S){y[g].alpha=S,et&&On[g]!=null&&(On[g].style.opacity=S),Qe&&Me[g]&&(Me[g].style.opacity=S)}let Zi,_s,Vs;const Ar={focus:!0};function lg(g){if(g!=Vs){let S=g==null,P=Jn.alpha!=1;y.forEach((I,V)=>{if(s==1||V>0){let $=S||V==0||V==g;I._focus=S?null:$,P&&ag(V,$?1:Jn.alpha)}}),Vs=g,P&&yr()}}Qe&&qn&&Ge(Xf,ne,g=>{ge._lock||(wn(g),Vs!=null&&Ui(null,Ar,!0,sn.setSeries))});function Ni(g,S,P){let I=x[S];P&&(g=g/Et-(I.ori==1?ie:J));let V=M;I.ori==1&&(V=O,g=V-g),I.dir==-1&&(g=V-g);let $=I._min,se=I._max,ce=g/V,_e=$+(se-$)*ce,Ae=I.distr;return Ae==3?so(10,_e):Ae==4?b0(_e,I.asinh):Ae==100?I.bwd(_e):_e}function cg(g,S){let P=Ni(g,A,S);return Ri(P,e[0],T,G)}i.valToIdx=g=>Ri(g,e[0]),i.posToIdx=cg,i.posToVal=Ni,i.valToPos=(g,S,P)=>x[S].ori==0?r(g,x[S],P?ve:M,P?Re:0):o(g,x[S],P?Be:O,P?le:0),i.setCursor=(g,S,P)=>{Gt=g.left,$t=g.top,Gs(null,S,P)};function pf(g,S){Yt(Tr,Pr,Wt.left=g),Yt(Tr,qo,Wt.width=S)}function mf(g,S){Yt(Tr,Ao,Wt.top=g),Yt(Tr,$o,Wt.height=S)}let Eo=C.ori==0?pf:mf,bo=C.ori==1?pf:mf;function hg(){if(Qe&&xe.live)for(let g=s==2?1:0;g<y.length;g++){if(g==0&&F)continue;let S=xe.values[g],P=0;for(let I in S)tt[g][P++].firstChild.nodeValue=S[I]}}function uc(g,S){if(g!=null&&(g.idxs?g.idxs.forEach((P,I)=>{me[I]=P}):R0(g.idx)||me.fill(g.idx),xe.idx=me[0]),Qe&&xe.live){for(let P=0;P<y.length;P++)(P>0||s==1&&!F)&&ug(P,me[P]);hg()}pe=!1,S!==!1&&Sn("setLegend")}i.setLegend=uc;function ug(g,S){let P=y[g],I=g==0&&B==2?Z:e[g],V;F?V=P.values(i,g,S)??mt:(V=P.value(i,S==null?null:I[S],g,S),V=V==null?mt:{_:V}),xe.values[g]=V}function Gs(g,S,P){ff=Gt,df=$t,[Gt,$t]=ge.move(i,Gt,$t),ge.left=Gt,ge.top=$t,et&&(Sr&&ki(Sr,un(Gt),0,M,O),Er&&ki(Er,0,un($t),M,O));let I,V=T>G;Zi=Nt,_s=null;let $=C.ori==0?M:O,se=C.ori==1?M:O;if(Gt<0||cn==0||V){I=ge.idx=null;for(let ce=0;ce<y.length;ce++){let _e=On[ce];_e!=null&&ki(_e,-10,-10,M,O)}qn&&Ui(null,Ar,!0,g==null&&sn.setSeries),xe.live&&(me.fill(I),pe=!0)}else{let ce,_e,Ae;s==1&&(ce=C.ori==0?Gt:$t,_e=Ni(ce,A),I=ge.idx=Ri(_e,e[0],T,G),Ae=z(e[0][I],C,$,0));let Ce=-10,Ue=-10,it=0,St=0,vt=!0,ht="",je="";for(let Ve=s==2?1:0;Ve<y.length;Ve++){let Xt=y[Ve],Jt=me[Ve],En=Jt==null?null:s==1?e[Ve][Jt]:e[Ve][1][Jt],Pt=ge.dataIdx(i,Ve,I,_e),Qt=Pt==null?null:s==1?e[Ve][Pt]:e[Ve][1][Pt];if(pe=pe||Qt!=En||Pt!=Jt,me[Ve]=Pt,Ve>0&&Xt.show){let Qn=Pt==null?-10:Pt==I?Ae:z(s==1?e[0][Pt]:e[Ve][0][Pt],C,$,0),zn=Qt==null?-10:Y(Qt,s==1?x[Xt.scale]:x[Xt.facets[1].scale],se,0);if(qn&&Qt!=null){let ci=C.ori==1?Gt:$t,Si=fn(Jn.dist(i,Ve,Pt,zn,ci));if(Si<Zi){let Fi=Jn.bias;if(Fi!=0){let ei=Ni(ci,Xt.scale),hi=Qt>=0?1:-1,Ei=ei>=0?1:-1;Ei==hi&&(Ei==1?Fi==1?Qt>=ei:Qt<=ei:Fi==1?Qt<=ei:Qt>=ei)&&(Zi=Si,_s=Ve)}else Zi=Si,_s=Ve}}if(pe||Li){let ci,Si;C.ori==0?(ci=Qn,Si=zn):(ci=zn,Si=Qn);let Fi,ei,hi,Ei,Oi,Hn,ti=!0,Ws=It.bbox;if(Ws!=null){ti=!1;let Vn=Ws(i,Ve);hi=Vn.left,Ei=Vn.top,Fi=Vn.width,ei=Vn.height}else hi=ci,Ei=Si,Fi=ei=It.size(i,Ve);if(Hn=It.fill(i,Ve),Oi=It.stroke(i,Ve),Li)Ve==_s&&Zi<=Jn.prox&&(Ce=hi,Ue=Ei,it=Fi,St=ei,vt=ti,ht=Hn,je=Oi);else{let Vn=On[Ve];Vn!=null&&($i[Ve]=hi,yi[Ve]=Ei,Jf(Vn,Fi,ei,ti),Zf(Vn,Hn,Oi),ki(Vn,pi(hi),pi(Ei),M,O))}}}}if(Li){let Ve=Jn.prox,Xt=Vs==null?Zi<=Ve:Zi>Ve||_s!=Vs;if(pe||Xt){let Jt=On[0];Jt!=null&&($i[0]=Ce,yi[0]=Ue,Jf(Jt,it,St,vt),Zf(Jt,ht,je),ki(Jt,pi(Ce),pi(Ue),M,O))}}}if(Wt.show&&ps)if(g!=null){let[ce,_e]=sn.scales,[Ae,Ce]=sn.match,[Ue,it]=g.cursor.sync.scales,St=g.cursor.drag;if(Mn=St._x,yn=St._y,Mn||yn){let{left:vt,top:ht,width:je,height:Ve}=g.select,Xt=g.scales[Ue].ori,Jt=g.posToVal,En,Pt,Qt,Qn,zn,ci=ce!=null&&Ae(ce,Ue),Si=_e!=null&&Ce(_e,it);ci&&Mn?(Xt==0?(En=vt,Pt=je):(En=ht,Pt=Ve),Qt=x[ce],Qn=z(Jt(En,Ue),Qt,$,0),zn=z(Jt(En+Pt,Ue),Qt,$,0),Eo(Ci(Qn,zn),fn(zn-Qn))):Eo(0,$),Si&&yn?(Xt==1?(En=vt,Pt=je):(En=ht,Pt=Ve),Qt=x[_e],Qn=Y(Jt(En,it),Qt,se,0),zn=Y(Jt(En+Pt,it),Qt,se,0),bo(Ci(Qn,zn),fn(zn-Qn))):bo(0,se)}else pc()}else{let ce=fn(ff-hf),_e=fn(df-uf);if(C.ori==1){let it=ce;ce=_e,_e=it}Mn=Tn.x&&ce>=Tn.dist,yn=Tn.y&&_e>=Tn.dist;let Ae=Tn.uni;Ae!=null?Mn&&yn&&(Mn=ce>=Ae,yn=_e>=Ae,!Mn&&!yn&&(_e>ce?yn=!0:Mn=!0)):Tn.x&&Tn.y&&(Mn||yn)&&(Mn=yn=!0);let Ce,Ue;Mn&&(C.ori==0?(Ce=br,Ue=Gt):(Ce=wr,Ue=$t),Eo(Ci(Ce,Ue),fn(Ue-Ce)),yn||bo(0,se)),yn&&(C.ori==1?(Ce=br,Ue=Gt):(Ce=wr,Ue=$t),bo(Ci(Ce,Ue),fn(Ue-Ce)),Mn||Eo(0,$)),!Mn&&!yn&&(Eo(0,0),bo(0,0))}if(Tn._x=Mn,Tn._y=yn,g==null){if(P){if(Tf!=null){let[ce,_e]=sn.scales;sn.values[0]=ce!=null?Ni(C.ori==0?Gt:$t,ce):null,sn.values[1]=_e!=null?Ni(C.ori==1?Gt:$t,_e):null}To(Mc,i,Gt,$t,M,O,I)}if(qn){let ce=P&&sn.setSeries,_e=Jn.prox;Vs==null?Zi<=_e&&Ui(_s,Ar,!0,ce):Zi>_e?Ui(null,Ar,!0,ce):_s!=Vs&&Ui(_s,Ar,!0,ce)}}pe&&(xe.idx=I,uc()),S!==!1&&Sn("setCursor")}let gs=null;Object.defineProperty(i,"rect",{get(){return gs==null&&wo(!1),gs}});function wo(g=!1){g?gs=null:(gs=_.getBoundingClientRect(),Sn("syncRect",gs))}function _f(g,S,P,I,V,$,se){ge._lock||ps&&g!=null&&g.movementX==0&&g.movementY==0||(fc(g,S,P,I,V,$,se,!1,g!=null),g!=null?Gs(null,!0,!0):Gs(S,!0,!1))}function fc(g,S,P,I,V,$,se,ce,_e){if(gs==null&&wo(!1),wn(g),g!=null)P=g.clientX-gs.left,I=g.clientY-gs.top;else{if(P<0||I<0){Gt=-10,$t=-10;return}let[Ae,Ce]=sn.scales,Ue=S.cursor.sync,[it,St]=Ue.values,[vt,ht]=Ue.scales,[je,Ve]=sn.match,Xt=S.axes[0].side%2==1,Jt=C.ori==0?M:O,En=C.ori==1?M:O,Pt=Xt?$:V,Qt=Xt?V:$,Qn=Xt?I:P,zn=Xt?P:I;if(vt!=null?P=je(Ae,vt)?a(it,x[Ae],Jt,0):-10:P=Jt*(Qn/Pt),ht!=null?I=Ve(Ce,ht)?a(St,x[Ce],En,0):-10:I=En*(zn/Qt),C.ori==1){let ci=P;P=I,I=ci}}_e&&(S==null||S.cursor.event.type==Mc)&&((P<=1||P>=M-1)&&(P=Js(P,M)),(I<=1||I>=O-1)&&(I=Js(I,O))),ce?(hf=P,uf=I,[br,wr]=ge.move(i,P,I)):(Gt=P,$t=I)}const dc={width:0,height:0,left:0,top:0};function pc(){Ra(dc,!1)}let gf,vf,xf,Mf;function yf(g,S,P,I,V,$,se){ps=!0,Mn=yn=Tn._x=Tn._y=!1,fc(g,S,P,I,V,$,se,!0,!1),g!=null&&(Ge(yc,gh,Sf,!1),To(Gf,i,br,wr,M,O,null));let{left:ce,top:_e,width:Ae,height:Ce}=Wt;gf=ce,vf=_e,xf=Ae,Mf=Ce}function Sf(g,S,P,I,V,$,se){ps=Tn._x=Tn._y=!1,fc(g,S,P,I,V,$,se,!1,!0);let{left:ce,top:_e,width:Ae,height:Ce}=Wt,Ue=Ae>0||Ce>0,it=gf!=ce||vf!=_e||xf!=Ae||Mf!=Ce;if(Ue&&it&&Ra(Wt),Tn.setScale&&Ue&&it){let St=ce,vt=Ae,ht=_e,je=Ce;if(C.ori==1&&(St=_e,vt=Ce,ht=ce,je=Ae),Mn&&ms(A,Ni(St,A),Ni(St+vt,A)),yn)for(let Ve in x){let Xt=x[Ve];Ve!=A&&Xt.from==null&&Xt.min!=Nt&&ms(Ve,Ni(ht+je,Ve),Ni(ht,Ve))}pc()}else ge.lock&&(ge._lock=!ge._lock,Gs(S,!0,g!=null));g!=null&&(Vt(yc,gh),To(yc,i,Gt,$t,M,O,null))}function fg(g,S,P,I,V,$,se){if(ge._lock)return;wn(g);let ce=ps;if(ps){let _e=!0,Ae=!0,Ce=10,Ue,it;C.ori==0?(Ue=Mn,it=yn):(Ue=yn,it=Mn),Ue&&it&&(_e=Gt<=Ce||Gt>=M-Ce,Ae=$t<=Ce||$t>=O-Ce),Ue&&_e&&(Gt=Gt<br?0:M),it&&Ae&&($t=$t<wr?0:O),Gs(null,!0,!0),ps=!1}Gt=-10,$t=-10,me.fill(null),Gs(null,!0,!0),ce&&(ps=ce)}function Ef(g,S,P,I,V,$,se){ge._lock||(wn(g),Se(),pc(),g!=null&&To(Yf,i,Gt,$t,M,O,null))}function bf(){w.forEach(Wv),De(i.width,i.height,!0)}ur(Ul,Kr,bf);const Rr={};Rr.mousedown=yf,Rr.mousemove=_f,Rr.mouseup=Sf,Rr.dblclick=Ef,Rr.setSeries=(g,S,P,I)=>{let V=sn.match[2];P=V(i,S,P),P!=-1&&Ui(P,I,!0,!1)},et&&(Ge(Gf,_,yf),Ge(Mc,_,_f),Ge(Wf,_,g=>{wn(g),wo(!1)}),Ge(Xf,_,fg),Ge(Yf,_,Ef),wh.add(i),i.syncRect=wo);const Ca=i.hooks=n.hooks||{};function Sn(g,S,P){ac?So.push([g,S,P]):g in Ca&&Ca[g].forEach(I=>{I.call(null,i,S,P)})}(n.plugins||[]).forEach(g=>{for(let S in g.hooks)Ca[S]=(Ca[S]||[]).concat(g.hooks[S])});const wf=(g,S,P)=>P,sn=an({key:null,setSeries:!1,filters:{pub:id,sub:id},scales:[A,y[1]?y[1].scale:null],match:[sd,sd,wf],values:[null,null]},ge.sync);sn.match.length==2&&sn.match.push(wf),ge.sync=sn;const Tf=sn.key,mc=e_(Tf);function To(g,S,P,I,V,$,se){sn.filters.pub(g,S,P,I,V,$,se)&&mc.pub(g,S,P,I,V,$,se)}mc.sub(i);function dg(g,S,P,I,V,$,se){sn.filters.sub(g,S,P,I,V,$,se)&&Rr[g](null,S,P,I,V,$,se)}i.pub=dg;function pg(){mc.unsub(i),wh.delete(i),Pe.clear(),Mh(Ul,Kr,bf),c.remove(),ne?.remove(),Sn("destroy")}i.destroy=pg;function _c(){Sn("init",n,e),de(e||n.data,!1),W[A]?lc(A,W[A]):Se(),fe=Wt.show&&(Wt.width>0||Wt.height>0),H=pe=!0,De(n.width,n.height)}return y.forEach(Bs),w.forEach(rc),t?t instanceof HTMLElement?(t.appendChild(c),_c()):t(i,_c):_c(),i}Fn.assign=an;Fn.fmtNum=Uu;Fn.rangeNum=Nl;Fn.rangeLog=$l;Fn.rangeAsinh=Lu;Fn.orient=gr;Fn.pxRatio=Et;Fn.join=N0;Fn.fmtDate=Fu,Fn.tzDate=Y0;Fn.sync=e_;{Fn.addGap=Rv,Fn.clipGaps=Kl;let n=Fn.paths={points:o_};n.linear=l_,n.stepped=Dv,n.bars=Lv,n.spline=Uv}const Co=ct("rpy"),Po=ct("base");async function Do(n){const e=await lt({do:"tool",...n});e&&!e.reached&&Xn(e.sentence)}function _l({label:n,value:e,options:t,onChange:i}){return R("div",{class:"segments",role:"radiogroup","aria-label":n,children:t.map(([s,r])=>R("button",{type:"button",role:"radio","aria-checked":s===e,onClick:()=>i(s),children:r},s))})}function Xv(){const n=us.value;if(!n)return null;const{tool:e,methods:t}=n,i=Po.value==="tool",s=i?[0,0,0]:e.position,r=i?[0,0,0]:e.rpy,o=(l,c,h)=>l.map((f,d)=>d===c?h:f),a=n.method==="matrix"?t?.matrix:t?.quaternion;return R("section",{"aria-label":"Tool pose",children:[R("div",{class:"row spread",children:[R("span",{class:"quiet",children:"Frame"}),R(_l,{label:"Frame",value:Po.value,options:[["base","Base"],["tool","Tool"]],onChange:l=>{Po.value=l,ut.local.value=l==="tool"}})]}),R("div",{class:"triple",children:["X","Y","Z"].map((l,c)=>R("label",{children:[R("span",{children:[R("span",{class:`axis axis-${l.toLowerCase()}`,children:l})," ",R("span",{class:"quiet",children:Il("length",Ot.value)})]}),R(nr,{value:s[c],kind:"length",label:`Tool ${l}`,onCommit:h=>{Do({position:o(s,c,h),frame:Po.value})}})]},l))}),R("div",{class:"row spread",children:[R("span",{class:"quiet",children:"Orientation"}),R(_l,{label:"Orientation as",value:Co.value,options:[["rpy","RPY"],["quaternion","Quaternion"],["axis","Axis"]],onChange:l=>Co.value=l})]}),Co.value==="rpy"&&R("div",{class:"triple",children:["Roll","Pitch","Yaw"].map((l,c)=>R("label",{children:[R("span",{children:[R("span",{class:"axis",children:l})," ",R("span",{class:"quiet",children:Il("angle",Ot.value)})]}),R(nr,{value:r[c],kind:"angle",label:l,onCommit:h=>{Do({rpy:o(r,c,h),frame:Po.value})}})]},l))}),Co.value==="quaternion"&&R("div",{class:"triple four",children:["w","x","y","z"].map((l,c)=>R("label",{children:[R("span",{class:"axis",children:l}),R(nr,{value:e.quaternion[c],kind:"plain",label:`Quaternion ${l}`,onCommit:h=>{Do({quaternion:e.quaternion.map((f,d)=>d===c?Number(h):f)})}})]},l))}),Co.value==="axis"&&R("div",{class:"triple four",children:[["x","y","z"].map((l,c)=>R("label",{children:[R("span",{class:"axis",children:l}),R(nr,{value:e.axis[c],kind:"plain",label:`Axis ${l}`,onCommit:h=>{Do({axis_angle:[...o(e.axis,c,h),e.angle]})}})]},l)),R("label",{children:[R("span",{class:"axis",children:"angle"}),R(nr,{value:e.angle,kind:"angle",label:"Angle",onCommit:l=>{Do({axis_angle:[...e.axis,l]})}})]})]}),as.value?.missed&&R("p",{class:"banner",children:[R(vi,{name:"warn"})," Not reached: ",as.value.reason??"every solution lies outside the limits",". The arm stands at the nearest pose."]}),R("div",{class:"row spread",children:[R("span",{class:"quiet",children:"Computed by"}),R(_l,{label:"Computed by",value:n.method,options:[["matrix","Matrices"],["quaternion","Quaternions"]],onChange:l=>{lt({do:"method",to:l})}})]}),a&&R("table",{class:"matrix","aria-label":"Tool pose as a matrix",children:R("tbody",{children:a.map((l,c)=>R("tr",{children:l.map((h,f)=>R("td",{children:h.toFixed(5)},f))},c))})}),t&&R("p",{class:"quiet small",children:["The two ways differ by ",wm(t.difference)," at most."]}),n.measures&&R("dl",{class:"facts",children:[R("dt",{children:"Manipulability"}),R("dd",{children:n.measures.manipulability.toPrecision(3)}),R("dt",{children:"Smallest singular value"}),R("dd",{children:[n.measures.smallest_singular_value.toPrecision(3),n.measures.smallest_singular_value<.001&&" – singular"]}),R("dt",{children:"Condition"}),R("dd",{children:n.measures.condition===null?"∞":n.measures.condition.toPrecision(3)})]})]})}const Na=ct("q"),Yv={light:["#0072b2","#b35c00","#007a5a","#a8327d","#5b4bd6","#1f1f1f","#8a6d00"],dark:["#56b4e9","#f5a742","#3fd6a5","#f08cc8","#b3a5ff","#e8e8e8","#f0e442"]},f_=30;function qv(){const n=no(null);Gl(()=>{let t=null;const i=An(()=>{t?.destroy(),t=n.current?$v(n.current,Na.value):null}),s=An(()=>{Hi.value,t?.redraw(!1,!1)}),r=new ResizeObserver(()=>n.current&&t?.setSize({width:n.current.clientWidth,height:n.current.clientHeight-f_}));return n.current&&r.observe(n.current),()=>{i(),s(),r.disconnect(),t?.destroy()}},[]);const e=(_o.value?.t.length??0)===0;return R("div",{class:"plots",children:[R(_l,{label:"What is plotted",value:Na.value,onChange:t=>Na.value=t,options:[["q","Joints"],["qd","Rates"],["qdd","Accelerations"],["tool_speed","Tool speed"]]}),e&&R("p",{class:"quiet",children:"A motion shows its joints, rates and the tool's speed here."}),R("div",{class:"plot",ref:n,hidden:e,role:"img","aria-label":`Plot of ${Na.value} over time`})]})}function $v(n,e){const t=_o.value,i=pn.value?.joints??[];if(!t||t.t.length===0)return null;const s=ra.value?"#c9cfdb":"#3a4150",r=ra.value?"#2c313c":"#e4e7ed",o=Yv[ra.value?"dark":"light"],a=Ot.value.angle==="deg",l=u=>pa(i[u])==="angle"?a?180/Math.PI:1:Ot.value.length==="mm"?1e3:1,c={q:"",qd:"/s",qdd:"/s²",tool_speed:""}[e],h=[{label:"t",value:(u,_)=>_===null?"–":`${_.toFixed(2)} s`}],f=[t.t];if(e==="tool_speed"){const u=Ot.value.length==="mm"?1e3:1;f.push(t.tool_speed.map(_=>_*u)),h.push({label:`tool, ${Ot.value.length}/s`,stroke:o[4],width:1.75,pxAlign:0})}else t[e].forEach((u,_)=>{if(!i[_])return;const v=pa(i[_])==="angle"?a?"°":"rad":Ot.value.length;f.push(u.map(m=>m*l(_))),h.push({label:`${i[_].label}, ${v}${c}`,stroke:o[_%o.length],width:1.75,pxAlign:0,..._>3?{dash:[6,3]}:{}})});const d={stroke:s,grid:{stroke:r,width:1},ticks:{stroke:r},font:"12px system-ui, sans-serif"};return new Fn({width:n.clientWidth||600,height:(n.clientHeight||180)-f_,series:h,scales:{x:{time:!1}},legend:{live:!0},axes:[d,{...d,size:56}],cursor:{drag:{x:!1,y:!1}},hooks:{ready:[u=>u.over.addEventListener("click",()=>{const _=u.cursor.left;_!==void 0&&lt({do:"seek",t:u.posToVal(_,"x")})})],draw:[u=>{const _=Math.round(u.valToPos(Hi.peek(),"x",!0));u.ctx.save(),u.ctx.strokeStyle="#7c3aed",u.ctx.lineWidth=2,u.ctx.beginPath(),u.ctx.moveTo(_,u.bbox.top),u.ctx.lineTo(_,u.bbox.top+u.bbox.height),u.ctx.stroke(),u.ctx.restore()}]}},f,n)}const Gu="180",Jr={ROTATE:0,DOLLY:1,PAN:2},qr={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},jv=0,Td=1,Zv=2,d_=1,p_=2,ns=3,cs=0,Kn=1,Vi=2,Ds=0,Qr=1,Ad=2,Rd=3,Cd=4,Kv=5,sr=100,Jv=101,Qv=102,ex=103,tx=104,nx=200,ix=201,sx=202,rx=203,Ah=204,Rh=205,ox=206,ax=207,lx=208,cx=209,hx=210,ux=211,fx=212,dx=213,px=214,Ch=0,Ph=1,Dh=2,lo=3,Lh=4,Ih=5,Uh=6,Nh=7,Wu=0,mx=1,_x=2,Ls=0,gx=1,vx=2,xx=3,m_=4,Mx=5,yx=6,Sx=7,__=300,co=301,ho=302,Fh=303,Oh=304,tc=306,kh=1e3,lr=1001,Bh=1002,oi=1003,Ex=1004,Fa=1005,Gi=1006,Tc=1007,cr=1008,qi=1009,g_=1010,v_=1011,_a=1012,Xu=1013,pr=1014,Wi=1015,Sa=1016,Yu=1017,qu=1018,ga=1020,x_=35902,M_=35899,y_=1021,S_=1022,Di=1023,va=1026,xa=1027,$u=1028,ju=1029,E_=1030,Zu=1031,Ku=1033,gl=33776,vl=33777,xl=33778,Ml=33779,zh=35840,Hh=35841,Vh=35842,Gh=35843,Wh=36196,Xh=37492,Yh=37496,qh=37808,$h=37809,jh=37810,Zh=37811,Kh=37812,Jh=37813,Qh=37814,eu=37815,tu=37816,nu=37817,iu=37818,su=37819,ru=37820,ou=37821,au=36492,lu=36494,cu=36495,hu=36283,uu=36284,fu=36285,du=36286,bx=3200,wx=3201,Ju=0,Tx=1,Ps="",mi="srgb",uo="srgb-linear",Ol="linear",Dt="srgb",Dr=7680,Pd=519,Ax=512,Rx=513,Cx=514,b_=515,Px=516,Dx=517,Lx=518,Ix=519,Dd=35044,Ux=35048,Ld="300 es",Xi=2e3,kl=2001;class vr{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});const i=this._listeners;i[e]===void 0&&(i[e]=[]),i[e].indexOf(t)===-1&&i[e].push(t)}hasEventListener(e,t){const i=this._listeners;return i===void 0?!1:i[e]!==void 0&&i[e].indexOf(t)!==-1}removeEventListener(e,t){const i=this._listeners;if(i===void 0)return;const s=i[e];if(s!==void 0){const r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){const t=this._listeners;if(t===void 0)return;const i=t[e.type];if(i!==void 0){e.target=this;const s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}}const Ln=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],yl=Math.PI/180,pu=180/Math.PI;function Ea(){const n=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(Ln[n&255]+Ln[n>>8&255]+Ln[n>>16&255]+Ln[n>>24&255]+"-"+Ln[e&255]+Ln[e>>8&255]+"-"+Ln[e>>16&15|64]+Ln[e>>24&255]+"-"+Ln[t&63|128]+Ln[t>>8&255]+"-"+Ln[t>>16&255]+Ln[t>>24&255]+Ln[i&255]+Ln[i>>8&255]+Ln[i>>16&255]+Ln[i>>24&255]).toLowerCase()}function ft(n,e,t){return Math.max(e,Math.min(t,n))}function Nx(n,e){return(n%e+e)%e}function Ac(n,e,t){return(1-t)*n+t*e}function Lo(n,e){switch(e.constructor){case Float32Array:return n;case Uint32Array:return n/4294967295;case Uint16Array:return n/65535;case Uint8Array:return n/255;case Int32Array:return Math.max(n/2147483647,-1);case Int16Array:return Math.max(n/32767,-1);case Int8Array:return Math.max(n/127,-1);default:throw new Error("Invalid component type.")}}function jn(n,e){switch(e.constructor){case Float32Array:return n;case Uint32Array:return Math.round(n*4294967295);case Uint16Array:return Math.round(n*65535);case Uint8Array:return Math.round(n*255);case Int32Array:return Math.round(n*2147483647);case Int16Array:return Math.round(n*32767);case Int8Array:return Math.round(n*127);default:throw new Error("Invalid component type.")}}const Fx={DEG2RAD:yl};class Ke{constructor(e=0,t=0){Ke.prototype.isVector2=!0,this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){const t=this.x,i=this.y,s=e.elements;return this.x=s[0]*t+s[3]*i+s[6],this.y=s[1]*t+s[4]*i+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=ft(this.x,e.x,t.x),this.y=ft(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=ft(this.x,e,t),this.y=ft(this.y,e,t),this}clampLength(e,t){const i=this.length();return this.divideScalar(i||1).multiplyScalar(ft(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){const t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;const i=this.dot(e)/t;return Math.acos(ft(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){const t=this.x-e.x,i=this.y-e.y;return t*t+i*i}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){const i=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*i-o*s+e.x,this.y=r*s+o*i+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}}class Rn{constructor(e=0,t=0,i=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=i,this._w=s}static slerpFlat(e,t,i,s,r,o,a){let l=i[s+0],c=i[s+1],h=i[s+2],f=i[s+3];const d=r[o+0],u=r[o+1],_=r[o+2],v=r[o+3];if(a===0){e[t+0]=l,e[t+1]=c,e[t+2]=h,e[t+3]=f;return}if(a===1){e[t+0]=d,e[t+1]=u,e[t+2]=_,e[t+3]=v;return}if(f!==v||l!==d||c!==u||h!==_){let m=1-a;const p=l*d+c*u+h*_+f*v,y=p>=0?1:-1,w=1-p*p;if(w>Number.EPSILON){const L=Math.sqrt(w),A=Math.atan2(L,p*y);m=Math.sin(m*A)/L,a=Math.sin(a*A)/L}const x=a*y;if(l=l*m+d*x,c=c*m+u*x,h=h*m+_*x,f=f*m+v*x,m===1-a){const L=1/Math.sqrt(l*l+c*c+h*h+f*f);l*=L,c*=L,h*=L,f*=L}}e[t]=l,e[t+1]=c,e[t+2]=h,e[t+3]=f}static multiplyQuaternionsFlat(e,t,i,s,r,o){const a=i[s],l=i[s+1],c=i[s+2],h=i[s+3],f=r[o],d=r[o+1],u=r[o+2],_=r[o+3];return e[t]=a*_+h*f+l*u-c*d,e[t+1]=l*_+h*d+c*f-a*u,e[t+2]=c*_+h*u+a*d-l*f,e[t+3]=h*_-a*f-l*d-c*u,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,i,s){return this._x=e,this._y=t,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){const i=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(i/2),h=a(s/2),f=a(r/2),d=l(i/2),u=l(s/2),_=l(r/2);switch(o){case"XYZ":this._x=d*h*f+c*u*_,this._y=c*u*f-d*h*_,this._z=c*h*_+d*u*f,this._w=c*h*f-d*u*_;break;case"YXZ":this._x=d*h*f+c*u*_,this._y=c*u*f-d*h*_,this._z=c*h*_-d*u*f,this._w=c*h*f+d*u*_;break;case"ZXY":this._x=d*h*f-c*u*_,this._y=c*u*f+d*h*_,this._z=c*h*_+d*u*f,this._w=c*h*f-d*u*_;break;case"ZYX":this._x=d*h*f-c*u*_,this._y=c*u*f+d*h*_,this._z=c*h*_-d*u*f,this._w=c*h*f+d*u*_;break;case"YZX":this._x=d*h*f+c*u*_,this._y=c*u*f+d*h*_,this._z=c*h*_-d*u*f,this._w=c*h*f-d*u*_;break;case"XZY":this._x=d*h*f-c*u*_,this._y=c*u*f-d*h*_,this._z=c*h*_+d*u*f,this._w=c*h*f+d*u*_;break;default:console.warn("THREE.Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){const i=t/2,s=Math.sin(i);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(e){const t=e.elements,i=t[0],s=t[4],r=t[8],o=t[1],a=t[5],l=t[9],c=t[2],h=t[6],f=t[10],d=i+a+f;if(d>0){const u=.5/Math.sqrt(d+1);this._w=.25/u,this._x=(h-l)*u,this._y=(r-c)*u,this._z=(o-s)*u}else if(i>a&&i>f){const u=2*Math.sqrt(1+i-a-f);this._w=(h-l)/u,this._x=.25*u,this._y=(s+o)/u,this._z=(r+c)/u}else if(a>f){const u=2*Math.sqrt(1+a-i-f);this._w=(r-c)/u,this._x=(s+o)/u,this._y=.25*u,this._z=(l+h)/u}else{const u=2*Math.sqrt(1+f-i-a);this._w=(o-s)/u,this._x=(r+c)/u,this._y=(l+h)/u,this._z=.25*u}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let i=e.dot(t)+1;return i<1e-8?(i=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=i):(this._x=0,this._y=-e.z,this._z=e.y,this._w=i)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=i),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(ft(this.dot(e),-1,1)))}rotateTowards(e,t){const i=this.angleTo(e);if(i===0)return this;const s=Math.min(1,t/i);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){const i=e._x,s=e._y,r=e._z,o=e._w,a=t._x,l=t._y,c=t._z,h=t._w;return this._x=i*h+o*a+s*c-r*l,this._y=s*h+o*l+r*a-i*c,this._z=r*h+o*c+i*l-s*a,this._w=o*h-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){if(t===0)return this;if(t===1)return this.copy(e);const i=this._x,s=this._y,r=this._z,o=this._w;let a=o*e._w+i*e._x+s*e._y+r*e._z;if(a<0?(this._w=-e._w,this._x=-e._x,this._y=-e._y,this._z=-e._z,a=-a):this.copy(e),a>=1)return this._w=o,this._x=i,this._y=s,this._z=r,this;const l=1-a*a;if(l<=Number.EPSILON){const u=1-t;return this._w=u*o+t*this._w,this._x=u*i+t*this._x,this._y=u*s+t*this._y,this._z=u*r+t*this._z,this.normalize(),this}const c=Math.sqrt(l),h=Math.atan2(c,a),f=Math.sin((1-t)*h)/c,d=Math.sin(t*h)/c;return this._w=o*f+this._w*d,this._x=i*f+this._x*d,this._y=s*f+this._y*d,this._z=r*f+this._z*d,this._onChangeCallback(),this}slerpQuaternions(e,t,i){return this.copy(e).slerp(t,i)}random(){const e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}}class k{constructor(e=0,t=0,i=0){k.prototype.isVector3=!0,this.x=e,this.y=t,this.z=i}set(e,t,i){return i===void 0&&(i=this.z),this.x=e,this.y=t,this.z=i,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(Id.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(Id.setFromAxisAngle(e,t))}applyMatrix3(e){const t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*i+r[6]*s,this.y=r[1]*t+r[4]*i+r[7]*s,this.z=r[2]*t+r[5]*i+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){const t=this.x,i=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(e){const t=this.x,i=this.y,s=this.z,r=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*s-a*i),h=2*(a*t-r*s),f=2*(r*i-o*t);return this.x=t+l*c+o*f-a*h,this.y=i+l*h+a*c-r*f,this.z=s+l*f+r*h-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){const t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*i+r[8]*s,this.y=r[1]*t+r[5]*i+r[9]*s,this.z=r[2]*t+r[6]*i+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=ft(this.x,e.x,t.x),this.y=ft(this.y,e.y,t.y),this.z=ft(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=ft(this.x,e,t),this.y=ft(this.y,e,t),this.z=ft(this.z,e,t),this}clampLength(e,t){const i=this.length();return this.divideScalar(i||1).multiplyScalar(ft(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){const i=e.x,s=e.y,r=e.z,o=t.x,a=t.y,l=t.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(e){const t=e.lengthSq();if(t===0)return this.set(0,0,0);const i=e.dot(this)/t;return this.copy(e).multiplyScalar(i)}projectOnPlane(e){return Rc.copy(this).projectOnVector(e),this.sub(Rc)}reflect(e){return this.sub(Rc.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){const t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;const i=this.dot(e)/t;return Math.acos(ft(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){const t=this.x-e.x,i=this.y-e.y,s=this.z-e.z;return t*t+i*i+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,i){const s=Math.sin(t)*e;return this.x=s*Math.sin(i),this.y=Math.cos(t)*e,this.z=s*Math.cos(i),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,i){return this.x=e*Math.sin(t),this.y=i,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){const t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){const t=this.setFromMatrixColumn(e,0).length(),i=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=i,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){const e=Math.random()*Math.PI*2,t=Math.random()*2-1,i=Math.sqrt(1-t*t);return this.x=i*Math.cos(e),this.y=t,this.z=i*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}}const Rc=new k,Id=new Rn;class rt{constructor(e,t,i,s,r,o,a,l,c){rt.prototype.isMatrix3=!0,this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c)}set(e,t,i,s,r,o,a,l,c){const h=this.elements;return h[0]=e,h[1]=s,h[2]=a,h[3]=t,h[4]=r,h[5]=l,h[6]=i,h[7]=o,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){const t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],this}extractBasis(e,t,i){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(e){const t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){const i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],h=i[4],f=i[7],d=i[2],u=i[5],_=i[8],v=s[0],m=s[3],p=s[6],y=s[1],w=s[4],x=s[7],L=s[2],A=s[5],U=s[8];return r[0]=o*v+a*y+l*L,r[3]=o*m+a*w+l*A,r[6]=o*p+a*x+l*U,r[1]=c*v+h*y+f*L,r[4]=c*m+h*w+f*A,r[7]=c*p+h*x+f*U,r[2]=d*v+u*y+_*L,r[5]=d*m+u*w+_*A,r[8]=d*p+u*x+_*U,this}multiplyScalar(e){const t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){const e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8];return t*o*h-t*a*c-i*r*h+i*a*l+s*r*c-s*o*l}invert(){const e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8],f=h*o-a*c,d=a*l-h*r,u=c*r-o*l,_=t*f+i*d+s*u;if(_===0)return this.set(0,0,0,0,0,0,0,0,0);const v=1/_;return e[0]=f*v,e[1]=(s*c-h*i)*v,e[2]=(a*i-s*o)*v,e[3]=d*v,e[4]=(h*t-s*l)*v,e[5]=(s*r-a*t)*v,e[6]=u*v,e[7]=(i*l-c*t)*v,e[8]=(o*t-i*r)*v,this}transpose(){let e;const t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){const t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,i,s,r,o,a){const l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+e,-s*c,s*l,-s*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return this.premultiply(Cc.makeScale(e,t)),this}rotate(e){return this.premultiply(Cc.makeRotation(-e)),this}translate(e,t){return this.premultiply(Cc.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){const t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,i,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){const t=this.elements,i=e.elements;for(let s=0;s<9;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<9;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){const i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e}clone(){return new this.constructor().fromArray(this.elements)}}const Cc=new rt;function w_(n){for(let e=n.length-1;e>=0;--e)if(n[e]>=65535)return!0;return!1}function Bl(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function Ox(){const n=Bl("canvas");return n.style.display="block",n}const Ud={};function Ma(n){n in Ud||(Ud[n]=!0,console.warn(n))}function kx(n,e,t){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(e,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:i()}}setTimeout(r,t)})}const Nd=new rt().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Fd=new rt().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function Bx(){const n={enabled:!0,workingColorSpace:uo,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Dt&&(s.r=os(s.r),s.g=os(s.g),s.b=os(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Dt&&(s.r=eo(s.r),s.g=eo(s.g),s.b=eo(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Ps?Ol:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[r].toXYZ).multiply(this.spaces[o].fromXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace},fromWorkingColorSpace:function(s,r){return Ma("THREE.ColorManagement: .fromWorkingColorSpace() has been renamed to .workingToColorSpace()."),n.workingToColorSpace(s,r)},toWorkingColorSpace:function(s,r){return Ma("THREE.ColorManagement: .toWorkingColorSpace() has been renamed to .colorSpaceToWorking()."),n.colorSpaceToWorking(s,r)}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[uo]:{primaries:e,whitePoint:i,transfer:Ol,toXYZ:Nd,fromXYZ:Fd,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:mi},outputColorSpaceConfig:{drawingBufferColorSpace:mi}},[mi]:{primaries:e,whitePoint:i,transfer:Dt,toXYZ:Nd,fromXYZ:Fd,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:mi}}}),n}const xt=Bx();function os(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function eo(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}let Lr;class zx{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let i;if(e instanceof HTMLCanvasElement)i=e;else{Lr===void 0&&(Lr=Bl("canvas")),Lr.width=e.width,Lr.height=e.height;const s=Lr.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),i=Lr}return i.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){const t=Bl("canvas");t.width=e.width,t.height=e.height;const i=t.getContext("2d");i.drawImage(e,0,0,e.width,e.height);const s=i.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=os(r[o]/255)*255;return i.putImageData(s,0,0),t}else if(e.data){const t=e.data.slice(0);for(let i=0;i<t.length;i++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[i]=Math.floor(os(t[i]/255)*255):t[i]=os(t[i]);return{data:t,width:e.width,height:e.height}}else return console.warn("THREE.ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}}let Hx=0;class Qu{constructor(e=null){this.isSource=!0,Object.defineProperty(this,"id",{value:Hx++}),this.uuid=Ea(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){const t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):t instanceof VideoFrame?e.set(t.displayHeight,t.displayWidth,0):t!==null?e.set(t.width,t.height,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){const t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];const i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Pc(s[o].image)):r.push(Pc(s[o]))}else r=Pc(s);i.url=r}return t||(e.images[this.uuid]=i),i}}function Pc(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?zx.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(console.warn("THREE.Texture: Unable to serialize Texture."),{})}let Vx=0;const Dc=new k;class Yn extends vr{constructor(e=Yn.DEFAULT_IMAGE,t=Yn.DEFAULT_MAPPING,i=lr,s=lr,r=Gi,o=cr,a=Di,l=qi,c=Yn.DEFAULT_ANISOTROPY,h=Ps){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:Vx++}),this.uuid=Ea(),this.name="",this.source=new Qu(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new Ke(0,0),this.repeat=new Ke(1,1),this.center=new Ke(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new rt,this.generateMipmaps=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0}get width(){return this.source.getSize(Dc).x}get height(){return this.source.getSize(Dc).y}get depth(){return this.source.getSize(Dc).z}get image(){return this.source.data}set image(e=null){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(const t in e){const i=e[t];if(i===void 0){console.warn(`THREE.Texture.setValues(): parameter '${t}' has value of undefined.`);continue}const s=this[t];if(s===void 0){console.warn(`THREE.Texture.setValues(): property '${t}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[t]=i}}toJSON(e){const t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];const i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),t||(e.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==__)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case kh:e.x=e.x-Math.floor(e.x);break;case lr:e.x=e.x<0?0:1;break;case Bh:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case kh:e.y=e.y-Math.floor(e.y);break;case lr:e.y=e.y<0?0:1;break;case Bh:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}}Yn.DEFAULT_IMAGE=null;Yn.DEFAULT_MAPPING=__;Yn.DEFAULT_ANISOTROPY=1;class en{constructor(e=0,t=0,i=0,s=1){en.prototype.isVector4=!0,this.x=e,this.y=t,this.z=i,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,i,s){return this.x=e,this.y=t,this.z=i,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){const t=this.x,i=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*i+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);const t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,i,s,r;const l=e.elements,c=l[0],h=l[4],f=l[8],d=l[1],u=l[5],_=l[9],v=l[2],m=l[6],p=l[10];if(Math.abs(h-d)<.01&&Math.abs(f-v)<.01&&Math.abs(_-m)<.01){if(Math.abs(h+d)<.1&&Math.abs(f+v)<.1&&Math.abs(_+m)<.1&&Math.abs(c+u+p-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;const w=(c+1)/2,x=(u+1)/2,L=(p+1)/2,A=(h+d)/4,U=(f+v)/4,N=(_+m)/4;return w>x&&w>L?w<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(w),s=A/i,r=U/i):x>L?x<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(x),i=A/s,r=N/s):L<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(L),i=U/r,s=N/r),this.set(i,s,r,t),this}let y=Math.sqrt((m-_)*(m-_)+(f-v)*(f-v)+(d-h)*(d-h));return Math.abs(y)<.001&&(y=1),this.x=(m-_)/y,this.y=(f-v)/y,this.z=(d-h)/y,this.w=Math.acos((c+u+p-1)/2),this}setFromMatrixPosition(e){const t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=ft(this.x,e.x,t.x),this.y=ft(this.y,e.y,t.y),this.z=ft(this.z,e.z,t.z),this.w=ft(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=ft(this.x,e,t),this.y=ft(this.y,e,t),this.z=ft(this.z,e,t),this.w=ft(this.w,e,t),this}clampLength(e,t){const i=this.length();return this.divideScalar(i||1).multiplyScalar(ft(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this.w=e.w+(t.w-e.w)*i,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}}class Gx extends vr{constructor(e=1,t=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Gi,depthBuffer:!0,stencilBuffer:!1,resolveDepthBuffer:!0,resolveStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1},i),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=i.depth,this.scissor=new en(0,0,e,t),this.scissorTest=!1,this.viewport=new en(0,0,e,t);const s={width:e,height:t,depth:i.depth},r=new Yn(s);this.textures=[];const o=i.count;for(let a=0;a<o;a++)this.textures[a]=r.clone(),this.textures[a].isRenderTargetTexture=!0,this.textures[a].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview}_setTextureOptions(e={}){const t={minFilter:Gi,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&(this._depthTexture.renderTarget=null),e!==null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,i=1){if(this.width!==e||this.height!==t||this.depth!==i){this.width=e,this.height=t,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=i,this.textures[s].isArrayTexture=this.textures[s].image.depth>1;this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,i=e.textures.length;t<i;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;const s=Object.assign({},e.textures[t].image);this.textures[t].source=new Qu(s)}return this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,e.depthTexture!==null&&(this.depthTexture=e.depthTexture.clone()),this.samples=e.samples,this}dispose(){this.dispatchEvent({type:"dispose"})}}class mr extends Gx{constructor(e=1,t=1,i={}){super(e,t,i),this.isWebGLRenderTarget=!0}}class T_ extends Yn{constructor(e=null,t=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=oi,this.minFilter=oi,this.wrapR=lr,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}}class Wx extends Yn{constructor(e=null,t=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=oi,this.minFilter=oi,this.wrapR=lr,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}}class Os{constructor(e=new k(1/0,1/0,1/0),t=new k(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t+=3)this.expandByPoint(bi.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,i=e.count;t<i;t++)this.expandByPoint(bi.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){const i=bi.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(i),this.max.copy(e).add(i),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);const i=e.geometry;if(i!==void 0){const r=i.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,bi):bi.fromBufferAttribute(r,o),bi.applyMatrix4(e.matrixWorld),this.expandByPoint(bi);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),Oa.copy(e.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),Oa.copy(i.boundingBox)),Oa.applyMatrix4(e.matrixWorld),this.union(Oa)}const s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,bi),bi.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,i;return e.normal.x>0?(t=e.normal.x*this.min.x,i=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,i=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,i+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,i+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,i+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,i+=e.normal.z*this.min.z),t<=-e.constant&&i>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(Io),ka.subVectors(this.max,Io),Ir.subVectors(e.a,Io),Ur.subVectors(e.b,Io),Nr.subVectors(e.c,Io),xs.subVectors(Ur,Ir),Ms.subVectors(Nr,Ur),Xs.subVectors(Ir,Nr);let t=[0,-xs.z,xs.y,0,-Ms.z,Ms.y,0,-Xs.z,Xs.y,xs.z,0,-xs.x,Ms.z,0,-Ms.x,Xs.z,0,-Xs.x,-xs.y,xs.x,0,-Ms.y,Ms.x,0,-Xs.y,Xs.x,0];return!Lc(t,Ir,Ur,Nr,ka)||(t=[1,0,0,0,1,0,0,0,1],!Lc(t,Ir,Ur,Nr,ka))?!1:(Ba.crossVectors(xs,Ms),t=[Ba.x,Ba.y,Ba.z],Lc(t,Ir,Ur,Nr,ka))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,bi).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(bi).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(Ki[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),Ki[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),Ki[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),Ki[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),Ki[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),Ki[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),Ki[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),Ki[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(Ki),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}}const Ki=[new k,new k,new k,new k,new k,new k,new k,new k],bi=new k,Oa=new Os,Ir=new k,Ur=new k,Nr=new k,xs=new k,Ms=new k,Xs=new k,Io=new k,ka=new k,Ba=new k,Ys=new k;function Lc(n,e,t,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){Ys.fromArray(n,r);const a=s.x*Math.abs(Ys.x)+s.y*Math.abs(Ys.y)+s.z*Math.abs(Ys.z),l=e.dot(Ys),c=t.dot(Ys),h=i.dot(Ys);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>a)return!1}return!0}const Xx=new Os,Uo=new k,Ic=new k;class xr{constructor(e=new k,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){const i=this.center;t!==void 0?i.copy(t):Xx.setFromPoints(e).getCenter(i);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,i.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){const t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){const i=this.center.distanceToSquared(e);return t.copy(e),i>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;Uo.subVectors(e,this.center);const t=Uo.lengthSq();if(t>this.radius*this.radius){const i=Math.sqrt(t),s=(i-this.radius)*.5;this.center.addScaledVector(Uo,s/i),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(Ic.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(Uo.copy(e.center).add(Ic)),this.expandByPoint(Uo.copy(e.center).sub(Ic))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}}const Ji=new k,Uc=new k,za=new k,ys=new k,Nc=new k,Ha=new k,Fc=new k;class nc{constructor(e=new k,t=new k(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,Ji)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);const i=t.dot(this.direction);return i<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){const t=Ji.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(Ji.copy(this.origin).addScaledVector(this.direction,t),Ji.distanceToSquared(e))}distanceSqToSegment(e,t,i,s){Uc.copy(e).add(t).multiplyScalar(.5),za.copy(t).sub(e).normalize(),ys.copy(this.origin).sub(Uc);const r=e.distanceTo(t)*.5,o=-this.direction.dot(za),a=ys.dot(this.direction),l=-ys.dot(za),c=ys.lengthSq(),h=Math.abs(1-o*o);let f,d,u,_;if(h>0)if(f=o*l-a,d=o*a-l,_=r*h,f>=0)if(d>=-_)if(d<=_){const v=1/h;f*=v,d*=v,u=f*(f+o*d+2*a)+d*(o*f+d+2*l)+c}else d=r,f=Math.max(0,-(o*d+a)),u=-f*f+d*(d+2*l)+c;else d=-r,f=Math.max(0,-(o*d+a)),u=-f*f+d*(d+2*l)+c;else d<=-_?(f=Math.max(0,-(-o*r+a)),d=f>0?-r:Math.min(Math.max(-r,-l),r),u=-f*f+d*(d+2*l)+c):d<=_?(f=0,d=Math.min(Math.max(-r,-l),r),u=d*(d+2*l)+c):(f=Math.max(0,-(o*r+a)),d=f>0?r:Math.min(Math.max(-r,-l),r),u=-f*f+d*(d+2*l)+c);else d=o>0?-r:r,f=Math.max(0,-(o*d+a)),u=-f*f+d*(d+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,f),s&&s.copy(Uc).addScaledVector(za,d),u}intersectSphere(e,t){Ji.subVectors(e.center,this.origin);const i=Ji.dot(this.direction),s=Ji.dot(Ji)-i*i,r=e.radius*e.radius;if(s>r)return null;const o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){const t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;const i=-(this.origin.dot(e.normal)+e.constant)/t;return i>=0?i:null}intersectPlane(e,t){const i=this.distanceToPlane(e);return i===null?null:this.at(i,t)}intersectsPlane(e){const t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let i,s,r,o,a,l;const c=1/this.direction.x,h=1/this.direction.y,f=1/this.direction.z,d=this.origin;return c>=0?(i=(e.min.x-d.x)*c,s=(e.max.x-d.x)*c):(i=(e.max.x-d.x)*c,s=(e.min.x-d.x)*c),h>=0?(r=(e.min.y-d.y)*h,o=(e.max.y-d.y)*h):(r=(e.max.y-d.y)*h,o=(e.min.y-d.y)*h),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),f>=0?(a=(e.min.z-d.z)*f,l=(e.max.z-d.z)*f):(a=(e.max.z-d.z)*f,l=(e.min.z-d.z)*f),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,t)}intersectsBox(e){return this.intersectBox(e,Ji)!==null}intersectTriangle(e,t,i,s,r){Nc.subVectors(t,e),Ha.subVectors(i,e),Fc.crossVectors(Nc,Ha);let o=this.direction.dot(Fc),a;if(o>0){if(s)return null;a=1}else if(o<0)a=-1,o=-o;else return null;ys.subVectors(this.origin,e);const l=a*this.direction.dot(Ha.crossVectors(ys,Ha));if(l<0)return null;const c=a*this.direction.dot(Nc.cross(ys));if(c<0||l+c>o)return null;const h=-a*ys.dot(Fc);return h<0?null:this.at(h/o,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}}class Rt{constructor(e,t,i,s,r,o,a,l,c,h,f,d,u,_,v,m){Rt.prototype.isMatrix4=!0,this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c,h,f,d,u,_,v,m)}set(e,t,i,s,r,o,a,l,c,h,f,d,u,_,v,m){const p=this.elements;return p[0]=e,p[4]=t,p[8]=i,p[12]=s,p[1]=r,p[5]=o,p[9]=a,p[13]=l,p[2]=c,p[6]=h,p[10]=f,p[14]=d,p[3]=u,p[7]=_,p[11]=v,p[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new Rt().fromArray(this.elements)}copy(e){const t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],t[9]=i[9],t[10]=i[10],t[11]=i[11],t[12]=i[12],t[13]=i[13],t[14]=i[14],t[15]=i[15],this}copyPosition(e){const t=this.elements,i=e.elements;return t[12]=i[12],t[13]=i[13],t[14]=i[14],this}setFromMatrix3(e){const t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,i){return e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this}makeBasis(e,t,i){return this.set(e.x,t.x,i.x,0,e.y,t.y,i.y,0,e.z,t.z,i.z,0,0,0,0,1),this}extractRotation(e){const t=this.elements,i=e.elements,s=1/Fr.setFromMatrixColumn(e,0).length(),r=1/Fr.setFromMatrixColumn(e,1).length(),o=1/Fr.setFromMatrixColumn(e,2).length();return t[0]=i[0]*s,t[1]=i[1]*s,t[2]=i[2]*s,t[3]=0,t[4]=i[4]*r,t[5]=i[5]*r,t[6]=i[6]*r,t[7]=0,t[8]=i[8]*o,t[9]=i[9]*o,t[10]=i[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){const t=this.elements,i=e.x,s=e.y,r=e.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),h=Math.cos(r),f=Math.sin(r);if(e.order==="XYZ"){const d=o*h,u=o*f,_=a*h,v=a*f;t[0]=l*h,t[4]=-l*f,t[8]=c,t[1]=u+_*c,t[5]=d-v*c,t[9]=-a*l,t[2]=v-d*c,t[6]=_+u*c,t[10]=o*l}else if(e.order==="YXZ"){const d=l*h,u=l*f,_=c*h,v=c*f;t[0]=d+v*a,t[4]=_*a-u,t[8]=o*c,t[1]=o*f,t[5]=o*h,t[9]=-a,t[2]=u*a-_,t[6]=v+d*a,t[10]=o*l}else if(e.order==="ZXY"){const d=l*h,u=l*f,_=c*h,v=c*f;t[0]=d-v*a,t[4]=-o*f,t[8]=_+u*a,t[1]=u+_*a,t[5]=o*h,t[9]=v-d*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){const d=o*h,u=o*f,_=a*h,v=a*f;t[0]=l*h,t[4]=_*c-u,t[8]=d*c+v,t[1]=l*f,t[5]=v*c+d,t[9]=u*c-_,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){const d=o*l,u=o*c,_=a*l,v=a*c;t[0]=l*h,t[4]=v-d*f,t[8]=_*f+u,t[1]=f,t[5]=o*h,t[9]=-a*h,t[2]=-c*h,t[6]=u*f+_,t[10]=d-v*f}else if(e.order==="XZY"){const d=o*l,u=o*c,_=a*l,v=a*c;t[0]=l*h,t[4]=-f,t[8]=c*h,t[1]=d*f+v,t[5]=o*h,t[9]=u*f-_,t[2]=_*f-u,t[6]=a*h,t[10]=v*f+d}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(Yx,e,qx)}lookAt(e,t,i){const s=this.elements;return ni.subVectors(e,t),ni.lengthSq()===0&&(ni.z=1),ni.normalize(),Ss.crossVectors(i,ni),Ss.lengthSq()===0&&(Math.abs(i.z)===1?ni.x+=1e-4:ni.z+=1e-4,ni.normalize(),Ss.crossVectors(i,ni)),Ss.normalize(),Va.crossVectors(ni,Ss),s[0]=Ss.x,s[4]=Va.x,s[8]=ni.x,s[1]=Ss.y,s[5]=Va.y,s[9]=ni.y,s[2]=Ss.z,s[6]=Va.z,s[10]=ni.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){const i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],h=i[1],f=i[5],d=i[9],u=i[13],_=i[2],v=i[6],m=i[10],p=i[14],y=i[3],w=i[7],x=i[11],L=i[15],A=s[0],U=s[4],N=s[8],b=s[12],E=s[1],C=s[5],B=s[9],z=s[13],Y=s[2],W=s[6],j=s[10],q=s[14],K=s[3],re=s[7],ae=s[11],me=s[15];return r[0]=o*A+a*E+l*Y+c*K,r[4]=o*U+a*C+l*W+c*re,r[8]=o*N+a*B+l*j+c*ae,r[12]=o*b+a*z+l*q+c*me,r[1]=h*A+f*E+d*Y+u*K,r[5]=h*U+f*C+d*W+u*re,r[9]=h*N+f*B+d*j+u*ae,r[13]=h*b+f*z+d*q+u*me,r[2]=_*A+v*E+m*Y+p*K,r[6]=_*U+v*C+m*W+p*re,r[10]=_*N+v*B+m*j+p*ae,r[14]=_*b+v*z+m*q+p*me,r[3]=y*A+w*E+x*Y+L*K,r[7]=y*U+w*C+x*W+L*re,r[11]=y*N+w*B+x*j+L*ae,r[15]=y*b+w*z+x*q+L*me,this}multiplyScalar(e){const t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){const e=this.elements,t=e[0],i=e[4],s=e[8],r=e[12],o=e[1],a=e[5],l=e[9],c=e[13],h=e[2],f=e[6],d=e[10],u=e[14],_=e[3],v=e[7],m=e[11],p=e[15];return _*(+r*l*f-s*c*f-r*a*d+i*c*d+s*a*u-i*l*u)+v*(+t*l*u-t*c*d+r*o*d-s*o*u+s*c*h-r*l*h)+m*(+t*c*f-t*a*u-r*o*f+i*o*u+r*a*h-i*c*h)+p*(-s*a*h-t*l*f+t*a*d+s*o*f-i*o*d+i*l*h)}transpose(){const e=this.elements;let t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,i){const s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=i),this}invert(){const e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8],f=e[9],d=e[10],u=e[11],_=e[12],v=e[13],m=e[14],p=e[15],y=f*m*c-v*d*c+v*l*u-a*m*u-f*l*p+a*d*p,w=_*d*c-h*m*c-_*l*u+o*m*u+h*l*p-o*d*p,x=h*v*c-_*f*c+_*a*u-o*v*u-h*a*p+o*f*p,L=_*f*l-h*v*l-_*a*d+o*v*d+h*a*m-o*f*m,A=t*y+i*w+s*x+r*L;if(A===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);const U=1/A;return e[0]=y*U,e[1]=(v*d*r-f*m*r-v*s*u+i*m*u+f*s*p-i*d*p)*U,e[2]=(a*m*r-v*l*r+v*s*c-i*m*c-a*s*p+i*l*p)*U,e[3]=(f*l*r-a*d*r-f*s*c+i*d*c+a*s*u-i*l*u)*U,e[4]=w*U,e[5]=(h*m*r-_*d*r+_*s*u-t*m*u-h*s*p+t*d*p)*U,e[6]=(_*l*r-o*m*r-_*s*c+t*m*c+o*s*p-t*l*p)*U,e[7]=(o*d*r-h*l*r+h*s*c-t*d*c-o*s*u+t*l*u)*U,e[8]=x*U,e[9]=(_*f*r-h*v*r-_*i*u+t*v*u+h*i*p-t*f*p)*U,e[10]=(o*v*r-_*a*r+_*i*c-t*v*c-o*i*p+t*a*p)*U,e[11]=(h*a*r-o*f*r-h*i*c+t*f*c+o*i*u-t*a*u)*U,e[12]=L*U,e[13]=(h*v*s-_*f*s+_*i*d-t*v*d-h*i*m+t*f*m)*U,e[14]=(_*a*s-o*v*s-_*i*l+t*v*l+o*i*m-t*a*m)*U,e[15]=(o*f*s-h*a*s+h*i*l-t*f*l-o*i*d+t*a*d)*U,this}scale(e){const t=this.elements,i=e.x,s=e.y,r=e.z;return t[0]*=i,t[4]*=s,t[8]*=r,t[1]*=i,t[5]*=s,t[9]*=r,t[2]*=i,t[6]*=s,t[10]*=r,t[3]*=i,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){const e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],i=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,i,s))}makeTranslation(e,t,i){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,i,0,0,0,1),this}makeRotationX(e){const t=Math.cos(e),i=Math.sin(e);return this.set(1,0,0,0,0,t,-i,0,0,i,t,0,0,0,0,1),this}makeRotationY(e){const t=Math.cos(e),i=Math.sin(e);return this.set(t,0,i,0,0,1,0,0,-i,0,t,0,0,0,0,1),this}makeRotationZ(e){const t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,0,i,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){const i=Math.cos(t),s=Math.sin(t),r=1-i,o=e.x,a=e.y,l=e.z,c=r*o,h=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,h*a+i,h*l-s*o,0,c*l-s*a,h*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(e,t,i){return this.set(e,0,0,0,0,t,0,0,0,0,i,0,0,0,0,1),this}makeShear(e,t,i,s,r,o){return this.set(1,i,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,i){const s=this.elements,r=t._x,o=t._y,a=t._z,l=t._w,c=r+r,h=o+o,f=a+a,d=r*c,u=r*h,_=r*f,v=o*h,m=o*f,p=a*f,y=l*c,w=l*h,x=l*f,L=i.x,A=i.y,U=i.z;return s[0]=(1-(v+p))*L,s[1]=(u+x)*L,s[2]=(_-w)*L,s[3]=0,s[4]=(u-x)*A,s[5]=(1-(d+p))*A,s[6]=(m+y)*A,s[7]=0,s[8]=(_+w)*U,s[9]=(m-y)*U,s[10]=(1-(d+v))*U,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,i){const s=this.elements;let r=Fr.set(s[0],s[1],s[2]).length();const o=Fr.set(s[4],s[5],s[6]).length(),a=Fr.set(s[8],s[9],s[10]).length();this.determinant()<0&&(r=-r),e.x=s[12],e.y=s[13],e.z=s[14],wi.copy(this);const c=1/r,h=1/o,f=1/a;return wi.elements[0]*=c,wi.elements[1]*=c,wi.elements[2]*=c,wi.elements[4]*=h,wi.elements[5]*=h,wi.elements[6]*=h,wi.elements[8]*=f,wi.elements[9]*=f,wi.elements[10]*=f,t.setFromRotationMatrix(wi),i.x=r,i.y=o,i.z=a,this}makePerspective(e,t,i,s,r,o,a=Xi,l=!1){const c=this.elements,h=2*r/(t-e),f=2*r/(i-s),d=(t+e)/(t-e),u=(i+s)/(i-s);let _,v;if(l)_=r/(o-r),v=o*r/(o-r);else if(a===Xi)_=-(o+r)/(o-r),v=-2*o*r/(o-r);else if(a===kl)_=-o/(o-r),v=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=d,c[12]=0,c[1]=0,c[5]=f,c[9]=u,c[13]=0,c[2]=0,c[6]=0,c[10]=_,c[14]=v,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,i,s,r,o,a=Xi,l=!1){const c=this.elements,h=2/(t-e),f=2/(i-s),d=-(t+e)/(t-e),u=-(i+s)/(i-s);let _,v;if(l)_=1/(o-r),v=o/(o-r);else if(a===Xi)_=-2/(o-r),v=-(o+r)/(o-r);else if(a===kl)_=-1/(o-r),v=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=0,c[12]=d,c[1]=0,c[5]=f,c[9]=0,c[13]=u,c[2]=0,c[6]=0,c[10]=_,c[14]=v,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){const t=this.elements,i=e.elements;for(let s=0;s<16;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<16;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){const i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e[t+9]=i[9],e[t+10]=i[10],e[t+11]=i[11],e[t+12]=i[12],e[t+13]=i[13],e[t+14]=i[14],e[t+15]=i[15],e}}const Fr=new k,wi=new Rt,Yx=new k(0,0,0),qx=new k(1,1,1),Ss=new k,Va=new k,ni=new k,Od=new Rt,kd=new Rn;class Mi{constructor(e=0,t=0,i=0,s=Mi.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=i,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,i,s=this._order){return this._x=e,this._y=t,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,i=!0){const s=e.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],h=s[9],f=s[2],d=s[6],u=s[10];switch(t){case"XYZ":this._y=Math.asin(ft(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,u),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(d,c),this._z=0);break;case"YXZ":this._x=Math.asin(-ft(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,u),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-f,r),this._z=0);break;case"ZXY":this._x=Math.asin(ft(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-f,u),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-ft(f,-1,1)),Math.abs(f)<.9999999?(this._x=Math.atan2(d,u),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(ft(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-f,r)):(this._x=0,this._y=Math.atan2(a,u));break;case"XZY":this._z=Math.asin(-ft(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(d,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-h,u),this._y=0);break;default:console.warn("THREE.Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,i===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,i){return Od.makeRotationFromQuaternion(e),this.setFromRotationMatrix(Od,t,i)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return kd.setFromEuler(this),this.setFromQuaternion(kd,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}}Mi.DEFAULT_ORDER="XYZ";class ef{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}}let $x=0;const Bd=new k,Or=new Rn,Qi=new Rt,Ga=new k,No=new k,jx=new k,Zx=new Rn,zd=new k(1,0,0),Hd=new k(0,1,0),Vd=new k(0,0,1),Gd={type:"added"},Kx={type:"removed"},kr={type:"childadded",child:null},Oc={type:"childremoved",child:null};class tn extends vr{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:$x++}),this.uuid=Ea(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=tn.DEFAULT_UP.clone();const e=new k,t=new Mi,i=new Rn,s=new k(1,1,1);function r(){i.setFromEuler(t,!1)}function o(){t.setFromQuaternion(i,void 0,!1)}t._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Rt},normalMatrix:{value:new rt}}),this.matrix=new Rt,this.matrixWorld=new Rt,this.matrixAutoUpdate=tn.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=tn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new ef,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.userData={}}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return Or.setFromAxisAngle(e,t),this.quaternion.multiply(Or),this}rotateOnWorldAxis(e,t){return Or.setFromAxisAngle(e,t),this.quaternion.premultiply(Or),this}rotateX(e){return this.rotateOnAxis(zd,e)}rotateY(e){return this.rotateOnAxis(Hd,e)}rotateZ(e){return this.rotateOnAxis(Vd,e)}translateOnAxis(e,t){return Bd.copy(e).applyQuaternion(this.quaternion),this.position.add(Bd.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(zd,e)}translateY(e){return this.translateOnAxis(Hd,e)}translateZ(e){return this.translateOnAxis(Vd,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(Qi.copy(this.matrixWorld).invert())}lookAt(e,t,i){e.isVector3?Ga.copy(e):Ga.set(e,t,i);const s=this.parent;this.updateWorldMatrix(!0,!1),No.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Qi.lookAt(No,Ga,this.up):Qi.lookAt(Ga,No,this.up),this.quaternion.setFromRotationMatrix(Qi),s&&(Qi.extractRotation(s.matrixWorld),Or.setFromRotationMatrix(Qi),this.quaternion.premultiply(Or.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(console.error("THREE.Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(Gd),kr.child=e,this.dispatchEvent(kr),kr.child=null):console.error("THREE.Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}const t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(Kx),Oc.child=e,this.dispatchEvent(Oc),Oc.child=null),this}removeFromParent(){const e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),Qi.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),Qi.multiply(e.parent.matrixWorld)),e.applyMatrix4(Qi),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(Gd),kr.child=e,this.dispatchEvent(kr),kr.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let i=0,s=this.children.length;i<s;i++){const o=this.children[i].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,i=[]){this[e]===t&&i.push(this);const s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,i);return i}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(No,e,jx),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(No,Zx,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);const t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}traverse(e){e(this);const t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);const t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverseVisible(e)}traverseAncestors(e){const t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale),this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);const t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].updateMatrixWorld(e)}updateWorldMatrix(e,t){const i=this.parent;if(e===!0&&i!==null&&i.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),t===!0){const s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].updateWorldMatrix(!1,!0)}}toJSON(e){const t=e===void 0||typeof e=="string",i={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});const s={};s.uuid=this.uuid,s.type=this.type,this.name!==""&&(s.name=this.name),this.castShadow===!0&&(s.castShadow=!0),this.receiveShadow===!0&&(s.receiveShadow=!0),this.visible===!1&&(s.visible=!1),this.frustumCulled===!1&&(s.frustumCulled=!1),this.renderOrder!==0&&(s.renderOrder=this.renderOrder),Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.matrixAutoUpdate===!1&&(s.matrixAutoUpdate=!1),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);const a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){const l=a.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){const f=l[c];r(e.shapes,f)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){const a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(e.materials,this.material[l]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){const l=this.animations[a];s.animations.push(r(e.animations,l))}}if(t){const a=o(e.geometries),l=o(e.materials),c=o(e.textures),h=o(e.images),f=o(e.shapes),d=o(e.skeletons),u=o(e.animations),_=o(e.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),h.length>0&&(i.images=h),f.length>0&&(i.shapes=f),d.length>0&&(i.skeletons=d),u.length>0&&(i.animations=u),_.length>0&&(i.nodes=_)}return i.object=s,i;function o(a){const l=[];for(const c in a){const h=a[c];delete h.metadata,l.push(h)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let i=0;i<e.children.length;i++){const s=e.children[i];this.add(s.clone())}return this}}tn.DEFAULT_UP=new k(0,1,0);tn.DEFAULT_MATRIX_AUTO_UPDATE=!0;tn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;const Ti=new k,es=new k,kc=new k,ts=new k,Br=new k,zr=new k,Wd=new k,Bc=new k,zc=new k,Hc=new k,Vc=new en,Gc=new en,Wc=new en;class Pi{constructor(e=new k,t=new k,i=new k){this.a=e,this.b=t,this.c=i}static getNormal(e,t,i,s){s.subVectors(i,t),Ti.subVectors(e,t),s.cross(Ti);const r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,i,s,r){Ti.subVectors(s,t),es.subVectors(i,t),kc.subVectors(e,t);const o=Ti.dot(Ti),a=Ti.dot(es),l=Ti.dot(kc),c=es.dot(es),h=es.dot(kc),f=o*c-a*a;if(f===0)return r.set(0,0,0),null;const d=1/f,u=(c*l-a*h)*d,_=(o*h-a*l)*d;return r.set(1-u-_,_,u)}static containsPoint(e,t,i,s){return this.getBarycoord(e,t,i,s,ts)===null?!1:ts.x>=0&&ts.y>=0&&ts.x+ts.y<=1}static getInterpolation(e,t,i,s,r,o,a,l){return this.getBarycoord(e,t,i,s,ts)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,ts.x),l.addScaledVector(o,ts.y),l.addScaledVector(a,ts.z),l)}static getInterpolatedAttribute(e,t,i,s,r,o){return Vc.setScalar(0),Gc.setScalar(0),Wc.setScalar(0),Vc.fromBufferAttribute(e,t),Gc.fromBufferAttribute(e,i),Wc.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(Vc,r.x),o.addScaledVector(Gc,r.y),o.addScaledVector(Wc,r.z),o}static isFrontFacing(e,t,i,s){return Ti.subVectors(i,t),es.subVectors(e,t),Ti.cross(es).dot(s)<0}set(e,t,i){return this.a.copy(e),this.b.copy(t),this.c.copy(i),this}setFromPointsAndIndices(e,t,i,s){return this.a.copy(e[t]),this.b.copy(e[i]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,i,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,i),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return Ti.subVectors(this.c,this.b),es.subVectors(this.a,this.b),Ti.cross(es).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return Pi.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return Pi.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,i,s,r){return Pi.getInterpolation(e,this.a,this.b,this.c,t,i,s,r)}containsPoint(e){return Pi.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return Pi.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){const i=this.a,s=this.b,r=this.c;let o,a;Br.subVectors(s,i),zr.subVectors(r,i),Bc.subVectors(e,i);const l=Br.dot(Bc),c=zr.dot(Bc);if(l<=0&&c<=0)return t.copy(i);zc.subVectors(e,s);const h=Br.dot(zc),f=zr.dot(zc);if(h>=0&&f<=h)return t.copy(s);const d=l*f-h*c;if(d<=0&&l>=0&&h<=0)return o=l/(l-h),t.copy(i).addScaledVector(Br,o);Hc.subVectors(e,r);const u=Br.dot(Hc),_=zr.dot(Hc);if(_>=0&&u<=_)return t.copy(r);const v=u*c-l*_;if(v<=0&&c>=0&&_<=0)return a=c/(c-_),t.copy(i).addScaledVector(zr,a);const m=h*_-u*f;if(m<=0&&f-h>=0&&u-_>=0)return Wd.subVectors(r,s),a=(f-h)/(f-h+(u-_)),t.copy(s).addScaledVector(Wd,a);const p=1/(m+v+d);return o=v*p,a=d*p,t.copy(i).addScaledVector(Br,o).addScaledVector(zr,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}}const A_={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Es={h:0,s:0,l:0},Wa={h:0,s:0,l:0};function Xc(n,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?n+(e-n)*6*t:t<1/2?e:t<2/3?n+(e-n)*6*(2/3-t):n}class Je{constructor(e,t,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,i)}set(e,t,i){if(t===void 0&&i===void 0){const s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,i);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=mi){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,xt.colorSpaceToWorking(this,t),this}setRGB(e,t,i,s=xt.workingColorSpace){return this.r=e,this.g=t,this.b=i,xt.colorSpaceToWorking(this,s),this}setHSL(e,t,i,s=xt.workingColorSpace){if(e=Nx(e,1),t=ft(t,0,1),i=ft(i,0,1),t===0)this.r=this.g=this.b=i;else{const r=i<=.5?i*(1+t):i+t-i*t,o=2*i-r;this.r=Xc(o,r,e+1/3),this.g=Xc(o,r,e),this.b=Xc(o,r,e-1/3)}return xt.colorSpaceToWorking(this,s),this}setStyle(e,t=mi){function i(r){r!==void 0&&parseFloat(r)<1&&console.warn("THREE.Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r;const o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+)\%\s*,\s*(\d+)\%\s*,\s*(\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseInt(r[1],10))/100,Math.min(100,parseInt(r[2],10))/100,Math.min(100,parseInt(r[3],10))/100,t);break;case"hsl":case"hsla":if(r=/^\s*(\d*\.?\d+)\s*,\s*(\d*\.?\d+)\%\s*,\s*(\d*\.?\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:console.warn("THREE.Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){const r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);console.warn("THREE.Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=mi){const i=A_[e.toLowerCase()];return i!==void 0?this.setHex(i,t):console.warn("THREE.Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=os(e.r),this.g=os(e.g),this.b=os(e.b),this}copyLinearToSRGB(e){return this.r=eo(e.r),this.g=eo(e.g),this.b=eo(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=mi){return xt.workingToColorSpace(In.copy(this),e),Math.round(ft(In.r*255,0,255))*65536+Math.round(ft(In.g*255,0,255))*256+Math.round(ft(In.b*255,0,255))}getHexString(e=mi){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=xt.workingColorSpace){xt.workingToColorSpace(In.copy(this),t);const i=In.r,s=In.g,r=In.b,o=Math.max(i,s,r),a=Math.min(i,s,r);let l,c;const h=(a+o)/2;if(a===o)l=0,c=0;else{const f=o-a;switch(c=h<=.5?f/(o+a):f/(2-o-a),o){case i:l=(s-r)/f+(s<r?6:0);break;case s:l=(r-i)/f+2;break;case r:l=(i-s)/f+4;break}l/=6}return e.h=l,e.s=c,e.l=h,e}getRGB(e,t=xt.workingColorSpace){return xt.workingToColorSpace(In.copy(this),t),e.r=In.r,e.g=In.g,e.b=In.b,e}getStyle(e=mi){xt.workingToColorSpace(In.copy(this),e);const t=In.r,i=In.g,s=In.b;return e!==mi?`color(${e} ${t.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(e,t,i){return this.getHSL(Es),this.setHSL(Es.h+e,Es.s+t,Es.l+i)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,i){return this.r=e.r+(t.r-e.r)*i,this.g=e.g+(t.g-e.g)*i,this.b=e.b+(t.b-e.b)*i,this}lerpHSL(e,t){this.getHSL(Es),e.getHSL(Wa);const i=Ac(Es.h,Wa.h,t),s=Ac(Es.s,Wa.s,t),r=Ac(Es.l,Wa.l,t);return this.setHSL(i,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){const t=this.r,i=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*i+r[6]*s,this.g=r[1]*t+r[4]*i+r[7]*s,this.b=r[2]*t+r[5]*i+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}}const In=new Je;Je.NAMES=A_;let Jx=0;class ks extends vr{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:Jx++}),this.uuid=Ea(),this.name="",this.type="Material",this.blending=Qr,this.side=cs,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Ah,this.blendDst=Rh,this.blendEquation=sr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new Je(0,0,0),this.blendAlpha=0,this.depthFunc=lo,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Pd,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Dr,this.stencilZFail=Dr,this.stencilZPass=Dr,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(const t in e){const i=e[t];if(i===void 0){console.warn(`THREE.Material: parameter '${t}' has value of undefined.`);continue}const s=this[t];if(s===void 0){console.warn(`THREE.Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[t]=i}}toJSON(e){const t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});const i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,this.name!==""&&(i.name=this.name),this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&this.emissiveIntensity!==1&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessRange!==void 0&&(i.iridescenceThicknessRange=this.iridescenceThicknessRange),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(e).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(e).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(e).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(e).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(e).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&this.attenuationDistance!==1/0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.shadowSide!==null&&(i.shadowSide=this.shadowSide),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),this.blending!==Qr&&(i.blending=this.blending),this.side!==cs&&(i.side=this.side),this.vertexColors===!0&&(i.vertexColors=!0),this.opacity<1&&(i.opacity=this.opacity),this.transparent===!0&&(i.transparent=!0),this.blendSrc!==Ah&&(i.blendSrc=this.blendSrc),this.blendDst!==Rh&&(i.blendDst=this.blendDst),this.blendEquation!==sr&&(i.blendEquation=this.blendEquation),this.blendSrcAlpha!==null&&(i.blendSrcAlpha=this.blendSrcAlpha),this.blendDstAlpha!==null&&(i.blendDstAlpha=this.blendDstAlpha),this.blendEquationAlpha!==null&&(i.blendEquationAlpha=this.blendEquationAlpha),this.blendColor&&this.blendColor.isColor&&(i.blendColor=this.blendColor.getHex()),this.blendAlpha!==0&&(i.blendAlpha=this.blendAlpha),this.depthFunc!==lo&&(i.depthFunc=this.depthFunc),this.depthTest===!1&&(i.depthTest=this.depthTest),this.depthWrite===!1&&(i.depthWrite=this.depthWrite),this.colorWrite===!1&&(i.colorWrite=this.colorWrite),this.stencilWriteMask!==255&&(i.stencilWriteMask=this.stencilWriteMask),this.stencilFunc!==Pd&&(i.stencilFunc=this.stencilFunc),this.stencilRef!==0&&(i.stencilRef=this.stencilRef),this.stencilFuncMask!==255&&(i.stencilFuncMask=this.stencilFuncMask),this.stencilFail!==Dr&&(i.stencilFail=this.stencilFail),this.stencilZFail!==Dr&&(i.stencilZFail=this.stencilZFail),this.stencilZPass!==Dr&&(i.stencilZPass=this.stencilZPass),this.stencilWrite===!0&&(i.stencilWrite=this.stencilWrite),this.rotation!==void 0&&this.rotation!==0&&(i.rotation=this.rotation),this.polygonOffset===!0&&(i.polygonOffset=!0),this.polygonOffsetFactor!==0&&(i.polygonOffsetFactor=this.polygonOffsetFactor),this.polygonOffsetUnits!==0&&(i.polygonOffsetUnits=this.polygonOffsetUnits),this.linewidth!==void 0&&this.linewidth!==1&&(i.linewidth=this.linewidth),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.dithering===!0&&(i.dithering=!0),this.alphaTest>0&&(i.alphaTest=this.alphaTest),this.alphaHash===!0&&(i.alphaHash=!0),this.alphaToCoverage===!0&&(i.alphaToCoverage=!0),this.premultipliedAlpha===!0&&(i.premultipliedAlpha=!0),this.forceSinglePass===!0&&(i.forceSinglePass=!0),this.wireframe===!0&&(i.wireframe=!0),this.wireframeLinewidth>1&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!=="round"&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!=="round"&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading===!0&&(i.flatShading=!0),this.visible===!1&&(i.visible=!1),this.toneMapped===!1&&(i.toneMapped=!1),this.fog===!1&&(i.fog=!1),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){const o=[];for(const a in r){const l=r[a];delete l.metadata,o.push(l)}return o}if(t){const r=s(e.textures),o=s(e.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;const t=e.clippingPlanes;let i=null;if(t!==null){const s=t.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=t[r].clone()}return this.clippingPlanes=i,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}}class ic extends ks{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new Je(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Mi,this.combine=Wu,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}}const rn=new k,Xa=new Ke;let Qx=0;class Cn{constructor(e,t,i=!1){if(Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:Qx++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=i,this.usage=Dd,this.updateRanges=[],this.gpuType=Wi,this.version=0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this}copyAt(e,t,i){e*=this.itemSize,i*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[i+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,i=this.count;t<i;t++)Xa.fromBufferAttribute(this,t),Xa.applyMatrix3(e),this.setXY(t,Xa.x,Xa.y);else if(this.itemSize===3)for(let t=0,i=this.count;t<i;t++)rn.fromBufferAttribute(this,t),rn.applyMatrix3(e),this.setXYZ(t,rn.x,rn.y,rn.z);return this}applyMatrix4(e){for(let t=0,i=this.count;t<i;t++)rn.fromBufferAttribute(this,t),rn.applyMatrix4(e),this.setXYZ(t,rn.x,rn.y,rn.z);return this}applyNormalMatrix(e){for(let t=0,i=this.count;t<i;t++)rn.fromBufferAttribute(this,t),rn.applyNormalMatrix(e),this.setXYZ(t,rn.x,rn.y,rn.z);return this}transformDirection(e){for(let t=0,i=this.count;t<i;t++)rn.fromBufferAttribute(this,t),rn.transformDirection(e),this.setXYZ(t,rn.x,rn.y,rn.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let i=this.array[e*this.itemSize+t];return this.normalized&&(i=Lo(i,this.array)),i}setComponent(e,t,i){return this.normalized&&(i=jn(i,this.array)),this.array[e*this.itemSize+t]=i,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=Lo(t,this.array)),t}setX(e,t){return this.normalized&&(t=jn(t,this.array)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=Lo(t,this.array)),t}setY(e,t){return this.normalized&&(t=jn(t,this.array)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=Lo(t,this.array)),t}setZ(e,t){return this.normalized&&(t=jn(t,this.array)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=Lo(t,this.array)),t}setW(e,t){return this.normalized&&(t=jn(t,this.array)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,i){return e*=this.itemSize,this.normalized&&(t=jn(t,this.array),i=jn(i,this.array)),this.array[e+0]=t,this.array[e+1]=i,this}setXYZ(e,t,i,s){return e*=this.itemSize,this.normalized&&(t=jn(t,this.array),i=jn(i,this.array),s=jn(s,this.array)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this}setXYZW(e,t,i,s,r){return e*=this.itemSize,this.normalized&&(t=jn(t,this.array),i=jn(i,this.array),s=jn(s,this.array),r=jn(r,this.array)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){const e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return this.name!==""&&(e.name=this.name),this.usage!==Dd&&(e.usage=this.usage),e}}class R_ extends Cn{constructor(e,t,i){super(new Uint16Array(e),t,i)}}class C_ extends Cn{constructor(e,t,i){super(new Uint32Array(e),t,i)}}class qt extends Cn{constructor(e,t,i){super(new Float32Array(e),t,i)}}let eM=0;const ui=new Rt,Yc=new tn,Hr=new k,ii=new Os,Fo=new Os,bn=new k;class nn extends vr{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:eM++}),this.uuid=Ea(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={}}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(w_(e)?C_:R_)(e,1):this.index=e,this}setIndirect(e){return this.indirect=e,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,i=0){this.groups.push({start:e,count:t,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){const t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);const i=this.attributes.normal;if(i!==void 0){const r=new rt().getNormalMatrix(e);i.applyNormalMatrix(r),i.needsUpdate=!0}const s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this}applyQuaternion(e){return ui.makeRotationFromQuaternion(e),this.applyMatrix4(ui),this}rotateX(e){return ui.makeRotationX(e),this.applyMatrix4(ui),this}rotateY(e){return ui.makeRotationY(e),this.applyMatrix4(ui),this}rotateZ(e){return ui.makeRotationZ(e),this.applyMatrix4(ui),this}translate(e,t,i){return ui.makeTranslation(e,t,i),this.applyMatrix4(ui),this}scale(e,t,i){return ui.makeScale(e,t,i),this.applyMatrix4(ui),this}lookAt(e){return Yc.lookAt(e),Yc.updateMatrix(),this.applyMatrix4(Yc.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Hr).negate(),this.translate(Hr.x,Hr.y,Hr.z),this}setFromPoints(e){const t=this.getAttribute("position");if(t===void 0){const i=[];for(let s=0,r=e.length;s<r;s++){const o=e[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new qt(i,3))}else{const i=Math.min(e.length,t.count);for(let s=0;s<i;s++){const r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&console.warn("THREE.BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Os);const e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){console.error("THREE.BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new k(-1/0,-1/0,-1/0),new k(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let i=0,s=t.length;i<s;i++){const r=t[i];ii.setFromBufferAttribute(r),this.morphTargetsRelative?(bn.addVectors(this.boundingBox.min,ii.min),this.boundingBox.expandByPoint(bn),bn.addVectors(this.boundingBox.max,ii.max),this.boundingBox.expandByPoint(bn)):(this.boundingBox.expandByPoint(ii.min),this.boundingBox.expandByPoint(ii.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&console.error('THREE.BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new xr);const e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){console.error("THREE.BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new k,1/0);return}if(e){const i=this.boundingSphere.center;if(ii.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){const a=t[r];Fo.setFromBufferAttribute(a),this.morphTargetsRelative?(bn.addVectors(ii.min,Fo.min),ii.expandByPoint(bn),bn.addVectors(ii.max,Fo.max),ii.expandByPoint(bn)):(ii.expandByPoint(Fo.min),ii.expandByPoint(Fo.max))}ii.getCenter(i);let s=0;for(let r=0,o=e.count;r<o;r++)bn.fromBufferAttribute(e,r),s=Math.max(s,i.distanceToSquared(bn));if(t)for(let r=0,o=t.length;r<o;r++){const a=t[r],l=this.morphTargetsRelative;for(let c=0,h=a.count;c<h;c++)bn.fromBufferAttribute(a,c),l&&(Hr.fromBufferAttribute(e,c),bn.add(Hr)),s=Math.max(s,i.distanceToSquared(bn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&console.error('THREE.BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){const e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){console.error("THREE.BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}const i=t.position,s=t.normal,r=t.uv;this.hasAttribute("tangent")===!1&&this.setAttribute("tangent",new Cn(new Float32Array(4*i.count),4));const o=this.getAttribute("tangent"),a=[],l=[];for(let N=0;N<i.count;N++)a[N]=new k,l[N]=new k;const c=new k,h=new k,f=new k,d=new Ke,u=new Ke,_=new Ke,v=new k,m=new k;function p(N,b,E){c.fromBufferAttribute(i,N),h.fromBufferAttribute(i,b),f.fromBufferAttribute(i,E),d.fromBufferAttribute(r,N),u.fromBufferAttribute(r,b),_.fromBufferAttribute(r,E),h.sub(c),f.sub(c),u.sub(d),_.sub(d);const C=1/(u.x*_.y-_.x*u.y);isFinite(C)&&(v.copy(h).multiplyScalar(_.y).addScaledVector(f,-u.y).multiplyScalar(C),m.copy(f).multiplyScalar(u.x).addScaledVector(h,-_.x).multiplyScalar(C),a[N].add(v),a[b].add(v),a[E].add(v),l[N].add(m),l[b].add(m),l[E].add(m))}let y=this.groups;y.length===0&&(y=[{start:0,count:e.count}]);for(let N=0,b=y.length;N<b;++N){const E=y[N],C=E.start,B=E.count;for(let z=C,Y=C+B;z<Y;z+=3)p(e.getX(z+0),e.getX(z+1),e.getX(z+2))}const w=new k,x=new k,L=new k,A=new k;function U(N){L.fromBufferAttribute(s,N),A.copy(L);const b=a[N];w.copy(b),w.sub(L.multiplyScalar(L.dot(b))).normalize(),x.crossVectors(A,b);const C=x.dot(l[N])<0?-1:1;o.setXYZW(N,w.x,w.y,w.z,C)}for(let N=0,b=y.length;N<b;++N){const E=y[N],C=E.start,B=E.count;for(let z=C,Y=C+B;z<Y;z+=3)U(e.getX(z+0)),U(e.getX(z+1)),U(e.getX(z+2))}}computeVertexNormals(){const e=this.index,t=this.getAttribute("position");if(t!==void 0){let i=this.getAttribute("normal");if(i===void 0)i=new Cn(new Float32Array(t.count*3),3),this.setAttribute("normal",i);else for(let d=0,u=i.count;d<u;d++)i.setXYZ(d,0,0,0);const s=new k,r=new k,o=new k,a=new k,l=new k,c=new k,h=new k,f=new k;if(e)for(let d=0,u=e.count;d<u;d+=3){const _=e.getX(d+0),v=e.getX(d+1),m=e.getX(d+2);s.fromBufferAttribute(t,_),r.fromBufferAttribute(t,v),o.fromBufferAttribute(t,m),h.subVectors(o,r),f.subVectors(s,r),h.cross(f),a.fromBufferAttribute(i,_),l.fromBufferAttribute(i,v),c.fromBufferAttribute(i,m),a.add(h),l.add(h),c.add(h),i.setXYZ(_,a.x,a.y,a.z),i.setXYZ(v,l.x,l.y,l.z),i.setXYZ(m,c.x,c.y,c.z)}else for(let d=0,u=t.count;d<u;d+=3)s.fromBufferAttribute(t,d+0),r.fromBufferAttribute(t,d+1),o.fromBufferAttribute(t,d+2),h.subVectors(o,r),f.subVectors(s,r),h.cross(f),i.setXYZ(d+0,h.x,h.y,h.z),i.setXYZ(d+1,h.x,h.y,h.z),i.setXYZ(d+2,h.x,h.y,h.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){const e=this.attributes.normal;for(let t=0,i=e.count;t<i;t++)bn.fromBufferAttribute(e,t),bn.normalize(),e.setXYZ(t,bn.x,bn.y,bn.z)}toNonIndexed(){function e(a,l){const c=a.array,h=a.itemSize,f=a.normalized,d=new c.constructor(l.length*h);let u=0,_=0;for(let v=0,m=l.length;v<m;v++){a.isInterleavedBufferAttribute?u=l[v]*a.data.stride+a.offset:u=l[v]*h;for(let p=0;p<h;p++)d[_++]=c[u++]}return new Cn(d,h,f)}if(this.index===null)return console.warn("THREE.BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;const t=new nn,i=this.index.array,s=this.attributes;for(const a in s){const l=s[a],c=e(l,i);t.setAttribute(a,c)}const r=this.morphAttributes;for(const a in r){const l=[],c=r[a];for(let h=0,f=c.length;h<f;h++){const d=c[h],u=e(d,i);l.push(u)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;const o=this.groups;for(let a=0,l=o.length;a<l;a++){const c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){const e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.type,this.name!==""&&(e.name=this.name),Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0){const l=this.parameters;for(const c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};const t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});const i=this.attributes;for(const l in i){const c=i[l];e.data.attributes[l]=c.toJSON(e.data)}const s={};let r=!1;for(const l in this.morphAttributes){const c=this.morphAttributes[l],h=[];for(let f=0,d=c.length;f<d;f++){const u=c[f];h.push(u.toJSON(e.data))}h.length>0&&(s[l]=h,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);const o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));const a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;const t={};this.name=e.name;const i=e.index;i!==null&&this.setIndex(i.clone());const s=e.attributes;for(const c in s){const h=s[c];this.setAttribute(c,h.clone(t))}const r=e.morphAttributes;for(const c in r){const h=[],f=r[c];for(let d=0,u=f.length;d<u;d++)h.push(f[d].clone(t));this.morphAttributes[c]=h}this.morphTargetsRelative=e.morphTargetsRelative;const o=e.groups;for(let c=0,h=o.length;c<h;c++){const f=o[c];this.addGroup(f.start,f.count,f.materialIndex)}const a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());const l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this}dispose(){this.dispatchEvent({type:"dispose"})}}const Xd=new Rt,qs=new nc,Ya=new xr,Yd=new k,qa=new k,$a=new k,ja=new k,qc=new k,Za=new k,qd=new k,Ka=new k;class be extends tn{constructor(e=new nn,t=new ic){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0&&(this.morphTargetInfluences=e.morphTargetInfluences.slice()),e.morphTargetDictionary!==void 0&&(this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary)),this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){const t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){const s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){const a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){const i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;t.fromBufferAttribute(s,e);const a=this.morphTargetInfluences;if(r&&a){Za.set(0,0,0);for(let l=0,c=r.length;l<c;l++){const h=a[l],f=r[l];h!==0&&(qc.fromBufferAttribute(f,e),o?Za.addScaledVector(qc,h):Za.addScaledVector(qc.sub(t),h))}t.add(Za)}return t}raycast(e,t){const i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),Ya.copy(i.boundingSphere),Ya.applyMatrix4(r),qs.copy(e.ray).recast(e.near),!(Ya.containsPoint(qs.origin)===!1&&(qs.intersectSphere(Ya,Yd)===null||qs.origin.distanceToSquared(Yd)>(e.far-e.near)**2))&&(Xd.copy(r).invert(),qs.copy(e.ray).applyMatrix4(Xd),!(i.boundingBox!==null&&qs.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(e,t,qs)))}_computeIntersections(e,t,i){let s;const r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,h=r.attributes.uv1,f=r.attributes.normal,d=r.groups,u=r.drawRange;if(a!==null)if(Array.isArray(o))for(let _=0,v=d.length;_<v;_++){const m=d[_],p=o[m.materialIndex],y=Math.max(m.start,u.start),w=Math.min(a.count,Math.min(m.start+m.count,u.start+u.count));for(let x=y,L=w;x<L;x+=3){const A=a.getX(x),U=a.getX(x+1),N=a.getX(x+2);s=Ja(this,p,e,i,c,h,f,A,U,N),s&&(s.faceIndex=Math.floor(x/3),s.face.materialIndex=m.materialIndex,t.push(s))}}else{const _=Math.max(0,u.start),v=Math.min(a.count,u.start+u.count);for(let m=_,p=v;m<p;m+=3){const y=a.getX(m),w=a.getX(m+1),x=a.getX(m+2);s=Ja(this,o,e,i,c,h,f,y,w,x),s&&(s.faceIndex=Math.floor(m/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let _=0,v=d.length;_<v;_++){const m=d[_],p=o[m.materialIndex],y=Math.max(m.start,u.start),w=Math.min(l.count,Math.min(m.start+m.count,u.start+u.count));for(let x=y,L=w;x<L;x+=3){const A=x,U=x+1,N=x+2;s=Ja(this,p,e,i,c,h,f,A,U,N),s&&(s.faceIndex=Math.floor(x/3),s.face.materialIndex=m.materialIndex,t.push(s))}}else{const _=Math.max(0,u.start),v=Math.min(l.count,u.start+u.count);for(let m=_,p=v;m<p;m+=3){const y=m,w=m+1,x=m+2;s=Ja(this,o,e,i,c,h,f,y,w,x),s&&(s.faceIndex=Math.floor(m/3),t.push(s))}}}}function tM(n,e,t,i,s,r,o,a){let l;if(e.side===Kn?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,e.side===cs,a),l===null)return null;Ka.copy(a),Ka.applyMatrix4(n.matrixWorld);const c=t.ray.origin.distanceTo(Ka);return c<t.near||c>t.far?null:{distance:c,point:Ka.clone(),object:n}}function Ja(n,e,t,i,s,r,o,a,l,c){n.getVertexPosition(a,qa),n.getVertexPosition(l,$a),n.getVertexPosition(c,ja);const h=tM(n,e,t,i,qa,$a,ja,qd);if(h){const f=new k;Pi.getBarycoord(qd,qa,$a,ja,f),s&&(h.uv=Pi.getInterpolatedAttribute(s,a,l,c,f,new Ke)),r&&(h.uv1=Pi.getInterpolatedAttribute(r,a,l,c,f,new Ke)),o&&(h.normal=Pi.getInterpolatedAttribute(o,a,l,c,f,new k),h.normal.dot(i.direction)>0&&h.normal.multiplyScalar(-1));const d={a,b:l,c,normal:new k,materialIndex:0};Pi.getNormal(qa,$a,ja,d.normal),h.face=d,h.barycoord=f}return h}class on extends nn{constructor(e=1,t=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};const a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);const l=[],c=[],h=[],f=[];let d=0,u=0;_("z","y","x",-1,-1,i,t,e,o,r,0),_("z","y","x",1,-1,i,t,-e,o,r,1),_("x","z","y",1,1,e,i,t,s,o,2),_("x","z","y",1,-1,e,i,-t,s,o,3),_("x","y","z",1,-1,e,t,i,s,r,4),_("x","y","z",-1,-1,e,t,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new qt(c,3)),this.setAttribute("normal",new qt(h,3)),this.setAttribute("uv",new qt(f,2));function _(v,m,p,y,w,x,L,A,U,N,b){const E=x/U,C=L/N,B=x/2,z=L/2,Y=A/2,W=U+1,j=N+1;let q=0,K=0;const re=new k;for(let ae=0;ae<j;ae++){const me=ae*C-z;for(let xe=0;xe<W;xe++){const ge=xe*E-B;re[v]=ge*y,re[m]=me*w,re[p]=Y,c.push(re.x,re.y,re.z),re[v]=0,re[m]=0,re[p]=A>0?1:-1,h.push(re.x,re.y,re.z),f.push(xe/U),f.push(1-ae/N),q+=1}}for(let ae=0;ae<N;ae++)for(let me=0;me<U;me++){const xe=d+me+W*ae,ge=d+me+W*(ae+1),Qe=d+(me+1)+W*(ae+1),et=d+(me+1)+W*ae;l.push(xe,ge,et),l.push(ge,Qe,et),K+=6}a.addGroup(u,K,b),u+=K,d+=q}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new on(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}}function fo(n){const e={};for(const t in n){e[t]={};for(const i in n[t]){const s=n[t][i];s&&(s.isColor||s.isMatrix3||s.isMatrix4||s.isVector2||s.isVector3||s.isVector4||s.isTexture||s.isQuaternion)?s.isRenderTargetTexture?(console.warn("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][i]=null):e[t][i]=s.clone():Array.isArray(s)?e[t][i]=s.slice():e[t][i]=s}}return e}function Gn(n){const e={};for(let t=0;t<n.length;t++){const i=fo(n[t]);for(const s in i)e[s]=i[s]}return e}function nM(n){const e=[];for(let t=0;t<n.length;t++)e.push(n[t].clone());return e}function P_(n){const e=n.getRenderTarget();return e===null?n.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:xt.workingColorSpace}const iM={clone:fo,merge:Gn};var sM=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,rM=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`;class hs extends ks{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=sM,this.fragmentShader=rM,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=fo(e.uniforms),this.uniformsGroups=nM(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this}toJSON(e){const t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(const s in this.uniforms){const o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;const i={};for(const s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(t.extensions=i),t}}class D_ extends tn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Rt,this.projectionMatrix=new Rt,this.projectionMatrixInverse=new Rt,this.coordinateSystem=Xi,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorldInverse.copy(this.matrixWorld).invert()}updateWorldMatrix(e,t){super.updateWorldMatrix(e,t),this.matrixWorldInverse.copy(this.matrixWorld).invert()}clone(){return new this.constructor().copy(this)}}const bs=new k,$d=new Ke,jd=new Ke;class _i extends D_{constructor(e=50,t=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){const t=.5*this.getFilmHeight()/e;this.fov=pu*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){const e=Math.tan(yl*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return pu*2*Math.atan(Math.tan(yl*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,i){bs.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(bs.x,bs.y).multiplyScalar(-e/bs.z),bs.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(bs.x,bs.y).multiplyScalar(-e/bs.z)}getViewSize(e,t){return this.getViewBounds(e,$d,jd),t.subVectors(jd,$d)}setViewOffset(e,t,i,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){const e=this.near;let t=e*Math.tan(yl*.5*this.fov)/this.zoom,i=2*t,s=this.aspect*i,r=-.5*s;const o=this.view;if(this.view!==null&&this.view.enabled){const l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,t-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}const a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-i,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){const t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}}const Vr=-90,Gr=1;class oM extends tn{constructor(e,t,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;const s=new _i(Vr,Gr,e,t);s.layers=this.layers,this.add(s);const r=new _i(Vr,Gr,e,t);r.layers=this.layers,this.add(r);const o=new _i(Vr,Gr,e,t);o.layers=this.layers,this.add(o);const a=new _i(Vr,Gr,e,t);a.layers=this.layers,this.add(a);const l=new _i(Vr,Gr,e,t);l.layers=this.layers,this.add(l);const c=new _i(Vr,Gr,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){const e=this.coordinateSystem,t=this.children.concat(),[i,s,r,o,a,l]=t;for(const c of t)this.remove(c);if(e===Xi)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===kl)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(const c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();const{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());const[r,o,a,l,c,h]=this.children,f=e.getRenderTarget(),d=e.getActiveCubeFace(),u=e.getActiveMipmapLevel(),_=e.xr.enabled;e.xr.enabled=!1;const v=i.texture.generateMipmaps;i.texture.generateMipmaps=!1,e.setRenderTarget(i,0,s),e.render(t,r),e.setRenderTarget(i,1,s),e.render(t,o),e.setRenderTarget(i,2,s),e.render(t,a),e.setRenderTarget(i,3,s),e.render(t,l),e.setRenderTarget(i,4,s),e.render(t,c),i.texture.generateMipmaps=v,e.setRenderTarget(i,5,s),e.render(t,h),e.setRenderTarget(f,d,u),e.xr.enabled=_,i.texture.needsPMREMUpdate=!0}}class L_ extends Yn{constructor(e=[],t=co,i,s,r,o,a,l,c,h){super(e,t,i,s,r,o,a,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}}class aM extends mr{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;const i={width:e,height:e,depth:1},s=[i,i,i,i,i,i];this.texture=new L_(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;const i={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new on(5,5,5),r=new hs({name:"CubemapFromEquirect",uniforms:fo(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:Kn,blending:Ds});r.uniforms.tEquirect.value=t;const o=new be(s,r),a=t.minFilter;return t.minFilter===cr&&(t.minFilter=Gi),new oM(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,i=!0,s=!0){const r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,i,s);e.setRenderTarget(r)}}class Yi extends tn{constructor(){super(),this.isGroup=!0,this.type="Group"}}const lM={type:"move"};class $c{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Yi,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Yi,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new k,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new k),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Yi,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new k,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new k),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){const t=this._hand;if(t)for(const i of e.hand.values())this._getHandJoint(t,i)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,i){let s=null,r=null,o=null;const a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(const v of e.hand.values()){const m=t.getJointPose(v,i),p=this._getHandJoint(c,v);m!==null&&(p.matrix.fromArray(m.transform.matrix),p.matrix.decompose(p.position,p.rotation,p.scale),p.matrixWorldNeedsUpdate=!0,p.jointRadius=m.radius),p.visible=m!==null}const h=c.joints["index-finger-tip"],f=c.joints["thumb-tip"],d=h.position.distanceTo(f.position),u=.02,_=.005;c.inputState.pinching&&d>u+_?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&d<=u-_&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.rotation,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1));a!==null&&(s=t.getPose(e.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.rotation,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(lM)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){const i=new Yi;i.matrixAutoUpdate=!1,i.visible=!1,e.joints[t.jointName]=i,e.add(i)}return e.joints[t.jointName]}}class cM extends tn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Mi,this.environmentIntensity=1,this.environmentRotation=new Mi,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),e.background!==null&&(this.background=e.background.clone()),e.environment!==null&&(this.environment=e.environment.clone()),e.fog!==null&&(this.fog=e.fog.clone()),this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),e.overrideMaterial!==null&&(this.overrideMaterial=e.overrideMaterial.clone()),this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){const t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),this.backgroundBlurriness>0&&(t.object.backgroundBlurriness=this.backgroundBlurriness),this.backgroundIntensity!==1&&(t.object.backgroundIntensity=this.backgroundIntensity),t.object.backgroundRotation=this.backgroundRotation.toArray(),this.environmentIntensity!==1&&(t.object.environmentIntensity=this.environmentIntensity),t.object.environmentRotation=this.environmentRotation.toArray(),t}}class hM extends Yn{constructor(e=null,t=1,i=1,s,r,o,a,l,c=oi,h=oi,f,d){super(null,o,a,l,c,h,s,r,f,d),this.isDataTexture=!0,this.image={data:e,width:t,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}}class Zd extends Cn{constructor(e,t,i,s=1){super(e,t,i),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}toJSON(){const e=super.toJSON();return e.meshPerAttribute=this.meshPerAttribute,e.isInstancedBufferAttribute=!0,e}}const Wr=new Rt,Kd=new Rt,Qa=[],Jd=new Os,uM=new Rt,Oo=new be,ko=new xr;class fM extends be{constructor(e,t,i){super(e,t),this.isInstancedMesh=!0,this.instanceMatrix=new Zd(new Float32Array(i*16),16),this.instanceColor=null,this.morphTexture=null,this.count=i,this.boundingBox=null,this.boundingSphere=null;for(let s=0;s<i;s++)this.setMatrixAt(s,uM)}computeBoundingBox(){const e=this.geometry,t=this.count;this.boundingBox===null&&(this.boundingBox=new Os),e.boundingBox===null&&e.computeBoundingBox(),this.boundingBox.makeEmpty();for(let i=0;i<t;i++)this.getMatrixAt(i,Wr),Jd.copy(e.boundingBox).applyMatrix4(Wr),this.boundingBox.union(Jd)}computeBoundingSphere(){const e=this.geometry,t=this.count;this.boundingSphere===null&&(this.boundingSphere=new xr),e.boundingSphere===null&&e.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let i=0;i<t;i++)this.getMatrixAt(i,Wr),ko.copy(e.boundingSphere).applyMatrix4(Wr),this.boundingSphere.union(ko)}copy(e,t){return super.copy(e,t),this.instanceMatrix.copy(e.instanceMatrix),e.morphTexture!==null&&(this.morphTexture=e.morphTexture.clone()),e.instanceColor!==null&&(this.instanceColor=e.instanceColor.clone()),this.count=e.count,e.boundingBox!==null&&(this.boundingBox=e.boundingBox.clone()),e.boundingSphere!==null&&(this.boundingSphere=e.boundingSphere.clone()),this}getColorAt(e,t){t.fromArray(this.instanceColor.array,e*3)}getMatrixAt(e,t){t.fromArray(this.instanceMatrix.array,e*16)}getMorphAt(e,t){const i=t.morphTargetInfluences,s=this.morphTexture.source.data.data,r=i.length+1,o=e*r+1;for(let a=0;a<i.length;a++)i[a]=s[o+a]}raycast(e,t){const i=this.matrixWorld,s=this.count;if(Oo.geometry=this.geometry,Oo.material=this.material,Oo.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),ko.copy(this.boundingSphere),ko.applyMatrix4(i),e.ray.intersectsSphere(ko)!==!1))for(let r=0;r<s;r++){this.getMatrixAt(r,Wr),Kd.multiplyMatrices(i,Wr),Oo.matrixWorld=Kd,Oo.raycast(e,Qa);for(let o=0,a=Qa.length;o<a;o++){const l=Qa[o];l.instanceId=r,l.object=this,t.push(l)}Qa.length=0}}setColorAt(e,t){this.instanceColor===null&&(this.instanceColor=new Zd(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),t.toArray(this.instanceColor.array,e*3)}setMatrixAt(e,t){t.toArray(this.instanceMatrix.array,e*16)}setMorphAt(e,t){const i=t.morphTargetInfluences,s=i.length+1;this.morphTexture===null&&(this.morphTexture=new hM(new Float32Array(s*this.count),s,this.count,$u,Wi));const r=this.morphTexture.source.data.data;let o=0;for(let c=0;c<i.length;c++)o+=i[c];const a=this.geometry.morphTargetsRelative?1:1-o,l=s*e;r[l]=a,r.set(i,l+1)}updateMorphTargets(){}dispose(){this.dispatchEvent({type:"dispose"}),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}}const jc=new k,dM=new k,pM=new rt;class Cs{constructor(e=new k(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,i,s){return this.normal.set(e,t,i),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,i){const s=jc.subVectors(i,t).cross(dM.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){const e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t){const i=e.delta(jc),s=this.normal.dot(i);if(s===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;const r=-(e.start.dot(this.normal)+this.constant)/s;return r<0||r>1?null:t.copy(e.start).addScaledVector(i,r)}intersectsLine(e){const t=this.distanceToPoint(e.start),i=this.distanceToPoint(e.end);return t<0&&i>0||i<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){const i=t||pM.getNormalMatrix(e),s=this.coplanarPoint(jc).applyMatrix4(e),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}}const $s=new xr,mM=new Ke(.5,.5),el=new k;class tf{constructor(e=new Cs,t=new Cs,i=new Cs,s=new Cs,r=new Cs,o=new Cs){this.planes=[e,t,i,s,r,o]}set(e,t,i,s,r,o){const a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){const t=this.planes;for(let i=0;i<6;i++)t[i].copy(e.planes[i]);return this}setFromProjectionMatrix(e,t=Xi,i=!1){const s=this.planes,r=e.elements,o=r[0],a=r[1],l=r[2],c=r[3],h=r[4],f=r[5],d=r[6],u=r[7],_=r[8],v=r[9],m=r[10],p=r[11],y=r[12],w=r[13],x=r[14],L=r[15];if(s[0].setComponents(c-o,u-h,p-_,L-y).normalize(),s[1].setComponents(c+o,u+h,p+_,L+y).normalize(),s[2].setComponents(c+a,u+f,p+v,L+w).normalize(),s[3].setComponents(c-a,u-f,p-v,L-w).normalize(),i)s[4].setComponents(l,d,m,x).normalize(),s[5].setComponents(c-l,u-d,p-m,L-x).normalize();else if(s[4].setComponents(c-l,u-d,p-m,L-x).normalize(),t===Xi)s[5].setComponents(c+l,u+d,p+m,L+x).normalize();else if(t===kl)s[5].setComponents(l,d,m,x).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),$s.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{const t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),$s.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere($s)}intersectsSprite(e){$s.center.set(0,0,0);const t=mM.distanceTo(e.center);return $s.radius=.7071067811865476+t,$s.applyMatrix4(e.matrixWorld),this.intersectsSphere($s)}intersectsSphere(e){const t=this.planes,i=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(e){const t=this.planes;for(let i=0;i<6;i++){const s=t[i];if(el.x=s.normal.x>0?e.max.x:e.min.x,el.y=s.normal.y>0?e.max.y:e.min.y,el.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(el)<0)return!1}return!0}containsPoint(e){const t=this.planes;for(let i=0;i<6;i++)if(t[i].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}}class to extends ks{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new Je(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}}const zl=new k,Hl=new k,Qd=new Rt,Bo=new nc,tl=new xr,Zc=new k,ep=new k;class di extends tn{constructor(e=new nn,t=new to){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){const e=this.geometry;if(e.index===null){const t=e.attributes.position,i=[0];for(let s=1,r=t.count;s<r;s++)zl.fromBufferAttribute(t,s-1),Hl.fromBufferAttribute(t,s),i[s]=i[s-1],i[s]+=zl.distanceTo(Hl);e.setAttribute("lineDistance",new qt(i,1))}else console.warn("THREE.Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}raycast(e,t){const i=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),tl.copy(i.boundingSphere),tl.applyMatrix4(s),tl.radius+=r,e.ray.intersectsSphere(tl)===!1)return;Qd.copy(s).invert(),Bo.copy(e.ray).applyMatrix4(Qd);const a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,h=i.index,d=i.attributes.position;if(h!==null){const u=Math.max(0,o.start),_=Math.min(h.count,o.start+o.count);for(let v=u,m=_-1;v<m;v+=c){const p=h.getX(v),y=h.getX(v+1),w=nl(this,e,Bo,l,p,y,v);w&&t.push(w)}if(this.isLineLoop){const v=h.getX(_-1),m=h.getX(u),p=nl(this,e,Bo,l,v,m,_-1);p&&t.push(p)}}else{const u=Math.max(0,o.start),_=Math.min(d.count,o.start+o.count);for(let v=u,m=_-1;v<m;v+=c){const p=nl(this,e,Bo,l,v,v+1,v);p&&t.push(p)}if(this.isLineLoop){const v=nl(this,e,Bo,l,_-1,u,_-1);v&&t.push(v)}}}updateMorphTargets(){const t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){const s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){const a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}}function nl(n,e,t,i,s,r,o){const a=n.geometry.attributes.position;if(zl.fromBufferAttribute(a,s),Hl.fromBufferAttribute(a,r),t.distanceSqToSegment(zl,Hl,Zc,ep)>i)return;Zc.applyMatrix4(n.matrixWorld);const c=e.ray.origin.distanceTo(Zc);if(!(c<e.near||c>e.far))return{distance:c,point:ep.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}const tp=new k,np=new k;class _M extends di{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){const e=this.geometry;if(e.index===null){const t=e.attributes.position,i=[];for(let s=0,r=t.count;s<r;s+=2)tp.fromBufferAttribute(t,s),np.fromBufferAttribute(t,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+tp.distanceTo(np);e.setAttribute("lineDistance",new qt(i,1))}else console.warn("THREE.LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}}class gM extends di{constructor(e,t){super(e,t),this.isLineLoop=!0,this.type="LineLoop"}}class I_ extends Yn{constructor(e,t,i=pr,s,r,o,a=oi,l=oi,c,h=va,f=1){if(h!==va&&h!==xa)throw new Error("DepthTexture format must be either THREE.DepthFormat or THREE.DepthStencilFormat");const d={width:e,height:t,depth:f};super(d,s,r,o,a,l,h,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new Qu(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){const t=super.toJSON(e);return this.compareFunction!==null&&(t.compareFunction=this.compareFunction),t}}class U_ extends Yn{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}}class Un extends nn{constructor(e=1,t=1,i=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:e,radiusBottom:t,height:i,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};const c=this;s=Math.floor(s),r=Math.floor(r);const h=[],f=[],d=[],u=[];let _=0;const v=[],m=i/2;let p=0;y(),o===!1&&(e>0&&w(!0),t>0&&w(!1)),this.setIndex(h),this.setAttribute("position",new qt(f,3)),this.setAttribute("normal",new qt(d,3)),this.setAttribute("uv",new qt(u,2));function y(){const x=new k,L=new k;let A=0;const U=(t-e)/i;for(let N=0;N<=r;N++){const b=[],E=N/r,C=E*(t-e)+e;for(let B=0;B<=s;B++){const z=B/s,Y=z*l+a,W=Math.sin(Y),j=Math.cos(Y);L.x=C*W,L.y=-E*i+m,L.z=C*j,f.push(L.x,L.y,L.z),x.set(W,U,j).normalize(),d.push(x.x,x.y,x.z),u.push(z,1-E),b.push(_++)}v.push(b)}for(let N=0;N<s;N++)for(let b=0;b<r;b++){const E=v[b][N],C=v[b+1][N],B=v[b+1][N+1],z=v[b][N+1];(e>0||b!==0)&&(h.push(E,C,z),A+=3),(t>0||b!==r-1)&&(h.push(C,B,z),A+=3)}c.addGroup(p,A,0),p+=A}function w(x){const L=_,A=new Ke,U=new k;let N=0;const b=x===!0?e:t,E=x===!0?1:-1;for(let B=1;B<=s;B++)f.push(0,m*E,0),d.push(0,E,0),u.push(.5,.5),_++;const C=_;for(let B=0;B<=s;B++){const Y=B/s*l+a,W=Math.cos(Y),j=Math.sin(Y);U.x=b*j,U.y=m*E,U.z=b*W,f.push(U.x,U.y,U.z),d.push(0,E,0),A.x=W*.5+.5,A.y=j*.5*E+.5,u.push(A.x,A.y),_++}for(let B=0;B<s;B++){const z=L+B,Y=C+B;x===!0?h.push(Y,Y+1,z):h.push(Y+1,Y,z),N+=3}c.addGroup(p,N,x===!0?1:2),p+=N}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new Un(e.radiusTop,e.radiusBottom,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}}class nf extends nn{constructor(e=[],t=[],i=1,s=0){super(),this.type="PolyhedronGeometry",this.parameters={vertices:e,indices:t,radius:i,detail:s};const r=[],o=[];a(s),c(i),h(),this.setAttribute("position",new qt(r,3)),this.setAttribute("normal",new qt(r.slice(),3)),this.setAttribute("uv",new qt(o,2)),s===0?this.computeVertexNormals():this.normalizeNormals();function a(y){const w=new k,x=new k,L=new k;for(let A=0;A<t.length;A+=3)u(t[A+0],w),u(t[A+1],x),u(t[A+2],L),l(w,x,L,y)}function l(y,w,x,L){const A=L+1,U=[];for(let N=0;N<=A;N++){U[N]=[];const b=y.clone().lerp(x,N/A),E=w.clone().lerp(x,N/A),C=A-N;for(let B=0;B<=C;B++)B===0&&N===A?U[N][B]=b:U[N][B]=b.clone().lerp(E,B/C)}for(let N=0;N<A;N++)for(let b=0;b<2*(A-N)-1;b++){const E=Math.floor(b/2);b%2===0?(d(U[N][E+1]),d(U[N+1][E]),d(U[N][E])):(d(U[N][E+1]),d(U[N+1][E+1]),d(U[N+1][E]))}}function c(y){const w=new k;for(let x=0;x<r.length;x+=3)w.x=r[x+0],w.y=r[x+1],w.z=r[x+2],w.normalize().multiplyScalar(y),r[x+0]=w.x,r[x+1]=w.y,r[x+2]=w.z}function h(){const y=new k;for(let w=0;w<r.length;w+=3){y.x=r[w+0],y.y=r[w+1],y.z=r[w+2];const x=m(y)/2/Math.PI+.5,L=p(y)/Math.PI+.5;o.push(x,1-L)}_(),f()}function f(){for(let y=0;y<o.length;y+=6){const w=o[y+0],x=o[y+2],L=o[y+4],A=Math.max(w,x,L),U=Math.min(w,x,L);A>.9&&U<.1&&(w<.2&&(o[y+0]+=1),x<.2&&(o[y+2]+=1),L<.2&&(o[y+4]+=1))}}function d(y){r.push(y.x,y.y,y.z)}function u(y,w){const x=y*3;w.x=e[x+0],w.y=e[x+1],w.z=e[x+2]}function _(){const y=new k,w=new k,x=new k,L=new k,A=new Ke,U=new Ke,N=new Ke;for(let b=0,E=0;b<r.length;b+=9,E+=6){y.set(r[b+0],r[b+1],r[b+2]),w.set(r[b+3],r[b+4],r[b+5]),x.set(r[b+6],r[b+7],r[b+8]),A.set(o[E+0],o[E+1]),U.set(o[E+2],o[E+3]),N.set(o[E+4],o[E+5]),L.copy(y).add(w).add(x).divideScalar(3);const C=m(L);v(A,E+0,y,C),v(U,E+2,w,C),v(N,E+4,x,C)}}function v(y,w,x,L){L<0&&y.x===1&&(o[w]=y.x-1),x.x===0&&x.z===0&&(o[w]=L/2/Math.PI+.5)}function m(y){return Math.atan2(y.z,-y.x)}function p(y){return Math.atan2(-y.y,Math.sqrt(y.x*y.x+y.z*y.z))}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new nf(e.vertices,e.indices,e.radius,e.details)}}class $r extends nf{constructor(e=1,t=0){const i=[1,0,0,-1,0,0,0,1,0,0,-1,0,0,0,1,0,0,-1],s=[0,2,4,0,4,3,0,3,5,0,5,2,1,2,5,1,5,3,1,3,4,1,4,2];super(i,s,e,t),this.type="OctahedronGeometry",this.parameters={radius:e,detail:t}}static fromJSON(e){return new $r(e.radius,e.detail)}}class Is extends nn{constructor(e=1,t=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:i,heightSegments:s};const r=e/2,o=t/2,a=Math.floor(i),l=Math.floor(s),c=a+1,h=l+1,f=e/a,d=t/l,u=[],_=[],v=[],m=[];for(let p=0;p<h;p++){const y=p*d-o;for(let w=0;w<c;w++){const x=w*f-r;_.push(x,-y,0),v.push(0,0,1),m.push(w/a),m.push(1-p/l)}}for(let p=0;p<l;p++)for(let y=0;y<a;y++){const w=y+c*p,x=y+c*(p+1),L=y+1+c*(p+1),A=y+1+c*p;u.push(w,x,A),u.push(x,L,A)}this.setIndex(u),this.setAttribute("position",new qt(_,3)),this.setAttribute("normal",new qt(v,3)),this.setAttribute("uv",new qt(m,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new Is(e.width,e.height,e.widthSegments,e.heightSegments)}}class sf extends nn{constructor(e=1,t=32,i=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:e,widthSegments:t,heightSegments:i,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},t=Math.max(3,Math.floor(t)),i=Math.max(2,Math.floor(i));const l=Math.min(o+a,Math.PI);let c=0;const h=[],f=new k,d=new k,u=[],_=[],v=[],m=[];for(let p=0;p<=i;p++){const y=[],w=p/i;let x=0;p===0&&o===0?x=.5/t:p===i&&l===Math.PI&&(x=-.5/t);for(let L=0;L<=t;L++){const A=L/t;f.x=-e*Math.cos(s+A*r)*Math.sin(o+w*a),f.y=e*Math.cos(o+w*a),f.z=e*Math.sin(s+A*r)*Math.sin(o+w*a),_.push(f.x,f.y,f.z),d.copy(f).normalize(),v.push(d.x,d.y,d.z),m.push(A+x,1-w),y.push(c++)}h.push(y)}for(let p=0;p<i;p++)for(let y=0;y<t;y++){const w=h[p][y+1],x=h[p][y],L=h[p+1][y],A=h[p+1][y+1];(p!==0||o>0)&&u.push(w,x,A),(p!==i-1||l<Math.PI)&&u.push(x,L,A)}this.setIndex(u),this.setAttribute("position",new qt(_,3)),this.setAttribute("normal",new qt(v,3)),this.setAttribute("uv",new qt(m,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new sf(e.radius,e.widthSegments,e.heightSegments,e.phiStart,e.phiLength,e.thetaStart,e.thetaLength)}}class rr extends nn{constructor(e=1,t=.4,i=12,s=48,r=Math.PI*2){super(),this.type="TorusGeometry",this.parameters={radius:e,tube:t,radialSegments:i,tubularSegments:s,arc:r},i=Math.floor(i),s=Math.floor(s);const o=[],a=[],l=[],c=[],h=new k,f=new k,d=new k;for(let u=0;u<=i;u++)for(let _=0;_<=s;_++){const v=_/s*r,m=u/i*Math.PI*2;f.x=(e+t*Math.cos(m))*Math.cos(v),f.y=(e+t*Math.cos(m))*Math.sin(v),f.z=t*Math.sin(m),a.push(f.x,f.y,f.z),h.x=e*Math.cos(v),h.y=e*Math.sin(v),d.subVectors(f,h).normalize(),l.push(d.x,d.y,d.z),c.push(_/s),c.push(u/i)}for(let u=1;u<=i;u++)for(let _=1;_<=s;_++){const v=(s+1)*u+_-1,m=(s+1)*(u-1)+_-1,p=(s+1)*(u-1)+_,y=(s+1)*u+_;o.push(v,m,y),o.push(m,p,y)}this.setIndex(o),this.setAttribute("position",new qt(a,3)),this.setAttribute("normal",new qt(l,3)),this.setAttribute("uv",new qt(c,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new rr(e.radius,e.tube,e.radialSegments,e.tubularSegments,e.arc)}}class vM extends ks{constructor(e){super(),this.isShadowMaterial=!0,this.type="ShadowMaterial",this.color=new Je(0),this.transparent=!0,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.fog=e.fog,this}}class xM extends ks{constructor(e){super(),this.isMeshStandardMaterial=!0,this.type="MeshStandardMaterial",this.defines={STANDARD:""},this.color=new Je(16777215),this.roughness=1,this.metalness=0,this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new Je(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Ju,this.normalScale=new Ke(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.roughnessMap=null,this.metalnessMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Mi,this.envMapIntensity=1,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.defines={STANDARD:""},this.color.copy(e.color),this.roughness=e.roughness,this.metalness=e.metalness,this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.roughnessMap=e.roughnessMap,this.metalnessMap=e.metalnessMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.envMapIntensity=e.envMapIntensity,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}}class MM extends ks{constructor(e){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new Je(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new Je(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Ju,this.normalScale=new Ke(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Mi,this.combine=Wu,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}}class yM extends ks{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=bx,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}}class SM extends ks{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}}class N_ extends tn{constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new Je(e),this.intensity=t}dispose(){}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){const t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,this.groundColor!==void 0&&(t.object.groundColor=this.groundColor.getHex()),this.distance!==void 0&&(t.object.distance=this.distance),this.angle!==void 0&&(t.object.angle=this.angle),this.decay!==void 0&&(t.object.decay=this.decay),this.penumbra!==void 0&&(t.object.penumbra=this.penumbra),this.shadow!==void 0&&(t.object.shadow=this.shadow.toJSON()),this.target!==void 0&&(t.object.target=this.target.uuid),t}}class EM extends N_{constructor(e,t,i){super(e,i),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(tn.DEFAULT_UP),this.updateMatrix(),this.groundColor=new Je(t)}copy(e,t){return super.copy(e,t),this.groundColor.copy(e.groundColor),this}}const Kc=new Rt,ip=new k,sp=new k;class bM{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Ke(512,512),this.mapType=qi,this.map=null,this.mapPass=null,this.matrix=new Rt,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new tf,this._frameExtents=new Ke(1,1),this._viewportCount=1,this._viewports=[new en(0,0,1,1)]}getViewportCount(){return this._viewportCount}getFrustum(){return this._frustum}updateMatrices(e){const t=this.camera,i=this.matrix;ip.setFromMatrixPosition(e.matrixWorld),t.position.copy(ip),sp.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(sp),t.updateMatrixWorld(),Kc.multiplyMatrices(t.projectionMatrix,t.matrixWorldInverse),this._frustum.setFromProjectionMatrix(Kc,t.coordinateSystem,t.reversedDepth),t.reversedDepth?i.set(.5,0,0,.5,0,.5,0,.5,0,0,1,0,0,0,0,1):i.set(.5,0,0,.5,0,.5,0,.5,0,0,.5,.5,0,0,0,1),i.multiply(Kc)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this}clone(){return new this.constructor().copy(this)}toJSON(){const e={};return this.intensity!==1&&(e.intensity=this.intensity),this.bias!==0&&(e.bias=this.bias),this.normalBias!==0&&(e.normalBias=this.normalBias),this.radius!==1&&(e.radius=this.radius),(this.mapSize.x!==512||this.mapSize.y!==512)&&(e.mapSize=this.mapSize.toArray()),e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}}class rf extends D_{constructor(e=-1,t=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){const e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2;let r=i-e,o=i+e,a=s+t,l=s-t;if(this.view!==null&&this.view.enabled){const c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=h*this.view.offsetY,l=a-h*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){const t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}}class wM extends bM{constructor(){super(new rf(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}}class rp extends N_{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(tn.DEFAULT_UP),this.updateMatrix(),this.target=new tn,this.shadow=new wM}dispose(){this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}}class TM extends _i{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e}}const op=new Rt;class F_{constructor(e,t,i=0,s=1/0){this.ray=new nc(e,t),this.near=i,this.far=s,this.camera=null,this.layers=new ef,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(e,t){this.ray.set(e,t)}setFromCamera(e,t){t.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(e.x,e.y,.5).unproject(t).sub(this.ray.origin).normalize(),this.camera=t):t.isOrthographicCamera?(this.ray.origin.set(e.x,e.y,(t.near+t.far)/(t.near-t.far)).unproject(t),this.ray.direction.set(0,0,-1).transformDirection(t.matrixWorld),this.camera=t):console.error("THREE.Raycaster: Unsupported camera type: "+t.type)}setFromXRController(e){return op.identity().extractRotation(e.matrixWorld),this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(op),this}intersectObject(e,t=!0,i=[]){return mu(e,this,i,t),i.sort(ap),i}intersectObjects(e,t=!0,i=[]){for(let s=0,r=e.length;s<r;s++)mu(e[s],this,i,t);return i.sort(ap),i}}function ap(n,e){return n.distance-e.distance}function mu(n,e,t,i){let s=!0;if(n.layers.test(e.layers)&&n.raycast(e,t)===!1&&(s=!1),s===!0&&i===!0){const r=n.children;for(let o=0,a=r.length;o<a;o++)mu(r[o],e,t,!0)}}class lp{constructor(e=1,t=0,i=0){this.radius=e,this.phi=t,this.theta=i}set(e,t,i){return this.radius=e,this.phi=t,this.theta=i,this}copy(e){return this.radius=e.radius,this.phi=e.phi,this.theta=e.theta,this}makeSafe(){return this.phi=ft(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(e){return this.setFromCartesianCoords(e.x,e.y,e.z)}setFromCartesianCoords(e,t,i){return this.radius=Math.sqrt(e*e+t*t+i*i),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(e,i),this.phi=Math.acos(ft(t/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}}class O_ extends _M{constructor(e=1){const t=[0,0,0,e,0,0,0,0,0,0,e,0,0,0,0,0,0,e],i=[1,0,0,1,.6,0,0,1,0,.6,1,0,0,0,1,0,.6,1],s=new nn;s.setAttribute("position",new qt(t,3)),s.setAttribute("color",new qt(i,3));const r=new to({vertexColors:!0,toneMapped:!1});super(s,r),this.type="AxesHelper"}setColors(e,t,i){const s=new Je,r=this.geometry.attributes.color.array;return s.set(e),s.toArray(r,0),s.toArray(r,3),s.set(t),s.toArray(r,6),s.toArray(r,9),s.set(i),s.toArray(r,12),s.toArray(r,15),this.geometry.attributes.color.needsUpdate=!0,this}dispose(){this.geometry.dispose(),this.material.dispose()}}class k_ extends vr{constructor(e,t=null){super(),this.object=e,this.domElement=t,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(e){if(e===void 0){console.warn("THREE.Controls: connect() now requires an element.");return}this.domElement!==null&&this.disconnect(),this.domElement=e}disconnect(){}dispose(){}update(){}}function cp(n,e,t,i){const s=AM(i);switch(t){case y_:return n*e;case $u:return n*e/s.components*s.byteLength;case ju:return n*e/s.components*s.byteLength;case E_:return n*e*2/s.components*s.byteLength;case Zu:return n*e*2/s.components*s.byteLength;case S_:return n*e*3/s.components*s.byteLength;case Di:return n*e*4/s.components*s.byteLength;case Ku:return n*e*4/s.components*s.byteLength;case gl:case vl:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case xl:case Ml:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Hh:case Gh:return Math.max(n,16)*Math.max(e,8)/4;case zh:case Vh:return Math.max(n,8)*Math.max(e,8)/2;case Wh:case Xh:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case Yh:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case qh:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case $h:return Math.floor((n+4)/5)*Math.floor((e+3)/4)*16;case jh:return Math.floor((n+4)/5)*Math.floor((e+4)/5)*16;case Zh:return Math.floor((n+5)/6)*Math.floor((e+4)/5)*16;case Kh:return Math.floor((n+5)/6)*Math.floor((e+5)/6)*16;case Jh:return Math.floor((n+7)/8)*Math.floor((e+4)/5)*16;case Qh:return Math.floor((n+7)/8)*Math.floor((e+5)/6)*16;case eu:return Math.floor((n+7)/8)*Math.floor((e+7)/8)*16;case tu:return Math.floor((n+9)/10)*Math.floor((e+4)/5)*16;case nu:return Math.floor((n+9)/10)*Math.floor((e+5)/6)*16;case iu:return Math.floor((n+9)/10)*Math.floor((e+7)/8)*16;case su:return Math.floor((n+9)/10)*Math.floor((e+9)/10)*16;case ru:return Math.floor((n+11)/12)*Math.floor((e+9)/10)*16;case ou:return Math.floor((n+11)/12)*Math.floor((e+11)/12)*16;case au:case lu:case cu:return Math.ceil(n/4)*Math.ceil(e/4)*16;case hu:case uu:return Math.ceil(n/4)*Math.ceil(e/4)*8;case fu:case du:return Math.ceil(n/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function AM(n){switch(n){case qi:case g_:return{byteLength:1,components:1};case _a:case v_:case Sa:return{byteLength:2,components:1};case Yu:case qu:return{byteLength:2,components:4};case pr:case Xu:case Wi:return{byteLength:4,components:1};case x_:case M_:return{byteLength:4,components:3}}throw new Error(`Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:Gu}}));typeof window<"u"&&(window.__THREE__?console.warn("WARNING: Multiple instances of Three.js being imported."):window.__THREE__=Gu);function B_(){let n=null,e=!1,t=null,i=null;function s(r,o){t(r,o),i=n.requestAnimationFrame(s)}return{start:function(){e!==!0&&t!==null&&(i=n.requestAnimationFrame(s),e=!0)},stop:function(){n.cancelAnimationFrame(i),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){n=r}}}function RM(n){const e=new WeakMap;function t(a,l){const c=a.array,h=a.usage,f=c.byteLength,d=n.createBuffer();n.bindBuffer(l,d),n.bufferData(l,c,h),a.onUploadCallback();let u;if(c instanceof Float32Array)u=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)u=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?u=n.HALF_FLOAT:u=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)u=n.SHORT;else if(c instanceof Uint32Array)u=n.UNSIGNED_INT;else if(c instanceof Int32Array)u=n.INT;else if(c instanceof Int8Array)u=n.BYTE;else if(c instanceof Uint8Array)u=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)u=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:d,type:u,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:f}}function i(a,l,c){const h=l.array,f=l.updateRanges;if(n.bindBuffer(c,a),f.length===0)n.bufferSubData(c,0,h);else{f.sort((u,_)=>u.start-_.start);let d=0;for(let u=1;u<f.length;u++){const _=f[d],v=f[u];v.start<=_.start+_.count+1?_.count=Math.max(_.count,v.start+v.count-_.start):(++d,f[d]=v)}f.length=d+1;for(let u=0,_=f.length;u<_;u++){const v=f[u];n.bufferSubData(c,v.start*h.BYTES_PER_ELEMENT,h,v.start,v.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);const l=e.get(a);l&&(n.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){const h=e.get(a);(!h||h.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}const c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var CM=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,PM=`#ifdef USE_ALPHAHASH
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
#endif`,DM=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,LM=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,IM=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,UM=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,NM=`#ifdef USE_AOMAP
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
#endif`,FM=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,OM=`#ifdef USE_BATCHING
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
#endif`,kM=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,BM=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,zM=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,HM=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,VM=`#ifdef USE_IRIDESCENCE
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
#endif`,GM=`#ifdef USE_BUMPMAP
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
#endif`,WM=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,XM=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,YM=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,qM=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,$M=`#if defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#elif defined( USE_COLOR )
	diffuseColor.rgb *= vColor;
#endif`,jM=`#if defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#elif defined( USE_COLOR )
	varying vec3 vColor;
#endif`,ZM=`#if defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#elif defined( USE_COLOR ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec3 vColor;
#endif`,KM=`#if defined( USE_COLOR_ALPHA )
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
#endif`,JM=`#define PI 3.141592653589793
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
} // validated`,QM=`#ifdef ENVMAP_TYPE_CUBE_UV
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
#endif`,ey=`vec3 transformedNormal = objectNormal;
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
#endif`,ty=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,ny=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,iy=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,sy=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,ry="gl_FragColor = linearToOutputTexel( gl_FragColor );",oy=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,ay=`#ifdef USE_ENVMAP
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
#endif`,ly=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform float flipEnvMap;
	uniform mat3 envMapRotation;
	#ifdef ENVMAP_TYPE_CUBE
		uniform samplerCube envMap;
	#else
		uniform sampler2D envMap;
	#endif
	
#endif`,cy=`#ifdef USE_ENVMAP
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
#endif`,hy=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,uy=`#ifdef USE_ENVMAP
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
#endif`,fy=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,dy=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,py=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,my=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,_y=`#ifdef USE_GRADIENTMAP
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
}`,gy=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,vy=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,xy=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,My=`uniform bool receiveShadow;
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
#endif`,yy=`#ifdef USE_ENVMAP
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
#endif`,Sy=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,Ey=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,by=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,wy=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,Ty=`PhysicalMaterial material;
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
#endif`,Ay=`struct PhysicalMaterial {
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
}`,Ry=`
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
#endif`,Cy=`#if defined( RE_IndirectDiffuse )
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
#endif`,Py=`#if defined( RE_IndirectDiffuse )
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,Dy=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,Ly=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Iy=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Uy=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,Ny=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,Fy=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,Oy=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,ky=`#if defined( USE_POINTS_UV )
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
#endif`,By=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,zy=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,Hy=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,Vy=`#if defined( USE_MORPHCOLORS )
	vColor *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,Gy=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Wy=`#ifdef USE_MORPHTARGETS
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
#endif`,Xy=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Yy=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,qy=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,$y=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,jy=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Zy=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
	#endif
#endif`,Ky=`#ifdef USE_NORMALMAP
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
#endif`,Jy=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,Qy=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,eS=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,tS=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,nS=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,iS=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,sS=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,rS=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,oS=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,aS=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,lS=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,cS=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,hS=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,uS=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,fS=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,dS=`float getShadowMask() {
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
}`,pS=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,mS=`#ifdef USE_SKINNING
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
#endif`,_S=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,gS=`#ifdef USE_SKINNING
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
#endif`,vS=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,xS=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,MS=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,yS=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,SS=`#ifdef USE_TRANSMISSION
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
#endif`,ES=`#ifdef USE_TRANSMISSION
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
#endif`,bS=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,wS=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,TS=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,AS=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`;const RS=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,CS=`uniform sampler2D t2D;
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
}`,PS=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,DS=`#ifdef ENVMAP_TYPE_CUBE
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
}`,LS=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,IS=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,US=`#include <common>
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
}`,NS=`#if DEPTH_PACKING == 3200
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
}`,FS=`#define DISTANCE
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
}`,OS=`#define DISTANCE
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
}`,kS=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,BS=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,zS=`uniform float scale;
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
}`,HS=`uniform vec3 diffuse;
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
}`,VS=`#include <common>
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
}`,GS=`uniform vec3 diffuse;
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
}`,WS=`#define LAMBERT
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
}`,XS=`#define LAMBERT
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
}`,YS=`#define MATCAP
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
}`,qS=`#define MATCAP
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
}`,$S=`#define NORMAL
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
}`,jS=`#define NORMAL
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
}`,ZS=`#define PHONG
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
}`,KS=`#define PHONG
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
}`,JS=`#define STANDARD
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
}`,QS=`#define STANDARD
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
}`,eE=`#define TOON
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
}`,tE=`#define TOON
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
}`,nE=`uniform float size;
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
}`,iE=`uniform vec3 diffuse;
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
}`,sE=`#include <common>
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
}`,rE=`uniform vec3 color;
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
}`,oE=`uniform float rotation;
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
}`,aE=`uniform vec3 diffuse;
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
}`,at={alphahash_fragment:CM,alphahash_pars_fragment:PM,alphamap_fragment:DM,alphamap_pars_fragment:LM,alphatest_fragment:IM,alphatest_pars_fragment:UM,aomap_fragment:NM,aomap_pars_fragment:FM,batching_pars_vertex:OM,batching_vertex:kM,begin_vertex:BM,beginnormal_vertex:zM,bsdfs:HM,iridescence_fragment:VM,bumpmap_pars_fragment:GM,clipping_planes_fragment:WM,clipping_planes_pars_fragment:XM,clipping_planes_pars_vertex:YM,clipping_planes_vertex:qM,color_fragment:$M,color_pars_fragment:jM,color_pars_vertex:ZM,color_vertex:KM,common:JM,cube_uv_reflection_fragment:QM,defaultnormal_vertex:ey,displacementmap_pars_vertex:ty,displacementmap_vertex:ny,emissivemap_fragment:iy,emissivemap_pars_fragment:sy,colorspace_fragment:ry,colorspace_pars_fragment:oy,envmap_fragment:ay,envmap_common_pars_fragment:ly,envmap_pars_fragment:cy,envmap_pars_vertex:hy,envmap_physical_pars_fragment:yy,envmap_vertex:uy,fog_vertex:fy,fog_pars_vertex:dy,fog_fragment:py,fog_pars_fragment:my,gradientmap_pars_fragment:_y,lightmap_pars_fragment:gy,lights_lambert_fragment:vy,lights_lambert_pars_fragment:xy,lights_pars_begin:My,lights_toon_fragment:Sy,lights_toon_pars_fragment:Ey,lights_phong_fragment:by,lights_phong_pars_fragment:wy,lights_physical_fragment:Ty,lights_physical_pars_fragment:Ay,lights_fragment_begin:Ry,lights_fragment_maps:Cy,lights_fragment_end:Py,logdepthbuf_fragment:Dy,logdepthbuf_pars_fragment:Ly,logdepthbuf_pars_vertex:Iy,logdepthbuf_vertex:Uy,map_fragment:Ny,map_pars_fragment:Fy,map_particle_fragment:Oy,map_particle_pars_fragment:ky,metalnessmap_fragment:By,metalnessmap_pars_fragment:zy,morphinstance_vertex:Hy,morphcolor_vertex:Vy,morphnormal_vertex:Gy,morphtarget_pars_vertex:Wy,morphtarget_vertex:Xy,normal_fragment_begin:Yy,normal_fragment_maps:qy,normal_pars_fragment:$y,normal_pars_vertex:jy,normal_vertex:Zy,normalmap_pars_fragment:Ky,clearcoat_normal_fragment_begin:Jy,clearcoat_normal_fragment_maps:Qy,clearcoat_pars_fragment:eS,iridescence_pars_fragment:tS,opaque_fragment:nS,packing:iS,premultiplied_alpha_fragment:sS,project_vertex:rS,dithering_fragment:oS,dithering_pars_fragment:aS,roughnessmap_fragment:lS,roughnessmap_pars_fragment:cS,shadowmap_pars_fragment:hS,shadowmap_pars_vertex:uS,shadowmap_vertex:fS,shadowmask_pars_fragment:dS,skinbase_vertex:pS,skinning_pars_vertex:mS,skinning_vertex:_S,skinnormal_vertex:gS,specularmap_fragment:vS,specularmap_pars_fragment:xS,tonemapping_fragment:MS,tonemapping_pars_fragment:yS,transmission_fragment:SS,transmission_pars_fragment:ES,uv_pars_fragment:bS,uv_pars_vertex:wS,uv_vertex:TS,worldpos_vertex:AS,background_vert:RS,background_frag:CS,backgroundCube_vert:PS,backgroundCube_frag:DS,cube_vert:LS,cube_frag:IS,depth_vert:US,depth_frag:NS,distanceRGBA_vert:FS,distanceRGBA_frag:OS,equirect_vert:kS,equirect_frag:BS,linedashed_vert:zS,linedashed_frag:HS,meshbasic_vert:VS,meshbasic_frag:GS,meshlambert_vert:WS,meshlambert_frag:XS,meshmatcap_vert:YS,meshmatcap_frag:qS,meshnormal_vert:$S,meshnormal_frag:jS,meshphong_vert:ZS,meshphong_frag:KS,meshphysical_vert:JS,meshphysical_frag:QS,meshtoon_vert:eE,meshtoon_frag:tE,points_vert:nE,points_frag:iE,shadow_vert:sE,shadow_frag:rE,sprite_vert:oE,sprite_frag:aE},Ee={common:{diffuse:{value:new Je(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new rt},alphaMap:{value:null},alphaMapTransform:{value:new rt},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new rt}},envmap:{envMap:{value:null},envMapRotation:{value:new rt},flipEnvMap:{value:-1},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new rt}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new rt}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new rt},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new rt},normalScale:{value:new Ke(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new rt},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new rt}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new rt}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new rt}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new Je(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMap:{value:[]},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotShadowMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMap:{value:[]},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null}},points:{diffuse:{value:new Je(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new rt},alphaTest:{value:0},uvTransform:{value:new rt}},sprite:{diffuse:{value:new Je(16777215)},opacity:{value:1},center:{value:new Ke(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new rt},alphaMap:{value:null},alphaMapTransform:{value:new rt},alphaTest:{value:0}}},zi={basic:{uniforms:Gn([Ee.common,Ee.specularmap,Ee.envmap,Ee.aomap,Ee.lightmap,Ee.fog]),vertexShader:at.meshbasic_vert,fragmentShader:at.meshbasic_frag},lambert:{uniforms:Gn([Ee.common,Ee.specularmap,Ee.envmap,Ee.aomap,Ee.lightmap,Ee.emissivemap,Ee.bumpmap,Ee.normalmap,Ee.displacementmap,Ee.fog,Ee.lights,{emissive:{value:new Je(0)}}]),vertexShader:at.meshlambert_vert,fragmentShader:at.meshlambert_frag},phong:{uniforms:Gn([Ee.common,Ee.specularmap,Ee.envmap,Ee.aomap,Ee.lightmap,Ee.emissivemap,Ee.bumpmap,Ee.normalmap,Ee.displacementmap,Ee.fog,Ee.lights,{emissive:{value:new Je(0)},specular:{value:new Je(1118481)},shininess:{value:30}}]),vertexShader:at.meshphong_vert,fragmentShader:at.meshphong_frag},standard:{uniforms:Gn([Ee.common,Ee.envmap,Ee.aomap,Ee.lightmap,Ee.emissivemap,Ee.bumpmap,Ee.normalmap,Ee.displacementmap,Ee.roughnessmap,Ee.metalnessmap,Ee.fog,Ee.lights,{emissive:{value:new Je(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:at.meshphysical_vert,fragmentShader:at.meshphysical_frag},toon:{uniforms:Gn([Ee.common,Ee.aomap,Ee.lightmap,Ee.emissivemap,Ee.bumpmap,Ee.normalmap,Ee.displacementmap,Ee.gradientmap,Ee.fog,Ee.lights,{emissive:{value:new Je(0)}}]),vertexShader:at.meshtoon_vert,fragmentShader:at.meshtoon_frag},matcap:{uniforms:Gn([Ee.common,Ee.bumpmap,Ee.normalmap,Ee.displacementmap,Ee.fog,{matcap:{value:null}}]),vertexShader:at.meshmatcap_vert,fragmentShader:at.meshmatcap_frag},points:{uniforms:Gn([Ee.points,Ee.fog]),vertexShader:at.points_vert,fragmentShader:at.points_frag},dashed:{uniforms:Gn([Ee.common,Ee.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:at.linedashed_vert,fragmentShader:at.linedashed_frag},depth:{uniforms:Gn([Ee.common,Ee.displacementmap]),vertexShader:at.depth_vert,fragmentShader:at.depth_frag},normal:{uniforms:Gn([Ee.common,Ee.bumpmap,Ee.normalmap,Ee.displacementmap,{opacity:{value:1}}]),vertexShader:at.meshnormal_vert,fragmentShader:at.meshnormal_frag},sprite:{uniforms:Gn([Ee.sprite,Ee.fog]),vertexShader:at.sprite_vert,fragmentShader:at.sprite_frag},background:{uniforms:{uvTransform:{value:new rt},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:at.background_vert,fragmentShader:at.background_frag},backgroundCube:{uniforms:{envMap:{value:null},flipEnvMap:{value:-1},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new rt}},vertexShader:at.backgroundCube_vert,fragmentShader:at.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:at.cube_vert,fragmentShader:at.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:at.equirect_vert,fragmentShader:at.equirect_frag},distanceRGBA:{uniforms:Gn([Ee.common,Ee.displacementmap,{referencePosition:{value:new k},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:at.distanceRGBA_vert,fragmentShader:at.distanceRGBA_frag},shadow:{uniforms:Gn([Ee.lights,Ee.fog,{color:{value:new Je(0)},opacity:{value:1}}]),vertexShader:at.shadow_vert,fragmentShader:at.shadow_frag}};zi.physical={uniforms:Gn([zi.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new rt},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new rt},clearcoatNormalScale:{value:new Ke(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new rt},dispersion:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new rt},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new rt},sheen:{value:0},sheenColor:{value:new Je(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new rt},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new rt},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new rt},transmissionSamplerSize:{value:new Ke},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new rt},attenuationDistance:{value:0},attenuationColor:{value:new Je(0)},specularColor:{value:new Je(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new rt},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new rt},anisotropyVector:{value:new Ke},anisotropyMap:{value:null},anisotropyMapTransform:{value:new rt}}]),vertexShader:at.meshphysical_vert,fragmentShader:at.meshphysical_frag};const il={r:0,b:0,g:0},js=new Mi,lE=new Rt;function cE(n,e,t,i,s,r,o){const a=new Je(0);let l=r===!0?0:1,c,h,f=null,d=0,u=null;function _(w){let x=w.isScene===!0?w.background:null;return x&&x.isTexture&&(x=(w.backgroundBlurriness>0?t:e).get(x)),x}function v(w){let x=!1;const L=_(w);L===null?p(a,l):L&&L.isColor&&(p(L,1),x=!0);const A=n.xr.getEnvironmentBlendMode();A==="additive"?i.buffers.color.setClear(0,0,0,1,o):A==="alpha-blend"&&i.buffers.color.setClear(0,0,0,0,o),(n.autoClear||x)&&(i.buffers.depth.setTest(!0),i.buffers.depth.setMask(!0),i.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function m(w,x){const L=_(x);L&&(L.isCubeTexture||L.mapping===tc)?(h===void 0&&(h=new be(new on(1,1,1),new hs({name:"BackgroundCubeMaterial",uniforms:fo(zi.backgroundCube.uniforms),vertexShader:zi.backgroundCube.vertexShader,fragmentShader:zi.backgroundCube.fragmentShader,side:Kn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),h.geometry.deleteAttribute("normal"),h.geometry.deleteAttribute("uv"),h.onBeforeRender=function(A,U,N){this.matrixWorld.copyPosition(N.matrixWorld)},Object.defineProperty(h.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),s.update(h)),js.copy(x.backgroundRotation),js.x*=-1,js.y*=-1,js.z*=-1,L.isCubeTexture&&L.isRenderTargetTexture===!1&&(js.y*=-1,js.z*=-1),h.material.uniforms.envMap.value=L,h.material.uniforms.flipEnvMap.value=L.isCubeTexture&&L.isRenderTargetTexture===!1?-1:1,h.material.uniforms.backgroundBlurriness.value=x.backgroundBlurriness,h.material.uniforms.backgroundIntensity.value=x.backgroundIntensity,h.material.uniforms.backgroundRotation.value.setFromMatrix4(lE.makeRotationFromEuler(js)),h.material.toneMapped=xt.getTransfer(L.colorSpace)!==Dt,(f!==L||d!==L.version||u!==n.toneMapping)&&(h.material.needsUpdate=!0,f=L,d=L.version,u=n.toneMapping),h.layers.enableAll(),w.unshift(h,h.geometry,h.material,0,0,null)):L&&L.isTexture&&(c===void 0&&(c=new be(new Is(2,2),new hs({name:"BackgroundMaterial",uniforms:fo(zi.background.uniforms),vertexShader:zi.background.vertexShader,fragmentShader:zi.background.fragmentShader,side:cs,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),Object.defineProperty(c.material,"map",{get:function(){return this.uniforms.t2D.value}}),s.update(c)),c.material.uniforms.t2D.value=L,c.material.uniforms.backgroundIntensity.value=x.backgroundIntensity,c.material.toneMapped=xt.getTransfer(L.colorSpace)!==Dt,L.matrixAutoUpdate===!0&&L.updateMatrix(),c.material.uniforms.uvTransform.value.copy(L.matrix),(f!==L||d!==L.version||u!==n.toneMapping)&&(c.material.needsUpdate=!0,f=L,d=L.version,u=n.toneMapping),c.layers.enableAll(),w.unshift(c,c.geometry,c.material,0,0,null))}function p(w,x){w.getRGB(il,P_(n)),i.buffers.color.setClear(il.r,il.g,il.b,x,o)}function y(){h!==void 0&&(h.geometry.dispose(),h.material.dispose(),h=void 0),c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0)}return{getClearColor:function(){return a},setClearColor:function(w,x=1){a.set(w),l=x,p(a,l)},getClearAlpha:function(){return l},setClearAlpha:function(w){l=w,p(a,l)},render:v,addToRenderList:m,dispose:y}}function hE(n,e){const t=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=d(null);let r=s,o=!1;function a(E,C,B,z,Y){let W=!1;const j=f(z,B,C);r!==j&&(r=j,c(r.object)),W=u(E,z,B,Y),W&&_(E,z,B,Y),Y!==null&&e.update(Y,n.ELEMENT_ARRAY_BUFFER),(W||o)&&(o=!1,x(E,C,B,z),Y!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,e.get(Y).buffer))}function l(){return n.createVertexArray()}function c(E){return n.bindVertexArray(E)}function h(E){return n.deleteVertexArray(E)}function f(E,C,B){const z=B.wireframe===!0;let Y=i[E.id];Y===void 0&&(Y={},i[E.id]=Y);let W=Y[C.id];W===void 0&&(W={},Y[C.id]=W);let j=W[z];return j===void 0&&(j=d(l()),W[z]=j),j}function d(E){const C=[],B=[],z=[];for(let Y=0;Y<t;Y++)C[Y]=0,B[Y]=0,z[Y]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:C,enabledAttributes:B,attributeDivisors:z,object:E,attributes:{},index:null}}function u(E,C,B,z){const Y=r.attributes,W=C.attributes;let j=0;const q=B.getAttributes();for(const K in q)if(q[K].location>=0){const ae=Y[K];let me=W[K];if(me===void 0&&(K==="instanceMatrix"&&E.instanceMatrix&&(me=E.instanceMatrix),K==="instanceColor"&&E.instanceColor&&(me=E.instanceColor)),ae===void 0||ae.attribute!==me||me&&ae.data!==me.data)return!0;j++}return r.attributesNum!==j||r.index!==z}function _(E,C,B,z){const Y={},W=C.attributes;let j=0;const q=B.getAttributes();for(const K in q)if(q[K].location>=0){let ae=W[K];ae===void 0&&(K==="instanceMatrix"&&E.instanceMatrix&&(ae=E.instanceMatrix),K==="instanceColor"&&E.instanceColor&&(ae=E.instanceColor));const me={};me.attribute=ae,ae&&ae.data&&(me.data=ae.data),Y[K]=me,j++}r.attributes=Y,r.attributesNum=j,r.index=z}function v(){const E=r.newAttributes;for(let C=0,B=E.length;C<B;C++)E[C]=0}function m(E){p(E,0)}function p(E,C){const B=r.newAttributes,z=r.enabledAttributes,Y=r.attributeDivisors;B[E]=1,z[E]===0&&(n.enableVertexAttribArray(E),z[E]=1),Y[E]!==C&&(n.vertexAttribDivisor(E,C),Y[E]=C)}function y(){const E=r.newAttributes,C=r.enabledAttributes;for(let B=0,z=C.length;B<z;B++)C[B]!==E[B]&&(n.disableVertexAttribArray(B),C[B]=0)}function w(E,C,B,z,Y,W,j){j===!0?n.vertexAttribIPointer(E,C,B,Y,W):n.vertexAttribPointer(E,C,B,z,Y,W)}function x(E,C,B,z){v();const Y=z.attributes,W=B.getAttributes(),j=C.defaultAttributeValues;for(const q in W){const K=W[q];if(K.location>=0){let re=Y[q];if(re===void 0&&(q==="instanceMatrix"&&E.instanceMatrix&&(re=E.instanceMatrix),q==="instanceColor"&&E.instanceColor&&(re=E.instanceColor)),re!==void 0){const ae=re.normalized,me=re.itemSize,xe=e.get(re);if(xe===void 0)continue;const ge=xe.buffer,Qe=xe.type,et=xe.bytesPerElement,ee=Qe===n.INT||Qe===n.UNSIGNED_INT||re.gpuType===Xu;if(re.isInterleavedBufferAttribute){const ne=re.data,we=ne.stride,ze=re.offset;if(ne.isInstancedInterleavedBuffer){for(let Me=0;Me<K.locationSize;Me++)p(K.location+Me,ne.meshPerAttribute);E.isInstancedMesh!==!0&&z._maxInstanceCount===void 0&&(z._maxInstanceCount=ne.meshPerAttribute*ne.count)}else for(let Me=0;Me<K.locationSize;Me++)m(K.location+Me);n.bindBuffer(n.ARRAY_BUFFER,ge);for(let Me=0;Me<K.locationSize;Me++)w(K.location+Me,me/K.locationSize,Qe,ae,we*et,(ze+me/K.locationSize*Me)*et,ee)}else{if(re.isInstancedBufferAttribute){for(let ne=0;ne<K.locationSize;ne++)p(K.location+ne,re.meshPerAttribute);E.isInstancedMesh!==!0&&z._maxInstanceCount===void 0&&(z._maxInstanceCount=re.meshPerAttribute*re.count)}else for(let ne=0;ne<K.locationSize;ne++)m(K.location+ne);n.bindBuffer(n.ARRAY_BUFFER,ge);for(let ne=0;ne<K.locationSize;ne++)w(K.location+ne,me/K.locationSize,Qe,ae,me*et,me/K.locationSize*ne*et,ee)}}else if(j!==void 0){const ae=j[q];if(ae!==void 0)switch(ae.length){case 2:n.vertexAttrib2fv(K.location,ae);break;case 3:n.vertexAttrib3fv(K.location,ae);break;case 4:n.vertexAttrib4fv(K.location,ae);break;default:n.vertexAttrib1fv(K.location,ae)}}}}y()}function L(){N();for(const E in i){const C=i[E];for(const B in C){const z=C[B];for(const Y in z)h(z[Y].object),delete z[Y];delete C[B]}delete i[E]}}function A(E){if(i[E.id]===void 0)return;const C=i[E.id];for(const B in C){const z=C[B];for(const Y in z)h(z[Y].object),delete z[Y];delete C[B]}delete i[E.id]}function U(E){for(const C in i){const B=i[C];if(B[E.id]===void 0)continue;const z=B[E.id];for(const Y in z)h(z[Y].object),delete z[Y];delete B[E.id]}}function N(){b(),o=!0,r!==s&&(r=s,c(r.object))}function b(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:N,resetDefaultState:b,dispose:L,releaseStatesOfGeometry:A,releaseStatesOfProgram:U,initAttributes:v,enableAttribute:m,disableUnusedAttributes:y}}function uE(n,e,t){let i;function s(c){i=c}function r(c,h){n.drawArrays(i,c,h),t.update(h,i,1)}function o(c,h,f){f!==0&&(n.drawArraysInstanced(i,c,h,f),t.update(h,i,f))}function a(c,h,f){if(f===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,c,0,h,0,f);let u=0;for(let _=0;_<f;_++)u+=h[_];t.update(u,i,1)}function l(c,h,f,d){if(f===0)return;const u=e.get("WEBGL_multi_draw");if(u===null)for(let _=0;_<c.length;_++)o(c[_],h[_],d[_]);else{u.multiDrawArraysInstancedWEBGL(i,c,0,h,0,d,0,f);let _=0;for(let v=0;v<f;v++)_+=h[v]*d[v];t.update(_,i,1)}}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a,this.renderMultiDrawInstances=l}function fE(n,e,t,i){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){const U=e.get("EXT_texture_filter_anisotropic");s=n.getParameter(U.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(U){return!(U!==Di&&i.convert(U)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(U){const N=U===Sa&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(U!==qi&&i.convert(U)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE)&&U!==Wi&&!N)}function l(U){if(U==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";U="mediump"}return U==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp";const h=l(c);h!==c&&(console.warn("THREE.WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);const f=t.logarithmicDepthBuffer===!0,d=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),u=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),_=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),v=n.getParameter(n.MAX_TEXTURE_SIZE),m=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),p=n.getParameter(n.MAX_VERTEX_ATTRIBS),y=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),w=n.getParameter(n.MAX_VARYING_VECTORS),x=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),L=_>0,A=n.getParameter(n.MAX_SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:f,reversedDepthBuffer:d,maxTextures:u,maxVertexTextures:_,maxTextureSize:v,maxCubemapSize:m,maxAttributes:p,maxVertexUniforms:y,maxVaryings:w,maxFragmentUniforms:x,vertexTextures:L,maxSamples:A}}function dE(n){const e=this;let t=null,i=0,s=!1,r=!1;const o=new Cs,a=new rt,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(f,d){const u=f.length!==0||d||i!==0||s;return s=d,i=f.length,u},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(f,d){t=h(f,d,0)},this.setState=function(f,d,u){const _=f.clippingPlanes,v=f.clipIntersection,m=f.clipShadows,p=n.get(f);if(!s||_===null||_.length===0||r&&!m)r?h(null):c();else{const y=r?0:i,w=y*4;let x=p.clippingState||null;l.value=x,x=h(_,d,w,u);for(let L=0;L!==w;++L)x[L]=t[L];p.clippingState=x,this.numIntersection=v?this.numPlanes:0,this.numPlanes+=y}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=i>0),e.numPlanes=i,e.numIntersection=0}function h(f,d,u,_){const v=f!==null?f.length:0;let m=null;if(v!==0){if(m=l.value,_!==!0||m===null){const p=u+v*4,y=d.matrixWorldInverse;a.getNormalMatrix(y),(m===null||m.length<p)&&(m=new Float32Array(p));for(let w=0,x=u;w!==v;++w,x+=4)o.copy(f[w]).applyMatrix4(y,a),o.normal.toArray(m,x),m[x+3]=o.constant}l.value=m,l.needsUpdate=!0}return e.numPlanes=v,e.numIntersection=0,m}}function pE(n){let e=new WeakMap;function t(o,a){return a===Fh?o.mapping=co:a===Oh&&(o.mapping=ho),o}function i(o){if(o&&o.isTexture){const a=o.mapping;if(a===Fh||a===Oh)if(e.has(o)){const l=e.get(o).texture;return t(l,o.mapping)}else{const l=o.image;if(l&&l.height>0){const c=new aM(l.height);return c.fromEquirectangularTexture(n,o),e.set(o,c),o.addEventListener("dispose",s),t(c.texture,o.mapping)}else return null}}return o}function s(o){const a=o.target;a.removeEventListener("dispose",s);const l=e.get(a);l!==void 0&&(e.delete(a),l.dispose())}function r(){e=new WeakMap}return{get:i,dispose:r}}const jr=4,hp=[.125,.215,.35,.446,.526,.582],or=20,Jc=new rf,up=new Je;let Qc=null,eh=0,th=0,nh=!1;const er=(1+Math.sqrt(5))/2,Xr=1/er,fp=[new k(-er,Xr,0),new k(er,Xr,0),new k(-Xr,0,er),new k(Xr,0,er),new k(0,er,-Xr),new k(0,er,Xr),new k(-1,1,-1),new k(1,1,-1),new k(-1,1,1),new k(1,1,1)],mE=new k;class dp{constructor(e){this._renderer=e,this._pingPongRenderTarget=null,this._lodMax=0,this._cubeSize=0,this._lodPlanes=[],this._sizeLods=[],this._sigmas=[],this._blurMaterial=null,this._cubemapMaterial=null,this._equirectMaterial=null,this._compileMaterial(this._blurMaterial)}fromScene(e,t=0,i=.1,s=100,r={}){const{size:o=256,position:a=mE}=r;Qc=this._renderer.getRenderTarget(),eh=this._renderer.getActiveCubeFace(),th=this._renderer.getActiveMipmapLevel(),nh=this._renderer.xr.enabled,this._renderer.xr.enabled=!1,this._setSize(o);const l=this._allocateTargets();return l.depthBuffer=!0,this._sceneToCubeUV(e,i,s,l,a),t>0&&this._blur(l,0,0,t),this._applyPMREM(l),this._cleanup(l),l}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=_p(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=mp(),this._compileMaterial(this._equirectMaterial))}dispose(){this._dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose()}_setSize(e){this._lodMax=Math.floor(Math.log2(e)),this._cubeSize=Math.pow(2,this._lodMax)}_dispose(){this._blurMaterial!==null&&this._blurMaterial.dispose(),this._pingPongRenderTarget!==null&&this._pingPongRenderTarget.dispose();for(let e=0;e<this._lodPlanes.length;e++)this._lodPlanes[e].dispose()}_cleanup(e){this._renderer.setRenderTarget(Qc,eh,th),this._renderer.xr.enabled=nh,e.scissorTest=!1,sl(e,0,0,e.width,e.height)}_fromTexture(e,t){e.mapping===co||e.mapping===ho?this._setSize(e.image.length===0?16:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4),Qc=this._renderer.getRenderTarget(),eh=this._renderer.getActiveCubeFace(),th=this._renderer.getActiveMipmapLevel(),nh=this._renderer.xr.enabled,this._renderer.xr.enabled=!1;const i=t||this._allocateTargets();return this._textureToCubeUV(e,i),this._applyPMREM(i),this._cleanup(i),i}_allocateTargets(){const e=3*Math.max(this._cubeSize,112),t=4*this._cubeSize,i={magFilter:Gi,minFilter:Gi,generateMipmaps:!1,type:Sa,format:Di,colorSpace:uo,depthBuffer:!1},s=pp(e,t,i);if(this._pingPongRenderTarget===null||this._pingPongRenderTarget.width!==e||this._pingPongRenderTarget.height!==t){this._pingPongRenderTarget!==null&&this._dispose(),this._pingPongRenderTarget=pp(e,t,i);const{_lodMax:r}=this;({sizeLods:this._sizeLods,lodPlanes:this._lodPlanes,sigmas:this._sigmas}=_E(r)),this._blurMaterial=gE(r,e,t)}return s}_compileMaterial(e){const t=new be(this._lodPlanes[0],e);this._renderer.compile(t,Jc)}_sceneToCubeUV(e,t,i,s,r){const l=new _i(90,1,t,i),c=[1,-1,1,1,1,1],h=[1,1,1,-1,-1,-1],f=this._renderer,d=f.autoClear,u=f.toneMapping;f.getClearColor(up),f.toneMapping=Ls,f.autoClear=!1,f.state.buffers.depth.getReversed()&&(f.setRenderTarget(s),f.clearDepth(),f.setRenderTarget(null));const v=new ic({name:"PMREM.Background",side:Kn,depthWrite:!1,depthTest:!1}),m=new be(new on,v);let p=!1;const y=e.background;y?y.isColor&&(v.color.copy(y),e.background=null,p=!0):(v.color.copy(up),p=!0);for(let w=0;w<6;w++){const x=w%3;x===0?(l.up.set(0,c[w],0),l.position.set(r.x,r.y,r.z),l.lookAt(r.x+h[w],r.y,r.z)):x===1?(l.up.set(0,0,c[w]),l.position.set(r.x,r.y,r.z),l.lookAt(r.x,r.y+h[w],r.z)):(l.up.set(0,c[w],0),l.position.set(r.x,r.y,r.z),l.lookAt(r.x,r.y,r.z+h[w]));const L=this._cubeSize;sl(s,x*L,w>2?L:0,L,L),f.setRenderTarget(s),p&&f.render(m,l),f.render(e,l)}m.geometry.dispose(),m.material.dispose(),f.toneMapping=u,f.autoClear=d,e.background=y}_textureToCubeUV(e,t){const i=this._renderer,s=e.mapping===co||e.mapping===ho;s?(this._cubemapMaterial===null&&(this._cubemapMaterial=_p()),this._cubemapMaterial.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):this._equirectMaterial===null&&(this._equirectMaterial=mp());const r=s?this._cubemapMaterial:this._equirectMaterial,o=new be(this._lodPlanes[0],r),a=r.uniforms;a.envMap.value=e;const l=this._cubeSize;sl(t,0,0,3*l,2*l),i.setRenderTarget(t),i.render(o,Jc)}_applyPMREM(e){const t=this._renderer,i=t.autoClear;t.autoClear=!1;const s=this._lodPlanes.length;for(let r=1;r<s;r++){const o=Math.sqrt(this._sigmas[r]*this._sigmas[r]-this._sigmas[r-1]*this._sigmas[r-1]),a=fp[(s-r-1)%fp.length];this._blur(e,r-1,r,o,a)}t.autoClear=i}_blur(e,t,i,s,r){const o=this._pingPongRenderTarget;this._halfBlur(e,o,t,i,s,"latitudinal",r),this._halfBlur(o,e,i,i,s,"longitudinal",r)}_halfBlur(e,t,i,s,r,o,a){const l=this._renderer,c=this._blurMaterial;o!=="latitudinal"&&o!=="longitudinal"&&console.error("blur direction must be either latitudinal or longitudinal!");const h=3,f=new be(this._lodPlanes[s],c),d=c.uniforms,u=this._sizeLods[i]-1,_=isFinite(r)?Math.PI/(2*u):2*Math.PI/(2*or-1),v=r/_,m=isFinite(r)?1+Math.floor(h*v):or;m>or&&console.warn(`sigmaRadians, ${r}, is too large and will clip, as it requested ${m} samples when the maximum is set to ${or}`);const p=[];let y=0;for(let U=0;U<or;++U){const N=U/v,b=Math.exp(-N*N/2);p.push(b),U===0?y+=b:U<m&&(y+=2*b)}for(let U=0;U<p.length;U++)p[U]=p[U]/y;d.envMap.value=e.texture,d.samples.value=m,d.weights.value=p,d.latitudinal.value=o==="latitudinal",a&&(d.poleAxis.value=a);const{_lodMax:w}=this;d.dTheta.value=_,d.mipInt.value=w-i;const x=this._sizeLods[s],L=3*x*(s>w-jr?s-w+jr:0),A=4*(this._cubeSize-x);sl(t,L,A,3*x,2*x),l.setRenderTarget(t),l.render(f,Jc)}}function _E(n){const e=[],t=[],i=[];let s=n;const r=n-jr+1+hp.length;for(let o=0;o<r;o++){const a=Math.pow(2,s);t.push(a);let l=1/a;o>n-jr?l=hp[o-n+jr-1]:o===0&&(l=0),i.push(l);const c=1/(a-2),h=-c,f=1+c,d=[h,h,f,h,f,f,h,h,f,f,h,f],u=6,_=6,v=3,m=2,p=1,y=new Float32Array(v*_*u),w=new Float32Array(m*_*u),x=new Float32Array(p*_*u);for(let A=0;A<u;A++){const U=A%3*2/3-1,N=A>2?0:-1,b=[U,N,0,U+2/3,N,0,U+2/3,N+1,0,U,N,0,U+2/3,N+1,0,U,N+1,0];y.set(b,v*_*A),w.set(d,m*_*A);const E=[A,A,A,A,A,A];x.set(E,p*_*A)}const L=new nn;L.setAttribute("position",new Cn(y,v)),L.setAttribute("uv",new Cn(w,m)),L.setAttribute("faceIndex",new Cn(x,p)),e.push(L),s>jr&&s--}return{lodPlanes:e,sizeLods:t,sigmas:i}}function pp(n,e,t){const i=new mr(n,e,t);return i.texture.mapping=tc,i.texture.name="PMREM.cubeUv",i.scissorTest=!0,i}function sl(n,e,t,i,s){n.viewport.set(e,t,i,s),n.scissor.set(e,t,i,s)}function gE(n,e,t){const i=new Float32Array(or),s=new k(0,1,0);return new hs({name:"SphericalGaussianBlur",defines:{n:or,CUBEUV_TEXEL_WIDTH:1/e,CUBEUV_TEXEL_HEIGHT:1/t,CUBEUV_MAX_MIP:`${n}.0`},uniforms:{envMap:{value:null},samples:{value:1},weights:{value:i},latitudinal:{value:!1},dTheta:{value:0},mipInt:{value:0},poleAxis:{value:s}},vertexShader:of(),fragmentShader:`

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
		`,blending:Ds,depthTest:!1,depthWrite:!1})}function mp(){return new hs({name:"EquirectangularToCubeUV",uniforms:{envMap:{value:null}},vertexShader:of(),fragmentShader:`

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
		`,blending:Ds,depthTest:!1,depthWrite:!1})}function _p(){return new hs({name:"CubemapToCubeUV",uniforms:{envMap:{value:null},flipEnvMap:{value:-1}},vertexShader:of(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			uniform float flipEnvMap;

			varying vec3 vOutputDirection;

			uniform samplerCube envMap;

			void main() {

				gl_FragColor = textureCube( envMap, vec3( flipEnvMap * vOutputDirection.x, vOutputDirection.yz ) );

			}
		`,blending:Ds,depthTest:!1,depthWrite:!1})}function of(){return`

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
	`}function vE(n){let e=new WeakMap,t=null;function i(a){if(a&&a.isTexture){const l=a.mapping,c=l===Fh||l===Oh,h=l===co||l===ho;if(c||h){let f=e.get(a);const d=f!==void 0?f.texture.pmremVersion:0;if(a.isRenderTargetTexture&&a.pmremVersion!==d)return t===null&&(t=new dp(n)),f=c?t.fromEquirectangular(a,f):t.fromCubemap(a,f),f.texture.pmremVersion=a.pmremVersion,e.set(a,f),f.texture;if(f!==void 0)return f.texture;{const u=a.image;return c&&u&&u.height>0||h&&u&&s(u)?(t===null&&(t=new dp(n)),f=c?t.fromEquirectangular(a):t.fromCubemap(a),f.texture.pmremVersion=a.pmremVersion,e.set(a,f),a.addEventListener("dispose",r),f.texture):null}}}return a}function s(a){let l=0;const c=6;for(let h=0;h<c;h++)a[h]!==void 0&&l++;return l===c}function r(a){const l=a.target;l.removeEventListener("dispose",r);const c=e.get(l);c!==void 0&&(e.delete(l),c.dispose())}function o(){e=new WeakMap,t!==null&&(t.dispose(),t=null)}return{get:i,dispose:o}}function xE(n){const e={};function t(i){if(e[i]!==void 0)return e[i];let s;switch(i){case"WEBGL_depth_texture":s=n.getExtension("WEBGL_depth_texture")||n.getExtension("MOZ_WEBGL_depth_texture")||n.getExtension("WEBKIT_WEBGL_depth_texture");break;case"EXT_texture_filter_anisotropic":s=n.getExtension("EXT_texture_filter_anisotropic")||n.getExtension("MOZ_EXT_texture_filter_anisotropic")||n.getExtension("WEBKIT_EXT_texture_filter_anisotropic");break;case"WEBGL_compressed_texture_s3tc":s=n.getExtension("WEBGL_compressed_texture_s3tc")||n.getExtension("MOZ_WEBGL_compressed_texture_s3tc")||n.getExtension("WEBKIT_WEBGL_compressed_texture_s3tc");break;case"WEBGL_compressed_texture_pvrtc":s=n.getExtension("WEBGL_compressed_texture_pvrtc")||n.getExtension("WEBKIT_WEBGL_compressed_texture_pvrtc");break;default:s=n.getExtension(i)}return e[i]=s,s}return{has:function(i){return t(i)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(i){const s=t(i);return s===null&&Ma("THREE.WebGLRenderer: "+i+" extension not supported."),s}}}function ME(n,e,t,i){const s={},r=new WeakMap;function o(f){const d=f.target;d.index!==null&&e.remove(d.index);for(const _ in d.attributes)e.remove(d.attributes[_]);d.removeEventListener("dispose",o),delete s[d.id];const u=r.get(d);u&&(e.remove(u),r.delete(d)),i.releaseStatesOfGeometry(d),d.isInstancedBufferGeometry===!0&&delete d._maxInstanceCount,t.memory.geometries--}function a(f,d){return s[d.id]===!0||(d.addEventListener("dispose",o),s[d.id]=!0,t.memory.geometries++),d}function l(f){const d=f.attributes;for(const u in d)e.update(d[u],n.ARRAY_BUFFER)}function c(f){const d=[],u=f.index,_=f.attributes.position;let v=0;if(u!==null){const y=u.array;v=u.version;for(let w=0,x=y.length;w<x;w+=3){const L=y[w+0],A=y[w+1],U=y[w+2];d.push(L,A,A,U,U,L)}}else if(_!==void 0){const y=_.array;v=_.version;for(let w=0,x=y.length/3-1;w<x;w+=3){const L=w+0,A=w+1,U=w+2;d.push(L,A,A,U,U,L)}}else return;const m=new(w_(d)?C_:R_)(d,1);m.version=v;const p=r.get(f);p&&e.remove(p),r.set(f,m)}function h(f){const d=r.get(f);if(d){const u=f.index;u!==null&&d.version<u.version&&c(f)}else c(f);return r.get(f)}return{get:a,update:l,getWireframeAttribute:h}}function yE(n,e,t){let i;function s(d){i=d}let r,o;function a(d){r=d.type,o=d.bytesPerElement}function l(d,u){n.drawElements(i,u,r,d*o),t.update(u,i,1)}function c(d,u,_){_!==0&&(n.drawElementsInstanced(i,u,r,d*o,_),t.update(u,i,_))}function h(d,u,_){if(_===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,u,0,r,d,0,_);let m=0;for(let p=0;p<_;p++)m+=u[p];t.update(m,i,1)}function f(d,u,_,v){if(_===0)return;const m=e.get("WEBGL_multi_draw");if(m===null)for(let p=0;p<d.length;p++)c(d[p]/o,u[p],v[p]);else{m.multiDrawElementsInstancedWEBGL(i,u,0,r,d,0,v,0,_);let p=0;for(let y=0;y<_;y++)p+=u[y]*v[y];t.update(p,i,1)}}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=h,this.renderMultiDrawInstances=f}function SE(n){const e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(t.calls++,o){case n.TRIANGLES:t.triangles+=a*(r/3);break;case n.LINES:t.lines+=a*(r/2);break;case n.LINE_STRIP:t.lines+=a*(r-1);break;case n.LINE_LOOP:t.lines+=a*r;break;case n.POINTS:t.points+=a*r;break;default:console.error("THREE.WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:i}}function EE(n,e,t){const i=new WeakMap,s=new en;function r(o,a,l){const c=o.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,f=h!==void 0?h.length:0;let d=i.get(a);if(d===void 0||d.count!==f){let E=function(){N.dispose(),i.delete(a),a.removeEventListener("dispose",E)};var u=E;d!==void 0&&d.texture.dispose();const _=a.morphAttributes.position!==void 0,v=a.morphAttributes.normal!==void 0,m=a.morphAttributes.color!==void 0,p=a.morphAttributes.position||[],y=a.morphAttributes.normal||[],w=a.morphAttributes.color||[];let x=0;_===!0&&(x=1),v===!0&&(x=2),m===!0&&(x=3);let L=a.attributes.position.count*x,A=1;L>e.maxTextureSize&&(A=Math.ceil(L/e.maxTextureSize),L=e.maxTextureSize);const U=new Float32Array(L*A*4*f),N=new T_(U,L,A,f);N.type=Wi,N.needsUpdate=!0;const b=x*4;for(let C=0;C<f;C++){const B=p[C],z=y[C],Y=w[C],W=L*A*4*C;for(let j=0;j<B.count;j++){const q=j*b;_===!0&&(s.fromBufferAttribute(B,j),U[W+q+0]=s.x,U[W+q+1]=s.y,U[W+q+2]=s.z,U[W+q+3]=0),v===!0&&(s.fromBufferAttribute(z,j),U[W+q+4]=s.x,U[W+q+5]=s.y,U[W+q+6]=s.z,U[W+q+7]=0),m===!0&&(s.fromBufferAttribute(Y,j),U[W+q+8]=s.x,U[W+q+9]=s.y,U[W+q+10]=s.z,U[W+q+11]=Y.itemSize===4?s.w:1)}}d={count:f,texture:N,size:new Ke(L,A)},i.set(a,d),a.addEventListener("dispose",E)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,t);else{let _=0;for(let m=0;m<c.length;m++)_+=c[m];const v=a.morphTargetsRelative?1:1-_;l.getUniforms().setValue(n,"morphTargetBaseInfluence",v),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",d.texture,t),l.getUniforms().setValue(n,"morphTargetsTextureSize",d.size)}return{update:r}}function bE(n,e,t,i){let s=new WeakMap;function r(l){const c=i.render.frame,h=l.geometry,f=e.get(l,h);if(s.get(f)!==c&&(e.update(f),s.set(f,c)),l.isInstancedMesh&&(l.hasEventListener("dispose",a)===!1&&l.addEventListener("dispose",a),s.get(l)!==c&&(t.update(l.instanceMatrix,n.ARRAY_BUFFER),l.instanceColor!==null&&t.update(l.instanceColor,n.ARRAY_BUFFER),s.set(l,c))),l.isSkinnedMesh){const d=l.skeleton;s.get(d)!==c&&(d.update(),s.set(d,c))}return f}function o(){s=new WeakMap}function a(l){const c=l.target;c.removeEventListener("dispose",a),t.remove(c.instanceMatrix),c.instanceColor!==null&&t.remove(c.instanceColor)}return{update:r,dispose:o}}const z_=new Yn,gp=new I_(1,1),H_=new T_,V_=new Wx,G_=new L_,vp=[],xp=[],Mp=new Float32Array(16),yp=new Float32Array(9),Sp=new Float32Array(4);function Mo(n,e,t){const i=n[0];if(i<=0||i>0)return n;const s=e*t;let r=vp[s];if(r===void 0&&(r=new Float32Array(s),vp[s]=r),e!==0){i.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,n[o].toArray(r,a)}return r}function mn(n,e){if(n.length!==e.length)return!1;for(let t=0,i=n.length;t<i;t++)if(n[t]!==e[t])return!1;return!0}function _n(n,e){for(let t=0,i=e.length;t<i;t++)n[t]=e[t]}function sc(n,e){let t=xp[e];t===void 0&&(t=new Int32Array(e),xp[e]=t);for(let i=0;i!==e;++i)t[i]=n.allocateTextureUnit();return t}function wE(n,e){const t=this.cache;t[0]!==e&&(n.uniform1f(this.addr,e),t[0]=e)}function TE(n,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(mn(t,e))return;n.uniform2fv(this.addr,e),_n(t,e)}}function AE(n,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(n.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(mn(t,e))return;n.uniform3fv(this.addr,e),_n(t,e)}}function RE(n,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(mn(t,e))return;n.uniform4fv(this.addr,e),_n(t,e)}}function CE(n,e){const t=this.cache,i=e.elements;if(i===void 0){if(mn(t,e))return;n.uniformMatrix2fv(this.addr,!1,e),_n(t,e)}else{if(mn(t,i))return;Sp.set(i),n.uniformMatrix2fv(this.addr,!1,Sp),_n(t,i)}}function PE(n,e){const t=this.cache,i=e.elements;if(i===void 0){if(mn(t,e))return;n.uniformMatrix3fv(this.addr,!1,e),_n(t,e)}else{if(mn(t,i))return;yp.set(i),n.uniformMatrix3fv(this.addr,!1,yp),_n(t,i)}}function DE(n,e){const t=this.cache,i=e.elements;if(i===void 0){if(mn(t,e))return;n.uniformMatrix4fv(this.addr,!1,e),_n(t,e)}else{if(mn(t,i))return;Mp.set(i),n.uniformMatrix4fv(this.addr,!1,Mp),_n(t,i)}}function LE(n,e){const t=this.cache;t[0]!==e&&(n.uniform1i(this.addr,e),t[0]=e)}function IE(n,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(mn(t,e))return;n.uniform2iv(this.addr,e),_n(t,e)}}function UE(n,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(mn(t,e))return;n.uniform3iv(this.addr,e),_n(t,e)}}function NE(n,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(mn(t,e))return;n.uniform4iv(this.addr,e),_n(t,e)}}function FE(n,e){const t=this.cache;t[0]!==e&&(n.uniform1ui(this.addr,e),t[0]=e)}function OE(n,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(mn(t,e))return;n.uniform2uiv(this.addr,e),_n(t,e)}}function kE(n,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(mn(t,e))return;n.uniform3uiv(this.addr,e),_n(t,e)}}function BE(n,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(mn(t,e))return;n.uniform4uiv(this.addr,e),_n(t,e)}}function zE(n,e,t){const i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?(gp.compareFunction=b_,r=gp):r=z_,t.setTexture2D(e||r,s)}function HE(n,e,t){const i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture3D(e||V_,s)}function VE(n,e,t){const i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTextureCube(e||G_,s)}function GE(n,e,t){const i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture2DArray(e||H_,s)}function WE(n){switch(n){case 5126:return wE;case 35664:return TE;case 35665:return AE;case 35666:return RE;case 35674:return CE;case 35675:return PE;case 35676:return DE;case 5124:case 35670:return LE;case 35667:case 35671:return IE;case 35668:case 35672:return UE;case 35669:case 35673:return NE;case 5125:return FE;case 36294:return OE;case 36295:return kE;case 36296:return BE;case 35678:case 36198:case 36298:case 36306:case 35682:return zE;case 35679:case 36299:case 36307:return HE;case 35680:case 36300:case 36308:case 36293:return VE;case 36289:case 36303:case 36311:case 36292:return GE}}function XE(n,e){n.uniform1fv(this.addr,e)}function YE(n,e){const t=Mo(e,this.size,2);n.uniform2fv(this.addr,t)}function qE(n,e){const t=Mo(e,this.size,3);n.uniform3fv(this.addr,t)}function $E(n,e){const t=Mo(e,this.size,4);n.uniform4fv(this.addr,t)}function jE(n,e){const t=Mo(e,this.size,4);n.uniformMatrix2fv(this.addr,!1,t)}function ZE(n,e){const t=Mo(e,this.size,9);n.uniformMatrix3fv(this.addr,!1,t)}function KE(n,e){const t=Mo(e,this.size,16);n.uniformMatrix4fv(this.addr,!1,t)}function JE(n,e){n.uniform1iv(this.addr,e)}function QE(n,e){n.uniform2iv(this.addr,e)}function eb(n,e){n.uniform3iv(this.addr,e)}function tb(n,e){n.uniform4iv(this.addr,e)}function nb(n,e){n.uniform1uiv(this.addr,e)}function ib(n,e){n.uniform2uiv(this.addr,e)}function sb(n,e){n.uniform3uiv(this.addr,e)}function rb(n,e){n.uniform4uiv(this.addr,e)}function ob(n,e,t){const i=this.cache,s=e.length,r=sc(t,s);mn(i,r)||(n.uniform1iv(this.addr,r),_n(i,r));for(let o=0;o!==s;++o)t.setTexture2D(e[o]||z_,r[o])}function ab(n,e,t){const i=this.cache,s=e.length,r=sc(t,s);mn(i,r)||(n.uniform1iv(this.addr,r),_n(i,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||V_,r[o])}function lb(n,e,t){const i=this.cache,s=e.length,r=sc(t,s);mn(i,r)||(n.uniform1iv(this.addr,r),_n(i,r));for(let o=0;o!==s;++o)t.setTextureCube(e[o]||G_,r[o])}function cb(n,e,t){const i=this.cache,s=e.length,r=sc(t,s);mn(i,r)||(n.uniform1iv(this.addr,r),_n(i,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||H_,r[o])}function hb(n){switch(n){case 5126:return XE;case 35664:return YE;case 35665:return qE;case 35666:return $E;case 35674:return jE;case 35675:return ZE;case 35676:return KE;case 5124:case 35670:return JE;case 35667:case 35671:return QE;case 35668:case 35672:return eb;case 35669:case 35673:return tb;case 5125:return nb;case 36294:return ib;case 36295:return sb;case 36296:return rb;case 35678:case 36198:case 36298:case 36306:case 35682:return ob;case 35679:case 36299:case 36307:return ab;case 35680:case 36300:case 36308:case 36293:return lb;case 36289:case 36303:case 36311:case 36292:return cb}}class ub{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.setValue=WE(t.type)}}class fb{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=hb(t.type)}}class db{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,i){const s=this.seq;for(let r=0,o=s.length;r!==o;++r){const a=s[r];a.setValue(e,t[a.id],i)}}}const ih=/(\w+)(\])?(\[|\.)?/g;function Ep(n,e){n.seq.push(e),n.map[e.id]=e}function pb(n,e,t){const i=n.name,s=i.length;for(ih.lastIndex=0;;){const r=ih.exec(i),o=ih.lastIndex;let a=r[1];const l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){Ep(t,c===void 0?new ub(a,n,e):new fb(a,n,e));break}else{let f=t.map[a];f===void 0&&(f=new db(a),Ep(t,f)),t=f}}}class Sl{constructor(e,t){this.seq=[],this.map={};const i=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let s=0;s<i;++s){const r=e.getActiveUniform(t,s),o=e.getUniformLocation(t,r.name);pb(r,o,this)}}setValue(e,t,i,s){const r=this.map[t];r!==void 0&&r.setValue(e,i,s)}setOptional(e,t,i){const s=t[i];s!==void 0&&this.setValue(e,i,s)}static upload(e,t,i,s){for(let r=0,o=t.length;r!==o;++r){const a=t[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,s)}}static seqWithValue(e,t){const i=[];for(let s=0,r=e.length;s!==r;++s){const o=e[s];o.id in t&&i.push(o)}return i}}function bp(n,e,t){const i=n.createShader(e);return n.shaderSource(i,t),n.compileShader(i),i}const mb=37297;let _b=0;function gb(n,e){const t=n.split(`
`),i=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){const a=o+1;i.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return i.join(`
`)}const wp=new rt;function vb(n){xt._getMatrix(wp,xt.workingColorSpace,n);const e=`mat3( ${wp.elements.map(t=>t.toFixed(4))} )`;switch(xt.getTransfer(n)){case Ol:return[e,"LinearTransferOETF"];case Dt:return[e,"sRGBTransferOETF"];default:return console.warn("THREE.WebGLProgram: Unsupported color space: ",n),[e,"LinearTransferOETF"]}}function Tp(n,e,t){const i=n.getShaderParameter(e,n.COMPILE_STATUS),r=(n.getShaderInfoLog(e)||"").trim();if(i&&r==="")return"";const o=/ERROR: 0:(\d+)/.exec(r);if(o){const a=parseInt(o[1]);return t.toUpperCase()+`

`+r+`

`+gb(n.getShaderSource(e),a)}else return r}function xb(n,e){const t=vb(e);return[`vec4 ${n}( vec4 value ) {`,`	return ${t[1]}( vec4( value.rgb * ${t[0]}, value.a ) );`,"}"].join(`
`)}function Mb(n,e){let t;switch(e){case gx:t="Linear";break;case vx:t="Reinhard";break;case xx:t="Cineon";break;case m_:t="ACESFilmic";break;case yx:t="AgX";break;case Sx:t="Neutral";break;case Mx:t="Custom";break;default:console.warn("THREE.WebGLProgram: Unsupported toneMapping:",e),t="Linear"}return"vec3 "+n+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}const rl=new k;function yb(){xt.getLuminanceCoefficients(rl);const n=rl.x.toFixed(4),e=rl.y.toFixed(4),t=rl.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function Sb(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Zo).join(`
`)}function Eb(n){const e=[];for(const t in n){const i=n[t];i!==!1&&e.push("#define "+t+" "+i)}return e.join(`
`)}function bb(n,e){const t={},i=n.getProgramParameter(e,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){const r=n.getActiveAttrib(e,s),o=r.name;let a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:n.getAttribLocation(e,o),locationSize:a}}return t}function Zo(n){return n!==""}function Ap(n,e){const t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return n.replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows)}function Rp(n,e){return n.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}const wb=/^[ \t]*#include +<([\w\d./]+)>/gm;function _u(n){return n.replace(wb,Ab)}const Tb=new Map;function Ab(n,e){let t=at[e];if(t===void 0){const i=Tb.get(e);if(i!==void 0)t=at[i],console.warn('THREE.WebGLRenderer: Shader chunk "%s" has been deprecated. Use "%s" instead.',e,i);else throw new Error("Can not resolve #include <"+e+">")}return _u(t)}const Rb=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Cp(n){return n.replace(Rb,Cb)}function Cb(n,e,t,i){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function Pp(n){let e=`precision ${n.precision} float;
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
#define LOW_PRECISION`),e}function Pb(n){let e="SHADOWMAP_TYPE_BASIC";return n.shadowMapType===d_?e="SHADOWMAP_TYPE_PCF":n.shadowMapType===p_?e="SHADOWMAP_TYPE_PCF_SOFT":n.shadowMapType===ns&&(e="SHADOWMAP_TYPE_VSM"),e}function Db(n){let e="ENVMAP_TYPE_CUBE";if(n.envMap)switch(n.envMapMode){case co:case ho:e="ENVMAP_TYPE_CUBE";break;case tc:e="ENVMAP_TYPE_CUBE_UV";break}return e}function Lb(n){let e="ENVMAP_MODE_REFLECTION";return n.envMap&&n.envMapMode===ho&&(e="ENVMAP_MODE_REFRACTION"),e}function Ib(n){let e="ENVMAP_BLENDING_NONE";if(n.envMap)switch(n.combine){case Wu:e="ENVMAP_BLENDING_MULTIPLY";break;case mx:e="ENVMAP_BLENDING_MIX";break;case _x:e="ENVMAP_BLENDING_ADD";break}return e}function Ub(n){const e=n.envMapCubeUVHeight;if(e===null)return null;const t=Math.log2(e)-2,i=1/e;return{texelWidth:1/(3*Math.max(Math.pow(2,t),112)),texelHeight:i,maxMip:t}}function Nb(n,e,t,i){const s=n.getContext(),r=t.defines;let o=t.vertexShader,a=t.fragmentShader;const l=Pb(t),c=Db(t),h=Lb(t),f=Ib(t),d=Ub(t),u=Sb(t),_=Eb(r),v=s.createProgram();let m,p,y=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(m=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,_].filter(Zo).join(`
`),m.length>0&&(m+=`
`),p=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,_].filter(Zo).join(`
`),p.length>0&&(p+=`
`)):(m=[Pp(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,_,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+h:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Zo).join(`
`),p=[Pp(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,_,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+h:"",t.envMap?"#define "+f:"",d?"#define CUBEUV_TEXEL_WIDTH "+d.texelWidth:"",d?"#define CUBEUV_TEXEL_HEIGHT "+d.texelHeight:"",d?"#define CUBEUV_MAX_MIP "+d.maxMip+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor||t.batchingColor?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==Ls?"#define TONE_MAPPING":"",t.toneMapping!==Ls?at.tonemapping_pars_fragment:"",t.toneMapping!==Ls?Mb("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",at.colorspace_pars_fragment,xb("linearToOutputTexel",t.outputColorSpace),yb(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(Zo).join(`
`)),o=_u(o),o=Ap(o,t),o=Rp(o,t),a=_u(a),a=Ap(a,t),a=Rp(a,t),o=Cp(o),a=Cp(a),t.isRawShaderMaterial!==!0&&(y=`#version 300 es
`,m=[u,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+m,p=["#define varying in",t.glslVersion===Ld?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===Ld?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+p);const w=y+m+o,x=y+p+a,L=bp(s,s.VERTEX_SHADER,w),A=bp(s,s.FRAGMENT_SHADER,x);s.attachShader(v,L),s.attachShader(v,A),t.index0AttributeName!==void 0?s.bindAttribLocation(v,0,t.index0AttributeName):t.morphTargets===!0&&s.bindAttribLocation(v,0,"position"),s.linkProgram(v);function U(C){if(n.debug.checkShaderErrors){const B=s.getProgramInfoLog(v)||"",z=s.getShaderInfoLog(L)||"",Y=s.getShaderInfoLog(A)||"",W=B.trim(),j=z.trim(),q=Y.trim();let K=!0,re=!0;if(s.getProgramParameter(v,s.LINK_STATUS)===!1)if(K=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,v,L,A);else{const ae=Tp(s,L,"vertex"),me=Tp(s,A,"fragment");console.error("THREE.WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(v,s.VALIDATE_STATUS)+`

Material Name: `+C.name+`
Material Type: `+C.type+`

Program Info Log: `+W+`
`+ae+`
`+me)}else W!==""?console.warn("THREE.WebGLProgram: Program Info Log:",W):(j===""||q==="")&&(re=!1);re&&(C.diagnostics={runnable:K,programLog:W,vertexShader:{log:j,prefix:m},fragmentShader:{log:q,prefix:p}})}s.deleteShader(L),s.deleteShader(A),N=new Sl(s,v),b=bb(s,v)}let N;this.getUniforms=function(){return N===void 0&&U(this),N};let b;this.getAttributes=function(){return b===void 0&&U(this),b};let E=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return E===!1&&(E=s.getProgramParameter(v,mb)),E},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(v),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=_b++,this.cacheKey=e,this.usedTimes=1,this.program=v,this.vertexShader=L,this.fragmentShader=A,this}let Fb=0;class Ob{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e){const t=e.vertexShader,i=e.fragmentShader,s=this._getShaderStage(t),r=this._getShaderStage(i),o=this._getShaderCacheForMaterial(e);return o.has(s)===!1&&(o.add(s),s.usedTimes++),o.has(r)===!1&&(o.add(r),r.usedTimes++),this}remove(e){const t=this.materialCache.get(e);for(const i of t)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(e),this}getVertexShaderID(e){return this._getShaderStage(e.vertexShader).id}getFragmentShaderID(e){return this._getShaderStage(e.fragmentShader).id}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){const t=this.materialCache;let i=t.get(e);return i===void 0&&(i=new Set,t.set(e,i)),i}_getShaderStage(e){const t=this.shaderCache;let i=t.get(e);return i===void 0&&(i=new kb(e),t.set(e,i)),i}}class kb{constructor(e){this.id=Fb++,this.code=e,this.usedTimes=0}}function Bb(n,e,t,i,s,r,o){const a=new ef,l=new Ob,c=new Set,h=[],f=s.logarithmicDepthBuffer,d=s.vertexTextures;let u=s.precision;const _={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distanceRGBA",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function v(b){return c.add(b),b===0?"uv":`uv${b}`}function m(b,E,C,B,z){const Y=B.fog,W=z.geometry,j=b.isMeshStandardMaterial?B.environment:null,q=(b.isMeshStandardMaterial?t:e).get(b.envMap||j),K=q&&q.mapping===tc?q.image.height:null,re=_[b.type];b.precision!==null&&(u=s.getMaxPrecision(b.precision),u!==b.precision&&console.warn("THREE.WebGLProgram.getParameters:",b.precision,"not supported, using",u,"instead."));const ae=W.morphAttributes.position||W.morphAttributes.normal||W.morphAttributes.color,me=ae!==void 0?ae.length:0;let xe=0;W.morphAttributes.position!==void 0&&(xe=1),W.morphAttributes.normal!==void 0&&(xe=2),W.morphAttributes.color!==void 0&&(xe=3);let ge,Qe,et,ee;if(re){const _t=zi[re];ge=_t.vertexShader,Qe=_t.fragmentShader}else ge=b.vertexShader,Qe=b.fragmentShader,l.update(b),et=l.getVertexShaderID(b),ee=l.getFragmentShaderID(b);const ne=n.getRenderTarget(),we=n.state.buffers.depth.getReversed(),ze=z.isInstancedMesh===!0,Me=z.isBatchedMesh===!0,tt=!!b.map,kt=!!b.matcap,F=!!q,mt=!!b.aoMap,$e=!!b.lightMap,We=!!b.bumpMap,Ne=!!b.normalMap,Tt=!!b.displacementMap,Pe=!!b.emissiveMap,Ge=!!b.metalnessMap,Vt=!!b.roughnessMap,yt=b.anisotropy>0,D=b.clearcoat>0,M=b.dispersion>0,O=b.iridescence>0,J=b.sheen>0,ie=b.transmission>0,te=yt&&!!b.anisotropyMap,Fe=D&&!!b.clearcoatMap,ue=D&&!!b.clearcoatNormalMap,Le=D&&!!b.clearcoatRoughnessMap,Re=O&&!!b.iridescenceMap,le=O&&!!b.iridescenceThicknessMap,ve=J&&!!b.sheenColorMap,Be=J&&!!b.sheenRoughnessMap,ke=!!b.specularMap,ye=!!b.specularColorMap,Ze=!!b.specularIntensityMap,H=ie&&!!b.transmissionMap,fe=ie&&!!b.thicknessMap,pe=!!b.gradientMap,De=!!b.alphaMap,he=b.alphaTest>0,oe=!!b.alphaHash,Oe=!!b.extensions;let nt=Ls;b.toneMapped&&(ne===null||ne.isXRRenderTarget===!0)&&(nt=n.toneMapping);const Ct={shaderID:re,shaderType:b.type,shaderName:b.name,vertexShader:ge,fragmentShader:Qe,defines:b.defines,customVertexShaderID:et,customFragmentShaderID:ee,isRawShaderMaterial:b.isRawShaderMaterial===!0,glslVersion:b.glslVersion,precision:u,batching:Me,batchingColor:Me&&z._colorsTexture!==null,instancing:ze,instancingColor:ze&&z.instanceColor!==null,instancingMorph:ze&&z.morphTexture!==null,supportsVertexTextures:d,outputColorSpace:ne===null?n.outputColorSpace:ne.isXRRenderTarget===!0?ne.texture.colorSpace:uo,alphaToCoverage:!!b.alphaToCoverage,map:tt,matcap:kt,envMap:F,envMapMode:F&&q.mapping,envMapCubeUVHeight:K,aoMap:mt,lightMap:$e,bumpMap:We,normalMap:Ne,displacementMap:d&&Tt,emissiveMap:Pe,normalMapObjectSpace:Ne&&b.normalMapType===Tx,normalMapTangentSpace:Ne&&b.normalMapType===Ju,metalnessMap:Ge,roughnessMap:Vt,anisotropy:yt,anisotropyMap:te,clearcoat:D,clearcoatMap:Fe,clearcoatNormalMap:ue,clearcoatRoughnessMap:Le,dispersion:M,iridescence:O,iridescenceMap:Re,iridescenceThicknessMap:le,sheen:J,sheenColorMap:ve,sheenRoughnessMap:Be,specularMap:ke,specularColorMap:ye,specularIntensityMap:Ze,transmission:ie,transmissionMap:H,thicknessMap:fe,gradientMap:pe,opaque:b.transparent===!1&&b.blending===Qr&&b.alphaToCoverage===!1,alphaMap:De,alphaTest:he,alphaHash:oe,combine:b.combine,mapUv:tt&&v(b.map.channel),aoMapUv:mt&&v(b.aoMap.channel),lightMapUv:$e&&v(b.lightMap.channel),bumpMapUv:We&&v(b.bumpMap.channel),normalMapUv:Ne&&v(b.normalMap.channel),displacementMapUv:Tt&&v(b.displacementMap.channel),emissiveMapUv:Pe&&v(b.emissiveMap.channel),metalnessMapUv:Ge&&v(b.metalnessMap.channel),roughnessMapUv:Vt&&v(b.roughnessMap.channel),anisotropyMapUv:te&&v(b.anisotropyMap.channel),clearcoatMapUv:Fe&&v(b.clearcoatMap.channel),clearcoatNormalMapUv:ue&&v(b.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:Le&&v(b.clearcoatRoughnessMap.channel),iridescenceMapUv:Re&&v(b.iridescenceMap.channel),iridescenceThicknessMapUv:le&&v(b.iridescenceThicknessMap.channel),sheenColorMapUv:ve&&v(b.sheenColorMap.channel),sheenRoughnessMapUv:Be&&v(b.sheenRoughnessMap.channel),specularMapUv:ke&&v(b.specularMap.channel),specularColorMapUv:ye&&v(b.specularColorMap.channel),specularIntensityMapUv:Ze&&v(b.specularIntensityMap.channel),transmissionMapUv:H&&v(b.transmissionMap.channel),thicknessMapUv:fe&&v(b.thicknessMap.channel),alphaMapUv:De&&v(b.alphaMap.channel),vertexTangents:!!W.attributes.tangent&&(Ne||yt),vertexColors:b.vertexColors,vertexAlphas:b.vertexColors===!0&&!!W.attributes.color&&W.attributes.color.itemSize===4,pointsUvs:z.isPoints===!0&&!!W.attributes.uv&&(tt||De),fog:!!Y,useFog:b.fog===!0,fogExp2:!!Y&&Y.isFogExp2,flatShading:b.flatShading===!0&&b.wireframe===!1,sizeAttenuation:b.sizeAttenuation===!0,logarithmicDepthBuffer:f,reversedDepthBuffer:we,skinning:z.isSkinnedMesh===!0,morphTargets:W.morphAttributes.position!==void 0,morphNormals:W.morphAttributes.normal!==void 0,morphColors:W.morphAttributes.color!==void 0,morphTargetsCount:me,morphTextureStride:xe,numDirLights:E.directional.length,numPointLights:E.point.length,numSpotLights:E.spot.length,numSpotLightMaps:E.spotLightMap.length,numRectAreaLights:E.rectArea.length,numHemiLights:E.hemi.length,numDirLightShadows:E.directionalShadowMap.length,numPointLightShadows:E.pointShadowMap.length,numSpotLightShadows:E.spotShadowMap.length,numSpotLightShadowsWithMaps:E.numSpotLightShadowsWithMaps,numLightProbes:E.numLightProbes,numClippingPlanes:o.numPlanes,numClipIntersection:o.numIntersection,dithering:b.dithering,shadowMapEnabled:n.shadowMap.enabled&&C.length>0,shadowMapType:n.shadowMap.type,toneMapping:nt,decodeVideoTexture:tt&&b.map.isVideoTexture===!0&&xt.getTransfer(b.map.colorSpace)===Dt,decodeVideoTextureEmissive:Pe&&b.emissiveMap.isVideoTexture===!0&&xt.getTransfer(b.emissiveMap.colorSpace)===Dt,premultipliedAlpha:b.premultipliedAlpha,doubleSided:b.side===Vi,flipSided:b.side===Kn,useDepthPacking:b.depthPacking>=0,depthPacking:b.depthPacking||0,index0AttributeName:b.index0AttributeName,extensionClipCullDistance:Oe&&b.extensions.clipCullDistance===!0&&i.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Oe&&b.extensions.multiDraw===!0||Me)&&i.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:i.has("KHR_parallel_shader_compile"),customProgramCacheKey:b.customProgramCacheKey()};return Ct.vertexUv1s=c.has(1),Ct.vertexUv2s=c.has(2),Ct.vertexUv3s=c.has(3),c.clear(),Ct}function p(b){const E=[];if(b.shaderID?E.push(b.shaderID):(E.push(b.customVertexShaderID),E.push(b.customFragmentShaderID)),b.defines!==void 0)for(const C in b.defines)E.push(C),E.push(b.defines[C]);return b.isRawShaderMaterial===!1&&(y(E,b),w(E,b),E.push(n.outputColorSpace)),E.push(b.customProgramCacheKey),E.join()}function y(b,E){b.push(E.precision),b.push(E.outputColorSpace),b.push(E.envMapMode),b.push(E.envMapCubeUVHeight),b.push(E.mapUv),b.push(E.alphaMapUv),b.push(E.lightMapUv),b.push(E.aoMapUv),b.push(E.bumpMapUv),b.push(E.normalMapUv),b.push(E.displacementMapUv),b.push(E.emissiveMapUv),b.push(E.metalnessMapUv),b.push(E.roughnessMapUv),b.push(E.anisotropyMapUv),b.push(E.clearcoatMapUv),b.push(E.clearcoatNormalMapUv),b.push(E.clearcoatRoughnessMapUv),b.push(E.iridescenceMapUv),b.push(E.iridescenceThicknessMapUv),b.push(E.sheenColorMapUv),b.push(E.sheenRoughnessMapUv),b.push(E.specularMapUv),b.push(E.specularColorMapUv),b.push(E.specularIntensityMapUv),b.push(E.transmissionMapUv),b.push(E.thicknessMapUv),b.push(E.combine),b.push(E.fogExp2),b.push(E.sizeAttenuation),b.push(E.morphTargetsCount),b.push(E.morphAttributeCount),b.push(E.numDirLights),b.push(E.numPointLights),b.push(E.numSpotLights),b.push(E.numSpotLightMaps),b.push(E.numHemiLights),b.push(E.numRectAreaLights),b.push(E.numDirLightShadows),b.push(E.numPointLightShadows),b.push(E.numSpotLightShadows),b.push(E.numSpotLightShadowsWithMaps),b.push(E.numLightProbes),b.push(E.shadowMapType),b.push(E.toneMapping),b.push(E.numClippingPlanes),b.push(E.numClipIntersection),b.push(E.depthPacking)}function w(b,E){a.disableAll(),E.supportsVertexTextures&&a.enable(0),E.instancing&&a.enable(1),E.instancingColor&&a.enable(2),E.instancingMorph&&a.enable(3),E.matcap&&a.enable(4),E.envMap&&a.enable(5),E.normalMapObjectSpace&&a.enable(6),E.normalMapTangentSpace&&a.enable(7),E.clearcoat&&a.enable(8),E.iridescence&&a.enable(9),E.alphaTest&&a.enable(10),E.vertexColors&&a.enable(11),E.vertexAlphas&&a.enable(12),E.vertexUv1s&&a.enable(13),E.vertexUv2s&&a.enable(14),E.vertexUv3s&&a.enable(15),E.vertexTangents&&a.enable(16),E.anisotropy&&a.enable(17),E.alphaHash&&a.enable(18),E.batching&&a.enable(19),E.dispersion&&a.enable(20),E.batchingColor&&a.enable(21),E.gradientMap&&a.enable(22),b.push(a.mask),a.disableAll(),E.fog&&a.enable(0),E.useFog&&a.enable(1),E.flatShading&&a.enable(2),E.logarithmicDepthBuffer&&a.enable(3),E.reversedDepthBuffer&&a.enable(4),E.skinning&&a.enable(5),E.morphTargets&&a.enable(6),E.morphNormals&&a.enable(7),E.morphColors&&a.enable(8),E.premultipliedAlpha&&a.enable(9),E.shadowMapEnabled&&a.enable(10),E.doubleSided&&a.enable(11),E.flipSided&&a.enable(12),E.useDepthPacking&&a.enable(13),E.dithering&&a.enable(14),E.transmission&&a.enable(15),E.sheen&&a.enable(16),E.opaque&&a.enable(17),E.pointsUvs&&a.enable(18),E.decodeVideoTexture&&a.enable(19),E.decodeVideoTextureEmissive&&a.enable(20),E.alphaToCoverage&&a.enable(21),b.push(a.mask)}function x(b){const E=_[b.type];let C;if(E){const B=zi[E];C=iM.clone(B.uniforms)}else C=b.uniforms;return C}function L(b,E){let C;for(let B=0,z=h.length;B<z;B++){const Y=h[B];if(Y.cacheKey===E){C=Y,++C.usedTimes;break}}return C===void 0&&(C=new Nb(n,E,b,r),h.push(C)),C}function A(b){if(--b.usedTimes===0){const E=h.indexOf(b);h[E]=h[h.length-1],h.pop(),b.destroy()}}function U(b){l.remove(b)}function N(){l.dispose()}return{getParameters:m,getProgramCacheKey:p,getUniforms:x,acquireProgram:L,releaseProgram:A,releaseShaderCache:U,programs:h,dispose:N}}function zb(){let n=new WeakMap;function e(o){return n.has(o)}function t(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:e,get:t,remove:i,update:s,dispose:r}}function Hb(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.material.id!==e.material.id?n.material.id-e.material.id:n.z!==e.z?n.z-e.z:n.id-e.id}function Dp(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.z!==e.z?e.z-n.z:n.id-e.id}function Lp(){const n=[];let e=0;const t=[],i=[],s=[];function r(){e=0,t.length=0,i.length=0,s.length=0}function o(f,d,u,_,v,m){let p=n[e];return p===void 0?(p={id:f.id,object:f,geometry:d,material:u,groupOrder:_,renderOrder:f.renderOrder,z:v,group:m},n[e]=p):(p.id=f.id,p.object=f,p.geometry=d,p.material=u,p.groupOrder=_,p.renderOrder=f.renderOrder,p.z=v,p.group=m),e++,p}function a(f,d,u,_,v,m){const p=o(f,d,u,_,v,m);u.transmission>0?i.push(p):u.transparent===!0?s.push(p):t.push(p)}function l(f,d,u,_,v,m){const p=o(f,d,u,_,v,m);u.transmission>0?i.unshift(p):u.transparent===!0?s.unshift(p):t.unshift(p)}function c(f,d){t.length>1&&t.sort(f||Hb),i.length>1&&i.sort(d||Dp),s.length>1&&s.sort(d||Dp)}function h(){for(let f=e,d=n.length;f<d;f++){const u=n[f];if(u.id===null)break;u.id=null,u.object=null,u.geometry=null,u.material=null,u.group=null}}return{opaque:t,transmissive:i,transparent:s,init:r,push:a,unshift:l,finish:h,sort:c}}function Vb(){let n=new WeakMap;function e(i,s){const r=n.get(i);let o;return r===void 0?(o=new Lp,n.set(i,[o])):s>=r.length?(o=new Lp,r.push(o)):o=r[s],o}function t(){n=new WeakMap}return{get:e,dispose:t}}function Gb(){const n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"DirectionalLight":t={direction:new k,color:new Je};break;case"SpotLight":t={position:new k,direction:new k,color:new Je,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new k,color:new Je,distance:0,decay:0};break;case"HemisphereLight":t={direction:new k,skyColor:new Je,groundColor:new Je};break;case"RectAreaLight":t={color:new Je,position:new k,halfWidth:new k,halfHeight:new k};break}return n[e.id]=t,t}}}function Wb(){const n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ke};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ke};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ke,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[e.id]=t,t}}}let Xb=0;function Yb(n,e){return(e.castShadow?2:0)-(n.castShadow?2:0)+(e.map?1:0)-(n.map?1:0)}function qb(n){const e=new Gb,t=Wb(),i={version:0,hash:{directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new k);const s=new k,r=new Rt,o=new Rt;function a(c){let h=0,f=0,d=0;for(let b=0;b<9;b++)i.probe[b].set(0,0,0);let u=0,_=0,v=0,m=0,p=0,y=0,w=0,x=0,L=0,A=0,U=0;c.sort(Yb);for(let b=0,E=c.length;b<E;b++){const C=c[b],B=C.color,z=C.intensity,Y=C.distance,W=C.shadow&&C.shadow.map?C.shadow.map.texture:null;if(C.isAmbientLight)h+=B.r*z,f+=B.g*z,d+=B.b*z;else if(C.isLightProbe){for(let j=0;j<9;j++)i.probe[j].addScaledVector(C.sh.coefficients[j],z);U++}else if(C.isDirectionalLight){const j=e.get(C);if(j.color.copy(C.color).multiplyScalar(C.intensity),C.castShadow){const q=C.shadow,K=t.get(C);K.shadowIntensity=q.intensity,K.shadowBias=q.bias,K.shadowNormalBias=q.normalBias,K.shadowRadius=q.radius,K.shadowMapSize=q.mapSize,i.directionalShadow[u]=K,i.directionalShadowMap[u]=W,i.directionalShadowMatrix[u]=C.shadow.matrix,y++}i.directional[u]=j,u++}else if(C.isSpotLight){const j=e.get(C);j.position.setFromMatrixPosition(C.matrixWorld),j.color.copy(B).multiplyScalar(z),j.distance=Y,j.coneCos=Math.cos(C.angle),j.penumbraCos=Math.cos(C.angle*(1-C.penumbra)),j.decay=C.decay,i.spot[v]=j;const q=C.shadow;if(C.map&&(i.spotLightMap[L]=C.map,L++,q.updateMatrices(C),C.castShadow&&A++),i.spotLightMatrix[v]=q.matrix,C.castShadow){const K=t.get(C);K.shadowIntensity=q.intensity,K.shadowBias=q.bias,K.shadowNormalBias=q.normalBias,K.shadowRadius=q.radius,K.shadowMapSize=q.mapSize,i.spotShadow[v]=K,i.spotShadowMap[v]=W,x++}v++}else if(C.isRectAreaLight){const j=e.get(C);j.color.copy(B).multiplyScalar(z),j.halfWidth.set(C.width*.5,0,0),j.halfHeight.set(0,C.height*.5,0),i.rectArea[m]=j,m++}else if(C.isPointLight){const j=e.get(C);if(j.color.copy(C.color).multiplyScalar(C.intensity),j.distance=C.distance,j.decay=C.decay,C.castShadow){const q=C.shadow,K=t.get(C);K.shadowIntensity=q.intensity,K.shadowBias=q.bias,K.shadowNormalBias=q.normalBias,K.shadowRadius=q.radius,K.shadowMapSize=q.mapSize,K.shadowCameraNear=q.camera.near,K.shadowCameraFar=q.camera.far,i.pointShadow[_]=K,i.pointShadowMap[_]=W,i.pointShadowMatrix[_]=C.shadow.matrix,w++}i.point[_]=j,_++}else if(C.isHemisphereLight){const j=e.get(C);j.skyColor.copy(C.color).multiplyScalar(z),j.groundColor.copy(C.groundColor).multiplyScalar(z),i.hemi[p]=j,p++}}m>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=Ee.LTC_FLOAT_1,i.rectAreaLTC2=Ee.LTC_FLOAT_2):(i.rectAreaLTC1=Ee.LTC_HALF_1,i.rectAreaLTC2=Ee.LTC_HALF_2)),i.ambient[0]=h,i.ambient[1]=f,i.ambient[2]=d;const N=i.hash;(N.directionalLength!==u||N.pointLength!==_||N.spotLength!==v||N.rectAreaLength!==m||N.hemiLength!==p||N.numDirectionalShadows!==y||N.numPointShadows!==w||N.numSpotShadows!==x||N.numSpotMaps!==L||N.numLightProbes!==U)&&(i.directional.length=u,i.spot.length=v,i.rectArea.length=m,i.point.length=_,i.hemi.length=p,i.directionalShadow.length=y,i.directionalShadowMap.length=y,i.pointShadow.length=w,i.pointShadowMap.length=w,i.spotShadow.length=x,i.spotShadowMap.length=x,i.directionalShadowMatrix.length=y,i.pointShadowMatrix.length=w,i.spotLightMatrix.length=x+L-A,i.spotLightMap.length=L,i.numSpotLightShadowsWithMaps=A,i.numLightProbes=U,N.directionalLength=u,N.pointLength=_,N.spotLength=v,N.rectAreaLength=m,N.hemiLength=p,N.numDirectionalShadows=y,N.numPointShadows=w,N.numSpotShadows=x,N.numSpotMaps=L,N.numLightProbes=U,i.version=Xb++)}function l(c,h){let f=0,d=0,u=0,_=0,v=0;const m=h.matrixWorldInverse;for(let p=0,y=c.length;p<y;p++){const w=c[p];if(w.isDirectionalLight){const x=i.directional[f];x.direction.setFromMatrixPosition(w.matrixWorld),s.setFromMatrixPosition(w.target.matrixWorld),x.direction.sub(s),x.direction.transformDirection(m),f++}else if(w.isSpotLight){const x=i.spot[u];x.position.setFromMatrixPosition(w.matrixWorld),x.position.applyMatrix4(m),x.direction.setFromMatrixPosition(w.matrixWorld),s.setFromMatrixPosition(w.target.matrixWorld),x.direction.sub(s),x.direction.transformDirection(m),u++}else if(w.isRectAreaLight){const x=i.rectArea[_];x.position.setFromMatrixPosition(w.matrixWorld),x.position.applyMatrix4(m),o.identity(),r.copy(w.matrixWorld),r.premultiply(m),o.extractRotation(r),x.halfWidth.set(w.width*.5,0,0),x.halfHeight.set(0,w.height*.5,0),x.halfWidth.applyMatrix4(o),x.halfHeight.applyMatrix4(o),_++}else if(w.isPointLight){const x=i.point[d];x.position.setFromMatrixPosition(w.matrixWorld),x.position.applyMatrix4(m),d++}else if(w.isHemisphereLight){const x=i.hemi[v];x.direction.setFromMatrixPosition(w.matrixWorld),x.direction.transformDirection(m),v++}}}return{setup:a,setupView:l,state:i}}function Ip(n){const e=new qb(n),t=[],i=[];function s(h){c.camera=h,t.length=0,i.length=0}function r(h){t.push(h)}function o(h){i.push(h)}function a(){e.setup(t)}function l(h){e.setupView(t,h)}const c={lightsArray:t,shadowsArray:i,camera:null,lights:e,transmissionRenderTarget:{}};return{init:s,state:c,setupLights:a,setupLightsView:l,pushLight:r,pushShadow:o}}function $b(n){let e=new WeakMap;function t(s,r=0){const o=e.get(s);let a;return o===void 0?(a=new Ip(n),e.set(s,[a])):r>=o.length?(a=new Ip(n),o.push(a)):a=o[r],a}function i(){e=new WeakMap}return{get:t,dispose:i}}const jb=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,Zb=`uniform sampler2D shadow_pass;
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
}`;function Kb(n,e,t){let i=new tf;const s=new Ke,r=new Ke,o=new en,a=new yM({depthPacking:wx}),l=new SM,c={},h=t.maxTextureSize,f={[cs]:Kn,[Kn]:cs,[Vi]:Vi},d=new hs({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Ke},radius:{value:4}},vertexShader:jb,fragmentShader:Zb}),u=d.clone();u.defines.HORIZONTAL_PASS=1;const _=new nn;_.setAttribute("position",new Cn(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));const v=new be(_,d),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=d_;let p=this.type;this.render=function(A,U,N){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||A.length===0)return;const b=n.getRenderTarget(),E=n.getActiveCubeFace(),C=n.getActiveMipmapLevel(),B=n.state;B.setBlending(Ds),B.buffers.depth.getReversed()===!0?B.buffers.color.setClear(0,0,0,0):B.buffers.color.setClear(1,1,1,1),B.buffers.depth.setTest(!0),B.setScissorTest(!1);const z=p!==ns&&this.type===ns,Y=p===ns&&this.type!==ns;for(let W=0,j=A.length;W<j;W++){const q=A[W],K=q.shadow;if(K===void 0){console.warn("THREE.WebGLShadowMap:",q,"has no shadow.");continue}if(K.autoUpdate===!1&&K.needsUpdate===!1)continue;s.copy(K.mapSize);const re=K.getFrameExtents();if(s.multiply(re),r.copy(K.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/re.x),s.x=r.x*re.x,K.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/re.y),s.y=r.y*re.y,K.mapSize.y=r.y)),K.map===null||z===!0||Y===!0){const me=this.type!==ns?{minFilter:oi,magFilter:oi}:{};K.map!==null&&K.map.dispose(),K.map=new mr(s.x,s.y,me),K.map.texture.name=q.name+".shadowMap",K.camera.updateProjectionMatrix()}n.setRenderTarget(K.map),n.clear();const ae=K.getViewportCount();for(let me=0;me<ae;me++){const xe=K.getViewport(me);o.set(r.x*xe.x,r.y*xe.y,r.x*xe.z,r.y*xe.w),B.viewport(o),K.updateMatrices(q,me),i=K.getFrustum(),x(U,N,K.camera,q,this.type)}K.isPointLightShadow!==!0&&this.type===ns&&y(K,N),K.needsUpdate=!1}p=this.type,m.needsUpdate=!1,n.setRenderTarget(b,E,C)};function y(A,U){const N=e.update(v);d.defines.VSM_SAMPLES!==A.blurSamples&&(d.defines.VSM_SAMPLES=A.blurSamples,u.defines.VSM_SAMPLES=A.blurSamples,d.needsUpdate=!0,u.needsUpdate=!0),A.mapPass===null&&(A.mapPass=new mr(s.x,s.y)),d.uniforms.shadow_pass.value=A.map.texture,d.uniforms.resolution.value=A.mapSize,d.uniforms.radius.value=A.radius,n.setRenderTarget(A.mapPass),n.clear(),n.renderBufferDirect(U,null,N,d,v,null),u.uniforms.shadow_pass.value=A.mapPass.texture,u.uniforms.resolution.value=A.mapSize,u.uniforms.radius.value=A.radius,n.setRenderTarget(A.map),n.clear(),n.renderBufferDirect(U,null,N,u,v,null)}function w(A,U,N,b){let E=null;const C=N.isPointLight===!0?A.customDistanceMaterial:A.customDepthMaterial;if(C!==void 0)E=C;else if(E=N.isPointLight===!0?l:a,n.localClippingEnabled&&U.clipShadows===!0&&Array.isArray(U.clippingPlanes)&&U.clippingPlanes.length!==0||U.displacementMap&&U.displacementScale!==0||U.alphaMap&&U.alphaTest>0||U.map&&U.alphaTest>0||U.alphaToCoverage===!0){const B=E.uuid,z=U.uuid;let Y=c[B];Y===void 0&&(Y={},c[B]=Y);let W=Y[z];W===void 0&&(W=E.clone(),Y[z]=W,U.addEventListener("dispose",L)),E=W}if(E.visible=U.visible,E.wireframe=U.wireframe,b===ns?E.side=U.shadowSide!==null?U.shadowSide:U.side:E.side=U.shadowSide!==null?U.shadowSide:f[U.side],E.alphaMap=U.alphaMap,E.alphaTest=U.alphaToCoverage===!0?.5:U.alphaTest,E.map=U.map,E.clipShadows=U.clipShadows,E.clippingPlanes=U.clippingPlanes,E.clipIntersection=U.clipIntersection,E.displacementMap=U.displacementMap,E.displacementScale=U.displacementScale,E.displacementBias=U.displacementBias,E.wireframeLinewidth=U.wireframeLinewidth,E.linewidth=U.linewidth,N.isPointLight===!0&&E.isMeshDistanceMaterial===!0){const B=n.properties.get(E);B.light=N}return E}function x(A,U,N,b,E){if(A.visible===!1)return;if(A.layers.test(U.layers)&&(A.isMesh||A.isLine||A.isPoints)&&(A.castShadow||A.receiveShadow&&E===ns)&&(!A.frustumCulled||i.intersectsObject(A))){A.modelViewMatrix.multiplyMatrices(N.matrixWorldInverse,A.matrixWorld);const z=e.update(A),Y=A.material;if(Array.isArray(Y)){const W=z.groups;for(let j=0,q=W.length;j<q;j++){const K=W[j],re=Y[K.materialIndex];if(re&&re.visible){const ae=w(A,re,b,E);A.onBeforeShadow(n,A,U,N,z,ae,K),n.renderBufferDirect(N,null,z,ae,A,K),A.onAfterShadow(n,A,U,N,z,ae,K)}}}else if(Y.visible){const W=w(A,Y,b,E);A.onBeforeShadow(n,A,U,N,z,W,null),n.renderBufferDirect(N,null,z,W,A,null),A.onAfterShadow(n,A,U,N,z,W,null)}}const B=A.children;for(let z=0,Y=B.length;z<Y;z++)x(B[z],U,N,b,E)}function L(A){A.target.removeEventListener("dispose",L);for(const N in c){const b=c[N],E=A.target.uuid;E in b&&(b[E].dispose(),delete b[E])}}}const Jb={[Ch]:Ph,[Dh]:Uh,[Lh]:Nh,[lo]:Ih,[Ph]:Ch,[Uh]:Dh,[Nh]:Lh,[Ih]:lo};function Qb(n,e){function t(){let H=!1;const fe=new en;let pe=null;const De=new en(0,0,0,0);return{setMask:function(he){pe!==he&&!H&&(n.colorMask(he,he,he,he),pe=he)},setLocked:function(he){H=he},setClear:function(he,oe,Oe,nt,Ct){Ct===!0&&(he*=nt,oe*=nt,Oe*=nt),fe.set(he,oe,Oe,nt),De.equals(fe)===!1&&(n.clearColor(he,oe,Oe,nt),De.copy(fe))},reset:function(){H=!1,pe=null,De.set(-1,0,0,0)}}}function i(){let H=!1,fe=!1,pe=null,De=null,he=null;return{setReversed:function(oe){if(fe!==oe){const Oe=e.get("EXT_clip_control");oe?Oe.clipControlEXT(Oe.LOWER_LEFT_EXT,Oe.ZERO_TO_ONE_EXT):Oe.clipControlEXT(Oe.LOWER_LEFT_EXT,Oe.NEGATIVE_ONE_TO_ONE_EXT),fe=oe;const nt=he;he=null,this.setClear(nt)}},getReversed:function(){return fe},setTest:function(oe){oe?ne(n.DEPTH_TEST):we(n.DEPTH_TEST)},setMask:function(oe){pe!==oe&&!H&&(n.depthMask(oe),pe=oe)},setFunc:function(oe){if(fe&&(oe=Jb[oe]),De!==oe){switch(oe){case Ch:n.depthFunc(n.NEVER);break;case Ph:n.depthFunc(n.ALWAYS);break;case Dh:n.depthFunc(n.LESS);break;case lo:n.depthFunc(n.LEQUAL);break;case Lh:n.depthFunc(n.EQUAL);break;case Ih:n.depthFunc(n.GEQUAL);break;case Uh:n.depthFunc(n.GREATER);break;case Nh:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}De=oe}},setLocked:function(oe){H=oe},setClear:function(oe){he!==oe&&(fe&&(oe=1-oe),n.clearDepth(oe),he=oe)},reset:function(){H=!1,pe=null,De=null,he=null,fe=!1}}}function s(){let H=!1,fe=null,pe=null,De=null,he=null,oe=null,Oe=null,nt=null,Ct=null;return{setTest:function(_t){H||(_t?ne(n.STENCIL_TEST):we(n.STENCIL_TEST))},setMask:function(_t){fe!==_t&&!H&&(n.stencilMask(_t),fe=_t)},setFunc:function(_t,wn,It){(pe!==_t||De!==wn||he!==It)&&(n.stencilFunc(_t,wn,It),pe=_t,De=wn,he=It)},setOp:function(_t,wn,It){(oe!==_t||Oe!==wn||nt!==It)&&(n.stencilOp(_t,wn,It),oe=_t,Oe=wn,nt=It)},setLocked:function(_t){H=_t},setClear:function(_t){Ct!==_t&&(n.clearStencil(_t),Ct=_t)},reset:function(){H=!1,fe=null,pe=null,De=null,he=null,oe=null,Oe=null,nt=null,Ct=null}}}const r=new t,o=new i,a=new s,l=new WeakMap,c=new WeakMap;let h={},f={},d=new WeakMap,u=[],_=null,v=!1,m=null,p=null,y=null,w=null,x=null,L=null,A=null,U=new Je(0,0,0),N=0,b=!1,E=null,C=null,B=null,z=null,Y=null;const W=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS);let j=!1,q=0;const K=n.getParameter(n.VERSION);K.indexOf("WebGL")!==-1?(q=parseFloat(/^WebGL (\d)/.exec(K)[1]),j=q>=1):K.indexOf("OpenGL ES")!==-1&&(q=parseFloat(/^OpenGL ES (\d)/.exec(K)[1]),j=q>=2);let re=null,ae={};const me=n.getParameter(n.SCISSOR_BOX),xe=n.getParameter(n.VIEWPORT),ge=new en().fromArray(me),Qe=new en().fromArray(xe);function et(H,fe,pe,De){const he=new Uint8Array(4),oe=n.createTexture();n.bindTexture(H,oe),n.texParameteri(H,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(H,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let Oe=0;Oe<pe;Oe++)H===n.TEXTURE_3D||H===n.TEXTURE_2D_ARRAY?n.texImage3D(fe,0,n.RGBA,1,1,De,0,n.RGBA,n.UNSIGNED_BYTE,he):n.texImage2D(fe+Oe,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,he);return oe}const ee={};ee[n.TEXTURE_2D]=et(n.TEXTURE_2D,n.TEXTURE_2D,1),ee[n.TEXTURE_CUBE_MAP]=et(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),ee[n.TEXTURE_2D_ARRAY]=et(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),ee[n.TEXTURE_3D]=et(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),ne(n.DEPTH_TEST),o.setFunc(lo),We(!1),Ne(Td),ne(n.CULL_FACE),mt(Ds);function ne(H){h[H]!==!0&&(n.enable(H),h[H]=!0)}function we(H){h[H]!==!1&&(n.disable(H),h[H]=!1)}function ze(H,fe){return f[H]!==fe?(n.bindFramebuffer(H,fe),f[H]=fe,H===n.DRAW_FRAMEBUFFER&&(f[n.FRAMEBUFFER]=fe),H===n.FRAMEBUFFER&&(f[n.DRAW_FRAMEBUFFER]=fe),!0):!1}function Me(H,fe){let pe=u,De=!1;if(H){pe=d.get(fe),pe===void 0&&(pe=[],d.set(fe,pe));const he=H.textures;if(pe.length!==he.length||pe[0]!==n.COLOR_ATTACHMENT0){for(let oe=0,Oe=he.length;oe<Oe;oe++)pe[oe]=n.COLOR_ATTACHMENT0+oe;pe.length=he.length,De=!0}}else pe[0]!==n.BACK&&(pe[0]=n.BACK,De=!0);De&&n.drawBuffers(pe)}function tt(H){return _!==H?(n.useProgram(H),_=H,!0):!1}const kt={[sr]:n.FUNC_ADD,[Jv]:n.FUNC_SUBTRACT,[Qv]:n.FUNC_REVERSE_SUBTRACT};kt[ex]=n.MIN,kt[tx]=n.MAX;const F={[nx]:n.ZERO,[ix]:n.ONE,[sx]:n.SRC_COLOR,[Ah]:n.SRC_ALPHA,[hx]:n.SRC_ALPHA_SATURATE,[lx]:n.DST_COLOR,[ox]:n.DST_ALPHA,[rx]:n.ONE_MINUS_SRC_COLOR,[Rh]:n.ONE_MINUS_SRC_ALPHA,[cx]:n.ONE_MINUS_DST_COLOR,[ax]:n.ONE_MINUS_DST_ALPHA,[ux]:n.CONSTANT_COLOR,[fx]:n.ONE_MINUS_CONSTANT_COLOR,[dx]:n.CONSTANT_ALPHA,[px]:n.ONE_MINUS_CONSTANT_ALPHA};function mt(H,fe,pe,De,he,oe,Oe,nt,Ct,_t){if(H===Ds){v===!0&&(we(n.BLEND),v=!1);return}if(v===!1&&(ne(n.BLEND),v=!0),H!==Kv){if(H!==m||_t!==b){if((p!==sr||x!==sr)&&(n.blendEquation(n.FUNC_ADD),p=sr,x=sr),_t)switch(H){case Qr:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Ad:n.blendFunc(n.ONE,n.ONE);break;case Rd:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case Cd:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:console.error("THREE.WebGLState: Invalid blending: ",H);break}else switch(H){case Qr:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Ad:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case Rd:console.error("THREE.WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Cd:console.error("THREE.WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:console.error("THREE.WebGLState: Invalid blending: ",H);break}y=null,w=null,L=null,A=null,U.set(0,0,0),N=0,m=H,b=_t}return}he=he||fe,oe=oe||pe,Oe=Oe||De,(fe!==p||he!==x)&&(n.blendEquationSeparate(kt[fe],kt[he]),p=fe,x=he),(pe!==y||De!==w||oe!==L||Oe!==A)&&(n.blendFuncSeparate(F[pe],F[De],F[oe],F[Oe]),y=pe,w=De,L=oe,A=Oe),(nt.equals(U)===!1||Ct!==N)&&(n.blendColor(nt.r,nt.g,nt.b,Ct),U.copy(nt),N=Ct),m=H,b=!1}function $e(H,fe){H.side===Vi?we(n.CULL_FACE):ne(n.CULL_FACE);let pe=H.side===Kn;fe&&(pe=!pe),We(pe),H.blending===Qr&&H.transparent===!1?mt(Ds):mt(H.blending,H.blendEquation,H.blendSrc,H.blendDst,H.blendEquationAlpha,H.blendSrcAlpha,H.blendDstAlpha,H.blendColor,H.blendAlpha,H.premultipliedAlpha),o.setFunc(H.depthFunc),o.setTest(H.depthTest),o.setMask(H.depthWrite),r.setMask(H.colorWrite);const De=H.stencilWrite;a.setTest(De),De&&(a.setMask(H.stencilWriteMask),a.setFunc(H.stencilFunc,H.stencilRef,H.stencilFuncMask),a.setOp(H.stencilFail,H.stencilZFail,H.stencilZPass)),Pe(H.polygonOffset,H.polygonOffsetFactor,H.polygonOffsetUnits),H.alphaToCoverage===!0?ne(n.SAMPLE_ALPHA_TO_COVERAGE):we(n.SAMPLE_ALPHA_TO_COVERAGE)}function We(H){E!==H&&(H?n.frontFace(n.CW):n.frontFace(n.CCW),E=H)}function Ne(H){H!==jv?(ne(n.CULL_FACE),H!==C&&(H===Td?n.cullFace(n.BACK):H===Zv?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):we(n.CULL_FACE),C=H}function Tt(H){H!==B&&(j&&n.lineWidth(H),B=H)}function Pe(H,fe,pe){H?(ne(n.POLYGON_OFFSET_FILL),(z!==fe||Y!==pe)&&(n.polygonOffset(fe,pe),z=fe,Y=pe)):we(n.POLYGON_OFFSET_FILL)}function Ge(H){H?ne(n.SCISSOR_TEST):we(n.SCISSOR_TEST)}function Vt(H){H===void 0&&(H=n.TEXTURE0+W-1),re!==H&&(n.activeTexture(H),re=H)}function yt(H,fe,pe){pe===void 0&&(re===null?pe=n.TEXTURE0+W-1:pe=re);let De=ae[pe];De===void 0&&(De={type:void 0,texture:void 0},ae[pe]=De),(De.type!==H||De.texture!==fe)&&(re!==pe&&(n.activeTexture(pe),re=pe),n.bindTexture(H,fe||ee[H]),De.type=H,De.texture=fe)}function D(){const H=ae[re];H!==void 0&&H.type!==void 0&&(n.bindTexture(H.type,null),H.type=void 0,H.texture=void 0)}function M(){try{n.compressedTexImage2D(...arguments)}catch(H){console.error("THREE.WebGLState:",H)}}function O(){try{n.compressedTexImage3D(...arguments)}catch(H){console.error("THREE.WebGLState:",H)}}function J(){try{n.texSubImage2D(...arguments)}catch(H){console.error("THREE.WebGLState:",H)}}function ie(){try{n.texSubImage3D(...arguments)}catch(H){console.error("THREE.WebGLState:",H)}}function te(){try{n.compressedTexSubImage2D(...arguments)}catch(H){console.error("THREE.WebGLState:",H)}}function Fe(){try{n.compressedTexSubImage3D(...arguments)}catch(H){console.error("THREE.WebGLState:",H)}}function ue(){try{n.texStorage2D(...arguments)}catch(H){console.error("THREE.WebGLState:",H)}}function Le(){try{n.texStorage3D(...arguments)}catch(H){console.error("THREE.WebGLState:",H)}}function Re(){try{n.texImage2D(...arguments)}catch(H){console.error("THREE.WebGLState:",H)}}function le(){try{n.texImage3D(...arguments)}catch(H){console.error("THREE.WebGLState:",H)}}function ve(H){ge.equals(H)===!1&&(n.scissor(H.x,H.y,H.z,H.w),ge.copy(H))}function Be(H){Qe.equals(H)===!1&&(n.viewport(H.x,H.y,H.z,H.w),Qe.copy(H))}function ke(H,fe){let pe=c.get(fe);pe===void 0&&(pe=new WeakMap,c.set(fe,pe));let De=pe.get(H);De===void 0&&(De=n.getUniformBlockIndex(fe,H.name),pe.set(H,De))}function ye(H,fe){const De=c.get(fe).get(H);l.get(fe)!==De&&(n.uniformBlockBinding(fe,De,H.__bindingPointIndex),l.set(fe,De))}function Ze(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),h={},re=null,ae={},f={},d=new WeakMap,u=[],_=null,v=!1,m=null,p=null,y=null,w=null,x=null,L=null,A=null,U=new Je(0,0,0),N=0,b=!1,E=null,C=null,B=null,z=null,Y=null,ge.set(0,0,n.canvas.width,n.canvas.height),Qe.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:ne,disable:we,bindFramebuffer:ze,drawBuffers:Me,useProgram:tt,setBlending:mt,setMaterial:$e,setFlipSided:We,setCullFace:Ne,setLineWidth:Tt,setPolygonOffset:Pe,setScissorTest:Ge,activeTexture:Vt,bindTexture:yt,unbindTexture:D,compressedTexImage2D:M,compressedTexImage3D:O,texImage2D:Re,texImage3D:le,updateUBOMapping:ke,uniformBlockBinding:ye,texStorage2D:ue,texStorage3D:Le,texSubImage2D:J,texSubImage3D:ie,compressedTexSubImage2D:te,compressedTexSubImage3D:Fe,scissor:ve,viewport:Be,reset:Ze}}function ew(n,e,t,i,s,r,o){const a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Ke,h=new WeakMap;let f;const d=new WeakMap;let u=!1;try{u=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function _(D,M){return u?new OffscreenCanvas(D,M):Bl("canvas")}function v(D,M,O){let J=1;const ie=yt(D);if((ie.width>O||ie.height>O)&&(J=O/Math.max(ie.width,ie.height)),J<1)if(typeof HTMLImageElement<"u"&&D instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&D instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&D instanceof ImageBitmap||typeof VideoFrame<"u"&&D instanceof VideoFrame){const te=Math.floor(J*ie.width),Fe=Math.floor(J*ie.height);f===void 0&&(f=_(te,Fe));const ue=M?_(te,Fe):f;return ue.width=te,ue.height=Fe,ue.getContext("2d").drawImage(D,0,0,te,Fe),console.warn("THREE.WebGLRenderer: Texture has been resized from ("+ie.width+"x"+ie.height+") to ("+te+"x"+Fe+")."),ue}else return"data"in D&&console.warn("THREE.WebGLRenderer: Image in DataTexture is too big ("+ie.width+"x"+ie.height+")."),D;return D}function m(D){return D.generateMipmaps}function p(D){n.generateMipmap(D)}function y(D){return D.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:D.isWebGL3DRenderTarget?n.TEXTURE_3D:D.isWebGLArrayRenderTarget||D.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function w(D,M,O,J,ie=!1){if(D!==null){if(n[D]!==void 0)return n[D];console.warn("THREE.WebGLRenderer: Attempt to use non-existing WebGL internal format '"+D+"'")}let te=M;if(M===n.RED&&(O===n.FLOAT&&(te=n.R32F),O===n.HALF_FLOAT&&(te=n.R16F),O===n.UNSIGNED_BYTE&&(te=n.R8)),M===n.RED_INTEGER&&(O===n.UNSIGNED_BYTE&&(te=n.R8UI),O===n.UNSIGNED_SHORT&&(te=n.R16UI),O===n.UNSIGNED_INT&&(te=n.R32UI),O===n.BYTE&&(te=n.R8I),O===n.SHORT&&(te=n.R16I),O===n.INT&&(te=n.R32I)),M===n.RG&&(O===n.FLOAT&&(te=n.RG32F),O===n.HALF_FLOAT&&(te=n.RG16F),O===n.UNSIGNED_BYTE&&(te=n.RG8)),M===n.RG_INTEGER&&(O===n.UNSIGNED_BYTE&&(te=n.RG8UI),O===n.UNSIGNED_SHORT&&(te=n.RG16UI),O===n.UNSIGNED_INT&&(te=n.RG32UI),O===n.BYTE&&(te=n.RG8I),O===n.SHORT&&(te=n.RG16I),O===n.INT&&(te=n.RG32I)),M===n.RGB_INTEGER&&(O===n.UNSIGNED_BYTE&&(te=n.RGB8UI),O===n.UNSIGNED_SHORT&&(te=n.RGB16UI),O===n.UNSIGNED_INT&&(te=n.RGB32UI),O===n.BYTE&&(te=n.RGB8I),O===n.SHORT&&(te=n.RGB16I),O===n.INT&&(te=n.RGB32I)),M===n.RGBA_INTEGER&&(O===n.UNSIGNED_BYTE&&(te=n.RGBA8UI),O===n.UNSIGNED_SHORT&&(te=n.RGBA16UI),O===n.UNSIGNED_INT&&(te=n.RGBA32UI),O===n.BYTE&&(te=n.RGBA8I),O===n.SHORT&&(te=n.RGBA16I),O===n.INT&&(te=n.RGBA32I)),M===n.RGB&&(O===n.UNSIGNED_INT_5_9_9_9_REV&&(te=n.RGB9_E5),O===n.UNSIGNED_INT_10F_11F_11F_REV&&(te=n.R11F_G11F_B10F)),M===n.RGBA){const Fe=ie?Ol:xt.getTransfer(J);O===n.FLOAT&&(te=n.RGBA32F),O===n.HALF_FLOAT&&(te=n.RGBA16F),O===n.UNSIGNED_BYTE&&(te=Fe===Dt?n.SRGB8_ALPHA8:n.RGBA8),O===n.UNSIGNED_SHORT_4_4_4_4&&(te=n.RGBA4),O===n.UNSIGNED_SHORT_5_5_5_1&&(te=n.RGB5_A1)}return(te===n.R16F||te===n.R32F||te===n.RG16F||te===n.RG32F||te===n.RGBA16F||te===n.RGBA32F)&&e.get("EXT_color_buffer_float"),te}function x(D,M){let O;return D?M===null||M===pr||M===ga?O=n.DEPTH24_STENCIL8:M===Wi?O=n.DEPTH32F_STENCIL8:M===_a&&(O=n.DEPTH24_STENCIL8,console.warn("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):M===null||M===pr||M===ga?O=n.DEPTH_COMPONENT24:M===Wi?O=n.DEPTH_COMPONENT32F:M===_a&&(O=n.DEPTH_COMPONENT16),O}function L(D,M){return m(D)===!0||D.isFramebufferTexture&&D.minFilter!==oi&&D.minFilter!==Gi?Math.log2(Math.max(M.width,M.height))+1:D.mipmaps!==void 0&&D.mipmaps.length>0?D.mipmaps.length:D.isCompressedTexture&&Array.isArray(D.image)?M.mipmaps.length:1}function A(D){const M=D.target;M.removeEventListener("dispose",A),N(M),M.isVideoTexture&&h.delete(M)}function U(D){const M=D.target;M.removeEventListener("dispose",U),E(M)}function N(D){const M=i.get(D);if(M.__webglInit===void 0)return;const O=D.source,J=d.get(O);if(J){const ie=J[M.__cacheKey];ie.usedTimes--,ie.usedTimes===0&&b(D),Object.keys(J).length===0&&d.delete(O)}i.remove(D)}function b(D){const M=i.get(D);n.deleteTexture(M.__webglTexture);const O=D.source,J=d.get(O);delete J[M.__cacheKey],o.memory.textures--}function E(D){const M=i.get(D);if(D.depthTexture&&(D.depthTexture.dispose(),i.remove(D.depthTexture)),D.isWebGLCubeRenderTarget)for(let J=0;J<6;J++){if(Array.isArray(M.__webglFramebuffer[J]))for(let ie=0;ie<M.__webglFramebuffer[J].length;ie++)n.deleteFramebuffer(M.__webglFramebuffer[J][ie]);else n.deleteFramebuffer(M.__webglFramebuffer[J]);M.__webglDepthbuffer&&n.deleteRenderbuffer(M.__webglDepthbuffer[J])}else{if(Array.isArray(M.__webglFramebuffer))for(let J=0;J<M.__webglFramebuffer.length;J++)n.deleteFramebuffer(M.__webglFramebuffer[J]);else n.deleteFramebuffer(M.__webglFramebuffer);if(M.__webglDepthbuffer&&n.deleteRenderbuffer(M.__webglDepthbuffer),M.__webglMultisampledFramebuffer&&n.deleteFramebuffer(M.__webglMultisampledFramebuffer),M.__webglColorRenderbuffer)for(let J=0;J<M.__webglColorRenderbuffer.length;J++)M.__webglColorRenderbuffer[J]&&n.deleteRenderbuffer(M.__webglColorRenderbuffer[J]);M.__webglDepthRenderbuffer&&n.deleteRenderbuffer(M.__webglDepthRenderbuffer)}const O=D.textures;for(let J=0,ie=O.length;J<ie;J++){const te=i.get(O[J]);te.__webglTexture&&(n.deleteTexture(te.__webglTexture),o.memory.textures--),i.remove(O[J])}i.remove(D)}let C=0;function B(){C=0}function z(){const D=C;return D>=s.maxTextures&&console.warn("THREE.WebGLTextures: Trying to use "+D+" texture units while this GPU supports only "+s.maxTextures),C+=1,D}function Y(D){const M=[];return M.push(D.wrapS),M.push(D.wrapT),M.push(D.wrapR||0),M.push(D.magFilter),M.push(D.minFilter),M.push(D.anisotropy),M.push(D.internalFormat),M.push(D.format),M.push(D.type),M.push(D.generateMipmaps),M.push(D.premultiplyAlpha),M.push(D.flipY),M.push(D.unpackAlignment),M.push(D.colorSpace),M.join()}function W(D,M){const O=i.get(D);if(D.isVideoTexture&&Ge(D),D.isRenderTargetTexture===!1&&D.isExternalTexture!==!0&&D.version>0&&O.__version!==D.version){const J=D.image;if(J===null)console.warn("THREE.WebGLRenderer: Texture marked for update but no image data found.");else if(J.complete===!1)console.warn("THREE.WebGLRenderer: Texture marked for update but image is incomplete");else{ee(O,D,M);return}}else D.isExternalTexture&&(O.__webglTexture=D.sourceTexture?D.sourceTexture:null);t.bindTexture(n.TEXTURE_2D,O.__webglTexture,n.TEXTURE0+M)}function j(D,M){const O=i.get(D);if(D.isRenderTargetTexture===!1&&D.version>0&&O.__version!==D.version){ee(O,D,M);return}t.bindTexture(n.TEXTURE_2D_ARRAY,O.__webglTexture,n.TEXTURE0+M)}function q(D,M){const O=i.get(D);if(D.isRenderTargetTexture===!1&&D.version>0&&O.__version!==D.version){ee(O,D,M);return}t.bindTexture(n.TEXTURE_3D,O.__webglTexture,n.TEXTURE0+M)}function K(D,M){const O=i.get(D);if(D.version>0&&O.__version!==D.version){ne(O,D,M);return}t.bindTexture(n.TEXTURE_CUBE_MAP,O.__webglTexture,n.TEXTURE0+M)}const re={[kh]:n.REPEAT,[lr]:n.CLAMP_TO_EDGE,[Bh]:n.MIRRORED_REPEAT},ae={[oi]:n.NEAREST,[Ex]:n.NEAREST_MIPMAP_NEAREST,[Fa]:n.NEAREST_MIPMAP_LINEAR,[Gi]:n.LINEAR,[Tc]:n.LINEAR_MIPMAP_NEAREST,[cr]:n.LINEAR_MIPMAP_LINEAR},me={[Ax]:n.NEVER,[Ix]:n.ALWAYS,[Rx]:n.LESS,[b_]:n.LEQUAL,[Cx]:n.EQUAL,[Lx]:n.GEQUAL,[Px]:n.GREATER,[Dx]:n.NOTEQUAL};function xe(D,M){if(M.type===Wi&&e.has("OES_texture_float_linear")===!1&&(M.magFilter===Gi||M.magFilter===Tc||M.magFilter===Fa||M.magFilter===cr||M.minFilter===Gi||M.minFilter===Tc||M.minFilter===Fa||M.minFilter===cr)&&console.warn("THREE.WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(D,n.TEXTURE_WRAP_S,re[M.wrapS]),n.texParameteri(D,n.TEXTURE_WRAP_T,re[M.wrapT]),(D===n.TEXTURE_3D||D===n.TEXTURE_2D_ARRAY)&&n.texParameteri(D,n.TEXTURE_WRAP_R,re[M.wrapR]),n.texParameteri(D,n.TEXTURE_MAG_FILTER,ae[M.magFilter]),n.texParameteri(D,n.TEXTURE_MIN_FILTER,ae[M.minFilter]),M.compareFunction&&(n.texParameteri(D,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(D,n.TEXTURE_COMPARE_FUNC,me[M.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(M.magFilter===oi||M.minFilter!==Fa&&M.minFilter!==cr||M.type===Wi&&e.has("OES_texture_float_linear")===!1)return;if(M.anisotropy>1||i.get(M).__currentAnisotropy){const O=e.get("EXT_texture_filter_anisotropic");n.texParameterf(D,O.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(M.anisotropy,s.getMaxAnisotropy())),i.get(M).__currentAnisotropy=M.anisotropy}}}function ge(D,M){let O=!1;D.__webglInit===void 0&&(D.__webglInit=!0,M.addEventListener("dispose",A));const J=M.source;let ie=d.get(J);ie===void 0&&(ie={},d.set(J,ie));const te=Y(M);if(te!==D.__cacheKey){ie[te]===void 0&&(ie[te]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,O=!0),ie[te].usedTimes++;const Fe=ie[D.__cacheKey];Fe!==void 0&&(ie[D.__cacheKey].usedTimes--,Fe.usedTimes===0&&b(M)),D.__cacheKey=te,D.__webglTexture=ie[te].texture}return O}function Qe(D,M,O){return Math.floor(Math.floor(D/O)/M)}function et(D,M,O,J){const te=D.updateRanges;if(te.length===0)t.texSubImage2D(n.TEXTURE_2D,0,0,0,M.width,M.height,O,J,M.data);else{te.sort((le,ve)=>le.start-ve.start);let Fe=0;for(let le=1;le<te.length;le++){const ve=te[Fe],Be=te[le],ke=ve.start+ve.count,ye=Qe(Be.start,M.width,4),Ze=Qe(ve.start,M.width,4);Be.start<=ke+1&&ye===Ze&&Qe(Be.start+Be.count-1,M.width,4)===ye?ve.count=Math.max(ve.count,Be.start+Be.count-ve.start):(++Fe,te[Fe]=Be)}te.length=Fe+1;const ue=n.getParameter(n.UNPACK_ROW_LENGTH),Le=n.getParameter(n.UNPACK_SKIP_PIXELS),Re=n.getParameter(n.UNPACK_SKIP_ROWS);n.pixelStorei(n.UNPACK_ROW_LENGTH,M.width);for(let le=0,ve=te.length;le<ve;le++){const Be=te[le],ke=Math.floor(Be.start/4),ye=Math.ceil(Be.count/4),Ze=ke%M.width,H=Math.floor(ke/M.width),fe=ye,pe=1;n.pixelStorei(n.UNPACK_SKIP_PIXELS,Ze),n.pixelStorei(n.UNPACK_SKIP_ROWS,H),t.texSubImage2D(n.TEXTURE_2D,0,Ze,H,fe,pe,O,J,M.data)}D.clearUpdateRanges(),n.pixelStorei(n.UNPACK_ROW_LENGTH,ue),n.pixelStorei(n.UNPACK_SKIP_PIXELS,Le),n.pixelStorei(n.UNPACK_SKIP_ROWS,Re)}}function ee(D,M,O){let J=n.TEXTURE_2D;(M.isDataArrayTexture||M.isCompressedArrayTexture)&&(J=n.TEXTURE_2D_ARRAY),M.isData3DTexture&&(J=n.TEXTURE_3D);const ie=ge(D,M),te=M.source;t.bindTexture(J,D.__webglTexture,n.TEXTURE0+O);const Fe=i.get(te);if(te.version!==Fe.__version||ie===!0){t.activeTexture(n.TEXTURE0+O);const ue=xt.getPrimaries(xt.workingColorSpace),Le=M.colorSpace===Ps?null:xt.getPrimaries(M.colorSpace),Re=M.colorSpace===Ps||ue===Le?n.NONE:n.BROWSER_DEFAULT_WEBGL;n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,M.flipY),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,M.premultiplyAlpha),n.pixelStorei(n.UNPACK_ALIGNMENT,M.unpackAlignment),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,Re);let le=v(M.image,!1,s.maxTextureSize);le=Vt(M,le);const ve=r.convert(M.format,M.colorSpace),Be=r.convert(M.type);let ke=w(M.internalFormat,ve,Be,M.colorSpace,M.isVideoTexture);xe(J,M);let ye;const Ze=M.mipmaps,H=M.isVideoTexture!==!0,fe=Fe.__version===void 0||ie===!0,pe=te.dataReady,De=L(M,le);if(M.isDepthTexture)ke=x(M.format===xa,M.type),fe&&(H?t.texStorage2D(n.TEXTURE_2D,1,ke,le.width,le.height):t.texImage2D(n.TEXTURE_2D,0,ke,le.width,le.height,0,ve,Be,null));else if(M.isDataTexture)if(Ze.length>0){H&&fe&&t.texStorage2D(n.TEXTURE_2D,De,ke,Ze[0].width,Ze[0].height);for(let he=0,oe=Ze.length;he<oe;he++)ye=Ze[he],H?pe&&t.texSubImage2D(n.TEXTURE_2D,he,0,0,ye.width,ye.height,ve,Be,ye.data):t.texImage2D(n.TEXTURE_2D,he,ke,ye.width,ye.height,0,ve,Be,ye.data);M.generateMipmaps=!1}else H?(fe&&t.texStorage2D(n.TEXTURE_2D,De,ke,le.width,le.height),pe&&et(M,le,ve,Be)):t.texImage2D(n.TEXTURE_2D,0,ke,le.width,le.height,0,ve,Be,le.data);else if(M.isCompressedTexture)if(M.isCompressedArrayTexture){H&&fe&&t.texStorage3D(n.TEXTURE_2D_ARRAY,De,ke,Ze[0].width,Ze[0].height,le.depth);for(let he=0,oe=Ze.length;he<oe;he++)if(ye=Ze[he],M.format!==Di)if(ve!==null)if(H){if(pe)if(M.layerUpdates.size>0){const Oe=cp(ye.width,ye.height,M.format,M.type);for(const nt of M.layerUpdates){const Ct=ye.data.subarray(nt*Oe/ye.data.BYTES_PER_ELEMENT,(nt+1)*Oe/ye.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,he,0,0,nt,ye.width,ye.height,1,ve,Ct)}M.clearLayerUpdates()}else t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,he,0,0,0,ye.width,ye.height,le.depth,ve,ye.data)}else t.compressedTexImage3D(n.TEXTURE_2D_ARRAY,he,ke,ye.width,ye.height,le.depth,0,ye.data,0,0);else console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else H?pe&&t.texSubImage3D(n.TEXTURE_2D_ARRAY,he,0,0,0,ye.width,ye.height,le.depth,ve,Be,ye.data):t.texImage3D(n.TEXTURE_2D_ARRAY,he,ke,ye.width,ye.height,le.depth,0,ve,Be,ye.data)}else{H&&fe&&t.texStorage2D(n.TEXTURE_2D,De,ke,Ze[0].width,Ze[0].height);for(let he=0,oe=Ze.length;he<oe;he++)ye=Ze[he],M.format!==Di?ve!==null?H?pe&&t.compressedTexSubImage2D(n.TEXTURE_2D,he,0,0,ye.width,ye.height,ve,ye.data):t.compressedTexImage2D(n.TEXTURE_2D,he,ke,ye.width,ye.height,0,ye.data):console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):H?pe&&t.texSubImage2D(n.TEXTURE_2D,he,0,0,ye.width,ye.height,ve,Be,ye.data):t.texImage2D(n.TEXTURE_2D,he,ke,ye.width,ye.height,0,ve,Be,ye.data)}else if(M.isDataArrayTexture)if(H){if(fe&&t.texStorage3D(n.TEXTURE_2D_ARRAY,De,ke,le.width,le.height,le.depth),pe)if(M.layerUpdates.size>0){const he=cp(le.width,le.height,M.format,M.type);for(const oe of M.layerUpdates){const Oe=le.data.subarray(oe*he/le.data.BYTES_PER_ELEMENT,(oe+1)*he/le.data.BYTES_PER_ELEMENT);t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,oe,le.width,le.height,1,ve,Be,Oe)}M.clearLayerUpdates()}else t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,le.width,le.height,le.depth,ve,Be,le.data)}else t.texImage3D(n.TEXTURE_2D_ARRAY,0,ke,le.width,le.height,le.depth,0,ve,Be,le.data);else if(M.isData3DTexture)H?(fe&&t.texStorage3D(n.TEXTURE_3D,De,ke,le.width,le.height,le.depth),pe&&t.texSubImage3D(n.TEXTURE_3D,0,0,0,0,le.width,le.height,le.depth,ve,Be,le.data)):t.texImage3D(n.TEXTURE_3D,0,ke,le.width,le.height,le.depth,0,ve,Be,le.data);else if(M.isFramebufferTexture){if(fe)if(H)t.texStorage2D(n.TEXTURE_2D,De,ke,le.width,le.height);else{let he=le.width,oe=le.height;for(let Oe=0;Oe<De;Oe++)t.texImage2D(n.TEXTURE_2D,Oe,ke,he,oe,0,ve,Be,null),he>>=1,oe>>=1}}else if(Ze.length>0){if(H&&fe){const he=yt(Ze[0]);t.texStorage2D(n.TEXTURE_2D,De,ke,he.width,he.height)}for(let he=0,oe=Ze.length;he<oe;he++)ye=Ze[he],H?pe&&t.texSubImage2D(n.TEXTURE_2D,he,0,0,ve,Be,ye):t.texImage2D(n.TEXTURE_2D,he,ke,ve,Be,ye);M.generateMipmaps=!1}else if(H){if(fe){const he=yt(le);t.texStorage2D(n.TEXTURE_2D,De,ke,he.width,he.height)}pe&&t.texSubImage2D(n.TEXTURE_2D,0,0,0,ve,Be,le)}else t.texImage2D(n.TEXTURE_2D,0,ke,ve,Be,le);m(M)&&p(J),Fe.__version=te.version,M.onUpdate&&M.onUpdate(M)}D.__version=M.version}function ne(D,M,O){if(M.image.length!==6)return;const J=ge(D,M),ie=M.source;t.bindTexture(n.TEXTURE_CUBE_MAP,D.__webglTexture,n.TEXTURE0+O);const te=i.get(ie);if(ie.version!==te.__version||J===!0){t.activeTexture(n.TEXTURE0+O);const Fe=xt.getPrimaries(xt.workingColorSpace),ue=M.colorSpace===Ps?null:xt.getPrimaries(M.colorSpace),Le=M.colorSpace===Ps||Fe===ue?n.NONE:n.BROWSER_DEFAULT_WEBGL;n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,M.flipY),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,M.premultiplyAlpha),n.pixelStorei(n.UNPACK_ALIGNMENT,M.unpackAlignment),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,Le);const Re=M.isCompressedTexture||M.image[0].isCompressedTexture,le=M.image[0]&&M.image[0].isDataTexture,ve=[];for(let oe=0;oe<6;oe++)!Re&&!le?ve[oe]=v(M.image[oe],!0,s.maxCubemapSize):ve[oe]=le?M.image[oe].image:M.image[oe],ve[oe]=Vt(M,ve[oe]);const Be=ve[0],ke=r.convert(M.format,M.colorSpace),ye=r.convert(M.type),Ze=w(M.internalFormat,ke,ye,M.colorSpace),H=M.isVideoTexture!==!0,fe=te.__version===void 0||J===!0,pe=ie.dataReady;let De=L(M,Be);xe(n.TEXTURE_CUBE_MAP,M);let he;if(Re){H&&fe&&t.texStorage2D(n.TEXTURE_CUBE_MAP,De,Ze,Be.width,Be.height);for(let oe=0;oe<6;oe++){he=ve[oe].mipmaps;for(let Oe=0;Oe<he.length;Oe++){const nt=he[Oe];M.format!==Di?ke!==null?H?pe&&t.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+oe,Oe,0,0,nt.width,nt.height,ke,nt.data):t.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+oe,Oe,Ze,nt.width,nt.height,0,nt.data):console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):H?pe&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+oe,Oe,0,0,nt.width,nt.height,ke,ye,nt.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+oe,Oe,Ze,nt.width,nt.height,0,ke,ye,nt.data)}}}else{if(he=M.mipmaps,H&&fe){he.length>0&&De++;const oe=yt(ve[0]);t.texStorage2D(n.TEXTURE_CUBE_MAP,De,Ze,oe.width,oe.height)}for(let oe=0;oe<6;oe++)if(le){H?pe&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+oe,0,0,0,ve[oe].width,ve[oe].height,ke,ye,ve[oe].data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+oe,0,Ze,ve[oe].width,ve[oe].height,0,ke,ye,ve[oe].data);for(let Oe=0;Oe<he.length;Oe++){const Ct=he[Oe].image[oe].image;H?pe&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+oe,Oe+1,0,0,Ct.width,Ct.height,ke,ye,Ct.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+oe,Oe+1,Ze,Ct.width,Ct.height,0,ke,ye,Ct.data)}}else{H?pe&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+oe,0,0,0,ke,ye,ve[oe]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+oe,0,Ze,ke,ye,ve[oe]);for(let Oe=0;Oe<he.length;Oe++){const nt=he[Oe];H?pe&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+oe,Oe+1,0,0,ke,ye,nt.image[oe]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+oe,Oe+1,Ze,ke,ye,nt.image[oe])}}}m(M)&&p(n.TEXTURE_CUBE_MAP),te.__version=ie.version,M.onUpdate&&M.onUpdate(M)}D.__version=M.version}function we(D,M,O,J,ie,te){const Fe=r.convert(O.format,O.colorSpace),ue=r.convert(O.type),Le=w(O.internalFormat,Fe,ue,O.colorSpace),Re=i.get(M),le=i.get(O);if(le.__renderTarget=M,!Re.__hasExternalTextures){const ve=Math.max(1,M.width>>te),Be=Math.max(1,M.height>>te);ie===n.TEXTURE_3D||ie===n.TEXTURE_2D_ARRAY?t.texImage3D(ie,te,Le,ve,Be,M.depth,0,Fe,ue,null):t.texImage2D(ie,te,Le,ve,Be,0,Fe,ue,null)}t.bindFramebuffer(n.FRAMEBUFFER,D),Pe(M)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,J,ie,le.__webglTexture,0,Tt(M)):(ie===n.TEXTURE_2D||ie>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&ie<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,J,ie,le.__webglTexture,te),t.bindFramebuffer(n.FRAMEBUFFER,null)}function ze(D,M,O){if(n.bindRenderbuffer(n.RENDERBUFFER,D),M.depthBuffer){const J=M.depthTexture,ie=J&&J.isDepthTexture?J.type:null,te=x(M.stencilBuffer,ie),Fe=M.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,ue=Tt(M);Pe(M)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,ue,te,M.width,M.height):O?n.renderbufferStorageMultisample(n.RENDERBUFFER,ue,te,M.width,M.height):n.renderbufferStorage(n.RENDERBUFFER,te,M.width,M.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,Fe,n.RENDERBUFFER,D)}else{const J=M.textures;for(let ie=0;ie<J.length;ie++){const te=J[ie],Fe=r.convert(te.format,te.colorSpace),ue=r.convert(te.type),Le=w(te.internalFormat,Fe,ue,te.colorSpace),Re=Tt(M);O&&Pe(M)===!1?n.renderbufferStorageMultisample(n.RENDERBUFFER,Re,Le,M.width,M.height):Pe(M)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,Re,Le,M.width,M.height):n.renderbufferStorage(n.RENDERBUFFER,Le,M.width,M.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function Me(D,M){if(M&&M.isWebGLCubeRenderTarget)throw new Error("Depth Texture with cube render targets is not supported");if(t.bindFramebuffer(n.FRAMEBUFFER,D),!(M.depthTexture&&M.depthTexture.isDepthTexture))throw new Error("renderTarget.depthTexture must be an instance of THREE.DepthTexture");const J=i.get(M.depthTexture);J.__renderTarget=M,(!J.__webglTexture||M.depthTexture.image.width!==M.width||M.depthTexture.image.height!==M.height)&&(M.depthTexture.image.width=M.width,M.depthTexture.image.height=M.height,M.depthTexture.needsUpdate=!0),W(M.depthTexture,0);const ie=J.__webglTexture,te=Tt(M);if(M.depthTexture.format===va)Pe(M)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,n.DEPTH_ATTACHMENT,n.TEXTURE_2D,ie,0,te):n.framebufferTexture2D(n.FRAMEBUFFER,n.DEPTH_ATTACHMENT,n.TEXTURE_2D,ie,0);else if(M.depthTexture.format===xa)Pe(M)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,n.DEPTH_STENCIL_ATTACHMENT,n.TEXTURE_2D,ie,0,te):n.framebufferTexture2D(n.FRAMEBUFFER,n.DEPTH_STENCIL_ATTACHMENT,n.TEXTURE_2D,ie,0);else throw new Error("Unknown depthTexture format")}function tt(D){const M=i.get(D),O=D.isWebGLCubeRenderTarget===!0;if(M.__boundDepthTexture!==D.depthTexture){const J=D.depthTexture;if(M.__depthDisposeCallback&&M.__depthDisposeCallback(),J){const ie=()=>{delete M.__boundDepthTexture,delete M.__depthDisposeCallback,J.removeEventListener("dispose",ie)};J.addEventListener("dispose",ie),M.__depthDisposeCallback=ie}M.__boundDepthTexture=J}if(D.depthTexture&&!M.__autoAllocateDepthBuffer){if(O)throw new Error("target.depthTexture not supported in Cube render targets");const J=D.texture.mipmaps;J&&J.length>0?Me(M.__webglFramebuffer[0],D):Me(M.__webglFramebuffer,D)}else if(O){M.__webglDepthbuffer=[];for(let J=0;J<6;J++)if(t.bindFramebuffer(n.FRAMEBUFFER,M.__webglFramebuffer[J]),M.__webglDepthbuffer[J]===void 0)M.__webglDepthbuffer[J]=n.createRenderbuffer(),ze(M.__webglDepthbuffer[J],D,!1);else{const ie=D.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,te=M.__webglDepthbuffer[J];n.bindRenderbuffer(n.RENDERBUFFER,te),n.framebufferRenderbuffer(n.FRAMEBUFFER,ie,n.RENDERBUFFER,te)}}else{const J=D.texture.mipmaps;if(J&&J.length>0?t.bindFramebuffer(n.FRAMEBUFFER,M.__webglFramebuffer[0]):t.bindFramebuffer(n.FRAMEBUFFER,M.__webglFramebuffer),M.__webglDepthbuffer===void 0)M.__webglDepthbuffer=n.createRenderbuffer(),ze(M.__webglDepthbuffer,D,!1);else{const ie=D.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,te=M.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,te),n.framebufferRenderbuffer(n.FRAMEBUFFER,ie,n.RENDERBUFFER,te)}}t.bindFramebuffer(n.FRAMEBUFFER,null)}function kt(D,M,O){const J=i.get(D);M!==void 0&&we(J.__webglFramebuffer,D,D.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),O!==void 0&&tt(D)}function F(D){const M=D.texture,O=i.get(D),J=i.get(M);D.addEventListener("dispose",U);const ie=D.textures,te=D.isWebGLCubeRenderTarget===!0,Fe=ie.length>1;if(Fe||(J.__webglTexture===void 0&&(J.__webglTexture=n.createTexture()),J.__version=M.version,o.memory.textures++),te){O.__webglFramebuffer=[];for(let ue=0;ue<6;ue++)if(M.mipmaps&&M.mipmaps.length>0){O.__webglFramebuffer[ue]=[];for(let Le=0;Le<M.mipmaps.length;Le++)O.__webglFramebuffer[ue][Le]=n.createFramebuffer()}else O.__webglFramebuffer[ue]=n.createFramebuffer()}else{if(M.mipmaps&&M.mipmaps.length>0){O.__webglFramebuffer=[];for(let ue=0;ue<M.mipmaps.length;ue++)O.__webglFramebuffer[ue]=n.createFramebuffer()}else O.__webglFramebuffer=n.createFramebuffer();if(Fe)for(let ue=0,Le=ie.length;ue<Le;ue++){const Re=i.get(ie[ue]);Re.__webglTexture===void 0&&(Re.__webglTexture=n.createTexture(),o.memory.textures++)}if(D.samples>0&&Pe(D)===!1){O.__webglMultisampledFramebuffer=n.createFramebuffer(),O.__webglColorRenderbuffer=[],t.bindFramebuffer(n.FRAMEBUFFER,O.__webglMultisampledFramebuffer);for(let ue=0;ue<ie.length;ue++){const Le=ie[ue];O.__webglColorRenderbuffer[ue]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,O.__webglColorRenderbuffer[ue]);const Re=r.convert(Le.format,Le.colorSpace),le=r.convert(Le.type),ve=w(Le.internalFormat,Re,le,Le.colorSpace,D.isXRRenderTarget===!0),Be=Tt(D);n.renderbufferStorageMultisample(n.RENDERBUFFER,Be,ve,D.width,D.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+ue,n.RENDERBUFFER,O.__webglColorRenderbuffer[ue])}n.bindRenderbuffer(n.RENDERBUFFER,null),D.depthBuffer&&(O.__webglDepthRenderbuffer=n.createRenderbuffer(),ze(O.__webglDepthRenderbuffer,D,!0)),t.bindFramebuffer(n.FRAMEBUFFER,null)}}if(te){t.bindTexture(n.TEXTURE_CUBE_MAP,J.__webglTexture),xe(n.TEXTURE_CUBE_MAP,M);for(let ue=0;ue<6;ue++)if(M.mipmaps&&M.mipmaps.length>0)for(let Le=0;Le<M.mipmaps.length;Le++)we(O.__webglFramebuffer[ue][Le],D,M,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+ue,Le);else we(O.__webglFramebuffer[ue],D,M,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+ue,0);m(M)&&p(n.TEXTURE_CUBE_MAP),t.unbindTexture()}else if(Fe){for(let ue=0,Le=ie.length;ue<Le;ue++){const Re=ie[ue],le=i.get(Re);let ve=n.TEXTURE_2D;(D.isWebGL3DRenderTarget||D.isWebGLArrayRenderTarget)&&(ve=D.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(ve,le.__webglTexture),xe(ve,Re),we(O.__webglFramebuffer,D,Re,n.COLOR_ATTACHMENT0+ue,ve,0),m(Re)&&p(ve)}t.unbindTexture()}else{let ue=n.TEXTURE_2D;if((D.isWebGL3DRenderTarget||D.isWebGLArrayRenderTarget)&&(ue=D.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(ue,J.__webglTexture),xe(ue,M),M.mipmaps&&M.mipmaps.length>0)for(let Le=0;Le<M.mipmaps.length;Le++)we(O.__webglFramebuffer[Le],D,M,n.COLOR_ATTACHMENT0,ue,Le);else we(O.__webglFramebuffer,D,M,n.COLOR_ATTACHMENT0,ue,0);m(M)&&p(ue),t.unbindTexture()}D.depthBuffer&&tt(D)}function mt(D){const M=D.textures;for(let O=0,J=M.length;O<J;O++){const ie=M[O];if(m(ie)){const te=y(D),Fe=i.get(ie).__webglTexture;t.bindTexture(te,Fe),p(te),t.unbindTexture()}}}const $e=[],We=[];function Ne(D){if(D.samples>0){if(Pe(D)===!1){const M=D.textures,O=D.width,J=D.height;let ie=n.COLOR_BUFFER_BIT;const te=D.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,Fe=i.get(D),ue=M.length>1;if(ue)for(let Re=0;Re<M.length;Re++)t.bindFramebuffer(n.FRAMEBUFFER,Fe.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+Re,n.RENDERBUFFER,null),t.bindFramebuffer(n.FRAMEBUFFER,Fe.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+Re,n.TEXTURE_2D,null,0);t.bindFramebuffer(n.READ_FRAMEBUFFER,Fe.__webglMultisampledFramebuffer);const Le=D.texture.mipmaps;Le&&Le.length>0?t.bindFramebuffer(n.DRAW_FRAMEBUFFER,Fe.__webglFramebuffer[0]):t.bindFramebuffer(n.DRAW_FRAMEBUFFER,Fe.__webglFramebuffer);for(let Re=0;Re<M.length;Re++){if(D.resolveDepthBuffer&&(D.depthBuffer&&(ie|=n.DEPTH_BUFFER_BIT),D.stencilBuffer&&D.resolveStencilBuffer&&(ie|=n.STENCIL_BUFFER_BIT)),ue){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,Fe.__webglColorRenderbuffer[Re]);const le=i.get(M[Re]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,le,0)}n.blitFramebuffer(0,0,O,J,0,0,O,J,ie,n.NEAREST),l===!0&&($e.length=0,We.length=0,$e.push(n.COLOR_ATTACHMENT0+Re),D.depthBuffer&&D.resolveDepthBuffer===!1&&($e.push(te),We.push(te),n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,We)),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,$e))}if(t.bindFramebuffer(n.READ_FRAMEBUFFER,null),t.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),ue)for(let Re=0;Re<M.length;Re++){t.bindFramebuffer(n.FRAMEBUFFER,Fe.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+Re,n.RENDERBUFFER,Fe.__webglColorRenderbuffer[Re]);const le=i.get(M[Re]).__webglTexture;t.bindFramebuffer(n.FRAMEBUFFER,Fe.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+Re,n.TEXTURE_2D,le,0)}t.bindFramebuffer(n.DRAW_FRAMEBUFFER,Fe.__webglMultisampledFramebuffer)}else if(D.depthBuffer&&D.resolveDepthBuffer===!1&&l){const M=D.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[M])}}}function Tt(D){return Math.min(s.maxSamples,D.samples)}function Pe(D){const M=i.get(D);return D.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&M.__useRenderToTexture!==!1}function Ge(D){const M=o.render.frame;h.get(D)!==M&&(h.set(D,M),D.update())}function Vt(D,M){const O=D.colorSpace,J=D.format,ie=D.type;return D.isCompressedTexture===!0||D.isVideoTexture===!0||O!==uo&&O!==Ps&&(xt.getTransfer(O)===Dt?(J!==Di||ie!==qi)&&console.warn("THREE.WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):console.error("THREE.WebGLTextures: Unsupported texture color space:",O)),M}function yt(D){return typeof HTMLImageElement<"u"&&D instanceof HTMLImageElement?(c.width=D.naturalWidth||D.width,c.height=D.naturalHeight||D.height):typeof VideoFrame<"u"&&D instanceof VideoFrame?(c.width=D.displayWidth,c.height=D.displayHeight):(c.width=D.width,c.height=D.height),c}this.allocateTextureUnit=z,this.resetTextureUnits=B,this.setTexture2D=W,this.setTexture2DArray=j,this.setTexture3D=q,this.setTextureCube=K,this.rebindTextures=kt,this.setupRenderTarget=F,this.updateRenderTargetMipmap=mt,this.updateMultisampleRenderTarget=Ne,this.setupDepthRenderbuffer=tt,this.setupFrameBufferTexture=we,this.useMultisampledRTT=Pe}function tw(n,e){function t(i,s=Ps){let r;const o=xt.getTransfer(s);if(i===qi)return n.UNSIGNED_BYTE;if(i===Yu)return n.UNSIGNED_SHORT_4_4_4_4;if(i===qu)return n.UNSIGNED_SHORT_5_5_5_1;if(i===x_)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===M_)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===g_)return n.BYTE;if(i===v_)return n.SHORT;if(i===_a)return n.UNSIGNED_SHORT;if(i===Xu)return n.INT;if(i===pr)return n.UNSIGNED_INT;if(i===Wi)return n.FLOAT;if(i===Sa)return n.HALF_FLOAT;if(i===y_)return n.ALPHA;if(i===S_)return n.RGB;if(i===Di)return n.RGBA;if(i===va)return n.DEPTH_COMPONENT;if(i===xa)return n.DEPTH_STENCIL;if(i===$u)return n.RED;if(i===ju)return n.RED_INTEGER;if(i===E_)return n.RG;if(i===Zu)return n.RG_INTEGER;if(i===Ku)return n.RGBA_INTEGER;if(i===gl||i===vl||i===xl||i===Ml)if(o===Dt)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===gl)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===vl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===xl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===Ml)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===gl)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===vl)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===xl)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===Ml)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===zh||i===Hh||i===Vh||i===Gh)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===zh)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===Hh)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===Vh)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===Gh)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===Wh||i===Xh||i===Yh)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(i===Wh||i===Xh)return o===Dt?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===Yh)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC}else return null;if(i===qh||i===$h||i===jh||i===Zh||i===Kh||i===Jh||i===Qh||i===eu||i===tu||i===nu||i===iu||i===su||i===ru||i===ou)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(i===qh)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===$h)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===jh)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===Zh)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===Kh)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===Jh)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===Qh)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===eu)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===tu)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===nu)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===iu)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===su)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===ru)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===ou)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===au||i===lu||i===cu)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(i===au)return o===Dt?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===lu)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===cu)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===hu||i===uu||i===fu||i===du)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(i===hu)return r.COMPRESSED_RED_RGTC1_EXT;if(i===uu)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===fu)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===du)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===ga?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:t}}const nw=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,iw=`
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

}`;class sw{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){const i=new U_(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=i}}getMesh(e){if(this.texture!==null&&this.mesh===null){const t=e.cameras[0].viewport,i=new hs({vertexShader:nw,fragmentShader:iw,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new be(new Is(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}}class rw extends vr{constructor(e,t){super();const i=this;let s=null,r=1,o=null,a="local-floor",l=1,c=null,h=null,f=null,d=null,u=null,_=null;const v=typeof XRWebGLBinding<"u",m=new sw,p={},y=t.getContextAttributes();let w=null,x=null;const L=[],A=[],U=new Ke;let N=null;const b=new _i;b.viewport=new en;const E=new _i;E.viewport=new en;const C=[b,E],B=new TM;let z=null,Y=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(ee){let ne=L[ee];return ne===void 0&&(ne=new $c,L[ee]=ne),ne.getTargetRaySpace()},this.getControllerGrip=function(ee){let ne=L[ee];return ne===void 0&&(ne=new $c,L[ee]=ne),ne.getGripSpace()},this.getHand=function(ee){let ne=L[ee];return ne===void 0&&(ne=new $c,L[ee]=ne),ne.getHandSpace()};function W(ee){const ne=A.indexOf(ee.inputSource);if(ne===-1)return;const we=L[ne];we!==void 0&&(we.update(ee.inputSource,ee.frame,c||o),we.dispatchEvent({type:ee.type,data:ee.inputSource}))}function j(){s.removeEventListener("select",W),s.removeEventListener("selectstart",W),s.removeEventListener("selectend",W),s.removeEventListener("squeeze",W),s.removeEventListener("squeezestart",W),s.removeEventListener("squeezeend",W),s.removeEventListener("end",j),s.removeEventListener("inputsourceschange",q);for(let ee=0;ee<L.length;ee++){const ne=A[ee];ne!==null&&(A[ee]=null,L[ee].disconnect(ne))}z=null,Y=null,m.reset();for(const ee in p)delete p[ee];e.setRenderTarget(w),u=null,d=null,f=null,s=null,x=null,et.stop(),i.isPresenting=!1,e.setPixelRatio(N),e.setSize(U.width,U.height,!1),i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(ee){r=ee,i.isPresenting===!0&&console.warn("THREE.WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(ee){a=ee,i.isPresenting===!0&&console.warn("THREE.WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(ee){c=ee},this.getBaseLayer=function(){return d!==null?d:u},this.getBinding=function(){return f===null&&v&&(f=new XRWebGLBinding(s,t)),f},this.getFrame=function(){return _},this.getSession=function(){return s},this.setSession=async function(ee){if(s=ee,s!==null){if(w=e.getRenderTarget(),s.addEventListener("select",W),s.addEventListener("selectstart",W),s.addEventListener("selectend",W),s.addEventListener("squeeze",W),s.addEventListener("squeezestart",W),s.addEventListener("squeezeend",W),s.addEventListener("end",j),s.addEventListener("inputsourceschange",q),y.xrCompatible!==!0&&await t.makeXRCompatible(),N=e.getPixelRatio(),e.getSize(U),v&&"createProjectionLayer"in XRWebGLBinding.prototype){let we=null,ze=null,Me=null;y.depth&&(Me=y.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,we=y.stencil?xa:va,ze=y.stencil?ga:pr);const tt={colorFormat:t.RGBA8,depthFormat:Me,scaleFactor:r};f=this.getBinding(),d=f.createProjectionLayer(tt),s.updateRenderState({layers:[d]}),e.setPixelRatio(1),e.setSize(d.textureWidth,d.textureHeight,!1),x=new mr(d.textureWidth,d.textureHeight,{format:Di,type:qi,depthTexture:new I_(d.textureWidth,d.textureHeight,ze,void 0,void 0,void 0,void 0,void 0,void 0,we),stencilBuffer:y.stencil,colorSpace:e.outputColorSpace,samples:y.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1})}else{const we={antialias:y.antialias,alpha:!0,depth:y.depth,stencil:y.stencil,framebufferScaleFactor:r};u=new XRWebGLLayer(s,t,we),s.updateRenderState({baseLayer:u}),e.setPixelRatio(1),e.setSize(u.framebufferWidth,u.framebufferHeight,!1),x=new mr(u.framebufferWidth,u.framebufferHeight,{format:Di,type:qi,colorSpace:e.outputColorSpace,stencilBuffer:y.stencil,resolveDepthBuffer:u.ignoreDepthValues===!1,resolveStencilBuffer:u.ignoreDepthValues===!1})}x.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),et.setContext(s),et.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return m.getDepthTexture()};function q(ee){for(let ne=0;ne<ee.removed.length;ne++){const we=ee.removed[ne],ze=A.indexOf(we);ze>=0&&(A[ze]=null,L[ze].disconnect(we))}for(let ne=0;ne<ee.added.length;ne++){const we=ee.added[ne];let ze=A.indexOf(we);if(ze===-1){for(let tt=0;tt<L.length;tt++)if(tt>=A.length){A.push(we),ze=tt;break}else if(A[tt]===null){A[tt]=we,ze=tt;break}if(ze===-1)break}const Me=L[ze];Me&&Me.connect(we)}}const K=new k,re=new k;function ae(ee,ne,we){K.setFromMatrixPosition(ne.matrixWorld),re.setFromMatrixPosition(we.matrixWorld);const ze=K.distanceTo(re),Me=ne.projectionMatrix.elements,tt=we.projectionMatrix.elements,kt=Me[14]/(Me[10]-1),F=Me[14]/(Me[10]+1),mt=(Me[9]+1)/Me[5],$e=(Me[9]-1)/Me[5],We=(Me[8]-1)/Me[0],Ne=(tt[8]+1)/tt[0],Tt=kt*We,Pe=kt*Ne,Ge=ze/(-We+Ne),Vt=Ge*-We;if(ne.matrixWorld.decompose(ee.position,ee.quaternion,ee.scale),ee.translateX(Vt),ee.translateZ(Ge),ee.matrixWorld.compose(ee.position,ee.quaternion,ee.scale),ee.matrixWorldInverse.copy(ee.matrixWorld).invert(),Me[10]===-1)ee.projectionMatrix.copy(ne.projectionMatrix),ee.projectionMatrixInverse.copy(ne.projectionMatrixInverse);else{const yt=kt+Ge,D=F+Ge,M=Tt-Vt,O=Pe+(ze-Vt),J=mt*F/D*yt,ie=$e*F/D*yt;ee.projectionMatrix.makePerspective(M,O,J,ie,yt,D),ee.projectionMatrixInverse.copy(ee.projectionMatrix).invert()}}function me(ee,ne){ne===null?ee.matrixWorld.copy(ee.matrix):ee.matrixWorld.multiplyMatrices(ne.matrixWorld,ee.matrix),ee.matrixWorldInverse.copy(ee.matrixWorld).invert()}this.updateCamera=function(ee){if(s===null)return;let ne=ee.near,we=ee.far;m.texture!==null&&(m.depthNear>0&&(ne=m.depthNear),m.depthFar>0&&(we=m.depthFar)),B.near=E.near=b.near=ne,B.far=E.far=b.far=we,(z!==B.near||Y!==B.far)&&(s.updateRenderState({depthNear:B.near,depthFar:B.far}),z=B.near,Y=B.far),B.layers.mask=ee.layers.mask|6,b.layers.mask=B.layers.mask&3,E.layers.mask=B.layers.mask&5;const ze=ee.parent,Me=B.cameras;me(B,ze);for(let tt=0;tt<Me.length;tt++)me(Me[tt],ze);Me.length===2?ae(B,b,E):B.projectionMatrix.copy(b.projectionMatrix),xe(ee,B,ze)};function xe(ee,ne,we){we===null?ee.matrix.copy(ne.matrixWorld):(ee.matrix.copy(we.matrixWorld),ee.matrix.invert(),ee.matrix.multiply(ne.matrixWorld)),ee.matrix.decompose(ee.position,ee.quaternion,ee.scale),ee.updateMatrixWorld(!0),ee.projectionMatrix.copy(ne.projectionMatrix),ee.projectionMatrixInverse.copy(ne.projectionMatrixInverse),ee.isPerspectiveCamera&&(ee.fov=pu*2*Math.atan(1/ee.projectionMatrix.elements[5]),ee.zoom=1)}this.getCamera=function(){return B},this.getFoveation=function(){if(!(d===null&&u===null))return l},this.setFoveation=function(ee){l=ee,d!==null&&(d.fixedFoveation=ee),u!==null&&u.fixedFoveation!==void 0&&(u.fixedFoveation=ee)},this.hasDepthSensing=function(){return m.texture!==null},this.getDepthSensingMesh=function(){return m.getMesh(B)},this.getCameraTexture=function(ee){return p[ee]};let ge=null;function Qe(ee,ne){if(h=ne.getViewerPose(c||o),_=ne,h!==null){const we=h.views;u!==null&&(e.setRenderTargetFramebuffer(x,u.framebuffer),e.setRenderTarget(x));let ze=!1;we.length!==B.cameras.length&&(B.cameras.length=0,ze=!0);for(let F=0;F<we.length;F++){const mt=we[F];let $e=null;if(u!==null)$e=u.getViewport(mt);else{const Ne=f.getViewSubImage(d,mt);$e=Ne.viewport,F===0&&(e.setRenderTargetTextures(x,Ne.colorTexture,Ne.depthStencilTexture),e.setRenderTarget(x))}let We=C[F];We===void 0&&(We=new _i,We.layers.enable(F),We.viewport=new en,C[F]=We),We.matrix.fromArray(mt.transform.matrix),We.matrix.decompose(We.position,We.quaternion,We.scale),We.projectionMatrix.fromArray(mt.projectionMatrix),We.projectionMatrixInverse.copy(We.projectionMatrix).invert(),We.viewport.set($e.x,$e.y,$e.width,$e.height),F===0&&(B.matrix.copy(We.matrix),B.matrix.decompose(B.position,B.quaternion,B.scale)),ze===!0&&B.cameras.push(We)}const Me=s.enabledFeatures;if(Me&&Me.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&v){f=i.getBinding();const F=f.getDepthInformation(we[0]);F&&F.isValid&&F.texture&&m.init(F,s.renderState)}if(Me&&Me.includes("camera-access")&&v){e.state.unbindTexture(),f=i.getBinding();for(let F=0;F<we.length;F++){const mt=we[F].camera;if(mt){let $e=p[mt];$e||($e=new U_,p[mt]=$e);const We=f.getCameraImage(mt);$e.sourceTexture=We}}}}for(let we=0;we<L.length;we++){const ze=A[we],Me=L[we];ze!==null&&Me!==void 0&&Me.update(ze,ne,c||o)}ge&&ge(ee,ne),ne.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:ne}),_=null}const et=new B_;et.setAnimationLoop(Qe),this.setAnimationLoop=function(ee){ge=ee},this.dispose=function(){}}}const Zs=new Mi,ow=new Rt;function aw(n,e){function t(m,p){m.matrixAutoUpdate===!0&&m.updateMatrix(),p.value.copy(m.matrix)}function i(m,p){p.color.getRGB(m.fogColor.value,P_(n)),p.isFog?(m.fogNear.value=p.near,m.fogFar.value=p.far):p.isFogExp2&&(m.fogDensity.value=p.density)}function s(m,p,y,w,x){p.isMeshBasicMaterial||p.isMeshLambertMaterial?r(m,p):p.isMeshToonMaterial?(r(m,p),f(m,p)):p.isMeshPhongMaterial?(r(m,p),h(m,p)):p.isMeshStandardMaterial?(r(m,p),d(m,p),p.isMeshPhysicalMaterial&&u(m,p,x)):p.isMeshMatcapMaterial?(r(m,p),_(m,p)):p.isMeshDepthMaterial?r(m,p):p.isMeshDistanceMaterial?(r(m,p),v(m,p)):p.isMeshNormalMaterial?r(m,p):p.isLineBasicMaterial?(o(m,p),p.isLineDashedMaterial&&a(m,p)):p.isPointsMaterial?l(m,p,y,w):p.isSpriteMaterial?c(m,p):p.isShadowMaterial?(m.color.value.copy(p.color),m.opacity.value=p.opacity):p.isShaderMaterial&&(p.uniformsNeedUpdate=!1)}function r(m,p){m.opacity.value=p.opacity,p.color&&m.diffuse.value.copy(p.color),p.emissive&&m.emissive.value.copy(p.emissive).multiplyScalar(p.emissiveIntensity),p.map&&(m.map.value=p.map,t(p.map,m.mapTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,t(p.alphaMap,m.alphaMapTransform)),p.bumpMap&&(m.bumpMap.value=p.bumpMap,t(p.bumpMap,m.bumpMapTransform),m.bumpScale.value=p.bumpScale,p.side===Kn&&(m.bumpScale.value*=-1)),p.normalMap&&(m.normalMap.value=p.normalMap,t(p.normalMap,m.normalMapTransform),m.normalScale.value.copy(p.normalScale),p.side===Kn&&m.normalScale.value.negate()),p.displacementMap&&(m.displacementMap.value=p.displacementMap,t(p.displacementMap,m.displacementMapTransform),m.displacementScale.value=p.displacementScale,m.displacementBias.value=p.displacementBias),p.emissiveMap&&(m.emissiveMap.value=p.emissiveMap,t(p.emissiveMap,m.emissiveMapTransform)),p.specularMap&&(m.specularMap.value=p.specularMap,t(p.specularMap,m.specularMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest);const y=e.get(p),w=y.envMap,x=y.envMapRotation;w&&(m.envMap.value=w,Zs.copy(x),Zs.x*=-1,Zs.y*=-1,Zs.z*=-1,w.isCubeTexture&&w.isRenderTargetTexture===!1&&(Zs.y*=-1,Zs.z*=-1),m.envMapRotation.value.setFromMatrix4(ow.makeRotationFromEuler(Zs)),m.flipEnvMap.value=w.isCubeTexture&&w.isRenderTargetTexture===!1?-1:1,m.reflectivity.value=p.reflectivity,m.ior.value=p.ior,m.refractionRatio.value=p.refractionRatio),p.lightMap&&(m.lightMap.value=p.lightMap,m.lightMapIntensity.value=p.lightMapIntensity,t(p.lightMap,m.lightMapTransform)),p.aoMap&&(m.aoMap.value=p.aoMap,m.aoMapIntensity.value=p.aoMapIntensity,t(p.aoMap,m.aoMapTransform))}function o(m,p){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,p.map&&(m.map.value=p.map,t(p.map,m.mapTransform))}function a(m,p){m.dashSize.value=p.dashSize,m.totalSize.value=p.dashSize+p.gapSize,m.scale.value=p.scale}function l(m,p,y,w){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,m.size.value=p.size*y,m.scale.value=w*.5,p.map&&(m.map.value=p.map,t(p.map,m.uvTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,t(p.alphaMap,m.alphaMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest)}function c(m,p){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,m.rotation.value=p.rotation,p.map&&(m.map.value=p.map,t(p.map,m.mapTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,t(p.alphaMap,m.alphaMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest)}function h(m,p){m.specular.value.copy(p.specular),m.shininess.value=Math.max(p.shininess,1e-4)}function f(m,p){p.gradientMap&&(m.gradientMap.value=p.gradientMap)}function d(m,p){m.metalness.value=p.metalness,p.metalnessMap&&(m.metalnessMap.value=p.metalnessMap,t(p.metalnessMap,m.metalnessMapTransform)),m.roughness.value=p.roughness,p.roughnessMap&&(m.roughnessMap.value=p.roughnessMap,t(p.roughnessMap,m.roughnessMapTransform)),p.envMap&&(m.envMapIntensity.value=p.envMapIntensity)}function u(m,p,y){m.ior.value=p.ior,p.sheen>0&&(m.sheenColor.value.copy(p.sheenColor).multiplyScalar(p.sheen),m.sheenRoughness.value=p.sheenRoughness,p.sheenColorMap&&(m.sheenColorMap.value=p.sheenColorMap,t(p.sheenColorMap,m.sheenColorMapTransform)),p.sheenRoughnessMap&&(m.sheenRoughnessMap.value=p.sheenRoughnessMap,t(p.sheenRoughnessMap,m.sheenRoughnessMapTransform))),p.clearcoat>0&&(m.clearcoat.value=p.clearcoat,m.clearcoatRoughness.value=p.clearcoatRoughness,p.clearcoatMap&&(m.clearcoatMap.value=p.clearcoatMap,t(p.clearcoatMap,m.clearcoatMapTransform)),p.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=p.clearcoatRoughnessMap,t(p.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),p.clearcoatNormalMap&&(m.clearcoatNormalMap.value=p.clearcoatNormalMap,t(p.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(p.clearcoatNormalScale),p.side===Kn&&m.clearcoatNormalScale.value.negate())),p.dispersion>0&&(m.dispersion.value=p.dispersion),p.iridescence>0&&(m.iridescence.value=p.iridescence,m.iridescenceIOR.value=p.iridescenceIOR,m.iridescenceThicknessMinimum.value=p.iridescenceThicknessRange[0],m.iridescenceThicknessMaximum.value=p.iridescenceThicknessRange[1],p.iridescenceMap&&(m.iridescenceMap.value=p.iridescenceMap,t(p.iridescenceMap,m.iridescenceMapTransform)),p.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=p.iridescenceThicknessMap,t(p.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),p.transmission>0&&(m.transmission.value=p.transmission,m.transmissionSamplerMap.value=y.texture,m.transmissionSamplerSize.value.set(y.width,y.height),p.transmissionMap&&(m.transmissionMap.value=p.transmissionMap,t(p.transmissionMap,m.transmissionMapTransform)),m.thickness.value=p.thickness,p.thicknessMap&&(m.thicknessMap.value=p.thicknessMap,t(p.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=p.attenuationDistance,m.attenuationColor.value.copy(p.attenuationColor)),p.anisotropy>0&&(m.anisotropyVector.value.set(p.anisotropy*Math.cos(p.anisotropyRotation),p.anisotropy*Math.sin(p.anisotropyRotation)),p.anisotropyMap&&(m.anisotropyMap.value=p.anisotropyMap,t(p.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=p.specularIntensity,m.specularColor.value.copy(p.specularColor),p.specularColorMap&&(m.specularColorMap.value=p.specularColorMap,t(p.specularColorMap,m.specularColorMapTransform)),p.specularIntensityMap&&(m.specularIntensityMap.value=p.specularIntensityMap,t(p.specularIntensityMap,m.specularIntensityMapTransform))}function _(m,p){p.matcap&&(m.matcap.value=p.matcap)}function v(m,p){const y=e.get(p).light;m.referencePosition.value.setFromMatrixPosition(y.matrixWorld),m.nearDistance.value=y.shadow.camera.near,m.farDistance.value=y.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function lw(n,e,t,i){let s={},r={},o=[];const a=n.getParameter(n.MAX_UNIFORM_BUFFER_BINDINGS);function l(y,w){const x=w.program;i.uniformBlockBinding(y,x)}function c(y,w){let x=s[y.id];x===void 0&&(_(y),x=h(y),s[y.id]=x,y.addEventListener("dispose",m));const L=w.program;i.updateUBOMapping(y,L);const A=e.render.frame;r[y.id]!==A&&(d(y),r[y.id]=A)}function h(y){const w=f();y.__bindingPointIndex=w;const x=n.createBuffer(),L=y.__size,A=y.usage;return n.bindBuffer(n.UNIFORM_BUFFER,x),n.bufferData(n.UNIFORM_BUFFER,L,A),n.bindBuffer(n.UNIFORM_BUFFER,null),n.bindBufferBase(n.UNIFORM_BUFFER,w,x),x}function f(){for(let y=0;y<a;y++)if(o.indexOf(y)===-1)return o.push(y),y;return console.error("THREE.WebGLRenderer: Maximum number of simultaneously usable uniforms groups reached."),0}function d(y){const w=s[y.id],x=y.uniforms,L=y.__cache;n.bindBuffer(n.UNIFORM_BUFFER,w);for(let A=0,U=x.length;A<U;A++){const N=Array.isArray(x[A])?x[A]:[x[A]];for(let b=0,E=N.length;b<E;b++){const C=N[b];if(u(C,A,b,L)===!0){const B=C.__offset,z=Array.isArray(C.value)?C.value:[C.value];let Y=0;for(let W=0;W<z.length;W++){const j=z[W],q=v(j);typeof j=="number"||typeof j=="boolean"?(C.__data[0]=j,n.bufferSubData(n.UNIFORM_BUFFER,B+Y,C.__data)):j.isMatrix3?(C.__data[0]=j.elements[0],C.__data[1]=j.elements[1],C.__data[2]=j.elements[2],C.__data[3]=0,C.__data[4]=j.elements[3],C.__data[5]=j.elements[4],C.__data[6]=j.elements[5],C.__data[7]=0,C.__data[8]=j.elements[6],C.__data[9]=j.elements[7],C.__data[10]=j.elements[8],C.__data[11]=0):(j.toArray(C.__data,Y),Y+=q.storage/Float32Array.BYTES_PER_ELEMENT)}n.bufferSubData(n.UNIFORM_BUFFER,B,C.__data)}}}n.bindBuffer(n.UNIFORM_BUFFER,null)}function u(y,w,x,L){const A=y.value,U=w+"_"+x;if(L[U]===void 0)return typeof A=="number"||typeof A=="boolean"?L[U]=A:L[U]=A.clone(),!0;{const N=L[U];if(typeof A=="number"||typeof A=="boolean"){if(N!==A)return L[U]=A,!0}else if(N.equals(A)===!1)return N.copy(A),!0}return!1}function _(y){const w=y.uniforms;let x=0;const L=16;for(let U=0,N=w.length;U<N;U++){const b=Array.isArray(w[U])?w[U]:[w[U]];for(let E=0,C=b.length;E<C;E++){const B=b[E],z=Array.isArray(B.value)?B.value:[B.value];for(let Y=0,W=z.length;Y<W;Y++){const j=z[Y],q=v(j),K=x%L,re=K%q.boundary,ae=K+re;x+=re,ae!==0&&L-ae<q.storage&&(x+=L-ae),B.__data=new Float32Array(q.storage/Float32Array.BYTES_PER_ELEMENT),B.__offset=x,x+=q.storage}}}const A=x%L;return A>0&&(x+=L-A),y.__size=x,y.__cache={},this}function v(y){const w={boundary:0,storage:0};return typeof y=="number"||typeof y=="boolean"?(w.boundary=4,w.storage=4):y.isVector2?(w.boundary=8,w.storage=8):y.isVector3||y.isColor?(w.boundary=16,w.storage=12):y.isVector4?(w.boundary=16,w.storage=16):y.isMatrix3?(w.boundary=48,w.storage=48):y.isMatrix4?(w.boundary=64,w.storage=64):y.isTexture?console.warn("THREE.WebGLRenderer: Texture samplers can not be part of an uniforms group."):console.warn("THREE.WebGLRenderer: Unsupported uniform value type.",y),w}function m(y){const w=y.target;w.removeEventListener("dispose",m);const x=o.indexOf(w.__bindingPointIndex);o.splice(x,1),n.deleteBuffer(s[w.id]),delete s[w.id],delete r[w.id]}function p(){for(const y in s)n.deleteBuffer(s[y]);o=[],s={},r={}}return{bind:l,update:c,dispose:p}}class cw{constructor(e={}){const{canvas:t=Ox(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:f=!1,reversedDepthBuffer:d=!1}=e;this.isWebGLRenderer=!0;let u;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");u=i.getContextAttributes().alpha}else u=o;const _=new Uint32Array(4),v=new Int32Array(4);let m=null,p=null;const y=[],w=[];this.domElement=t,this.debug={checkShaderErrors:!0,onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=Ls,this.toneMappingExposure=1,this.transmissionResolutionScale=1;const x=this;let L=!1;this._outputColorSpace=mi;let A=0,U=0,N=null,b=-1,E=null;const C=new en,B=new en;let z=null;const Y=new Je(0);let W=0,j=t.width,q=t.height,K=1,re=null,ae=null;const me=new en(0,0,j,q),xe=new en(0,0,j,q);let ge=!1;const Qe=new tf;let et=!1,ee=!1;const ne=new Rt,we=new k,ze=new en,Me={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0};let tt=!1;function kt(){return N===null?K:1}let F=i;function mt(T,G){return t.getContext(T,G)}try{const T={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:f};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${Gu}`),t.addEventListener("webglcontextlost",pe,!1),t.addEventListener("webglcontextrestored",De,!1),t.addEventListener("webglcontextcreationerror",he,!1),F===null){const G="webgl2";if(F=mt(G,T),F===null)throw mt(G)?new Error("Error creating WebGL context with your selected attributes."):new Error("Error creating WebGL context.")}}catch(T){throw console.error("THREE.WebGLRenderer: "+T.message),T}let $e,We,Ne,Tt,Pe,Ge,Vt,yt,D,M,O,J,ie,te,Fe,ue,Le,Re,le,ve,Be,ke,ye,Ze;function H(){$e=new xE(F),$e.init(),ke=new tw(F,$e),We=new fE(F,$e,e,ke),Ne=new Qb(F,$e),We.reversedDepthBuffer&&d&&Ne.buffers.depth.setReversed(!0),Tt=new SE(F),Pe=new zb,Ge=new ew(F,$e,Ne,Pe,We,ke,Tt),Vt=new pE(x),yt=new vE(x),D=new RM(F),ye=new hE(F,D),M=new ME(F,D,Tt,ye),O=new bE(F,M,D,Tt),le=new EE(F,We,Ge),ue=new dE(Pe),J=new Bb(x,Vt,yt,$e,We,ye,ue),ie=new aw(x,Pe),te=new Vb,Fe=new $b($e),Re=new cE(x,Vt,yt,Ne,O,u,l),Le=new Kb(x,O,We),Ze=new lw(F,Tt,We,Ne),ve=new uE(F,$e,Tt),Be=new yE(F,$e,Tt),Tt.programs=J.programs,x.capabilities=We,x.extensions=$e,x.properties=Pe,x.renderLists=te,x.shadowMap=Le,x.state=Ne,x.info=Tt}H();const fe=new rw(x,F);this.xr=fe,this.getContext=function(){return F},this.getContextAttributes=function(){return F.getContextAttributes()},this.forceContextLoss=function(){const T=$e.get("WEBGL_lose_context");T&&T.loseContext()},this.forceContextRestore=function(){const T=$e.get("WEBGL_lose_context");T&&T.restoreContext()},this.getPixelRatio=function(){return K},this.setPixelRatio=function(T){T!==void 0&&(K=T,this.setSize(j,q,!1))},this.getSize=function(T){return T.set(j,q)},this.setSize=function(T,G,Q=!0){if(fe.isPresenting){console.warn("THREE.WebGLRenderer: Can't change size while VR device is presenting.");return}j=T,q=G,t.width=Math.floor(T*K),t.height=Math.floor(G*K),Q===!0&&(t.style.width=T+"px",t.style.height=G+"px"),this.setViewport(0,0,T,G)},this.getDrawingBufferSize=function(T){return T.set(j*K,q*K).floor()},this.setDrawingBufferSize=function(T,G,Q){j=T,q=G,K=Q,t.width=Math.floor(T*Q),t.height=Math.floor(G*Q),this.setViewport(0,0,T,G)},this.getCurrentViewport=function(T){return T.copy(C)},this.getViewport=function(T){return T.copy(me)},this.setViewport=function(T,G,Q,Z){T.isVector4?me.set(T.x,T.y,T.z,T.w):me.set(T,G,Q,Z),Ne.viewport(C.copy(me).multiplyScalar(K).round())},this.getScissor=function(T){return T.copy(xe)},this.setScissor=function(T,G,Q,Z){T.isVector4?xe.set(T.x,T.y,T.z,T.w):xe.set(T,G,Q,Z),Ne.scissor(B.copy(xe).multiplyScalar(K).round())},this.getScissorTest=function(){return ge},this.setScissorTest=function(T){Ne.setScissorTest(ge=T)},this.setOpaqueSort=function(T){re=T},this.setTransparentSort=function(T){ae=T},this.getClearColor=function(T){return T.copy(Re.getClearColor())},this.setClearColor=function(){Re.setClearColor(...arguments)},this.getClearAlpha=function(){return Re.getClearAlpha()},this.setClearAlpha=function(){Re.setClearAlpha(...arguments)},this.clear=function(T=!0,G=!0,Q=!0){let Z=0;if(T){let X=!1;if(N!==null){const de=N.texture.format;X=de===Ku||de===Zu||de===ju}if(X){const de=N.texture.type,Se=de===qi||de===pr||de===_a||de===ga||de===Yu||de===qu,Ie=Re.getClearColor(),Te=Re.getClearAlpha(),Ye=Ie.r,qe=Ie.g,He=Ie.b;Se?(_[0]=Ye,_[1]=qe,_[2]=He,_[3]=Te,F.clearBufferuiv(F.COLOR,0,_)):(v[0]=Ye,v[1]=qe,v[2]=He,v[3]=Te,F.clearBufferiv(F.COLOR,0,v))}else Z|=F.COLOR_BUFFER_BIT}G&&(Z|=F.DEPTH_BUFFER_BIT),Q&&(Z|=F.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),F.clear(Z)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.dispose=function(){t.removeEventListener("webglcontextlost",pe,!1),t.removeEventListener("webglcontextrestored",De,!1),t.removeEventListener("webglcontextcreationerror",he,!1),Re.dispose(),te.dispose(),Fe.dispose(),Pe.dispose(),Vt.dispose(),yt.dispose(),O.dispose(),ye.dispose(),Ze.dispose(),J.dispose(),fe.dispose(),fe.removeEventListener("sessionstart",It),fe.removeEventListener("sessionend",Jn),qn.stop()};function pe(T){T.preventDefault(),console.log("THREE.WebGLRenderer: Context Lost."),L=!0}function De(){console.log("THREE.WebGLRenderer: Context Restored."),L=!1;const T=Tt.autoReset,G=Le.enabled,Q=Le.autoUpdate,Z=Le.needsUpdate,X=Le.type;H(),Tt.autoReset=T,Le.enabled=G,Le.autoUpdate=Q,Le.needsUpdate=Z,Le.type=X}function he(T){console.error("THREE.WebGLRenderer: A WebGL context could not be created. Reason: ",T.statusMessage)}function oe(T){const G=T.target;G.removeEventListener("dispose",oe),Oe(G)}function Oe(T){nt(T),Pe.remove(T)}function nt(T){const G=Pe.get(T).programs;G!==void 0&&(G.forEach(function(Q){J.releaseProgram(Q)}),T.isShaderMaterial&&J.releaseShaderCache(T))}this.renderBufferDirect=function(T,G,Q,Z,X,de){G===null&&(G=Me);const Se=X.isMesh&&X.matrixWorld.determinant()<0,Ie=ji(T,G,Q,Z,X);Ne.setMaterial(Z,Se);let Te=Q.index,Ye=1;if(Z.wireframe===!0){if(Te=M.getWireframeAttribute(Q),Te===void 0)return;Ye=2}const qe=Q.drawRange,He=Q.attributes.position;let ot=qe.start*Ye,gt=(qe.start+qe.count)*Ye;de!==null&&(ot=Math.max(ot,de.start*Ye),gt=Math.min(gt,(de.start+de.count)*Ye)),Te!==null?(ot=Math.max(ot,0),gt=Math.min(gt,Te.count)):He!=null&&(ot=Math.max(ot,0),gt=Math.min(gt,He.count));const Bt=gt-ot;if(Bt<0||Bt===1/0)return;ye.setup(X,Z,Ie,Q,Te);let At,st=ve;if(Te!==null&&(At=D.get(Te),st=Be,st.setIndex(At)),X.isMesh)Z.wireframe===!0?(Ne.setLineWidth(Z.wireframeLinewidth*kt()),st.setMode(F.LINES)):st.setMode(F.TRIANGLES);else if(X.isLine){let Xe=Z.linewidth;Xe===void 0&&(Xe=1),Ne.setLineWidth(Xe*kt()),X.isLineSegments?st.setMode(F.LINES):X.isLineLoop?st.setMode(F.LINE_LOOP):st.setMode(F.LINE_STRIP)}else X.isPoints?st.setMode(F.POINTS):X.isSprite&&st.setMode(F.TRIANGLES);if(X.isBatchedMesh)if(X._multiDrawInstances!==null)Ma("THREE.WebGLRenderer: renderMultiDrawInstances has been deprecated and will be removed in r184. Append to renderMultiDraw arguments and use indirection."),st.renderMultiDrawInstances(X._multiDrawStarts,X._multiDrawCounts,X._multiDrawCount,X._multiDrawInstances);else if($e.get("WEBGL_multi_draw"))st.renderMultiDraw(X._multiDrawStarts,X._multiDrawCounts,X._multiDrawCount);else{const Xe=X._multiDrawStarts,zt=X._multiDrawCounts,dt=X._multiDrawCount,Dn=Te?D.get(Te).bytesPerElement:1,fs=Pe.get(Z).currentProgram.getUniforms();for(let kn=0;kn<dt;kn++)fs.setValue(F,"_gl_DrawID",kn),st.render(Xe[kn]/Dn,zt[kn])}else if(X.isInstancedMesh)st.renderInstances(ot,Bt,X.count);else if(Q.isInstancedBufferGeometry){const Xe=Q._maxInstanceCount!==void 0?Q._maxInstanceCount:1/0,zt=Math.min(Q.instanceCount,Xe);st.renderInstances(ot,Bt,zt)}else st.render(ot,Bt)};function Ct(T,G,Q){T.transparent===!0&&T.side===Vi&&T.forceSinglePass===!1?(T.side=Kn,T.needsUpdate=!0,Bs(T,G,Q),T.side=cs,T.needsUpdate=!0,Bs(T,G,Q),T.side=Vi):Bs(T,G,Q)}this.compile=function(T,G,Q=null){Q===null&&(Q=T),p=Fe.get(Q),p.init(G),w.push(p),Q.traverseVisible(function(X){X.isLight&&X.layers.test(G.layers)&&(p.pushLight(X),X.castShadow&&p.pushShadow(X))}),T!==Q&&T.traverseVisible(function(X){X.isLight&&X.layers.test(G.layers)&&(p.pushLight(X),X.castShadow&&p.pushShadow(X))}),p.setupLights();const Z=new Set;return T.traverse(function(X){if(!(X.isMesh||X.isPoints||X.isLine||X.isSprite))return;const de=X.material;if(de)if(Array.isArray(de))for(let Se=0;Se<de.length;Se++){const Ie=de[Se];Ct(Ie,Q,X),Z.add(Ie)}else Ct(de,Q,X),Z.add(de)}),p=w.pop(),Z},this.compileAsync=function(T,G,Q=null){const Z=this.compile(T,G,Q);return new Promise(X=>{function de(){if(Z.forEach(function(Se){Pe.get(Se).currentProgram.isReady()&&Z.delete(Se)}),Z.size===0){X(T);return}setTimeout(de,10)}$e.get("KHR_parallel_shader_compile")!==null?de():setTimeout(de,10)})};let _t=null;function wn(T){_t&&_t(T)}function It(){qn.stop()}function Jn(){qn.start()}const qn=new B_;qn.setAnimationLoop(wn),typeof self<"u"&&qn.setContext(self),this.setAnimationLoop=function(T){_t=T,fe.setAnimationLoop(T),T===null?qn.stop():qn.start()},fe.addEventListener("sessionstart",It),fe.addEventListener("sessionend",Jn),this.render=function(T,G){if(G!==void 0&&G.isCamera!==!0){console.error("THREE.WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(L===!0)return;if(T.matrixWorldAutoUpdate===!0&&T.updateMatrixWorld(),G.parent===null&&G.matrixWorldAutoUpdate===!0&&G.updateMatrixWorld(),fe.enabled===!0&&fe.isPresenting===!0&&(fe.cameraAutoUpdate===!0&&fe.updateCamera(G),G=fe.getCamera()),T.isScene===!0&&T.onBeforeRender(x,T,G,N),p=Fe.get(T,w.length),p.init(G),w.push(p),ne.multiplyMatrices(G.projectionMatrix,G.matrixWorldInverse),Qe.setFromProjectionMatrix(ne,Xi,G.reversedDepth),ee=this.localClippingEnabled,et=ue.init(this.clippingPlanes,ee),m=te.get(T,y.length),m.init(),y.push(m),fe.enabled===!0&&fe.isPresenting===!0){const de=x.xr.getDepthSensingMesh();de!==null&&Li(de,G,-1/0,x.sortObjects)}Li(T,G,0,x.sortObjects),m.finish(),x.sortObjects===!0&&m.sort(re,ae),tt=fe.enabled===!1||fe.isPresenting===!1||fe.hasDepthSensing()===!1,tt&&Re.addToRenderList(m,T),this.info.render.frame++,et===!0&&ue.beginShadows();const Q=p.state.shadowsArray;Le.render(Q,T,G),et===!0&&ue.endShadows(),this.info.autoReset===!0&&this.info.reset();const Z=m.opaque,X=m.transmissive;if(p.setupLights(),G.isArrayCamera){const de=G.cameras;if(X.length>0)for(let Se=0,Ie=de.length;Se<Ie;Se++){const Te=de[Se];$i(Z,X,T,Te)}tt&&Re.render(T);for(let Se=0,Ie=de.length;Se<Ie;Se++){const Te=de[Se];On(m,T,Te,Te.viewport)}}else X.length>0&&$i(Z,X,T,G),tt&&Re.render(T),On(m,T,G);N!==null&&U===0&&(Ge.updateMultisampleRenderTarget(N),Ge.updateRenderTargetMipmap(N)),T.isScene===!0&&T.onAfterRender(x,T,G),ye.resetDefaultState(),b=-1,E=null,w.pop(),w.length>0?(p=w[w.length-1],et===!0&&ue.setGlobalState(x.clippingPlanes,p.state.camera)):p=null,y.pop(),y.length>0?m=y[y.length-1]:m=null};function Li(T,G,Q,Z){if(T.visible===!1)return;if(T.layers.test(G.layers)){if(T.isGroup)Q=T.renderOrder;else if(T.isLOD)T.autoUpdate===!0&&T.update(G);else if(T.isLight)p.pushLight(T),T.castShadow&&p.pushShadow(T);else if(T.isSprite){if(!T.frustumCulled||Qe.intersectsSprite(T)){Z&&ze.setFromMatrixPosition(T.matrixWorld).applyMatrix4(ne);const Se=O.update(T),Ie=T.material;Ie.visible&&m.push(T,Se,Ie,Q,ze.z,null)}}else if((T.isMesh||T.isLine||T.isPoints)&&(!T.frustumCulled||Qe.intersectsObject(T))){const Se=O.update(T),Ie=T.material;if(Z&&(T.boundingSphere!==void 0?(T.boundingSphere===null&&T.computeBoundingSphere(),ze.copy(T.boundingSphere.center)):(Se.boundingSphere===null&&Se.computeBoundingSphere(),ze.copy(Se.boundingSphere.center)),ze.applyMatrix4(T.matrixWorld).applyMatrix4(ne)),Array.isArray(Ie)){const Te=Se.groups;for(let Ye=0,qe=Te.length;Ye<qe;Ye++){const He=Te[Ye],ot=Ie[He.materialIndex];ot&&ot.visible&&m.push(T,Se,ot,Q,ze.z,He)}}else Ie.visible&&m.push(T,Se,Ie,Q,ze.z,null)}}const de=T.children;for(let Se=0,Ie=de.length;Se<Ie;Se++)Li(de[Se],G,Q,Z)}function On(T,G,Q,Z){const X=T.opaque,de=T.transmissive,Se=T.transparent;p.setupLightsView(Q),et===!0&&ue.setGlobalState(x.clippingPlanes,Q),Z&&Ne.viewport(C.copy(Z)),X.length>0&&yi(X,G,Q),de.length>0&&yi(de,G,Q),Se.length>0&&yi(Se,G,Q),Ne.buffers.depth.setTest(!0),Ne.buffers.depth.setMask(!0),Ne.buffers.color.setMask(!0),Ne.setPolygonOffset(!1)}function $i(T,G,Q,Z){if((Q.isScene===!0?Q.overrideMaterial:null)!==null)return;p.state.transmissionRenderTarget[Z.id]===void 0&&(p.state.transmissionRenderTarget[Z.id]=new mr(1,1,{generateMipmaps:!0,type:$e.has("EXT_color_buffer_half_float")||$e.has("EXT_color_buffer_float")?Sa:qi,minFilter:cr,samples:4,stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,colorSpace:xt.workingColorSpace}));const de=p.state.transmissionRenderTarget[Z.id],Se=Z.viewport||C;de.setSize(Se.z*x.transmissionResolutionScale,Se.w*x.transmissionResolutionScale);const Ie=x.getRenderTarget(),Te=x.getActiveCubeFace(),Ye=x.getActiveMipmapLevel();x.setRenderTarget(de),x.getClearColor(Y),W=x.getClearAlpha(),W<1&&x.setClearColor(16777215,.5),x.clear(),tt&&Re.render(Q);const qe=x.toneMapping;x.toneMapping=Ls;const He=Z.viewport;if(Z.viewport!==void 0&&(Z.viewport=void 0),p.setupLightsView(Z),et===!0&&ue.setGlobalState(x.clippingPlanes,Z),yi(T,Q,Z),Ge.updateMultisampleRenderTarget(de),Ge.updateRenderTargetMipmap(de),$e.has("WEBGL_multisampled_render_to_texture")===!1){let ot=!1;for(let gt=0,Bt=G.length;gt<Bt;gt++){const At=G[gt],st=At.object,Xe=At.geometry,zt=At.material,dt=At.group;if(zt.side===Vi&&st.layers.test(Z.layers)){const Dn=zt.side;zt.side=Kn,zt.needsUpdate=!0,yo(st,Q,Z,Xe,zt,dt),zt.side=Dn,zt.needsUpdate=!0,ot=!0}}ot===!0&&(Ge.updateMultisampleRenderTarget(de),Ge.updateRenderTargetMipmap(de))}x.setRenderTarget(Ie,Te,Ye),x.setClearColor(Y,W),He!==void 0&&(Z.viewport=He),x.toneMapping=qe}function yi(T,G,Q){const Z=G.isScene===!0?G.overrideMaterial:null;for(let X=0,de=T.length;X<de;X++){const Se=T[X],Ie=Se.object,Te=Se.geometry,Ye=Se.group;let qe=Se.material;qe.allowOverride===!0&&Z!==null&&(qe=Z),Ie.layers.test(Q.layers)&&yo(Ie,G,Q,Te,qe,Ye)}}function yo(T,G,Q,Z,X,de){T.onBeforeRender(x,G,Q,Z,X,de),T.modelViewMatrix.multiplyMatrices(Q.matrixWorldInverse,T.matrixWorld),T.normalMatrix.getNormalMatrix(T.modelViewMatrix),X.onBeforeRender(x,G,Q,Z,T,de),X.transparent===!0&&X.side===Vi&&X.forceSinglePass===!1?(X.side=Kn,X.needsUpdate=!0,x.renderBufferDirect(Q,G,Z,X,T,de),X.side=cs,X.needsUpdate=!0,x.renderBufferDirect(Q,G,Z,X,T,de),X.side=Vi):x.renderBufferDirect(Q,G,Z,X,T,de),T.onAfterRender(x,G,Q,Z,X,de)}function Bs(T,G,Q){G.isScene!==!0&&(G=Me);const Z=Pe.get(T),X=p.state.lights,de=p.state.shadowsArray,Se=X.state.version,Ie=J.getParameters(T,X.state,de,G,Q),Te=J.getProgramCacheKey(Ie);let Ye=Z.programs;Z.environment=T.isMeshStandardMaterial?G.environment:null,Z.fog=G.fog,Z.envMap=(T.isMeshStandardMaterial?yt:Vt).get(T.envMap||Z.environment),Z.envMapRotation=Z.environment!==null&&T.envMap===null?G.environmentRotation:T.envMapRotation,Ye===void 0&&(T.addEventListener("dispose",oe),Ye=new Map,Z.programs=Ye);let qe=Ye.get(Te);if(qe!==void 0){if(Z.currentProgram===qe&&Z.lightsStateVersion===Se)return wa(T,Ie),qe}else Ie.uniforms=J.getUniforms(T),T.onBeforeCompile(Ie,x),qe=J.acquireProgram(Ie,Te),Ye.set(Te,qe),Z.uniforms=Ie.uniforms;const He=Z.uniforms;return(!T.isShaderMaterial&&!T.isRawShaderMaterial||T.clipping===!0)&&(He.clippingPlanes=ue.uniform),wa(T,Ie),Z.needsLights=zs(T),Z.lightsStateVersion=Se,Z.needsLights&&(He.ambientLightColor.value=X.state.ambient,He.lightProbe.value=X.state.probe,He.directionalLights.value=X.state.directional,He.directionalLightShadows.value=X.state.directionalShadow,He.spotLights.value=X.state.spot,He.spotLightShadows.value=X.state.spotShadow,He.rectAreaLights.value=X.state.rectArea,He.ltc_1.value=X.state.rectAreaLTC1,He.ltc_2.value=X.state.rectAreaLTC2,He.pointLights.value=X.state.point,He.pointLightShadows.value=X.state.pointShadow,He.hemisphereLights.value=X.state.hemi,He.directionalShadowMap.value=X.state.directionalShadowMap,He.directionalShadowMatrix.value=X.state.directionalShadowMatrix,He.spotShadowMap.value=X.state.spotShadowMap,He.spotLightMatrix.value=X.state.spotLightMatrix,He.spotLightMap.value=X.state.spotLightMap,He.pointShadowMap.value=X.state.pointShadowMap,He.pointShadowMatrix.value=X.state.pointShadowMatrix),Z.currentProgram=qe,Z.uniformsList=null,qe}function ba(T){if(T.uniformsList===null){const G=T.currentProgram.getUniforms();T.uniformsList=Sl.seqWithValue(G.seq,T.uniforms)}return T.uniformsList}function wa(T,G){const Q=Pe.get(T);Q.outputColorSpace=G.outputColorSpace,Q.batching=G.batching,Q.batchingColor=G.batchingColor,Q.instancing=G.instancing,Q.instancingColor=G.instancingColor,Q.instancingMorph=G.instancingMorph,Q.skinning=G.skinning,Q.morphTargets=G.morphTargets,Q.morphNormals=G.morphNormals,Q.morphColors=G.morphColors,Q.morphTargetsCount=G.morphTargetsCount,Q.numClippingPlanes=G.numClippingPlanes,Q.numIntersection=G.numClipIntersection,Q.vertexAlphas=G.vertexAlphas,Q.vertexTangents=G.vertexTangents,Q.toneMapping=G.toneMapping}function ji(T,G,Q,Z,X){G.isScene!==!0&&(G=Me),Ge.resetTextureUnits();const de=G.fog,Se=Z.isMeshStandardMaterial?G.environment:null,Ie=N===null?x.outputColorSpace:N.isXRRenderTarget===!0?N.texture.colorSpace:uo,Te=(Z.isMeshStandardMaterial?yt:Vt).get(Z.envMap||Se),Ye=Z.vertexColors===!0&&!!Q.attributes.color&&Q.attributes.color.itemSize===4,qe=!!Q.attributes.tangent&&(!!Z.normalMap||Z.anisotropy>0),He=!!Q.morphAttributes.position,ot=!!Q.morphAttributes.normal,gt=!!Q.morphAttributes.color;let Bt=Ls;Z.toneMapped&&(N===null||N.isXRRenderTarget===!0)&&(Bt=x.toneMapping);const At=Q.morphAttributes.position||Q.morphAttributes.normal||Q.morphAttributes.color,st=At!==void 0?At.length:0,Xe=Pe.get(Z),zt=p.state.lights;if(et===!0&&(ee===!0||T!==E)){const vn=T===E&&Z.id===b;ue.setState(Z,T,vn)}let dt=!1;Z.version===Xe.__version?(Xe.needsLights&&Xe.lightsStateVersion!==zt.state.version||Xe.outputColorSpace!==Ie||X.isBatchedMesh&&Xe.batching===!1||!X.isBatchedMesh&&Xe.batching===!0||X.isBatchedMesh&&Xe.batchingColor===!0&&X.colorTexture===null||X.isBatchedMesh&&Xe.batchingColor===!1&&X.colorTexture!==null||X.isInstancedMesh&&Xe.instancing===!1||!X.isInstancedMesh&&Xe.instancing===!0||X.isSkinnedMesh&&Xe.skinning===!1||!X.isSkinnedMesh&&Xe.skinning===!0||X.isInstancedMesh&&Xe.instancingColor===!0&&X.instanceColor===null||X.isInstancedMesh&&Xe.instancingColor===!1&&X.instanceColor!==null||X.isInstancedMesh&&Xe.instancingMorph===!0&&X.morphTexture===null||X.isInstancedMesh&&Xe.instancingMorph===!1&&X.morphTexture!==null||Xe.envMap!==Te||Z.fog===!0&&Xe.fog!==de||Xe.numClippingPlanes!==void 0&&(Xe.numClippingPlanes!==ue.numPlanes||Xe.numIntersection!==ue.numIntersection)||Xe.vertexAlphas!==Ye||Xe.vertexTangents!==qe||Xe.morphTargets!==He||Xe.morphNormals!==ot||Xe.morphColors!==gt||Xe.toneMapping!==Bt||Xe.morphTargetsCount!==st)&&(dt=!0):(dt=!0,Xe.__version=Z.version);let Dn=Xe.currentProgram;dt===!0&&(Dn=Bs(Z,G,X));let fs=!1,kn=!1,Hs=!1;const Ht=Dn.getUniforms(),Bn=Xe.uniforms;if(Ne.useProgram(Dn.program)&&(fs=!0,kn=!0,Hs=!0),Z.id!==b&&(b=Z.id,kn=!0),fs||E!==T){Ne.buffers.depth.getReversed()&&T.reversedDepth!==!0&&(T._reversedDepth=!0,T.updateProjectionMatrix()),Ht.setValue(F,"projectionMatrix",T.projectionMatrix),Ht.setValue(F,"viewMatrix",T.matrixWorldInverse);const xn=Ht.map.cameraPosition;xn!==void 0&&xn.setValue(F,we.setFromMatrixPosition(T.matrixWorld)),We.logarithmicDepthBuffer&&Ht.setValue(F,"logDepthBufFC",2/(Math.log(T.far+1)/Math.LN2)),(Z.isMeshPhongMaterial||Z.isMeshToonMaterial||Z.isMeshLambertMaterial||Z.isMeshBasicMaterial||Z.isMeshStandardMaterial||Z.isShaderMaterial)&&Ht.setValue(F,"isOrthographic",T.isOrthographicCamera===!0),E!==T&&(E=T,kn=!0,Hs=!0)}if(X.isSkinnedMesh){Ht.setOptional(F,X,"bindMatrix"),Ht.setOptional(F,X,"bindMatrixInverse");const vn=X.skeleton;vn&&(vn.boneTexture===null&&vn.computeBoneTexture(),Ht.setValue(F,"boneTexture",vn.boneTexture,Ge))}X.isBatchedMesh&&(Ht.setOptional(F,X,"batchingTexture"),Ht.setValue(F,"batchingTexture",X._matricesTexture,Ge),Ht.setOptional(F,X,"batchingIdTexture"),Ht.setValue(F,"batchingIdTexture",X._indirectTexture,Ge),Ht.setOptional(F,X,"batchingColorTexture"),X._colorsTexture!==null&&Ht.setValue(F,"batchingColorTexture",X._colorsTexture,Ge));const $n=Q.morphAttributes;if(($n.position!==void 0||$n.normal!==void 0||$n.color!==void 0)&&le.update(X,Q,Dn),(kn||Xe.receiveShadow!==X.receiveShadow)&&(Xe.receiveShadow=X.receiveShadow,Ht.setValue(F,"receiveShadow",X.receiveShadow)),Z.isMeshGouraudMaterial&&Z.envMap!==null&&(Bn.envMap.value=Te,Bn.flipEnvMap.value=Te.isCubeTexture&&Te.isRenderTargetTexture===!1?-1:1),Z.isMeshStandardMaterial&&Z.envMap===null&&G.environment!==null&&(Bn.envMapIntensity.value=G.environmentIntensity),kn&&(Ht.setValue(F,"toneMappingExposure",x.toneMappingExposure),Xe.needsLights&&rc(Bn,Hs),de&&Z.fog===!0&&ie.refreshFogUniforms(Bn,de),ie.refreshMaterialUniforms(Bn,Z,K,q,p.state.transmissionRenderTarget[T.id]),Sl.upload(F,ba(Xe),Bn,Ge)),Z.isShaderMaterial&&Z.uniformsNeedUpdate===!0&&(Sl.upload(F,ba(Xe),Bn,Ge),Z.uniformsNeedUpdate=!1),Z.isSpriteMaterial&&Ht.setValue(F,"center",X.center),Ht.setValue(F,"modelViewMatrix",X.modelViewMatrix),Ht.setValue(F,"normalMatrix",X.normalMatrix),Ht.setValue(F,"modelMatrix",X.matrixWorld),Z.isShaderMaterial||Z.isRawShaderMaterial){const vn=Z.uniformsGroups;for(let xn=0,ds=vn.length;xn<ds;xn++){const li=vn[xn];Ze.update(li,Dn),Ze.bind(li,Dn)}}return Dn}function rc(T,G){T.ambientLightColor.needsUpdate=G,T.lightProbe.needsUpdate=G,T.directionalLights.needsUpdate=G,T.directionalLightShadows.needsUpdate=G,T.pointLights.needsUpdate=G,T.pointLightShadows.needsUpdate=G,T.spotLights.needsUpdate=G,T.spotLightShadows.needsUpdate=G,T.rectAreaLights.needsUpdate=G,T.hemisphereLights.needsUpdate=G}function zs(T){return T.isMeshLambertMaterial||T.isMeshToonMaterial||T.isMeshPhongMaterial||T.isMeshStandardMaterial||T.isShadowMaterial||T.isShaderMaterial&&T.lights===!0}this.getActiveCubeFace=function(){return A},this.getActiveMipmapLevel=function(){return U},this.getRenderTarget=function(){return N},this.setRenderTargetTextures=function(T,G,Q){const Z=Pe.get(T);Z.__autoAllocateDepthBuffer=T.resolveDepthBuffer===!1,Z.__autoAllocateDepthBuffer===!1&&(Z.__useRenderToTexture=!1),Pe.get(T.texture).__webglTexture=G,Pe.get(T.depthTexture).__webglTexture=Z.__autoAllocateDepthBuffer?void 0:Q,Z.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(T,G){const Q=Pe.get(T);Q.__webglFramebuffer=G,Q.__useDefaultFramebuffer=G===void 0};const Ta=F.createFramebuffer();this.setRenderTarget=function(T,G=0,Q=0){N=T,A=G,U=Q;let Z=!0,X=null,de=!1,Se=!1;if(T){const Te=Pe.get(T);if(Te.__useDefaultFramebuffer!==void 0)Ne.bindFramebuffer(F.FRAMEBUFFER,null),Z=!1;else if(Te.__webglFramebuffer===void 0)Ge.setupRenderTarget(T);else if(Te.__hasExternalTextures)Ge.rebindTextures(T,Pe.get(T.texture).__webglTexture,Pe.get(T.depthTexture).__webglTexture);else if(T.depthBuffer){const He=T.depthTexture;if(Te.__boundDepthTexture!==He){if(He!==null&&Pe.has(He)&&(T.width!==He.image.width||T.height!==He.image.height))throw new Error("WebGLRenderTarget: Attached DepthTexture is initialized to the incorrect size.");Ge.setupDepthRenderbuffer(T)}}const Ye=T.texture;(Ye.isData3DTexture||Ye.isDataArrayTexture||Ye.isCompressedArrayTexture)&&(Se=!0);const qe=Pe.get(T).__webglFramebuffer;T.isWebGLCubeRenderTarget?(Array.isArray(qe[G])?X=qe[G][Q]:X=qe[G],de=!0):T.samples>0&&Ge.useMultisampledRTT(T)===!1?X=Pe.get(T).__webglMultisampledFramebuffer:Array.isArray(qe)?X=qe[Q]:X=qe,C.copy(T.viewport),B.copy(T.scissor),z=T.scissorTest}else C.copy(me).multiplyScalar(K).floor(),B.copy(xe).multiplyScalar(K).floor(),z=ge;if(Q!==0&&(X=Ta),Ne.bindFramebuffer(F.FRAMEBUFFER,X)&&Z&&Ne.drawBuffers(T,X),Ne.viewport(C),Ne.scissor(B),Ne.setScissorTest(z),de){const Te=Pe.get(T.texture);F.framebufferTexture2D(F.FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_CUBE_MAP_POSITIVE_X+G,Te.__webglTexture,Q)}else if(Se){const Te=G;for(let Ye=0;Ye<T.textures.length;Ye++){const qe=Pe.get(T.textures[Ye]);F.framebufferTextureLayer(F.FRAMEBUFFER,F.COLOR_ATTACHMENT0+Ye,qe.__webglTexture,Q,Te)}}else if(T!==null&&Q!==0){const Te=Pe.get(T.texture);F.framebufferTexture2D(F.FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_2D,Te.__webglTexture,Q)}b=-1},this.readRenderTargetPixels=function(T,G,Q,Z,X,de,Se,Ie=0){if(!(T&&T.isWebGLRenderTarget)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Te=Pe.get(T).__webglFramebuffer;if(T.isWebGLCubeRenderTarget&&Se!==void 0&&(Te=Te[Se]),Te){Ne.bindFramebuffer(F.FRAMEBUFFER,Te);try{const Ye=T.textures[Ie],qe=Ye.format,He=Ye.type;if(!We.textureFormatReadable(qe)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(!We.textureTypeReadable(He)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}G>=0&&G<=T.width-Z&&Q>=0&&Q<=T.height-X&&(T.textures.length>1&&F.readBuffer(F.COLOR_ATTACHMENT0+Ie),F.readPixels(G,Q,Z,X,ke.convert(qe),ke.convert(He),de))}finally{const Ye=N!==null?Pe.get(N).__webglFramebuffer:null;Ne.bindFramebuffer(F.FRAMEBUFFER,Ye)}}},this.readRenderTargetPixelsAsync=async function(T,G,Q,Z,X,de,Se,Ie=0){if(!(T&&T.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Te=Pe.get(T).__webglFramebuffer;if(T.isWebGLCubeRenderTarget&&Se!==void 0&&(Te=Te[Se]),Te)if(G>=0&&G<=T.width-Z&&Q>=0&&Q<=T.height-X){Ne.bindFramebuffer(F.FRAMEBUFFER,Te);const Ye=T.textures[Ie],qe=Ye.format,He=Ye.type;if(!We.textureFormatReadable(qe))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(!We.textureTypeReadable(He))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");const ot=F.createBuffer();F.bindBuffer(F.PIXEL_PACK_BUFFER,ot),F.bufferData(F.PIXEL_PACK_BUFFER,de.byteLength,F.STREAM_READ),T.textures.length>1&&F.readBuffer(F.COLOR_ATTACHMENT0+Ie),F.readPixels(G,Q,Z,X,ke.convert(qe),ke.convert(He),0);const gt=N!==null?Pe.get(N).__webglFramebuffer:null;Ne.bindFramebuffer(F.FRAMEBUFFER,gt);const Bt=F.fenceSync(F.SYNC_GPU_COMMANDS_COMPLETE,0);return F.flush(),await kx(F,Bt,4),F.bindBuffer(F.PIXEL_PACK_BUFFER,ot),F.getBufferSubData(F.PIXEL_PACK_BUFFER,0,de),F.deleteBuffer(ot),F.deleteSync(Bt),de}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(T,G=null,Q=0){const Z=Math.pow(2,-Q),X=Math.floor(T.image.width*Z),de=Math.floor(T.image.height*Z),Se=G!==null?G.x:0,Ie=G!==null?G.y:0;Ge.setTexture2D(T,0),F.copyTexSubImage2D(F.TEXTURE_2D,Q,0,0,Se,Ie,X,de),Ne.unbindTexture()};const Ii=F.createFramebuffer(),cn=F.createFramebuffer();this.copyTextureToTexture=function(T,G,Q=null,Z=null,X=0,de=null){de===null&&(X!==0?(Ma("WebGLRenderer: copyTextureToTexture function signature has changed to support src and dst mipmap levels."),de=X,X=0):de=0);let Se,Ie,Te,Ye,qe,He,ot,gt,Bt;const At=T.isCompressedTexture?T.mipmaps[de]:T.image;if(Q!==null)Se=Q.max.x-Q.min.x,Ie=Q.max.y-Q.min.y,Te=Q.isBox3?Q.max.z-Q.min.z:1,Ye=Q.min.x,qe=Q.min.y,He=Q.isBox3?Q.min.z:0;else{const $n=Math.pow(2,-X);Se=Math.floor(At.width*$n),Ie=Math.floor(At.height*$n),T.isDataArrayTexture?Te=At.depth:T.isData3DTexture?Te=Math.floor(At.depth*$n):Te=1,Ye=0,qe=0,He=0}Z!==null?(ot=Z.x,gt=Z.y,Bt=Z.z):(ot=0,gt=0,Bt=0);const st=ke.convert(G.format),Xe=ke.convert(G.type);let zt;G.isData3DTexture?(Ge.setTexture3D(G,0),zt=F.TEXTURE_3D):G.isDataArrayTexture||G.isCompressedArrayTexture?(Ge.setTexture2DArray(G,0),zt=F.TEXTURE_2D_ARRAY):(Ge.setTexture2D(G,0),zt=F.TEXTURE_2D),F.pixelStorei(F.UNPACK_FLIP_Y_WEBGL,G.flipY),F.pixelStorei(F.UNPACK_PREMULTIPLY_ALPHA_WEBGL,G.premultiplyAlpha),F.pixelStorei(F.UNPACK_ALIGNMENT,G.unpackAlignment);const dt=F.getParameter(F.UNPACK_ROW_LENGTH),Dn=F.getParameter(F.UNPACK_IMAGE_HEIGHT),fs=F.getParameter(F.UNPACK_SKIP_PIXELS),kn=F.getParameter(F.UNPACK_SKIP_ROWS),Hs=F.getParameter(F.UNPACK_SKIP_IMAGES);F.pixelStorei(F.UNPACK_ROW_LENGTH,At.width),F.pixelStorei(F.UNPACK_IMAGE_HEIGHT,At.height),F.pixelStorei(F.UNPACK_SKIP_PIXELS,Ye),F.pixelStorei(F.UNPACK_SKIP_ROWS,qe),F.pixelStorei(F.UNPACK_SKIP_IMAGES,He);const Ht=T.isDataArrayTexture||T.isData3DTexture,Bn=G.isDataArrayTexture||G.isData3DTexture;if(T.isDepthTexture){const $n=Pe.get(T),vn=Pe.get(G),xn=Pe.get($n.__renderTarget),ds=Pe.get(vn.__renderTarget);Ne.bindFramebuffer(F.READ_FRAMEBUFFER,xn.__webglFramebuffer),Ne.bindFramebuffer(F.DRAW_FRAMEBUFFER,ds.__webglFramebuffer);for(let li=0;li<Te;li++)Ht&&(F.framebufferTextureLayer(F.READ_FRAMEBUFFER,F.COLOR_ATTACHMENT0,Pe.get(T).__webglTexture,X,He+li),F.framebufferTextureLayer(F.DRAW_FRAMEBUFFER,F.COLOR_ATTACHMENT0,Pe.get(G).__webglTexture,de,Bt+li)),F.blitFramebuffer(Ye,qe,Se,Ie,ot,gt,Se,Ie,F.DEPTH_BUFFER_BIT,F.NEAREST);Ne.bindFramebuffer(F.READ_FRAMEBUFFER,null),Ne.bindFramebuffer(F.DRAW_FRAMEBUFFER,null)}else if(X!==0||T.isRenderTargetTexture||Pe.has(T)){const $n=Pe.get(T),vn=Pe.get(G);Ne.bindFramebuffer(F.READ_FRAMEBUFFER,Ii),Ne.bindFramebuffer(F.DRAW_FRAMEBUFFER,cn);for(let xn=0;xn<Te;xn++)Ht?F.framebufferTextureLayer(F.READ_FRAMEBUFFER,F.COLOR_ATTACHMENT0,$n.__webglTexture,X,He+xn):F.framebufferTexture2D(F.READ_FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_2D,$n.__webglTexture,X),Bn?F.framebufferTextureLayer(F.DRAW_FRAMEBUFFER,F.COLOR_ATTACHMENT0,vn.__webglTexture,de,Bt+xn):F.framebufferTexture2D(F.DRAW_FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_2D,vn.__webglTexture,de),X!==0?F.blitFramebuffer(Ye,qe,Se,Ie,ot,gt,Se,Ie,F.COLOR_BUFFER_BIT,F.NEAREST):Bn?F.copyTexSubImage3D(zt,de,ot,gt,Bt+xn,Ye,qe,Se,Ie):F.copyTexSubImage2D(zt,de,ot,gt,Ye,qe,Se,Ie);Ne.bindFramebuffer(F.READ_FRAMEBUFFER,null),Ne.bindFramebuffer(F.DRAW_FRAMEBUFFER,null)}else Bn?T.isDataTexture||T.isData3DTexture?F.texSubImage3D(zt,de,ot,gt,Bt,Se,Ie,Te,st,Xe,At.data):G.isCompressedArrayTexture?F.compressedTexSubImage3D(zt,de,ot,gt,Bt,Se,Ie,Te,st,At.data):F.texSubImage3D(zt,de,ot,gt,Bt,Se,Ie,Te,st,Xe,At):T.isDataTexture?F.texSubImage2D(F.TEXTURE_2D,de,ot,gt,Se,Ie,st,Xe,At.data):T.isCompressedTexture?F.compressedTexSubImage2D(F.TEXTURE_2D,de,ot,gt,At.width,At.height,st,At.data):F.texSubImage2D(F.TEXTURE_2D,de,ot,gt,Se,Ie,st,Xe,At);F.pixelStorei(F.UNPACK_ROW_LENGTH,dt),F.pixelStorei(F.UNPACK_IMAGE_HEIGHT,Dn),F.pixelStorei(F.UNPACK_SKIP_PIXELS,fs),F.pixelStorei(F.UNPACK_SKIP_ROWS,kn),F.pixelStorei(F.UNPACK_SKIP_IMAGES,Hs),de===0&&G.generateMipmaps&&F.generateMipmap(zt),Ne.unbindTexture()},this.initRenderTarget=function(T){Pe.get(T).__webglFramebuffer===void 0&&Ge.setupRenderTarget(T)},this.initTexture=function(T){T.isCubeTexture?Ge.setTextureCube(T,0):T.isData3DTexture?Ge.setTexture3D(T,0):T.isDataArrayTexture||T.isCompressedArrayTexture?Ge.setTexture2DArray(T,0):Ge.setTexture2D(T,0),Ne.unbindTexture()},this.resetState=function(){A=0,U=0,N=null,Ne.reset(),ye.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Xi}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;const t=this.getContext();t.drawingBufferColorSpace=xt._getDrawingBufferColorSpace(e),t.unpackColorSpace=xt._getUnpackColorSpace()}}const Up={type:"change"},af={type:"start"},W_={type:"end"},ol=new nc,Np=new Cs,hw=Math.cos(70*Fx.DEG2RAD),hn=new k,Zn=2*Math.PI,Lt={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},sh=1e-6;class uw extends k_{constructor(e,t=null){super(e,t),this.state=Lt.NONE,this.target=new k,this.cursor=new k,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:Jr.ROTATE,MIDDLE:Jr.DOLLY,RIGHT:Jr.PAN},this.touches={ONE:qr.ROTATE,TWO:qr.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._domElementKeyEvents=null,this._lastPosition=new k,this._lastQuaternion=new Rn,this._lastTargetPosition=new k,this._quat=new Rn().setFromUnitVectors(e.up,new k(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new lp,this._sphericalDelta=new lp,this._scale=1,this._panOffset=new k,this._rotateStart=new Ke,this._rotateEnd=new Ke,this._rotateDelta=new Ke,this._panStart=new Ke,this._panEnd=new Ke,this._panDelta=new Ke,this._dollyStart=new Ke,this._dollyEnd=new Ke,this._dollyDelta=new Ke,this._dollyDirection=new k,this._mouse=new Ke,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=dw.bind(this),this._onPointerDown=fw.bind(this),this._onPointerUp=pw.bind(this),this._onContextMenu=yw.bind(this),this._onMouseWheel=gw.bind(this),this._onKeyDown=vw.bind(this),this._onTouchStart=xw.bind(this),this._onTouchMove=Mw.bind(this),this._onMouseDown=mw.bind(this),this._onMouseMove=_w.bind(this),this._interceptControlDown=Sw.bind(this),this._interceptControlUp=Ew.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}connect(e){super.connect(e),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.getRootNode().addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.removeEventListener("pointermove",this._onPointerMove),this.domElement.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.getRootNode().removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.style.touchAction="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(e){e.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=e}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(Up),this.update(),this.state=Lt.NONE}update(e=null){const t=this.object.position;hn.copy(t).sub(this.target),hn.applyQuaternion(this._quat),this._spherical.setFromVector3(hn),this.autoRotate&&this.state===Lt.NONE&&this._rotateLeft(this._getAutoRotationAngle(e)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let i=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(i)&&isFinite(s)&&(i<-Math.PI?i+=Zn:i>Math.PI&&(i-=Zn),s<-Math.PI?s+=Zn:s>Math.PI&&(s-=Zn),i<=s?this._spherical.theta=Math.max(i,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(i+s)/2?Math.max(i,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{const o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(hn.setFromSpherical(this._spherical),hn.applyQuaternion(this._quatInverse),t.copy(this.target).add(hn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){const a=hn.length();o=this._clampDistance(a*this._scale);const l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){const a=new k(this._mouse.x,this._mouse.y,0);a.unproject(this.object);const l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;const c=new k(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=hn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(ol.origin.copy(this.object.position),ol.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(ol.direction))<hw?this.object.lookAt(this.target):(Np.setFromNormalAndCoplanarPoint(this.object.up,this.target),ol.intersectPlane(Np,this.target))))}else if(this.object.isOrthographicCamera){const o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>sh||8*(1-this._lastQuaternion.dot(this.object.quaternion))>sh||this._lastTargetPosition.distanceToSquared(this.target)>sh?(this.dispatchEvent(Up),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(e){return e!==null?Zn/60*this.autoRotateSpeed*e:Zn/60/60*this.autoRotateSpeed}_getZoomScale(e){const t=Math.abs(e*.01);return Math.pow(.95,this.zoomSpeed*t)}_rotateLeft(e){this._sphericalDelta.theta-=e}_rotateUp(e){this._sphericalDelta.phi-=e}_panLeft(e,t){hn.setFromMatrixColumn(t,0),hn.multiplyScalar(-e),this._panOffset.add(hn)}_panUp(e,t){this.screenSpacePanning===!0?hn.setFromMatrixColumn(t,1):(hn.setFromMatrixColumn(t,0),hn.crossVectors(this.object.up,hn)),hn.multiplyScalar(e),this._panOffset.add(hn)}_pan(e,t){const i=this.domElement;if(this.object.isPerspectiveCamera){const s=this.object.position;hn.copy(s).sub(this.target);let r=hn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*e*r/i.clientHeight,this.object.matrix),this._panUp(2*t*r/i.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(e*(this.object.right-this.object.left)/this.object.zoom/i.clientWidth,this.object.matrix),this._panUp(t*(this.object.top-this.object.bottom)/this.object.zoom/i.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(e,t){if(!this.zoomToCursor)return;this._performCursorZoom=!0;const i=this.domElement.getBoundingClientRect(),s=e-i.left,r=t-i.top,o=i.width,a=i.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(e){return Math.max(this.minDistance,Math.min(this.maxDistance,e))}_handleMouseDownRotate(e){this._rotateStart.set(e.clientX,e.clientY)}_handleMouseDownDolly(e){this._updateZoomParameters(e.clientX,e.clientX),this._dollyStart.set(e.clientX,e.clientY)}_handleMouseDownPan(e){this._panStart.set(e.clientX,e.clientY)}_handleMouseMoveRotate(e){this._rotateEnd.set(e.clientX,e.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);const t=this.domElement;this._rotateLeft(Zn*this._rotateDelta.x/t.clientHeight),this._rotateUp(Zn*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(e){this._dollyEnd.set(e.clientX,e.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.update()}_handleMouseMovePan(e){this._panEnd.set(e.clientX,e.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(e){this._updateZoomParameters(e.clientX,e.clientY),e.deltaY<0?this._dollyIn(this._getZoomScale(e.deltaY)):e.deltaY>0&&this._dollyOut(this._getZoomScale(e.deltaY)),this.update()}_handleKeyDown(e){let t=!1;switch(e.code){case this.keys.UP:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(Zn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),t=!0;break;case this.keys.BOTTOM:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(-Zn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),t=!0;break;case this.keys.LEFT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(Zn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),t=!0;break;case this.keys.RIGHT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(-Zn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),t=!0;break}t&&(e.preventDefault(),this.update())}_handleTouchStartRotate(e){if(this._pointers.length===1)this._rotateStart.set(e.pageX,e.pageY);else{const t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._rotateStart.set(i,s)}}_handleTouchStartPan(e){if(this._pointers.length===1)this._panStart.set(e.pageX,e.pageY);else{const t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panStart.set(i,s)}}_handleTouchStartDolly(e){const t=this._getSecondPointerPosition(e),i=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(i*i+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enablePan&&this._handleTouchStartPan(e)}_handleTouchStartDollyRotate(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enableRotate&&this._handleTouchStartRotate(e)}_handleTouchMoveRotate(e){if(this._pointers.length==1)this._rotateEnd.set(e.pageX,e.pageY);else{const i=this._getSecondPointerPosition(e),s=.5*(e.pageX+i.x),r=.5*(e.pageY+i.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);const t=this.domElement;this._rotateLeft(Zn*this._rotateDelta.x/t.clientHeight),this._rotateUp(Zn*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(e){if(this._pointers.length===1)this._panEnd.set(e.pageX,e.pageY);else{const t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panEnd.set(i,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(e){const t=this._getSecondPointerPosition(e),i=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(i*i+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);const o=(e.pageX+t.x)*.5,a=(e.pageY+t.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enablePan&&this._handleTouchMovePan(e)}_handleTouchMoveDollyRotate(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enableRotate&&this._handleTouchMoveRotate(e)}_addPointer(e){this._pointers.push(e.pointerId)}_removePointer(e){delete this._pointerPositions[e.pointerId];for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId){this._pointers.splice(t,1);return}}_isTrackingPointer(e){for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId)return!0;return!1}_trackPointer(e){let t=this._pointerPositions[e.pointerId];t===void 0&&(t=new Ke,this._pointerPositions[e.pointerId]=t),t.set(e.pageX,e.pageY)}_getSecondPointerPosition(e){const t=e.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[t]}_customWheelEvent(e){const t=e.deltaMode,i={clientX:e.clientX,clientY:e.clientY,deltaY:e.deltaY};switch(t){case 1:i.deltaY*=16;break;case 2:i.deltaY*=100;break}return e.ctrlKey&&!this._controlActive&&(i.deltaY*=10),i}}function fw(n){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(n.pointerId),this.domElement.addEventListener("pointermove",this._onPointerMove),this.domElement.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(n)&&(this._addPointer(n),n.pointerType==="touch"?this._onTouchStart(n):this._onMouseDown(n)))}function dw(n){this.enabled!==!1&&(n.pointerType==="touch"?this._onTouchMove(n):this._onMouseMove(n))}function pw(n){switch(this._removePointer(n),this._pointers.length){case 0:this.domElement.releasePointerCapture(n.pointerId),this.domElement.removeEventListener("pointermove",this._onPointerMove),this.domElement.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(W_),this.state=Lt.NONE;break;case 1:const e=this._pointers[0],t=this._pointerPositions[e];this._onTouchStart({pointerId:e,pageX:t.x,pageY:t.y});break}}function mw(n){let e;switch(n.button){case 0:e=this.mouseButtons.LEFT;break;case 1:e=this.mouseButtons.MIDDLE;break;case 2:e=this.mouseButtons.RIGHT;break;default:e=-1}switch(e){case Jr.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(n),this.state=Lt.DOLLY;break;case Jr.ROTATE:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Lt.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Lt.ROTATE}break;case Jr.PAN:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Lt.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Lt.PAN}break;default:this.state=Lt.NONE}this.state!==Lt.NONE&&this.dispatchEvent(af)}function _w(n){switch(this.state){case Lt.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(n);break;case Lt.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(n);break;case Lt.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(n);break}}function gw(n){this.enabled===!1||this.enableZoom===!1||this.state!==Lt.NONE||(n.preventDefault(),this.dispatchEvent(af),this._handleMouseWheel(this._customWheelEvent(n)),this.dispatchEvent(W_))}function vw(n){this.enabled!==!1&&this._handleKeyDown(n)}function xw(n){switch(this._trackPointer(n),this._pointers.length){case 1:switch(this.touches.ONE){case qr.ROTATE:if(this.enableRotate===!1)return;this._handleTouchStartRotate(n),this.state=Lt.TOUCH_ROTATE;break;case qr.PAN:if(this.enablePan===!1)return;this._handleTouchStartPan(n),this.state=Lt.TOUCH_PAN;break;default:this.state=Lt.NONE}break;case 2:switch(this.touches.TWO){case qr.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(n),this.state=Lt.TOUCH_DOLLY_PAN;break;case qr.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(n),this.state=Lt.TOUCH_DOLLY_ROTATE;break;default:this.state=Lt.NONE}break;default:this.state=Lt.NONE}this.state!==Lt.NONE&&this.dispatchEvent(af)}function Mw(n){switch(this._trackPointer(n),this.state){case Lt.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(n),this.update();break;case Lt.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(n),this.update();break;case Lt.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(n),this.update();break;case Lt.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(n),this.update();break;default:this.state=Lt.NONE}}function yw(n){this.enabled!==!1&&n.preventDefault()}function Sw(n){n.key==="Control"&&(this._controlActive=!0,this.domElement.getRootNode().addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function Ew(n){n.key==="Control"&&(this._controlActive=!1,this.domElement.getRootNode().removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}const bw=new Je(8141549),ww=new Je(0);class Tw{constructor(e){this.invalidate=e}invalidate;object=new Yi;links=[];parts=[];axes=[];collision=[];cache=new Map;matrices=null;generation=0;async load(e){const t=++this.generation,i=new Map,s=new Set(e.links.flatMap(r=>r.parts.map(o=>o.mesh)));await Promise.all([...s].map(async r=>i.set(r,await this.geometry(r)))),t===this.generation&&(this.object.clear(),this.links=[],this.parts=[],this.axes=[],this.collision=[],e.links.forEach((r,o)=>{const a=new Yi;a.name=r.name,a.matrixAutoUpdate=!1;for(const c of r.parts){const h=i.get(c.mesh);if(!h)continue;const[f,d,u,_]=c.color,v=new xM({color:new Je().setRGB(f,d,u,"srgb"),roughness:.46,metalness:.08,side:cs,opacity:_,transparent:_<1,wireframe:c.collision}),m=new be(h,v);m.castShadow=m.receiveShadow=!c.collision,m.visible=!c.collision,lf(m,c.placed),c.collision?this.collision.push(m):this.parts.push({geometry:h,placed:m.matrix.clone(),link:o}),a.add(m)}const l=new O_(.11*e.reach);l.visible=!1,this.axes.push(l),a.add(l),this.links.push(a),this.object.add(a)}),this.matrices&&this.move(this.matrices),this.invalidate())}geometry(e){let t=this.cache.get(e);return t||(t=fetch(`/mesh/${e}`).then(async i=>{const s=new nn,r=i.ok?Hg(await i.arrayBuffer()):null;return r&&(s.setAttribute("position",new Cn(r.positions,3)),s.setAttribute("normal",new Cn(r.normals,3)),s.setIndex(new Cn(r.indices,1))),s}),this.cache.set(e,t)),t}move(e){this.matrices=e,!(e.length<16*this.links.length)&&this.links.forEach((t,i)=>{t.matrix.fromArray(e,16*i),t.matrixWorldNeedsUpdate=!0})}highlight(e){this.links.forEach((t,i)=>{for(const s of t.children)if(s instanceof be){const r=s.material;r.emissive=i===e?bw:ww,r.emissiveIntensity=i===e?.75:0}}),this.invalidate()}showFrames(e){for(const t of this.axes)t.visible=e;this.invalidate()}showCollision(e){for(const t of this.collision)t.visible=e;this.invalidate()}}const rh=16,Aw=new Je(8141549);class Rw{object=new Yi;meshes=[];plainColor=new Je(7042182);frame=null;hidden=[];pointed=null;load(e){this.object.clear(),this.meshes.forEach(({mesh:t})=>t.dispose()),this.meshes=e.parts.map(t=>{const i=new MM({transparent:!0,opacity:.17,depthWrite:!1,polygonOffset:!0,polygonOffsetFactor:3,polygonOffsetUnits:12}),s=new fM(t.geometry,i,rh);return s.frustumCulled=!1,s.count=0,s.renderOrder=2,this.object.add(s),{mesh:s,part:t}}),this.frame&&this.move(this.frame,this.hidden)}setDark(e){this.plainColor=new Je(e?11187141:5989496),this.paint()}move(e,t){this.frame=e,this.hidden=t;const i=[];for(let r=0;r<Math.min(e.count,rh);r++)t[r]||i.push(r);const s=new Rt;for(const{mesh:r,part:o}of this.meshes){r.count=0;for(const a of i){const l=16*(a*e.links+o.link);l+16>e.matrices.length||r.setMatrixAt(r.count++,s.fromArray(e.matrices,l).multiply(o.placed))}r.instanceMatrix.needsUpdate=!0}this.paint()}point(e){this.pointed=e,this.paint()}paint(){if(!this.frame)return;const e=[];for(let t=0;t<Math.min(this.frame.count,rh);t++)this.hidden[t]||e.push(t);for(const{mesh:t}of this.meshes)e.forEach((i,s)=>t.setColorAt(s,i===this.pointed?Aw:this.plainColor)),t.instanceColor&&(t.instanceColor.needsUpdate=!0),t.material.opacity=this.pointed===null?.17:.24}}const Cw=`
varying vec2 place;
void main() { place = position.xy; gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0); }`,Pw=`
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
}`;class Dw{object=new Yi;grid;shadow=new vM({opacity:.2,depthWrite:!1});planes;constructor(){this.grid=new hs({vertexShader:Cw,fragmentShader:Pw,transparent:!0,depthWrite:!1,uniforms:{ink:{value:new Je(3883602)},strength:{value:.34},span:{value:4},cell:{value:.1}}});const e=new be(new Is(2,2),this.grid),t=new be(new Is(2,2),this.shadow);t.receiveShadow=!0,t.position.z=-5e-4,e.renderOrder=t.renderOrder=-1,this.planes=[e,t],this.object.add(e,t)}resize(e){const t=3.2*e;for(const o of this.planes)o.geometry.dispose(),o.geometry=new Is(2*t,2*t),o.position.z=-.001*e;const i=e/8,s=10**Math.floor(Math.log10(i)),r=s*([1,2,5,10].find(o=>o*s>=i)??10);this.grid.uniforms.span.value=t,this.grid.uniforms.cell.value=r/1}setDark(e){this.grid.uniforms.ink.value.set(e?11187400:3883602),this.grid.uniforms.strength.value=e?.22:.3,this.shadow.opacity=e?.42:.2}}const Fp=600;class Lw{object=new Yi;way=new di(new nn,new to({color:8141549,transparent:!0,opacity:.85}));trail;points=new Float32Array(3*Fp);length=0;reach=new gM(new nn,new to({transparent:!0,opacity:.6}));constructor(){const e=new nn;e.setAttribute("position",new Cn(this.points,3).setUsage(Ux)),e.setDrawRange(0,0),this.trail=new di(e,new to({color:15227148,transparent:!0,opacity:.9})),this.trail.frustumCulled=this.way.frustumCulled=!1,this.reach.visible=!1,this.object.add(this.way,this.trail,this.reach)}setDark(e){this.way.material.color=new Je(e?10980346:7153881),this.trail.material.color=new Je(e?16486972:14239759),this.reach.material.color=new Je(e?6220500:1013358)}setWay(e){this.way.geometry.dispose(),this.way.geometry=new nn,this.way.geometry.setAttribute("position",new Cn(new Float32Array(e.flat()),3))}add(e){const t=3*(this.length-1);if(this.length>0&&Math.hypot(...e.map((r,o)=>r-this.points[t+o]))<1e-5)return;this.length===Fp&&(this.points.copyWithin(0,3),this.length-=1),this.points.set(e,3*this.length),this.length+=1;const{geometry:i}=this.trail;i.setDrawRange(0,this.length),i.attributes.position.needsUpdate=!0}clearTrail(){this.length=0,this.trail.geometry.setDrawRange(0,0)}showTrail(e){this.trail.visible=this.way.visible=e}outline(e){const t=e.outline.map(([s,r])=>[s,0,r]),i=[...e.outline].reverse().map(([s,r])=>[-s,0,r]);this.reach.geometry.dispose(),this.reach.geometry=new nn,this.reach.geometry.setAttribute("position",new Cn(new Float32Array([...t,...i].flat()),3)),lf(this.reach,e.outline_frame),this.clearTrail()}showOutline(e){this.reach.visible=e}}const zo=new URLSearchParams(location.search).has("plain");class Iw{constructor(e){this.canvas=e,this.renderer=new cw({canvas:e,antialias:!zo,alpha:!0,preserveDrawingBuffer:zo,powerPreference:"high-performance"}),this.renderer.toneMapping=m_,this.renderer.toneMappingExposure=1.05,this.renderer.shadowMap.enabled=!zo,this.renderer.shadowMap.type=p_,this.perspective.up.set(0,0,1),this.orthographic.up.set(0,0,1),this.controls=new uw(this.perspective,e),this.controls.zoomToCursor=!0,this.controls.enableDamping=!1,this.controls.addEventListener("change",()=>this.invalidate()),this.arm=new Tw(()=>this.invalidate()),this.ghosts=new Rw,this.sun.castShadow=!zo,this.sun.shadow.mapSize.set(2048,2048),this.sun.shadow.radius=6,this.sun.shadow.bias=-4e-4,this.sun.shadow.normalBias=.01,this.tool.add(this.triad),this.scene.add(this.sky,this.sun,this.sun.target,this.fill,this.ground.object,this.arm.object,this.ghosts.object,this.path.object,this.tool),new ResizeObserver(()=>this.resize()).observe(e.parentElement),this.resize()}canvas;renderer;scene=new cM;perspective=new _i(38,1,.01,200);orthographic=new rf(-1,1,1,-1,-100,200);camera=this.perspective;controls;arm;ghosts;ground=new Dw;path=new Lw;tool=new Yi;triad=new O_(1);sun=new rp(16777215,2.2);sky=new EM(16777215,9080730,1.5);fill=new rp(14673663,.7);reach=1;wanted=!1;statistics={pictures:0,calls:0,triangles:0,milliseconds:0};beforeDraw=[];invalidate(){this.wanted||(this.wanted=!0,requestAnimationFrame(()=>{this.wanted=!1,this.draw()}))}onDraw(e){this.beforeDraw.push(e)}draw(){const e=performance.now();for(const s of this.beforeDraw)s();this.renderer.render(this.scene,this.camera);const{calls:t,triangles:i}=this.renderer.info.render;Object.assign(this.statistics,{calls:t,triangles:i,milliseconds:performance.now()-e}),this.statistics.pictures+=1}resize(){const e=this.canvas.parentElement,[t,i]=[Math.max(1,e.clientWidth),Math.max(1,e.clientHeight)];this.renderer.setPixelRatio(zo?1:Math.min(devicePixelRatio,2)),this.renderer.setSize(t,i,!1),this.perspective.aspect=t/i,this.perspective.updateProjectionMatrix(),this.matchOrthographic(),this.invalidate()}async show(e,t){this.reach=e.reach,this.perspective.near=e.reach/200,this.perspective.far=e.reach*200;const i=e.reach;this.sun.position.set(1.2*i,-1.6*i,3.2*i),this.fill.position.set(-2*i,1.5*i,1.2*i);const s=this.sun.shadow.camera;Object.assign(s,{left:-1.7*i,right:1.7*i,top:1.7*i,bottom:-1.7*i,near:.2*i,far:8*i}),s.updateProjectionMatrix(),this.triad.scale.setScalar(.12*i),this.ground.resize(i),await this.arm.load(e),this.ghosts.load(this.arm),this.path.outline(e),t||this.fit("home"),this.invalidate()}setDark(e){this.scene.background=null,this.sky.intensity=e?1.05:1.5,this.sky.groundColor=new Je(e?2764086:10133160),this.ground.setDark(e),this.path.setDark(e),this.ghosts.setDark(e),this.invalidate()}fit(e){const t=new Os().setFromObject(this.arm.object);t.isEmpty()&&t.setFromCenterAndSize(new k(0,0,this.reach/2),new k(1,1,1).multiplyScalar(this.reach));const i=t.getBoundingSphere(new xr),s={home:new k(1,-1.25,.62),front:new k(1,0,0),right:new k(0,-1,0),top:new k(0,-1e-4,1),here:this.camera.position.clone().sub(this.controls.target)},r=Math.min(1,this.perspective.aspect),o=1.08*i.radius/Math.sin(this.perspective.fov*Math.PI/360)/r;this.controls.target.copy(i.center),this.perspective.position.copy(i.center).addScaledVector(s[e].normalize(),o),this.orthographic.position.copy(this.perspective.position),this.matchOrthographic(),this.controls.update(),this.invalidate()}toggleProjection(){const e=this.camera===this.perspective?this.orthographic:this.perspective;e.position.copy(this.camera.position),this.camera=e,this.controls.object=e,this.matchOrthographic(),this.controls.update(),this.invalidate()}matchOrthographic(){const e=this.controls?this.camera.position.distanceTo(this.controls.target)*Math.tan(this.perspective.fov*Math.PI/360):1,{aspect:t}=this.perspective;Object.assign(this.orthographic,{left:-e*t,right:e*t,top:e,bottom:-e}),this.orthographic.updateProjectionMatrix()}ray(e){const t=this.canvas.getBoundingClientRect(),i=new Ke(2*(e.clientX-t.left)/t.width-1,1-2*(e.clientY-t.top)/t.height),s=new F_;return s.setFromCamera(i,this.camera),{origin:s.ray.origin.toArray(),direction:s.ray.direction.toArray()}}project(e){const t=this.canvas.getBoundingClientRect(),i=new k(...e).project(this.camera);return[t.left+(i.x+1)/2*t.width,t.top+(1-i.y)/2*t.height]}setTool(e){lf(this.tool,e),this.tool.updateMatrixWorld()}get size(){return this.reach}}function lf(n,e){n.matrixAutoUpdate=!1;const t=e.flat();n.matrix.set(...t),n.matrixWorldNeedsUpdate=!0}const Ks=new F_,Nn=new k,ws=new k,jt=new Rn,Op={X:new k(1,0,0),Y:new k(0,1,0),Z:new k(0,0,1)},oh={type:"change"},kp={type:"mouseDown",mode:null},Bp={type:"mouseUp",mode:null},zp={type:"objectChange"};class Uw extends k_{constructor(e,t=null){super(void 0,t);const i=new zw(this);this._root=i;const s=new Hw;this._gizmo=s,i.add(s);const r=new Vw;this._plane=r,i.add(r);const o=this;function a(w,x){let L=x;Object.defineProperty(o,w,{get:function(){return L!==void 0?L:x},set:function(A){L!==A&&(L=A,r[w]=A,s[w]=A,o.dispatchEvent({type:w+"-changed",value:A}),o.dispatchEvent(oh))}}),o[w]=x,r[w]=x,s[w]=x}a("camera",e),a("object",void 0),a("enabled",!0),a("axis",null),a("mode","translate"),a("translationSnap",null),a("rotationSnap",null),a("scaleSnap",null),a("space","world"),a("size",1),a("dragging",!1),a("showX",!0),a("showY",!0),a("showZ",!0),a("minX",-1/0),a("maxX",1/0),a("minY",-1/0),a("maxY",1/0),a("minZ",-1/0),a("maxZ",1/0);const l=new k,c=new k,h=new Rn,f=new Rn,d=new k,u=new Rn,_=new k,v=new k,m=new k,p=0,y=new k;a("worldPosition",l),a("worldPositionStart",c),a("worldQuaternion",h),a("worldQuaternionStart",f),a("cameraPosition",d),a("cameraQuaternion",u),a("pointStart",_),a("pointEnd",v),a("rotationAxis",m),a("rotationAngle",p),a("eye",y),this._offset=new k,this._startNorm=new k,this._endNorm=new k,this._cameraScale=new k,this._parentPosition=new k,this._parentQuaternion=new Rn,this._parentQuaternionInv=new Rn,this._parentScale=new k,this._worldScaleStart=new k,this._worldQuaternionInv=new Rn,this._worldScale=new k,this._positionStart=new k,this._quaternionStart=new Rn,this._scaleStart=new k,this._getPointer=Nw.bind(this),this._onPointerDown=Ow.bind(this),this._onPointerHover=Fw.bind(this),this._onPointerMove=kw.bind(this),this._onPointerUp=Bw.bind(this),t!==null&&this.connect(t)}connect(e){super.connect(e),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointermove",this._onPointerHover),this.domElement.addEventListener("pointerup",this._onPointerUp),this.domElement.style.touchAction="none"}disconnect(){this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.removeEventListener("pointermove",this._onPointerHover),this.domElement.removeEventListener("pointermove",this._onPointerMove),this.domElement.removeEventListener("pointerup",this._onPointerUp),this.domElement.style.touchAction="auto"}getHelper(){return this._root}pointerHover(e){if(this.object===void 0||this.dragging===!0)return;e!==null&&Ks.setFromCamera(e,this.camera);const t=ah(this._gizmo.picker[this.mode],Ks);t?this.axis=t.object.name:this.axis=null}pointerDown(e){if(!(this.object===void 0||this.dragging===!0||e!=null&&e.button!==0)&&this.axis!==null){e!==null&&Ks.setFromCamera(e,this.camera);const t=ah(this._plane,Ks,!0);t&&(this.object.updateMatrixWorld(),this.object.parent.updateMatrixWorld(),this._positionStart.copy(this.object.position),this._quaternionStart.copy(this.object.quaternion),this._scaleStart.copy(this.object.scale),this.object.matrixWorld.decompose(this.worldPositionStart,this.worldQuaternionStart,this._worldScaleStart),this.pointStart.copy(t.point).sub(this.worldPositionStart)),this.dragging=!0,kp.mode=this.mode,this.dispatchEvent(kp)}}pointerMove(e){const t=this.axis,i=this.mode,s=this.object;let r=this.space;if(i==="scale"?r="local":(t==="E"||t==="XYZE"||t==="XYZ")&&(r="world"),s===void 0||t===null||this.dragging===!1||e!==null&&e.button!==-1)return;e!==null&&Ks.setFromCamera(e,this.camera);const o=ah(this._plane,Ks,!0);if(o){if(this.pointEnd.copy(o.point).sub(this.worldPositionStart),i==="translate")this._offset.copy(this.pointEnd).sub(this.pointStart),r==="local"&&t!=="XYZ"&&this._offset.applyQuaternion(this._worldQuaternionInv),t.indexOf("X")===-1&&(this._offset.x=0),t.indexOf("Y")===-1&&(this._offset.y=0),t.indexOf("Z")===-1&&(this._offset.z=0),r==="local"&&t!=="XYZ"?this._offset.applyQuaternion(this._quaternionStart).divide(this._parentScale):this._offset.applyQuaternion(this._parentQuaternionInv).divide(this._parentScale),s.position.copy(this._offset).add(this._positionStart),this.translationSnap&&(r==="local"&&(s.position.applyQuaternion(jt.copy(this._quaternionStart).invert()),t.search("X")!==-1&&(s.position.x=Math.round(s.position.x/this.translationSnap)*this.translationSnap),t.search("Y")!==-1&&(s.position.y=Math.round(s.position.y/this.translationSnap)*this.translationSnap),t.search("Z")!==-1&&(s.position.z=Math.round(s.position.z/this.translationSnap)*this.translationSnap),s.position.applyQuaternion(this._quaternionStart)),r==="world"&&(s.parent&&s.position.add(Nn.setFromMatrixPosition(s.parent.matrixWorld)),t.search("X")!==-1&&(s.position.x=Math.round(s.position.x/this.translationSnap)*this.translationSnap),t.search("Y")!==-1&&(s.position.y=Math.round(s.position.y/this.translationSnap)*this.translationSnap),t.search("Z")!==-1&&(s.position.z=Math.round(s.position.z/this.translationSnap)*this.translationSnap),s.parent&&s.position.sub(Nn.setFromMatrixPosition(s.parent.matrixWorld)))),s.position.x=Math.max(this.minX,Math.min(this.maxX,s.position.x)),s.position.y=Math.max(this.minY,Math.min(this.maxY,s.position.y)),s.position.z=Math.max(this.minZ,Math.min(this.maxZ,s.position.z));else if(i==="scale"){if(t.search("XYZ")!==-1){let a=this.pointEnd.length()/this.pointStart.length();this.pointEnd.dot(this.pointStart)<0&&(a*=-1),ws.set(a,a,a)}else Nn.copy(this.pointStart),ws.copy(this.pointEnd),Nn.applyQuaternion(this._worldQuaternionInv),ws.applyQuaternion(this._worldQuaternionInv),ws.divide(Nn),t.search("X")===-1&&(ws.x=1),t.search("Y")===-1&&(ws.y=1),t.search("Z")===-1&&(ws.z=1);s.scale.copy(this._scaleStart).multiply(ws),this.scaleSnap&&(t.search("X")!==-1&&(s.scale.x=Math.round(s.scale.x/this.scaleSnap)*this.scaleSnap||this.scaleSnap),t.search("Y")!==-1&&(s.scale.y=Math.round(s.scale.y/this.scaleSnap)*this.scaleSnap||this.scaleSnap),t.search("Z")!==-1&&(s.scale.z=Math.round(s.scale.z/this.scaleSnap)*this.scaleSnap||this.scaleSnap))}else if(i==="rotate"){this._offset.copy(this.pointEnd).sub(this.pointStart);const a=20/this.worldPosition.distanceTo(Nn.setFromMatrixPosition(this.camera.matrixWorld));let l=!1;t==="XYZE"?(this.rotationAxis.copy(this._offset).cross(this.eye).normalize(),this.rotationAngle=this._offset.dot(Nn.copy(this.rotationAxis).cross(this.eye))*a):(t==="X"||t==="Y"||t==="Z")&&(this.rotationAxis.copy(Op[t]),Nn.copy(Op[t]),r==="local"&&Nn.applyQuaternion(this.worldQuaternion),Nn.cross(this.eye),Nn.length()===0?l=!0:this.rotationAngle=this._offset.dot(Nn.normalize())*a),(t==="E"||l)&&(this.rotationAxis.copy(this.eye),this.rotationAngle=this.pointEnd.angleTo(this.pointStart),this._startNorm.copy(this.pointStart).normalize(),this._endNorm.copy(this.pointEnd).normalize(),this.rotationAngle*=this._endNorm.cross(this._startNorm).dot(this.eye)<0?1:-1),this.rotationSnap&&(this.rotationAngle=Math.round(this.rotationAngle/this.rotationSnap)*this.rotationSnap),r==="local"&&t!=="E"&&t!=="XYZE"?(s.quaternion.copy(this._quaternionStart),s.quaternion.multiply(jt.setFromAxisAngle(this.rotationAxis,this.rotationAngle)).normalize()):(this.rotationAxis.applyQuaternion(this._parentQuaternionInv),s.quaternion.copy(jt.setFromAxisAngle(this.rotationAxis,this.rotationAngle)),s.quaternion.multiply(this._quaternionStart).normalize())}this.dispatchEvent(oh),this.dispatchEvent(zp)}}pointerUp(e){e!==null&&e.button!==0||(this.dragging&&this.axis!==null&&(Bp.mode=this.mode,this.dispatchEvent(Bp)),this.dragging=!1,this.axis=null)}dispose(){this.disconnect(),this._root.dispose()}attach(e){return this.object=e,this._root.visible=!0,this}detach(){return this.object=void 0,this.axis=null,this._root.visible=!1,this}reset(){this.enabled&&this.dragging&&(this.object.position.copy(this._positionStart),this.object.quaternion.copy(this._quaternionStart),this.object.scale.copy(this._scaleStart),this.dispatchEvent(oh),this.dispatchEvent(zp),this.pointStart.copy(this.pointEnd))}getRaycaster(){return Ks}getMode(){return this.mode}setMode(e){this.mode=e}setTranslationSnap(e){this.translationSnap=e}setRotationSnap(e){this.rotationSnap=e}setScaleSnap(e){this.scaleSnap=e}setSize(e){this.size=e}setSpace(e){this.space=e}setColors(e,t,i,s){const r=this._gizmo.materialLib;r.xAxis.color.set(e),r.yAxis.color.set(t),r.zAxis.color.set(i),r.active.color.set(s),r.xAxisTransparent.color.set(e),r.yAxisTransparent.color.set(t),r.zAxisTransparent.color.set(i),r.activeTransparent.color.set(s),r.xAxis._color&&r.xAxis._color.set(e),r.yAxis._color&&r.yAxis._color.set(t),r.zAxis._color&&r.zAxis._color.set(i),r.active._color&&r.active._color.set(s),r.xAxisTransparent._color&&r.xAxisTransparent._color.set(e),r.yAxisTransparent._color&&r.yAxisTransparent._color.set(t),r.zAxisTransparent._color&&r.zAxisTransparent._color.set(i),r.activeTransparent._color&&r.activeTransparent._color.set(s)}}function Nw(n){if(this.domElement.ownerDocument.pointerLockElement)return{x:0,y:0,button:n.button};{const e=this.domElement.getBoundingClientRect();return{x:(n.clientX-e.left)/e.width*2-1,y:-(n.clientY-e.top)/e.height*2+1,button:n.button}}}function Fw(n){if(this.enabled)switch(n.pointerType){case"mouse":case"pen":this.pointerHover(this._getPointer(n));break}}function Ow(n){this.enabled&&(document.pointerLockElement||this.domElement.setPointerCapture(n.pointerId),this.domElement.addEventListener("pointermove",this._onPointerMove),this.pointerHover(this._getPointer(n)),this.pointerDown(this._getPointer(n)))}function kw(n){this.enabled&&this.pointerMove(this._getPointer(n))}function Bw(n){this.enabled&&(this.domElement.releasePointerCapture(n.pointerId),this.domElement.removeEventListener("pointermove",this._onPointerMove),this.pointerUp(this._getPointer(n)))}function ah(n,e,t){const i=e.intersectObject(n,!0);for(let s=0;s<i.length;s++)if(i[s].object.visible||t)return i[s];return!1}const al=new Mi,Ut=new k(0,1,0),Hp=new k(0,0,0),Vp=new Rt,ll=new Rn,El=new Rn,Bi=new k,Gp=new Rt,Ko=new k(1,0,0),tr=new k(0,1,0),Jo=new k(0,0,1),cl=new k,Ho=new k,Vo=new k;class zw extends tn{constructor(e){super(),this.isTransformControlsRoot=!0,this.controls=e,this.visible=!1}updateMatrixWorld(e){const t=this.controls;t.object!==void 0&&(t.object.updateMatrixWorld(),t.object.parent===null?console.error("TransformControls: The attached 3D object must be a part of the scene graph."):t.object.parent.matrixWorld.decompose(t._parentPosition,t._parentQuaternion,t._parentScale),t.object.matrixWorld.decompose(t.worldPosition,t.worldQuaternion,t._worldScale),t._parentQuaternionInv.copy(t._parentQuaternion).invert(),t._worldQuaternionInv.copy(t.worldQuaternion).invert()),t.camera.updateMatrixWorld(),t.camera.matrixWorld.decompose(t.cameraPosition,t.cameraQuaternion,t._cameraScale),t.camera.isOrthographicCamera?t.camera.getWorldDirection(t.eye).negate():t.eye.copy(t.cameraPosition).sub(t.worldPosition).normalize(),super.updateMatrixWorld(e)}dispose(){this.traverse(function(e){e.geometry&&e.geometry.dispose(),e.material&&e.material.dispose()})}}class Hw extends tn{constructor(){super(),this.isTransformControlsGizmo=!0,this.type="TransformControlsGizmo";const e=new ic({depthTest:!1,depthWrite:!1,fog:!1,toneMapped:!1,transparent:!0}),t=new to({depthTest:!1,depthWrite:!1,fog:!1,toneMapped:!1,transparent:!0}),i=e.clone();i.opacity=.15;const s=t.clone();s.opacity=.5;const r=e.clone();r.color.setHex(16711680);const o=e.clone();o.color.setHex(65280);const a=e.clone();a.color.setHex(255);const l=e.clone();l.color.setHex(16711680),l.opacity=.5;const c=e.clone();c.color.setHex(65280),c.opacity=.5;const h=e.clone();h.color.setHex(255),h.opacity=.5;const f=e.clone();f.opacity=.25;const d=e.clone();d.color.setHex(16776960),d.opacity=.25;const u=e.clone();u.color.setHex(16776960);const _=e.clone();_.color.setHex(7895160),this.materialLib={xAxis:r,yAxis:o,zAxis:a,active:u,xAxisTransparent:l,yAxisTransparent:c,zAxisTransparent:h,activeTransparent:d};const v=new Un(0,.04,.1,12);v.translate(0,.05,0);const m=new on(.08,.08,.08);m.translate(0,.04,0);const p=new nn;p.setAttribute("position",new qt([0,0,0,1,0,0],3));const y=new Un(.0075,.0075,.5,3);y.translate(0,.25,0);function w(W,j){const q=new rr(W,.0075,3,64,j*Math.PI*2);return q.rotateY(Math.PI/2),q.rotateX(Math.PI/2),q}function x(){const W=new nn;return W.setAttribute("position",new qt([0,0,0,1,1,1],3)),W}const L={X:[[new be(v,r),[.5,0,0],[0,0,-Math.PI/2]],[new be(v,r),[-.5,0,0],[0,0,Math.PI/2]],[new be(y,r),[0,0,0],[0,0,-Math.PI/2]]],Y:[[new be(v,o),[0,.5,0]],[new be(v,o),[0,-.5,0],[Math.PI,0,0]],[new be(y,o)]],Z:[[new be(v,a),[0,0,.5],[Math.PI/2,0,0]],[new be(v,a),[0,0,-.5],[-Math.PI/2,0,0]],[new be(y,a),null,[Math.PI/2,0,0]]],XYZ:[[new be(new $r(.1,0),f),[0,0,0]]],XY:[[new be(new on(.15,.15,.01),h),[.15,.15,0]]],YZ:[[new be(new on(.15,.15,.01),l),[0,.15,.15],[0,Math.PI/2,0]]],XZ:[[new be(new on(.15,.15,.01),c),[.15,0,.15],[-Math.PI/2,0,0]]]},A={X:[[new be(new Un(.2,0,.6,4),i),[.3,0,0],[0,0,-Math.PI/2]],[new be(new Un(.2,0,.6,4),i),[-.3,0,0],[0,0,Math.PI/2]]],Y:[[new be(new Un(.2,0,.6,4),i),[0,.3,0]],[new be(new Un(.2,0,.6,4),i),[0,-.3,0],[0,0,Math.PI]]],Z:[[new be(new Un(.2,0,.6,4),i),[0,0,.3],[Math.PI/2,0,0]],[new be(new Un(.2,0,.6,4),i),[0,0,-.3],[-Math.PI/2,0,0]]],XYZ:[[new be(new $r(.2,0),i)]],XY:[[new be(new on(.2,.2,.01),i),[.15,.15,0]]],YZ:[[new be(new on(.2,.2,.01),i),[0,.15,.15],[0,Math.PI/2,0]]],XZ:[[new be(new on(.2,.2,.01),i),[.15,0,.15],[-Math.PI/2,0,0]]]},U={START:[[new be(new $r(.01,2),s),null,null,null,"helper"]],END:[[new be(new $r(.01,2),s),null,null,null,"helper"]],DELTA:[[new di(x(),s),null,null,null,"helper"]],X:[[new di(p,s),[-1e3,0,0],null,[1e6,1,1],"helper"]],Y:[[new di(p,s),[0,-1e3,0],[0,0,Math.PI/2],[1e6,1,1],"helper"]],Z:[[new di(p,s),[0,0,-1e3],[0,-Math.PI/2,0],[1e6,1,1],"helper"]]},N={XYZE:[[new be(w(.5,1),_),null,[0,Math.PI/2,0]]],X:[[new be(w(.5,.5),r)]],Y:[[new be(w(.5,.5),o),null,[0,0,-Math.PI/2]]],Z:[[new be(w(.5,.5),a),null,[0,Math.PI/2,0]]],E:[[new be(w(.75,1),d),null,[0,Math.PI/2,0]]]},b={AXIS:[[new di(p,s),[-1e3,0,0],null,[1e6,1,1],"helper"]]},E={XYZE:[[new be(new sf(.25,10,8),i)]],X:[[new be(new rr(.5,.1,4,24),i),[0,0,0],[0,-Math.PI/2,-Math.PI/2]]],Y:[[new be(new rr(.5,.1,4,24),i),[0,0,0],[Math.PI/2,0,0]]],Z:[[new be(new rr(.5,.1,4,24),i),[0,0,0],[0,0,-Math.PI/2]]],E:[[new be(new rr(.75,.1,2,24),i)]]},C={X:[[new be(m,r),[.5,0,0],[0,0,-Math.PI/2]],[new be(y,r),[0,0,0],[0,0,-Math.PI/2]],[new be(m,r),[-.5,0,0],[0,0,Math.PI/2]]],Y:[[new be(m,o),[0,.5,0]],[new be(y,o)],[new be(m,o),[0,-.5,0],[0,0,Math.PI]]],Z:[[new be(m,a),[0,0,.5],[Math.PI/2,0,0]],[new be(y,a),[0,0,0],[Math.PI/2,0,0]],[new be(m,a),[0,0,-.5],[-Math.PI/2,0,0]]],XY:[[new be(new on(.15,.15,.01),h),[.15,.15,0]]],YZ:[[new be(new on(.15,.15,.01),l),[0,.15,.15],[0,Math.PI/2,0]]],XZ:[[new be(new on(.15,.15,.01),c),[.15,0,.15],[-Math.PI/2,0,0]]],XYZ:[[new be(new on(.1,.1,.1),f)]]},B={X:[[new be(new Un(.2,0,.6,4),i),[.3,0,0],[0,0,-Math.PI/2]],[new be(new Un(.2,0,.6,4),i),[-.3,0,0],[0,0,Math.PI/2]]],Y:[[new be(new Un(.2,0,.6,4),i),[0,.3,0]],[new be(new Un(.2,0,.6,4),i),[0,-.3,0],[0,0,Math.PI]]],Z:[[new be(new Un(.2,0,.6,4),i),[0,0,.3],[Math.PI/2,0,0]],[new be(new Un(.2,0,.6,4),i),[0,0,-.3],[-Math.PI/2,0,0]]],XY:[[new be(new on(.2,.2,.01),i),[.15,.15,0]]],YZ:[[new be(new on(.2,.2,.01),i),[0,.15,.15],[0,Math.PI/2,0]]],XZ:[[new be(new on(.2,.2,.01),i),[.15,0,.15],[-Math.PI/2,0,0]]],XYZ:[[new be(new on(.2,.2,.2),i),[0,0,0]]]},z={X:[[new di(p,s),[-1e3,0,0],null,[1e6,1,1],"helper"]],Y:[[new di(p,s),[0,-1e3,0],[0,0,Math.PI/2],[1e6,1,1],"helper"]],Z:[[new di(p,s),[0,0,-1e3],[0,-Math.PI/2,0],[1e6,1,1],"helper"]]};function Y(W){const j=new tn;for(const q in W)for(let K=W[q].length;K--;){const re=W[q][K][0].clone(),ae=W[q][K][1],me=W[q][K][2],xe=W[q][K][3],ge=W[q][K][4];re.name=q,re.tag=ge,ae&&re.position.set(ae[0],ae[1],ae[2]),me&&re.rotation.set(me[0],me[1],me[2]),xe&&re.scale.set(xe[0],xe[1],xe[2]),re.updateMatrix();const Qe=re.geometry.clone();Qe.applyMatrix4(re.matrix),re.geometry=Qe,re.renderOrder=1/0,re.position.set(0,0,0),re.rotation.set(0,0,0),re.scale.set(1,1,1),j.add(re)}return j}this.gizmo={},this.picker={},this.helper={},this.add(this.gizmo.translate=Y(L)),this.add(this.gizmo.rotate=Y(N)),this.add(this.gizmo.scale=Y(C)),this.add(this.picker.translate=Y(A)),this.add(this.picker.rotate=Y(E)),this.add(this.picker.scale=Y(B)),this.add(this.helper.translate=Y(U)),this.add(this.helper.rotate=Y(b)),this.add(this.helper.scale=Y(z)),this.picker.translate.visible=!1,this.picker.rotate.visible=!1,this.picker.scale.visible=!1}updateMatrixWorld(e){const i=(this.mode==="scale"?"local":this.space)==="local"?this.worldQuaternion:El;this.gizmo.translate.visible=this.mode==="translate",this.gizmo.rotate.visible=this.mode==="rotate",this.gizmo.scale.visible=this.mode==="scale",this.helper.translate.visible=this.mode==="translate",this.helper.rotate.visible=this.mode==="rotate",this.helper.scale.visible=this.mode==="scale";let s=[];s=s.concat(this.picker[this.mode].children),s=s.concat(this.gizmo[this.mode].children),s=s.concat(this.helper[this.mode].children);for(let r=0;r<s.length;r++){const o=s[r];o.visible=!0,o.rotation.set(0,0,0),o.position.copy(this.worldPosition);let a;if(this.camera.isOrthographicCamera?a=(this.camera.top-this.camera.bottom)/this.camera.zoom:a=this.worldPosition.distanceTo(this.cameraPosition)*Math.min(1.9*Math.tan(Math.PI*this.camera.fov/360)/this.camera.zoom,7),o.scale.set(1,1,1).multiplyScalar(a*this.size/4),o.tag==="helper"){o.visible=!1,o.name==="AXIS"?(o.visible=!!this.axis,this.axis==="X"&&(jt.setFromEuler(al.set(0,0,0)),o.quaternion.copy(i).multiply(jt),Math.abs(Ut.copy(Ko).applyQuaternion(i).dot(this.eye))>.9&&(o.visible=!1)),this.axis==="Y"&&(jt.setFromEuler(al.set(0,0,Math.PI/2)),o.quaternion.copy(i).multiply(jt),Math.abs(Ut.copy(tr).applyQuaternion(i).dot(this.eye))>.9&&(o.visible=!1)),this.axis==="Z"&&(jt.setFromEuler(al.set(0,Math.PI/2,0)),o.quaternion.copy(i).multiply(jt),Math.abs(Ut.copy(Jo).applyQuaternion(i).dot(this.eye))>.9&&(o.visible=!1)),this.axis==="XYZE"&&(jt.setFromEuler(al.set(0,Math.PI/2,0)),Ut.copy(this.rotationAxis),o.quaternion.setFromRotationMatrix(Vp.lookAt(Hp,Ut,tr)),o.quaternion.multiply(jt),o.visible=this.dragging),this.axis==="E"&&(o.visible=!1)):o.name==="START"?(o.position.copy(this.worldPositionStart),o.visible=this.dragging):o.name==="END"?(o.position.copy(this.worldPosition),o.visible=this.dragging):o.name==="DELTA"?(o.position.copy(this.worldPositionStart),o.quaternion.copy(this.worldQuaternionStart),Nn.set(1e-10,1e-10,1e-10).add(this.worldPositionStart).sub(this.worldPosition).multiplyScalar(-1),Nn.applyQuaternion(this.worldQuaternionStart.clone().invert()),o.scale.copy(Nn),o.visible=this.dragging):(o.quaternion.copy(i),this.dragging?o.position.copy(this.worldPositionStart):o.position.copy(this.worldPosition),this.axis&&(o.visible=this.axis.search(o.name)!==-1));continue}o.quaternion.copy(i),this.mode==="translate"||this.mode==="scale"?(o.name==="X"&&Math.abs(Ut.copy(Ko).applyQuaternion(i).dot(this.eye))>.99&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1),o.name==="Y"&&Math.abs(Ut.copy(tr).applyQuaternion(i).dot(this.eye))>.99&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1),o.name==="Z"&&Math.abs(Ut.copy(Jo).applyQuaternion(i).dot(this.eye))>.99&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1),o.name==="XY"&&Math.abs(Ut.copy(Jo).applyQuaternion(i).dot(this.eye))<.2&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1),o.name==="YZ"&&Math.abs(Ut.copy(Ko).applyQuaternion(i).dot(this.eye))<.2&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1),o.name==="XZ"&&Math.abs(Ut.copy(tr).applyQuaternion(i).dot(this.eye))<.2&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1)):this.mode==="rotate"&&(ll.copy(i),Ut.copy(this.eye).applyQuaternion(jt.copy(i).invert()),o.name.search("E")!==-1&&o.quaternion.setFromRotationMatrix(Vp.lookAt(this.eye,Hp,tr)),o.name==="X"&&(jt.setFromAxisAngle(Ko,Math.atan2(-Ut.y,Ut.z)),jt.multiplyQuaternions(ll,jt),o.quaternion.copy(jt)),o.name==="Y"&&(jt.setFromAxisAngle(tr,Math.atan2(Ut.x,Ut.z)),jt.multiplyQuaternions(ll,jt),o.quaternion.copy(jt)),o.name==="Z"&&(jt.setFromAxisAngle(Jo,Math.atan2(Ut.y,Ut.x)),jt.multiplyQuaternions(ll,jt),o.quaternion.copy(jt))),o.visible=o.visible&&(o.name.indexOf("X")===-1||this.showX),o.visible=o.visible&&(o.name.indexOf("Y")===-1||this.showY),o.visible=o.visible&&(o.name.indexOf("Z")===-1||this.showZ),o.visible=o.visible&&(o.name.indexOf("E")===-1||this.showX&&this.showY&&this.showZ),o.material._color=o.material._color||o.material.color.clone(),o.material._opacity=o.material._opacity||o.material.opacity,o.material.color.copy(o.material._color),o.material.opacity=o.material._opacity,this.enabled&&this.axis&&(o.name===this.axis?(o.material.color.copy(this.materialLib.active.color),o.material.opacity=1):this.axis.split("").some(function(l){return o.name===l})&&(o.material.color.copy(this.materialLib.active.color),o.material.opacity=1))}super.updateMatrixWorld(e)}}class Vw extends be{constructor(){super(new Is(1e5,1e5,2,2),new ic({visible:!1,wireframe:!0,side:Vi,transparent:!0,opacity:.1,toneMapped:!1})),this.isTransformControlsPlane=!0,this.type="TransformControlsPlane"}updateMatrixWorld(e){let t=this.space;switch(this.position.copy(this.worldPosition),this.mode==="scale"&&(t="local"),cl.copy(Ko).applyQuaternion(t==="local"?this.worldQuaternion:El),Ho.copy(tr).applyQuaternion(t==="local"?this.worldQuaternion:El),Vo.copy(Jo).applyQuaternion(t==="local"?this.worldQuaternion:El),Ut.copy(Ho),this.mode){case"translate":case"scale":switch(this.axis){case"X":Ut.copy(this.eye).cross(cl),Bi.copy(cl).cross(Ut);break;case"Y":Ut.copy(this.eye).cross(Ho),Bi.copy(Ho).cross(Ut);break;case"Z":Ut.copy(this.eye).cross(Vo),Bi.copy(Vo).cross(Ut);break;case"XY":Bi.copy(Vo);break;case"YZ":Bi.copy(cl);break;case"XZ":Ut.copy(Vo),Bi.copy(Ho);break;case"XYZ":case"E":Bi.set(0,0,0);break}break;default:Bi.set(0,0,0)}Bi.length()===0?this.quaternion.copy(this.cameraQuaternion):(Gp.lookAt(Nn.set(0,0,0),Bi,Ut),this.quaternion.setFromRotationMatrix(Gp)),super.updateMatrixWorld(e)}}const Gw=420;function Ww(n,e){const{canvas:t}=n;let i=null,s=0;const r=new ha(u=>ls.send(u),u=>{if(i)return;const _=u;vs.value=_?.link??null}),o=new ha(u=>ls.send(u),()=>{},u=>Xn(u.message)),a=u=>{e.style.setProperty("transform",`translate(${u.offsetX+16}px, ${u.offsetY+12}px)`),r.push({do:"pick",...n.ray(u)})};t.addEventListener("pointermove",u=>{if(i?.pointer===u.pointerId){e.style.setProperty("transform",`translate(${u.offsetX+16}px, ${u.offsetY+12}px)`),o.push({do:"drag",...n.ray(u)}),u.stopImmediatePropagation();return}u.buttons===0&&u.pointerType!=="touch"&&d.axis===null&&a(u)},{capture:!0}),t.addEventListener("pointerleave",()=>{i||(vs.value=null)});const l=async u=>{i={pointer:u.pointerId},pl.value=!0,n.controls.enabled=!1,t.setPointerCapture(u.pointerId);const _=await lt({do:"grab",...n.ray(u),arm:u.ctrlKey||u.metaKey});if(!_)return c(!1);Ru.value||Mm(),vs.value=_.link},c=u=>{i&&(i=null,pl.value=!1,n.controls.enabled=!0,o.settled().then(()=>lt({do:"release",cancel:u})).then(X_))};let h;t.addEventListener("pointerdown",u=>{if(s=u.timeStamp,d.axis!==null)return;if(u.pointerType==="touch"){const v=u;h=setTimeout(()=>{l(v)},Gw);return}const _=vs.value!==null&&pn.value?.links[vs.value]?.joint!==null;u.button===0&&_&&!u.shiftKey&&(u.stopImmediatePropagation(),l(u))},{capture:!0}),t.addEventListener("pointermove",u=>{h&&Math.hypot(u.movementX,u.movementY)>2&&clearTimeout(h)});const f=u=>{clearTimeout(h),i?.pointer===u.pointerId&&c(u.type==="pointercancel")};t.addEventListener("pointerup",f),t.addEventListener("pointercancel",f),addEventListener("keydown",u=>{u.key==="Escape"&&i&&c(!0)}),t.addEventListener("dblclick",()=>{const u=vs.value===null?null:n.arm.links[vs.value];!u||performance.now()-s>5e3||(n.controls.target.setFromMatrixPosition(u.matrixWorld),n.controls.update())}),An(()=>{const u=vs.value,_=u===null?null:pn.value?.links[u]?.joint??null;n.arm.highlight(u),t.style.setProperty("cursor",pl.value?"grabbing":_!==null&&u!==null?"grab":"default");const v=pn.value?.joints,m=_===null?void 0:v?.[_];if(e.hidden=m===void 0,m&&_!==null){const p=pa(m);e.textContent=`${m.label}  ${io(Yl.value[_]??0,p,Ot.value)} ${Il(p,Ot.value)}`}});const d=Xw(n)}function X_(){const n=us.value?.tool;n&&(vm.value=`Tool at ${n.position.map(e=>`${(1e3*e).toFixed(0)}`).join(", ")} millimetres`)}function Xw(n){const e=new tn;n.scene.add(e);const t=new Uw(n.camera,n.canvas);t.size=.75,t.attach(e),n.scene.add(t.getHelper());let i="",s=!1;const r=new ha(l=>ls.send(l),l=>{const c=l;c.reached||Xn(c.sentence)},l=>Xn(l.message)),o=()=>{s||n.tool.matrix.decompose(e.position,e.quaternion,new k)};t.addEventListener("dragging-changed",l=>{s=l.value,n.controls.enabled=!s,pl.value=s,s?i=da("gizmo"):r.settled().then(o).then(X_).then(()=>n.invalidate())}),t.addEventListener("objectChange",()=>{const l=e.quaternion;r.push({do:"tool",position:e.position.toArray(),quaternion:[l.w,l.x,l.y,l.z],gesture:i})}),t.addEventListener("change",()=>n.invalidate()),n.onDraw(()=>{t.camera=n.camera,o()}),addEventListener("keydown",l=>l.key==="Control"&&a(!0)),addEventListener("keyup",l=>l.key==="Control"&&a(!1));const a=l=>{t.setTranslationSnap(l?.01:null),t.setRotationSnap(l?Math.PI/36:null)};return An(()=>{const l=ut.gizmo.value;t.enabled=l!=="off",t.getHelper().visible=l!=="off",l!=="off"&&t.setMode(l),t.setSpace(ut.local.value?"local":"world"),n.invalidate()}),t}let gi=null;function Yw(){const n=no(null),e=no(null);return Gl(()=>{const t=new Iw(n.current);gi=t,window.pieperViewer=t,Ww(t,e.current),qw(t)},[]),R("div",{class:"view",children:[R("canvas",{ref:n,tabIndex:0,"aria-label":"3D view of the arm. Every action is in the panels too; press ? for keys."}),R("div",{ref:e,class:"touch-label",hidden:!0})]})}function qw(n){let e=0,t=null,i="";Vg(r=>{r.kind==="pose"?n.arm.move(r.matrices):(t=r,s()),n.invalidate()});const s=()=>{if(!t)return;const r=as.value?.solutions??[];n.ghosts.move(t,Array.from({length:t.count},(o,a)=>r[a]?.current??!1)),n.invalidate()};An(()=>{const r=pn.value;if(!r||r.revision===e)return;e=r.revision;const o=i===r.id;i=r.id,n.show(r,o).then(()=>document.documentElement.dataset.ready="1")}),An(()=>n.setDark(ra.value)),An(()=>{const r=us.value?.matrix;r&&(n.setTool(r),ut.trail.value&&n.path.add([r[0][3],r[1][3],r[2][3]]),n.invalidate())}),An(()=>{n.path.setWay(_o.value?.tool??[]),n.invalidate()}),An(()=>{n.arm.showFrames(ut.frames.value),n.arm.showCollision(ut.collision.value),n.path.showTrail(ut.trail.value),n.path.showOutline(ut.outline.value),n.ghosts.object.visible=ut.ghosts.value&&fr.value?.playing!==!0,n.invalidate()}),An(()=>{as.value,s()}),An(()=>{n.ghosts.point(Yo.value),n.invalidate()})}function gu(n,e){const t=document.createElement("a");t.href=URL.createObjectURL(e),t.download=n,t.click(),setTimeout(()=>URL.revokeObjectURL(t.href),1e4)}async function vu(n){if(!gi)return;const{renderer:e,canvas:t}=gi,i=e.getPixelRatio();e.setPixelRatio(n),e.render(gi.scene,gi.camera);const s=await new Promise(r=>t.toBlob(r,"image/png"));e.setPixelRatio(i),gi.invalidate(),s?gu(`${pn.value?.id??"arm"}.png`,s):Xn("The picture could not be made")}const $w=[["motion","Motion"],["plots","Plots"],["log","Log"]];function jw(){const n=Ll.value,e=fr.value;return R("footer",{class:`drawer ${n?"open":""}`,children:[R("div",{class:"drawer-bar",children:[R(Zw,{}),R("span",{class:"grow"}),R("div",{class:"tabs",role:"tablist","aria-label":"Drawer",children:$w.map(([t,i])=>R("button",{type:"button",role:"tab",id:`drawer-tab-${t}`,"aria-selected":n===t,"aria-controls":"drawer-body",onClick:()=>Ll.value=n===t?null:t,children:[i,t==="log"&&Wo.value.some(s=>s.level!=="info")&&R("span",{class:"badge",children:Wo.value.length})]},t))})]}),R("div",{class:"drawer-body",id:"drawer-body",role:"tabpanel",hidden:!n,...n?{"aria-labelledby":`drawer-tab-${n}`}:{},children:[n==="motion"&&e&&R(Kw,{}),n==="plots"&&R(qv,{}),n==="log"&&(Wo.value.length===0?R("p",{class:"quiet",children:"Nothing has happened that needs telling."}):R("ol",{class:"log",children:Wo.value.map((t,i)=>R("li",{class:t.level,children:t.text},i))}))]})]})}function Zw(){const n=fr.value;if(!n)return null;const e=n.keyframes.length>1;return R("div",{class:"transport",role:"group","aria-label":"Playback",children:[R(Zt,{icon:"plus",label:"Add this posture as a keyframe",keys:"K",text:e?void 0:"Keyframe",onClick:Y_}),R(Zt,{icon:"back",label:"A step back",disabled:!e,onClick:()=>{lt({do:"step",by:-1})}}),R(Zt,{icon:n.playing?"pause":"play",class:"primary",label:n.playing?"Pause":"Play",keys:"Space",disabled:!e,onClick:q_}),R(Zt,{icon:"forward",label:"A step on",disabled:!e,onClick:()=>{lt({do:"step",by:1})}}),R(Zt,{icon:"loop",label:"Again and again",pressed:n.loop,disabled:!e,onClick:()=>{lt({do:"loop",on:!n.loop})}}),e&&R(xi,{children:[R("input",{class:"scrub",type:"range",min:0,max:n.duration,step:n.duration/1e3,value:Hi.value,"aria-label":"Time","aria-valuetext":`${Hi.value.toFixed(2)} of ${n.duration.toFixed(2)} seconds`,onInput:t=>{Hi.value=Number(t.currentTarget.value),lt({do:"seek",t:Hi.value})}}),R("span",{class:"time",children:[Hi.value.toFixed(2)," / ",n.duration.toFixed(2)," s"]})]}),!e&&R("span",{class:"quiet small wide",children:"Two keyframes or a table make a motion."})]})}function Y_(){lt({do:"keyframe",op:"add"}).then(n=>{n&&Xn("Keyframe added","note")})}function q_(){lt({do:fr.value?.playing?"pause":"play"})}function Kw(){const n=fr.value,e=async i=>{const s=await lt({do:"motion_table",name:i.name,text:await i.text()});s&&Xn(`${i.name}: ${s.rows} rows`,"note")},t=n.keyframes.length>60;return R("div",{class:"motion",children:[R("div",{class:"row",children:[R("label",{class:"text-button",children:[R("span",{children:"Open a table…"}),R("input",{type:"file",class:"visually-hidden",accept:".csv",onChange:i=>{const s=i.currentTarget.files?.[0];s&&e(s),i.currentTarget.value=""}})]}),R("label",{class:"field",children:["Law ",R("select",{value:n.law,onChange:i=>{lt({do:"law",to:i.currentTarget.value})},children:n.laws.map(i=>R("option",{children:i},i))})]}),R("label",{class:"field",children:["Speed ",R("input",{type:"range",min:.1,max:4,step:.1,value:n.speed,"aria-valuetext":`${n.speed} times`,onInput:i=>{lt({do:"speed",to:Number(i.currentTarget.value)})}})," ",R("span",{class:"time",children:[n.speed.toFixed(1),"×"]})]}),R("span",{class:"grow"}),R("button",{type:"button",class:"text-button",onClick:()=>Wp("csv"),children:"CSV"}),R("button",{type:"button",class:"text-button",onClick:()=>Wp("json"),children:"JSON"}),R("button",{type:"button",class:"text-button",disabled:n.keyframes.length===0,onClick:()=>{lt({do:"keyframe",op:"clear"})},children:"Clear"})]}),n.problem&&R("p",{class:"banner",children:n.problem}),n.name&&R("p",{class:"quiet small",children:[n.name,": ",n.keyframes.length," rows"]}),n.keyframes.length===0&&R("p",{class:"quiet",children:["Bring the arm to a posture and press ",R("kbd",{children:"K"}),"; move it and press ",R("kbd",{children:"K"})," again; ",R("kbd",{children:"Space"})," plays."]}),!t&&n.keyframes.length>0&&R("ol",{class:"keyframes",children:n.keyframes.map(i=>R("li",{class:Math.abs(Hi.value-i.t)<1e-6?"here":"",children:[R("button",{type:"button",class:"keyframe-name",onClick:()=>{lt({do:"keyframe",op:"goto",id:i.id})},children:i.label||i.id}),R("label",{class:"field",children:[R(nr,{value:i.t,kind:"plain",label:`Time of keyframe ${i.label}`,onCommit:s=>{lt({do:"keyframe",op:"move",id:i.id,t:s.replace(/s$/,"")})}})," s"]}),R("button",{type:"button",class:"text-button",title:"Takes the present posture",onClick:()=>{lt({do:"keyframe",op:"set",id:i.id})},children:"Set"}),R(Zt,{icon:"close",label:`Remove keyframe ${i.label}`,onClick:()=>{lt({do:"keyframe",op:"remove",id:i.id})}})]},i.id))})]})}function Wp(n){const e=_o.value;if(!e||e.t.length===0)return Xn("There is no motion to export");const t=pn.value?.joints.length??0,i=`${pn.value?.id??"arm"}-motion`;if(n==="json")return gu(`${i}.json`,new Blob([JSON.stringify(e)],{type:"application/json"}));const s=["t",...Array.from({length:t},(o,a)=>`q${a+1}`)].join(","),r=e.t.map((o,a)=>[o,...e.q.map(l=>l[a])].join(","));gu(`${i}.csv`,new Blob([[s,...r].join(`
`),`
`],{type:"text/csv"}))}const lh=Math.PI/180,Jw=.04,Qw=new ha(n=>ls.send(n),()=>{},n=>Xn(n.message));function eT({joint:n,index:e}){const t=no(""),i=pa(n),s=Yl.value[e]??0,{lower:r,upper:o}=n,a=o-r,l=i==="angle"?.1*lh:5e-4,c=!n.unlimited&&Math.min(s-r,o-s)<Jw*a,h=us.value?.over_limit[e]??!1,f=v=>Qw.push({do:"joint",joint:e,value:v,gesture:t.current}),d=v=>{const m={ArrowUp:1,ArrowRight:1,ArrowDown:-1,ArrowLeft:-1}[v.key];if(m===void 0)return;v.preventDefault(),v.stopPropagation(),v.repeat||(t.current=da(`key-${e}`));const p=v.shiftKey?10:v.altKey?.1:1;f(Math.min(o,Math.max(r,s+m*p*(i==="angle"?lh:.001))))},u=i==="angle"?[-90,-45,0,45,90].map(v=>v*lh).filter(v=>v>r&&v<o):r<0&&o>0?[0]:[],_=n.unlimited?"no limits":`limits ${io(r,i,Ot.value)} to ${io(o,i,Ot.value)}`;return R("li",{class:`joint ${h?"over":c?"near":""}`,children:[R("button",{type:"button",class:"joint-name",title:`${n.name}: ${_}. Double-click for zero.`,onDblClick:()=>{lt({do:"joint",joint:e,value:0})},"aria-label":`${n.label}, ${n.name}, ${_}`,children:n.label}),R("span",{class:"track",children:[R("input",{type:"range",min:r,max:o,step:l,value:s,"aria-label":`${n.label} slider`,"aria-valuetext":`${n.label}, ${jg(s,i)}, ${h?"over its limit":c?"near its limit":_}`,onPointerDown:()=>t.current=da(`slider-${e}`),onKeyDown:d,onInput:v=>f(Number(v.currentTarget.value))}),R("svg",{class:"ticks",viewBox:"0 0 100 4",preserveAspectRatio:"none","aria-hidden":"true",children:u.map(v=>{const m=100*(v-r)/a;return R("line",{x1:m,x2:m,y1:"0",y2:"4"},v)})})]}),R(nr,{value:s,kind:i,label:`${n.label} value`,onCommit:v=>{lt({do:"joint",joint:e,value:v})}}),R("span",{class:"joint-state",title:h?"over its limit":c?"near its limit":"",children:(h||c)&&R(vi,{name:"warn"})})]})}function tT(){const n=pn.value?.joints??[],e=us.value?.unlocked??!1,t=()=>{const i=Array.from(Yl.value,(s,r)=>io(s,pa(n[r]),Ot.value)).join(", ");navigator.clipboard?.writeText(i).then(()=>Xn("Joint values copied","note"),()=>Xn("The clipboard is closed to this page"))};return R("section",{"aria-label":"Joints",children:[R("ul",{class:"joints",children:n.map((i,s)=>R(eT,{joint:i,index:s},`${pn.value?.revision}-${s}`))}),e&&R("p",{class:"banner",children:[R(vi,{name:"warn"})," Limits are unlocked: joints may go where the arm cannot."]}),R("div",{class:"buttons",children:[R(Zt,{icon:"home",label:"Home",keys:"H",text:"Home",onClick:()=>{lt({do:"named",to:"home"})}}),R(Zt,{icon:"fit",label:"Zero",keys:"0",text:"Zero",onClick:()=>{lt({do:"named",to:"zero"})}}),R(Zt,{icon:"dice",label:"Random posture within the limits",text:"Random",onClick:()=>{lt({do:"named",to:"random"})}}),R(Zt,{icon:"copy",label:"Copy the joint values",text:"Copy",onClick:t}),R(Zt,{icon:e?"unlock":"lock",label:e?"Lock the limits":"Unlock the limits",pressed:e,onClick:()=>{lt({do:"unlock",on:!e})},text:"Limits"})]}),R("button",{type:"button",class:"link",onClick:()=>{lt({do:"set_home"}).then(()=>Xn("This posture is home now","note"))},children:"Make this posture home"})]})}const nT=new ha(n=>ls.send(n),()=>{},n=>Xn(n.message));function iT(n){const t=[n.shoulder,n.elbow&&`elbow ${n.elbow}`,n.wrist].filter(i=>typeof i=="string");return t.length>0?t:[n.branch]}function sT({family:n,index:e}){const t=no("");return R("div",{class:"family",children:[R("p",{children:[R("strong",{children:"Infinitely many."})," ",n.name,"."]}),R("input",{type:"range",min:0,max:1,step:1/96,value:n.at,"aria-label":`Family ${e+1}: ${n.name}`,onPointerDown:()=>t.current=da("family"),onKeyDown:i=>{i.repeat||(t.current=da("family")),i.stopPropagation()},onInput:i=>nT.push({do:"family",index:e,at:Number(i.currentTarget.value),gesture:t.current})})]})}function rT(){const n=as.value,e=us.value?.unlocked??!1;if(!n)return null;if(n.status==="playing")return R("p",{class:"quiet",children:"The list is made when the motion stands."});const t=n.solutions.length,i={solved:`${t} solution${t===1?"":"s"} for this pose`,singular:`A singular pose: ${n.families.length===1?"a family":`${n.families.length} families`}${t>0?` and ${t} more`:""}`,redundant:"More joints than the pose needs",unreachable:"No solution",none:"No solver takes this arm",playing:""}[n.status];return R("section",{"aria-label":"IK solutions",children:[R("div",{class:"row spread",children:[R("strong",{children:i}),R("label",{class:"check",children:[R("input",{type:"checkbox",checked:ut.ghosts.value,onChange:s=>{ut.ghosts.value=s.currentTarget.checked,lt({do:"ghosts",on:ut.ghosts.value})}})," Ghosts"]})]}),n.missed&&R("p",{class:"banner",children:[R(vi,{name:"warn"})," The pose asked for cannot be reached: ",n.reason??"every solution lies outside the limits",". The arm stands at the nearest."]}),n.families.map((s,r)=>R(sT,{family:s,index:r},r)),R("ol",{class:"solutions",children:n.solutions.map((s,r)=>{const o=!s.within_limits&&!e;return R("li",{children:R("button",{type:"button",class:`solution ${s.current?"current":""}`,"aria-current":s.current,disabled:o,onMouseEnter:()=>Yo.value=r,onMouseLeave:()=>Yo.value=null,onFocus:()=>Yo.value=r,onBlur:()=>Yo.value=null,onClick:()=>{lt({do:"solution",index:r})},children:[R("span",{class:"number-of",children:r+1}),R("span",{class:"flags",children:[iT(s).map(a=>R("span",{class:"flag",children:a},a)),s.multiplicity>1&&R("span",{class:"flag",children:["×",s.multiplicity]})]}),R("span",{class:"details",children:[s.current?R("span",{class:"here",children:[R(vi,{name:"check"})," here"]}):R("span",{children:[(s.distance*180/Math.PI).toFixed(0),"° away"]}),o&&R("span",{class:"outside",children:[R(vi,{name:"lock"})," outside limits"]}),R("span",{class:"residual",title:"What forward kinematics misses the pose by",children:wm(s.residual)})]})]})},r)})}),n.microseconds!==void 0&&R("p",{class:"quiet small",children:["Solved by ",R("em",{children:n.solver})," in ",n.microseconds.toFixed(1)," µs. ",R("kbd",{children:"["})," ",R("kbd",{children:"]"})," step through."]})]})}function Xp(n){const e=as.value?.solutions??[],t=us.value?.unlocked??!1,i=Math.max(0,e.findIndex(s=>s.current));for(let s=1;s<=e.length;s++){const r=(i+n*s+e.length*s)%e.length;if(e[r].within_limits||t)return void lt({do:"solution",index:r})}}async function oT(n){const e=Dl.value.find(s=>s.id===n.value),t={};for(const s of e?.needs??[]){const r=prompt(`${e.name}: the length ${s}, as in 0.3 or 250 mm`,"0.3");if(r===null){n.value=pn.value?.id??"";return}t[s]=r}await lt({do:"load",robot:n.value,values:t})===void 0&&(n.value=pn.value?.id??"")}async function aT(n){const e=await n.text();n.name.endsWith(".json")?await lt({do:"open",text:e}):await lt({do:"load",file:{name:n.name,text:e}})}function lT(){const{undo:n,redo:e}=mm.value,t=Dl.value.some(r=>r.id===pn.value?.id),i={system:"light",light:"dark",dark:"system"},s=gm.value;return R("header",{class:"top",children:[R("span",{class:"brand",children:[R("svg",{viewBox:"0 0 32 32","aria-hidden":"true",children:[R("path",{d:"M9 25h14M12 25l-1-9 9-6 4 4"}),R("circle",{cx:"11",cy:"16",r:"2.6"}),R("circle",{cx:"20",cy:"10",r:"2.6"})]}),R("span",{children:"pieper"})]}),R("label",{class:"picker",children:[R("span",{class:"visually-hidden",children:"Robot"}),R("select",{value:pn.value?.id??"",onChange:r=>{oT(r.currentTarget)},children:[!t&&pn.value&&R("option",{value:pn.value.id,children:pn.value.name}),Dl.value.map(r=>R("option",{value:r.id,children:r.name},r.id))]}),R(vi,{name:"down"})]}),R("label",{class:"icon-button",title:"Open a robot (.toml, .urdf) or a project (.json)",children:[R(vi,{name:"upload"}),R("span",{class:"visually-hidden",children:"Open a robot or project file"}),R("input",{type:"file",class:"visually-hidden",accept:".toml,.urdf,.xml,.json",onChange:r=>{const o=r.currentTarget.files?.[0];o&&aT(o),r.currentTarget.value=""}})]}),R("span",{class:"group",children:[R(Zt,{icon:"undo",label:n?`Undo: ${n}`:"Nothing to undo",keys:"Ctrl+Z",disabled:!n,onClick:()=>{lt({do:"undo"})}}),R(Zt,{icon:"redo",label:e?`Redo: ${e}`:"Nothing to redo",keys:"Ctrl+Shift+Z",disabled:!e,onClick:()=>{lt({do:"redo"})}})]}),R("span",{class:"grow"}),R("span",{class:"group wide",children:[R(Zt,{icon:"move",label:"Move the tool by a gizmo",keys:"W",pressed:ut.gizmo.value==="translate",onClick:()=>ut.gizmo.value=ut.gizmo.value==="translate"?"off":"translate"}),R(Zt,{icon:"rotate",label:"Turn the tool by a gizmo",keys:"E",pressed:ut.gizmo.value==="rotate",onClick:()=>ut.gizmo.value=ut.gizmo.value==="rotate"?"off":"rotate"})]}),R("span",{class:"group wide",children:[R(Zt,{icon:"ghost",label:"Ghosts of all solutions",keys:"G",pressed:ut.ghosts.value,onClick:$_}),R(Zt,{icon:"axes",label:"Link frames",keys:"T",pressed:ut.frames.value,onClick:()=>ut.frames.value=!ut.frames.value}),R(Zt,{icon:"trail",label:"The tool's way",pressed:ut.trail.value,onClick:()=>ut.trail.value=!ut.trail.value}),R(Zt,{icon:"reach",label:"Outline of the reach",keys:"O",pressed:ut.outline.value,onClick:()=>ut.outline.value=!ut.outline.value})]}),R("span",{class:"group",children:[R("button",{type:"button",class:"text-button",title:"Units (U)","aria-label":`Units: ${Ot.value.angle} and ${Ot.value.length}`,onClick:j_,children:[Ot.value.angle==="deg"?"°":"rad"," · ",Ot.value.length]}),R(Zt,{icon:"camera",label:"Snapshot as PNG",keys:"P",onClick:()=>{vu(2)}}),R(Zt,{icon:As.value==="system"?"auto":As.value==="light"?"sun":"moon",label:`Theme: ${As.value}`,onClick:()=>{As.value=i[As.value],fa("theme",As.value)}}),R(Zt,{icon:"help",label:"Keys and gestures",keys:"?",onClick:()=>Ns.value="help"}),R(Zt,{icon:"panel",label:"Side panel",pressed:sa.value,onClick:()=>sa.value=!sa.value})]}),R("span",{class:`connection ${Zr.value}`,role:"status",title:"Time for a message to the program and back",children:[R("span",{class:"dot","aria-hidden":"true"}),Zr.value==="open"?s===null?"connected":`${s.toFixed(1)} ms`:Zr.value]})]})}function $_(){ut.ghosts.value=!ut.ghosts.value,lt({do:"ghosts",on:ut.ghosts.value})}function j_(){const{angle:n,length:e}=Ot.value;Ot.value=n==="deg"&&e==="mm"?{angle:"rad",length:"m"}:{angle:"deg",length:"mm"},fa("angle",Ot.value.angle),fa("length",Ot.value.length),Xn(`Shown in ${Ot.value.angle==="deg"?"degrees":"radians"} and ${Ot.value.length==="mm"?"millimetres":"metres"}`,"note")}const hl=n=>()=>{n.value=!n.value},Yp=n=>()=>{ut.gizmo.value=ut.gizmo.value===n?"off":n},Vl=[{name:"Fit the arm",keys:"F",run:()=>gi?.fit("here")},{name:"Recentre the view",keys:"V",run:()=>gi?.fit("home")},{name:"Front view",keys:"1",run:()=>gi?.fit("front")},{name:"Right view",keys:"3",run:()=>gi?.fit("right")},{name:"Top view",keys:"7",run:()=>gi?.fit("top")},{name:"Parallel or central projection",keys:"5",run:()=>gi?.toggleProjection()},{name:"Home posture",keys:"H",run:()=>{lt({do:"named",to:"home"})}},{name:"Zero posture",keys:"0",run:()=>{lt({do:"named",to:"zero"})}},{name:"Random posture",keys:"",run:()=>{lt({do:"named",to:"random"})}},{name:"Play or pause",keys:"Space",run:q_},{name:"Add a keyframe",keys:"K",run:Y_},{name:"Ghosts of all solutions",keys:"G",run:$_},{name:"Next solution",keys:"]",run:()=>Xp(1)},{name:"Previous solution",keys:"[",run:()=>Xp(-1)},{name:"Link frames",keys:"T",run:hl(ut.frames)},{name:"Collision shapes",keys:"C",run:hl(ut.collision)},{name:"Outline of the reach",keys:"O",run:hl(ut.outline)},{name:"Move the tool by a gizmo",keys:"W",run:Yp("translate")},{name:"Turn the tool by a gizmo",keys:"E",run:Yp("rotate")},{name:"Gizmo in the tool’s or the base’s axes",keys:"X",run:hl(ut.local)},{name:"Snapshot",keys:"P",run:()=>{vu(2)}},{name:"Snapshot at four times the size",keys:"",run:()=>{vu(4)}},{name:"Units",keys:"U",run:j_},{name:"Plots",keys:"",run:()=>Ll.value=Ll.value==="plots"?null:"plots"},{name:"Undo",keys:"Ctrl+Z",run:()=>{lt({do:"undo"})}},{name:"Redo",keys:"Ctrl+Shift+Z",run:()=>{lt({do:"redo"})}},{name:"Save the project",keys:"Ctrl+S",run:()=>location.assign("/api/project.json?download")},{name:"All commands",keys:"Ctrl+K",run:()=>Ns.value="palette"},{name:"Keys and gestures",keys:"?",run:()=>Ns.value="help"}];function cT(){addEventListener("keydown",n=>{const e=n.target instanceof HTMLElement&&n.target.closest("input:not([type=range]):not([type=checkbox]), textarea, select, .cm-editor, dialog");if(n.ctrlKey||n.metaKey){const s=`Ctrl+${n.shiftKey?"Shift+":""}${n.key.toUpperCase()}`,r=Vl.find(o=>o.keys===s);return!r||e&&s!=="Ctrl+K"?void 0:(n.preventDefault(),r.run())}if(e||n.altKey||!dl.value||Ns.value)return;const t=n.key===" "?"Space":n.key.length===1?n.key.toUpperCase():"";if(t==="Space"&&n.target instanceof HTMLElement&&n.target.closest("button, input"))return;const i=Vl.find(s=>s.keys===t);!i||t===""||(n.preventDefault(),i.run())})}function Z_({title:n,children:e}){const t=no(null);return Gl(()=>t.current?.showModal(),[]),R("dialog",{ref:t,"aria-label":n,onClose:()=>Ns.value=null,onClick:i=>{i.target===t.current&&t.current?.close()},children:R("div",{class:"dialog-body",children:[R("div",{class:"row spread",children:[R("h2",{children:n}),R(Zt,{icon:"close",label:"Close",onClick:()=>t.current?.close()})]}),e]})})}const hT=[["Drag a link","turn its joint"],["Ctrl + drag a link","the whole arm follows"],["Drag empty space","turn the view"],["Right or Shift + drag","shift the view"],["Wheel, pinch","zoom to the pointer"],["Double-click a link","turn about it"],["Esc while dragging","back to where it began"],["Touch: hold, then drag","take hold of a link"]];function uT(){return R(Z_,{title:"Keys and gestures",children:[R("div",{class:"sheet",children:[R("dl",{children:hT.map(([n,e])=>R(xi,{children:[R("dt",{children:n},n),R("dd",{children:e})]}))}),R("dl",{children:Vl.filter(n=>n.keys).map(n=>R(xi,{children:[R("dt",{children:R("kbd",{children:n.keys})},n.name),R("dd",{children:n.name})]}))})]}),R("label",{class:"check",children:[R("input",{type:"checkbox",checked:dl.value,onChange:n=>{dl.value=n.currentTarget.checked,fa("letters",dl.value?"on":"off")}})," Single letters act as keys"]})]})}function fT(){const[n,e]=dh(""),[t,i]=dh(0),s=Vl.filter(o=>o.name.toLowerCase().includes(n.toLowerCase())),r=o=>{Ns.value=null,s[o]?.run()};return R(Z_,{title:"Commands",children:[R("input",{class:"search",type:"text",role:"combobox","aria-expanded":"true","aria-controls":"palette-list","aria-label":"Search commands",placeholder:"Search commands",value:n,ref:o=>o?.focus(),onInput:o=>{e(o.currentTarget.value),i(0)},onKeyDown:o=>{(o.key==="ArrowDown"||o.key==="ArrowUp")&&(o.preventDefault(),i((t+(o.key==="ArrowDown"?1:s.length-1))%Math.max(1,s.length))),o.key==="Enter"&&r(t)}}),R("ul",{class:"palette",id:"palette-list",role:"listbox","aria-label":"Commands",children:s.map((o,a)=>R("li",{role:"option","aria-selected":a===t,onClick:()=>r(a),children:[R("span",{children:o.name}),o.keys&&R("kbd",{children:o.keys})]},o.name))})]})}function dT(){return R(xi,{children:[Ns.value==="help"&&R(uT,{}),Ns.value==="palette"&&R(fT,{}),Zr.value==="lost"&&R("div",{class:"notice",role:"alert",children:[R(vi,{name:"warn"})," The connection to the program is lost. Trying again…"]}),Zr.value==="refused"&&R("div",{class:"notice",role:"alert",children:[R(vi,{name:"warn"})," ",_m.value]}),R("div",{class:"toasts",children:Xo.value.map(n=>R("div",{class:`toast ${n.kind}`,role:n.kind==="error"?"alert":"status",children:n.text},n.id))}),!Ru.value&&R("div",{class:"hint",role:"note",children:[R("p",{children:[R("strong",{children:"Drag a link"})," to turn its joint."]}),R("p",{children:[R("strong",{children:"Ctrl + drag"})," pulls the whole arm."]}),R("p",{children:[R("strong",{children:"?"})," shows every key and gesture."]}),R("button",{type:"button",class:"link",onClick:Mm,children:"Got it"})]}),R("div",{class:"visually-hidden","aria-live":"polite",children:vm.value})]})}const pT={theta:"θ",alpha:"α",d:"d",a:"a"};function mT(){const n=pn.value;return n?R("section",{"aria-label":"Robot",children:[R("h2",{children:n.name}),n.summary&&R("p",{class:"quiet",children:n.summary}),n.problems.map(e=>R("p",{class:"banner",children:[R(vi,{name:"warn"})," ",e]},e)),n.table&&R("div",{class:"scroll",children:R("table",{class:"dh",children:[R("caption",{children:[n.table.convention==="standard"?"Standard":"Modified"," Denavit-Hartenberg"]}),R("thead",{children:R("tr",{children:[R("th",{scope:"col",children:"#"}),n.table.columns.map(e=>R("th",{scope:"col",children:pT[e]??e},e))]})}),R("tbody",{children:n.table.rows.map((e,t)=>R("tr",{children:[R("th",{scope:"row",children:t+1}),e.map((i,s)=>R("td",{children:i},s))]},t))})]})}),n.parameters.length>0&&R("dl",{class:"facts",children:n.parameters.map(([e,t])=>R(xi,{children:[R("dt",{children:e},e),R("dd",{children:t??"?"})]}))}),R("dl",{class:"facts",children:n.facts.map(([e,t])=>R(xi,{children:[R("dt",{children:e},e),R("dd",{children:t})]}))}),n.source&&R("p",{class:"quiet small",children:n.source})]}):null}const Go=[["joints","Joints"],["tool","Tool"],["ik","Solutions"],["robot","Robot"]];function _T(){const n=vc.value,e=(as.value?.solutions.length??0)+(as.value?.families.length??0);return R("aside",{class:"panel","aria-label":"Control panel",children:[R("div",{class:"tabs",role:"tablist","aria-label":"Control panel",onKeyDown:i=>{const s={ArrowRight:1,ArrowLeft:3}[i.key];if(s===void 0)return;const r=(Go.findIndex(([o])=>o===n)+s)%Go.length;vc.value=Go[r][0],document.getElementById(`tab-${Go[r][0]}`)?.focus()},children:Go.map(([i,s])=>R("button",{type:"button",id:`tab-${i}`,role:"tab","aria-selected":n===i,"aria-controls":"panel-body",tabIndex:n===i?0:-1,onClick:()=>vc.value=i,children:[s,i==="ik"&&e>0&&R("span",{class:"badge",children:e})]},i))}),R("div",{class:"panel-body",id:"panel-body",role:"tabpanel","aria-labelledby":`tab-${n}`,tabIndex:0,children:[n==="joints"&&R(tT,{}),n==="tool"&&R(Xv,{}),n==="ik"&&R(rT,{}),n==="robot"&&R(mT,{})]}),R(gT,{})]})}function gT(){const n=us.value?.tool;return n?R("dl",{class:"readout","aria-label":"Tool position",children:[["X","Y","Z"].map((e,t)=>R("div",{children:[R("dt",{class:`axis axis-${e.toLowerCase()}`,children:e}),R("dd",{children:io(n.position[t],"length",Ot.value)})]},e)),R("div",{children:R("dt",{children:Ot.value.length})})]}):null}function vT(){return Gl(()=>An(()=>{document.documentElement.dataset.theme=ra.value?"dark":"light"}),[]),R("div",{class:`app ${sa.value?"":"no-panel"}`,children:[R(lT,{}),R("main",{class:"stage","aria-label":"3D view",children:R(Yw,{})}),sa.value&&R(_T,{}),R(jw,{}),R(dT,{})]})}Eg(R(vT,{}),document.getElementById("app"));cT();window.pieperConnection=ls;ls.open();
