var Tt,lm,cm,Cs,xu,Il,um,yl,hm,Rh,yu,Aa=Symbol.for("pv"),Ul={},Nl=[],Ag=/^m(i|n|o|s|text|space)$/,Ch=Array.isArray,Ph=Nl.slice,pr=Object.assign;function hr(n){n&&n.parentNode&&n.remove()}function Rg(n,e,t){var i,s,r,o={},a=arguments.length;for(r in e)r=="key"?i=e[r]:r=="ref"&&typeof n!="function"?s=e[r]:o[r]=e[r];return a>2&&(o.children=a>3?Ph.call(arguments,2):t),oa(n,o,i,s,null)}function oa(n,e,t,i,s){var r={type:n,props:e,key:t,ref:i,__k:null,__:null,__b:0,__e:null,__c:null,constructor:Aa,__v:s||++lm,__i:-1,__u:0};return!s&&Tt.vnode&&Tt.vnode(r),r}function ci(n){return n.children}function aa(n,e){this.props=n,this.context=e,this.__g=0}function ks(n,e){if(e==null)return n.__&&ks(n.__,n.__i+1);for(var t;e<n.__k.length;e++)if((t=n.__k[e])&&t.__e)return t.__e;return typeof n.type!="function"||n.props.__P?null:ks(n)}function Cg(n){var e,t=n.__v,i=t.__e,s=[],r=[],o=n.__P;o&&((e=pr({constructor:Aa},t)).__v=t.__v+1,Tt.vnode&&Tt.vnode(e),Dh(o,e,t,n.__n,o.namespaceURI,32&t.__u?[i]:null,s,i||ks(t),32&t.__u,r),e.__v=t.__v,e.__.__k[e.__i]=e,gm(s,e,r),t.__=t.__e=null,e.__e!=i&&fm(e))}function fm(n){if((n=n.__)&&n.__c&&!n.props.__P)return n.__e=null,n.__k.some(function(e){return e&&(n.__e=e.__e)}),fm(n)}function zf(n){(8&n.__g||(n.__g|=8,Cs.push(n),Il++))&&xu==Tt.debounceRendering||((xu=Tt.debounceRendering)||queueMicrotask)(dm)}function dm(){try{for(var n,e=1;Cs.length;)Cs.length>e&&Cs.sort(um),n=Cs.shift(),e=Cs.length,8&n.__g&&Cg(n)}finally{(Il=Cs.length)&&(xu||queueMicrotask)(dm)}}function pm(n,e,t,i,s,r,o,a,l,c,u){var f,d,h,_,x,m,p=i.__k||Nl,M=e.length;for(l=Pg(t,e,p,l,M),f=0;f<M;f++)(h=t.__k[f])!=null&&(d=~h.__i&&p[h.__i]||Ul,h.__i=f,m=Dh(n,h,d,s,r,o,a,l,c,u),_=h.__e,(d.ref!=h.ref||8&d.__u)&&(d.ref&&Lh(d.ref,null,h,d),h.ref&&u.push(h.ref,h.__c||_,h)),x=x||_,4&h.__u?(l=mm(h,l,n,!d.__v),d.__e&&(d.__e=null)):typeof h.type=="function"&&m!==void 0?l=m:_&&(l=_.nextSibling),h.__u&=-21);return t.__e=x,l}function Pg(n,e,t,i,s){var r,o,a,l,c,u,f,d,h,_=t.length,x=_,m=0,p=0,M=n.__k=Array(s);for(r=0;r<s;r++)(o=e[r])!=null&&typeof o!="boolean"&&typeof o!="function"?(typeof o!="object"||o.constructor===String?o=M[r]=oa(null,o):Ch(o)?o=M[r]=oa(ci,{children:o}):o.constructor===Aa&&o.__b?o=M[r]=oa(o.type,o.props,o.key,o.ref,o.__v):M[r]=o,l=r+m,o.__=n,o.__b=n.__b+1,a=null,~(c=o.__i=Dg(o,t,l,x))&&(x--,(a=t[c])&&(a.__u|=2)),a&&a.__v?(o.__u|=16,c==l-1?m--:c==l+1?m++:c!=l&&(c>l?m--:m++,p=1)):(~c||(s>_?m--:s<_&&m++),typeof o.type!="function"&&(o.__u|=4))):M[r]=null;if(p){for(u=[],f=[],r=0;r<s;r++)if((o=M[r])&&16&o.__u){for(m=0,d=u.length;m<d;)u[h=m+d>>1]<o.__i?m=h+1:d=h;u[m]=o.__i,f[r]=m+1}for(m=u.length;r--;)f[r]&&(f[r]==m?m--:M[r].__u|=4)}if(x)for(r=0;r<_;r++)!(a=t[r])||2&a.__u||(a.__e==i&&(i=ks(a)),Ih(a,a));return i}function mm(n,e,t,i){var s,r,o,a;if(typeof n.type=="function"){if(n.props.__P)return e;if(s=n.__k)for(r=0;r<s.length;r++)s[r]&&(s[r].__=n,e=mm(s[r],e,t,!1));return e}for(e&&!e.parentNode&&(e=ks(n))&&!e.parentNode&&(e=null),o=n.__e,a=e;a&&a.nodeType==8;)a=a.nextSibling;for(o!=a&&(!i&&t.moveBefore&&o.parentNode?t.moveBefore(o,e):t.insertBefore(o,e||null)),e=o;(e=e&&e.nextSibling)&&e.nodeType==8&&!e.data.startsWith("$s"););return e}function Dg(n,e,t,i){var s,r=n.key,o=n.type,a=e[t],l=a&&!(2&a.__u);if(a===null&&r==null||l&&r==a.key&&o==a.type)return t;if(i>(l?1:0)){for(s=t-1;s>=0;s--)if((a=e[s])&&!(2&a.__u)&&r==a.key&&o==a.type)return s;for(s=t+1;s<e.length;s++)if((a=e[s])&&!(2&a.__u)&&r==a.key&&o==a.type)return s}return-1}function Hf(n,e,t){t==null&&(t=""),e[0]=="-"?n.setProperty(e,t):n[e]=t}function ka(n,e,t,i,s){var r,o;if(e=="style")if(typeof t=="string")n.style.cssText=t;else{if(typeof i=="string"&&(n.style.cssText=i=""),i)for(e in i)t&&e in t||Hf(n.style,e);if(t)for(e in t)i&&t[e]==i[e]||Hf(n.style,e,t[e])}else if(e[0]=="o"&&e[1]=="n")typeof t!="function"&&(t=null),typeof i!="function"&&(i=null),(n.__e||(n.__e={}))[e]=t,t&&i||(o=yu[e]||(yu[e]=Lg(e)),(n.__a||(n.__a={}))[e]=Rh,r=e!=(e=e.replace(hm,"$1")),(e=e.slice(2))[0]<"a"&&(e=e.toLowerCase()),t?n.addEventListener(e,o,r):n.removeEventListener(e,o,r));else{if(s=="http://www.w3.org/2000/svg")e=e.replace(/xlink(H|:h)/,"h").replace(/sName$/,"s");else if(e!="width"&&e!="height"&&e!="href"&&e!="list"&&e!="form"&&e!="tabIndex"&&e!="download"&&e!="rowSpan"&&e!="colSpan"&&e!="role"&&e!="popover"&&e in n)try{return void(n[e]=t??"")}catch{}if(typeof t=="function")return;t==null||t===!1&&e[4]!="-"?n.removeAttribute(e):n.setAttribute(e,e=="popover"&&t==1?"":t)}}function Lg(n){return function(e){var t=this.__e;if(t){if(t=t[n],e[yl]==null)e[yl]=Rh++;else if(e[yl]<this.__a[n])return;return t(Tt.event?Tt.event(e):e)}}}function Dh(n,e,t,i,s,r,o,a,l,c){var u,f,d,h,_,x,m,p,M,b,v,L,R,U,N,T,E,C,B=e.type;if(e.constructor!==Aa)return null;128&t.__u&&(l=32&t.__u,u=t.__c.__z)&&(e.__u|=l,f=r=[],u.nodeType==8?a=Ml(u,r):r.push(u),a=r[0]||a),(u=Tt.__b)&&u(e);e:if(typeof B=="function"){d=o.length;try{if(p=e.props,M=(u=B.prototype)&&u.render,b=(u=B.contextType)&&i[u.__c],v=u?b?b.props.value:u.__:i,(h=t.__c)?(e.__c=h,2&h.__g&&(h.__g|=1)):(M?e.__c=h=new B(p,v):(e.__c=h=new aa(p,v),h.constructor=B,h.render=Ug),b&&b.sub(h),h.state||(h.state={}),h.__n=i,h.__g|=8,h.__h=[],h.__k=[]),M&&(h.__s||(h.__s=h.state),B.getDerivedStateFromProps&&(h.__s==h.state&&(h.__s=pr({},h.__s)),pr(h.__s,B.getDerivedStateFromProps(p,h.__s)))),_=h.props,x=h.state,h.__v=e,t.__c){if(p!==_&&M&&!B.getDerivedStateFromProps&&h.componentWillReceiveProps&&h.componentWillReceiveProps(p,v),e.__v==t.__v&&!(8&h.__g)||!(4&h.__g)&&h.shouldComponentUpdate&&h.shouldComponentUpdate(p,h.__s,v)===!1){e.__v!=t.__v&&(h.props=p,h.state=h.__s,h.__g&=-9),e.__e=t.__e,e.__k=t.__k,e.__k.some(function(z){z&&(z.__=e)}),Nl.push.apply(h.__h,h.__k),h.__k=[],h.__h.length&&o.push(h),a=ks(t);break e}h.componentWillUpdate&&h.componentWillUpdate(p,h.__s,v),M&&h.componentDidUpdate&&h.__h.push(function(){h.componentDidUpdate(_,x,m)})}else M&&!B.getDerivedStateFromProps&&h.componentWillMount&&h.componentWillMount(),M&&h.componentDidMount&&h.__h.push(h.componentDidMount);h.context=v,h.props=p,h.__P=n,h.__g&=-5,L=Tt.__r,R=M?25:0;do h.__g&=-9,L&&L(e),u=h.render(h.props,h.state=h.__s,h.context);while(8&h.__g&&++R<25);M&&(Nl.push.apply(h.__h,h.__k),h.__k=[]),h.state=h.__s,h.getChildContext&&(i=pr({},i,h.getChildContext())),M&&t.__c&&h.getSnapshotBeforeUpdate&&(m=h.getSnapshotBeforeUpdate(_,x)),U=u&&u.type===ci&&u.key==null?u.props.children:u,p.__P&&(u=a,s=(n=p.__P).namespaceURI,l=r=null,t.props&&t.props.__P!=n&&(t.__k.some(function(z){z&&Ih(z,z)}),t.__k=null),a=t.__k?ks(t,0):null),a=pm(n,Ch(U)?U:[U],e,t,i,s,r,o,a,l,c),p.__P&&(e.__e=null,a=u),e.__u&=-161,f&&f.some(hr),h.__h.length&&o.push(h),1&h.__g&&(h.__g&=-4)}catch(z){if(o.length=d,e.__v=null,l||r)if(z&&z.then){if(e.__u|=128|l,r){for(~(E=r.indexOf(a||void 0))||(E=r.length);(C=r[E-1])&&C.nodeType==8;)E--;for(;E<r.length;E++)if(C=r[E])if(r[E]=null,N){if(C==T)break}else{if(C.nodeType!=8)break;C.data.startsWith("$s")&&(T=Ml(N=C))}}if(!N){for(;a&&a.nodeType==8&&a.nextSibling;)a=a.nextSibling;N=a}(u=Ml(N=e.__c.__z||(e.__c.__z=N)))?(e.__e=N,a=u):e.__e=a,a=a&&a.nextSibling}else r&&r.some(hr);else e.__e=t.__e;e.__k||(e.__k=t.__k||[]),z&&z.then||_m(e),Tt.__e(z,e,t)}}else a=e.__e=Ig(t.__e,e,t,i,s,r,o,l,c,n);return(u=Tt.diffed)&&u(e),a}function Ml(n,e){if(n&&n.nodeType==8&&n.data.startsWith("$s"))for(var t=1;n=n.nextSibling;){if(n.nodeType==8){if(n.data.startsWith("$s"))t++;else if(n.data.startsWith("/$s")&&!--t)return n}e&&e.push(n)}}function _m(n){n&&(n.__c&&(n.__c.__g|=4),n.__k&&n.__k.some(_m))}function gm(n,e,t){for(var i=0;i<t.length;)Lh(t[i++],t[i++],t[i++]);Tt.__c&&Tt.__c(e,n),n.some(function(s){try{n=s.__h,s.__h=[],n.some(function(r){r.call(s)})}catch(r){Tt.__e(r,s.__v)}})}function Ig(n,e,t,i,s,r,o,a,l,c){var u,f,d,h,_,x,m,p,M=t.props||Ul,b=e.props,v=e.type;if(v=="svg"?s="http://www.w3.org/2000/svg":v=="math"?s="http://www.w3.org/1998/Math/MathML":s||(s="http://www.w3.org/1999/xhtml"),r){for(u=0;u<r.length;u++)if((_=r[u])&&(v?_.localName==v:_.nodeType==3)){n=_,r[u]=null;break}}if(!n){if(p=c.ownerDocument||document,!v)return p.createTextNode(b);n=p.createElementNS(s,v,b.is?b:c),a&&(Tt.__m&&Tt.__m(e,r),a=!1),r=null}if(v){if(c=v=="template"&&n.content||n,r=v=="textarea"&&b.defaultValue!=null?null:r&&Ph.call(c.childNodes),!a&&r)for(M={},u=0;u<n.attributes.length;u++)M[(_=n.attributes[u]).name]=_.value;for(u in M)_=M[u],u=="dangerouslySetInnerHTML"?d=_:u=="children"||u in b||u=="value"&&"defaultValue"in b||u=="checked"&&"defaultChecked"in b||ka(n,u,null,_,s);for(u in b)_=b[u],u=="children"?h=_:u=="dangerouslySetInnerHTML"?f=_:u=="value"?x=_:u=="checked"?m=_:a&&typeof _!="function"||M[u]===_||ka(n,u,_,M[u],s);f?(a||d&&(f.__html==d.__html||f.__html==n.innerHTML)||(n.innerHTML=f.__html),e.__k=[]):(d&&(n.textContent=""),(v=="foreignObject"||s=="http://www.w3.org/1998/Math/MathML"&&Ag.test(v))&&(s="http://www.w3.org/1999/xhtml"),pm(c,Ch(h)?h:[h],e,t,i,s,r,o,r?r[0]:t.__k&&ks(t,0),a,l),r&&r.some(hr)),a&&v!="textarea"||(u="value",v=="progress"&&x==null?n.removeAttribute(u):x==null||x===n[u]&&(v!="progress"||x)||ka(n,u,x,M[u],s),u="checked",m!=null&&m!=n[u]&&ka(n,u,m,M[u],s))}else M===b||a&&n.data==b||(n.data=b);return n}function Lh(n,e,t,i){try{typeof n=="function"?e?e.__x=n(e)||1:i&&(i=i.__c||i.__e)&&(e=i.__x)&&(i.__x=null,typeof e=="function"?e():n(null)):n.current=e}catch(s){Tt.__e(s,t)}}function Ih(n,e,t){var i,s,r,o;if(Tt.unmount&&Tt.unmount(n),!(i=n.ref)||i.current&&i.current!=n.__e||Lh(i,null,e,n),i=n.__c){if(i.componentWillUnmount)try{i.componentWillUnmount()}catch(a){Tt.__e(a,e)}i.__P=i.__n=null}if(i=n.__k)for(o=0;o<i.length;o++)i[o]&&Ih(i[o],e,typeof n.type!="function"||t&&!n.props.__P);!t&&(i=n.__c)&&(i=i.__z)&&(s=Ml(i,r=[]))&&(i==n.__e&&r.some(hr),hr(s),hr(i)),t||hr(n.__e),n.__e=n.__c=n.__=null}function Ug(n,e,t){return this.constructor(n,t)}function Ng(n,e){var t,i,s,r;Tt.__&&Tt.__(n,e),e.nodeType==9&&(e=e.documentElement),i=(t=n&&32&n.__u)?null:e.__k,e.__k=oa(ci,{children:[n]}),s=[],r=[],Dh(e,e.__k,i||Ul,Ul,e.namespaceURI,i?null:e.firstChild?Ph.call(e.childNodes):null,s,i?i.__e:e.firstChild,t,r),gm(s,e.__k,r),e.__k.props.children=null}Tt={__e:function(n,e,t,i){for(var s,r,o;e=e.__;)if((s=e.__c)&&!(1&s.__g)){s.__g|=4;try{if((o=(r=s.constructor)&&r.getDerivedStateFromError)&&s.setState(r.getDerivedStateFromError(n)),s.componentDidCatch&&(s.componentDidCatch(n,i||{}),o=1),o&&8&s.__g)return void(s.__g|=2)}catch(a){n=a}}throw Il=0,n}},lm=0,cm=function(n){return n!=null&&n.constructor===Aa},aa.prototype.setState=function(n,e){var t=this.__s;t&&t!=this.state||(t=this.__s=pr({},this.state)),typeof n=="function"&&(n=n(pr({},t),this.props)),n&&(pr(t,n),this.__v&&(e&&this.__k.push(e),zf(this)))},aa.prototype.forceUpdate=function(n){this.__v&&(this.__g|=4,n&&this.__h.push(n),zf(this))},aa.prototype.render=ci,Cs=[],Il=0,um=function(n,e){return n.__v.__b-e.__v.__b},yl=Symbol(),hm=/(PointerCapture)$|Capture$/i,Rh=0,yu={};var Fg=Symbol.for("pv"),Og=0;function w(n,e,t,i,s,r){e||(e={});var o,a,l=e;if("ref"in l&&typeof n!="function")for(a in l={},e)a=="ref"?o=e[a]:l[a]=e[a];var c={type:n,props:l,key:t,ref:o,__k:null,__:null,__b:0,__e:null,__c:null,constructor:Fg,__v:--Og,__i:-1,__u:0};return Tt.vnode&&Tt.vnode(c),c}var ao,un,wc,Vf,Mu=Object.is,Fl=0,vm=[],Su=[],nn=Tt,Gf=nn.__b,Wf=nn.__r,Xf=nn.diffed,Yf=nn.__c,qf=nn.unmount,$f=nn.__;function Kl(n,e){nn.__h&&nn.__h(un,n,Fl||e),Fl=0;var t=un.__H||(un.__H={__:[],__h:[]});return n>=t.__.length&&t.__.push({}),t.__[n]}function lo(n){return Fl=1,kg(xm,n)}function kg(n,e,t){var i=Kl(ao++,2);if(i.t=n,!i.__c&&(i.__=[xm(void 0,e),function(r){var o=(i.__N||i.__)[0],a=i.t(o,r);Mu(o,a)||(i.__N=[a,i.__[1]],i.__c.setState({}))}],i.__c=un,!un.__f)){un.__f=!0;var s=un.shouldComponentUpdate;un.shouldComponentUpdate=function(r,o,a){var l=this.__H;if(!l)return!0;var c=!1,u=this.props!=r;if(l.__.some(function(d){d.__N&&(c=!0,Mu(d.__[0],d.__N[0])||(u=!0))}),s){var f=s.call(this,r,o,a);return c?f||u:f}return!c||u}}return i.__}function Ra(n,e){var t=Kl(ao++,3);!nn.__s&&Nh(t.__H,e)&&(t.__P=!0,t.__=n,t.u=e,un.__H.__h.push(t))}function Bg(n,e){var t=Kl(ao++,4);!nn.__s&&Nh(t.__H,e)&&(t.__P=!1,t.__=n,t.u=e,un.__h.push(t))}function Zi(n){return Fl=5,Uh(function(){return{current:n}},[])}function Uh(n,e){var t=Kl(ao++,7);return Nh(t.__H,e)&&(t.__=n(),t.__H=e),t.__}function zg(){var n;do{for(;n=Su.shift();)try{la(n)}catch(t){nn.__e(t,{__:(n=n.__P)&&n.__v})}for(;n=vm.shift();){var e=n.__H;if(n.__P&&e)try{e.__h.some(la),e.__h.some(Eu),e.__h=[]}catch(t){e.__h=[],nn.__e(t,n.__v)}}}while(Su.length)}nn.__b=function(n){un=null,Gf&&Gf(n)},nn.__=function(n,e){n&&e.__k&&e.__k.__m&&(n.__m=e.__k.__m),$f&&$f(n,e)},nn.__r=function(n){Wf&&Wf(n),ao=0;var e=(un=n.__c).__H;e&&(wc==un?un.__h=[]:(e.__h.some(la),e.__h.some(Eu),ao=0),e.__h=[],e.__.some(function(t){t.__N&&(t.__=t.__N),t.u=t.__N=void 0})),wc=un},nn.diffed=function(n){Xf&&Xf(n);var e=n.__c;e&&e.__H&&(e.__H.__h.length&&Zf(vm.push(e)),e.__H.__.some(function(t){t.u&&(t.__H=t.u)})),wc=un=null},nn.__c=function(n,e){e.some(function(t){try{t.__h.some(la),t.__h=t.__h.filter(function(i){return!i.__||Eu(i)})}catch(i){t.__h=[function(){throw i}]}}),Yf&&Yf(n,e)},nn.unmount=function(n){qf&&qf(n);var e,t,i=n.__c;i&&i.__H&&(i.__H.__.some(function(s){try{if(s.__P&&s.__c){if(t===void 0){for(t=n.__;t&&(!t.__c||!t.__c.__P);)t=t.__;t=t&&t.__c}s.__P=t,Zf(Su.push(s))}else la(s)}catch(r){e=r}}),i.__H=void 0,e&&nn.__e(e,i.__v))};var jf=typeof requestAnimationFrame=="function";function Hg(n){var e,t=function(){clearTimeout(i),jf&&cancelAnimationFrame(e),setTimeout(n)},i=setTimeout(t,35);jf&&(e=requestAnimationFrame(t))}function Zf(n){n!=1&&Vf==nn.requestAnimationFrame||((Vf=nn.requestAnimationFrame)||Hg)(zg)}function la(n){var e=un,t=n.__c;typeof t=="function"&&(n.__c=void 0,t()),un=e}function Eu(n){var e=un;n.__c=n.__(),un=e}function Nh(n,e){return!n||n.length!=e.length||e.some(function(t,i){return!Mu(t,n[i])})}function xm(n,e){return typeof e=="function"?e(n):e}var Vg=Symbol.for("preact-signals");function Jl(){if(ls>1)ls--;else{var n,e=!1;for((function(){var s=kl;for(kl=void 0;s!==void 0;){var r=s.S;if(r.v===s.v)for(var o=r.t;o!==void 0;o=o.x)o.i===s.i&&(o.i=r.i);s=s.o}})();ua!==void 0;){var t=ua;for(ua=void 0,Ol++;t!==void 0;){var i=t.u;if(t.u=void 0,t.f&=-3,!(8&t.f)&&Mm(t))try{t.c()}catch(s){e||(n=s,e=!0)}t=i}}if(Ol=0,ls--,e)throw n}}function Gg(n){if(ls>0)return n();bu=++Wg,ls++;try{return n()}finally{Jl()}}var ca,Kt=void 0;function Ql(n){var e=Kt,t=ca;Kt=void 0,ca=void 0;try{return n()}finally{Kt=e,ca=t}}var ua=void 0,ls=0,Ol=0,Wg=0,bu=0,kl=void 0,Bl=0;function ym(n){if(Kt!==void 0){var e=n.n;if(e===void 0||e.t!==Kt)return e={i:0,S:n,p:Kt.s,n:void 0,t:Kt,e:void 0,x:void 0,r:e},Kt.s!==void 0&&(Kt.s.n=e),Kt.s=e,n.n=e,32&Kt.f&&n.S(e),e;if(e.i===-1)return e.i=0,e.n!==void 0&&(e.n.p=e.p,e.p!==void 0&&(e.p.n=e.n),e.p=Kt.s,e.n=void 0,Kt.s.n=e,Kt.s=e),e}}function Dn(n,e){this.v=n,this.i=0,this.n=void 0,this.t=void 0,this.l=0,this.W=e?.watched,this.Z=e?.unwatched,this.name=e?.name}Dn.prototype.brand=Vg;Dn.prototype.h=function(){return!0};Dn.prototype.S=function(n){var e=this,t=this.t;t!==n&&n.e===void 0&&(n.x=t,this.t=n,t!==void 0?t.e=n:Ql(function(){var i;(i=e.W)==null||i.call(e)}))};Dn.prototype.U=function(n){var e=this;if(this.t!==void 0){var t=n.e,i=n.x;t!==void 0&&(t.x=i,n.e=void 0),i!==void 0&&(i.e=t,n.x=void 0),n===this.t&&(this.t=i,i===void 0&&Ql(function(){var s;(s=e.Z)==null||s.call(e)}))}};Dn.prototype.subscribe=function(n){var e=this;return sn(function(){var t=e.value;Ql(function(){return n(t)})},{name:"sub"})};Dn.prototype.valueOf=function(){return this.value};Dn.prototype.toString=function(){return this.value+""};Dn.prototype.toJSON=function(){return this.value};Dn.prototype.peek=function(){var n=this;return Ql(function(){return n.value})};Object.defineProperty(Dn.prototype,"value",{get:function(){var n=ym(this);return n!==void 0&&(n.i=this.i),this.v},set:function(n){if(n!==this.v){if(Ol>100)throw new Error("Cycle detected");(function(t){ls!==0&&Ol===0&&t.l!==bu&&(t.l=bu,kl={S:t,v:t.v,i:t.i,o:kl})})(this),this.v=n,this.i++,Bl++,ls++;try{for(var e=this.t;e!==void 0;e=e.x)e.t.N()}finally{Jl()}}}});function at(n,e){return new Dn(n,e)}function Mm(n){for(var e=n.s;e!==void 0;e=e.n)if(e.S.i!==e.i||!e.S.h()||e.S.i!==e.i)return!0;return!1}function Sm(n){for(var e=n.s;e!==void 0;e=e.n){var t=e.S.n;if(t!==void 0&&(e.r=t),e.S.n=e,e.i=-1,e.n===void 0){n.s=e;break}}}function Em(n){for(var e=n.s,t=void 0;e!==void 0;){var i=e.p;e.i===-1?(e.S.U(e),i!==void 0&&(i.n=e.n),e.n!==void 0&&(e.n.p=i)):t=e,e.S.n=e.r,e.r!==void 0&&(e.r=void 0),e=i}n.s=t}function Mr(n,e){Dn.call(this,void 0,e),this.x=n,this.s=void 0,this.g=Bl-1,this.f=4}Mr.prototype=new Dn;Mr.prototype.h=function(){if(this.f&=-3,1&this.f)return!1;if((36&this.f)==32||(this.f&=-5,this.g===Bl))return!0;if(this.g=Bl,this.f|=1,this.i>0&&!Mm(this))return this.f&=-2,!0;var n=Kt;try{Sm(this),Kt=this;var e=this.x();(16&this.f||this.v!==e||this.i===0)&&(this.v=e,this.f&=-17,this.i++)}catch(t){this.v=t,this.f|=16,this.i++}return Kt=n,Em(this),this.f&=-2,!0};Mr.prototype.S=function(n){if(this.t===void 0){this.f|=36;for(var e=this.s;e!==void 0;e=e.n)e.S.S(e)}Dn.prototype.S.call(this,n)};Mr.prototype.U=function(n){if(this.t!==void 0&&(Dn.prototype.U.call(this,n),this.t===void 0)){this.f&=-33;for(var e=this.s;e!==void 0;e=e.n)e.S.U(e)}};Mr.prototype.N=function(){if(!(2&this.f)){this.f|=6;for(var n=this.t;n!==void 0;n=n.x)n.t.N()}};Object.defineProperty(Mr.prototype,"value",{get:function(){if(1&this.f)throw new Error("Cycle detected");var n=ym(this);if(this.h(),n!==void 0&&(n.i=this.i),16&this.f)throw this.v;return this.v}});function wu(n,e){return new Mr(n,e)}function bm(n){var e=n.j;if(n.j=void 0,typeof e=="function"){ls++;var t=Kt;Kt=void 0;try{e()}catch(i){throw n.f&=-2,n.f|=8,Fh(n),i}finally{Kt=t,Jl()}}}function Fh(n){for(var e=n.s;e!==void 0;e=e.n)e.S.U(e);n.x=void 0,n.s=void 0,bm(n)}function Xg(n){if(Kt!==this)throw new Error("Out-of-order effect");Em(this),Kt=n,this.f&=-2;try{8&this.f&&Fh(this)}finally{Jl()}}function Mo(n,e){this.x=n,this.j=void 0,this.s=void 0,this.u=void 0,this.f=32,this.name=e?.name,ca&&ca.push(this)}Mo.prototype.c=function(){var n=this.S();try{if(8&this.f||this.x===void 0)return;var e=this.x();typeof e=="function"&&(this.j=e)}finally{n()}};Mo.prototype.S=function(){if(1&this.f)throw new Error("Cycle detected");this.f|=1,this.f&=-9,bm(this),Sm(this),ls++;var n=Kt;return Kt=this,Xg.bind(this,n)};Mo.prototype.N=function(){2&this.f||(this.f|=2,this.u=ua,ua=this)};Mo.prototype.d=function(){this.f|=8,1&this.f||Fh(this)};Mo.prototype.dispose=function(){this.d()};function sn(n,e){var t=new Mo(n,e);try{t.c()}catch(s){throw t.d(),s}var i=t.d.bind(t);return i[Symbol.dispose]=i,i}var wm,Ba,Yg=typeof window<"u"&&!!window.__PREACT_SIGNALS_DEVTOOLS__,Tm=[];sn(function(){wm=this.N})();function So(n,e){Tt[n]=e.bind(null,Tt[n]||function(){})}function ma(n){if(Ba){var e=Ba;Ba=void 0,e()}Ba=n&&n.S()}function Am(n){var e=this,t=n.data,i=$g(t);i.name="ReactiveDom",i.value=t;var s=Uh(function(){for(var a=e,l=e.__v;l=l.__;)if(l.__c){l.__c.__$f|=4;break}var c=wu(function(){var h=i.value.value;return h===0?0:h===!0?"":h||""}),u=wu(function(){return!Array.isArray(c.value)&&!cm(c.value)}),f=sn(function(){if(this.N=Rm,u.value){var h=c.value;a.__v&&a.__v.__e&&a.__v.__e.nodeType===3&&(a.__v.__e.data=h)}}),d=e.__$u.d;return e.__$u.d=function(){f(),d.call(this)},[u,c]},[]),r=s[0],o=s[1];return r.value?o.peek():o.value}Am.displayName="ReactiveTextNode";Object.defineProperties(Dn.prototype,{constructor:{configurable:!0,value:Rg(ci,null).constructor},type:{configurable:!0,value:Am},props:{configurable:!0,get:function(){var n=this;return{data:{get value(){return n.value}}}}},__b:{configurable:!0,value:1}});So("__b",function(n,e){if(ma(),typeof e.type=="string"){var t,i=e.props;for(var s in i)if(s!=="children"){var r=i[s];r instanceof Dn&&(t||(e.__np=t={}),t[s]=r,i[s]=r.peek())}}n(e)});So("__r",function(n,e){if(n(e),e.type!==ci){ma();var t,i=e.__c;i&&(i.__$f&=-2,(t=i.__$u)===void 0&&(i.__$u=t=(function(s,r){var o;return sn(function(){o=this},{name:r}),o.c=s,o})((function(s){return function(){var r;Yg&&((r=this.y)==null||r.call(this)),s.__$f|=1,s.setState({})}})(i),typeof e.type=="function"?e.type.displayName||e.type.name:""))),ma(t)}});So("__e",function(n,e,t,i){ma(),n(e,t,i)});So("diffed",function(n,e){ma();var t;if(typeof e.type=="string"&&(t=e.__e)){var i=e.__np,s=e.props,r=t.U;if(r)for(var o in r){var a=r[o];a===void 0||i&&o in i||(a.d(),r[o]=void 0)}if(i){r||(r={},t.U=r);for(var l in i){var c=r[l],u=i[l];c===void 0?(c=qg(t,l,u,s),r[l]=c):c.o(u,s)}}}n(e)});function qg(n,e,t,i){var s=e in n&&n.ownerSVGElement===void 0,r=at(t);return{o:function(o,a){r.value=o,i=a},d:sn(function(){this.N=Rm;var o=r.value.value;i[e]!==o&&(i[e]=o,s?n[e]=o:o!=null&&(o!==!1||e[4]==="-")?n.setAttribute(e,o):n.removeAttribute(e))})}}So("unmount",function(n,e){if(typeof e.type=="string"){var t=e.__e;if(t){var i=t.U;if(i){t.U=void 0;for(var s in i){var r=i[s];r&&r.d()}}}var o=e.__np;if(o){var a=e.props;for(var l in o)a[l]=o[l]}e.__np=void 0}else{var c=e.__c;if(c){c.__$f|=8;var u=c.__$u;u&&(c.__$u=void 0,u.d())}}n(e)});So("__h",function(n,e,t,i){i<3&&(e.__$f|=2),n(e,t,i)});aa.prototype.shouldComponentUpdate=function(n,e){if(this.__R)return!0;var t=this.__$u,i=t&&t.s!==void 0;for(var s in e)return!0;if(this.__f||typeof this.u=="boolean"&&this.u===!0){var r=2&this.__$f;if(!(i||r||4&this.__$f)||1&this.__$f)return!0}else if(!(i||4&this.__$f)||3&this.__$f)return!0;for(var o in n)if(o!=="__source"&&n[o]!==this.props[o])return!0;for(var a in this.props)if(!(a in n))return!0;return!1};function $g(n,e){return Uh(function(){return at(n,e)},[])}var jg=function(n){queueMicrotask(function(){queueMicrotask(n)})};function Zg(){Gg(function(){for(var n;n=Tm.shift();)wm.call(n)})}function Rm(){Tm.push(this)===1&&(Tt.requestAnimationFrame||jg)(Zg)}const Kf=250,Kg=5e3;class Jg{constructor(e){this.listener=e}listener;socket=null;waiting=new Map;next=1;wait=Kf;async open(){const e=/(?:^#|&)token=([0-9a-f]+)/.exec(location.hash)?.[1];if(e){const t=await fetch("/api/session",{method:"POST",body:JSON.stringify({token:e})}).catch(()=>null);if(history.replaceState(null,"",location.pathname+location.search),t&&!t.ok)return this.listener.phase("refused",await t.text())}this.connect(),setInterval(()=>this.post({ping:performance.now()}),2e3)}connect(){this.listener.phase("connecting","");const e=new WebSocket(`ws://${location.host}/ws`);e.binaryType="arraybuffer",this.socket=e,e.onopen=()=>{this.wait=Kf,this.listener.phase("open",""),this.post({ping:performance.now()})},e.onmessage=t=>{typeof t.data=="string"?this.text(JSON.parse(t.data)):this.listener.frame(t.data)},e.onclose=()=>{this.lost()}}async lost(){for(const t of this.waiting.values())t.reject(new Error("the connection was lost"));if(this.waiting.clear(),(await fetch("/api/project.json").catch(()=>null))?.status===401)return this.listener.phase("refused","This window is not signed in: open the address that the program printed.");this.listener.phase("lost",""),setTimeout(()=>this.connect(),this.wait),this.wait=Math.min(2*this.wait,Kg)}text(e){if(typeof e.section=="string")return this.listener.section(e.section,e.value);if(typeof e.pong=="number")return this.listener.roundTrip(performance.now()-e.pong);if(typeof e.ack=="number"){const t=this.waiting.get(e.ack);this.waiting.delete(e.ack),typeof e.error=="string"?t?.reject(new Error(e.error)):t?.resolve(e.value);return}typeof e.event=="string"&&this.listener.event(e)}post(e){return this.socket?.readyState!==WebSocket.OPEN?!1:(this.socket.send(JSON.stringify(e)),!0)}send(e){const t=this.next++;return new Promise((i,s)=>{this.post({id:t,...e})?this.waiting.set(t,{resolve:i,reject:s}):s(new Error("not connected"))})}drop(){this.socket?.close()}}class co{constructor(e,t=()=>{},i=()=>{}){this.send=e,this.answered=t,this.failed=i}send;answered;failed;busy=!1;latest=null;push(e){this.latest=e,this.busy||this.drain()}async drain(){for(this.busy=!0;this.latest;){const e=this.latest;this.latest=null;try{this.answered(await this.send(e))}catch(t){this.failed(t)}}this.busy=!1,this.idle.splice(0).forEach(e=>e())}idle=[];settled(){return this.busy?new Promise(e=>this.idle.push(e)):Promise.resolve()}}const Jf=document.getElementById("snapshot"),Oh=Jf?JSON.parse(Jf.textContent??"null"):null,Eo=Oh!==null;function Sl(n){const e=atob(n),t=new Uint8Array(e.length);for(let i=0;i<e.length;i++)t[i]=e.charCodeAt(i);return t.buffer}function Qg(n){const e=Oh?.meshes[n];return e===void 0?null:Sl(e)}class e0{constructor(e){this.listener=e}listener;data=Oh;motion=this.data.sections.motion;pictures=this.data.pictures.map(Sl);last=0;open(){for(const[e,t]of Object.entries(this.data.sections))this.listener.section(e,t);return this.listener.frame(Sl(this.data.frame)),this.listener.frame(Sl(this.data.ghosts)),this.listener.phase("open","shared"),Promise.resolve()}drop(){}send(e){const{motion:t}=this;if(e.do==="samples")return Promise.resolve(this.data.samples);if(e.do==="ghosts"||e.do==="pick")return Promise.resolve(null);if(t)switch(e.do){case"play":return t.time>=t.duration&&(t.time=0),this.change({playing:!0}),this.last=performance.now(),requestAnimationFrame(()=>this.advance()),Promise.resolve(null);case"pause":return this.change({playing:!1}),Promise.resolve(null);case"seek":return this.show(Number(e.t)),this.change({}),Promise.resolve(null);case"step":return this.change({playing:!1}),this.show(t.time+Number(e.by)/30),this.change({}),Promise.resolve(null);case"loop":return this.change({loop:e.on===!0}),Promise.resolve(null);case"speed":return this.change({speed:Number(e.to)}),Promise.resolve(null)}return Promise.reject(new Error("This is a shared file: there is no program behind it."))}change(e){this.motion&&(this.motion={...this.motion,...e},this.listener.section("motion",this.motion))}show(e){const{motion:t}=this;if(!t)return;t.time=Math.min(t.duration,Math.max(0,e));const i=Math.round(t.time/t.duration*(this.pictures.length-1)),s=this.pictures[i];s&&this.listener.frame(s)}advance(){const{motion:e}=this;if(!e?.playing)return;const t=performance.now();let i=e.time+e.speed*(t-this.last)/1e3;if(this.last=t,i>e.duration&&e.loop&&(i%=e.duration),this.show(i),i>e.duration)return this.change({playing:!1});requestAnimationFrame(()=>this.advance())}}const Ur=16;function t0(n){if(n.byteLength<Ur+4)return null;const e=new DataView(n),t=e.getUint8(0),i=e.getUint16(2,!0),s=e.getUint32(4,!0),r=e.getUint32(Ur,!0);if(t===1){const o=Ur+4+4*r;return n.byteLength<o+64*i?null:{kind:"pose",playing:(e.getUint8(1)&1)===1,sequence:s,links:i,time:e.getFloat64(8,!0),q:new Float32Array(n,Ur+4,r),matrices:new Float32Array(n,o,16*i)}}return t===2?n.byteLength<Ur+4+64*i*r?null:{kind:"ghosts",sequence:s,links:i,count:r,matrices:new Float32Array(n,Ur+4,16*i*r)}:null}function n0(n){if(n.byteLength<12)return null;const e=new DataView(n);if(e.getUint32(0,!0)!==827150416)return null;const t=e.getUint32(4,!0),i=e.getUint32(8,!0);return n.byteLength!==12+24*t+4*i?null:{positions:new Float32Array(n,12,3*t),normals:new Float32Array(n,12+12*t,3*t),indices:new Uint32Array(n,12+24*t,i)}}const zl=at([]),mn=at(null),Ji=at(null),fs=at(null),gr=at(null),Cm=at({undo:null,redo:null}),Ko=at([]),ha=at(null),_a=at([]),Ca=at(null),ec=at(new Float32Array),Wi=at(0),to=at("connecting"),Pm=at(""),Dm=at(null),Jo=at([]),Lm=at("");function ga(n,e,t){const i=Im(()=>localStorage.getItem(`pieper.${n}`));return i&&e.includes(i)?i:t}function Im(n){try{return n()}catch{return null}}function va(n,e){Im(()=>localStorage.setItem(`pieper.${n}`,e))}const Tc=at("joints"),Ps=at(null),Us=at(!0),oi=at(ga("theme",["system","light","dark"],"system")),Ct=at({angle:ga("angle",["deg","rad"],"deg"),length:ga("length",["mm","m"],"mm")}),El=at(ga("letters",["on","off"],"on")==="on"),kh=at(Eo||ga("hint",["seen","new"],"new")==="seen");function Um(){kh.value=!0,va("hint","seen")}const Bs=at(null),rt={ghosts:at(!1),frames:at(!1),trail:at(!0),outline:at(!1),gizmo:at("off"),local:at(!1),collision:at(!1)},Ms=at(null),Qo=at(null),bl=at(!1),mr=wu(()=>oi.value==="dark"||oi.value==="system"&&Fm.value),Nm=matchMedia("(prefers-color-scheme: dark)"),Fm=at(Nm.matches);Nm.addEventListener("change",n=>Fm.value=n.matches);const Om=[];function i0(n){Om.push(n)}const s0={robots:n=>zl.value=n,robot:n=>mn.value=n,pose:n=>Ji.value=n,ik:n=>fs.value=n,motion:n=>{const e=n.samples!==gr.value?.samples||!Ca.value;gr.value=n,n.playing||(Wi.value=n.time),e&&r0()},script:n=>ha.value=n,history:n=>Cm.value=n,log:n=>Ko.value=n};async function r0(){Ca.value=await Ii.send({do:"samples",rate:60})}const Qf={section:(n,e)=>s0[n]?.(e),event:n=>{if(n.event!=="console")return;const e={stream:n.stream,text:n.text};_a.value=[..._a.value,e].slice(-500)},frame:n=>{const e=t0(n);if(e){e.kind==="pose"&&(ec.value=e.q,e.playing&&(Wi.value=e.time));for(const t of Om)t(e)}},phase:(n,e)=>{to.value=n,Pm.value=e},roundTrip:n=>Dm.value=n},Ii=Eo?new e0(Qf):new Jg(Qf);let o0=0;function Kn(n,e="error"){const t=++o0;Jo.value=[...Jo.value.filter(i=>i.text!==n),{id:t,text:n,kind:e}].slice(-3),setTimeout(()=>Jo.value=Jo.value.filter(i=>i.id!==t),e==="error"?7e3:3500)}async function st(n){try{return await Ii.send(n)}catch(e){Kn(e.message);return}}let a0=0;function xa(n){return`${n}-${++a0}-${Date.now()}`}const l0={undo:"M7 5 3.5 8.5 7 12M4 8.5h7.5a4.5 4.5 0 0 1 0 9H9",redo:"M13 5l3.5 3.5L13 12M16 8.5H8.5a4.5 4.5 0 0 0 0 9H11",play:"M6 4.5v11l9-5.5z",pause:"M6.5 4.5v11M13.5 4.5v11",back:"M14 5v10l-6-5zM5.5 5v10",forward:"M6 5v10l6-5zM14.5 5v10",stop:"M5.5 5.5h9v9h-9z",loop:"M4 10a5 5 0 0 1 5-5h6M12.5 2.5 15 5l-2.5 2.5M16 10a5 5 0 0 1-5 5H5M7.5 17.5 5 15l2.5-2.5",sun:"M10 6.2a3.8 3.8 0 1 0 0 7.6 3.8 3.8 0 0 0 0-7.6M10 1.5v2M10 16.5v2M1.5 10h2M16.5 10h2M4 4l1.4 1.4M14.6 14.6 16 16M16 4l-1.4 1.4M5.4 14.6 4 16",moon:"M16 11.8A6.5 6.5 0 0 1 8.2 4 6.5 6.5 0 1 0 16 11.8z",auto:"M10 3a7 7 0 1 0 0 14zM10 3a7 7 0 0 1 0 14",camera:"M3 6.5h3l1.3-2h5.4l1.3 2h3v9H3zM10 8.2a2.6 2.6 0 1 0 0 5.2 2.6 2.6 0 0 0 0-5.2",home:"M3.5 9.5 10 4l6.5 5.5M5.5 8.5V16h9V8.5",ghost:"M4.5 16V9a5.5 5.5 0 0 1 11 0v7l-2-1.5-1.8 1.5L10 14.5 8.3 16l-1.8-1.5zM8 9v.01M12 9v.01",axes:"M6 14V4M6 14h10M6 14l-3 3M4.3 5.7 6 4l1.7 1.7M14.3 12.3 16 14l-1.7 1.7",trail:"M3 15c4 0 3-9 7-9s3 7 7 4",reach:"M3 16a7 7 0 0 1 14 0M6.5 16a3.5 3.5 0 0 1 7 0",move:"M10 2.5v15M2.5 10h15M7.8 4.7 10 2.5l2.2 2.2M7.8 15.3 10 17.5l2.2-2.2M4.7 7.8 2.5 10l2.2 2.2M15.3 7.8 17.5 10l-2.2 2.2",rotate:"M15.5 7A6.5 6.5 0 1 0 16.5 11M16 3v4h-4",plus:"M10 4v12M4 10h12",close:"M5 5l10 10M15 5 5 15",lock:"M5.5 9h9v7.5h-9zM7 9V6.5a3 3 0 0 1 6 0V9",unlock:"M5.5 9h9v7.5h-9zM7 9V6.5a3 3 0 0 1 5.8-1",warn:"M10 3.5 17.5 16h-15zM10 8v4M10 14v.01",check:"M4.5 10.5 8.5 14.5 15.5 6",help:"M7.5 7.5a2.5 2.5 0 1 1 3.6 2.2c-.7.4-1.1.9-1.1 1.8M10 14.5v.01",down:"M5 7.5 10 12.5 15 7.5",panel:"M3 4.5h14v11H3zM12.5 4.5v11",download:"M10 3.5v9M6.5 9.5 10 13l3.5-3.5M4 16h12",upload:"M10 13V4M6.5 7.5 10 4l3.5 3.5M4 16h12",dice:"M4 4h12v12H4zM7.5 7.5v.01M12.5 7.5v.01M10 10v.01M7.5 12.5v.01M12.5 12.5v.01",copy:"M7 7h9v9H7zM13 7V4H4v9h3",fit:"M3 7V3h4M13 3h4v4M17 13v4h-4M7 17H3v-4"};function yi({name:n}){return w("svg",{class:"icon",viewBox:"0 0 20 20","aria-hidden":"true",children:w("path",{d:l0[n]})})}function bt({icon:n,label:e,onClick:t,pressed:i,disabled:s,keys:r,text:o,class:a}){const l=r?`${e} (${r})`:e;return w("button",{type:"button",class:`icon-button ${a??""}`,title:l,"aria-label":e,disabled:s??!1,onClick:t,...i===void 0?{}:{"aria-pressed":i},children:[w(yi,{name:n}),o&&w("span",{children:o})]})}const km=Math.PI/180;function Hl(n,e){return n==="angle"?e.angle==="deg"?"°":"rad":e.length}function uo(n,e,t){if(!Number.isFinite(n))return"–";const[i,s]=e==="angle"?t.angle==="deg"?[n/km,2]:[n,4]:t.length==="mm"?[n*1e3,2]:[n,5],r=i.toFixed(s);return Number(r)===0?0 .toFixed(s):r}function c0(n,e,t){const i=n.trim().replace(",",".");return/^[-+]?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?$/i.test(i)?`${i} ${e==="angle"?t.angle:t.length}`:i}function u0(n,e){return e==="angle"?`${(n/km).toFixed(1)} degrees`:`${(n*1e3).toFixed(1)} millimetres`}function ya(n){return n.kind==="prismatic"?"length":"angle"}function Bm(n){if(n===0)return"0";const e=Math.floor(Math.log10(Math.abs(n)));return`${(n/10**e).toFixed(1)}e${e}`}function or({value:n,kind:e,label:t,onCommit:i,id:s}){const[r,o]=lo(null),a=e==="plain"?n.toFixed(4):uo(n,e,Ct.value),l=()=>{r!==null&&r.trim()!==""&&r!==a&&i(e==="plain"?r.trim():c0(r,e,Ct.value)),o(null)};return w("span",{class:"number",children:[w("input",{id:s,type:"text",inputMode:"text",spellcheck:!1,autocomplete:"off","aria-label":t,value:r??a,onFocus:c=>{o(a),c.currentTarget.select()},onInput:c=>o(c.currentTarget.value),onBlur:l,onKeyDown:c=>{c.key==="Enter"&&(l(),c.currentTarget.blur()),c.key==="Escape"&&(o(null),c.currentTarget.blur()),c.stopPropagation()}}),e!=="plain"&&w("span",{class:"unit","aria-hidden":"true",children:Hl(e,Ct.value)})]})}const Uo=at("rpy"),No=at("base");async function Fo(n){const e=await st({do:"tool",...n});e&&!e.reached&&Kn(e.sentence)}function fa({label:n,value:e,options:t,onChange:i}){return w("div",{class:"segments",role:"radiogroup","aria-label":n,children:t.map(([s,r])=>w("button",{type:"button",role:"radio","aria-checked":s===e,onClick:()=>i(s),children:r},s))})}function h0(){const n=Ji.value;if(!n)return null;const{tool:e,methods:t}=n,i=No.value==="tool",s=i?[0,0,0]:e.position,r=i?[0,0,0]:e.rpy,o=(l,c,u)=>l.map((f,d)=>d===c?u:f),a=n.method==="matrix"?t?.matrix:t?.quaternion;return w("section",{"aria-label":"Tool pose",children:[w("div",{class:"row spread",children:[w("span",{class:"quiet",children:"Frame"}),w(fa,{label:"Frame",value:No.value,options:[["base","Base"],["tool","Tool"]],onChange:l=>{No.value=l,rt.local.value=l==="tool"}})]}),w("div",{class:"triple",children:["X","Y","Z"].map((l,c)=>w("label",{children:[w("span",{children:[w("span",{class:`axis axis-${l.toLowerCase()}`,children:l})," ",w("span",{class:"quiet",children:Hl("length",Ct.value)})]}),w(or,{value:s[c],kind:"length",label:`Tool ${l}`,onCommit:u=>{Fo({position:o(s,c,u),frame:No.value})}})]},l))}),w("div",{class:"row spread",children:[w("span",{class:"quiet",children:"Orientation"}),w(fa,{label:"Orientation as",value:Uo.value,options:[["rpy","RPY"],["quaternion","Quaternion"],["axis","Axis"]],onChange:l=>Uo.value=l})]}),Uo.value==="rpy"&&w("div",{class:"triple",children:["Roll","Pitch","Yaw"].map((l,c)=>w("label",{children:[w("span",{children:[w("span",{class:"axis",children:l})," ",w("span",{class:"quiet",children:Hl("angle",Ct.value)})]}),w(or,{value:r[c],kind:"angle",label:l,onCommit:u=>{Fo({rpy:o(r,c,u),frame:No.value})}})]},l))}),Uo.value==="quaternion"&&w("div",{class:"triple four",children:["w","x","y","z"].map((l,c)=>w("label",{children:[w("span",{class:"axis",children:l}),w(or,{value:e.quaternion[c],kind:"plain",label:`Quaternion ${l}`,onCommit:u=>{Fo({quaternion:e.quaternion.map((f,d)=>d===c?Number(u):f)})}})]},l))}),Uo.value==="axis"&&w("div",{class:"triple four",children:[["x","y","z"].map((l,c)=>w("label",{children:[w("span",{class:"axis",children:l}),w(or,{value:e.axis[c],kind:"plain",label:`Axis ${l}`,onCommit:u=>{Fo({axis_angle:[...o(e.axis,c,u),e.angle]})}})]},l)),w("label",{children:[w("span",{class:"axis",children:"angle"}),w(or,{value:e.angle,kind:"angle",label:"Angle",onCommit:l=>{Fo({axis_angle:[...e.axis,l]})}})]})]}),fs.value?.missed&&w("p",{class:"banner",children:[w(yi,{name:"warn"})," Not reached: ",fs.value.reason??"every solution lies outside the limits",". The arm stands at the nearest pose."]}),w("div",{class:"row spread",children:[w("span",{class:"quiet",children:"Computed by"}),w(fa,{label:"Computed by",value:n.method,options:[["matrix","Matrices"],["quaternion","Quaternions"]],onChange:l=>{st({do:"method",to:l})}})]}),a&&w("table",{class:"matrix","aria-label":"Tool pose as a matrix",children:w("tbody",{children:a.map((l,c)=>w("tr",{children:l.map((u,f)=>w("td",{children:u.toFixed(5)},f))},c))})}),t&&w("p",{class:"quiet small",children:["The two ways differ by ",Bm(t.difference)," at most."]}),n.measures&&w("dl",{class:"facts",children:[w("dt",{children:"Manipulability"}),w("dd",{children:n.measures.manipulability.toPrecision(3)}),w("dt",{children:"Smallest singular value"}),w("dd",{children:[n.measures.smallest_singular_value.toPrecision(3),n.measures.smallest_singular_value<.001&&" – singular"]}),w("dt",{children:"Condition"}),w("dd",{children:n.measures.condition===null?"∞":n.measures.condition.toPrecision(3)})]})]})}const Ac=at("forward");function f0(){const n=Zi(null),[e,t]=lo("");return Ra(()=>{const i=a=>{const l=n.current?.querySelectorAll("output.value");a.forEach((c,u)=>{const f=l?.[u];f&&(f.textContent=c===null?"":`= ${Number(c.toFixed(5))}`)})},s=new co(a=>Ii.send(a),i,()=>{});let r="";return sn(()=>{const[a,l]=[Ac.value,mn.value?.revision];Ji.value;const c=`${a} ${l}`;if(c===r)return s.push({do:"formula_values",scope:a});r=c,Ii.send({do:"formulas",scope:a}).then(u=>{n.current&&(n.current.innerHTML=u.html),t(""),s.push({do:"formula_values",scope:a})},u=>{n.current&&(n.current.textContent=""),t(u.message)})})},[]),w("div",{class:"formulas",children:[w(fa,{label:"Which way",value:Ac.value,onChange:i=>Ac.value=i,options:[["forward","Forward"],["inverse","Inverse"]]}),e&&w("p",{class:"quiet",children:e}),w("div",{class:"sheet-body",ref:n,tabIndex:0,role:"region","aria-label":"Formulas of the arm"})]})}const d0=!0,vn="u-",p0="uplot",m0=vn+"hz",_0=vn+"vt",g0=vn+"title",v0=vn+"wrap",x0=vn+"under",y0=vn+"over",M0=vn+"axis",ar=vn+"off",S0=vn+"select",E0=vn+"cursor-x",b0=vn+"cursor-y",w0=vn+"cursor-pt",T0=vn+"legend",A0=vn+"live",R0=vn+"inline",C0=vn+"series",P0=vn+"marker",ed=vn+"label",D0=vn+"value",ea="width",ta="height",Oo="top",td="bottom",Nr="left",Rc="right",Bh="#000",nd=Bh+"0",Cc="mousemove",id="mousedown",Pc="mouseup",sd="mouseenter",rd="mouseleave",od="dblclick",L0="resize",I0="scroll",ad="change",Vl="dppxchange",zh="--",bo=typeof window<"u",Tu=bo?document:null,no=bo?window:null,U0=bo?navigator:null;let Et,za;function Au(){let n=devicePixelRatio;Et!=n&&(Et=n,za&&Cu(ad,za,Au),za=matchMedia(`(min-resolution: ${Et-.001}dppx) and (max-resolution: ${Et+.001}dppx)`),_r(ad,za,Au),no.dispatchEvent(new CustomEvent(Vl)))}function ri(n,e){if(e!=null){let t=n.classList;!t.contains(e)&&t.add(e)}}function Ru(n,e){let t=n.classList;t.contains(e)&&t.remove(e)}function qt(n,e,t){n.style[e]=t+"px"}function Ri(n,e,t,i){let s=Tu.createElement(n);return e!=null&&ri(s,e),t?.insertBefore(s,i),s}function mi(n,e){return Ri("div",n,e)}const ld=new WeakMap;function zi(n,e,t,i,s){let r="translate("+e+"px,"+t+"px)",o=ld.get(n);r!=o&&(n.style.transform=r,ld.set(n,r),e<0||t<0||e>i||t>s?ri(n,ar):Ru(n,ar))}const cd=new WeakMap;function ud(n,e,t){let i=e+t,s=cd.get(n);i!=s&&(cd.set(n,i),n.style.background=e,n.style.borderColor=t)}const hd=new WeakMap;function fd(n,e,t,i){let s=e+""+t,r=hd.get(n);s!=r&&(hd.set(n,s),n.style.height=t+"px",n.style.width=e+"px",n.style.marginLeft=i?-e/2+"px":0,n.style.marginTop=i?-t/2+"px":0)}const Hh={passive:!0},N0={...Hh,capture:!0};function _r(n,e,t,i){e.addEventListener(n,t,i?N0:Hh)}function Cu(n,e,t,i){e.removeEventListener(n,t,Hh)}bo&&Au();function Ci(n,e,t,i){let s;t=t||0,i=i||e.length-1;let r=i<=2147483647;for(;i-t>1;)s=r?t+i>>1:ai((t+i)/2),e[s]<n?t=s:i=s;return n-e[t]<=e[i]-n?t:i}function zm(n){return(t,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(t[a])){r=a;break}for(let a=s;a>=i;a--)if(n(t[a])){o=a;break}return[r,o]}}const Hm=n=>n!=null,Vm=n=>n!=null&&n>0,tc=zm(Hm),F0=zm(Vm);function O0(n,e,t,i=0,s=!1){let r=s?F0:tc,o=s?Vm:Hm;[e,t]=r(n,e,t);let a=n[e],l=n[e];if(e>-1)if(i==1)a=n[e],l=n[t];else if(i==-1)a=n[t],l=n[e];else for(let c=e;c<=t;c++){let u=n[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??Ot,l??-Ot]}function nc(n,e,t,i){let s=md(n),r=md(e);n==e&&(s==-1?(n*=t,e/=t):(n/=t,e*=t));let o=t==10?cs:Gm,a=s==1?ai:gi,l=r==1?gi:ai,c=a(o(pn(n))),u=l(o(pn(e))),f=ho(t,c),d=ho(t,u);return t==10&&(c<0&&(f=kt(f,-c)),u<0&&(d=kt(d,-u))),i||t==2?(n=f*s,e=d*r):(n=qm(n,f),e=ic(e,d)),[n,e]}function Vh(n,e,t,i){let s=nc(n,e,t,i);return n==0&&(s[0]=0),e==0&&(s[1]=0),s}const Gh=.1,dd={mode:3,pad:Gh},da={pad:0,soft:null,mode:0},k0={min:da,max:da};function Gl(n,e,t,i){return sc(t)?pd(n,e,t):(da.pad=t,da.soft=i?0:null,da.mode=i?3:0,pd(n,e,k0))}function yt(n,e){return n??e}function B0(n,e,t){for(e=yt(e,0),t=yt(t,n.length-1);e<=t;){if(n[e]!=null)return!0;e++}return!1}function pd(n,e,t){let i=t.min,s=t.max,r=yt(i.pad,0),o=yt(s.pad,0),a=yt(i.hard,-Ot),l=yt(s.hard,Ot),c=yt(i.soft,Ot),u=yt(s.soft,-Ot),f=yt(i.mode,0),d=yt(s.mode,0),h=e-n,_=cs(h),x=Xn(pn(n),pn(e)),m=cs(x),p=pn(m-_);(h<1e-24||p>10)&&(h=0,(n==0||e==0)&&(h=1e-24,f==2&&c!=Ot&&(r=0),d==2&&u!=-Ot&&(o=0)));let M=h||x||1e3,b=cs(M),v=ho(10,ai(b)),L=M*(h==0?n==0?.1:1:r),R=kt(qm(n-L,v/10),24),U=n>=c&&(f==1||f==3&&R<=c||f==2&&R>=c)?c:Ot,N=Xn(a,R<U&&n>=U?U:Pi(U,R)),T=M*(h==0?e==0?.1:1:o),E=kt(ic(e+T,v/10),24),C=e<=u&&(d==1||d==3&&E>=u||d==2&&E<=u)?u:-Ot,B=Pi(l,E>C&&e<=C?C:Xn(C,E));return N==B&&N==0&&(B=100),[N,B]}const z0=new Intl.NumberFormat(bo?U0.language:"en-US"),Wh=n=>z0.format(n),ui=Math,wl=ui.PI,pn=ui.abs,ai=ui.floor,dn=ui.round,gi=ui.ceil,Pi=ui.min,Xn=ui.max,ho=ui.pow,md=ui.sign,cs=ui.log10,Gm=ui.log2,H0=(n,e=1)=>ui.sinh(n)*e,Dc=(n,e=1)=>ui.asinh(n/e),Ot=1/0;function _d(n){return(cs((n^n>>31)-(n>>31))|0)+1}function Pu(n,e,t){return Pi(Xn(n,e),t)}function Wm(n){return typeof n=="function"}function pt(n){return Wm(n)?n:()=>n}const V0=()=>{},Xm=n=>n,Ym=(n,e)=>e,G0=n=>null,gd=n=>!0,vd=(n,e)=>n==e,W0=/\.\d*?(?=9{6,}|0{6,})/gm,vr=n=>{if(jm(n)||zs.has(n))return n;const e=`${n}`,t=e.match(W0);if(t==null)return n;let i=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${vr(s)}e${r}`}return kt(n,i)};function nr(n,e){return vr(kt(vr(n/e))*e)}function ic(n,e){return vr(gi(vr(n/e))*e)}function qm(n,e){return vr(ai(vr(n/e))*e)}function kt(n,e=0){if(jm(n))return n;let t=10**e,i=n*t*(1+Number.EPSILON);return dn(i)/t}const zs=new Map;function $m(n){return((""+n).split(".")[1]||"").length}function Ma(n,e,t,i){let s=[],r=i.map($m);for(let o=e;o<t;o++){let a=pn(o),l=kt(ho(n,o),a);for(let c=0;c<i.length;c++){let u=n==10?+`${i[c]}e${o}`:i[c]*l,f=(o>=0?0:a)+(o>=r[c]?0:r[c]),d=n==10?u:kt(u,f);s.push(d),zs.set(d,f)}}return s}const pa={},Xh=[],fo=[null,null],Ds=Array.isArray,jm=Number.isInteger,X0=n=>n===void 0;function xd(n){return typeof n=="string"}function sc(n){let e=!1;if(n!=null){let t=n.constructor;e=t==null||t==Object}return e}function Y0(n){return n!=null&&typeof n=="object"}const q0=Object.getPrototypeOf(Uint8Array),Zm="__proto__";function po(n,e=sc){let t;if(Ds(n)){let i=n.find(s=>s!=null);if(Ds(i)||e(i)){t=Array(n.length);for(let s=0;s<n.length;s++)t[s]=po(n[s],e)}else t=n.slice()}else if(n instanceof q0)t=n.slice();else if(e(n)){t={};for(let i in n)i!=Zm&&(t[i]=po(n[i],e))}else t=n;return t}function cn(n){let e=arguments;for(let t=1;t<e.length;t++){let i=e[t];for(let s in i)s!=Zm&&(sc(n[s])?cn(n[s],po(i[s])):n[s]=po(i[s]))}return n}const $0=0,j0=1,Z0=2;function K0(n,e,t){for(let i=0,s,r=-1;i<e.length;i++){let o=e[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<t&&n[s]==null;)n[r=s++]=null}}}function J0(n,e){if(tv(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return nv(o[0])||(o=ev(o)),o}let t=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let u=0;u<c;u++)t.add(l[u])}let i=[Array.from(t).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],f=Array(s).fill(void 0),d=e?e[o][c]:j0,h=[];for(let _=0;_<u.length;_++){let x=u[_],m=r.get(l[_]);x===null?d!=$0&&(f[m]=x,d==Z0&&h.push(m)):f[m]=x}K0(f,h,s),i.push(f)}}return i}const Q0=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function ev(n){let e=n[0],t=e.length,i=Array(t);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>e[r]-e[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(t);for(let l=0;l<t;l++)a[l]=o[i[l]];s.push(a)}return s}function tv(n){let e=n[0][0],t=e.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function nv(n,e=100){const t=n.length;if(t<=1)return!0;let i=0,s=t-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;const r=Xn(1,ai((s-i+1)/e));for(let o=n[i],a=i+r;a<=s;a+=r){const l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}const Km=["January","February","March","April","May","June","July","August","September","October","November","December"],Jm=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function Qm(n){return n.slice(0,3)}const iv=Jm.map(Qm),sv=Km.map(Qm),rv={MMMM:Km,MMM:sv,WWWW:Jm,WWW:iv};function ko(n){return(n<10?"0":"")+n}function ov(n){return(n<10?"00":n<100?"0":"")+n}const av={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,e)=>e.MMMM[n.getMonth()],MMM:(n,e)=>e.MMM[n.getMonth()],MM:n=>ko(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>ko(n.getDate()),D:n=>n.getDate(),WWWW:(n,e)=>e.WWWW[n.getDay()],WWW:(n,e)=>e.WWW[n.getDay()],HH:n=>ko(n.getHours()),H:n=>n.getHours(),h:n=>{let e=n.getHours();return e==0?12:e>12?e-12:e},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>ko(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>ko(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>ov(n.getMilliseconds())};function Yh(n,e){e=e||rv;let t=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)t.push(s[0][0]=="{"?av[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](r,e);return o}}const lv=new Intl.DateTimeFormat().resolvedOptions().timeZone;function cv(n,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+n+n.getTimezoneOffset()*6e4):e==lv?t=n:(t=new Date(n.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(n.getMilliseconds())),t}const e_=n=>n%1==0,Wl=[1,2,2.5,5],uv=Ma(10,-32,0,Wl),t_=Ma(10,0,32,Wl),hv=t_.filter(e_),ir=uv.concat(t_),qh=`
`,n_="{YYYY}",yd=qh+n_,i_="{M}/{D}",na=qh+i_,Ha=na+"/{YY}",s_="{aa}",fv="{h}:{mm}",Kr=fv+s_,Md=qh+Kr,Sd=":{ss}",wt=null;function r_(n){let e=n*1e3,t=e*60,i=t*60,s=i*24,r=s*30,o=s*365,l=(n==1?Ma(10,0,3,Wl).filter(e_):Ma(10,-3,0,Wl)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]);const c=[[o,n_,wt,wt,wt,wt,wt,wt,1],[s*28,"{MMM}",yd,wt,wt,wt,wt,wt,1],[s,i_,yd,wt,wt,wt,wt,wt,1],[i,"{h}"+s_,Ha,wt,na,wt,wt,wt,1],[t,Kr,Ha,wt,na,wt,wt,wt,1],[e,Sd,Ha+" "+Kr,wt,na+" "+Kr,wt,Md,wt,1],[n,Sd+".{fff}",Ha+" "+Kr,wt,na+" "+Kr,wt,Md,wt,1]];function u(f){return(d,h,_,x,m,p)=>{let M=[],b=m>=o,v=m>=r&&m<o,L=f(_),R=kt(L*n,3),U=Lc(L.getFullYear(),b?0:L.getMonth(),v||b?1:L.getDate()),N=kt(U*n,3);if(v||b){let T=v?m/r:0,E=b?m/o:0,C=R==N?R:kt(Lc(U.getFullYear()+E,U.getMonth()+T,1)*n,3),B=new Date(dn(C/n)),z=B.getFullYear(),X=B.getMonth();for(let W=0;C<=x;W++){let q=Lc(z+E*W,X+T*W,1),j=q-f(kt(q*n,3));C=kt((+q+j)*n,3),C<=x&&M.push(C)}}else{let T=m>=s?s:m,E=ai(_)-ai(R),C=N+E+ic(R-N,T);M.push(C);let B=f(C),z=B.getHours()+B.getMinutes()/t+B.getSeconds()/i,X=m/i,W=d.axes[h]._space,q=p/W;for(;C=kt(C+m,n==1?0:3),!(C>x);)if(X>1){let j=ai(kt(z+X,6))%24,ae=f(C).getHours()-j;ae>1&&(ae=-1),C-=ae*i,z=(z+X)%24;let me=M[M.length-1];kt((C-me)/m,3)*q>=.7&&M.push(C)}else M.push(C)}return M}}return[l,c,u]}const[dv,pv,mv]=r_(1),[_v,gv,vv]=r_(.001);Ma(2,-53,53,[1]);function Ed(n,e){return n.map(t=>t.map((i,s)=>s==0||s==8||i==null?i:e(s==1||t[8]==0?i:t[1]+i)))}function bd(n,e){return(t,i,s,r,o)=>{let a=e.find(_=>o>=_[0])||e[e.length-1],l,c,u,f,d,h;return i.map(_=>{let x=n(_),m=x.getFullYear(),p=x.getMonth(),M=x.getDate(),b=x.getHours(),v=x.getMinutes(),L=x.getSeconds(),R=m!=l&&a[2]||p!=c&&a[3]||M!=u&&a[4]||b!=f&&a[5]||v!=d&&a[6]||L!=h&&a[7]||a[1];return l=m,c=p,u=M,f=b,d=v,h=L,R(x)})}}function xv(n,e){let t=Yh(e);return(i,s,r,o,a)=>s.map(l=>t(n(l)))}function Lc(n,e,t){return new Date(n,e,t)}function wd(n,e){return e(n)}const yv="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function Td(n,e){return(t,i,s,r)=>r==null?zh:e(n(i))}function Mv(n,e){let t=n.series[e];return t.width?t.stroke(n,e):t.points.width?t.points.stroke(n,e):null}function Sv(n,e){return n.series[e].fill(n,e)}const Ev={show:!0,live:!0,isolate:!1,mount:V0,markers:{show:!0,width:2,stroke:Mv,fill:Sv,dash:"solid"},idx:null,idxs:null,values:[]};function bv(n,e){let t=n.cursor.points,i=mi(),s=t.size(n,e);qt(i,ea,s),qt(i,ta,s);let r=s/-2;qt(i,"marginLeft",r),qt(i,"marginTop",r);let o=t.width(n,e,s);return o&&qt(i,"borderWidth",o),i}function wv(n,e){let t=n.series[e].points;return t._fill||t._stroke}function Tv(n,e){let t=n.series[e].points;return t._stroke||t._fill}function Av(n,e){return n.series[e].points.size}const Ic=[0,0];function Rv(n,e,t){return Ic[0]=e,Ic[1]=t,Ic}function Va(n,e,t,i=!0){return s=>{s.button==0&&(!i||s.target==e)&&t(s)}}function Uc(n,e,t,i=!0){return s=>{(!i||s.target==e)&&t(s)}}const Cv={show:!0,x:!0,y:!0,lock:!1,move:Rv,points:{one:!1,show:bv,size:Av,width:0,stroke:Tv,fill:wv},bind:{mousedown:Va,mouseup:Va,click:Va,dblclick:Va,mousemove:Uc,mouseleave:Uc,mouseenter:Uc},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,e,t,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},o_={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},$h=cn({},o_,{filter:Ym}),a_=cn({},$h,{size:10}),l_=cn({},o_,{show:!1}),jh='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',c_="bold "+jh,u_=1.5,Ad={show:!0,scale:"x",stroke:Bh,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:c_,side:2,grid:$h,ticks:a_,border:l_,font:jh,lineGap:u_,rotate:0},Pv="Value",Dv="Time",Rd={show:!0,scale:"x",auto:!1,sorted:1,min:Ot,max:-Ot,idxs:[]};function Lv(n,e,t,i,s){return e.map(r=>r==null?"":Wh(r))}function Iv(n,e,t,i,s,r,o){let a=[],l=zs.get(s)||0;t=o?t:kt(ic(t,s),l);for(let c=t;c<=i;c=kt(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function Du(n,e,t,i,s,r,o){const a=[],l=n.scales[n.axes[e].scale].log,c=l==10?cs:Gm,u=ai(c(t));s=ho(l,u),l==10&&(s=ir[Ci(s,ir)]);let f=t,d=s*l;l==10&&(d=ir[Ci(d,ir)]);do a.push(f),f=f+s,l==10&&!zs.has(f)&&(f=kt(f,zs.get(s))),f>=d&&(s=f,d=s*l,l==10&&(d=ir[Ci(d,ir)]));while(f<=i);return a}function Uv(n,e,t,i,s,r,o){let l=n.scales[n.axes[e].scale].asinh,c=i>l?Du(n,e,Xn(l,t),i,s):[l],u=i>=0&&t<=0?[0]:[];return(t<-l?Du(n,e,Xn(l,-i),-t,s):[l]).reverse().map(d=>-d).concat(u,c)}const h_=/./,Nv=/[12357]/,Fv=/[125]/,Cd=/1/,Lu=(n,e,t,i)=>n.map((s,r)=>e==4&&s==0||r%i==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function Ov(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=n.scales[o],l=n.valToPos,c=r._space,u=l(10,o),f=l(9,o)-u>=c?h_:l(7,o)-u>=c?Nv:l(5,o)-u>=c?Fv:Cd;if(f==Cd){let d=pn(l(1,o)-u);if(d<c)return Lu(e.slice().reverse(),a.distr,f,gi(c/d)).reverse()}return Lu(e,a.distr,f,1)}function kv(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=r._space,l=n.valToPos,c=pn(l(1,o)-l(2,o));return c<a?Lu(e.slice().reverse(),3,h_,gi(a/c)).reverse():e}function Bv(n,e,t,i){return i==null?zh:e==null?"":Wh(e)}const Pd={show:!0,scale:"y",stroke:Bh,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:c_,side:3,grid:$h,ticks:a_,border:l_,font:jh,lineGap:u_,rotate:0};function zv(n,e){let t=3+(n||1)*2;return kt(t*e,3)}function Hv(n,e){let{scale:t,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],t,!0),o=n.valToPos(s[i[1]],t,!0),a=pn(o-r),l=n.series[e],c=a/(l.points.space*Et);return i[1]-i[0]<=c}const Dd={scale:null,auto:!0,sorted:0,min:Ot,max:-Ot},f_=(n,e,t,i,s)=>s,Ld={show:!0,auto:!0,sorted:0,gaps:f_,alpha:1,facets:[cn({},Dd,{scale:"x"}),cn({},Dd,{scale:"y"})]},Id={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:f_,alpha:1,points:{show:Hv,filter:null},values:null,min:Ot,max:-Ot,idxs:[],path:null,clip:null};function Vv(n,e,t,i,s){return t/10}const d_={time:d0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},Gv=cn({},d_,{time:!1,ori:1}),Ud={};function p_(n,e){let t=Ud[n];return t||(t={key:n,plots:[],sub(i){t.plots.push(i)},unsub(i){t.plots=t.plots.filter(s=>s!=i)},pub(i,s,r,o,a,l,c){for(let u=0;u<t.plots.length;u++)t.plots[u]!=s&&t.plots[u].pub(i,s,r,o,a,l,c)}},n!=null&&(Ud[n]=t)),t}const mo=1,Iu=2;function Sr(n,e,t){const i=n.mode,s=n.series[e],r=i==2?n._data[e]:n._data,o=n.scales,a=n.bbox;let l=r[0],c=i==2?r[1]:r[e],u=i==2?o[s.facets[0].scale]:o[n.series[0].scale],f=i==2?o[s.facets[1].scale]:o[s.scale],d=a.left,h=a.top,_=a.width,x=a.height,m=n.valToPosH,p=n.valToPosV;return u.ori==0?t(s,l,c,u,f,m,p,d,h,_,x,oc,wo,lc,__,v_):t(s,l,c,u,f,p,m,h,d,x,_,ac,To,Jh,g_,x_)}function Zh(n,e){let t=0,i=0,s=yt(n.bands,Xh);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?i|=1:i|=2)}return[t,i==1?-1:i==2?1:i==3?2:0]}function Wv(n,e,t,i,s){let r=n.mode,o=n.series[e],a=r==2?o.facets[1].scale:o.scale,l=n.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function us(n,e,t,i,s,r){return Sr(n,e,(o,a,l,c,u,f,d,h,_,x,m)=>{let p=o.pxRound;const M=c.dir*(c.ori==0?1:-1),b=c.ori==0?wo:To;let v,L;M==1?(v=t,L=i):(v=i,L=t);let R=p(f(a[v],c,x,h)),U=p(d(l[v],u,m,_)),N=p(f(a[L],c,x,h)),T=p(d(r==1?u.max:u.min,u,m,_)),E=new Path2D(s);return b(E,N,T),b(E,R,T),b(E,R,U),E})}function rc(n,e,t,i,s,r){let o=null;if(n.length>0){o=new Path2D;const a=e==0?lc:Jh;let l=t;for(let f=0;f<n.length;f++){let d=n[f];if(d[1]>d[0]){let h=d[0]-l;h>0&&a(o,l,i,h,i+r),l=d[1]}}let c=t+s-l,u=10;c>0&&a(o,l,i-u/2,c,i+r+u)}return o}function Xv(n,e,t){let i=n[n.length-1];i&&i[0]==e?i[1]=t:n.push([e,t])}function Kh(n,e,t,i,s,r,o){let a=[],l=n.length;for(let c=s==1?t:i;c>=t&&c<=i;c+=s)if(e[c]===null){let f=c,d=c;if(s==1)for(;++c<=i&&e[c]===null;)d=c;else for(;--c>=t&&e[c]===null;)d=c;let h=r(n[f]),_=d==f?h:r(n[d]),x=f-s;h=o<=0&&x>=0&&x<l?r(n[x]):h;let p=d+s;_=o>=0&&p>=0&&p<l?r(n[p]):_,_>=h&&a.push([h,_])}return a}function Nd(n){return n==0?Xm:n==1?dn:e=>nr(e,n)}function m_(n){let e=n==0?oc:ac,t=n==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},i=n==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,u=0)=>{c==0&&u==0?i(s,r,o,a,l):(c=Pi(c,a/2,l/2),u=Pi(u,a/2,l/2),e(s,r+c,o),t(s,r+a,o,r+a,o+l,c),t(s,r+a,o+l,r,o+l,u),t(s,r,o+l,r,o,u),t(s,r,o,r+a,o,c),s.closePath())}}const oc=(n,e,t)=>{n.moveTo(e,t)},ac=(n,e,t)=>{n.moveTo(t,e)},wo=(n,e,t)=>{n.lineTo(e,t)},To=(n,e,t)=>{n.lineTo(t,e)},lc=m_(0),Jh=m_(1),__=(n,e,t,i,s,r)=>{n.arc(e,t,i,s,r)},g_=(n,e,t,i,s,r)=>{n.arc(t,e,i,s,r)},v_=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(e,t,i,s,r,o)},x_=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(t,e,s,i,o,r)};function y_(n){return(e,t,i,s,r)=>Sr(e,t,(o,a,l,c,u,f,d,h,_,x,m)=>{let{pxRound:p,points:M}=o,b,v;c.ori==0?(b=oc,v=__):(b=ac,v=g_);const L=kt(M.width*Et,3);let R=(M.size-M.width)/2*Et,U=kt(R*2,3),N=new Path2D,T=new Path2D,{left:E,top:C,width:B,height:z}=e.bbox;lc(T,E-U,C-U,B+U*2,z+U*2);const X=W=>{if(l[W]!=null){let q=p(f(a[W],c,x,h)),j=p(d(l[W],u,m,_));b(N,q+R,j),v(N,q,j,R,0,wl*2)}};if(r)r.forEach(X);else for(let W=i;W<=s;W++)X(W);return{stroke:L>0?N:null,fill:N,clip:T,flags:mo|Iu}})}function M_(n){return(e,t,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(e,t,i),r!=s&&o!=s&&n(e,t,s),n(e,t,o))}}const Yv=M_(wo),qv=M_(To);function S_(n){const e=yt(n?.alignGaps,0);return(t,i,s,r)=>Sr(t,i,(o,a,l,c,u,f,d,h,_,x,m)=>{[s,r]=tc(l,s,r);let p=o.pxRound,M=z=>p(f(z,c,x,h)),b=z=>p(d(z,u,m,_)),v,L;c.ori==0?(v=wo,L=Yv):(v=To,L=qv);const R=c.dir*(c.ori==0?1:-1),U={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:mo},N=U.stroke;let T=!1;if(r-s>=x*4){let z=ge=>t.posToVal(ge,c.key,!0),X=null,W=null,q,j,K,re=M(a[R==1?s:r]),ae=M(a[s]),me=M(a[r]),xe=z(R==1?ae+1:me-1);for(let ge=R==1?s:r;ge>=s&&ge<=r;ge+=R){let Qe=a[ge],ee=(R==1?Qe<xe:Qe>xe)?re:M(Qe),ne=l[ge];ee==re?ne!=null?(j=ne,X==null?(v(N,ee,b(j)),q=X=W=j):j<X?X=j:j>W&&(W=j)):ne===null&&(T=!0):(X!=null&&L(N,re,b(X),b(W),b(q),b(j)),ne!=null?(j=ne,v(N,ee,b(j)),X=W=q=j):(X=W=null,ne===null&&(T=!0)),re=ee,xe=z(re+R))}X!=null&&X!=W&&K!=re&&L(N,re,b(X),b(W),b(q),b(j))}else for(let z=R==1?s:r;z>=s&&z<=r;z+=R){let X=l[z];X===null?T=!0:X!=null&&v(N,M(a[z]),b(X))}let[C,B]=Zh(t,i);if(o.fill!=null||C!=0){let z=U.fill=new Path2D(N),X=o.fillTo(t,i,o.min,o.max,C),W=b(X),q=M(a[s]),j=M(a[r]);R==-1&&([j,q]=[q,j]),v(z,j,W),v(z,q,W)}if(!o.spanGaps){let z=[];T&&z.push(...Kh(a,l,s,r,R,M,e)),U.gaps=z=o.gaps(t,i,s,r,z),U.clip=rc(z,c.ori,h,_,x,m)}return B!=0&&(U.band=B==2?[us(t,i,s,r,N,-1),us(t,i,s,r,N,1)]:us(t,i,s,r,N,B)),U})}function $v(n){const e=yt(n.align,1),t=yt(n.ascDesc,!1),i=yt(n.alignGaps,0),s=yt(n.extend,!1);return(r,o,a,l)=>Sr(r,o,(c,u,f,d,h,_,x,m,p,M,b)=>{[a,l]=tc(f,a,l);let v=c.pxRound,{left:L,width:R}=r.bbox,U=ae=>v(_(ae,d,M,m)),N=ae=>v(x(ae,h,b,p)),T=d.ori==0?wo:To;const E={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:mo},C=E.stroke,B=d.dir*(d.ori==0?1:-1);let z=N(f[B==1?a:l]),X=U(u[B==1?a:l]),W=X,q=X;s&&e==-1&&(q=L,T(C,q,z)),T(C,X,z);for(let ae=B==1?a:l;ae>=a&&ae<=l;ae+=B){let me=f[ae];if(me==null)continue;let xe=U(u[ae]),ge=N(me);e==1?T(C,xe,z):T(C,W,ge),T(C,xe,ge),z=ge,W=xe}let j=W;s&&e==1&&(j=L+R,T(C,j,z));let[K,re]=Zh(r,o);if(c.fill!=null||K!=0){let ae=E.fill=new Path2D(C),me=c.fillTo(r,o,c.min,c.max,K),xe=N(me);T(ae,j,xe),T(ae,q,xe)}if(!c.spanGaps){let ae=[];ae.push(...Kh(u,f,a,l,B,U,i));let me=c.width*Et/2,xe=t||e==1?me:-me,ge=t||e==-1?-me:me;ae.forEach(Qe=>{Qe[0]+=xe,Qe[1]+=ge}),E.gaps=ae=c.gaps(r,o,a,l,ae),E.clip=rc(ae,d.ori,m,p,M,b)}return re!=0&&(E.band=re==2?[us(r,o,a,l,C,-1),us(r,o,a,l,C,1)]:us(r,o,a,l,C,re)),E})}function Fd(n,e,t,i,s,r,o=Ot){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(e[l]!==void 0){if(a!=null){let u=pn(n[l]-n[a]);u<c&&(c=u,o=pn(t(n[l],i,s,r)-t(n[a],i,s,r)))}a=l}}return o}function jv(n){n=n||pa;const e=yt(n.size,[.6,Ot,1]),t=n.align||0,i=n.gap||0;let s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;const r=pt(s),o=1-e[0],a=yt(e[1],Ot),l=yt(e[2],1),c=yt(n.disp,pa),u=yt(n.each,h=>{}),{fill:f,stroke:d}=c;return(h,_,x,m)=>Sr(h,_,(p,M,b,v,L,R,U,N,T,E,C)=>{let B=p.pxRound,z=t,X=i*Et,W=a*Et,q=l*Et,j,K;v.ori==0?[j,K]=r(h,_):[K,j]=r(h,_);const re=v.dir*(v.ori==0?1:-1);let ae=v.ori==0?lc:Jh,me=v.ori==0?u:(O,J,ie,te,Fe,he,Le)=>{u(O,J,ie,Fe,te,Le,he)},xe=yt(h.bands,Xh).find(O=>O.series[0]==_),ge=xe!=null?xe.dir:0,Qe=p.fillTo(h,_,p.min,p.max,ge),et=B(U(Qe,L,C,T)),ee,ne,we,ze=E,ye=B(p.width*Et),tt=!1,Bt=null,F=null,mt=null,$e=null;f!=null&&(ye==0||d!=null)&&(tt=!0,Bt=f.values(h,_,x,m),F=new Map,new Set(Bt).forEach(O=>{O!=null&&F.set(O,new Path2D)}),ye>0&&(mt=d.values(h,_,x,m),$e=new Map,new Set(mt).forEach(O=>{O!=null&&$e.set(O,new Path2D)})));let{x0:We,size:Ne}=c;if(We!=null&&Ne!=null){z=1,M=We.values(h,_,x,m),We.unit==2&&(M=M.map(ie=>h.posToVal(N+ie*E,v.key,!0)));let O=Ne.values(h,_,x,m);Ne.unit==2?ne=O[0]*E:ne=R(O[0],v,E,N)-R(0,v,E,N),ze=Fd(M,b,R,v,E,N,ze),we=ze-ne+X}else ze=Fd(M,b,R,v,E,N,ze),we=ze*o+X,ne=ze-we;we<1&&(we=0),ye>=ne/2&&(ye=0),we<5&&(B=Xm);let At=we>0,Pe=ze-we-(At?ye:0);ne=B(Pu(Pe,q,W)),ee=(z==0?ne/2:z==re?0:ne)-z*re*((z==0?X/2:0)+(At?ye/2:0));const Ge={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},Gt=tt?null:new Path2D;let Mt=null;if(xe!=null)Mt=h.data[xe.series[1]];else{let{y0:O,y1:J}=c;O!=null&&J!=null&&(b=J.values(h,_,x,m),Mt=O.values(h,_,x,m))}let D=j*ne,y=K*ne;for(let O=re==1?x:m;O>=x&&O<=m;O+=re){let J=b[O];if(J==null)continue;if(Mt!=null){let ve=Mt[O]??0;if(J-ve==0)continue;et=U(ve,L,C,T)}let ie=v.distr!=2||c!=null?M[O]:O,te=R(ie,v,E,N),Fe=U(yt(J,Qe),L,C,T),he=B(te-ee),Le=B(Xn(Fe,et)),Re=B(Pi(Fe,et)),le=Le-Re;if(J!=null){let ve=J<0?y:D,Be=J<0?D:y;tt?(ye>0&&mt[O]!=null&&ae($e.get(mt[O]),he,Re+ai(ye/2),ne,Xn(0,le-ye),ve,Be),Bt[O]!=null&&ae(F.get(Bt[O]),he,Re+ai(ye/2),ne,Xn(0,le-ye),ve,Be)):ae(Gt,he,Re+ai(ye/2),ne,Xn(0,le-ye),ve,Be),me(h,_,O,he-ye/2,Re,ne+ye,le)}}return ye>0?Ge.stroke=tt?$e:Gt:tt||(Ge._fill=p.width==0?p._fill:p._stroke??p._fill,Ge.width=0),Ge.fill=tt?F:Gt,Ge})}function Zv(n,e){const t=yt(e?.alignGaps,0);return(i,s,r,o)=>Sr(i,s,(a,l,c,u,f,d,h,_,x,m,p)=>{[r,o]=tc(c,r,o);let M=a.pxRound,b=j=>M(d(j,u,m,_)),v=j=>M(h(j,f,p,x)),L,R,U;u.ori==0?(L=oc,U=wo,R=v_):(L=ac,U=To,R=x_);const N=u.dir*(u.ori==0?1:-1);let T=b(l[N==1?r:o]),E=T,C=[],B=[];for(let j=N==1?r:o;j>=r&&j<=o;j+=N)if(c[j]!=null){let re=l[j],ae=b(re);C.push(E=ae),B.push(v(c[j]))}const z={stroke:n(C,B,L,U,R,M),fill:null,clip:null,band:null,gaps:null,flags:mo},X=z.stroke;let[W,q]=Zh(i,s);if(a.fill!=null||W!=0){let j=z.fill=new Path2D(X),K=a.fillTo(i,s,a.min,a.max,W),re=v(K);U(j,E,re),U(j,T,re)}if(!a.spanGaps){let j=[];j.push(...Kh(l,c,r,o,N,b,t)),z.gaps=j=a.gaps(i,s,r,o,j),z.clip=rc(j,u.ori,_,x,m,p)}return q!=0&&(z.band=q==2?[us(i,s,r,o,X,-1),us(i,s,r,o,X,1)]:us(i,s,r,o,X,q)),z})}function Kv(n){return Zv(Jv,n)}function Jv(n,e,t,i,s,r){const o=n.length;if(o<2)return null;const a=new Path2D;if(t(a,n[0],e[0]),o==2)i(a,n[1],e[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),f=Array(o-1);for(let d=0;d<o-1;d++)u[d]=e[d+1]-e[d],f[d]=n[d+1]-n[d],c[d]=u[d]/f[d];l[0]=c[0];for(let d=1;d<o-1;d++)c[d]===0||c[d-1]===0||c[d-1]>0!=c[d]>0?l[d]=0:(l[d]=3*(f[d-1]+f[d])/((2*f[d]+f[d-1])/c[d-1]+(f[d]+2*f[d-1])/c[d]),isFinite(l[d])||(l[d]=0));l[o-1]=c[o-2];for(let d=0;d<o-1;d++)s(a,n[d]+f[d]/3,e[d]+l[d]*f[d]/3,n[d+1]-f[d]/3,e[d+1]-l[d+1]*f[d]/3,n[d+1],e[d+1])}return a}const Uu=new Set;function Od(){for(let n of Uu)n.syncRect(!0)}bo&&(_r(L0,no,Od),_r(I0,no,Od,!0),_r(Vl,no,()=>{On.pxRatio=Et}));const Qv=S_(),ex=y_();function kd(n,e,t,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>Nu(r,o,e,t))}function tx(n,e){return n.map((t,i)=>i==0?{}:cn({},e,t))}function Nu(n,e,t,i){return cn({},e==0?t:i,n)}function E_(n,e,t){return e==null?fo:[e,t]}const nx=E_;function ix(n,e,t){return e==null?fo:Gl(e,t,Gh,!0)}function b_(n,e,t,i){return e==null?fo:nc(e,t,n.scales[i].log,!1)}const sx=b_;function w_(n,e,t,i){return e==null?fo:Vh(e,t,n.scales[i].log,!1)}const rx=w_;function ox(n,e,t,i,s){let r=Xn(_d(n),_d(e)),o=e-n,a=Ci(s/i*o,t);do{let l=t[a],c=i*l/o;if(c>=s&&r+(l<5?zs.get(l):0)<=17)return[l,c]}while(++a<t.length);return[0,0]}function Bd(n){let e,t;return n=n.replace(/(\d+)px/,(i,s)=>(e=dn((t=+s)*Et))+"px"),[n,e,t]}function ax(n){n.show&&[n.font,n.labelFont].forEach(e=>{let t=kt(e[2]*Et,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function On(n,e,t){const i={mode:yt(n.mode,1)},s=i.mode;function r(g,S,P,I){let V=S.valToPct(g);return I+P*(S.dir==-1?1-V:V)}function o(g,S,P,I){let V=S.valToPct(g);return I+P*(S.dir==-1?V:1-V)}function a(g,S,P,I){return S.ori==0?r(g,S,P,I):o(g,S,P,I)}i.valToPosH=r,i.valToPosV=o;let l=!1;i.status=0;const c=i.root=mi(p0);if(n.id!=null&&(c.id=n.id),ri(c,n.class),n.title){let g=mi(g0,c);g.textContent=n.title}const u=Ri("canvas"),f=i.ctx=u.getContext("2d"),d=mi(v0,c);_r("click",d,g=>{g.target===_&&(Wt!=Cr||jt!=Pr)&&An.click(i,g)},!0);const h=i.under=mi(x0,d);d.appendChild(u);const _=i.over=mi(y0,d);n=po(n);const x=+yt(n.pxAlign,1),m=Nd(x);(n.plugins||[]).forEach(g=>{g.opts&&(n=g.opts(i,n)||n)});const p=n.ms||.001,M=i.series=s==1?kd(n.series||[],Rd,Id,!1):tx(n.series||[null],Ld),b=i.axes=kd(n.axes||[],Ad,Pd,!0),v=i.scales={},L=i.bands=n.bands||[];L.forEach(g=>{g.fill=pt(g.fill||null),g.dir=yt(g.dir,-1)});const R=s==2?M[1].facets[0].scale:M[0].scale,U={axes:fg,series:Xs},N=(n.drawOrder||["axes","series"]).map(g=>U[g]);function T(g){const S=g.distr==3?P=>cs(P>0?P:g.clamp(i,P,g.min,g.max,g.key)):g.distr==4?P=>Dc(P,g.asinh):g.distr==100?P=>g.fwd(P):P=>P;return P=>{let I=S(P),{_min:V,_max:$}=g,se=$-V;return(I-V)/se}}function E(g){let S=v[g];if(S==null){let P=(n.scales||pa)[g]||pa;if(P.from!=null){E(P.from);let I=cn({},v[P.from],P,{key:g});I.valToPct=T(I),v[g]=I}else{S=v[g]=cn({},g==R?d_:Gv,P),S.key=g;let I=S.time,V=S.range,$=Ds(V);if((g!=R||s==2&&!I)&&($&&(V[0]==null||V[1]==null)&&(V={min:V[0]==null?dd:{mode:1,hard:V[0],soft:V[0]},max:V[1]==null?dd:{mode:1,hard:V[1],soft:V[1]}},$=!1),!$&&sc(V))){let se=V;V=(ce,_e,Ae)=>_e==null?fo:Gl(_e,Ae,se)}S.range=pt(V||(I?nx:g==R?S.distr==3?sx:S.distr==4?rx:E_:S.distr==3?b_:S.distr==4?w_:ix)),S.auto=pt($?!1:S.auto),S.clamp=pt(S.clamp||Vv),S._min=S._max=null,S.valToPct=T(S)}}}E("x"),E("y"),s==1&&M.forEach(g=>{E(g.scale)}),b.forEach(g=>{E(g.scale)});for(let g in n.scales)E(g);const C=v[R],B=C.distr;let z,X;C.ori==0?(ri(c,m0),z=r,X=o):(ri(c,_0),z=o,X=r);const W={};for(let g in v){let S=v[g];(S.min!=null||S.max!=null)&&(W[g]={min:S.min,max:S.max},S.min=S.max=null)}const q=n.tzDate||(g=>new Date(dn(g/p))),j=n.fmtDate||Yh,K=p==1?mv(q):vv(q),re=bd(q,Ed(p==1?pv:gv,j)),ae=Td(q,wd(yv,j)),me=[],xe=i.legend=cn({},Ev,n.legend),ge=i.cursor=cn({},Cv,{drag:{y:s==2}},n.cursor),Qe=xe.show,et=ge.show,ee=xe.markers;xe.idxs=me,ee.width=pt(ee.width),ee.dash=pt(ee.dash),ee.stroke=pt(ee.stroke),ee.fill=pt(ee.fill);let ne,we,ze,ye=[],tt=[],Bt,F=!1,mt={};if(xe.live){const g=M[1]?M[1].values:null;F=g!=null,Bt=F?g(i,1,0):{_:0};for(let S in Bt)mt[S]=zh}if(Qe)if(ne=Ri("table",T0,c),ze=Ri("tbody",null,ne),xe.mount(i,ne),F){we=Ri("thead",null,ne,ze);let g=Ri("tr",null,we);Ri("th",null,g);for(var $e in Bt)Ri("th",ed,g).textContent=$e}else ri(ne,R0),xe.live&&ri(ne,A0);const We={show:!0},Ne={show:!1};function At(g,S){if(S==0&&(F||!xe.live||s==2))return fo;let P=[],I=Ri("tr",C0,ze,ze.childNodes[S]);ri(I,g.class),g.show||ri(I,ar);let V=Ri("th",null,I);if(ee.show){let ce=mi(P0,V);if(S>0){let _e=ee.width(i,S);_e&&(ce.style.border=_e+"px "+ee.dash(i,S)+" "+ee.stroke(i,S)),ce.style.background=ee.fill(i,S)}}let $=mi(ed,V);g.label instanceof HTMLElement?$.appendChild(g.label):$.textContent=g.label,S>0&&(ee.show||($.style.color=g.width>0?ee.stroke(i,S):ee.fill(i,S)),Ge("click",V,ce=>{if(ge._lock)return;Tn(ce);let _e=M.indexOf(g);if((ce.ctrlKey||ce.metaKey)!=xe.isolate){let Ae=M.some((Ce,Ue)=>Ue>0&&Ue!=_e&&Ce.show);M.forEach((Ce,Ue)=>{Ue>0&&Fi(Ue,Ae?Ue==_e?We:Ne:We,!0,on.setSeries)})}else Fi(_e,{show:!g.show},!0,on.setSeries)},!1),qn&&Ge(sd,V,ce=>{ge._lock||(Tn(ce),Fi(M.indexOf(g),Lr,!0,on.setSeries))},!1));for(var se in Bt){let ce=Ri("td",D0,I);ce.textContent="--",P.push(ce)}return[I,P]}const Pe=new Map;function Ge(g,S,P,I=!0){const V=Pe.get(S)||{},$=ge.bind[g](i,S,P,I);$&&(_r(g,S,V[g]=$),Pe.set(S,V))}function Gt(g,S,P){const I=Pe.get(S)||{};for(let V in I)(g==null||V==g)&&(Cu(V,S,I[V]),delete I[V]);g==null&&Pe.delete(S)}let Mt=0,D=0,y=0,O=0,J=0,ie=0,te=J,Fe=ie,he=y,Le=O,Re=0,le=0,ve=0,Be=0;i.bbox={};let ke=!1,Me=!1,Ze=!1,H=!1,fe=!1,pe=!1;function De(g,S,P){(P||g!=i.width||S!=i.height)&&ue(g,S),wr(!1),Ze=!0,Me=!0,Tr()}function ue(g,S){i.width=Mt=y=g,i.height=D=O=S,J=ie=0,Dt(),_t();let P=i.bbox;Re=P.left=nr(J*Et,.5),le=P.top=nr(ie*Et,.5),ve=P.width=nr(y*Et,.5),Be=P.height=nr(O*Et,.5)}const oe=3;function Oe(){let g=!1,S=0;for(;!g;){S++;let P=ug(S),I=hg(S);g=S==oe||P&&I,g||(ue(i.width,i.height),Me=!0)}}function nt({width:g,height:S}){De(g,S)}i.setSize=nt;function Dt(){let g=!1,S=!1,P=!1,I=!1;b.forEach((V,$)=>{if(V.show&&V._show){let{side:se,_size:ce}=V,_e=se%2,Ae=V.label!=null?V.labelSize:0,Ce=ce+Ae;Ce>0&&(_e?(y-=Ce,se==3?(J+=Ce,I=!0):P=!0):(O-=Ce,se==0?(ie+=Ce,g=!0):S=!0))}}),es[0]=g,es[1]=P,es[2]=S,es[3]=I,y-=Ni[1]+Ni[3],J+=Ni[3],O-=Ni[2]+Ni[0],ie+=Ni[0]}function _t(){let g=J+y,S=ie+O,P=J,I=ie;function V($,se){switch($){case 1:return g+=se,g-se;case 2:return S+=se,S-se;case 3:return P-=se,P+se;case 0:return I-=se,I+se}}b.forEach(($,se)=>{if($.show&&$._show){let ce=$.side;$._pos=V(ce,$._size),$.label!=null&&($._lpos=V(ce,$.labelSize))}})}if(ge.dataIdx==null){let g=ge.hover,S=g.skip=new Set(g.skip??[]);S.add(void 0);let P=g.prox=pt(g.prox),I=g.bias??=0;ge.dataIdx=(V,$,se,ce)=>{if($==0)return se;let _e=se,Ae=P(V,$,se,ce)??Ot,Ce=Ae>=0&&Ae<Ot,Ue=C.ori==0?y:O,it=ge.left,St=e[0],vt=e[$];if(S.has(vt[se])){_e=null;let ht=null,je=null,Ve;if(I==0||I==-1)for(Ve=se;ht==null&&Ve-- >0;)S.has(vt[Ve])||(ht=Ve);if(I==0||I==1)for(Ve=se;je==null&&Ve++<vt.length;)S.has(vt[Ve])||(je=Ve);if(ht!=null||je!=null)if(Ce){let Yt=ht==null?-1/0:z(St[ht],C,Ue,0),Jt=je==null?1/0:z(St[je],C,Ue,0),bn=it-Yt,Lt=Jt-it;bn<=Lt?bn<=Ae&&(_e=ht):Lt<=Ae&&(_e=je)}else _e=je==null?ht:ht==null?je:se-ht<=je-se?ht:je}else Ce&&pn(it-z(St[se],C,Ue,0))>Ae&&(_e=null);return _e}}const Tn=g=>{ge.event=g};ge.idxs=me,ge._lock=!1;let Nt=ge.points;Nt.show=pt(Nt.show),Nt.size=pt(Nt.size),Nt.stroke=pt(Nt.stroke),Nt.width=pt(Nt.width),Nt.fill=pt(Nt.fill);const Qn=i.focus=cn({},n.focus||{alpha:.3},ge.focus),qn=Qn.prox>=0,Ui=qn&&Nt.one;let kn=[],Qi=[],Si=[];function Ro(g,S){let P=Nt.show(i,S);if(P instanceof HTMLElement)return ri(P,w0),ri(P,g.class),zi(P,-10,-10,y,O),_.insertBefore(P,kn[S]),P}function Gs(g,S){if(s==1||S>0){let P=s==1&&v[g.scale].time,I=g.value;g.value=P?xd(I)?Td(q,wd(I,j)):I||ae:I||Bv,g.label=g.label||(P?Dv:Pv)}if(Ui||S>0){g.width=g.width==null?1:g.width,g.paths=g.paths||Qv||G0,g.fillTo=pt(g.fillTo||Wv),g.pxAlign=+yt(g.pxAlign,x),g.pxRound=Nd(g.pxAlign),g.stroke=pt(g.stroke||null),g.fill=pt(g.fill||null),g._stroke=g._fill=g._paths=g._focus=null;let P=zv(Xn(1,g.width),1),I=g.points=cn({},{size:P,width:Xn(1,P*.2),stroke:g.stroke,space:P*2,paths:ex,_stroke:null,_fill:null},g.points);I.show=pt(I.show),I.filter=pt(I.filter),I.fill=pt(I.fill),I.stroke=pt(I.stroke),I.paths=pt(I.paths),I.pxAlign=g.pxAlign}if(Qe){let P=At(g,S);ye.splice(S,0,P[0]),tt.splice(S,0,P[1]),xe.values.push(null)}if(et){me.splice(S,0,null);let P=null;Ui?S==0&&(P=Ro(g,S)):S>0&&(P=Ro(g,S)),kn.splice(S,0,P),Qi.splice(S,0,0),Si.splice(S,0,0)}En("addSeries",S)}function La(g,S){S=S??M.length,g=s==1?Nu(g,S,Rd,Id):Nu(g,S,{},Ld),M.splice(S,0,g),Gs(M[S],S)}i.addSeries=La;function Ia(g){if(M.splice(g,1),Qe){xe.values.splice(g,1),tt.splice(g,1);let S=ye.splice(g,1)[0];Gt(null,S.firstChild),S.remove()}et&&(me.splice(g,1),kn.splice(g,1)[0].remove(),Qi.splice(g,1),Si.splice(g,1)),En("delSeries",g)}i.delSeries=Ia;const es=[!1,!1,!1,!1];function dc(g,S){if(g._show=g.show,g.show){let P=g.side%2,I=v[g.scale];I==null&&(g.scale=P?M[1].scale:R,I=v[g.scale]);let V=I.time;g.size=pt(g.size),g.space=pt(g.space),g.rotate=pt(g.rotate),Ds(g.incrs)&&g.incrs.forEach(se=>{!zs.has(se)&&zs.set(se,$m(se))}),g.incrs=pt(g.incrs||(I.distr==2?hv:V?p==1?dv:_v:ir)),g.splits=pt(g.splits||(V&&I.distr==1?K:I.distr==3?Du:I.distr==4?Uv:Iv)),g.stroke=pt(g.stroke),g.grid.stroke=pt(g.grid.stroke),g.ticks.stroke=pt(g.ticks.stroke),g.border.stroke=pt(g.border.stroke);let $=g.values;g.values=Ds($)&&!Ds($[0])?pt($):V?Ds($)?bd(q,Ed($,j)):xd($)?xv(q,$):$||re:$||Lv,g.filter=pt(g.filter||(I.distr>=3&&I.log==10?Ov:I.distr==3&&I.log==2?kv:Ym)),g.font=Bd(g.font),g.labelFont=Bd(g.labelFont),g._size=g.size(i,null,S,0),g._space=g._rotate=g._incrs=g._found=g._splits=g._values=null,g._size>0&&(es[S]=!0,g._el=mi(M0,d))}}function Ws(g,S,P,I){let[V,$,se,ce]=P,_e=S%2,Ae=0;return _e==0&&(ce||$)&&(Ae=S==0&&!V||S==2&&!se?dn(Ad.size/3):0),_e==1&&(V||se)&&(Ae=S==1&&!$||S==3&&!ce?dn(Pd.size/2):0),Ae}const Ua=i.padding=(n.padding||[Ws,Ws,Ws,Ws]).map(g=>pt(yt(g,Ws))),Ni=i._padding=Ua.map((g,S)=>g(i,S,es,0));let hn,A=null,G=null;const Q=s==1?M[0].idxs:null;let Z=null,Y=!1;function de(g,S){if(e=g??[],i.data=i._data=e,s==2){hn=0;for(let P=1;P<M.length;P++)hn+=e[P][0].length}else{e.length==0&&(i.data=i._data=e=[[]]),Z=e[0],hn=Z.length;let P=e;if(B==2){P=e.slice();let I=P[0]=Array(hn);for(let V=0;V<hn;V++)I[V]=V}i._data=e=P}if(wr(!0),En("setData"),B==2&&(Ze=!0),S!==!1){let P=C;P.auto(i,Y)?Se():vs(R,P.min,P.max),H=H||ge.left>=0,pe=!0,Tr()}}i.setData=de;function Se(){Y=!0;let g,S;s==1&&(hn>0?(A=Q[0]=0,G=Q[1]=hn-1,g=e[0][A],S=e[0][G],B==2?(g=A,S=G):g==S&&(B==3?[g,S]=nc(g,g,C.log,!1):B==4?[g,S]=Vh(g,g,C.log,!1):C.time?S=g+dn(86400/p):[g,S]=Gl(g,S,Gh,!0))):(A=Q[0]=g=null,G=Q[1]=S=null)),vs(R,g,S)}let Ie,Te,Ye,qe,He,ct,gt,zt,Rt,ot;function Xe(g,S,P,I,V,$){g??=nd,P??=Xh,I??="butt",V??=nd,$??="round",g!=Ie&&(f.strokeStyle=Ie=g),V!=Te&&(f.fillStyle=Te=V),S!=Ye&&(f.lineWidth=Ye=S),$!=He&&(f.lineJoin=He=$),I!=ct&&(f.lineCap=ct=I),P!=qe&&f.setLineDash(qe=P)}function Ht(g,S,P,I){S!=Te&&(f.fillStyle=Te=S),g!=gt&&(f.font=gt=g),P!=zt&&(f.textAlign=zt=P),I!=Rt&&(f.textBaseline=Rt=I)}function dt(g,S,P,I,V=0){if(I.length>0&&g.auto(i,Y)&&(S==null||S.min==null)){let $=yt(A,0),se=yt(G,I.length-1),ce=P.min==null?O0(I,$,se,V,g.distr==3):[P.min,P.max];g.min=Pi(g.min,P.min=ce[0]),g.max=Xn(g.max,P.max=ce[1])}}const Ln={min:null,max:null};function ms(){for(let I in v){let V=v[I];W[I]==null&&(V.min==null||W[R]!=null&&V.auto(i,Y))&&(W[I]=Ln)}for(let I in v){let V=v[I];W[I]==null&&V.from!=null&&W[V.from]!=null&&(W[I]=Ln)}W[R]!=null&&wr(!0);let g={};for(let I in W){let V=W[I];if(V!=null){let $=g[I]=po(v[I],Y0);if(V.min!=null)cn($,V);else if(I!=R||s==2)if(hn==0&&$.from==null){let se=$.range(i,null,null,I);$.min=se[0],$.max=se[1]}else $.min=Ot,$.max=-Ot}}if(hn>0){M.forEach((I,V)=>{if(s==1){let $=I.scale,se=W[$];if(se==null)return;let ce=g[$];if(V==0){let _e=ce.range(i,ce.min,ce.max,$);ce.min=_e[0],ce.max=_e[1],A=Ci(ce.min,e[0]),G=Ci(ce.max,e[0]),G-A>1&&(e[0][A]<ce.min&&A++,e[0][G]>ce.max&&G--),I.min=Z[A],I.max=Z[G]}else I.show&&I.auto&&dt(ce,se,I,e[V],I.sorted);I.idxs[0]=A,I.idxs[1]=G}else if(V>0&&I.show&&I.auto){let[$,se]=I.facets,ce=$.scale,_e=se.scale,[Ae,Ce]=e[V],Ue=g[ce],it=g[_e];Ue!=null&&dt(Ue,W[ce],$,Ae,$.sorted),it!=null&&dt(it,W[_e],se,Ce,se.sorted),I.min=se.min,I.max=se.max}});for(let I in g){let V=g[I],$=W[I];if(V.from==null&&($==null||$.min==null)){let se=V.range(i,V.min==Ot?null:V.min,V.max==-Ot?null:V.max,I);V.min=se[0],V.max=se[1]}}}for(let I in g){let V=g[I];if(V.from!=null){let $=g[V.from];if($.min==null)V.min=V.max=null;else{let se=V.range(i,$.min,$.max,I);V.min=se[0],V.max=se[1]}}}let S={},P=!1;for(let I in g){let V=g[I],$=v[I];if($.min!=V.min||$.max!=V.max){$.min=V.min,$.max=V.max;let se=$.distr;$._min=se==3?cs($.min):se==4?Dc($.min,$.asinh):se==100?$.fwd($.min):$.min,$._max=se==3?cs($.max):se==4?Dc($.max,$.asinh):se==100?$.fwd($.max):$.max,S[I]=P=!0}}if(P){M.forEach((I,V)=>{s==2?V>0&&S.y&&(I._paths=null):S[I.scale]&&(I._paths=null)});for(let I in S)Ze=!0,En("setScale",I);et&&ge.left>=0&&(H=pe=!0)}for(let I in W)W[I]=null}function Bn(g){let S=Pu(A-1,0,hn-1),P=Pu(G+1,0,hn-1);for(;g[S]==null&&S>0;)S--;for(;g[P]==null&&P<hn-1;)P++;return[S,P]}function Xs(){if(hn>0){let g=M.some(S=>S._focus)&&ot!=Qn.alpha;g&&(f.globalAlpha=ot=Qn.alpha),M.forEach((S,P)=>{if(P>0&&S.show&&(Vt(P,!1),Vt(P,!0),S._paths==null)){let I=ot;ot!=S.alpha&&(f.globalAlpha=ot=S.alpha);let V=s==2?[0,e[P][0].length-1]:Bn(e[P]);S._paths=S.paths(i,P,V[0],V[1]),ot!=I&&(f.globalAlpha=ot=I)}}),M.forEach((S,P)=>{if(P>0&&S.show){let I=ot;ot!=S.alpha&&(f.globalAlpha=ot=S.alpha),S._paths!=null&&zn(P,!1);{let V=S._paths!=null?S._paths.gaps:null,$=S.points.show(i,P,A,G,V),se=S.points.filter(i,P,$,V);($||se)&&(S.points._paths=S.points.paths(i,P,A,G,se),zn(P,!0))}ot!=I&&(f.globalAlpha=ot=I),En("drawSeries",P)}}),g&&(f.globalAlpha=ot=1)}}function Vt(g,S){let P=S?M[g].points:M[g];P._stroke=P.stroke(i,g),P._fill=P.fill(i,g)}function zn(g,S){let P=S?M[g].points:M[g],{stroke:I,fill:V,clip:$,flags:se,_stroke:ce=P._stroke,_fill:_e=P._fill,_width:Ae=P.width}=P._paths;Ae=kt(Ae*Et,3);let Ce=null,Ue=Ae%2/2;S&&_e==null&&(_e=Ae>0?"#fff":ce);let it=P.pxAlign==1&&Ue>0;if(it&&f.translate(Ue,Ue),!S){let St=Re-Ae/2,vt=le-Ae/2,ht=ve+Ae,je=Be+Ae;Ce=new Path2D,Ce.rect(St,vt,ht,je)}S?yn(ce,Ae,P.dash,P.cap,_e,I,V,se,$):$n(g,ce,Ae,P.dash,P.cap,_e,I,V,se,Ce,$),it&&f.translate(-Ue,-Ue)}function $n(g,S,P,I,V,$,se,ce,_e,Ae,Ce){let Ue=!1;_e!=0&&L.forEach((it,St)=>{if(it.series[0]==g){let vt=M[it.series[1]],ht=e[it.series[1]],je=(vt._paths||pa).band;Ds(je)&&(je=it.dir==1?je[0]:je[1]);let Ve,Yt=null;vt.show&&je&&B0(ht,A,G)?(Yt=it.fill(i,St)||$,Ve=vt._paths.clip):je=null,yn(S,P,I,V,Yt,se,ce,_e,Ae,Ce,Ve,je),Ue=!0}}),Ue||yn(S,P,I,V,$,se,ce,_e,Ae,Ce)}const xn=mo|Iu;function yn(g,S,P,I,V,$,se,ce,_e,Ae,Ce,Ue){Xe(g,S,P,I,V),(_e||Ae||Ue)&&(f.save(),_e&&f.clip(_e),Ae&&f.clip(Ae)),Ue?(ce&xn)==xn?(f.clip(Ue),Ce&&f.clip(Ce),hi(V,se),_s(g,$,S)):ce&Iu?(hi(V,se),f.clip(Ue),_s(g,$,S)):ce&mo&&(f.save(),f.clip(Ue),Ce&&f.clip(Ce),hi(V,se),f.restore(),_s(g,$,S)):(hi(V,se),_s(g,$,S)),(_e||Ae||Ue)&&f.restore()}function _s(g,S,P){P>0&&(S instanceof Map?S.forEach((I,V)=>{f.strokeStyle=Ie=V,f.stroke(I)}):S!=null&&g&&f.stroke(S))}function hi(g,S){S instanceof Map?S.forEach((P,I)=>{f.fillStyle=Te=I,f.fill(P)}):S!=null&&g&&f.fill(S)}function cg(g,S,P,I){let V=b[g],$;if(I<=0)$=[0,0];else{let se=V._space=V.space(i,g,S,P,I),ce=V._incrs=V.incrs(i,g,S,P,I,se);$=ox(S,P,ce,I,se)}return V._found=$}function pc(g,S,P,I,V,$,se,ce,_e,Ae){let Ce=se%2/2;x==1&&f.translate(Ce,Ce),Xe(ce,se,_e,Ae,ce),f.beginPath();let Ue,it,St,vt,ht=V+(I==0||I==3?-$:$);P==0?(it=V,vt=ht):(Ue=V,St=ht);for(let je=0;je<g.length;je++)S[je]!=null&&(P==0?Ue=St=g[je]:it=vt=g[je],f.moveTo(Ue,it),f.lineTo(St,vt));f.stroke(),x==1&&f.translate(-Ce,-Ce)}function ug(g){let S=!0;return b.forEach((P,I)=>{if(!P.show)return;let V=v[P.scale];if(V.min==null){P._show&&(S=!1,P._show=!1,wr(!1));return}else P._show||(S=!1,P._show=!0,wr(!1));let $=P.side,se=$%2,{min:ce,max:_e}=V,[Ae,Ce]=cg(I,ce,_e,se==0?y:O);if(Ce==0)return;let Ue=V.distr==2,it=P._splits=P.splits(i,I,ce,_e,Ae,Ce,Ue),St=V.distr==2?it.map(Ve=>Z[Ve]):it,vt=V.distr==2?Z[it[1]]-Z[it[0]]:Ae,ht=P._values=P.values(i,P.filter(i,St,I,Ce,vt),I,Ce,vt);P._rotate=$==2?P.rotate(i,ht,I,Ce):0;let je=P._size;P._size=gi(P.size(i,ht,I,g)),je!=null&&P._size!=je&&(S=!1)}),S}function hg(g){let S=!0;return Ua.forEach((P,I)=>{let V=P(i,I,es,g);V!=Ni[I]&&(S=!1),Ni[I]=V}),S}function fg(){for(let g=0;g<b.length;g++){let S=b[g];if(!S.show||!S._show)continue;let P=S.side,I=P%2,V,$,se=S.stroke(i,g),ce=P==0||P==3?-1:1,[_e,Ae]=S._found;if(S.label!=null){let Vn=S.labelGap*ce,ni=dn((S._lpos+Vn)*Et);Ht(S.labelFont[0],se,"center",P==2?Oo:td),f.save(),I==1?(V=$=0,f.translate(ni,dn(le+Be/2)),f.rotate((P==3?-wl:wl)/2)):(V=dn(Re+ve/2),$=ni);let $s=Wm(S.label)?S.label(i,g,_e,Ae):S.label;f.fillText($s,V,$),f.restore()}if(Ae==0)continue;let Ce=v[S.scale],Ue=I==0?ve:Be,it=I==0?Re:le,St=S._splits,vt=Ce.distr==2?St.map(Vn=>Z[Vn]):St,ht=Ce.distr==2?Z[St[1]]-Z[St[0]]:_e,je=S.ticks,Ve=S.border,Yt=je.show?je.size:0,Jt=dn(Yt*Et),bn=dn((S.alignTo==2?S._size-Yt-S.gap:S.gap)*Et),Lt=S._rotate*-wl/180,Qt=m(S._pos*Et),ei=(Jt+bn)*ce,Hn=Qt+ei;$=I==0?Hn:0,V=I==1?Hn:0;let fi=S.font[0],Ei=S.align==1?Nr:S.align==2?Rc:Lt>0?Nr:Lt<0?Rc:I==0?"center":P==3?Rc:Nr,ki=Lt||I==1?"middle":P==2?Oo:td;Ht(fi,se,Ei,ki);let ti=S.font[1]*S.lineGap,di=St.map(Vn=>m(a(Vn,Ce,Ue,it))),bi=S._values;for(let Vn=0;Vn<bi.length;Vn++){let ni=bi[Vn];if(ni!=null){I==0?V=di[Vn]:$=di[Vn],ni=""+ni;let $s=ni.indexOf(`
`)==-1?[ni]:ni.split(/\n/gm);for(let Gn=0;Gn<$s.length;Gn++){let Bf=$s[Gn];Lt?(f.save(),f.translate(V,$+Gn*ti),f.rotate(Lt),f.fillText(Bf,0,0),f.restore()):f.fillText(Bf,V,$+Gn*ti)}}}je.show&&pc(di,je.filter(i,vt,g,Ae,ht),I,P,Qt,Jt,kt(je.width*Et,3),je.stroke(i,g),je.dash,je.cap);let Bi=S.grid;Bi.show&&pc(di,Bi.filter(i,vt,g,Ae,ht),I,I==0?2:1,I==0?le:Re,I==0?Be:ve,kt(Bi.width*Et,3),Bi.stroke(i,g),Bi.dash,Bi.cap),Ve.show&&pc([Qt],[1],I==0?1:0,I==0?1:2,I==1?le:Re,I==1?Be:ve,kt(Ve.width*Et,3),Ve.stroke(i,g),Ve.dash,Ve.cap)}En("drawAxes")}function wr(g){M.forEach((S,P)=>{P>0&&(S._paths=null,g&&(s==1?(S.min=null,S.max=null):S.facets.forEach(I=>{I.min=null,I.max=null})))})}let Na=!1,mc=!1,Co=[];function dg(){mc=!1;for(let g=0;g<Co.length;g++)En(...Co[g]);Co.length=0}function Tr(){Na||(Q0(Mf),Na=!0)}function pg(g,S=!1){Na=!0,mc=S,g(i),Mf(),S&&Co.length>0&&queueMicrotask(dg)}i.batch=pg;function Mf(){if(ke&&(ms(),ke=!1),Ze&&(Oe(),Ze=!1),Me){if(qt(h,Nr,J),qt(h,Oo,ie),qt(h,ea,y),qt(h,ta,O),qt(_,Nr,J),qt(_,Oo,ie),qt(_,ea,y),qt(_,ta,O),qt(d,ea,Mt),qt(d,ta,D),u.width=dn(Mt*Et),u.height=dn(D*Et),b.forEach(({_el:g,_show:S,_size:P,_pos:I,side:V})=>{if(g!=null)if(S){let $=V===3||V===0?P:0,se=V%2==1;qt(g,se?"left":"top",I-$),qt(g,se?"width":"height",P),qt(g,se?"top":"left",se?ie:J),qt(g,se?"height":"width",se?O:y),Ru(g,ar)}else ri(g,ar)}),Ie=Te=Ye=He=ct=gt=zt=Rt=qe=null,ot=1,Lo(!0),J!=te||ie!=Fe||y!=he||O!=Le){wr(!1);let g=y/he,S=O/Le;if(et&&!H&&ge.left>=0){ge.left*=g,ge.top*=S,Ar&&zi(Ar,dn(ge.left),0,y,O),Rr&&zi(Rr,0,dn(ge.top),y,O);for(let P=0;P<kn.length;P++){let I=kn[P];I!=null&&(Qi[P]*=g,Si[P]*=S,zi(I,gi(Qi[P]),gi(Si[P]),y,O))}}if(Xt.show&&!fe&&Xt.left>=0&&Xt.width>0){Xt.left*=g,Xt.width*=g,Xt.top*=S,Xt.height*=S;for(let P in Mc)qt(Dr,P,Xt[P])}te=J,Fe=ie,he=y,Le=O}En("setSize"),Me=!1}Mt>0&&D>0&&(f.clearRect(0,0,u.width,u.height),En("drawClear"),N.forEach(g=>g()),En("draw")),Xt.show&&fe&&(Fa(Xt),fe=!1),et&&H&&(qs(null,!0,!1),H=!1),xe.show&&xe.live&&pe&&(xc(),pe=!1),l||(l=!0,i.status=1,En("ready")),Y=!1,Na=!1}i.redraw=(g,S)=>{Ze=S||!1,g!==!1?vs(R,C.min,C.max):Tr()};function _c(g,S){let P=v[g];if(P.from==null){if(hn==0){let I=P.range(i,S.min,S.max,g);S.min=I[0],S.max=I[1]}if(S.min>S.max){let I=S.min;S.min=S.max,S.max=I}if(hn>1&&S.min!=null&&S.max!=null&&S.max-S.min<1e-16)return;g==R&&P.distr==2&&hn>0&&(S.min=Ci(S.min,e[0]),S.max=Ci(S.max,e[0]),S.min==S.max&&S.max++),W[g]=S,ke=!0,Tr()}}i.setScale=_c;let gc,vc,Ar,Rr,Sf,Ef,Cr,Pr,bf,wf,Wt,jt,gs=!1;const An=ge.drag;let Mn=An.x,Sn=An.y;et&&(ge.x&&(gc=mi(E0,_)),ge.y&&(vc=mi(b0,_)),C.ori==0?(Ar=gc,Rr=vc):(Ar=vc,Rr=gc),Wt=ge.left,jt=ge.top);const Xt=i.select=cn({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),Dr=Xt.show?mi(S0,Xt.over?_:h):null;function Fa(g,S){if(Xt.show){for(let P in g)Xt[P]=g[P],P in Mc&&qt(Dr,P,g[P]);S!==!1&&En("setSelect")}}i.setSelect=Fa;function mg(g){if(M[g].show)Qe&&Ru(ye[g],ar);else if(Qe&&ri(ye[g],ar),et){let P=Ui?kn[0]:kn[g];P!=null&&zi(P,-10,-10,y,O)}}function vs(g,S,P){_c(g,{min:S,max:P})}function Fi(g,S,P,I){S.focus!=null&&yg(g),S.show!=null&&M.forEach((V,$)=>{$>0&&(g==$||g==null)&&(V.show=S.show,mg($),s==2?(vs(V.facets[0].scale,null,null),vs(V.facets[1].scale,null,null)):vs(V.scale,null,null),Tr())}),P!==!1&&En("setSeries",g,S),I&&Io("setSeries",i,g,S)}i.setSeries=Fi;function _g(g,S){cn(L[g],S)}function gg(g,S){g.fill=pt(g.fill||null),g.dir=yt(g.dir,-1),S=S??L.length,L.splice(S,0,g)}function vg(g){g==null?L.length=0:L.splice(g,1)}i.addBand=gg,i.setBand=_g,i.delBand=vg;function xg(g,S){M[g].alpha=S,et&&kn[g]!=null&&(kn[g].style.opacity=S),Qe&&ye[g]&&(ye[g].style.opacity=S)}let ts,xs,Ys;const Lr={focus:!0};function yg(g){if(g!=Ys){let S=g==null,P=Qn.alpha!=1;M.forEach((I,V)=>{if(s==1||V>0){let $=S||V==0||V==g;I._focus=S?null:$,P&&xg(V,$?1:Qn.alpha)}}),Ys=g,P&&Tr()}}Qe&&qn&&Ge(rd,ne,g=>{ge._lock||(Tn(g),Ys!=null&&Fi(null,Lr,!0,on.setSeries))});function Oi(g,S,P){let I=v[S];P&&(g=g/Et-(I.ori==1?ie:J));let V=y;I.ori==1&&(V=O,g=V-g),I.dir==-1&&(g=V-g);let $=I._min,se=I._max,ce=g/V,_e=$+(se-$)*ce,Ae=I.distr;return Ae==3?ho(10,_e):Ae==4?H0(_e,I.asinh):Ae==100?I.bwd(_e):_e}function Mg(g,S){let P=Oi(g,R,S);return Ci(P,e[0],A,G)}i.valToIdx=g=>Ci(g,e[0]),i.posToIdx=Mg,i.posToVal=Oi,i.valToPos=(g,S,P)=>v[S].ori==0?r(g,v[S],P?ve:y,P?Re:0):o(g,v[S],P?Be:O,P?le:0),i.setCursor=(g,S,P)=>{Wt=g.left,jt=g.top,qs(null,S,P)};function Tf(g,S){qt(Dr,Nr,Xt.left=g),qt(Dr,ea,Xt.width=S)}function Af(g,S){qt(Dr,Oo,Xt.top=g),qt(Dr,ta,Xt.height=S)}let Po=C.ori==0?Tf:Af,Do=C.ori==1?Tf:Af;function Sg(){if(Qe&&xe.live)for(let g=s==2?1:0;g<M.length;g++){if(g==0&&F)continue;let S=xe.values[g],P=0;for(let I in S)tt[g][P++].firstChild.nodeValue=S[I]}}function xc(g,S){if(g!=null&&(g.idxs?g.idxs.forEach((P,I)=>{me[I]=P}):X0(g.idx)||me.fill(g.idx),xe.idx=me[0]),Qe&&xe.live){for(let P=0;P<M.length;P++)(P>0||s==1&&!F)&&Eg(P,me[P]);Sg()}pe=!1,S!==!1&&En("setLegend")}i.setLegend=xc;function Eg(g,S){let P=M[g],I=g==0&&B==2?Z:e[g],V;F?V=P.values(i,g,S)??mt:(V=P.value(i,S==null?null:I[S],g,S),V=V==null?mt:{_:V}),xe.values[g]=V}function qs(g,S,P){bf=Wt,wf=jt,[Wt,jt]=ge.move(i,Wt,jt),ge.left=Wt,ge.top=jt,et&&(Ar&&zi(Ar,dn(Wt),0,y,O),Rr&&zi(Rr,0,dn(jt),y,O));let I,V=A>G;ts=Ot,xs=null;let $=C.ori==0?y:O,se=C.ori==1?y:O;if(Wt<0||hn==0||V){I=ge.idx=null;for(let ce=0;ce<M.length;ce++){let _e=kn[ce];_e!=null&&zi(_e,-10,-10,y,O)}qn&&Fi(null,Lr,!0,g==null&&on.setSeries),xe.live&&(me.fill(I),pe=!0)}else{let ce,_e,Ae;s==1&&(ce=C.ori==0?Wt:jt,_e=Oi(ce,R),I=ge.idx=Ci(_e,e[0],A,G),Ae=z(e[0][I],C,$,0));let Ce=-10,Ue=-10,it=0,St=0,vt=!0,ht="",je="";for(let Ve=s==2?1:0;Ve<M.length;Ve++){let Yt=M[Ve],Jt=me[Ve],bn=Jt==null?null:s==1?e[Ve][Jt]:e[Ve][1][Jt],Lt=ge.dataIdx(i,Ve,I,_e),Qt=Lt==null?null:s==1?e[Ve][Lt]:e[Ve][1][Lt];if(pe=pe||Qt!=bn||Lt!=Jt,me[Ve]=Lt,Ve>0&&Yt.show){let ei=Lt==null?-10:Lt==I?Ae:z(s==1?e[0][Lt]:e[Ve][0][Lt],C,$,0),Hn=Qt==null?-10:X(Qt,s==1?v[Yt.scale]:v[Yt.facets[1].scale],se,0);if(qn&&Qt!=null){let fi=C.ori==1?Wt:jt,Ei=pn(Qn.dist(i,Ve,Lt,Hn,fi));if(Ei<ts){let ki=Qn.bias;if(ki!=0){let ti=Oi(fi,Yt.scale),di=Qt>=0?1:-1,bi=ti>=0?1:-1;bi==di&&(bi==1?ki==1?Qt>=ti:Qt<=ti:ki==1?Qt<=ti:Qt>=ti)&&(ts=Ei,xs=Ve)}else ts=Ei,xs=Ve}}if(pe||Ui){let fi,Ei;C.ori==0?(fi=ei,Ei=Hn):(fi=Hn,Ei=ei);let ki,ti,di,bi,Bi,Vn,ni=!0,$s=Nt.bbox;if($s!=null){ni=!1;let Gn=$s(i,Ve);di=Gn.left,bi=Gn.top,ki=Gn.width,ti=Gn.height}else di=fi,bi=Ei,ki=ti=Nt.size(i,Ve);if(Vn=Nt.fill(i,Ve),Bi=Nt.stroke(i,Ve),Ui)Ve==xs&&ts<=Qn.prox&&(Ce=di,Ue=bi,it=ki,St=ti,vt=ni,ht=Vn,je=Bi);else{let Gn=kn[Ve];Gn!=null&&(Qi[Ve]=di,Si[Ve]=bi,fd(Gn,ki,ti,ni),ud(Gn,Vn,Bi),zi(Gn,gi(di),gi(bi),y,O))}}}}if(Ui){let Ve=Qn.prox,Yt=Ys==null?ts<=Ve:ts>Ve||xs!=Ys;if(pe||Yt){let Jt=kn[0];Jt!=null&&(Qi[0]=Ce,Si[0]=Ue,fd(Jt,it,St,vt),ud(Jt,ht,je),zi(Jt,gi(Ce),gi(Ue),y,O))}}}if(Xt.show&&gs)if(g!=null){let[ce,_e]=on.scales,[Ae,Ce]=on.match,[Ue,it]=g.cursor.sync.scales,St=g.cursor.drag;if(Mn=St._x,Sn=St._y,Mn||Sn){let{left:vt,top:ht,width:je,height:Ve}=g.select,Yt=g.scales[Ue].ori,Jt=g.posToVal,bn,Lt,Qt,ei,Hn,fi=ce!=null&&Ae(ce,Ue),Ei=_e!=null&&Ce(_e,it);fi&&Mn?(Yt==0?(bn=vt,Lt=je):(bn=ht,Lt=Ve),Qt=v[ce],ei=z(Jt(bn,Ue),Qt,$,0),Hn=z(Jt(bn+Lt,Ue),Qt,$,0),Po(Pi(ei,Hn),pn(Hn-ei))):Po(0,$),Ei&&Sn?(Yt==1?(bn=vt,Lt=je):(bn=ht,Lt=Ve),Qt=v[_e],ei=X(Jt(bn,it),Qt,se,0),Hn=X(Jt(bn+Lt,it),Qt,se,0),Do(Pi(ei,Hn),pn(Hn-ei))):Do(0,se)}else Sc()}else{let ce=pn(bf-Sf),_e=pn(wf-Ef);if(C.ori==1){let it=ce;ce=_e,_e=it}Mn=An.x&&ce>=An.dist,Sn=An.y&&_e>=An.dist;let Ae=An.uni;Ae!=null?Mn&&Sn&&(Mn=ce>=Ae,Sn=_e>=Ae,!Mn&&!Sn&&(_e>ce?Sn=!0:Mn=!0)):An.x&&An.y&&(Mn||Sn)&&(Mn=Sn=!0);let Ce,Ue;Mn&&(C.ori==0?(Ce=Cr,Ue=Wt):(Ce=Pr,Ue=jt),Po(Pi(Ce,Ue),pn(Ue-Ce)),Sn||Do(0,se)),Sn&&(C.ori==1?(Ce=Cr,Ue=Wt):(Ce=Pr,Ue=jt),Do(Pi(Ce,Ue),pn(Ue-Ce)),Mn||Po(0,$)),!Mn&&!Sn&&(Po(0,0),Do(0,0))}if(An._x=Mn,An._y=Sn,g==null){if(P){if(kf!=null){let[ce,_e]=on.scales;on.values[0]=ce!=null?Oi(C.ori==0?Wt:jt,ce):null,on.values[1]=_e!=null?Oi(C.ori==1?Wt:jt,_e):null}Io(Cc,i,Wt,jt,y,O,I)}if(qn){let ce=P&&on.setSeries,_e=Qn.prox;Ys==null?ts<=_e&&Fi(xs,Lr,!0,ce):ts>_e?Fi(null,Lr,!0,ce):xs!=Ys&&Fi(xs,Lr,!0,ce)}}pe&&(xe.idx=I,xc()),S!==!1&&En("setCursor")}let ys=null;Object.defineProperty(i,"rect",{get(){return ys==null&&Lo(!1),ys}});function Lo(g=!1){g?ys=null:(ys=_.getBoundingClientRect(),En("syncRect",ys))}function Rf(g,S,P,I,V,$,se){ge._lock||gs&&g!=null&&g.movementX==0&&g.movementY==0||(yc(g,S,P,I,V,$,se,!1,g!=null),g!=null?qs(null,!0,!0):qs(S,!0,!1))}function yc(g,S,P,I,V,$,se,ce,_e){if(ys==null&&Lo(!1),Tn(g),g!=null)P=g.clientX-ys.left,I=g.clientY-ys.top;else{if(P<0||I<0){Wt=-10,jt=-10;return}let[Ae,Ce]=on.scales,Ue=S.cursor.sync,[it,St]=Ue.values,[vt,ht]=Ue.scales,[je,Ve]=on.match,Yt=S.axes[0].side%2==1,Jt=C.ori==0?y:O,bn=C.ori==1?y:O,Lt=Yt?$:V,Qt=Yt?V:$,ei=Yt?I:P,Hn=Yt?P:I;if(vt!=null?P=je(Ae,vt)?a(it,v[Ae],Jt,0):-10:P=Jt*(ei/Lt),ht!=null?I=Ve(Ce,ht)?a(St,v[Ce],bn,0):-10:I=bn*(Hn/Qt),C.ori==1){let fi=P;P=I,I=fi}}_e&&(S==null||S.cursor.event.type==Cc)&&((P<=1||P>=y-1)&&(P=nr(P,y)),(I<=1||I>=O-1)&&(I=nr(I,O))),ce?(Sf=P,Ef=I,[Cr,Pr]=ge.move(i,P,I)):(Wt=P,jt=I)}const Mc={width:0,height:0,left:0,top:0};function Sc(){Fa(Mc,!1)}let Cf,Pf,Df,Lf;function If(g,S,P,I,V,$,se){gs=!0,Mn=Sn=An._x=An._y=!1,yc(g,S,P,I,V,$,se,!0,!1),g!=null&&(Ge(Pc,Tu,Uf,!1),Io(id,i,Cr,Pr,y,O,null));let{left:ce,top:_e,width:Ae,height:Ce}=Xt;Cf=ce,Pf=_e,Df=Ae,Lf=Ce}function Uf(g,S,P,I,V,$,se){gs=An._x=An._y=!1,yc(g,S,P,I,V,$,se,!1,!0);let{left:ce,top:_e,width:Ae,height:Ce}=Xt,Ue=Ae>0||Ce>0,it=Cf!=ce||Pf!=_e||Df!=Ae||Lf!=Ce;if(Ue&&it&&Fa(Xt),An.setScale&&Ue&&it){let St=ce,vt=Ae,ht=_e,je=Ce;if(C.ori==1&&(St=_e,vt=Ce,ht=ce,je=Ae),Mn&&vs(R,Oi(St,R),Oi(St+vt,R)),Sn)for(let Ve in v){let Yt=v[Ve];Ve!=R&&Yt.from==null&&Yt.min!=Ot&&vs(Ve,Oi(ht+je,Ve),Oi(ht,Ve))}Sc()}else ge.lock&&(ge._lock=!ge._lock,qs(S,!0,g!=null));g!=null&&(Gt(Pc,Tu),Io(Pc,i,Wt,jt,y,O,null))}function bg(g,S,P,I,V,$,se){if(ge._lock)return;Tn(g);let ce=gs;if(gs){let _e=!0,Ae=!0,Ce=10,Ue,it;C.ori==0?(Ue=Mn,it=Sn):(Ue=Sn,it=Mn),Ue&&it&&(_e=Wt<=Ce||Wt>=y-Ce,Ae=jt<=Ce||jt>=O-Ce),Ue&&_e&&(Wt=Wt<Cr?0:y),it&&Ae&&(jt=jt<Pr?0:O),qs(null,!0,!0),gs=!1}Wt=-10,jt=-10,me.fill(null),qs(null,!0,!0),ce&&(gs=ce)}function Nf(g,S,P,I,V,$,se){ge._lock||(Tn(g),Se(),Sc(),g!=null&&Io(od,i,Wt,jt,y,O,null))}function Ff(){b.forEach(ax),De(i.width,i.height,!0)}_r(Vl,no,Ff);const Ir={};Ir.mousedown=If,Ir.mousemove=Rf,Ir.mouseup=Uf,Ir.dblclick=Nf,Ir.setSeries=(g,S,P,I)=>{let V=on.match[2];P=V(i,S,P),P!=-1&&Fi(P,I,!0,!1)},et&&(Ge(id,_,If),Ge(Cc,_,Rf),Ge(sd,_,g=>{Tn(g),Lo(!1)}),Ge(rd,_,bg),Ge(od,_,Nf),Uu.add(i),i.syncRect=Lo);const Oa=i.hooks=n.hooks||{};function En(g,S,P){mc?Co.push([g,S,P]):g in Oa&&Oa[g].forEach(I=>{I.call(null,i,S,P)})}(n.plugins||[]).forEach(g=>{for(let S in g.hooks)Oa[S]=(Oa[S]||[]).concat(g.hooks[S])});const Of=(g,S,P)=>P,on=cn({key:null,setSeries:!1,filters:{pub:gd,sub:gd},scales:[R,M[1]?M[1].scale:null],match:[vd,vd,Of],values:[null,null]},ge.sync);on.match.length==2&&on.match.push(Of),ge.sync=on;const kf=on.key,Ec=p_(kf);function Io(g,S,P,I,V,$,se){on.filters.pub(g,S,P,I,V,$,se)&&Ec.pub(g,S,P,I,V,$,se)}Ec.sub(i);function wg(g,S,P,I,V,$,se){on.filters.sub(g,S,P,I,V,$,se)&&Ir[g](null,S,P,I,V,$,se)}i.pub=wg;function Tg(){Ec.unsub(i),Uu.delete(i),Pe.clear(),Cu(Vl,no,Ff),c.remove(),ne?.remove(),En("destroy")}i.destroy=Tg;function bc(){En("init",n,e),de(e||n.data,!1),W[R]?_c(R,W[R]):Se(),fe=Xt.show&&(Xt.width>0||Xt.height>0),H=pe=!0,De(n.width,n.height)}return M.forEach(Gs),b.forEach(dc),t?t instanceof HTMLElement?(t.appendChild(c),bc()):t(i,bc):bc(),i}On.assign=cn;On.fmtNum=Wh;On.rangeNum=Gl;On.rangeLog=nc;On.rangeAsinh=Vh;On.orient=Sr;On.pxRatio=Et;On.join=J0;On.fmtDate=Yh,On.tzDate=cv;On.sync=p_;{On.addGap=Xv,On.clipGaps=rc;let n=On.paths={points:y_};n.linear=S_,n.stepped=$v,n.bars=jv,n.spline=Kv}const Ga=at("q"),lx={light:["#0072b2","#b35c00","#007a5a","#a8327d","#5b4bd6","#1f1f1f","#8a6d00"],dark:["#56b4e9","#f5a742","#3fd6a5","#f08cc8","#b3a5ff","#e8e8e8","#f0e442"]},T_=30;function cx(){const n=Zi(null);Ra(()=>{let t=null;const i=sn(()=>{t?.destroy(),t=n.current?ux(n.current,Ga.value):null}),s=sn(()=>{Wi.value,t?.redraw(!1,!1)}),r=new ResizeObserver(()=>n.current&&t?.setSize({width:n.current.clientWidth,height:n.current.clientHeight-T_}));return n.current&&r.observe(n.current),()=>{i(),s(),r.disconnect(),t?.destroy()}},[]);const e=(Ca.value?.t.length??0)===0;return w("div",{class:"plots",children:[w(fa,{label:"What is plotted",value:Ga.value,onChange:t=>Ga.value=t,options:[["q","Joints"],["qd","Rates"],["qdd","Accelerations"],["tool_speed","Tool speed"]]}),e&&w("p",{class:"quiet",children:"A motion shows its joints, rates and the tool's speed here."}),w("div",{class:"plot",ref:n,hidden:e,role:"img","aria-label":`Plot of ${Ga.value} over time`})]})}function ux(n,e){const t=Ca.value,i=mn.value?.joints??[];if(!t||t.t.length===0)return null;const s=mr.value?"#c9cfdb":"#3a4150",r=mr.value?"#2c313c":"#e4e7ed",o=lx[mr.value?"dark":"light"],a=Ct.value.angle==="deg",l=h=>ya(i[h])==="angle"?a?180/Math.PI:1:Ct.value.length==="mm"?1e3:1,c={q:"",qd:"/s",qdd:"/s²",tool_speed:""}[e],u=[{label:"t",value:(h,_)=>_===null?"–":`${_.toFixed(2)} s`}],f=[t.t];if(e==="tool_speed"){const h=Ct.value.length==="mm"?1e3:1;f.push(t.tool_speed.map(_=>_*h)),u.push({label:`tool, ${Ct.value.length}/s`,stroke:o[4],width:1.75,pxAlign:0})}else t[e].forEach((h,_)=>{if(!i[_])return;const x=ya(i[_])==="angle"?a?"°":"rad":Ct.value.length;f.push(h.map(m=>m*l(_))),u.push({label:`${i[_].label}, ${x}${c}`,stroke:o[_%o.length],width:1.75,pxAlign:0,..._>3?{dash:[6,3]}:{}})});const d={stroke:s,grid:{stroke:r,width:1},ticks:{stroke:r},font:"12px system-ui, sans-serif"};return new On({width:n.clientWidth||600,height:(n.clientHeight||180)-T_,series:u,scales:{x:{time:!1}},legend:{live:!0},axes:[d,{...d,size:56}],cursor:{drag:{x:!1,y:!1}},hooks:{ready:[h=>h.over.addEventListener("click",()=>{const _=h.cursor.left;_!==void 0&&st({do:"seek",t:h.posToVal(_,"x")})})],draw:[h=>{const _=Math.round(h.valToPos(Wi.peek(),"x",!0));h.ctx.save(),h.ctx.strokeStyle="#7c3aed",h.ctx.lineWidth=2,h.ctx.beginPath(),h.ctx.moveTo(_,h.bbox.top),h.ctx.lineTo(_,h.bbox.top+h.bbox.height),h.ctx.stroke(),h.ctx.restore()}]}},f,n)}const hx=(function(){const e=typeof document<"u"&&document.createElement("link").relList;return e&&e.supports&&e.supports("modulepreload")?"modulepreload":"preload"})(),fx=function(n,e){return new URL(n,e).href},zd={},dx=function(e,t,i){let s=Promise.resolve();if(t&&t.length>0){let c=function(u){return Promise.all(u.map(f=>Promise.resolve(f).then(d=>({status:"fulfilled",value:d}),d=>({status:"rejected",reason:d}))))};const o=document.getElementsByTagName("link"),a=document.querySelector("meta[property=csp-nonce]"),l=a?.nonce||a?.getAttribute("nonce");s=c(t.map(u=>{if(u=fx(u,i),u in zd)return;zd[u]=!0;const f=u.endsWith(".css"),d=f?'[rel="stylesheet"]':"";if(i)for(let _=o.length-1;_>=0;_--){const x=o[_];if(x.href===u&&(!f||x.rel==="stylesheet"))return}else if(document.querySelector(`link[href="${u}"]${d}`))return;const h=document.createElement("link");if(h.rel=f?"stylesheet":hx,f||(h.as="script"),h.crossOrigin="",h.href=u,l&&h.setAttribute("nonce",l),document.head.appendChild(h),f)return new Promise((_,x)=>{h.addEventListener("load",_),h.addEventListener("error",()=>x(new Error(`Unable to preload CSS for ${u}`)))})}))}function r(o){const a=new Event("vite:preloadError",{cancelable:!0});if(a.payload=o,window.dispatchEvent(a),!a.defaultPrevented)throw o}return s.then(o=>{for(const a of o||[])a.status==="rejected"&&r(a.reason);return e().catch(r)})};let Vi=null,Wa=0;function Hd(){!Vi||ha.value?.running||(_a.value=[],Vi.markLine(null),st({do:"script_run",text:Vi.text()}))}function Fu(){st({do:"script_stop"})}function px(){const n=Zi(null),e=Zi(null),[t,i]=lo([]),[s,r]=lo(null),o=ha.value;return Ra(()=>{let l=!1,c;Promise.all([dx(()=>import("./editor-CusletEg.js"),[],import.meta.url),st({do:"script_examples"})]).then(([{makeEditor:f},d])=>{if(l||!n.current)return;i(d??[]);const h=ha.value?.text||d?.[0]?.text||"";Vi=f(n.current,h,Hd,_=>{clearTimeout(c),c=setTimeout(()=>{st({do:"script_save",text:_})},800)}),Vi.setDark(mr.value)});const u=[sn(()=>{const f=mr.value;Vi?.setDark(f)}),sn(()=>{const f=ha.value?.error?.line??null;Vi?.markLine(f)}),sn(()=>{_a.value,requestAnimationFrame(()=>e.current?.scrollTo(0,e.current.scrollHeight))})];return()=>{l=!0,u.forEach(f=>f()),Vi?.destroy(),Vi=null}},[]),w("div",{class:"script",onKeyDown:l=>{Wa=l.key==="Escape"?Wa+1:0,Wa>=2&&o?.running&&(Wa=0,Fu())},children:[w("div",{class:"script-edit",children:[w("div",{class:"row",children:[w("button",{type:"button",class:"text-button go",disabled:o?.running||!o?.python?.found,onClick:Hd,title:"Ctrl+Enter",children:"Run"}),w("button",{type:"button",class:"text-button",disabled:!o?.running,onClick:Fu,title:"Esc twice",children:"Stop"}),w("label",{class:"field",children:["Examples ",w("select",{value:"",onChange:l=>{const c=t.find(u=>u.name===l.currentTarget.value);c&&Vi?.setText(c.text),l.currentTarget.value=""},children:[w("option",{value:"",children:"choose…"}),t.map(l=>w("option",{children:l.name},l.name))]})]}),w("button",{type:"button",class:"text-button","aria-expanded":s!==null,onClick:()=>{s?r(null):st({do:"script_help"}).then(l=>r(l))},children:"mathmodel"}),w("span",{class:"grow"}),w("span",{class:o?.python?.found?"quiet small":"banner",children:o?.python?.sentence??"Looking for Python…"})]}),w("div",{class:"editor",ref:n})]}),w("div",{class:"script-side",children:s?w("div",{class:"scroll-box",role:"region",tabIndex:0,"aria-label":"What mathmodel offers",children:[w("div",{class:"row spread",children:[w("strong",{children:"import mathmodel"}),w(bt,{icon:"close",label:"Close",onClick:()=>r(null)})]}),w("dl",{class:"help",children:s.map(l=>w(ci,{children:[w("dt",{children:w("code",{children:l.name})},l.name),w("dd",{children:[l.does,w("br",{}),w("code",{class:"quiet",children:l.example})]})]}))})]}):w("div",{class:"console",ref:e,role:"log",tabIndex:0,"aria-label":"Output of the script",children:[_a.value.map((l,c)=>w("span",{class:l.stream,children:l.text},c)),o?.ended&&!o.running&&w("span",{class:o.error?"err":"note",children:[o.ended,`
`]})]})})]})}const mx=[["motion","Motion"],["plots","Plots"],["formulas","Formulas"],["script","Script"],["log","Log"]];function _x(){const n=Ps.value,e=gr.value;return w("footer",{class:`drawer ${n?"open":""}`,children:[w("div",{class:"drawer-bar",children:[w(gx,{}),w("span",{class:"grow"}),w("div",{class:"tabs",role:"tablist","aria-label":"Drawer",children:mx.filter(([t])=>!Eo||t==="plots").map(([t,i])=>w("button",{type:"button",role:"tab",id:`drawer-tab-${t}`,"aria-selected":n===t,"aria-controls":"drawer-body",onClick:()=>Ps.value=n===t?null:t,children:[i,t==="log"&&Ko.value.some(s=>s.level!=="info")&&w("span",{class:"badge",children:Ko.value.length})]},t))})]}),w("div",{class:"drawer-body",id:"drawer-body",role:"tabpanel",hidden:!n,...n?{"aria-labelledby":`drawer-tab-${n}`}:{},children:[n==="motion"&&e&&w(xx,{}),n==="plots"&&w(cx,{}),n==="formulas"&&w(f0,{}),n==="script"&&w(px,{}),n==="log"&&(Ko.value.length===0?w("p",{class:"quiet",children:"Nothing has happened that needs telling."}):w("ol",{class:"log",children:Ko.value.map((t,i)=>w("li",{class:t.level,children:t.text},i))}))]})]})}function gx(){const n=gr.value;if(!n)return null;const e=n.keyframes.length>1;return w("div",{class:"transport",role:"group","aria-label":"Playback",children:[!Eo&&w(bt,{icon:"plus",label:"Add this posture as a keyframe",keys:"K",text:e?void 0:"Keyframe",onClick:A_}),w(bt,{icon:"back",label:"A step back",disabled:!e,onClick:()=>{st({do:"step",by:-1})}}),w(bt,{icon:n.playing?"pause":"play",class:"primary",label:n.playing?"Pause":"Play",keys:"Space",disabled:!e,onClick:R_}),w(bt,{icon:"forward",label:"A step on",disabled:!e,onClick:()=>{st({do:"step",by:1})}}),w(bt,{icon:"loop",label:"Again and again",pressed:n.loop,disabled:!e,onClick:()=>{st({do:"loop",on:!n.loop})}}),e&&w(ci,{children:[w("input",{class:"scrub",type:"range",min:0,max:n.duration,step:n.duration/1e3,value:Wi.value,"aria-label":"Time","aria-valuetext":`${Wi.value.toFixed(2)} of ${n.duration.toFixed(2)} seconds`,onInput:t=>{Wi.value=Number(t.currentTarget.value),st({do:"seek",t:Wi.value})}}),w("span",{class:"time",children:[Wi.value.toFixed(2)," / ",n.duration.toFixed(2)," s"]})]}),!e&&w("span",{class:"quiet small wide",children:"Two keyframes or a table make a motion."})]})}function A_(){st({do:"keyframe",op:"add"}).then(n=>{n&&Kn("Keyframe added","note")})}function R_(){st({do:gr.value?.playing?"pause":"play"})}const vx=["motion.csv","motion.json",...["joints","rates","accelerations","path"].flatMap(n=>[`${n}.svg`,`${n}.png`])];function xx(){const n=gr.value,e=async i=>{const s=await st({do:"motion_table",name:i.name,text:await i.text()});s&&Kn(`${i.name}: ${s.rows} rows`,"note")},t=n.keyframes.length>60;return w("div",{class:"motion",children:[w("div",{class:"row",children:[w("label",{class:"text-button",children:[w("span",{children:"Open a table…"}),w("input",{type:"file",class:"visually-hidden",accept:".csv",onChange:i=>{const s=i.currentTarget.files?.[0];s&&e(s),i.currentTarget.value=""}})]}),w("label",{class:"field",children:["Law ",w("select",{value:n.law,onChange:i=>{st({do:"law",to:i.currentTarget.value})},children:n.laws.map(i=>w("option",{children:i},i))})]}),w("label",{class:"field",children:["Speed ",w("input",{type:"range",min:.1,max:4,step:.1,value:n.speed,"aria-valuetext":`${n.speed} times`,onInput:i=>{st({do:"speed",to:Number(i.currentTarget.value)})}})," ",w("span",{class:"time",children:[n.speed.toFixed(1),"×"]})]}),w("span",{class:"grow"}),w("label",{class:"field",children:["Export ",w("select",{value:"",disabled:n.keyframes.length<2,onChange:i=>{location.assign(`/api/export/${i.currentTarget.value}`),i.currentTarget.value=""},children:[w("option",{value:"",children:"choose…"}),vx.map(i=>w("option",{children:i},i))]})]}),w("button",{type:"button",class:"text-button",disabled:n.keyframes.length===0,onClick:()=>{st({do:"keyframe",op:"clear"})},children:"Clear"})]}),n.problem&&w("p",{class:"banner",children:n.problem}),n.name&&w("p",{class:"quiet small",children:[n.name,": ",n.keyframes.length," rows"]}),n.keyframes.length===0&&w("p",{class:"quiet",children:["Bring the arm to a posture and press ",w("kbd",{children:"K"}),"; move it and press ",w("kbd",{children:"K"})," again; ",w("kbd",{children:"Space"})," plays."]}),!t&&n.keyframes.length>0&&w("ol",{class:"keyframes",children:n.keyframes.map(i=>w("li",{class:Math.abs(Wi.value-i.t)<1e-6?"here":"",children:[w("button",{type:"button",class:"keyframe-name",onClick:()=>{st({do:"keyframe",op:"goto",id:i.id})},children:i.label||i.id}),w("label",{class:"field",children:[w(or,{value:i.t,kind:"plain",label:`Time of keyframe ${i.label}`,onCommit:s=>{st({do:"keyframe",op:"move",id:i.id,t:s.replace(/s$/,"")})}})," s"]}),w("button",{type:"button",class:"text-button",title:"Takes the present posture",onClick:()=>{st({do:"keyframe",op:"set",id:i.id})},children:"Set"}),w(bt,{icon:"close",label:`Remove keyframe ${i.label}`,onClick:()=>{st({do:"keyframe",op:"remove",id:i.id})}})]},i.id))})]})}const Nc=Math.PI/180,yx=.04,Mx=new co(n=>Ii.send(n),()=>{},n=>Kn(n.message));function Sx({joint:n,index:e}){const t=Zi(""),i=ya(n),s=ec.value[e]??0,{lower:r,upper:o}=n,a=o-r,l=i==="angle"?.1*Nc:5e-4,c=!n.unlimited&&Math.min(s-r,o-s)<yx*a,u=Ji.value?.over_limit[e]??!1,f=Zi({value:s,at:0}),d=m=>{f.current={value:m,at:performance.now()},Mx.push({do:"joint",joint:e,value:m,gesture:t.current})},h=m=>{const p={ArrowUp:1,ArrowRight:1,ArrowDown:-1,ArrowLeft:-1}[m.key];if(p===void 0)return;m.preventDefault(),m.stopPropagation(),m.repeat||(t.current=xa(`key-${e}`));const M=performance.now()-f.current.at<200?f.current.value:s,b=m.shiftKey?10:m.altKey?.1:1;d(Math.min(o,Math.max(r,M+p*b*(i==="angle"?Nc:.001))))},_=i==="angle"?[-90,-45,0,45,90].map(m=>m*Nc).filter(m=>m>r&&m<o):r<0&&o>0?[0]:[],x=n.unlimited?"no limits":`limits ${uo(r,i,Ct.value)} to ${uo(o,i,Ct.value)}`;return w("li",{class:`joint ${u?"over":c?"near":""}`,children:[w("button",{type:"button",class:"joint-name",title:`${n.name}: ${x}. Double-click for zero.`,onDblClick:()=>{st({do:"joint",joint:e,value:0})},"aria-label":`${n.label}, ${n.name}, ${x}`,children:n.label}),w("span",{class:"track",children:[w("input",{type:"range",min:r,max:o,step:l,value:s,"aria-label":`${n.label} slider`,"aria-valuetext":`${n.label}, ${u0(s,i)}, ${u?"over its limit":c?"near its limit":x}`,onPointerDown:()=>t.current=xa(`slider-${e}`),onKeyDown:h,onInput:m=>d(Number(m.currentTarget.value))}),w("svg",{class:"ticks",viewBox:"0 0 100 4",preserveAspectRatio:"none","aria-hidden":"true",children:_.map(m=>{const p=100*(m-r)/a;return w("line",{x1:p,x2:p,y1:"0",y2:"4"},m)})})]}),w(or,{value:s,kind:i,label:`${n.label} value`,onCommit:m=>{st({do:"joint",joint:e,value:m})}}),w("span",{class:"joint-state",title:u?"over its limit":c?"near its limit":"",children:(u||c)&&w(yi,{name:"warn"})})]})}function Ex(){const n=mn.value?.joints??[],e=Ji.value?.unlocked??!1,t=()=>{const i=Array.from(ec.value,(s,r)=>uo(s,ya(n[r]),Ct.value)).join(", ");navigator.clipboard?.writeText(i).then(()=>Kn("Joint values copied","note"),()=>Kn("The clipboard is closed to this page"))};return w("section",{"aria-label":"Joints",children:[w("ul",{class:"joints",children:n.map((i,s)=>w(Sx,{joint:i,index:s},`${mn.value?.revision}-${s}`))}),e&&w("p",{class:"banner",children:[w(yi,{name:"warn"})," Limits are unlocked: joints may go where the arm cannot."]}),w("div",{class:"buttons",children:[w(bt,{icon:"home",label:"Home",keys:"H",text:"Home",onClick:()=>{st({do:"named",to:"home"})}}),w(bt,{icon:"fit",label:"Zero",keys:"0",text:"Zero",onClick:()=>{st({do:"named",to:"zero"})}}),w(bt,{icon:"dice",label:"Random posture within the limits",text:"Random",onClick:()=>{st({do:"named",to:"random"})}}),w(bt,{icon:"copy",label:"Copy the joint values",text:"Copy",onClick:t}),w(bt,{icon:e?"unlock":"lock",label:e?"Lock the limits":"Unlock the limits",pressed:e,onClick:()=>{st({do:"unlock",on:!e})},text:"Limits"})]}),w("button",{type:"button",class:"link",onClick:()=>{st({do:"set_home"}).then(()=>Kn("This posture is home now","note"))},children:"Make this posture home"})]})}const Qh="180",io={ROTATE:0,DOLLY:1,PAN:2},Jr={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},bx=0,Vd=1,wx=2,C_=1,P_=2,as=3,ds=0,Jn=1,Xi=2,Ns=0,so=1,Gd=2,Wd=3,Xd=4,Tx=5,lr=100,Ax=101,Rx=102,Cx=103,Px=104,Dx=200,Lx=201,Ix=202,Ux=203,Ou=204,ku=205,Nx=206,Fx=207,Ox=208,kx=209,Bx=210,zx=211,Hx=212,Vx=213,Gx=214,Bu=0,zu=1,Hu=2,_o=3,Vu=4,Gu=5,Wu=6,Xu=7,ef=0,Wx=1,Xx=2,Fs=0,Yx=1,qx=2,$x=3,D_=4,jx=5,Zx=6,Kx=7,L_=300,go=301,vo=302,Yu=303,qu=304,cc=306,$u=1e3,fr=1001,ju=1002,li=1003,Jx=1004,Xa=1005,Yi=1006,Fc=1007,dr=1008,Ki=1009,I_=1010,U_=1011,Sa=1012,tf=1013,xr=1014,qi=1015,Pa=1016,nf=1017,sf=1018,Ea=1020,N_=35902,F_=35899,O_=1021,k_=1022,Li=1023,ba=1026,wa=1027,rf=1028,of=1029,B_=1030,af=1031,lf=1033,Tl=33776,Al=33777,Rl=33778,Cl=33779,Zu=35840,Ku=35841,Ju=35842,Qu=35843,eh=36196,th=37492,nh=37496,ih=37808,sh=37809,rh=37810,oh=37811,ah=37812,lh=37813,ch=37814,uh=37815,hh=37816,fh=37817,dh=37818,ph=37819,mh=37820,_h=37821,gh=36492,vh=36494,xh=36495,yh=36283,Mh=36284,Sh=36285,Eh=36286,Qx=3200,ey=3201,cf=0,ty=1,Is="",vi="srgb",xo="srgb-linear",Xl="linear",It="srgb",Fr=7680,Yd=519,ny=512,iy=513,sy=514,z_=515,ry=516,oy=517,ay=518,ly=519,qd=35044,cy=35048,$d="300 es",$i=2e3,Yl=2001;class Er{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});const i=this._listeners;i[e]===void 0&&(i[e]=[]),i[e].indexOf(t)===-1&&i[e].push(t)}hasEventListener(e,t){const i=this._listeners;return i===void 0?!1:i[e]!==void 0&&i[e].indexOf(t)!==-1}removeEventListener(e,t){const i=this._listeners;if(i===void 0)return;const s=i[e];if(s!==void 0){const r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){const t=this._listeners;if(t===void 0)return;const i=t[e.type];if(i!==void 0){e.target=this;const s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}}const In=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],Pl=Math.PI/180,bh=180/Math.PI;function Da(){const n=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(In[n&255]+In[n>>8&255]+In[n>>16&255]+In[n>>24&255]+"-"+In[e&255]+In[e>>8&255]+"-"+In[e>>16&15|64]+In[e>>24&255]+"-"+In[t&63|128]+In[t>>8&255]+"-"+In[t>>16&255]+In[t>>24&255]+In[i&255]+In[i>>8&255]+In[i>>16&255]+In[i>>24&255]).toLowerCase()}function ft(n,e,t){return Math.max(e,Math.min(t,n))}function uy(n,e){return(n%e+e)%e}function Oc(n,e,t){return(1-t)*n+t*e}function Bo(n,e){switch(e.constructor){case Float32Array:return n;case Uint32Array:return n/4294967295;case Uint16Array:return n/65535;case Uint8Array:return n/255;case Int32Array:return Math.max(n/2147483647,-1);case Int16Array:return Math.max(n/32767,-1);case Int8Array:return Math.max(n/127,-1);default:throw new Error("Invalid component type.")}}function jn(n,e){switch(e.constructor){case Float32Array:return n;case Uint32Array:return Math.round(n*4294967295);case Uint16Array:return Math.round(n*65535);case Uint8Array:return Math.round(n*255);case Int32Array:return Math.round(n*2147483647);case Int16Array:return Math.round(n*32767);case Int8Array:return Math.round(n*127);default:throw new Error("Invalid component type.")}}const hy={DEG2RAD:Pl};class Ke{constructor(e=0,t=0){Ke.prototype.isVector2=!0,this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){const t=this.x,i=this.y,s=e.elements;return this.x=s[0]*t+s[3]*i+s[6],this.y=s[1]*t+s[4]*i+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=ft(this.x,e.x,t.x),this.y=ft(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=ft(this.x,e,t),this.y=ft(this.y,e,t),this}clampLength(e,t){const i=this.length();return this.divideScalar(i||1).multiplyScalar(ft(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){const t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;const i=this.dot(e)/t;return Math.acos(ft(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){const t=this.x-e.x,i=this.y-e.y;return t*t+i*i}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){const i=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*i-o*s+e.x,this.y=r*s+o*i+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}}class Rn{constructor(e=0,t=0,i=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=i,this._w=s}static slerpFlat(e,t,i,s,r,o,a){let l=i[s+0],c=i[s+1],u=i[s+2],f=i[s+3];const d=r[o+0],h=r[o+1],_=r[o+2],x=r[o+3];if(a===0){e[t+0]=l,e[t+1]=c,e[t+2]=u,e[t+3]=f;return}if(a===1){e[t+0]=d,e[t+1]=h,e[t+2]=_,e[t+3]=x;return}if(f!==x||l!==d||c!==h||u!==_){let m=1-a;const p=l*d+c*h+u*_+f*x,M=p>=0?1:-1,b=1-p*p;if(b>Number.EPSILON){const L=Math.sqrt(b),R=Math.atan2(L,p*M);m=Math.sin(m*R)/L,a=Math.sin(a*R)/L}const v=a*M;if(l=l*m+d*v,c=c*m+h*v,u=u*m+_*v,f=f*m+x*v,m===1-a){const L=1/Math.sqrt(l*l+c*c+u*u+f*f);l*=L,c*=L,u*=L,f*=L}}e[t]=l,e[t+1]=c,e[t+2]=u,e[t+3]=f}static multiplyQuaternionsFlat(e,t,i,s,r,o){const a=i[s],l=i[s+1],c=i[s+2],u=i[s+3],f=r[o],d=r[o+1],h=r[o+2],_=r[o+3];return e[t]=a*_+u*f+l*h-c*d,e[t+1]=l*_+u*d+c*f-a*h,e[t+2]=c*_+u*h+a*d-l*f,e[t+3]=u*_-a*f-l*d-c*h,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,i,s){return this._x=e,this._y=t,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){const i=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(i/2),u=a(s/2),f=a(r/2),d=l(i/2),h=l(s/2),_=l(r/2);switch(o){case"XYZ":this._x=d*u*f+c*h*_,this._y=c*h*f-d*u*_,this._z=c*u*_+d*h*f,this._w=c*u*f-d*h*_;break;case"YXZ":this._x=d*u*f+c*h*_,this._y=c*h*f-d*u*_,this._z=c*u*_-d*h*f,this._w=c*u*f+d*h*_;break;case"ZXY":this._x=d*u*f-c*h*_,this._y=c*h*f+d*u*_,this._z=c*u*_+d*h*f,this._w=c*u*f-d*h*_;break;case"ZYX":this._x=d*u*f-c*h*_,this._y=c*h*f+d*u*_,this._z=c*u*_-d*h*f,this._w=c*u*f+d*h*_;break;case"YZX":this._x=d*u*f+c*h*_,this._y=c*h*f+d*u*_,this._z=c*u*_-d*h*f,this._w=c*u*f-d*h*_;break;case"XZY":this._x=d*u*f-c*h*_,this._y=c*h*f-d*u*_,this._z=c*u*_+d*h*f,this._w=c*u*f+d*h*_;break;default:console.warn("THREE.Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){const i=t/2,s=Math.sin(i);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(e){const t=e.elements,i=t[0],s=t[4],r=t[8],o=t[1],a=t[5],l=t[9],c=t[2],u=t[6],f=t[10],d=i+a+f;if(d>0){const h=.5/Math.sqrt(d+1);this._w=.25/h,this._x=(u-l)*h,this._y=(r-c)*h,this._z=(o-s)*h}else if(i>a&&i>f){const h=2*Math.sqrt(1+i-a-f);this._w=(u-l)/h,this._x=.25*h,this._y=(s+o)/h,this._z=(r+c)/h}else if(a>f){const h=2*Math.sqrt(1+a-i-f);this._w=(r-c)/h,this._x=(s+o)/h,this._y=.25*h,this._z=(l+u)/h}else{const h=2*Math.sqrt(1+f-i-a);this._w=(o-s)/h,this._x=(r+c)/h,this._y=(l+u)/h,this._z=.25*h}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let i=e.dot(t)+1;return i<1e-8?(i=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=i):(this._x=0,this._y=-e.z,this._z=e.y,this._w=i)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=i),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(ft(this.dot(e),-1,1)))}rotateTowards(e,t){const i=this.angleTo(e);if(i===0)return this;const s=Math.min(1,t/i);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){const i=e._x,s=e._y,r=e._z,o=e._w,a=t._x,l=t._y,c=t._z,u=t._w;return this._x=i*u+o*a+s*c-r*l,this._y=s*u+o*l+r*a-i*c,this._z=r*u+o*c+i*l-s*a,this._w=o*u-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){if(t===0)return this;if(t===1)return this.copy(e);const i=this._x,s=this._y,r=this._z,o=this._w;let a=o*e._w+i*e._x+s*e._y+r*e._z;if(a<0?(this._w=-e._w,this._x=-e._x,this._y=-e._y,this._z=-e._z,a=-a):this.copy(e),a>=1)return this._w=o,this._x=i,this._y=s,this._z=r,this;const l=1-a*a;if(l<=Number.EPSILON){const h=1-t;return this._w=h*o+t*this._w,this._x=h*i+t*this._x,this._y=h*s+t*this._y,this._z=h*r+t*this._z,this.normalize(),this}const c=Math.sqrt(l),u=Math.atan2(c,a),f=Math.sin((1-t)*u)/c,d=Math.sin(t*u)/c;return this._w=o*f+this._w*d,this._x=i*f+this._x*d,this._y=s*f+this._y*d,this._z=r*f+this._z*d,this._onChangeCallback(),this}slerpQuaternions(e,t,i){return this.copy(e).slerp(t,i)}random(){const e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}}class k{constructor(e=0,t=0,i=0){k.prototype.isVector3=!0,this.x=e,this.y=t,this.z=i}set(e,t,i){return i===void 0&&(i=this.z),this.x=e,this.y=t,this.z=i,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(jd.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(jd.setFromAxisAngle(e,t))}applyMatrix3(e){const t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*i+r[6]*s,this.y=r[1]*t+r[4]*i+r[7]*s,this.z=r[2]*t+r[5]*i+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){const t=this.x,i=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(e){const t=this.x,i=this.y,s=this.z,r=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*s-a*i),u=2*(a*t-r*s),f=2*(r*i-o*t);return this.x=t+l*c+o*f-a*u,this.y=i+l*u+a*c-r*f,this.z=s+l*f+r*u-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){const t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*i+r[8]*s,this.y=r[1]*t+r[5]*i+r[9]*s,this.z=r[2]*t+r[6]*i+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=ft(this.x,e.x,t.x),this.y=ft(this.y,e.y,t.y),this.z=ft(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=ft(this.x,e,t),this.y=ft(this.y,e,t),this.z=ft(this.z,e,t),this}clampLength(e,t){const i=this.length();return this.divideScalar(i||1).multiplyScalar(ft(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){const i=e.x,s=e.y,r=e.z,o=t.x,a=t.y,l=t.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(e){const t=e.lengthSq();if(t===0)return this.set(0,0,0);const i=e.dot(this)/t;return this.copy(e).multiplyScalar(i)}projectOnPlane(e){return kc.copy(this).projectOnVector(e),this.sub(kc)}reflect(e){return this.sub(kc.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){const t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;const i=this.dot(e)/t;return Math.acos(ft(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){const t=this.x-e.x,i=this.y-e.y,s=this.z-e.z;return t*t+i*i+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,i){const s=Math.sin(t)*e;return this.x=s*Math.sin(i),this.y=Math.cos(t)*e,this.z=s*Math.cos(i),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,i){return this.x=e*Math.sin(t),this.y=i,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){const t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){const t=this.setFromMatrixColumn(e,0).length(),i=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=i,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){const e=Math.random()*Math.PI*2,t=Math.random()*2-1,i=Math.sqrt(1-t*t);return this.x=i*Math.cos(e),this.y=t,this.z=i*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}}const kc=new k,jd=new Rn;class lt{constructor(e,t,i,s,r,o,a,l,c){lt.prototype.isMatrix3=!0,this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c)}set(e,t,i,s,r,o,a,l,c){const u=this.elements;return u[0]=e,u[1]=s,u[2]=a,u[3]=t,u[4]=r,u[5]=l,u[6]=i,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){const t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],this}extractBasis(e,t,i){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(e){const t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){const i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],u=i[4],f=i[7],d=i[2],h=i[5],_=i[8],x=s[0],m=s[3],p=s[6],M=s[1],b=s[4],v=s[7],L=s[2],R=s[5],U=s[8];return r[0]=o*x+a*M+l*L,r[3]=o*m+a*b+l*R,r[6]=o*p+a*v+l*U,r[1]=c*x+u*M+f*L,r[4]=c*m+u*b+f*R,r[7]=c*p+u*v+f*U,r[2]=d*x+h*M+_*L,r[5]=d*m+h*b+_*R,r[8]=d*p+h*v+_*U,this}multiplyScalar(e){const t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){const e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8];return t*o*u-t*a*c-i*r*u+i*a*l+s*r*c-s*o*l}invert(){const e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],f=u*o-a*c,d=a*l-u*r,h=c*r-o*l,_=t*f+i*d+s*h;if(_===0)return this.set(0,0,0,0,0,0,0,0,0);const x=1/_;return e[0]=f*x,e[1]=(s*c-u*i)*x,e[2]=(a*i-s*o)*x,e[3]=d*x,e[4]=(u*t-s*l)*x,e[5]=(s*r-a*t)*x,e[6]=h*x,e[7]=(i*l-c*t)*x,e[8]=(o*t-i*r)*x,this}transpose(){let e;const t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){const t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,i,s,r,o,a){const l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+e,-s*c,s*l,-s*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return this.premultiply(Bc.makeScale(e,t)),this}rotate(e){return this.premultiply(Bc.makeRotation(-e)),this}translate(e,t){return this.premultiply(Bc.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){const t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,i,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){const t=this.elements,i=e.elements;for(let s=0;s<9;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<9;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){const i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e}clone(){return new this.constructor().fromArray(this.elements)}}const Bc=new lt;function H_(n){for(let e=n.length-1;e>=0;--e)if(n[e]>=65535)return!0;return!1}function ql(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function fy(){const n=ql("canvas");return n.style.display="block",n}const Zd={};function Ta(n){n in Zd||(Zd[n]=!0,console.warn(n))}function dy(n,e,t){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(e,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:i()}}setTimeout(r,t)})}const Kd=new lt().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Jd=new lt().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function py(){const n={enabled:!0,workingColorSpace:xo,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===It&&(s.r=hs(s.r),s.g=hs(s.g),s.b=hs(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===It&&(s.r=ro(s.r),s.g=ro(s.g),s.b=ro(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Is?Xl:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[r].toXYZ).multiply(this.spaces[o].fromXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace},fromWorkingColorSpace:function(s,r){return Ta("THREE.ColorManagement: .fromWorkingColorSpace() has been renamed to .workingToColorSpace()."),n.workingToColorSpace(s,r)},toWorkingColorSpace:function(s,r){return Ta("THREE.ColorManagement: .toWorkingColorSpace() has been renamed to .colorSpaceToWorking()."),n.colorSpaceToWorking(s,r)}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[xo]:{primaries:e,whitePoint:i,transfer:Xl,toXYZ:Kd,fromXYZ:Jd,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:vi},outputColorSpaceConfig:{drawingBufferColorSpace:vi}},[vi]:{primaries:e,whitePoint:i,transfer:It,toXYZ:Kd,fromXYZ:Jd,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:vi}}}),n}const xt=py();function hs(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function ro(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}let Or;class my{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let i;if(e instanceof HTMLCanvasElement)i=e;else{Or===void 0&&(Or=ql("canvas")),Or.width=e.width,Or.height=e.height;const s=Or.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),i=Or}return i.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){const t=ql("canvas");t.width=e.width,t.height=e.height;const i=t.getContext("2d");i.drawImage(e,0,0,e.width,e.height);const s=i.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=hs(r[o]/255)*255;return i.putImageData(s,0,0),t}else if(e.data){const t=e.data.slice(0);for(let i=0;i<t.length;i++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[i]=Math.floor(hs(t[i]/255)*255):t[i]=hs(t[i]);return{data:t,width:e.width,height:e.height}}else return console.warn("THREE.ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}}let _y=0;class uf{constructor(e=null){this.isSource=!0,Object.defineProperty(this,"id",{value:_y++}),this.uuid=Da(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){const t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):t instanceof VideoFrame?e.set(t.displayHeight,t.displayWidth,0):t!==null?e.set(t.width,t.height,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){const t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];const i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(zc(s[o].image)):r.push(zc(s[o]))}else r=zc(s);i.url=r}return t||(e.images[this.uuid]=i),i}}function zc(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?my.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(console.warn("THREE.Texture: Unable to serialize Texture."),{})}let gy=0;const Hc=new k;class Yn extends Er{constructor(e=Yn.DEFAULT_IMAGE,t=Yn.DEFAULT_MAPPING,i=fr,s=fr,r=Yi,o=dr,a=Li,l=Ki,c=Yn.DEFAULT_ANISOTROPY,u=Is){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:gy++}),this.uuid=Da(),this.name="",this.source=new uf(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new Ke(0,0),this.repeat=new Ke(1,1),this.center=new Ke(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new lt,this.generateMipmaps=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0}get width(){return this.source.getSize(Hc).x}get height(){return this.source.getSize(Hc).y}get depth(){return this.source.getSize(Hc).z}get image(){return this.source.data}set image(e=null){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(const t in e){const i=e[t];if(i===void 0){console.warn(`THREE.Texture.setValues(): parameter '${t}' has value of undefined.`);continue}const s=this[t];if(s===void 0){console.warn(`THREE.Texture.setValues(): property '${t}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[t]=i}}toJSON(e){const t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];const i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),t||(e.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==L_)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case $u:e.x=e.x-Math.floor(e.x);break;case fr:e.x=e.x<0?0:1;break;case ju:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case $u:e.y=e.y-Math.floor(e.y);break;case fr:e.y=e.y<0?0:1;break;case ju:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}}Yn.DEFAULT_IMAGE=null;Yn.DEFAULT_MAPPING=L_;Yn.DEFAULT_ANISOTROPY=1;class en{constructor(e=0,t=0,i=0,s=1){en.prototype.isVector4=!0,this.x=e,this.y=t,this.z=i,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,i,s){return this.x=e,this.y=t,this.z=i,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){const t=this.x,i=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*i+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);const t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,i,s,r;const l=e.elements,c=l[0],u=l[4],f=l[8],d=l[1],h=l[5],_=l[9],x=l[2],m=l[6],p=l[10];if(Math.abs(u-d)<.01&&Math.abs(f-x)<.01&&Math.abs(_-m)<.01){if(Math.abs(u+d)<.1&&Math.abs(f+x)<.1&&Math.abs(_+m)<.1&&Math.abs(c+h+p-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;const b=(c+1)/2,v=(h+1)/2,L=(p+1)/2,R=(u+d)/4,U=(f+x)/4,N=(_+m)/4;return b>v&&b>L?b<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(b),s=R/i,r=U/i):v>L?v<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(v),i=R/s,r=N/s):L<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(L),i=U/r,s=N/r),this.set(i,s,r,t),this}let M=Math.sqrt((m-_)*(m-_)+(f-x)*(f-x)+(d-u)*(d-u));return Math.abs(M)<.001&&(M=1),this.x=(m-_)/M,this.y=(f-x)/M,this.z=(d-u)/M,this.w=Math.acos((c+h+p-1)/2),this}setFromMatrixPosition(e){const t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=ft(this.x,e.x,t.x),this.y=ft(this.y,e.y,t.y),this.z=ft(this.z,e.z,t.z),this.w=ft(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=ft(this.x,e,t),this.y=ft(this.y,e,t),this.z=ft(this.z,e,t),this.w=ft(this.w,e,t),this}clampLength(e,t){const i=this.length();return this.divideScalar(i||1).multiplyScalar(ft(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this.w=e.w+(t.w-e.w)*i,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}}class vy extends Er{constructor(e=1,t=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Yi,depthBuffer:!0,stencilBuffer:!1,resolveDepthBuffer:!0,resolveStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1},i),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=i.depth,this.scissor=new en(0,0,e,t),this.scissorTest=!1,this.viewport=new en(0,0,e,t);const s={width:e,height:t,depth:i.depth},r=new Yn(s);this.textures=[];const o=i.count;for(let a=0;a<o;a++)this.textures[a]=r.clone(),this.textures[a].isRenderTargetTexture=!0,this.textures[a].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview}_setTextureOptions(e={}){const t={minFilter:Yi,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&(this._depthTexture.renderTarget=null),e!==null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,i=1){if(this.width!==e||this.height!==t||this.depth!==i){this.width=e,this.height=t,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=i,this.textures[s].isArrayTexture=this.textures[s].image.depth>1;this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,i=e.textures.length;t<i;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;const s=Object.assign({},e.textures[t].image);this.textures[t].source=new uf(s)}return this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,e.depthTexture!==null&&(this.depthTexture=e.depthTexture.clone()),this.samples=e.samples,this}dispose(){this.dispatchEvent({type:"dispose"})}}class yr extends vy{constructor(e=1,t=1,i={}){super(e,t,i),this.isWebGLRenderTarget=!0}}class V_ extends Yn{constructor(e=null,t=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=li,this.minFilter=li,this.wrapR=fr,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}}class xy extends Yn{constructor(e=null,t=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=li,this.minFilter=li,this.wrapR=fr,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}}class Hs{constructor(e=new k(1/0,1/0,1/0),t=new k(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t+=3)this.expandByPoint(wi.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,i=e.count;t<i;t++)this.expandByPoint(wi.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){const i=wi.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(i),this.max.copy(e).add(i),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);const i=e.geometry;if(i!==void 0){const r=i.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,wi):wi.fromBufferAttribute(r,o),wi.applyMatrix4(e.matrixWorld),this.expandByPoint(wi);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),Ya.copy(e.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),Ya.copy(i.boundingBox)),Ya.applyMatrix4(e.matrixWorld),this.union(Ya)}const s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,wi),wi.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,i;return e.normal.x>0?(t=e.normal.x*this.min.x,i=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,i=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,i+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,i+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,i+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,i+=e.normal.z*this.min.z),t<=-e.constant&&i>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(zo),qa.subVectors(this.max,zo),kr.subVectors(e.a,zo),Br.subVectors(e.b,zo),zr.subVectors(e.c,zo),Ss.subVectors(Br,kr),Es.subVectors(zr,Br),js.subVectors(kr,zr);let t=[0,-Ss.z,Ss.y,0,-Es.z,Es.y,0,-js.z,js.y,Ss.z,0,-Ss.x,Es.z,0,-Es.x,js.z,0,-js.x,-Ss.y,Ss.x,0,-Es.y,Es.x,0,-js.y,js.x,0];return!Vc(t,kr,Br,zr,qa)||(t=[1,0,0,0,1,0,0,0,1],!Vc(t,kr,Br,zr,qa))?!1:($a.crossVectors(Ss,Es),t=[$a.x,$a.y,$a.z],Vc(t,kr,Br,zr,qa))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,wi).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(wi).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(ns[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),ns[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),ns[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),ns[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),ns[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),ns[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),ns[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),ns[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(ns),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}}const ns=[new k,new k,new k,new k,new k,new k,new k,new k],wi=new k,Ya=new Hs,kr=new k,Br=new k,zr=new k,Ss=new k,Es=new k,js=new k,zo=new k,qa=new k,$a=new k,Zs=new k;function Vc(n,e,t,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){Zs.fromArray(n,r);const a=s.x*Math.abs(Zs.x)+s.y*Math.abs(Zs.y)+s.z*Math.abs(Zs.z),l=e.dot(Zs),c=t.dot(Zs),u=i.dot(Zs);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}const yy=new Hs,Ho=new k,Gc=new k;class br{constructor(e=new k,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){const i=this.center;t!==void 0?i.copy(t):yy.setFromPoints(e).getCenter(i);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,i.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){const t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){const i=this.center.distanceToSquared(e);return t.copy(e),i>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;Ho.subVectors(e,this.center);const t=Ho.lengthSq();if(t>this.radius*this.radius){const i=Math.sqrt(t),s=(i-this.radius)*.5;this.center.addScaledVector(Ho,s/i),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(Gc.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(Ho.copy(e.center).add(Gc)),this.expandByPoint(Ho.copy(e.center).sub(Gc))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}}const is=new k,Wc=new k,ja=new k,bs=new k,Xc=new k,Za=new k,Yc=new k;class uc{constructor(e=new k,t=new k(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,is)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);const i=t.dot(this.direction);return i<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){const t=is.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(is.copy(this.origin).addScaledVector(this.direction,t),is.distanceToSquared(e))}distanceSqToSegment(e,t,i,s){Wc.copy(e).add(t).multiplyScalar(.5),ja.copy(t).sub(e).normalize(),bs.copy(this.origin).sub(Wc);const r=e.distanceTo(t)*.5,o=-this.direction.dot(ja),a=bs.dot(this.direction),l=-bs.dot(ja),c=bs.lengthSq(),u=Math.abs(1-o*o);let f,d,h,_;if(u>0)if(f=o*l-a,d=o*a-l,_=r*u,f>=0)if(d>=-_)if(d<=_){const x=1/u;f*=x,d*=x,h=f*(f+o*d+2*a)+d*(o*f+d+2*l)+c}else d=r,f=Math.max(0,-(o*d+a)),h=-f*f+d*(d+2*l)+c;else d=-r,f=Math.max(0,-(o*d+a)),h=-f*f+d*(d+2*l)+c;else d<=-_?(f=Math.max(0,-(-o*r+a)),d=f>0?-r:Math.min(Math.max(-r,-l),r),h=-f*f+d*(d+2*l)+c):d<=_?(f=0,d=Math.min(Math.max(-r,-l),r),h=d*(d+2*l)+c):(f=Math.max(0,-(o*r+a)),d=f>0?r:Math.min(Math.max(-r,-l),r),h=-f*f+d*(d+2*l)+c);else d=o>0?-r:r,f=Math.max(0,-(o*d+a)),h=-f*f+d*(d+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,f),s&&s.copy(Wc).addScaledVector(ja,d),h}intersectSphere(e,t){is.subVectors(e.center,this.origin);const i=is.dot(this.direction),s=is.dot(is)-i*i,r=e.radius*e.radius;if(s>r)return null;const o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){const t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;const i=-(this.origin.dot(e.normal)+e.constant)/t;return i>=0?i:null}intersectPlane(e,t){const i=this.distanceToPlane(e);return i===null?null:this.at(i,t)}intersectsPlane(e){const t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let i,s,r,o,a,l;const c=1/this.direction.x,u=1/this.direction.y,f=1/this.direction.z,d=this.origin;return c>=0?(i=(e.min.x-d.x)*c,s=(e.max.x-d.x)*c):(i=(e.max.x-d.x)*c,s=(e.min.x-d.x)*c),u>=0?(r=(e.min.y-d.y)*u,o=(e.max.y-d.y)*u):(r=(e.max.y-d.y)*u,o=(e.min.y-d.y)*u),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),f>=0?(a=(e.min.z-d.z)*f,l=(e.max.z-d.z)*f):(a=(e.max.z-d.z)*f,l=(e.min.z-d.z)*f),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,t)}intersectsBox(e){return this.intersectBox(e,is)!==null}intersectTriangle(e,t,i,s,r){Xc.subVectors(t,e),Za.subVectors(i,e),Yc.crossVectors(Xc,Za);let o=this.direction.dot(Yc),a;if(o>0){if(s)return null;a=1}else if(o<0)a=-1,o=-o;else return null;bs.subVectors(this.origin,e);const l=a*this.direction.dot(Za.crossVectors(bs,Za));if(l<0)return null;const c=a*this.direction.dot(Xc.cross(bs));if(c<0||l+c>o)return null;const u=-a*bs.dot(Yc);return u<0?null:this.at(u/o,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}}class Pt{constructor(e,t,i,s,r,o,a,l,c,u,f,d,h,_,x,m){Pt.prototype.isMatrix4=!0,this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c,u,f,d,h,_,x,m)}set(e,t,i,s,r,o,a,l,c,u,f,d,h,_,x,m){const p=this.elements;return p[0]=e,p[4]=t,p[8]=i,p[12]=s,p[1]=r,p[5]=o,p[9]=a,p[13]=l,p[2]=c,p[6]=u,p[10]=f,p[14]=d,p[3]=h,p[7]=_,p[11]=x,p[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new Pt().fromArray(this.elements)}copy(e){const t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],t[9]=i[9],t[10]=i[10],t[11]=i[11],t[12]=i[12],t[13]=i[13],t[14]=i[14],t[15]=i[15],this}copyPosition(e){const t=this.elements,i=e.elements;return t[12]=i[12],t[13]=i[13],t[14]=i[14],this}setFromMatrix3(e){const t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,i){return e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this}makeBasis(e,t,i){return this.set(e.x,t.x,i.x,0,e.y,t.y,i.y,0,e.z,t.z,i.z,0,0,0,0,1),this}extractRotation(e){const t=this.elements,i=e.elements,s=1/Hr.setFromMatrixColumn(e,0).length(),r=1/Hr.setFromMatrixColumn(e,1).length(),o=1/Hr.setFromMatrixColumn(e,2).length();return t[0]=i[0]*s,t[1]=i[1]*s,t[2]=i[2]*s,t[3]=0,t[4]=i[4]*r,t[5]=i[5]*r,t[6]=i[6]*r,t[7]=0,t[8]=i[8]*o,t[9]=i[9]*o,t[10]=i[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){const t=this.elements,i=e.x,s=e.y,r=e.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),f=Math.sin(r);if(e.order==="XYZ"){const d=o*u,h=o*f,_=a*u,x=a*f;t[0]=l*u,t[4]=-l*f,t[8]=c,t[1]=h+_*c,t[5]=d-x*c,t[9]=-a*l,t[2]=x-d*c,t[6]=_+h*c,t[10]=o*l}else if(e.order==="YXZ"){const d=l*u,h=l*f,_=c*u,x=c*f;t[0]=d+x*a,t[4]=_*a-h,t[8]=o*c,t[1]=o*f,t[5]=o*u,t[9]=-a,t[2]=h*a-_,t[6]=x+d*a,t[10]=o*l}else if(e.order==="ZXY"){const d=l*u,h=l*f,_=c*u,x=c*f;t[0]=d-x*a,t[4]=-o*f,t[8]=_+h*a,t[1]=h+_*a,t[5]=o*u,t[9]=x-d*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){const d=o*u,h=o*f,_=a*u,x=a*f;t[0]=l*u,t[4]=_*c-h,t[8]=d*c+x,t[1]=l*f,t[5]=x*c+d,t[9]=h*c-_,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){const d=o*l,h=o*c,_=a*l,x=a*c;t[0]=l*u,t[4]=x-d*f,t[8]=_*f+h,t[1]=f,t[5]=o*u,t[9]=-a*u,t[2]=-c*u,t[6]=h*f+_,t[10]=d-x*f}else if(e.order==="XZY"){const d=o*l,h=o*c,_=a*l,x=a*c;t[0]=l*u,t[4]=-f,t[8]=c*u,t[1]=d*f+x,t[5]=o*u,t[9]=h*f-_,t[2]=_*f-h,t[6]=a*u,t[10]=x*f+d}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(My,e,Sy)}lookAt(e,t,i){const s=this.elements;return ii.subVectors(e,t),ii.lengthSq()===0&&(ii.z=1),ii.normalize(),ws.crossVectors(i,ii),ws.lengthSq()===0&&(Math.abs(i.z)===1?ii.x+=1e-4:ii.z+=1e-4,ii.normalize(),ws.crossVectors(i,ii)),ws.normalize(),Ka.crossVectors(ii,ws),s[0]=ws.x,s[4]=Ka.x,s[8]=ii.x,s[1]=ws.y,s[5]=Ka.y,s[9]=ii.y,s[2]=ws.z,s[6]=Ka.z,s[10]=ii.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){const i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],u=i[1],f=i[5],d=i[9],h=i[13],_=i[2],x=i[6],m=i[10],p=i[14],M=i[3],b=i[7],v=i[11],L=i[15],R=s[0],U=s[4],N=s[8],T=s[12],E=s[1],C=s[5],B=s[9],z=s[13],X=s[2],W=s[6],q=s[10],j=s[14],K=s[3],re=s[7],ae=s[11],me=s[15];return r[0]=o*R+a*E+l*X+c*K,r[4]=o*U+a*C+l*W+c*re,r[8]=o*N+a*B+l*q+c*ae,r[12]=o*T+a*z+l*j+c*me,r[1]=u*R+f*E+d*X+h*K,r[5]=u*U+f*C+d*W+h*re,r[9]=u*N+f*B+d*q+h*ae,r[13]=u*T+f*z+d*j+h*me,r[2]=_*R+x*E+m*X+p*K,r[6]=_*U+x*C+m*W+p*re,r[10]=_*N+x*B+m*q+p*ae,r[14]=_*T+x*z+m*j+p*me,r[3]=M*R+b*E+v*X+L*K,r[7]=M*U+b*C+v*W+L*re,r[11]=M*N+b*B+v*q+L*ae,r[15]=M*T+b*z+v*j+L*me,this}multiplyScalar(e){const t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){const e=this.elements,t=e[0],i=e[4],s=e[8],r=e[12],o=e[1],a=e[5],l=e[9],c=e[13],u=e[2],f=e[6],d=e[10],h=e[14],_=e[3],x=e[7],m=e[11],p=e[15];return _*(+r*l*f-s*c*f-r*a*d+i*c*d+s*a*h-i*l*h)+x*(+t*l*h-t*c*d+r*o*d-s*o*h+s*c*u-r*l*u)+m*(+t*c*f-t*a*h-r*o*f+i*o*h+r*a*u-i*c*u)+p*(-s*a*u-t*l*f+t*a*d+s*o*f-i*o*d+i*l*u)}transpose(){const e=this.elements;let t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,i){const s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=i),this}invert(){const e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],f=e[9],d=e[10],h=e[11],_=e[12],x=e[13],m=e[14],p=e[15],M=f*m*c-x*d*c+x*l*h-a*m*h-f*l*p+a*d*p,b=_*d*c-u*m*c-_*l*h+o*m*h+u*l*p-o*d*p,v=u*x*c-_*f*c+_*a*h-o*x*h-u*a*p+o*f*p,L=_*f*l-u*x*l-_*a*d+o*x*d+u*a*m-o*f*m,R=t*M+i*b+s*v+r*L;if(R===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);const U=1/R;return e[0]=M*U,e[1]=(x*d*r-f*m*r-x*s*h+i*m*h+f*s*p-i*d*p)*U,e[2]=(a*m*r-x*l*r+x*s*c-i*m*c-a*s*p+i*l*p)*U,e[3]=(f*l*r-a*d*r-f*s*c+i*d*c+a*s*h-i*l*h)*U,e[4]=b*U,e[5]=(u*m*r-_*d*r+_*s*h-t*m*h-u*s*p+t*d*p)*U,e[6]=(_*l*r-o*m*r-_*s*c+t*m*c+o*s*p-t*l*p)*U,e[7]=(o*d*r-u*l*r+u*s*c-t*d*c-o*s*h+t*l*h)*U,e[8]=v*U,e[9]=(_*f*r-u*x*r-_*i*h+t*x*h+u*i*p-t*f*p)*U,e[10]=(o*x*r-_*a*r+_*i*c-t*x*c-o*i*p+t*a*p)*U,e[11]=(u*a*r-o*f*r-u*i*c+t*f*c+o*i*h-t*a*h)*U,e[12]=L*U,e[13]=(u*x*s-_*f*s+_*i*d-t*x*d-u*i*m+t*f*m)*U,e[14]=(_*a*s-o*x*s-_*i*l+t*x*l+o*i*m-t*a*m)*U,e[15]=(o*f*s-u*a*s+u*i*l-t*f*l-o*i*d+t*a*d)*U,this}scale(e){const t=this.elements,i=e.x,s=e.y,r=e.z;return t[0]*=i,t[4]*=s,t[8]*=r,t[1]*=i,t[5]*=s,t[9]*=r,t[2]*=i,t[6]*=s,t[10]*=r,t[3]*=i,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){const e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],i=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,i,s))}makeTranslation(e,t,i){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,i,0,0,0,1),this}makeRotationX(e){const t=Math.cos(e),i=Math.sin(e);return this.set(1,0,0,0,0,t,-i,0,0,i,t,0,0,0,0,1),this}makeRotationY(e){const t=Math.cos(e),i=Math.sin(e);return this.set(t,0,i,0,0,1,0,0,-i,0,t,0,0,0,0,1),this}makeRotationZ(e){const t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,0,i,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){const i=Math.cos(t),s=Math.sin(t),r=1-i,o=e.x,a=e.y,l=e.z,c=r*o,u=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,u*a+i,u*l-s*o,0,c*l-s*a,u*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(e,t,i){return this.set(e,0,0,0,0,t,0,0,0,0,i,0,0,0,0,1),this}makeShear(e,t,i,s,r,o){return this.set(1,i,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,i){const s=this.elements,r=t._x,o=t._y,a=t._z,l=t._w,c=r+r,u=o+o,f=a+a,d=r*c,h=r*u,_=r*f,x=o*u,m=o*f,p=a*f,M=l*c,b=l*u,v=l*f,L=i.x,R=i.y,U=i.z;return s[0]=(1-(x+p))*L,s[1]=(h+v)*L,s[2]=(_-b)*L,s[3]=0,s[4]=(h-v)*R,s[5]=(1-(d+p))*R,s[6]=(m+M)*R,s[7]=0,s[8]=(_+b)*U,s[9]=(m-M)*U,s[10]=(1-(d+x))*U,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,i){const s=this.elements;let r=Hr.set(s[0],s[1],s[2]).length();const o=Hr.set(s[4],s[5],s[6]).length(),a=Hr.set(s[8],s[9],s[10]).length();this.determinant()<0&&(r=-r),e.x=s[12],e.y=s[13],e.z=s[14],Ti.copy(this);const c=1/r,u=1/o,f=1/a;return Ti.elements[0]*=c,Ti.elements[1]*=c,Ti.elements[2]*=c,Ti.elements[4]*=u,Ti.elements[5]*=u,Ti.elements[6]*=u,Ti.elements[8]*=f,Ti.elements[9]*=f,Ti.elements[10]*=f,t.setFromRotationMatrix(Ti),i.x=r,i.y=o,i.z=a,this}makePerspective(e,t,i,s,r,o,a=$i,l=!1){const c=this.elements,u=2*r/(t-e),f=2*r/(i-s),d=(t+e)/(t-e),h=(i+s)/(i-s);let _,x;if(l)_=r/(o-r),x=o*r/(o-r);else if(a===$i)_=-(o+r)/(o-r),x=-2*o*r/(o-r);else if(a===Yl)_=-o/(o-r),x=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=d,c[12]=0,c[1]=0,c[5]=f,c[9]=h,c[13]=0,c[2]=0,c[6]=0,c[10]=_,c[14]=x,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,i,s,r,o,a=$i,l=!1){const c=this.elements,u=2/(t-e),f=2/(i-s),d=-(t+e)/(t-e),h=-(i+s)/(i-s);let _,x;if(l)_=1/(o-r),x=o/(o-r);else if(a===$i)_=-2/(o-r),x=-(o+r)/(o-r);else if(a===Yl)_=-1/(o-r),x=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=d,c[1]=0,c[5]=f,c[9]=0,c[13]=h,c[2]=0,c[6]=0,c[10]=_,c[14]=x,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){const t=this.elements,i=e.elements;for(let s=0;s<16;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<16;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){const i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e[t+9]=i[9],e[t+10]=i[10],e[t+11]=i[11],e[t+12]=i[12],e[t+13]=i[13],e[t+14]=i[14],e[t+15]=i[15],e}}const Hr=new k,Ti=new Pt,My=new k(0,0,0),Sy=new k(1,1,1),ws=new k,Ka=new k,ii=new k,Qd=new Pt,ep=new Rn;class Mi{constructor(e=0,t=0,i=0,s=Mi.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=i,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,i,s=this._order){return this._x=e,this._y=t,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,i=!0){const s=e.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],u=s[9],f=s[2],d=s[6],h=s[10];switch(t){case"XYZ":this._y=Math.asin(ft(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,h),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(d,c),this._z=0);break;case"YXZ":this._x=Math.asin(-ft(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,h),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-f,r),this._z=0);break;case"ZXY":this._x=Math.asin(ft(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-f,h),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-ft(f,-1,1)),Math.abs(f)<.9999999?(this._x=Math.atan2(d,h),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(ft(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-f,r)):(this._x=0,this._y=Math.atan2(a,h));break;case"XZY":this._z=Math.asin(-ft(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(d,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,h),this._y=0);break;default:console.warn("THREE.Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,i===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,i){return Qd.makeRotationFromQuaternion(e),this.setFromRotationMatrix(Qd,t,i)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return ep.setFromEuler(this),this.setFromQuaternion(ep,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}}Mi.DEFAULT_ORDER="XYZ";class hf{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}}let Ey=0;const tp=new k,Vr=new Rn,ss=new Pt,Ja=new k,Vo=new k,by=new k,wy=new Rn,np=new k(1,0,0),ip=new k(0,1,0),sp=new k(0,0,1),rp={type:"added"},Ty={type:"removed"},Gr={type:"childadded",child:null},qc={type:"childremoved",child:null};class tn extends Er{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:Ey++}),this.uuid=Da(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=tn.DEFAULT_UP.clone();const e=new k,t=new Mi,i=new Rn,s=new k(1,1,1);function r(){i.setFromEuler(t,!1)}function o(){t.setFromQuaternion(i,void 0,!1)}t._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Pt},normalMatrix:{value:new lt}}),this.matrix=new Pt,this.matrixWorld=new Pt,this.matrixAutoUpdate=tn.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=tn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new hf,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.userData={}}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return Vr.setFromAxisAngle(e,t),this.quaternion.multiply(Vr),this}rotateOnWorldAxis(e,t){return Vr.setFromAxisAngle(e,t),this.quaternion.premultiply(Vr),this}rotateX(e){return this.rotateOnAxis(np,e)}rotateY(e){return this.rotateOnAxis(ip,e)}rotateZ(e){return this.rotateOnAxis(sp,e)}translateOnAxis(e,t){return tp.copy(e).applyQuaternion(this.quaternion),this.position.add(tp.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(np,e)}translateY(e){return this.translateOnAxis(ip,e)}translateZ(e){return this.translateOnAxis(sp,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(ss.copy(this.matrixWorld).invert())}lookAt(e,t,i){e.isVector3?Ja.copy(e):Ja.set(e,t,i);const s=this.parent;this.updateWorldMatrix(!0,!1),Vo.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?ss.lookAt(Vo,Ja,this.up):ss.lookAt(Ja,Vo,this.up),this.quaternion.setFromRotationMatrix(ss),s&&(ss.extractRotation(s.matrixWorld),Vr.setFromRotationMatrix(ss),this.quaternion.premultiply(Vr.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(console.error("THREE.Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(rp),Gr.child=e,this.dispatchEvent(Gr),Gr.child=null):console.error("THREE.Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}const t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(Ty),qc.child=e,this.dispatchEvent(qc),qc.child=null),this}removeFromParent(){const e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),ss.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),ss.multiply(e.parent.matrixWorld)),e.applyMatrix4(ss),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(rp),Gr.child=e,this.dispatchEvent(Gr),Gr.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let i=0,s=this.children.length;i<s;i++){const o=this.children[i].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,i=[]){this[e]===t&&i.push(this);const s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,i);return i}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Vo,e,by),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Vo,wy,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);const t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}traverse(e){e(this);const t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);const t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverseVisible(e)}traverseAncestors(e){const t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale),this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);const t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].updateMatrixWorld(e)}updateWorldMatrix(e,t){const i=this.parent;if(e===!0&&i!==null&&i.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),t===!0){const s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].updateWorldMatrix(!1,!0)}}toJSON(e){const t=e===void 0||typeof e=="string",i={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});const s={};s.uuid=this.uuid,s.type=this.type,this.name!==""&&(s.name=this.name),this.castShadow===!0&&(s.castShadow=!0),this.receiveShadow===!0&&(s.receiveShadow=!0),this.visible===!1&&(s.visible=!1),this.frustumCulled===!1&&(s.frustumCulled=!1),this.renderOrder!==0&&(s.renderOrder=this.renderOrder),Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.matrixAutoUpdate===!1&&(s.matrixAutoUpdate=!1),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);const a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){const l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){const f=l[c];r(e.shapes,f)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){const a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(e.materials,this.material[l]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){const l=this.animations[a];s.animations.push(r(e.animations,l))}}if(t){const a=o(e.geometries),l=o(e.materials),c=o(e.textures),u=o(e.images),f=o(e.shapes),d=o(e.skeletons),h=o(e.animations),_=o(e.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),u.length>0&&(i.images=u),f.length>0&&(i.shapes=f),d.length>0&&(i.skeletons=d),h.length>0&&(i.animations=h),_.length>0&&(i.nodes=_)}return i.object=s,i;function o(a){const l=[];for(const c in a){const u=a[c];delete u.metadata,l.push(u)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let i=0;i<e.children.length;i++){const s=e.children[i];this.add(s.clone())}return this}}tn.DEFAULT_UP=new k(0,1,0);tn.DEFAULT_MATRIX_AUTO_UPDATE=!0;tn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;const Ai=new k,rs=new k,$c=new k,os=new k,Wr=new k,Xr=new k,op=new k,jc=new k,Zc=new k,Kc=new k,Jc=new en,Qc=new en,eu=new en;class Di{constructor(e=new k,t=new k,i=new k){this.a=e,this.b=t,this.c=i}static getNormal(e,t,i,s){s.subVectors(i,t),Ai.subVectors(e,t),s.cross(Ai);const r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,i,s,r){Ai.subVectors(s,t),rs.subVectors(i,t),$c.subVectors(e,t);const o=Ai.dot(Ai),a=Ai.dot(rs),l=Ai.dot($c),c=rs.dot(rs),u=rs.dot($c),f=o*c-a*a;if(f===0)return r.set(0,0,0),null;const d=1/f,h=(c*l-a*u)*d,_=(o*u-a*l)*d;return r.set(1-h-_,_,h)}static containsPoint(e,t,i,s){return this.getBarycoord(e,t,i,s,os)===null?!1:os.x>=0&&os.y>=0&&os.x+os.y<=1}static getInterpolation(e,t,i,s,r,o,a,l){return this.getBarycoord(e,t,i,s,os)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,os.x),l.addScaledVector(o,os.y),l.addScaledVector(a,os.z),l)}static getInterpolatedAttribute(e,t,i,s,r,o){return Jc.setScalar(0),Qc.setScalar(0),eu.setScalar(0),Jc.fromBufferAttribute(e,t),Qc.fromBufferAttribute(e,i),eu.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(Jc,r.x),o.addScaledVector(Qc,r.y),o.addScaledVector(eu,r.z),o}static isFrontFacing(e,t,i,s){return Ai.subVectors(i,t),rs.subVectors(e,t),Ai.cross(rs).dot(s)<0}set(e,t,i){return this.a.copy(e),this.b.copy(t),this.c.copy(i),this}setFromPointsAndIndices(e,t,i,s){return this.a.copy(e[t]),this.b.copy(e[i]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,i,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,i),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return Ai.subVectors(this.c,this.b),rs.subVectors(this.a,this.b),Ai.cross(rs).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return Di.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return Di.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,i,s,r){return Di.getInterpolation(e,this.a,this.b,this.c,t,i,s,r)}containsPoint(e){return Di.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return Di.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){const i=this.a,s=this.b,r=this.c;let o,a;Wr.subVectors(s,i),Xr.subVectors(r,i),jc.subVectors(e,i);const l=Wr.dot(jc),c=Xr.dot(jc);if(l<=0&&c<=0)return t.copy(i);Zc.subVectors(e,s);const u=Wr.dot(Zc),f=Xr.dot(Zc);if(u>=0&&f<=u)return t.copy(s);const d=l*f-u*c;if(d<=0&&l>=0&&u<=0)return o=l/(l-u),t.copy(i).addScaledVector(Wr,o);Kc.subVectors(e,r);const h=Wr.dot(Kc),_=Xr.dot(Kc);if(_>=0&&h<=_)return t.copy(r);const x=h*c-l*_;if(x<=0&&c>=0&&_<=0)return a=c/(c-_),t.copy(i).addScaledVector(Xr,a);const m=u*_-h*f;if(m<=0&&f-u>=0&&h-_>=0)return op.subVectors(r,s),a=(f-u)/(f-u+(h-_)),t.copy(s).addScaledVector(op,a);const p=1/(m+x+d);return o=x*p,a=d*p,t.copy(i).addScaledVector(Wr,o).addScaledVector(Xr,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}}const G_={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Ts={h:0,s:0,l:0},Qa={h:0,s:0,l:0};function tu(n,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?n+(e-n)*6*t:t<1/2?e:t<2/3?n+(e-n)*6*(2/3-t):n}class Je{constructor(e,t,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,i)}set(e,t,i){if(t===void 0&&i===void 0){const s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,i);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=vi){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,xt.colorSpaceToWorking(this,t),this}setRGB(e,t,i,s=xt.workingColorSpace){return this.r=e,this.g=t,this.b=i,xt.colorSpaceToWorking(this,s),this}setHSL(e,t,i,s=xt.workingColorSpace){if(e=uy(e,1),t=ft(t,0,1),i=ft(i,0,1),t===0)this.r=this.g=this.b=i;else{const r=i<=.5?i*(1+t):i+t-i*t,o=2*i-r;this.r=tu(o,r,e+1/3),this.g=tu(o,r,e),this.b=tu(o,r,e-1/3)}return xt.colorSpaceToWorking(this,s),this}setStyle(e,t=vi){function i(r){r!==void 0&&parseFloat(r)<1&&console.warn("THREE.Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r;const o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+)\%\s*,\s*(\d+)\%\s*,\s*(\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseInt(r[1],10))/100,Math.min(100,parseInt(r[2],10))/100,Math.min(100,parseInt(r[3],10))/100,t);break;case"hsl":case"hsla":if(r=/^\s*(\d*\.?\d+)\s*,\s*(\d*\.?\d+)\%\s*,\s*(\d*\.?\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:console.warn("THREE.Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){const r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);console.warn("THREE.Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=vi){const i=G_[e.toLowerCase()];return i!==void 0?this.setHex(i,t):console.warn("THREE.Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=hs(e.r),this.g=hs(e.g),this.b=hs(e.b),this}copyLinearToSRGB(e){return this.r=ro(e.r),this.g=ro(e.g),this.b=ro(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=vi){return xt.workingToColorSpace(Un.copy(this),e),Math.round(ft(Un.r*255,0,255))*65536+Math.round(ft(Un.g*255,0,255))*256+Math.round(ft(Un.b*255,0,255))}getHexString(e=vi){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=xt.workingColorSpace){xt.workingToColorSpace(Un.copy(this),t);const i=Un.r,s=Un.g,r=Un.b,o=Math.max(i,s,r),a=Math.min(i,s,r);let l,c;const u=(a+o)/2;if(a===o)l=0,c=0;else{const f=o-a;switch(c=u<=.5?f/(o+a):f/(2-o-a),o){case i:l=(s-r)/f+(s<r?6:0);break;case s:l=(r-i)/f+2;break;case r:l=(i-s)/f+4;break}l/=6}return e.h=l,e.s=c,e.l=u,e}getRGB(e,t=xt.workingColorSpace){return xt.workingToColorSpace(Un.copy(this),t),e.r=Un.r,e.g=Un.g,e.b=Un.b,e}getStyle(e=vi){xt.workingToColorSpace(Un.copy(this),e);const t=Un.r,i=Un.g,s=Un.b;return e!==vi?`color(${e} ${t.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(e,t,i){return this.getHSL(Ts),this.setHSL(Ts.h+e,Ts.s+t,Ts.l+i)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,i){return this.r=e.r+(t.r-e.r)*i,this.g=e.g+(t.g-e.g)*i,this.b=e.b+(t.b-e.b)*i,this}lerpHSL(e,t){this.getHSL(Ts),e.getHSL(Qa);const i=Oc(Ts.h,Qa.h,t),s=Oc(Ts.s,Qa.s,t),r=Oc(Ts.l,Qa.l,t);return this.setHSL(i,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){const t=this.r,i=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*i+r[6]*s,this.g=r[1]*t+r[4]*i+r[7]*s,this.b=r[2]*t+r[5]*i+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}}const Un=new Je;Je.NAMES=G_;let Ay=0;class Vs extends Er{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:Ay++}),this.uuid=Da(),this.name="",this.type="Material",this.blending=so,this.side=ds,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Ou,this.blendDst=ku,this.blendEquation=lr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new Je(0,0,0),this.blendAlpha=0,this.depthFunc=_o,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Yd,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Fr,this.stencilZFail=Fr,this.stencilZPass=Fr,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(const t in e){const i=e[t];if(i===void 0){console.warn(`THREE.Material: parameter '${t}' has value of undefined.`);continue}const s=this[t];if(s===void 0){console.warn(`THREE.Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[t]=i}}toJSON(e){const t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});const i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,this.name!==""&&(i.name=this.name),this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&this.emissiveIntensity!==1&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessRange!==void 0&&(i.iridescenceThicknessRange=this.iridescenceThicknessRange),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(e).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(e).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(e).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(e).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(e).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&this.attenuationDistance!==1/0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.shadowSide!==null&&(i.shadowSide=this.shadowSide),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),this.blending!==so&&(i.blending=this.blending),this.side!==ds&&(i.side=this.side),this.vertexColors===!0&&(i.vertexColors=!0),this.opacity<1&&(i.opacity=this.opacity),this.transparent===!0&&(i.transparent=!0),this.blendSrc!==Ou&&(i.blendSrc=this.blendSrc),this.blendDst!==ku&&(i.blendDst=this.blendDst),this.blendEquation!==lr&&(i.blendEquation=this.blendEquation),this.blendSrcAlpha!==null&&(i.blendSrcAlpha=this.blendSrcAlpha),this.blendDstAlpha!==null&&(i.blendDstAlpha=this.blendDstAlpha),this.blendEquationAlpha!==null&&(i.blendEquationAlpha=this.blendEquationAlpha),this.blendColor&&this.blendColor.isColor&&(i.blendColor=this.blendColor.getHex()),this.blendAlpha!==0&&(i.blendAlpha=this.blendAlpha),this.depthFunc!==_o&&(i.depthFunc=this.depthFunc),this.depthTest===!1&&(i.depthTest=this.depthTest),this.depthWrite===!1&&(i.depthWrite=this.depthWrite),this.colorWrite===!1&&(i.colorWrite=this.colorWrite),this.stencilWriteMask!==255&&(i.stencilWriteMask=this.stencilWriteMask),this.stencilFunc!==Yd&&(i.stencilFunc=this.stencilFunc),this.stencilRef!==0&&(i.stencilRef=this.stencilRef),this.stencilFuncMask!==255&&(i.stencilFuncMask=this.stencilFuncMask),this.stencilFail!==Fr&&(i.stencilFail=this.stencilFail),this.stencilZFail!==Fr&&(i.stencilZFail=this.stencilZFail),this.stencilZPass!==Fr&&(i.stencilZPass=this.stencilZPass),this.stencilWrite===!0&&(i.stencilWrite=this.stencilWrite),this.rotation!==void 0&&this.rotation!==0&&(i.rotation=this.rotation),this.polygonOffset===!0&&(i.polygonOffset=!0),this.polygonOffsetFactor!==0&&(i.polygonOffsetFactor=this.polygonOffsetFactor),this.polygonOffsetUnits!==0&&(i.polygonOffsetUnits=this.polygonOffsetUnits),this.linewidth!==void 0&&this.linewidth!==1&&(i.linewidth=this.linewidth),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.dithering===!0&&(i.dithering=!0),this.alphaTest>0&&(i.alphaTest=this.alphaTest),this.alphaHash===!0&&(i.alphaHash=!0),this.alphaToCoverage===!0&&(i.alphaToCoverage=!0),this.premultipliedAlpha===!0&&(i.premultipliedAlpha=!0),this.forceSinglePass===!0&&(i.forceSinglePass=!0),this.wireframe===!0&&(i.wireframe=!0),this.wireframeLinewidth>1&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!=="round"&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!=="round"&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading===!0&&(i.flatShading=!0),this.visible===!1&&(i.visible=!1),this.toneMapped===!1&&(i.toneMapped=!1),this.fog===!1&&(i.fog=!1),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){const o=[];for(const a in r){const l=r[a];delete l.metadata,o.push(l)}return o}if(t){const r=s(e.textures),o=s(e.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;const t=e.clippingPlanes;let i=null;if(t!==null){const s=t.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=t[r].clone()}return this.clippingPlanes=i,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}}class hc extends Vs{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new Je(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Mi,this.combine=ef,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}}const an=new k,el=new Ke;let Ry=0;class Pn{constructor(e,t,i=!1){if(Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:Ry++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=i,this.usage=qd,this.updateRanges=[],this.gpuType=qi,this.version=0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this}copyAt(e,t,i){e*=this.itemSize,i*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[i+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,i=this.count;t<i;t++)el.fromBufferAttribute(this,t),el.applyMatrix3(e),this.setXY(t,el.x,el.y);else if(this.itemSize===3)for(let t=0,i=this.count;t<i;t++)an.fromBufferAttribute(this,t),an.applyMatrix3(e),this.setXYZ(t,an.x,an.y,an.z);return this}applyMatrix4(e){for(let t=0,i=this.count;t<i;t++)an.fromBufferAttribute(this,t),an.applyMatrix4(e),this.setXYZ(t,an.x,an.y,an.z);return this}applyNormalMatrix(e){for(let t=0,i=this.count;t<i;t++)an.fromBufferAttribute(this,t),an.applyNormalMatrix(e),this.setXYZ(t,an.x,an.y,an.z);return this}transformDirection(e){for(let t=0,i=this.count;t<i;t++)an.fromBufferAttribute(this,t),an.transformDirection(e),this.setXYZ(t,an.x,an.y,an.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let i=this.array[e*this.itemSize+t];return this.normalized&&(i=Bo(i,this.array)),i}setComponent(e,t,i){return this.normalized&&(i=jn(i,this.array)),this.array[e*this.itemSize+t]=i,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=Bo(t,this.array)),t}setX(e,t){return this.normalized&&(t=jn(t,this.array)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=Bo(t,this.array)),t}setY(e,t){return this.normalized&&(t=jn(t,this.array)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=Bo(t,this.array)),t}setZ(e,t){return this.normalized&&(t=jn(t,this.array)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=Bo(t,this.array)),t}setW(e,t){return this.normalized&&(t=jn(t,this.array)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,i){return e*=this.itemSize,this.normalized&&(t=jn(t,this.array),i=jn(i,this.array)),this.array[e+0]=t,this.array[e+1]=i,this}setXYZ(e,t,i,s){return e*=this.itemSize,this.normalized&&(t=jn(t,this.array),i=jn(i,this.array),s=jn(s,this.array)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this}setXYZW(e,t,i,s,r){return e*=this.itemSize,this.normalized&&(t=jn(t,this.array),i=jn(i,this.array),s=jn(s,this.array),r=jn(r,this.array)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){const e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return this.name!==""&&(e.name=this.name),this.usage!==qd&&(e.usage=this.usage),e}}class W_ extends Pn{constructor(e,t,i){super(new Uint16Array(e),t,i)}}class X_ extends Pn{constructor(e,t,i){super(new Uint32Array(e),t,i)}}class $t extends Pn{constructor(e,t,i){super(new Float32Array(e),t,i)}}let Cy=0;const pi=new Pt,nu=new tn,Yr=new k,si=new Hs,Go=new Hs,wn=new k;class rn extends Er{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:Cy++}),this.uuid=Da(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={}}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(H_(e)?X_:W_)(e,1):this.index=e,this}setIndirect(e){return this.indirect=e,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,i=0){this.groups.push({start:e,count:t,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){const t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);const i=this.attributes.normal;if(i!==void 0){const r=new lt().getNormalMatrix(e);i.applyNormalMatrix(r),i.needsUpdate=!0}const s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this}applyQuaternion(e){return pi.makeRotationFromQuaternion(e),this.applyMatrix4(pi),this}rotateX(e){return pi.makeRotationX(e),this.applyMatrix4(pi),this}rotateY(e){return pi.makeRotationY(e),this.applyMatrix4(pi),this}rotateZ(e){return pi.makeRotationZ(e),this.applyMatrix4(pi),this}translate(e,t,i){return pi.makeTranslation(e,t,i),this.applyMatrix4(pi),this}scale(e,t,i){return pi.makeScale(e,t,i),this.applyMatrix4(pi),this}lookAt(e){return nu.lookAt(e),nu.updateMatrix(),this.applyMatrix4(nu.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Yr).negate(),this.translate(Yr.x,Yr.y,Yr.z),this}setFromPoints(e){const t=this.getAttribute("position");if(t===void 0){const i=[];for(let s=0,r=e.length;s<r;s++){const o=e[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new $t(i,3))}else{const i=Math.min(e.length,t.count);for(let s=0;s<i;s++){const r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&console.warn("THREE.BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Hs);const e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){console.error("THREE.BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new k(-1/0,-1/0,-1/0),new k(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let i=0,s=t.length;i<s;i++){const r=t[i];si.setFromBufferAttribute(r),this.morphTargetsRelative?(wn.addVectors(this.boundingBox.min,si.min),this.boundingBox.expandByPoint(wn),wn.addVectors(this.boundingBox.max,si.max),this.boundingBox.expandByPoint(wn)):(this.boundingBox.expandByPoint(si.min),this.boundingBox.expandByPoint(si.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&console.error('THREE.BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new br);const e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){console.error("THREE.BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new k,1/0);return}if(e){const i=this.boundingSphere.center;if(si.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){const a=t[r];Go.setFromBufferAttribute(a),this.morphTargetsRelative?(wn.addVectors(si.min,Go.min),si.expandByPoint(wn),wn.addVectors(si.max,Go.max),si.expandByPoint(wn)):(si.expandByPoint(Go.min),si.expandByPoint(Go.max))}si.getCenter(i);let s=0;for(let r=0,o=e.count;r<o;r++)wn.fromBufferAttribute(e,r),s=Math.max(s,i.distanceToSquared(wn));if(t)for(let r=0,o=t.length;r<o;r++){const a=t[r],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)wn.fromBufferAttribute(a,c),l&&(Yr.fromBufferAttribute(e,c),wn.add(Yr)),s=Math.max(s,i.distanceToSquared(wn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&console.error('THREE.BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){const e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){console.error("THREE.BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}const i=t.position,s=t.normal,r=t.uv;this.hasAttribute("tangent")===!1&&this.setAttribute("tangent",new Pn(new Float32Array(4*i.count),4));const o=this.getAttribute("tangent"),a=[],l=[];for(let N=0;N<i.count;N++)a[N]=new k,l[N]=new k;const c=new k,u=new k,f=new k,d=new Ke,h=new Ke,_=new Ke,x=new k,m=new k;function p(N,T,E){c.fromBufferAttribute(i,N),u.fromBufferAttribute(i,T),f.fromBufferAttribute(i,E),d.fromBufferAttribute(r,N),h.fromBufferAttribute(r,T),_.fromBufferAttribute(r,E),u.sub(c),f.sub(c),h.sub(d),_.sub(d);const C=1/(h.x*_.y-_.x*h.y);isFinite(C)&&(x.copy(u).multiplyScalar(_.y).addScaledVector(f,-h.y).multiplyScalar(C),m.copy(f).multiplyScalar(h.x).addScaledVector(u,-_.x).multiplyScalar(C),a[N].add(x),a[T].add(x),a[E].add(x),l[N].add(m),l[T].add(m),l[E].add(m))}let M=this.groups;M.length===0&&(M=[{start:0,count:e.count}]);for(let N=0,T=M.length;N<T;++N){const E=M[N],C=E.start,B=E.count;for(let z=C,X=C+B;z<X;z+=3)p(e.getX(z+0),e.getX(z+1),e.getX(z+2))}const b=new k,v=new k,L=new k,R=new k;function U(N){L.fromBufferAttribute(s,N),R.copy(L);const T=a[N];b.copy(T),b.sub(L.multiplyScalar(L.dot(T))).normalize(),v.crossVectors(R,T);const C=v.dot(l[N])<0?-1:1;o.setXYZW(N,b.x,b.y,b.z,C)}for(let N=0,T=M.length;N<T;++N){const E=M[N],C=E.start,B=E.count;for(let z=C,X=C+B;z<X;z+=3)U(e.getX(z+0)),U(e.getX(z+1)),U(e.getX(z+2))}}computeVertexNormals(){const e=this.index,t=this.getAttribute("position");if(t!==void 0){let i=this.getAttribute("normal");if(i===void 0)i=new Pn(new Float32Array(t.count*3),3),this.setAttribute("normal",i);else for(let d=0,h=i.count;d<h;d++)i.setXYZ(d,0,0,0);const s=new k,r=new k,o=new k,a=new k,l=new k,c=new k,u=new k,f=new k;if(e)for(let d=0,h=e.count;d<h;d+=3){const _=e.getX(d+0),x=e.getX(d+1),m=e.getX(d+2);s.fromBufferAttribute(t,_),r.fromBufferAttribute(t,x),o.fromBufferAttribute(t,m),u.subVectors(o,r),f.subVectors(s,r),u.cross(f),a.fromBufferAttribute(i,_),l.fromBufferAttribute(i,x),c.fromBufferAttribute(i,m),a.add(u),l.add(u),c.add(u),i.setXYZ(_,a.x,a.y,a.z),i.setXYZ(x,l.x,l.y,l.z),i.setXYZ(m,c.x,c.y,c.z)}else for(let d=0,h=t.count;d<h;d+=3)s.fromBufferAttribute(t,d+0),r.fromBufferAttribute(t,d+1),o.fromBufferAttribute(t,d+2),u.subVectors(o,r),f.subVectors(s,r),u.cross(f),i.setXYZ(d+0,u.x,u.y,u.z),i.setXYZ(d+1,u.x,u.y,u.z),i.setXYZ(d+2,u.x,u.y,u.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){const e=this.attributes.normal;for(let t=0,i=e.count;t<i;t++)wn.fromBufferAttribute(e,t),wn.normalize(),e.setXYZ(t,wn.x,wn.y,wn.z)}toNonIndexed(){function e(a,l){const c=a.array,u=a.itemSize,f=a.normalized,d=new c.constructor(l.length*u);let h=0,_=0;for(let x=0,m=l.length;x<m;x++){a.isInterleavedBufferAttribute?h=l[x]*a.data.stride+a.offset:h=l[x]*u;for(let p=0;p<u;p++)d[_++]=c[h++]}return new Pn(d,u,f)}if(this.index===null)return console.warn("THREE.BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;const t=new rn,i=this.index.array,s=this.attributes;for(const a in s){const l=s[a],c=e(l,i);t.setAttribute(a,c)}const r=this.morphAttributes;for(const a in r){const l=[],c=r[a];for(let u=0,f=c.length;u<f;u++){const d=c[u],h=e(d,i);l.push(h)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;const o=this.groups;for(let a=0,l=o.length;a<l;a++){const c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){const e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.type,this.name!==""&&(e.name=this.name),Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0){const l=this.parameters;for(const c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};const t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});const i=this.attributes;for(const l in i){const c=i[l];e.data.attributes[l]=c.toJSON(e.data)}const s={};let r=!1;for(const l in this.morphAttributes){const c=this.morphAttributes[l],u=[];for(let f=0,d=c.length;f<d;f++){const h=c[f];u.push(h.toJSON(e.data))}u.length>0&&(s[l]=u,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);const o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));const a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;const t={};this.name=e.name;const i=e.index;i!==null&&this.setIndex(i.clone());const s=e.attributes;for(const c in s){const u=s[c];this.setAttribute(c,u.clone(t))}const r=e.morphAttributes;for(const c in r){const u=[],f=r[c];for(let d=0,h=f.length;d<h;d++)u.push(f[d].clone(t));this.morphAttributes[c]=u}this.morphTargetsRelative=e.morphTargetsRelative;const o=e.groups;for(let c=0,u=o.length;c<u;c++){const f=o[c];this.addGroup(f.start,f.count,f.materialIndex)}const a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());const l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this}dispose(){this.dispatchEvent({type:"dispose"})}}const ap=new Pt,Ks=new uc,tl=new br,lp=new k,nl=new k,il=new k,sl=new k,iu=new k,rl=new k,cp=new k,ol=new k;class be extends tn{constructor(e=new rn,t=new hc){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0&&(this.morphTargetInfluences=e.morphTargetInfluences.slice()),e.morphTargetDictionary!==void 0&&(this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary)),this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){const t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){const s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){const a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){const i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;t.fromBufferAttribute(s,e);const a=this.morphTargetInfluences;if(r&&a){rl.set(0,0,0);for(let l=0,c=r.length;l<c;l++){const u=a[l],f=r[l];u!==0&&(iu.fromBufferAttribute(f,e),o?rl.addScaledVector(iu,u):rl.addScaledVector(iu.sub(t),u))}t.add(rl)}return t}raycast(e,t){const i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),tl.copy(i.boundingSphere),tl.applyMatrix4(r),Ks.copy(e.ray).recast(e.near),!(tl.containsPoint(Ks.origin)===!1&&(Ks.intersectSphere(tl,lp)===null||Ks.origin.distanceToSquared(lp)>(e.far-e.near)**2))&&(ap.copy(r).invert(),Ks.copy(e.ray).applyMatrix4(ap),!(i.boundingBox!==null&&Ks.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(e,t,Ks)))}_computeIntersections(e,t,i){let s;const r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,f=r.attributes.normal,d=r.groups,h=r.drawRange;if(a!==null)if(Array.isArray(o))for(let _=0,x=d.length;_<x;_++){const m=d[_],p=o[m.materialIndex],M=Math.max(m.start,h.start),b=Math.min(a.count,Math.min(m.start+m.count,h.start+h.count));for(let v=M,L=b;v<L;v+=3){const R=a.getX(v),U=a.getX(v+1),N=a.getX(v+2);s=al(this,p,e,i,c,u,f,R,U,N),s&&(s.faceIndex=Math.floor(v/3),s.face.materialIndex=m.materialIndex,t.push(s))}}else{const _=Math.max(0,h.start),x=Math.min(a.count,h.start+h.count);for(let m=_,p=x;m<p;m+=3){const M=a.getX(m),b=a.getX(m+1),v=a.getX(m+2);s=al(this,o,e,i,c,u,f,M,b,v),s&&(s.faceIndex=Math.floor(m/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let _=0,x=d.length;_<x;_++){const m=d[_],p=o[m.materialIndex],M=Math.max(m.start,h.start),b=Math.min(l.count,Math.min(m.start+m.count,h.start+h.count));for(let v=M,L=b;v<L;v+=3){const R=v,U=v+1,N=v+2;s=al(this,p,e,i,c,u,f,R,U,N),s&&(s.faceIndex=Math.floor(v/3),s.face.materialIndex=m.materialIndex,t.push(s))}}else{const _=Math.max(0,h.start),x=Math.min(l.count,h.start+h.count);for(let m=_,p=x;m<p;m+=3){const M=m,b=m+1,v=m+2;s=al(this,o,e,i,c,u,f,M,b,v),s&&(s.faceIndex=Math.floor(m/3),t.push(s))}}}}function Py(n,e,t,i,s,r,o,a){let l;if(e.side===Jn?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,e.side===ds,a),l===null)return null;ol.copy(a),ol.applyMatrix4(n.matrixWorld);const c=t.ray.origin.distanceTo(ol);return c<t.near||c>t.far?null:{distance:c,point:ol.clone(),object:n}}function al(n,e,t,i,s,r,o,a,l,c){n.getVertexPosition(a,nl),n.getVertexPosition(l,il),n.getVertexPosition(c,sl);const u=Py(n,e,t,i,nl,il,sl,cp);if(u){const f=new k;Di.getBarycoord(cp,nl,il,sl,f),s&&(u.uv=Di.getInterpolatedAttribute(s,a,l,c,f,new Ke)),r&&(u.uv1=Di.getInterpolatedAttribute(r,a,l,c,f,new Ke)),o&&(u.normal=Di.getInterpolatedAttribute(o,a,l,c,f,new k),u.normal.dot(i.direction)>0&&u.normal.multiplyScalar(-1));const d={a,b:l,c,normal:new k,materialIndex:0};Di.getNormal(nl,il,sl,d.normal),u.face=d,u.barycoord=f}return u}class ln extends rn{constructor(e=1,t=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};const a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);const l=[],c=[],u=[],f=[];let d=0,h=0;_("z","y","x",-1,-1,i,t,e,o,r,0),_("z","y","x",1,-1,i,t,-e,o,r,1),_("x","z","y",1,1,e,i,t,s,o,2),_("x","z","y",1,-1,e,i,-t,s,o,3),_("x","y","z",1,-1,e,t,i,s,r,4),_("x","y","z",-1,-1,e,t,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new $t(c,3)),this.setAttribute("normal",new $t(u,3)),this.setAttribute("uv",new $t(f,2));function _(x,m,p,M,b,v,L,R,U,N,T){const E=v/U,C=L/N,B=v/2,z=L/2,X=R/2,W=U+1,q=N+1;let j=0,K=0;const re=new k;for(let ae=0;ae<q;ae++){const me=ae*C-z;for(let xe=0;xe<W;xe++){const ge=xe*E-B;re[x]=ge*M,re[m]=me*b,re[p]=X,c.push(re.x,re.y,re.z),re[x]=0,re[m]=0,re[p]=R>0?1:-1,u.push(re.x,re.y,re.z),f.push(xe/U),f.push(1-ae/N),j+=1}}for(let ae=0;ae<N;ae++)for(let me=0;me<U;me++){const xe=d+me+W*ae,ge=d+me+W*(ae+1),Qe=d+(me+1)+W*(ae+1),et=d+(me+1)+W*ae;l.push(xe,ge,et),l.push(ge,Qe,et),K+=6}a.addGroup(h,K,T),h+=K,d+=j}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new ln(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}}function yo(n){const e={};for(const t in n){e[t]={};for(const i in n[t]){const s=n[t][i];s&&(s.isColor||s.isMatrix3||s.isMatrix4||s.isVector2||s.isVector3||s.isVector4||s.isTexture||s.isQuaternion)?s.isRenderTargetTexture?(console.warn("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][i]=null):e[t][i]=s.clone():Array.isArray(s)?e[t][i]=s.slice():e[t][i]=s}}return e}function Wn(n){const e={};for(let t=0;t<n.length;t++){const i=yo(n[t]);for(const s in i)e[s]=i[s]}return e}function Dy(n){const e=[];for(let t=0;t<n.length;t++)e.push(n[t].clone());return e}function Y_(n){const e=n.getRenderTarget();return e===null?n.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:xt.workingColorSpace}const Ly={clone:yo,merge:Wn};var Iy=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,Uy=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`;class ps extends Vs{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=Iy,this.fragmentShader=Uy,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=yo(e.uniforms),this.uniformsGroups=Dy(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this}toJSON(e){const t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(const s in this.uniforms){const o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;const i={};for(const s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(t.extensions=i),t}}class q_ extends tn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Pt,this.projectionMatrix=new Pt,this.projectionMatrixInverse=new Pt,this.coordinateSystem=$i,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorldInverse.copy(this.matrixWorld).invert()}updateWorldMatrix(e,t){super.updateWorldMatrix(e,t),this.matrixWorldInverse.copy(this.matrixWorld).invert()}clone(){return new this.constructor().copy(this)}}const As=new k,up=new Ke,hp=new Ke;class xi extends q_{constructor(e=50,t=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){const t=.5*this.getFilmHeight()/e;this.fov=bh*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){const e=Math.tan(Pl*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return bh*2*Math.atan(Math.tan(Pl*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,i){As.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(As.x,As.y).multiplyScalar(-e/As.z),As.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(As.x,As.y).multiplyScalar(-e/As.z)}getViewSize(e,t){return this.getViewBounds(e,up,hp),t.subVectors(hp,up)}setViewOffset(e,t,i,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){const e=this.near;let t=e*Math.tan(Pl*.5*this.fov)/this.zoom,i=2*t,s=this.aspect*i,r=-.5*s;const o=this.view;if(this.view!==null&&this.view.enabled){const l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,t-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}const a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-i,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){const t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}}const qr=-90,$r=1;class Ny extends tn{constructor(e,t,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;const s=new xi(qr,$r,e,t);s.layers=this.layers,this.add(s);const r=new xi(qr,$r,e,t);r.layers=this.layers,this.add(r);const o=new xi(qr,$r,e,t);o.layers=this.layers,this.add(o);const a=new xi(qr,$r,e,t);a.layers=this.layers,this.add(a);const l=new xi(qr,$r,e,t);l.layers=this.layers,this.add(l);const c=new xi(qr,$r,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){const e=this.coordinateSystem,t=this.children.concat(),[i,s,r,o,a,l]=t;for(const c of t)this.remove(c);if(e===$i)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===Yl)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(const c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();const{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());const[r,o,a,l,c,u]=this.children,f=e.getRenderTarget(),d=e.getActiveCubeFace(),h=e.getActiveMipmapLevel(),_=e.xr.enabled;e.xr.enabled=!1;const x=i.texture.generateMipmaps;i.texture.generateMipmaps=!1,e.setRenderTarget(i,0,s),e.render(t,r),e.setRenderTarget(i,1,s),e.render(t,o),e.setRenderTarget(i,2,s),e.render(t,a),e.setRenderTarget(i,3,s),e.render(t,l),e.setRenderTarget(i,4,s),e.render(t,c),i.texture.generateMipmaps=x,e.setRenderTarget(i,5,s),e.render(t,u),e.setRenderTarget(f,d,h),e.xr.enabled=_,i.texture.needsPMREMUpdate=!0}}class $_ extends Yn{constructor(e=[],t=go,i,s,r,o,a,l,c,u){super(e,t,i,s,r,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}}class Fy extends yr{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;const i={width:e,height:e,depth:1},s=[i,i,i,i,i,i];this.texture=new $_(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;const i={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new ln(5,5,5),r=new ps({name:"CubemapFromEquirect",uniforms:yo(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:Jn,blending:Ns});r.uniforms.tEquirect.value=t;const o=new be(s,r),a=t.minFilter;return t.minFilter===dr&&(t.minFilter=Yi),new Ny(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,i=!0,s=!0){const r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,i,s);e.setRenderTarget(r)}}class ji extends tn{constructor(){super(),this.isGroup=!0,this.type="Group"}}const Oy={type:"move"};class su{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new ji,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new ji,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new k,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new k),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new ji,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new k,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new k),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){const t=this._hand;if(t)for(const i of e.hand.values())this._getHandJoint(t,i)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,i){let s=null,r=null,o=null;const a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(const x of e.hand.values()){const m=t.getJointPose(x,i),p=this._getHandJoint(c,x);m!==null&&(p.matrix.fromArray(m.transform.matrix),p.matrix.decompose(p.position,p.rotation,p.scale),p.matrixWorldNeedsUpdate=!0,p.jointRadius=m.radius),p.visible=m!==null}const u=c.joints["index-finger-tip"],f=c.joints["thumb-tip"],d=u.position.distanceTo(f.position),h=.02,_=.005;c.inputState.pinching&&d>h+_?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&d<=h-_&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.rotation,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1));a!==null&&(s=t.getPose(e.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.rotation,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(Oy)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){const i=new ji;i.matrixAutoUpdate=!1,i.visible=!1,e.joints[t.jointName]=i,e.add(i)}return e.joints[t.jointName]}}class ky extends tn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Mi,this.environmentIntensity=1,this.environmentRotation=new Mi,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),e.background!==null&&(this.background=e.background.clone()),e.environment!==null&&(this.environment=e.environment.clone()),e.fog!==null&&(this.fog=e.fog.clone()),this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),e.overrideMaterial!==null&&(this.overrideMaterial=e.overrideMaterial.clone()),this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){const t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),this.backgroundBlurriness>0&&(t.object.backgroundBlurriness=this.backgroundBlurriness),this.backgroundIntensity!==1&&(t.object.backgroundIntensity=this.backgroundIntensity),t.object.backgroundRotation=this.backgroundRotation.toArray(),this.environmentIntensity!==1&&(t.object.environmentIntensity=this.environmentIntensity),t.object.environmentRotation=this.environmentRotation.toArray(),t}}class By extends Yn{constructor(e=null,t=1,i=1,s,r,o,a,l,c=li,u=li,f,d){super(null,o,a,l,c,u,s,r,f,d),this.isDataTexture=!0,this.image={data:e,width:t,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}}class fp extends Pn{constructor(e,t,i,s=1){super(e,t,i),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}toJSON(){const e=super.toJSON();return e.meshPerAttribute=this.meshPerAttribute,e.isInstancedBufferAttribute=!0,e}}const jr=new Pt,dp=new Pt,ll=[],pp=new Hs,zy=new Pt,Wo=new be,Xo=new br;class Hy extends be{constructor(e,t,i){super(e,t),this.isInstancedMesh=!0,this.instanceMatrix=new fp(new Float32Array(i*16),16),this.instanceColor=null,this.morphTexture=null,this.count=i,this.boundingBox=null,this.boundingSphere=null;for(let s=0;s<i;s++)this.setMatrixAt(s,zy)}computeBoundingBox(){const e=this.geometry,t=this.count;this.boundingBox===null&&(this.boundingBox=new Hs),e.boundingBox===null&&e.computeBoundingBox(),this.boundingBox.makeEmpty();for(let i=0;i<t;i++)this.getMatrixAt(i,jr),pp.copy(e.boundingBox).applyMatrix4(jr),this.boundingBox.union(pp)}computeBoundingSphere(){const e=this.geometry,t=this.count;this.boundingSphere===null&&(this.boundingSphere=new br),e.boundingSphere===null&&e.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let i=0;i<t;i++)this.getMatrixAt(i,jr),Xo.copy(e.boundingSphere).applyMatrix4(jr),this.boundingSphere.union(Xo)}copy(e,t){return super.copy(e,t),this.instanceMatrix.copy(e.instanceMatrix),e.morphTexture!==null&&(this.morphTexture=e.morphTexture.clone()),e.instanceColor!==null&&(this.instanceColor=e.instanceColor.clone()),this.count=e.count,e.boundingBox!==null&&(this.boundingBox=e.boundingBox.clone()),e.boundingSphere!==null&&(this.boundingSphere=e.boundingSphere.clone()),this}getColorAt(e,t){t.fromArray(this.instanceColor.array,e*3)}getMatrixAt(e,t){t.fromArray(this.instanceMatrix.array,e*16)}getMorphAt(e,t){const i=t.morphTargetInfluences,s=this.morphTexture.source.data.data,r=i.length+1,o=e*r+1;for(let a=0;a<i.length;a++)i[a]=s[o+a]}raycast(e,t){const i=this.matrixWorld,s=this.count;if(Wo.geometry=this.geometry,Wo.material=this.material,Wo.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),Xo.copy(this.boundingSphere),Xo.applyMatrix4(i),e.ray.intersectsSphere(Xo)!==!1))for(let r=0;r<s;r++){this.getMatrixAt(r,jr),dp.multiplyMatrices(i,jr),Wo.matrixWorld=dp,Wo.raycast(e,ll);for(let o=0,a=ll.length;o<a;o++){const l=ll[o];l.instanceId=r,l.object=this,t.push(l)}ll.length=0}}setColorAt(e,t){this.instanceColor===null&&(this.instanceColor=new fp(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),t.toArray(this.instanceColor.array,e*3)}setMatrixAt(e,t){t.toArray(this.instanceMatrix.array,e*16)}setMorphAt(e,t){const i=t.morphTargetInfluences,s=i.length+1;this.morphTexture===null&&(this.morphTexture=new By(new Float32Array(s*this.count),s,this.count,rf,qi));const r=this.morphTexture.source.data.data;let o=0;for(let c=0;c<i.length;c++)o+=i[c];const a=this.geometry.morphTargetsRelative?1:1-o,l=s*e;r[l]=a,r.set(i,l+1)}updateMorphTargets(){}dispose(){this.dispatchEvent({type:"dispose"}),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}}const ru=new k,Vy=new k,Gy=new lt;class Ls{constructor(e=new k(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,i,s){return this.normal.set(e,t,i),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,i){const s=ru.subVectors(i,t).cross(Vy.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){const e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t){const i=e.delta(ru),s=this.normal.dot(i);if(s===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;const r=-(e.start.dot(this.normal)+this.constant)/s;return r<0||r>1?null:t.copy(e.start).addScaledVector(i,r)}intersectsLine(e){const t=this.distanceToPoint(e.start),i=this.distanceToPoint(e.end);return t<0&&i>0||i<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){const i=t||Gy.getNormalMatrix(e),s=this.coplanarPoint(ru).applyMatrix4(e),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}}const Js=new br,Wy=new Ke(.5,.5),cl=new k;class ff{constructor(e=new Ls,t=new Ls,i=new Ls,s=new Ls,r=new Ls,o=new Ls){this.planes=[e,t,i,s,r,o]}set(e,t,i,s,r,o){const a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){const t=this.planes;for(let i=0;i<6;i++)t[i].copy(e.planes[i]);return this}setFromProjectionMatrix(e,t=$i,i=!1){const s=this.planes,r=e.elements,o=r[0],a=r[1],l=r[2],c=r[3],u=r[4],f=r[5],d=r[6],h=r[7],_=r[8],x=r[9],m=r[10],p=r[11],M=r[12],b=r[13],v=r[14],L=r[15];if(s[0].setComponents(c-o,h-u,p-_,L-M).normalize(),s[1].setComponents(c+o,h+u,p+_,L+M).normalize(),s[2].setComponents(c+a,h+f,p+x,L+b).normalize(),s[3].setComponents(c-a,h-f,p-x,L-b).normalize(),i)s[4].setComponents(l,d,m,v).normalize(),s[5].setComponents(c-l,h-d,p-m,L-v).normalize();else if(s[4].setComponents(c-l,h-d,p-m,L-v).normalize(),t===$i)s[5].setComponents(c+l,h+d,p+m,L+v).normalize();else if(t===Yl)s[5].setComponents(l,d,m,v).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),Js.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{const t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),Js.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(Js)}intersectsSprite(e){Js.center.set(0,0,0);const t=Wy.distanceTo(e.center);return Js.radius=.7071067811865476+t,Js.applyMatrix4(e.matrixWorld),this.intersectsSphere(Js)}intersectsSphere(e){const t=this.planes,i=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(e){const t=this.planes;for(let i=0;i<6;i++){const s=t[i];if(cl.x=s.normal.x>0?e.max.x:e.min.x,cl.y=s.normal.y>0?e.max.y:e.min.y,cl.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(cl)<0)return!1}return!0}containsPoint(e){const t=this.planes;for(let i=0;i<6;i++)if(t[i].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}}class oo extends Vs{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new Je(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}}const $l=new k,jl=new k,mp=new Pt,Yo=new uc,ul=new br,ou=new k,_p=new k;class _i extends tn{constructor(e=new rn,t=new oo){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){const e=this.geometry;if(e.index===null){const t=e.attributes.position,i=[0];for(let s=1,r=t.count;s<r;s++)$l.fromBufferAttribute(t,s-1),jl.fromBufferAttribute(t,s),i[s]=i[s-1],i[s]+=$l.distanceTo(jl);e.setAttribute("lineDistance",new $t(i,1))}else console.warn("THREE.Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}raycast(e,t){const i=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),ul.copy(i.boundingSphere),ul.applyMatrix4(s),ul.radius+=r,e.ray.intersectsSphere(ul)===!1)return;mp.copy(s).invert(),Yo.copy(e.ray).applyMatrix4(mp);const a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=i.index,d=i.attributes.position;if(u!==null){const h=Math.max(0,o.start),_=Math.min(u.count,o.start+o.count);for(let x=h,m=_-1;x<m;x+=c){const p=u.getX(x),M=u.getX(x+1),b=hl(this,e,Yo,l,p,M,x);b&&t.push(b)}if(this.isLineLoop){const x=u.getX(_-1),m=u.getX(h),p=hl(this,e,Yo,l,x,m,_-1);p&&t.push(p)}}else{const h=Math.max(0,o.start),_=Math.min(d.count,o.start+o.count);for(let x=h,m=_-1;x<m;x+=c){const p=hl(this,e,Yo,l,x,x+1,x);p&&t.push(p)}if(this.isLineLoop){const x=hl(this,e,Yo,l,_-1,h,_-1);x&&t.push(x)}}}updateMorphTargets(){const t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){const s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){const a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}}function hl(n,e,t,i,s,r,o){const a=n.geometry.attributes.position;if($l.fromBufferAttribute(a,s),jl.fromBufferAttribute(a,r),t.distanceSqToSegment($l,jl,ou,_p)>i)return;ou.applyMatrix4(n.matrixWorld);const c=e.ray.origin.distanceTo(ou);if(!(c<e.near||c>e.far))return{distance:c,point:_p.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}const gp=new k,vp=new k;class Xy extends _i{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){const e=this.geometry;if(e.index===null){const t=e.attributes.position,i=[];for(let s=0,r=t.count;s<r;s+=2)gp.fromBufferAttribute(t,s),vp.fromBufferAttribute(t,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+gp.distanceTo(vp);e.setAttribute("lineDistance",new $t(i,1))}else console.warn("THREE.LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}}class Yy extends _i{constructor(e,t){super(e,t),this.isLineLoop=!0,this.type="LineLoop"}}class j_ extends Yn{constructor(e,t,i=xr,s,r,o,a=li,l=li,c,u=ba,f=1){if(u!==ba&&u!==wa)throw new Error("DepthTexture format must be either THREE.DepthFormat or THREE.DepthStencilFormat");const d={width:e,height:t,depth:f};super(d,s,r,o,a,l,u,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new uf(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){const t=super.toJSON(e);return this.compareFunction!==null&&(t.compareFunction=this.compareFunction),t}}class Z_ extends Yn{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}}class Nn extends rn{constructor(e=1,t=1,i=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:e,radiusBottom:t,height:i,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};const c=this;s=Math.floor(s),r=Math.floor(r);const u=[],f=[],d=[],h=[];let _=0;const x=[],m=i/2;let p=0;M(),o===!1&&(e>0&&b(!0),t>0&&b(!1)),this.setIndex(u),this.setAttribute("position",new $t(f,3)),this.setAttribute("normal",new $t(d,3)),this.setAttribute("uv",new $t(h,2));function M(){const v=new k,L=new k;let R=0;const U=(t-e)/i;for(let N=0;N<=r;N++){const T=[],E=N/r,C=E*(t-e)+e;for(let B=0;B<=s;B++){const z=B/s,X=z*l+a,W=Math.sin(X),q=Math.cos(X);L.x=C*W,L.y=-E*i+m,L.z=C*q,f.push(L.x,L.y,L.z),v.set(W,U,q).normalize(),d.push(v.x,v.y,v.z),h.push(z,1-E),T.push(_++)}x.push(T)}for(let N=0;N<s;N++)for(let T=0;T<r;T++){const E=x[T][N],C=x[T+1][N],B=x[T+1][N+1],z=x[T][N+1];(e>0||T!==0)&&(u.push(E,C,z),R+=3),(t>0||T!==r-1)&&(u.push(C,B,z),R+=3)}c.addGroup(p,R,0),p+=R}function b(v){const L=_,R=new Ke,U=new k;let N=0;const T=v===!0?e:t,E=v===!0?1:-1;for(let B=1;B<=s;B++)f.push(0,m*E,0),d.push(0,E,0),h.push(.5,.5),_++;const C=_;for(let B=0;B<=s;B++){const X=B/s*l+a,W=Math.cos(X),q=Math.sin(X);U.x=T*q,U.y=m*E,U.z=T*W,f.push(U.x,U.y,U.z),d.push(0,E,0),R.x=W*.5+.5,R.y=q*.5*E+.5,h.push(R.x,R.y),_++}for(let B=0;B<s;B++){const z=L+B,X=C+B;v===!0?u.push(X,X+1,z):u.push(X+1,X,z),N+=3}c.addGroup(p,N,v===!0?1:2),p+=N}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new Nn(e.radiusTop,e.radiusBottom,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}}class df extends rn{constructor(e=[],t=[],i=1,s=0){super(),this.type="PolyhedronGeometry",this.parameters={vertices:e,indices:t,radius:i,detail:s};const r=[],o=[];a(s),c(i),u(),this.setAttribute("position",new $t(r,3)),this.setAttribute("normal",new $t(r.slice(),3)),this.setAttribute("uv",new $t(o,2)),s===0?this.computeVertexNormals():this.normalizeNormals();function a(M){const b=new k,v=new k,L=new k;for(let R=0;R<t.length;R+=3)h(t[R+0],b),h(t[R+1],v),h(t[R+2],L),l(b,v,L,M)}function l(M,b,v,L){const R=L+1,U=[];for(let N=0;N<=R;N++){U[N]=[];const T=M.clone().lerp(v,N/R),E=b.clone().lerp(v,N/R),C=R-N;for(let B=0;B<=C;B++)B===0&&N===R?U[N][B]=T:U[N][B]=T.clone().lerp(E,B/C)}for(let N=0;N<R;N++)for(let T=0;T<2*(R-N)-1;T++){const E=Math.floor(T/2);T%2===0?(d(U[N][E+1]),d(U[N+1][E]),d(U[N][E])):(d(U[N][E+1]),d(U[N+1][E+1]),d(U[N+1][E]))}}function c(M){const b=new k;for(let v=0;v<r.length;v+=3)b.x=r[v+0],b.y=r[v+1],b.z=r[v+2],b.normalize().multiplyScalar(M),r[v+0]=b.x,r[v+1]=b.y,r[v+2]=b.z}function u(){const M=new k;for(let b=0;b<r.length;b+=3){M.x=r[b+0],M.y=r[b+1],M.z=r[b+2];const v=m(M)/2/Math.PI+.5,L=p(M)/Math.PI+.5;o.push(v,1-L)}_(),f()}function f(){for(let M=0;M<o.length;M+=6){const b=o[M+0],v=o[M+2],L=o[M+4],R=Math.max(b,v,L),U=Math.min(b,v,L);R>.9&&U<.1&&(b<.2&&(o[M+0]+=1),v<.2&&(o[M+2]+=1),L<.2&&(o[M+4]+=1))}}function d(M){r.push(M.x,M.y,M.z)}function h(M,b){const v=M*3;b.x=e[v+0],b.y=e[v+1],b.z=e[v+2]}function _(){const M=new k,b=new k,v=new k,L=new k,R=new Ke,U=new Ke,N=new Ke;for(let T=0,E=0;T<r.length;T+=9,E+=6){M.set(r[T+0],r[T+1],r[T+2]),b.set(r[T+3],r[T+4],r[T+5]),v.set(r[T+6],r[T+7],r[T+8]),R.set(o[E+0],o[E+1]),U.set(o[E+2],o[E+3]),N.set(o[E+4],o[E+5]),L.copy(M).add(b).add(v).divideScalar(3);const C=m(L);x(R,E+0,M,C),x(U,E+2,b,C),x(N,E+4,v,C)}}function x(M,b,v,L){L<0&&M.x===1&&(o[b]=M.x-1),v.x===0&&v.z===0&&(o[b]=L/2/Math.PI+.5)}function m(M){return Math.atan2(M.z,-M.x)}function p(M){return Math.atan2(-M.y,Math.sqrt(M.x*M.x+M.z*M.z))}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new df(e.vertices,e.indices,e.radius,e.details)}}class Qr extends df{constructor(e=1,t=0){const i=[1,0,0,-1,0,0,0,1,0,0,-1,0,0,0,1,0,0,-1],s=[0,2,4,0,4,3,0,3,5,0,5,2,1,2,5,1,5,3,1,3,4,1,4,2];super(i,s,e,t),this.type="OctahedronGeometry",this.parameters={radius:e,detail:t}}static fromJSON(e){return new Qr(e.radius,e.detail)}}class Os extends rn{constructor(e=1,t=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:i,heightSegments:s};const r=e/2,o=t/2,a=Math.floor(i),l=Math.floor(s),c=a+1,u=l+1,f=e/a,d=t/l,h=[],_=[],x=[],m=[];for(let p=0;p<u;p++){const M=p*d-o;for(let b=0;b<c;b++){const v=b*f-r;_.push(v,-M,0),x.push(0,0,1),m.push(b/a),m.push(1-p/l)}}for(let p=0;p<l;p++)for(let M=0;M<a;M++){const b=M+c*p,v=M+c*(p+1),L=M+1+c*(p+1),R=M+1+c*p;h.push(b,v,R),h.push(v,L,R)}this.setIndex(h),this.setAttribute("position",new $t(_,3)),this.setAttribute("normal",new $t(x,3)),this.setAttribute("uv",new $t(m,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new Os(e.width,e.height,e.widthSegments,e.heightSegments)}}class pf extends rn{constructor(e=1,t=32,i=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:e,widthSegments:t,heightSegments:i,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},t=Math.max(3,Math.floor(t)),i=Math.max(2,Math.floor(i));const l=Math.min(o+a,Math.PI);let c=0;const u=[],f=new k,d=new k,h=[],_=[],x=[],m=[];for(let p=0;p<=i;p++){const M=[],b=p/i;let v=0;p===0&&o===0?v=.5/t:p===i&&l===Math.PI&&(v=-.5/t);for(let L=0;L<=t;L++){const R=L/t;f.x=-e*Math.cos(s+R*r)*Math.sin(o+b*a),f.y=e*Math.cos(o+b*a),f.z=e*Math.sin(s+R*r)*Math.sin(o+b*a),_.push(f.x,f.y,f.z),d.copy(f).normalize(),x.push(d.x,d.y,d.z),m.push(R+v,1-b),M.push(c++)}u.push(M)}for(let p=0;p<i;p++)for(let M=0;M<t;M++){const b=u[p][M+1],v=u[p][M],L=u[p+1][M],R=u[p+1][M+1];(p!==0||o>0)&&h.push(b,v,R),(p!==i-1||l<Math.PI)&&h.push(v,L,R)}this.setIndex(h),this.setAttribute("position",new $t(_,3)),this.setAttribute("normal",new $t(x,3)),this.setAttribute("uv",new $t(m,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new pf(e.radius,e.widthSegments,e.heightSegments,e.phiStart,e.phiLength,e.thetaStart,e.thetaLength)}}class cr extends rn{constructor(e=1,t=.4,i=12,s=48,r=Math.PI*2){super(),this.type="TorusGeometry",this.parameters={radius:e,tube:t,radialSegments:i,tubularSegments:s,arc:r},i=Math.floor(i),s=Math.floor(s);const o=[],a=[],l=[],c=[],u=new k,f=new k,d=new k;for(let h=0;h<=i;h++)for(let _=0;_<=s;_++){const x=_/s*r,m=h/i*Math.PI*2;f.x=(e+t*Math.cos(m))*Math.cos(x),f.y=(e+t*Math.cos(m))*Math.sin(x),f.z=t*Math.sin(m),a.push(f.x,f.y,f.z),u.x=e*Math.cos(x),u.y=e*Math.sin(x),d.subVectors(f,u).normalize(),l.push(d.x,d.y,d.z),c.push(_/s),c.push(h/i)}for(let h=1;h<=i;h++)for(let _=1;_<=s;_++){const x=(s+1)*h+_-1,m=(s+1)*(h-1)+_-1,p=(s+1)*(h-1)+_,M=(s+1)*h+_;o.push(x,m,M),o.push(m,p,M)}this.setIndex(o),this.setAttribute("position",new $t(a,3)),this.setAttribute("normal",new $t(l,3)),this.setAttribute("uv",new $t(c,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new cr(e.radius,e.tube,e.radialSegments,e.tubularSegments,e.arc)}}class qy extends Vs{constructor(e){super(),this.isShadowMaterial=!0,this.type="ShadowMaterial",this.color=new Je(0),this.transparent=!0,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.fog=e.fog,this}}class $y extends Vs{constructor(e){super(),this.isMeshStandardMaterial=!0,this.type="MeshStandardMaterial",this.defines={STANDARD:""},this.color=new Je(16777215),this.roughness=1,this.metalness=0,this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new Je(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=cf,this.normalScale=new Ke(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.roughnessMap=null,this.metalnessMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Mi,this.envMapIntensity=1,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.defines={STANDARD:""},this.color.copy(e.color),this.roughness=e.roughness,this.metalness=e.metalness,this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.roughnessMap=e.roughnessMap,this.metalnessMap=e.metalnessMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.envMapIntensity=e.envMapIntensity,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}}class jy extends Vs{constructor(e){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new Je(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new Je(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=cf,this.normalScale=new Ke(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Mi,this.combine=ef,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}}class Zy extends Vs{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Qx,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}}class Ky extends Vs{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}}class K_ extends tn{constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new Je(e),this.intensity=t}dispose(){}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){const t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,this.groundColor!==void 0&&(t.object.groundColor=this.groundColor.getHex()),this.distance!==void 0&&(t.object.distance=this.distance),this.angle!==void 0&&(t.object.angle=this.angle),this.decay!==void 0&&(t.object.decay=this.decay),this.penumbra!==void 0&&(t.object.penumbra=this.penumbra),this.shadow!==void 0&&(t.object.shadow=this.shadow.toJSON()),this.target!==void 0&&(t.object.target=this.target.uuid),t}}class Jy extends K_{constructor(e,t,i){super(e,i),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(tn.DEFAULT_UP),this.updateMatrix(),this.groundColor=new Je(t)}copy(e,t){return super.copy(e,t),this.groundColor.copy(e.groundColor),this}}const au=new Pt,xp=new k,yp=new k;class Qy{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Ke(512,512),this.mapType=Ki,this.map=null,this.mapPass=null,this.matrix=new Pt,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new ff,this._frameExtents=new Ke(1,1),this._viewportCount=1,this._viewports=[new en(0,0,1,1)]}getViewportCount(){return this._viewportCount}getFrustum(){return this._frustum}updateMatrices(e){const t=this.camera,i=this.matrix;xp.setFromMatrixPosition(e.matrixWorld),t.position.copy(xp),yp.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(yp),t.updateMatrixWorld(),au.multiplyMatrices(t.projectionMatrix,t.matrixWorldInverse),this._frustum.setFromProjectionMatrix(au,t.coordinateSystem,t.reversedDepth),t.reversedDepth?i.set(.5,0,0,.5,0,.5,0,.5,0,0,1,0,0,0,0,1):i.set(.5,0,0,.5,0,.5,0,.5,0,0,.5,.5,0,0,0,1),i.multiply(au)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this}clone(){return new this.constructor().copy(this)}toJSON(){const e={};return this.intensity!==1&&(e.intensity=this.intensity),this.bias!==0&&(e.bias=this.bias),this.normalBias!==0&&(e.normalBias=this.normalBias),this.radius!==1&&(e.radius=this.radius),(this.mapSize.x!==512||this.mapSize.y!==512)&&(e.mapSize=this.mapSize.toArray()),e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}}class mf extends q_{constructor(e=-1,t=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){const e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2;let r=i-e,o=i+e,a=s+t,l=s-t;if(this.view!==null&&this.view.enabled){const c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){const t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}}class eM extends Qy{constructor(){super(new mf(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}}class Mp extends K_{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(tn.DEFAULT_UP),this.updateMatrix(),this.target=new tn,this.shadow=new eM}dispose(){this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}}class tM extends xi{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e}}const Sp=new Pt;class J_{constructor(e,t,i=0,s=1/0){this.ray=new uc(e,t),this.near=i,this.far=s,this.camera=null,this.layers=new hf,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(e,t){this.ray.set(e,t)}setFromCamera(e,t){t.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(e.x,e.y,.5).unproject(t).sub(this.ray.origin).normalize(),this.camera=t):t.isOrthographicCamera?(this.ray.origin.set(e.x,e.y,(t.near+t.far)/(t.near-t.far)).unproject(t),this.ray.direction.set(0,0,-1).transformDirection(t.matrixWorld),this.camera=t):console.error("THREE.Raycaster: Unsupported camera type: "+t.type)}setFromXRController(e){return Sp.identity().extractRotation(e.matrixWorld),this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(Sp),this}intersectObject(e,t=!0,i=[]){return wh(e,this,i,t),i.sort(Ep),i}intersectObjects(e,t=!0,i=[]){for(let s=0,r=e.length;s<r;s++)wh(e[s],this,i,t);return i.sort(Ep),i}}function Ep(n,e){return n.distance-e.distance}function wh(n,e,t,i){let s=!0;if(n.layers.test(e.layers)&&n.raycast(e,t)===!1&&(s=!1),s===!0&&i===!0){const r=n.children;for(let o=0,a=r.length;o<a;o++)wh(r[o],e,t,!0)}}class bp{constructor(e=1,t=0,i=0){this.radius=e,this.phi=t,this.theta=i}set(e,t,i){return this.radius=e,this.phi=t,this.theta=i,this}copy(e){return this.radius=e.radius,this.phi=e.phi,this.theta=e.theta,this}makeSafe(){return this.phi=ft(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(e){return this.setFromCartesianCoords(e.x,e.y,e.z)}setFromCartesianCoords(e,t,i){return this.radius=Math.sqrt(e*e+t*t+i*i),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(e,i),this.phi=Math.acos(ft(t/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}}class Q_ extends Xy{constructor(e=1){const t=[0,0,0,e,0,0,0,0,0,0,e,0,0,0,0,0,0,e],i=[1,0,0,1,.6,0,0,1,0,.6,1,0,0,0,1,0,.6,1],s=new rn;s.setAttribute("position",new $t(t,3)),s.setAttribute("color",new $t(i,3));const r=new oo({vertexColors:!0,toneMapped:!1});super(s,r),this.type="AxesHelper"}setColors(e,t,i){const s=new Je,r=this.geometry.attributes.color.array;return s.set(e),s.toArray(r,0),s.toArray(r,3),s.set(t),s.toArray(r,6),s.toArray(r,9),s.set(i),s.toArray(r,12),s.toArray(r,15),this.geometry.attributes.color.needsUpdate=!0,this}dispose(){this.geometry.dispose(),this.material.dispose()}}class eg extends Er{constructor(e,t=null){super(),this.object=e,this.domElement=t,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(e){if(e===void 0){console.warn("THREE.Controls: connect() now requires an element.");return}this.domElement!==null&&this.disconnect(),this.domElement=e}disconnect(){}dispose(){}update(){}}function wp(n,e,t,i){const s=nM(i);switch(t){case O_:return n*e;case rf:return n*e/s.components*s.byteLength;case of:return n*e/s.components*s.byteLength;case B_:return n*e*2/s.components*s.byteLength;case af:return n*e*2/s.components*s.byteLength;case k_:return n*e*3/s.components*s.byteLength;case Li:return n*e*4/s.components*s.byteLength;case lf:return n*e*4/s.components*s.byteLength;case Tl:case Al:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case Rl:case Cl:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Ku:case Qu:return Math.max(n,16)*Math.max(e,8)/4;case Zu:case Ju:return Math.max(n,8)*Math.max(e,8)/2;case eh:case th:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case nh:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case ih:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case sh:return Math.floor((n+4)/5)*Math.floor((e+3)/4)*16;case rh:return Math.floor((n+4)/5)*Math.floor((e+4)/5)*16;case oh:return Math.floor((n+5)/6)*Math.floor((e+4)/5)*16;case ah:return Math.floor((n+5)/6)*Math.floor((e+5)/6)*16;case lh:return Math.floor((n+7)/8)*Math.floor((e+4)/5)*16;case ch:return Math.floor((n+7)/8)*Math.floor((e+5)/6)*16;case uh:return Math.floor((n+7)/8)*Math.floor((e+7)/8)*16;case hh:return Math.floor((n+9)/10)*Math.floor((e+4)/5)*16;case fh:return Math.floor((n+9)/10)*Math.floor((e+5)/6)*16;case dh:return Math.floor((n+9)/10)*Math.floor((e+7)/8)*16;case ph:return Math.floor((n+9)/10)*Math.floor((e+9)/10)*16;case mh:return Math.floor((n+11)/12)*Math.floor((e+9)/10)*16;case _h:return Math.floor((n+11)/12)*Math.floor((e+11)/12)*16;case gh:case vh:case xh:return Math.ceil(n/4)*Math.ceil(e/4)*16;case yh:case Mh:return Math.ceil(n/4)*Math.ceil(e/4)*8;case Sh:case Eh:return Math.ceil(n/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function nM(n){switch(n){case Ki:case I_:return{byteLength:1,components:1};case Sa:case U_:case Pa:return{byteLength:2,components:1};case nf:case sf:return{byteLength:2,components:4};case xr:case tf:case qi:return{byteLength:4,components:1};case N_:case F_:return{byteLength:4,components:3}}throw new Error(`Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:Qh}}));typeof window<"u"&&(window.__THREE__?console.warn("WARNING: Multiple instances of Three.js being imported."):window.__THREE__=Qh);function tg(){let n=null,e=!1,t=null,i=null;function s(r,o){t(r,o),i=n.requestAnimationFrame(s)}return{start:function(){e!==!0&&t!==null&&(i=n.requestAnimationFrame(s),e=!0)},stop:function(){n.cancelAnimationFrame(i),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){n=r}}}function iM(n){const e=new WeakMap;function t(a,l){const c=a.array,u=a.usage,f=c.byteLength,d=n.createBuffer();n.bindBuffer(l,d),n.bufferData(l,c,u),a.onUploadCallback();let h;if(c instanceof Float32Array)h=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)h=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?h=n.HALF_FLOAT:h=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)h=n.SHORT;else if(c instanceof Uint32Array)h=n.UNSIGNED_INT;else if(c instanceof Int32Array)h=n.INT;else if(c instanceof Int8Array)h=n.BYTE;else if(c instanceof Uint8Array)h=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)h=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:d,type:h,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:f}}function i(a,l,c){const u=l.array,f=l.updateRanges;if(n.bindBuffer(c,a),f.length===0)n.bufferSubData(c,0,u);else{f.sort((h,_)=>h.start-_.start);let d=0;for(let h=1;h<f.length;h++){const _=f[d],x=f[h];x.start<=_.start+_.count+1?_.count=Math.max(_.count,x.start+x.count-_.start):(++d,f[d]=x)}f.length=d+1;for(let h=0,_=f.length;h<_;h++){const x=f[h];n.bufferSubData(c,x.start*u.BYTES_PER_ELEMENT,u,x.start,x.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);const l=e.get(a);l&&(n.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){const u=e.get(a);(!u||u.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}const c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var sM=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,rM=`#ifdef USE_ALPHAHASH
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
#endif`,oM=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,aM=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,lM=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,cM=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,uM=`#ifdef USE_AOMAP
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
#endif`,hM=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,fM=`#ifdef USE_BATCHING
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
#endif`,dM=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,pM=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,mM=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,_M=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,gM=`#ifdef USE_IRIDESCENCE
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
#endif`,vM=`#ifdef USE_BUMPMAP
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
#endif`,xM=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,yM=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,MM=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,SM=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,EM=`#if defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#elif defined( USE_COLOR )
	diffuseColor.rgb *= vColor;
#endif`,bM=`#if defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#elif defined( USE_COLOR )
	varying vec3 vColor;
#endif`,wM=`#if defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#elif defined( USE_COLOR ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec3 vColor;
#endif`,TM=`#if defined( USE_COLOR_ALPHA )
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
#endif`,AM=`#define PI 3.141592653589793
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
} // validated`,RM=`#ifdef ENVMAP_TYPE_CUBE_UV
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
#endif`,CM=`vec3 transformedNormal = objectNormal;
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
#endif`,PM=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,DM=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,LM=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,IM=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,UM="gl_FragColor = linearToOutputTexel( gl_FragColor );",NM=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,FM=`#ifdef USE_ENVMAP
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
#endif`,OM=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform float flipEnvMap;
	uniform mat3 envMapRotation;
	#ifdef ENVMAP_TYPE_CUBE
		uniform samplerCube envMap;
	#else
		uniform sampler2D envMap;
	#endif
	
#endif`,kM=`#ifdef USE_ENVMAP
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
#endif`,BM=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,zM=`#ifdef USE_ENVMAP
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
#endif`,HM=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,VM=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,GM=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,WM=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,XM=`#ifdef USE_GRADIENTMAP
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
}`,YM=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,qM=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,$M=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,jM=`uniform bool receiveShadow;
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
#endif`,ZM=`#ifdef USE_ENVMAP
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
#endif`,KM=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,JM=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,QM=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,eS=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,tS=`PhysicalMaterial material;
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
#endif`,nS=`struct PhysicalMaterial {
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
}`,iS=`
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
#endif`,sS=`#if defined( RE_IndirectDiffuse )
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
#endif`,rS=`#if defined( RE_IndirectDiffuse )
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,oS=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,aS=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,lS=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,cS=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,uS=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,hS=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,fS=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,dS=`#if defined( USE_POINTS_UV )
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
#endif`,pS=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,mS=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,_S=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,gS=`#if defined( USE_MORPHCOLORS )
	vColor *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,vS=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,xS=`#ifdef USE_MORPHTARGETS
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
#endif`,yS=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,MS=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,SS=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,ES=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,bS=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,wS=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
	#endif
#endif`,TS=`#ifdef USE_NORMALMAP
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
#endif`,AS=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,RS=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,CS=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,PS=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,DS=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,LS=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,IS=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,US=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,NS=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,FS=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,OS=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,kS=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,BS=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,zS=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,HS=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,VS=`float getShadowMask() {
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
}`,GS=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,WS=`#ifdef USE_SKINNING
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
#endif`,XS=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,YS=`#ifdef USE_SKINNING
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
#endif`,qS=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,$S=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,jS=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,ZS=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,KS=`#ifdef USE_TRANSMISSION
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
#endif`,JS=`#ifdef USE_TRANSMISSION
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
#endif`,QS=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,eE=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,tE=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,nE=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`;const iE=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,sE=`uniform sampler2D t2D;
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
}`,rE=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,oE=`#ifdef ENVMAP_TYPE_CUBE
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
}`,aE=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,lE=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,cE=`#include <common>
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
}`,uE=`#if DEPTH_PACKING == 3200
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
}`,hE=`#define DISTANCE
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
}`,fE=`#define DISTANCE
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
}`,dE=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,pE=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,mE=`uniform float scale;
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
}`,_E=`uniform vec3 diffuse;
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
}`,gE=`#include <common>
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
}`,vE=`uniform vec3 diffuse;
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
}`,xE=`#define LAMBERT
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
}`,yE=`#define LAMBERT
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
}`,ME=`#define MATCAP
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
}`,SE=`#define MATCAP
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
}`,EE=`#define NORMAL
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
}`,bE=`#define NORMAL
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
}`,wE=`#define PHONG
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
}`,TE=`#define PHONG
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
}`,AE=`#define STANDARD
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
}`,RE=`#define STANDARD
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
}`,CE=`#define TOON
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
}`,PE=`#define TOON
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
}`,DE=`uniform float size;
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
}`,LE=`uniform vec3 diffuse;
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
}`,IE=`#include <common>
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
}`,UE=`uniform vec3 color;
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
}`,NE=`uniform float rotation;
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
}`,FE=`uniform vec3 diffuse;
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
}`,ut={alphahash_fragment:sM,alphahash_pars_fragment:rM,alphamap_fragment:oM,alphamap_pars_fragment:aM,alphatest_fragment:lM,alphatest_pars_fragment:cM,aomap_fragment:uM,aomap_pars_fragment:hM,batching_pars_vertex:fM,batching_vertex:dM,begin_vertex:pM,beginnormal_vertex:mM,bsdfs:_M,iridescence_fragment:gM,bumpmap_pars_fragment:vM,clipping_planes_fragment:xM,clipping_planes_pars_fragment:yM,clipping_planes_pars_vertex:MM,clipping_planes_vertex:SM,color_fragment:EM,color_pars_fragment:bM,color_pars_vertex:wM,color_vertex:TM,common:AM,cube_uv_reflection_fragment:RM,defaultnormal_vertex:CM,displacementmap_pars_vertex:PM,displacementmap_vertex:DM,emissivemap_fragment:LM,emissivemap_pars_fragment:IM,colorspace_fragment:UM,colorspace_pars_fragment:NM,envmap_fragment:FM,envmap_common_pars_fragment:OM,envmap_pars_fragment:kM,envmap_pars_vertex:BM,envmap_physical_pars_fragment:ZM,envmap_vertex:zM,fog_vertex:HM,fog_pars_vertex:VM,fog_fragment:GM,fog_pars_fragment:WM,gradientmap_pars_fragment:XM,lightmap_pars_fragment:YM,lights_lambert_fragment:qM,lights_lambert_pars_fragment:$M,lights_pars_begin:jM,lights_toon_fragment:KM,lights_toon_pars_fragment:JM,lights_phong_fragment:QM,lights_phong_pars_fragment:eS,lights_physical_fragment:tS,lights_physical_pars_fragment:nS,lights_fragment_begin:iS,lights_fragment_maps:sS,lights_fragment_end:rS,logdepthbuf_fragment:oS,logdepthbuf_pars_fragment:aS,logdepthbuf_pars_vertex:lS,logdepthbuf_vertex:cS,map_fragment:uS,map_pars_fragment:hS,map_particle_fragment:fS,map_particle_pars_fragment:dS,metalnessmap_fragment:pS,metalnessmap_pars_fragment:mS,morphinstance_vertex:_S,morphcolor_vertex:gS,morphnormal_vertex:vS,morphtarget_pars_vertex:xS,morphtarget_vertex:yS,normal_fragment_begin:MS,normal_fragment_maps:SS,normal_pars_fragment:ES,normal_pars_vertex:bS,normal_vertex:wS,normalmap_pars_fragment:TS,clearcoat_normal_fragment_begin:AS,clearcoat_normal_fragment_maps:RS,clearcoat_pars_fragment:CS,iridescence_pars_fragment:PS,opaque_fragment:DS,packing:LS,premultiplied_alpha_fragment:IS,project_vertex:US,dithering_fragment:NS,dithering_pars_fragment:FS,roughnessmap_fragment:OS,roughnessmap_pars_fragment:kS,shadowmap_pars_fragment:BS,shadowmap_pars_vertex:zS,shadowmap_vertex:HS,shadowmask_pars_fragment:VS,skinbase_vertex:GS,skinning_pars_vertex:WS,skinning_vertex:XS,skinnormal_vertex:YS,specularmap_fragment:qS,specularmap_pars_fragment:$S,tonemapping_fragment:jS,tonemapping_pars_fragment:ZS,transmission_fragment:KS,transmission_pars_fragment:JS,uv_pars_fragment:QS,uv_pars_vertex:eE,uv_vertex:tE,worldpos_vertex:nE,background_vert:iE,background_frag:sE,backgroundCube_vert:rE,backgroundCube_frag:oE,cube_vert:aE,cube_frag:lE,depth_vert:cE,depth_frag:uE,distanceRGBA_vert:hE,distanceRGBA_frag:fE,equirect_vert:dE,equirect_frag:pE,linedashed_vert:mE,linedashed_frag:_E,meshbasic_vert:gE,meshbasic_frag:vE,meshlambert_vert:xE,meshlambert_frag:yE,meshmatcap_vert:ME,meshmatcap_frag:SE,meshnormal_vert:EE,meshnormal_frag:bE,meshphong_vert:wE,meshphong_frag:TE,meshphysical_vert:AE,meshphysical_frag:RE,meshtoon_vert:CE,meshtoon_frag:PE,points_vert:DE,points_frag:LE,shadow_vert:IE,shadow_frag:UE,sprite_vert:NE,sprite_frag:FE},Ee={common:{diffuse:{value:new Je(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new lt},alphaMap:{value:null},alphaMapTransform:{value:new lt},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new lt}},envmap:{envMap:{value:null},envMapRotation:{value:new lt},flipEnvMap:{value:-1},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new lt}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new lt}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new lt},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new lt},normalScale:{value:new Ke(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new lt},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new lt}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new lt}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new lt}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new Je(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMap:{value:[]},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotShadowMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMap:{value:[]},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null}},points:{diffuse:{value:new Je(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new lt},alphaTest:{value:0},uvTransform:{value:new lt}},sprite:{diffuse:{value:new Je(16777215)},opacity:{value:1},center:{value:new Ke(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new lt},alphaMap:{value:null},alphaMapTransform:{value:new lt},alphaTest:{value:0}}},Gi={basic:{uniforms:Wn([Ee.common,Ee.specularmap,Ee.envmap,Ee.aomap,Ee.lightmap,Ee.fog]),vertexShader:ut.meshbasic_vert,fragmentShader:ut.meshbasic_frag},lambert:{uniforms:Wn([Ee.common,Ee.specularmap,Ee.envmap,Ee.aomap,Ee.lightmap,Ee.emissivemap,Ee.bumpmap,Ee.normalmap,Ee.displacementmap,Ee.fog,Ee.lights,{emissive:{value:new Je(0)}}]),vertexShader:ut.meshlambert_vert,fragmentShader:ut.meshlambert_frag},phong:{uniforms:Wn([Ee.common,Ee.specularmap,Ee.envmap,Ee.aomap,Ee.lightmap,Ee.emissivemap,Ee.bumpmap,Ee.normalmap,Ee.displacementmap,Ee.fog,Ee.lights,{emissive:{value:new Je(0)},specular:{value:new Je(1118481)},shininess:{value:30}}]),vertexShader:ut.meshphong_vert,fragmentShader:ut.meshphong_frag},standard:{uniforms:Wn([Ee.common,Ee.envmap,Ee.aomap,Ee.lightmap,Ee.emissivemap,Ee.bumpmap,Ee.normalmap,Ee.displacementmap,Ee.roughnessmap,Ee.metalnessmap,Ee.fog,Ee.lights,{emissive:{value:new Je(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:ut.meshphysical_vert,fragmentShader:ut.meshphysical_frag},toon:{uniforms:Wn([Ee.common,Ee.aomap,Ee.lightmap,Ee.emissivemap,Ee.bumpmap,Ee.normalmap,Ee.displacementmap,Ee.gradientmap,Ee.fog,Ee.lights,{emissive:{value:new Je(0)}}]),vertexShader:ut.meshtoon_vert,fragmentShader:ut.meshtoon_frag},matcap:{uniforms:Wn([Ee.common,Ee.bumpmap,Ee.normalmap,Ee.displacementmap,Ee.fog,{matcap:{value:null}}]),vertexShader:ut.meshmatcap_vert,fragmentShader:ut.meshmatcap_frag},points:{uniforms:Wn([Ee.points,Ee.fog]),vertexShader:ut.points_vert,fragmentShader:ut.points_frag},dashed:{uniforms:Wn([Ee.common,Ee.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:ut.linedashed_vert,fragmentShader:ut.linedashed_frag},depth:{uniforms:Wn([Ee.common,Ee.displacementmap]),vertexShader:ut.depth_vert,fragmentShader:ut.depth_frag},normal:{uniforms:Wn([Ee.common,Ee.bumpmap,Ee.normalmap,Ee.displacementmap,{opacity:{value:1}}]),vertexShader:ut.meshnormal_vert,fragmentShader:ut.meshnormal_frag},sprite:{uniforms:Wn([Ee.sprite,Ee.fog]),vertexShader:ut.sprite_vert,fragmentShader:ut.sprite_frag},background:{uniforms:{uvTransform:{value:new lt},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:ut.background_vert,fragmentShader:ut.background_frag},backgroundCube:{uniforms:{envMap:{value:null},flipEnvMap:{value:-1},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new lt}},vertexShader:ut.backgroundCube_vert,fragmentShader:ut.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:ut.cube_vert,fragmentShader:ut.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:ut.equirect_vert,fragmentShader:ut.equirect_frag},distanceRGBA:{uniforms:Wn([Ee.common,Ee.displacementmap,{referencePosition:{value:new k},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:ut.distanceRGBA_vert,fragmentShader:ut.distanceRGBA_frag},shadow:{uniforms:Wn([Ee.lights,Ee.fog,{color:{value:new Je(0)},opacity:{value:1}}]),vertexShader:ut.shadow_vert,fragmentShader:ut.shadow_frag}};Gi.physical={uniforms:Wn([Gi.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new lt},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new lt},clearcoatNormalScale:{value:new Ke(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new lt},dispersion:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new lt},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new lt},sheen:{value:0},sheenColor:{value:new Je(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new lt},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new lt},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new lt},transmissionSamplerSize:{value:new Ke},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new lt},attenuationDistance:{value:0},attenuationColor:{value:new Je(0)},specularColor:{value:new Je(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new lt},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new lt},anisotropyVector:{value:new Ke},anisotropyMap:{value:null},anisotropyMapTransform:{value:new lt}}]),vertexShader:ut.meshphysical_vert,fragmentShader:ut.meshphysical_frag};const fl={r:0,b:0,g:0},Qs=new Mi,OE=new Pt;function kE(n,e,t,i,s,r,o){const a=new Je(0);let l=r===!0?0:1,c,u,f=null,d=0,h=null;function _(b){let v=b.isScene===!0?b.background:null;return v&&v.isTexture&&(v=(b.backgroundBlurriness>0?t:e).get(v)),v}function x(b){let v=!1;const L=_(b);L===null?p(a,l):L&&L.isColor&&(p(L,1),v=!0);const R=n.xr.getEnvironmentBlendMode();R==="additive"?i.buffers.color.setClear(0,0,0,1,o):R==="alpha-blend"&&i.buffers.color.setClear(0,0,0,0,o),(n.autoClear||v)&&(i.buffers.depth.setTest(!0),i.buffers.depth.setMask(!0),i.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function m(b,v){const L=_(v);L&&(L.isCubeTexture||L.mapping===cc)?(u===void 0&&(u=new be(new ln(1,1,1),new ps({name:"BackgroundCubeMaterial",uniforms:yo(Gi.backgroundCube.uniforms),vertexShader:Gi.backgroundCube.vertexShader,fragmentShader:Gi.backgroundCube.fragmentShader,side:Jn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),u.geometry.deleteAttribute("normal"),u.geometry.deleteAttribute("uv"),u.onBeforeRender=function(R,U,N){this.matrixWorld.copyPosition(N.matrixWorld)},Object.defineProperty(u.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),s.update(u)),Qs.copy(v.backgroundRotation),Qs.x*=-1,Qs.y*=-1,Qs.z*=-1,L.isCubeTexture&&L.isRenderTargetTexture===!1&&(Qs.y*=-1,Qs.z*=-1),u.material.uniforms.envMap.value=L,u.material.uniforms.flipEnvMap.value=L.isCubeTexture&&L.isRenderTargetTexture===!1?-1:1,u.material.uniforms.backgroundBlurriness.value=v.backgroundBlurriness,u.material.uniforms.backgroundIntensity.value=v.backgroundIntensity,u.material.uniforms.backgroundRotation.value.setFromMatrix4(OE.makeRotationFromEuler(Qs)),u.material.toneMapped=xt.getTransfer(L.colorSpace)!==It,(f!==L||d!==L.version||h!==n.toneMapping)&&(u.material.needsUpdate=!0,f=L,d=L.version,h=n.toneMapping),u.layers.enableAll(),b.unshift(u,u.geometry,u.material,0,0,null)):L&&L.isTexture&&(c===void 0&&(c=new be(new Os(2,2),new ps({name:"BackgroundMaterial",uniforms:yo(Gi.background.uniforms),vertexShader:Gi.background.vertexShader,fragmentShader:Gi.background.fragmentShader,side:ds,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),Object.defineProperty(c.material,"map",{get:function(){return this.uniforms.t2D.value}}),s.update(c)),c.material.uniforms.t2D.value=L,c.material.uniforms.backgroundIntensity.value=v.backgroundIntensity,c.material.toneMapped=xt.getTransfer(L.colorSpace)!==It,L.matrixAutoUpdate===!0&&L.updateMatrix(),c.material.uniforms.uvTransform.value.copy(L.matrix),(f!==L||d!==L.version||h!==n.toneMapping)&&(c.material.needsUpdate=!0,f=L,d=L.version,h=n.toneMapping),c.layers.enableAll(),b.unshift(c,c.geometry,c.material,0,0,null))}function p(b,v){b.getRGB(fl,Y_(n)),i.buffers.color.setClear(fl.r,fl.g,fl.b,v,o)}function M(){u!==void 0&&(u.geometry.dispose(),u.material.dispose(),u=void 0),c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0)}return{getClearColor:function(){return a},setClearColor:function(b,v=1){a.set(b),l=v,p(a,l)},getClearAlpha:function(){return l},setClearAlpha:function(b){l=b,p(a,l)},render:x,addToRenderList:m,dispose:M}}function BE(n,e){const t=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=d(null);let r=s,o=!1;function a(E,C,B,z,X){let W=!1;const q=f(z,B,C);r!==q&&(r=q,c(r.object)),W=h(E,z,B,X),W&&_(E,z,B,X),X!==null&&e.update(X,n.ELEMENT_ARRAY_BUFFER),(W||o)&&(o=!1,v(E,C,B,z),X!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,e.get(X).buffer))}function l(){return n.createVertexArray()}function c(E){return n.bindVertexArray(E)}function u(E){return n.deleteVertexArray(E)}function f(E,C,B){const z=B.wireframe===!0;let X=i[E.id];X===void 0&&(X={},i[E.id]=X);let W=X[C.id];W===void 0&&(W={},X[C.id]=W);let q=W[z];return q===void 0&&(q=d(l()),W[z]=q),q}function d(E){const C=[],B=[],z=[];for(let X=0;X<t;X++)C[X]=0,B[X]=0,z[X]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:C,enabledAttributes:B,attributeDivisors:z,object:E,attributes:{},index:null}}function h(E,C,B,z){const X=r.attributes,W=C.attributes;let q=0;const j=B.getAttributes();for(const K in j)if(j[K].location>=0){const ae=X[K];let me=W[K];if(me===void 0&&(K==="instanceMatrix"&&E.instanceMatrix&&(me=E.instanceMatrix),K==="instanceColor"&&E.instanceColor&&(me=E.instanceColor)),ae===void 0||ae.attribute!==me||me&&ae.data!==me.data)return!0;q++}return r.attributesNum!==q||r.index!==z}function _(E,C,B,z){const X={},W=C.attributes;let q=0;const j=B.getAttributes();for(const K in j)if(j[K].location>=0){let ae=W[K];ae===void 0&&(K==="instanceMatrix"&&E.instanceMatrix&&(ae=E.instanceMatrix),K==="instanceColor"&&E.instanceColor&&(ae=E.instanceColor));const me={};me.attribute=ae,ae&&ae.data&&(me.data=ae.data),X[K]=me,q++}r.attributes=X,r.attributesNum=q,r.index=z}function x(){const E=r.newAttributes;for(let C=0,B=E.length;C<B;C++)E[C]=0}function m(E){p(E,0)}function p(E,C){const B=r.newAttributes,z=r.enabledAttributes,X=r.attributeDivisors;B[E]=1,z[E]===0&&(n.enableVertexAttribArray(E),z[E]=1),X[E]!==C&&(n.vertexAttribDivisor(E,C),X[E]=C)}function M(){const E=r.newAttributes,C=r.enabledAttributes;for(let B=0,z=C.length;B<z;B++)C[B]!==E[B]&&(n.disableVertexAttribArray(B),C[B]=0)}function b(E,C,B,z,X,W,q){q===!0?n.vertexAttribIPointer(E,C,B,X,W):n.vertexAttribPointer(E,C,B,z,X,W)}function v(E,C,B,z){x();const X=z.attributes,W=B.getAttributes(),q=C.defaultAttributeValues;for(const j in W){const K=W[j];if(K.location>=0){let re=X[j];if(re===void 0&&(j==="instanceMatrix"&&E.instanceMatrix&&(re=E.instanceMatrix),j==="instanceColor"&&E.instanceColor&&(re=E.instanceColor)),re!==void 0){const ae=re.normalized,me=re.itemSize,xe=e.get(re);if(xe===void 0)continue;const ge=xe.buffer,Qe=xe.type,et=xe.bytesPerElement,ee=Qe===n.INT||Qe===n.UNSIGNED_INT||re.gpuType===tf;if(re.isInterleavedBufferAttribute){const ne=re.data,we=ne.stride,ze=re.offset;if(ne.isInstancedInterleavedBuffer){for(let ye=0;ye<K.locationSize;ye++)p(K.location+ye,ne.meshPerAttribute);E.isInstancedMesh!==!0&&z._maxInstanceCount===void 0&&(z._maxInstanceCount=ne.meshPerAttribute*ne.count)}else for(let ye=0;ye<K.locationSize;ye++)m(K.location+ye);n.bindBuffer(n.ARRAY_BUFFER,ge);for(let ye=0;ye<K.locationSize;ye++)b(K.location+ye,me/K.locationSize,Qe,ae,we*et,(ze+me/K.locationSize*ye)*et,ee)}else{if(re.isInstancedBufferAttribute){for(let ne=0;ne<K.locationSize;ne++)p(K.location+ne,re.meshPerAttribute);E.isInstancedMesh!==!0&&z._maxInstanceCount===void 0&&(z._maxInstanceCount=re.meshPerAttribute*re.count)}else for(let ne=0;ne<K.locationSize;ne++)m(K.location+ne);n.bindBuffer(n.ARRAY_BUFFER,ge);for(let ne=0;ne<K.locationSize;ne++)b(K.location+ne,me/K.locationSize,Qe,ae,me*et,me/K.locationSize*ne*et,ee)}}else if(q!==void 0){const ae=q[j];if(ae!==void 0)switch(ae.length){case 2:n.vertexAttrib2fv(K.location,ae);break;case 3:n.vertexAttrib3fv(K.location,ae);break;case 4:n.vertexAttrib4fv(K.location,ae);break;default:n.vertexAttrib1fv(K.location,ae)}}}}M()}function L(){N();for(const E in i){const C=i[E];for(const B in C){const z=C[B];for(const X in z)u(z[X].object),delete z[X];delete C[B]}delete i[E]}}function R(E){if(i[E.id]===void 0)return;const C=i[E.id];for(const B in C){const z=C[B];for(const X in z)u(z[X].object),delete z[X];delete C[B]}delete i[E.id]}function U(E){for(const C in i){const B=i[C];if(B[E.id]===void 0)continue;const z=B[E.id];for(const X in z)u(z[X].object),delete z[X];delete B[E.id]}}function N(){T(),o=!0,r!==s&&(r=s,c(r.object))}function T(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:N,resetDefaultState:T,dispose:L,releaseStatesOfGeometry:R,releaseStatesOfProgram:U,initAttributes:x,enableAttribute:m,disableUnusedAttributes:M}}function zE(n,e,t){let i;function s(c){i=c}function r(c,u){n.drawArrays(i,c,u),t.update(u,i,1)}function o(c,u,f){f!==0&&(n.drawArraysInstanced(i,c,u,f),t.update(u,i,f))}function a(c,u,f){if(f===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,c,0,u,0,f);let h=0;for(let _=0;_<f;_++)h+=u[_];t.update(h,i,1)}function l(c,u,f,d){if(f===0)return;const h=e.get("WEBGL_multi_draw");if(h===null)for(let _=0;_<c.length;_++)o(c[_],u[_],d[_]);else{h.multiDrawArraysInstancedWEBGL(i,c,0,u,0,d,0,f);let _=0;for(let x=0;x<f;x++)_+=u[x]*d[x];t.update(_,i,1)}}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a,this.renderMultiDrawInstances=l}function HE(n,e,t,i){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){const U=e.get("EXT_texture_filter_anisotropic");s=n.getParameter(U.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(U){return!(U!==Li&&i.convert(U)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(U){const N=U===Pa&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(U!==Ki&&i.convert(U)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE)&&U!==qi&&!N)}function l(U){if(U==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";U="mediump"}return U==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp";const u=l(c);u!==c&&(console.warn("THREE.WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);const f=t.logarithmicDepthBuffer===!0,d=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),h=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),_=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),x=n.getParameter(n.MAX_TEXTURE_SIZE),m=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),p=n.getParameter(n.MAX_VERTEX_ATTRIBS),M=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),b=n.getParameter(n.MAX_VARYING_VECTORS),v=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),L=_>0,R=n.getParameter(n.MAX_SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:f,reversedDepthBuffer:d,maxTextures:h,maxVertexTextures:_,maxTextureSize:x,maxCubemapSize:m,maxAttributes:p,maxVertexUniforms:M,maxVaryings:b,maxFragmentUniforms:v,vertexTextures:L,maxSamples:R}}function VE(n){const e=this;let t=null,i=0,s=!1,r=!1;const o=new Ls,a=new lt,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(f,d){const h=f.length!==0||d||i!==0||s;return s=d,i=f.length,h},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(f,d){t=u(f,d,0)},this.setState=function(f,d,h){const _=f.clippingPlanes,x=f.clipIntersection,m=f.clipShadows,p=n.get(f);if(!s||_===null||_.length===0||r&&!m)r?u(null):c();else{const M=r?0:i,b=M*4;let v=p.clippingState||null;l.value=v,v=u(_,d,b,h);for(let L=0;L!==b;++L)v[L]=t[L];p.clippingState=v,this.numIntersection=x?this.numPlanes:0,this.numPlanes+=M}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=i>0),e.numPlanes=i,e.numIntersection=0}function u(f,d,h,_){const x=f!==null?f.length:0;let m=null;if(x!==0){if(m=l.value,_!==!0||m===null){const p=h+x*4,M=d.matrixWorldInverse;a.getNormalMatrix(M),(m===null||m.length<p)&&(m=new Float32Array(p));for(let b=0,v=h;b!==x;++b,v+=4)o.copy(f[b]).applyMatrix4(M,a),o.normal.toArray(m,v),m[v+3]=o.constant}l.value=m,l.needsUpdate=!0}return e.numPlanes=x,e.numIntersection=0,m}}function GE(n){let e=new WeakMap;function t(o,a){return a===Yu?o.mapping=go:a===qu&&(o.mapping=vo),o}function i(o){if(o&&o.isTexture){const a=o.mapping;if(a===Yu||a===qu)if(e.has(o)){const l=e.get(o).texture;return t(l,o.mapping)}else{const l=o.image;if(l&&l.height>0){const c=new Fy(l.height);return c.fromEquirectangularTexture(n,o),e.set(o,c),o.addEventListener("dispose",s),t(c.texture,o.mapping)}else return null}}return o}function s(o){const a=o.target;a.removeEventListener("dispose",s);const l=e.get(a);l!==void 0&&(e.delete(a),l.dispose())}function r(){e=new WeakMap}return{get:i,dispose:r}}const eo=4,Tp=[.125,.215,.35,.446,.526,.582],ur=20,lu=new mf,Ap=new Je;let cu=null,uu=0,hu=0,fu=!1;const sr=(1+Math.sqrt(5))/2,Zr=1/sr,Rp=[new k(-sr,Zr,0),new k(sr,Zr,0),new k(-Zr,0,sr),new k(Zr,0,sr),new k(0,sr,-Zr),new k(0,sr,Zr),new k(-1,1,-1),new k(1,1,-1),new k(-1,1,1),new k(1,1,1)],WE=new k;class Cp{constructor(e){this._renderer=e,this._pingPongRenderTarget=null,this._lodMax=0,this._cubeSize=0,this._lodPlanes=[],this._sizeLods=[],this._sigmas=[],this._blurMaterial=null,this._cubemapMaterial=null,this._equirectMaterial=null,this._compileMaterial(this._blurMaterial)}fromScene(e,t=0,i=.1,s=100,r={}){const{size:o=256,position:a=WE}=r;cu=this._renderer.getRenderTarget(),uu=this._renderer.getActiveCubeFace(),hu=this._renderer.getActiveMipmapLevel(),fu=this._renderer.xr.enabled,this._renderer.xr.enabled=!1,this._setSize(o);const l=this._allocateTargets();return l.depthBuffer=!0,this._sceneToCubeUV(e,i,s,l,a),t>0&&this._blur(l,0,0,t),this._applyPMREM(l),this._cleanup(l),l}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=Lp(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=Dp(),this._compileMaterial(this._equirectMaterial))}dispose(){this._dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose()}_setSize(e){this._lodMax=Math.floor(Math.log2(e)),this._cubeSize=Math.pow(2,this._lodMax)}_dispose(){this._blurMaterial!==null&&this._blurMaterial.dispose(),this._pingPongRenderTarget!==null&&this._pingPongRenderTarget.dispose();for(let e=0;e<this._lodPlanes.length;e++)this._lodPlanes[e].dispose()}_cleanup(e){this._renderer.setRenderTarget(cu,uu,hu),this._renderer.xr.enabled=fu,e.scissorTest=!1,dl(e,0,0,e.width,e.height)}_fromTexture(e,t){e.mapping===go||e.mapping===vo?this._setSize(e.image.length===0?16:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4),cu=this._renderer.getRenderTarget(),uu=this._renderer.getActiveCubeFace(),hu=this._renderer.getActiveMipmapLevel(),fu=this._renderer.xr.enabled,this._renderer.xr.enabled=!1;const i=t||this._allocateTargets();return this._textureToCubeUV(e,i),this._applyPMREM(i),this._cleanup(i),i}_allocateTargets(){const e=3*Math.max(this._cubeSize,112),t=4*this._cubeSize,i={magFilter:Yi,minFilter:Yi,generateMipmaps:!1,type:Pa,format:Li,colorSpace:xo,depthBuffer:!1},s=Pp(e,t,i);if(this._pingPongRenderTarget===null||this._pingPongRenderTarget.width!==e||this._pingPongRenderTarget.height!==t){this._pingPongRenderTarget!==null&&this._dispose(),this._pingPongRenderTarget=Pp(e,t,i);const{_lodMax:r}=this;({sizeLods:this._sizeLods,lodPlanes:this._lodPlanes,sigmas:this._sigmas}=XE(r)),this._blurMaterial=YE(r,e,t)}return s}_compileMaterial(e){const t=new be(this._lodPlanes[0],e);this._renderer.compile(t,lu)}_sceneToCubeUV(e,t,i,s,r){const l=new xi(90,1,t,i),c=[1,-1,1,1,1,1],u=[1,1,1,-1,-1,-1],f=this._renderer,d=f.autoClear,h=f.toneMapping;f.getClearColor(Ap),f.toneMapping=Fs,f.autoClear=!1,f.state.buffers.depth.getReversed()&&(f.setRenderTarget(s),f.clearDepth(),f.setRenderTarget(null));const x=new hc({name:"PMREM.Background",side:Jn,depthWrite:!1,depthTest:!1}),m=new be(new ln,x);let p=!1;const M=e.background;M?M.isColor&&(x.color.copy(M),e.background=null,p=!0):(x.color.copy(Ap),p=!0);for(let b=0;b<6;b++){const v=b%3;v===0?(l.up.set(0,c[b],0),l.position.set(r.x,r.y,r.z),l.lookAt(r.x+u[b],r.y,r.z)):v===1?(l.up.set(0,0,c[b]),l.position.set(r.x,r.y,r.z),l.lookAt(r.x,r.y+u[b],r.z)):(l.up.set(0,c[b],0),l.position.set(r.x,r.y,r.z),l.lookAt(r.x,r.y,r.z+u[b]));const L=this._cubeSize;dl(s,v*L,b>2?L:0,L,L),f.setRenderTarget(s),p&&f.render(m,l),f.render(e,l)}m.geometry.dispose(),m.material.dispose(),f.toneMapping=h,f.autoClear=d,e.background=M}_textureToCubeUV(e,t){const i=this._renderer,s=e.mapping===go||e.mapping===vo;s?(this._cubemapMaterial===null&&(this._cubemapMaterial=Lp()),this._cubemapMaterial.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):this._equirectMaterial===null&&(this._equirectMaterial=Dp());const r=s?this._cubemapMaterial:this._equirectMaterial,o=new be(this._lodPlanes[0],r),a=r.uniforms;a.envMap.value=e;const l=this._cubeSize;dl(t,0,0,3*l,2*l),i.setRenderTarget(t),i.render(o,lu)}_applyPMREM(e){const t=this._renderer,i=t.autoClear;t.autoClear=!1;const s=this._lodPlanes.length;for(let r=1;r<s;r++){const o=Math.sqrt(this._sigmas[r]*this._sigmas[r]-this._sigmas[r-1]*this._sigmas[r-1]),a=Rp[(s-r-1)%Rp.length];this._blur(e,r-1,r,o,a)}t.autoClear=i}_blur(e,t,i,s,r){const o=this._pingPongRenderTarget;this._halfBlur(e,o,t,i,s,"latitudinal",r),this._halfBlur(o,e,i,i,s,"longitudinal",r)}_halfBlur(e,t,i,s,r,o,a){const l=this._renderer,c=this._blurMaterial;o!=="latitudinal"&&o!=="longitudinal"&&console.error("blur direction must be either latitudinal or longitudinal!");const u=3,f=new be(this._lodPlanes[s],c),d=c.uniforms,h=this._sizeLods[i]-1,_=isFinite(r)?Math.PI/(2*h):2*Math.PI/(2*ur-1),x=r/_,m=isFinite(r)?1+Math.floor(u*x):ur;m>ur&&console.warn(`sigmaRadians, ${r}, is too large and will clip, as it requested ${m} samples when the maximum is set to ${ur}`);const p=[];let M=0;for(let U=0;U<ur;++U){const N=U/x,T=Math.exp(-N*N/2);p.push(T),U===0?M+=T:U<m&&(M+=2*T)}for(let U=0;U<p.length;U++)p[U]=p[U]/M;d.envMap.value=e.texture,d.samples.value=m,d.weights.value=p,d.latitudinal.value=o==="latitudinal",a&&(d.poleAxis.value=a);const{_lodMax:b}=this;d.dTheta.value=_,d.mipInt.value=b-i;const v=this._sizeLods[s],L=3*v*(s>b-eo?s-b+eo:0),R=4*(this._cubeSize-v);dl(t,L,R,3*v,2*v),l.setRenderTarget(t),l.render(f,lu)}}function XE(n){const e=[],t=[],i=[];let s=n;const r=n-eo+1+Tp.length;for(let o=0;o<r;o++){const a=Math.pow(2,s);t.push(a);let l=1/a;o>n-eo?l=Tp[o-n+eo-1]:o===0&&(l=0),i.push(l);const c=1/(a-2),u=-c,f=1+c,d=[u,u,f,u,f,f,u,u,f,f,u,f],h=6,_=6,x=3,m=2,p=1,M=new Float32Array(x*_*h),b=new Float32Array(m*_*h),v=new Float32Array(p*_*h);for(let R=0;R<h;R++){const U=R%3*2/3-1,N=R>2?0:-1,T=[U,N,0,U+2/3,N,0,U+2/3,N+1,0,U,N,0,U+2/3,N+1,0,U,N+1,0];M.set(T,x*_*R),b.set(d,m*_*R);const E=[R,R,R,R,R,R];v.set(E,p*_*R)}const L=new rn;L.setAttribute("position",new Pn(M,x)),L.setAttribute("uv",new Pn(b,m)),L.setAttribute("faceIndex",new Pn(v,p)),e.push(L),s>eo&&s--}return{lodPlanes:e,sizeLods:t,sigmas:i}}function Pp(n,e,t){const i=new yr(n,e,t);return i.texture.mapping=cc,i.texture.name="PMREM.cubeUv",i.scissorTest=!0,i}function dl(n,e,t,i,s){n.viewport.set(e,t,i,s),n.scissor.set(e,t,i,s)}function YE(n,e,t){const i=new Float32Array(ur),s=new k(0,1,0);return new ps({name:"SphericalGaussianBlur",defines:{n:ur,CUBEUV_TEXEL_WIDTH:1/e,CUBEUV_TEXEL_HEIGHT:1/t,CUBEUV_MAX_MIP:`${n}.0`},uniforms:{envMap:{value:null},samples:{value:1},weights:{value:i},latitudinal:{value:!1},dTheta:{value:0},mipInt:{value:0},poleAxis:{value:s}},vertexShader:_f(),fragmentShader:`

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
		`,blending:Ns,depthTest:!1,depthWrite:!1})}function Dp(){return new ps({name:"EquirectangularToCubeUV",uniforms:{envMap:{value:null}},vertexShader:_f(),fragmentShader:`

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
		`,blending:Ns,depthTest:!1,depthWrite:!1})}function Lp(){return new ps({name:"CubemapToCubeUV",uniforms:{envMap:{value:null},flipEnvMap:{value:-1}},vertexShader:_f(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			uniform float flipEnvMap;

			varying vec3 vOutputDirection;

			uniform samplerCube envMap;

			void main() {

				gl_FragColor = textureCube( envMap, vec3( flipEnvMap * vOutputDirection.x, vOutputDirection.yz ) );

			}
		`,blending:Ns,depthTest:!1,depthWrite:!1})}function _f(){return`

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
	`}function qE(n){let e=new WeakMap,t=null;function i(a){if(a&&a.isTexture){const l=a.mapping,c=l===Yu||l===qu,u=l===go||l===vo;if(c||u){let f=e.get(a);const d=f!==void 0?f.texture.pmremVersion:0;if(a.isRenderTargetTexture&&a.pmremVersion!==d)return t===null&&(t=new Cp(n)),f=c?t.fromEquirectangular(a,f):t.fromCubemap(a,f),f.texture.pmremVersion=a.pmremVersion,e.set(a,f),f.texture;if(f!==void 0)return f.texture;{const h=a.image;return c&&h&&h.height>0||u&&h&&s(h)?(t===null&&(t=new Cp(n)),f=c?t.fromEquirectangular(a):t.fromCubemap(a),f.texture.pmremVersion=a.pmremVersion,e.set(a,f),a.addEventListener("dispose",r),f.texture):null}}}return a}function s(a){let l=0;const c=6;for(let u=0;u<c;u++)a[u]!==void 0&&l++;return l===c}function r(a){const l=a.target;l.removeEventListener("dispose",r);const c=e.get(l);c!==void 0&&(e.delete(l),c.dispose())}function o(){e=new WeakMap,t!==null&&(t.dispose(),t=null)}return{get:i,dispose:o}}function $E(n){const e={};function t(i){if(e[i]!==void 0)return e[i];let s;switch(i){case"WEBGL_depth_texture":s=n.getExtension("WEBGL_depth_texture")||n.getExtension("MOZ_WEBGL_depth_texture")||n.getExtension("WEBKIT_WEBGL_depth_texture");break;case"EXT_texture_filter_anisotropic":s=n.getExtension("EXT_texture_filter_anisotropic")||n.getExtension("MOZ_EXT_texture_filter_anisotropic")||n.getExtension("WEBKIT_EXT_texture_filter_anisotropic");break;case"WEBGL_compressed_texture_s3tc":s=n.getExtension("WEBGL_compressed_texture_s3tc")||n.getExtension("MOZ_WEBGL_compressed_texture_s3tc")||n.getExtension("WEBKIT_WEBGL_compressed_texture_s3tc");break;case"WEBGL_compressed_texture_pvrtc":s=n.getExtension("WEBGL_compressed_texture_pvrtc")||n.getExtension("WEBKIT_WEBGL_compressed_texture_pvrtc");break;default:s=n.getExtension(i)}return e[i]=s,s}return{has:function(i){return t(i)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(i){const s=t(i);return s===null&&Ta("THREE.WebGLRenderer: "+i+" extension not supported."),s}}}function jE(n,e,t,i){const s={},r=new WeakMap;function o(f){const d=f.target;d.index!==null&&e.remove(d.index);for(const _ in d.attributes)e.remove(d.attributes[_]);d.removeEventListener("dispose",o),delete s[d.id];const h=r.get(d);h&&(e.remove(h),r.delete(d)),i.releaseStatesOfGeometry(d),d.isInstancedBufferGeometry===!0&&delete d._maxInstanceCount,t.memory.geometries--}function a(f,d){return s[d.id]===!0||(d.addEventListener("dispose",o),s[d.id]=!0,t.memory.geometries++),d}function l(f){const d=f.attributes;for(const h in d)e.update(d[h],n.ARRAY_BUFFER)}function c(f){const d=[],h=f.index,_=f.attributes.position;let x=0;if(h!==null){const M=h.array;x=h.version;for(let b=0,v=M.length;b<v;b+=3){const L=M[b+0],R=M[b+1],U=M[b+2];d.push(L,R,R,U,U,L)}}else if(_!==void 0){const M=_.array;x=_.version;for(let b=0,v=M.length/3-1;b<v;b+=3){const L=b+0,R=b+1,U=b+2;d.push(L,R,R,U,U,L)}}else return;const m=new(H_(d)?X_:W_)(d,1);m.version=x;const p=r.get(f);p&&e.remove(p),r.set(f,m)}function u(f){const d=r.get(f);if(d){const h=f.index;h!==null&&d.version<h.version&&c(f)}else c(f);return r.get(f)}return{get:a,update:l,getWireframeAttribute:u}}function ZE(n,e,t){let i;function s(d){i=d}let r,o;function a(d){r=d.type,o=d.bytesPerElement}function l(d,h){n.drawElements(i,h,r,d*o),t.update(h,i,1)}function c(d,h,_){_!==0&&(n.drawElementsInstanced(i,h,r,d*o,_),t.update(h,i,_))}function u(d,h,_){if(_===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,h,0,r,d,0,_);let m=0;for(let p=0;p<_;p++)m+=h[p];t.update(m,i,1)}function f(d,h,_,x){if(_===0)return;const m=e.get("WEBGL_multi_draw");if(m===null)for(let p=0;p<d.length;p++)c(d[p]/o,h[p],x[p]);else{m.multiDrawElementsInstancedWEBGL(i,h,0,r,d,0,x,0,_);let p=0;for(let M=0;M<_;M++)p+=h[M]*x[M];t.update(p,i,1)}}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u,this.renderMultiDrawInstances=f}function KE(n){const e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(t.calls++,o){case n.TRIANGLES:t.triangles+=a*(r/3);break;case n.LINES:t.lines+=a*(r/2);break;case n.LINE_STRIP:t.lines+=a*(r-1);break;case n.LINE_LOOP:t.lines+=a*r;break;case n.POINTS:t.points+=a*r;break;default:console.error("THREE.WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:i}}function JE(n,e,t){const i=new WeakMap,s=new en;function r(o,a,l){const c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,f=u!==void 0?u.length:0;let d=i.get(a);if(d===void 0||d.count!==f){let T=function(){U.dispose(),i.delete(a),a.removeEventListener("dispose",T)};d!==void 0&&d.texture.dispose();const h=a.morphAttributes.position!==void 0,_=a.morphAttributes.normal!==void 0,x=a.morphAttributes.color!==void 0,m=a.morphAttributes.position||[],p=a.morphAttributes.normal||[],M=a.morphAttributes.color||[];let b=0;h===!0&&(b=1),_===!0&&(b=2),x===!0&&(b=3);let v=a.attributes.position.count*b,L=1;v>e.maxTextureSize&&(L=Math.ceil(v/e.maxTextureSize),v=e.maxTextureSize);const R=new Float32Array(v*L*4*f),U=new V_(R,v,L,f);U.type=qi,U.needsUpdate=!0;const N=b*4;for(let E=0;E<f;E++){const C=m[E],B=p[E],z=M[E],X=v*L*4*E;for(let W=0;W<C.count;W++){const q=W*N;h===!0&&(s.fromBufferAttribute(C,W),R[X+q+0]=s.x,R[X+q+1]=s.y,R[X+q+2]=s.z,R[X+q+3]=0),_===!0&&(s.fromBufferAttribute(B,W),R[X+q+4]=s.x,R[X+q+5]=s.y,R[X+q+6]=s.z,R[X+q+7]=0),x===!0&&(s.fromBufferAttribute(z,W),R[X+q+8]=s.x,R[X+q+9]=s.y,R[X+q+10]=s.z,R[X+q+11]=z.itemSize===4?s.w:1)}}d={count:f,texture:U,size:new Ke(v,L)},i.set(a,d),a.addEventListener("dispose",T)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,t);else{let h=0;for(let x=0;x<c.length;x++)h+=c[x];const _=a.morphTargetsRelative?1:1-h;l.getUniforms().setValue(n,"morphTargetBaseInfluence",_),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",d.texture,t),l.getUniforms().setValue(n,"morphTargetsTextureSize",d.size)}return{update:r}}function QE(n,e,t,i){let s=new WeakMap;function r(l){const c=i.render.frame,u=l.geometry,f=e.get(l,u);if(s.get(f)!==c&&(e.update(f),s.set(f,c)),l.isInstancedMesh&&(l.hasEventListener("dispose",a)===!1&&l.addEventListener("dispose",a),s.get(l)!==c&&(t.update(l.instanceMatrix,n.ARRAY_BUFFER),l.instanceColor!==null&&t.update(l.instanceColor,n.ARRAY_BUFFER),s.set(l,c))),l.isSkinnedMesh){const d=l.skeleton;s.get(d)!==c&&(d.update(),s.set(d,c))}return f}function o(){s=new WeakMap}function a(l){const c=l.target;c.removeEventListener("dispose",a),t.remove(c.instanceMatrix),c.instanceColor!==null&&t.remove(c.instanceColor)}return{update:r,dispose:o}}const ng=new Yn,Ip=new j_(1,1),ig=new V_,sg=new xy,rg=new $_,Up=[],Np=[],Fp=new Float32Array(16),Op=new Float32Array(9),kp=new Float32Array(4);function Ao(n,e,t){const i=n[0];if(i<=0||i>0)return n;const s=e*t;let r=Up[s];if(r===void 0&&(r=new Float32Array(s),Up[s]=r),e!==0){i.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,n[o].toArray(r,a)}return r}function _n(n,e){if(n.length!==e.length)return!1;for(let t=0,i=n.length;t<i;t++)if(n[t]!==e[t])return!1;return!0}function gn(n,e){for(let t=0,i=e.length;t<i;t++)n[t]=e[t]}function fc(n,e){let t=Np[e];t===void 0&&(t=new Int32Array(e),Np[e]=t);for(let i=0;i!==e;++i)t[i]=n.allocateTextureUnit();return t}function eb(n,e){const t=this.cache;t[0]!==e&&(n.uniform1f(this.addr,e),t[0]=e)}function tb(n,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(_n(t,e))return;n.uniform2fv(this.addr,e),gn(t,e)}}function nb(n,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(n.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(_n(t,e))return;n.uniform3fv(this.addr,e),gn(t,e)}}function ib(n,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(_n(t,e))return;n.uniform4fv(this.addr,e),gn(t,e)}}function sb(n,e){const t=this.cache,i=e.elements;if(i===void 0){if(_n(t,e))return;n.uniformMatrix2fv(this.addr,!1,e),gn(t,e)}else{if(_n(t,i))return;kp.set(i),n.uniformMatrix2fv(this.addr,!1,kp),gn(t,i)}}function rb(n,e){const t=this.cache,i=e.elements;if(i===void 0){if(_n(t,e))return;n.uniformMatrix3fv(this.addr,!1,e),gn(t,e)}else{if(_n(t,i))return;Op.set(i),n.uniformMatrix3fv(this.addr,!1,Op),gn(t,i)}}function ob(n,e){const t=this.cache,i=e.elements;if(i===void 0){if(_n(t,e))return;n.uniformMatrix4fv(this.addr,!1,e),gn(t,e)}else{if(_n(t,i))return;Fp.set(i),n.uniformMatrix4fv(this.addr,!1,Fp),gn(t,i)}}function ab(n,e){const t=this.cache;t[0]!==e&&(n.uniform1i(this.addr,e),t[0]=e)}function lb(n,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(_n(t,e))return;n.uniform2iv(this.addr,e),gn(t,e)}}function cb(n,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(_n(t,e))return;n.uniform3iv(this.addr,e),gn(t,e)}}function ub(n,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(_n(t,e))return;n.uniform4iv(this.addr,e),gn(t,e)}}function hb(n,e){const t=this.cache;t[0]!==e&&(n.uniform1ui(this.addr,e),t[0]=e)}function fb(n,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(_n(t,e))return;n.uniform2uiv(this.addr,e),gn(t,e)}}function db(n,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(_n(t,e))return;n.uniform3uiv(this.addr,e),gn(t,e)}}function pb(n,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(_n(t,e))return;n.uniform4uiv(this.addr,e),gn(t,e)}}function mb(n,e,t){const i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?(Ip.compareFunction=z_,r=Ip):r=ng,t.setTexture2D(e||r,s)}function _b(n,e,t){const i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture3D(e||sg,s)}function gb(n,e,t){const i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTextureCube(e||rg,s)}function vb(n,e,t){const i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture2DArray(e||ig,s)}function xb(n){switch(n){case 5126:return eb;case 35664:return tb;case 35665:return nb;case 35666:return ib;case 35674:return sb;case 35675:return rb;case 35676:return ob;case 5124:case 35670:return ab;case 35667:case 35671:return lb;case 35668:case 35672:return cb;case 35669:case 35673:return ub;case 5125:return hb;case 36294:return fb;case 36295:return db;case 36296:return pb;case 35678:case 36198:case 36298:case 36306:case 35682:return mb;case 35679:case 36299:case 36307:return _b;case 35680:case 36300:case 36308:case 36293:return gb;case 36289:case 36303:case 36311:case 36292:return vb}}function yb(n,e){n.uniform1fv(this.addr,e)}function Mb(n,e){const t=Ao(e,this.size,2);n.uniform2fv(this.addr,t)}function Sb(n,e){const t=Ao(e,this.size,3);n.uniform3fv(this.addr,t)}function Eb(n,e){const t=Ao(e,this.size,4);n.uniform4fv(this.addr,t)}function bb(n,e){const t=Ao(e,this.size,4);n.uniformMatrix2fv(this.addr,!1,t)}function wb(n,e){const t=Ao(e,this.size,9);n.uniformMatrix3fv(this.addr,!1,t)}function Tb(n,e){const t=Ao(e,this.size,16);n.uniformMatrix4fv(this.addr,!1,t)}function Ab(n,e){n.uniform1iv(this.addr,e)}function Rb(n,e){n.uniform2iv(this.addr,e)}function Cb(n,e){n.uniform3iv(this.addr,e)}function Pb(n,e){n.uniform4iv(this.addr,e)}function Db(n,e){n.uniform1uiv(this.addr,e)}function Lb(n,e){n.uniform2uiv(this.addr,e)}function Ib(n,e){n.uniform3uiv(this.addr,e)}function Ub(n,e){n.uniform4uiv(this.addr,e)}function Nb(n,e,t){const i=this.cache,s=e.length,r=fc(t,s);_n(i,r)||(n.uniform1iv(this.addr,r),gn(i,r));for(let o=0;o!==s;++o)t.setTexture2D(e[o]||ng,r[o])}function Fb(n,e,t){const i=this.cache,s=e.length,r=fc(t,s);_n(i,r)||(n.uniform1iv(this.addr,r),gn(i,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||sg,r[o])}function Ob(n,e,t){const i=this.cache,s=e.length,r=fc(t,s);_n(i,r)||(n.uniform1iv(this.addr,r),gn(i,r));for(let o=0;o!==s;++o)t.setTextureCube(e[o]||rg,r[o])}function kb(n,e,t){const i=this.cache,s=e.length,r=fc(t,s);_n(i,r)||(n.uniform1iv(this.addr,r),gn(i,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||ig,r[o])}function Bb(n){switch(n){case 5126:return yb;case 35664:return Mb;case 35665:return Sb;case 35666:return Eb;case 35674:return bb;case 35675:return wb;case 35676:return Tb;case 5124:case 35670:return Ab;case 35667:case 35671:return Rb;case 35668:case 35672:return Cb;case 35669:case 35673:return Pb;case 5125:return Db;case 36294:return Lb;case 36295:return Ib;case 36296:return Ub;case 35678:case 36198:case 36298:case 36306:case 35682:return Nb;case 35679:case 36299:case 36307:return Fb;case 35680:case 36300:case 36308:case 36293:return Ob;case 36289:case 36303:case 36311:case 36292:return kb}}class zb{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.setValue=xb(t.type)}}class Hb{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=Bb(t.type)}}class Vb{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,i){const s=this.seq;for(let r=0,o=s.length;r!==o;++r){const a=s[r];a.setValue(e,t[a.id],i)}}}const du=/(\w+)(\])?(\[|\.)?/g;function Bp(n,e){n.seq.push(e),n.map[e.id]=e}function Gb(n,e,t){const i=n.name,s=i.length;for(du.lastIndex=0;;){const r=du.exec(i),o=du.lastIndex;let a=r[1];const l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){Bp(t,c===void 0?new zb(a,n,e):new Hb(a,n,e));break}else{let f=t.map[a];f===void 0&&(f=new Vb(a),Bp(t,f)),t=f}}}class Dl{constructor(e,t){this.seq=[],this.map={};const i=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let s=0;s<i;++s){const r=e.getActiveUniform(t,s),o=e.getUniformLocation(t,r.name);Gb(r,o,this)}}setValue(e,t,i,s){const r=this.map[t];r!==void 0&&r.setValue(e,i,s)}setOptional(e,t,i){const s=t[i];s!==void 0&&this.setValue(e,i,s)}static upload(e,t,i,s){for(let r=0,o=t.length;r!==o;++r){const a=t[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,s)}}static seqWithValue(e,t){const i=[];for(let s=0,r=e.length;s!==r;++s){const o=e[s];o.id in t&&i.push(o)}return i}}function zp(n,e,t){const i=n.createShader(e);return n.shaderSource(i,t),n.compileShader(i),i}const Wb=37297;let Xb=0;function Yb(n,e){const t=n.split(`
`),i=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){const a=o+1;i.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return i.join(`
`)}const Hp=new lt;function qb(n){xt._getMatrix(Hp,xt.workingColorSpace,n);const e=`mat3( ${Hp.elements.map(t=>t.toFixed(4))} )`;switch(xt.getTransfer(n)){case Xl:return[e,"LinearTransferOETF"];case It:return[e,"sRGBTransferOETF"];default:return console.warn("THREE.WebGLProgram: Unsupported color space: ",n),[e,"LinearTransferOETF"]}}function Vp(n,e,t){const i=n.getShaderParameter(e,n.COMPILE_STATUS),r=(n.getShaderInfoLog(e)||"").trim();if(i&&r==="")return"";const o=/ERROR: 0:(\d+)/.exec(r);if(o){const a=parseInt(o[1]);return t.toUpperCase()+`

`+r+`

`+Yb(n.getShaderSource(e),a)}else return r}function $b(n,e){const t=qb(e);return[`vec4 ${n}( vec4 value ) {`,`	return ${t[1]}( vec4( value.rgb * ${t[0]}, value.a ) );`,"}"].join(`
`)}function jb(n,e){let t;switch(e){case Yx:t="Linear";break;case qx:t="Reinhard";break;case $x:t="Cineon";break;case D_:t="ACESFilmic";break;case Zx:t="AgX";break;case Kx:t="Neutral";break;case jx:t="Custom";break;default:console.warn("THREE.WebGLProgram: Unsupported toneMapping:",e),t="Linear"}return"vec3 "+n+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}const pl=new k;function Zb(){xt.getLuminanceCoefficients(pl);const n=pl.x.toFixed(4),e=pl.y.toFixed(4),t=pl.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function Kb(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(ia).join(`
`)}function Jb(n){const e=[];for(const t in n){const i=n[t];i!==!1&&e.push("#define "+t+" "+i)}return e.join(`
`)}function Qb(n,e){const t={},i=n.getProgramParameter(e,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){const r=n.getActiveAttrib(e,s),o=r.name;let a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:n.getAttribLocation(e,o),locationSize:a}}return t}function ia(n){return n!==""}function Gp(n,e){const t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return n.replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows)}function Wp(n,e){return n.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}const ew=/^[ \t]*#include +<([\w\d./]+)>/gm;function Th(n){return n.replace(ew,nw)}const tw=new Map;function nw(n,e){let t=ut[e];if(t===void 0){const i=tw.get(e);if(i!==void 0)t=ut[i],console.warn('THREE.WebGLRenderer: Shader chunk "%s" has been deprecated. Use "%s" instead.',e,i);else throw new Error("Can not resolve #include <"+e+">")}return Th(t)}const iw=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Xp(n){return n.replace(iw,sw)}function sw(n,e,t,i){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function Yp(n){let e=`precision ${n.precision} float;
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
#define LOW_PRECISION`),e}function rw(n){let e="SHADOWMAP_TYPE_BASIC";return n.shadowMapType===C_?e="SHADOWMAP_TYPE_PCF":n.shadowMapType===P_?e="SHADOWMAP_TYPE_PCF_SOFT":n.shadowMapType===as&&(e="SHADOWMAP_TYPE_VSM"),e}function ow(n){let e="ENVMAP_TYPE_CUBE";if(n.envMap)switch(n.envMapMode){case go:case vo:e="ENVMAP_TYPE_CUBE";break;case cc:e="ENVMAP_TYPE_CUBE_UV";break}return e}function aw(n){let e="ENVMAP_MODE_REFLECTION";return n.envMap&&n.envMapMode===vo&&(e="ENVMAP_MODE_REFRACTION"),e}function lw(n){let e="ENVMAP_BLENDING_NONE";if(n.envMap)switch(n.combine){case ef:e="ENVMAP_BLENDING_MULTIPLY";break;case Wx:e="ENVMAP_BLENDING_MIX";break;case Xx:e="ENVMAP_BLENDING_ADD";break}return e}function cw(n){const e=n.envMapCubeUVHeight;if(e===null)return null;const t=Math.log2(e)-2,i=1/e;return{texelWidth:1/(3*Math.max(Math.pow(2,t),112)),texelHeight:i,maxMip:t}}function uw(n,e,t,i){const s=n.getContext(),r=t.defines;let o=t.vertexShader,a=t.fragmentShader;const l=rw(t),c=ow(t),u=aw(t),f=lw(t),d=cw(t),h=Kb(t),_=Jb(r),x=s.createProgram();let m,p,M=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(m=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,_].filter(ia).join(`
`),m.length>0&&(m+=`
`),p=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,_].filter(ia).join(`
`),p.length>0&&(p+=`
`)):(m=[Yp(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,_,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+u:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(ia).join(`
`),p=[Yp(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,_,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+u:"",t.envMap?"#define "+f:"",d?"#define CUBEUV_TEXEL_WIDTH "+d.texelWidth:"",d?"#define CUBEUV_TEXEL_HEIGHT "+d.texelHeight:"",d?"#define CUBEUV_MAX_MIP "+d.maxMip+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor||t.batchingColor?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==Fs?"#define TONE_MAPPING":"",t.toneMapping!==Fs?ut.tonemapping_pars_fragment:"",t.toneMapping!==Fs?jb("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",ut.colorspace_pars_fragment,$b("linearToOutputTexel",t.outputColorSpace),Zb(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(ia).join(`
`)),o=Th(o),o=Gp(o,t),o=Wp(o,t),a=Th(a),a=Gp(a,t),a=Wp(a,t),o=Xp(o),a=Xp(a),t.isRawShaderMaterial!==!0&&(M=`#version 300 es
`,m=[h,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+m,p=["#define varying in",t.glslVersion===$d?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===$d?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+p);const b=M+m+o,v=M+p+a,L=zp(s,s.VERTEX_SHADER,b),R=zp(s,s.FRAGMENT_SHADER,v);s.attachShader(x,L),s.attachShader(x,R),t.index0AttributeName!==void 0?s.bindAttribLocation(x,0,t.index0AttributeName):t.morphTargets===!0&&s.bindAttribLocation(x,0,"position"),s.linkProgram(x);function U(C){if(n.debug.checkShaderErrors){const B=s.getProgramInfoLog(x)||"",z=s.getShaderInfoLog(L)||"",X=s.getShaderInfoLog(R)||"",W=B.trim(),q=z.trim(),j=X.trim();let K=!0,re=!0;if(s.getProgramParameter(x,s.LINK_STATUS)===!1)if(K=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,x,L,R);else{const ae=Vp(s,L,"vertex"),me=Vp(s,R,"fragment");console.error("THREE.WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(x,s.VALIDATE_STATUS)+`

Material Name: `+C.name+`
Material Type: `+C.type+`

Program Info Log: `+W+`
`+ae+`
`+me)}else W!==""?console.warn("THREE.WebGLProgram: Program Info Log:",W):(q===""||j==="")&&(re=!1);re&&(C.diagnostics={runnable:K,programLog:W,vertexShader:{log:q,prefix:m},fragmentShader:{log:j,prefix:p}})}s.deleteShader(L),s.deleteShader(R),N=new Dl(s,x),T=Qb(s,x)}let N;this.getUniforms=function(){return N===void 0&&U(this),N};let T;this.getAttributes=function(){return T===void 0&&U(this),T};let E=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return E===!1&&(E=s.getProgramParameter(x,Wb)),E},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(x),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=Xb++,this.cacheKey=e,this.usedTimes=1,this.program=x,this.vertexShader=L,this.fragmentShader=R,this}let hw=0;class fw{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e){const t=e.vertexShader,i=e.fragmentShader,s=this._getShaderStage(t),r=this._getShaderStage(i),o=this._getShaderCacheForMaterial(e);return o.has(s)===!1&&(o.add(s),s.usedTimes++),o.has(r)===!1&&(o.add(r),r.usedTimes++),this}remove(e){const t=this.materialCache.get(e);for(const i of t)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(e),this}getVertexShaderID(e){return this._getShaderStage(e.vertexShader).id}getFragmentShaderID(e){return this._getShaderStage(e.fragmentShader).id}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){const t=this.materialCache;let i=t.get(e);return i===void 0&&(i=new Set,t.set(e,i)),i}_getShaderStage(e){const t=this.shaderCache;let i=t.get(e);return i===void 0&&(i=new dw(e),t.set(e,i)),i}}class dw{constructor(e){this.id=hw++,this.code=e,this.usedTimes=0}}function pw(n,e,t,i,s,r,o){const a=new hf,l=new fw,c=new Set,u=[],f=s.logarithmicDepthBuffer,d=s.vertexTextures;let h=s.precision;const _={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distanceRGBA",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function x(T){return c.add(T),T===0?"uv":`uv${T}`}function m(T,E,C,B,z){const X=B.fog,W=z.geometry,q=T.isMeshStandardMaterial?B.environment:null,j=(T.isMeshStandardMaterial?t:e).get(T.envMap||q),K=j&&j.mapping===cc?j.image.height:null,re=_[T.type];T.precision!==null&&(h=s.getMaxPrecision(T.precision),h!==T.precision&&console.warn("THREE.WebGLProgram.getParameters:",T.precision,"not supported, using",h,"instead."));const ae=W.morphAttributes.position||W.morphAttributes.normal||W.morphAttributes.color,me=ae!==void 0?ae.length:0;let xe=0;W.morphAttributes.position!==void 0&&(xe=1),W.morphAttributes.normal!==void 0&&(xe=2),W.morphAttributes.color!==void 0&&(xe=3);let ge,Qe,et,ee;if(re){const _t=Gi[re];ge=_t.vertexShader,Qe=_t.fragmentShader}else ge=T.vertexShader,Qe=T.fragmentShader,l.update(T),et=l.getVertexShaderID(T),ee=l.getFragmentShaderID(T);const ne=n.getRenderTarget(),we=n.state.buffers.depth.getReversed(),ze=z.isInstancedMesh===!0,ye=z.isBatchedMesh===!0,tt=!!T.map,Bt=!!T.matcap,F=!!j,mt=!!T.aoMap,$e=!!T.lightMap,We=!!T.bumpMap,Ne=!!T.normalMap,At=!!T.displacementMap,Pe=!!T.emissiveMap,Ge=!!T.metalnessMap,Gt=!!T.roughnessMap,Mt=T.anisotropy>0,D=T.clearcoat>0,y=T.dispersion>0,O=T.iridescence>0,J=T.sheen>0,ie=T.transmission>0,te=Mt&&!!T.anisotropyMap,Fe=D&&!!T.clearcoatMap,he=D&&!!T.clearcoatNormalMap,Le=D&&!!T.clearcoatRoughnessMap,Re=O&&!!T.iridescenceMap,le=O&&!!T.iridescenceThicknessMap,ve=J&&!!T.sheenColorMap,Be=J&&!!T.sheenRoughnessMap,ke=!!T.specularMap,Me=!!T.specularColorMap,Ze=!!T.specularIntensityMap,H=ie&&!!T.transmissionMap,fe=ie&&!!T.thicknessMap,pe=!!T.gradientMap,De=!!T.alphaMap,ue=T.alphaTest>0,oe=!!T.alphaHash,Oe=!!T.extensions;let nt=Fs;T.toneMapped&&(ne===null||ne.isXRRenderTarget===!0)&&(nt=n.toneMapping);const Dt={shaderID:re,shaderType:T.type,shaderName:T.name,vertexShader:ge,fragmentShader:Qe,defines:T.defines,customVertexShaderID:et,customFragmentShaderID:ee,isRawShaderMaterial:T.isRawShaderMaterial===!0,glslVersion:T.glslVersion,precision:h,batching:ye,batchingColor:ye&&z._colorsTexture!==null,instancing:ze,instancingColor:ze&&z.instanceColor!==null,instancingMorph:ze&&z.morphTexture!==null,supportsVertexTextures:d,outputColorSpace:ne===null?n.outputColorSpace:ne.isXRRenderTarget===!0?ne.texture.colorSpace:xo,alphaToCoverage:!!T.alphaToCoverage,map:tt,matcap:Bt,envMap:F,envMapMode:F&&j.mapping,envMapCubeUVHeight:K,aoMap:mt,lightMap:$e,bumpMap:We,normalMap:Ne,displacementMap:d&&At,emissiveMap:Pe,normalMapObjectSpace:Ne&&T.normalMapType===ty,normalMapTangentSpace:Ne&&T.normalMapType===cf,metalnessMap:Ge,roughnessMap:Gt,anisotropy:Mt,anisotropyMap:te,clearcoat:D,clearcoatMap:Fe,clearcoatNormalMap:he,clearcoatRoughnessMap:Le,dispersion:y,iridescence:O,iridescenceMap:Re,iridescenceThicknessMap:le,sheen:J,sheenColorMap:ve,sheenRoughnessMap:Be,specularMap:ke,specularColorMap:Me,specularIntensityMap:Ze,transmission:ie,transmissionMap:H,thicknessMap:fe,gradientMap:pe,opaque:T.transparent===!1&&T.blending===so&&T.alphaToCoverage===!1,alphaMap:De,alphaTest:ue,alphaHash:oe,combine:T.combine,mapUv:tt&&x(T.map.channel),aoMapUv:mt&&x(T.aoMap.channel),lightMapUv:$e&&x(T.lightMap.channel),bumpMapUv:We&&x(T.bumpMap.channel),normalMapUv:Ne&&x(T.normalMap.channel),displacementMapUv:At&&x(T.displacementMap.channel),emissiveMapUv:Pe&&x(T.emissiveMap.channel),metalnessMapUv:Ge&&x(T.metalnessMap.channel),roughnessMapUv:Gt&&x(T.roughnessMap.channel),anisotropyMapUv:te&&x(T.anisotropyMap.channel),clearcoatMapUv:Fe&&x(T.clearcoatMap.channel),clearcoatNormalMapUv:he&&x(T.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:Le&&x(T.clearcoatRoughnessMap.channel),iridescenceMapUv:Re&&x(T.iridescenceMap.channel),iridescenceThicknessMapUv:le&&x(T.iridescenceThicknessMap.channel),sheenColorMapUv:ve&&x(T.sheenColorMap.channel),sheenRoughnessMapUv:Be&&x(T.sheenRoughnessMap.channel),specularMapUv:ke&&x(T.specularMap.channel),specularColorMapUv:Me&&x(T.specularColorMap.channel),specularIntensityMapUv:Ze&&x(T.specularIntensityMap.channel),transmissionMapUv:H&&x(T.transmissionMap.channel),thicknessMapUv:fe&&x(T.thicknessMap.channel),alphaMapUv:De&&x(T.alphaMap.channel),vertexTangents:!!W.attributes.tangent&&(Ne||Mt),vertexColors:T.vertexColors,vertexAlphas:T.vertexColors===!0&&!!W.attributes.color&&W.attributes.color.itemSize===4,pointsUvs:z.isPoints===!0&&!!W.attributes.uv&&(tt||De),fog:!!X,useFog:T.fog===!0,fogExp2:!!X&&X.isFogExp2,flatShading:T.flatShading===!0&&T.wireframe===!1,sizeAttenuation:T.sizeAttenuation===!0,logarithmicDepthBuffer:f,reversedDepthBuffer:we,skinning:z.isSkinnedMesh===!0,morphTargets:W.morphAttributes.position!==void 0,morphNormals:W.morphAttributes.normal!==void 0,morphColors:W.morphAttributes.color!==void 0,morphTargetsCount:me,morphTextureStride:xe,numDirLights:E.directional.length,numPointLights:E.point.length,numSpotLights:E.spot.length,numSpotLightMaps:E.spotLightMap.length,numRectAreaLights:E.rectArea.length,numHemiLights:E.hemi.length,numDirLightShadows:E.directionalShadowMap.length,numPointLightShadows:E.pointShadowMap.length,numSpotLightShadows:E.spotShadowMap.length,numSpotLightShadowsWithMaps:E.numSpotLightShadowsWithMaps,numLightProbes:E.numLightProbes,numClippingPlanes:o.numPlanes,numClipIntersection:o.numIntersection,dithering:T.dithering,shadowMapEnabled:n.shadowMap.enabled&&C.length>0,shadowMapType:n.shadowMap.type,toneMapping:nt,decodeVideoTexture:tt&&T.map.isVideoTexture===!0&&xt.getTransfer(T.map.colorSpace)===It,decodeVideoTextureEmissive:Pe&&T.emissiveMap.isVideoTexture===!0&&xt.getTransfer(T.emissiveMap.colorSpace)===It,premultipliedAlpha:T.premultipliedAlpha,doubleSided:T.side===Xi,flipSided:T.side===Jn,useDepthPacking:T.depthPacking>=0,depthPacking:T.depthPacking||0,index0AttributeName:T.index0AttributeName,extensionClipCullDistance:Oe&&T.extensions.clipCullDistance===!0&&i.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Oe&&T.extensions.multiDraw===!0||ye)&&i.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:i.has("KHR_parallel_shader_compile"),customProgramCacheKey:T.customProgramCacheKey()};return Dt.vertexUv1s=c.has(1),Dt.vertexUv2s=c.has(2),Dt.vertexUv3s=c.has(3),c.clear(),Dt}function p(T){const E=[];if(T.shaderID?E.push(T.shaderID):(E.push(T.customVertexShaderID),E.push(T.customFragmentShaderID)),T.defines!==void 0)for(const C in T.defines)E.push(C),E.push(T.defines[C]);return T.isRawShaderMaterial===!1&&(M(E,T),b(E,T),E.push(n.outputColorSpace)),E.push(T.customProgramCacheKey),E.join()}function M(T,E){T.push(E.precision),T.push(E.outputColorSpace),T.push(E.envMapMode),T.push(E.envMapCubeUVHeight),T.push(E.mapUv),T.push(E.alphaMapUv),T.push(E.lightMapUv),T.push(E.aoMapUv),T.push(E.bumpMapUv),T.push(E.normalMapUv),T.push(E.displacementMapUv),T.push(E.emissiveMapUv),T.push(E.metalnessMapUv),T.push(E.roughnessMapUv),T.push(E.anisotropyMapUv),T.push(E.clearcoatMapUv),T.push(E.clearcoatNormalMapUv),T.push(E.clearcoatRoughnessMapUv),T.push(E.iridescenceMapUv),T.push(E.iridescenceThicknessMapUv),T.push(E.sheenColorMapUv),T.push(E.sheenRoughnessMapUv),T.push(E.specularMapUv),T.push(E.specularColorMapUv),T.push(E.specularIntensityMapUv),T.push(E.transmissionMapUv),T.push(E.thicknessMapUv),T.push(E.combine),T.push(E.fogExp2),T.push(E.sizeAttenuation),T.push(E.morphTargetsCount),T.push(E.morphAttributeCount),T.push(E.numDirLights),T.push(E.numPointLights),T.push(E.numSpotLights),T.push(E.numSpotLightMaps),T.push(E.numHemiLights),T.push(E.numRectAreaLights),T.push(E.numDirLightShadows),T.push(E.numPointLightShadows),T.push(E.numSpotLightShadows),T.push(E.numSpotLightShadowsWithMaps),T.push(E.numLightProbes),T.push(E.shadowMapType),T.push(E.toneMapping),T.push(E.numClippingPlanes),T.push(E.numClipIntersection),T.push(E.depthPacking)}function b(T,E){a.disableAll(),E.supportsVertexTextures&&a.enable(0),E.instancing&&a.enable(1),E.instancingColor&&a.enable(2),E.instancingMorph&&a.enable(3),E.matcap&&a.enable(4),E.envMap&&a.enable(5),E.normalMapObjectSpace&&a.enable(6),E.normalMapTangentSpace&&a.enable(7),E.clearcoat&&a.enable(8),E.iridescence&&a.enable(9),E.alphaTest&&a.enable(10),E.vertexColors&&a.enable(11),E.vertexAlphas&&a.enable(12),E.vertexUv1s&&a.enable(13),E.vertexUv2s&&a.enable(14),E.vertexUv3s&&a.enable(15),E.vertexTangents&&a.enable(16),E.anisotropy&&a.enable(17),E.alphaHash&&a.enable(18),E.batching&&a.enable(19),E.dispersion&&a.enable(20),E.batchingColor&&a.enable(21),E.gradientMap&&a.enable(22),T.push(a.mask),a.disableAll(),E.fog&&a.enable(0),E.useFog&&a.enable(1),E.flatShading&&a.enable(2),E.logarithmicDepthBuffer&&a.enable(3),E.reversedDepthBuffer&&a.enable(4),E.skinning&&a.enable(5),E.morphTargets&&a.enable(6),E.morphNormals&&a.enable(7),E.morphColors&&a.enable(8),E.premultipliedAlpha&&a.enable(9),E.shadowMapEnabled&&a.enable(10),E.doubleSided&&a.enable(11),E.flipSided&&a.enable(12),E.useDepthPacking&&a.enable(13),E.dithering&&a.enable(14),E.transmission&&a.enable(15),E.sheen&&a.enable(16),E.opaque&&a.enable(17),E.pointsUvs&&a.enable(18),E.decodeVideoTexture&&a.enable(19),E.decodeVideoTextureEmissive&&a.enable(20),E.alphaToCoverage&&a.enable(21),T.push(a.mask)}function v(T){const E=_[T.type];let C;if(E){const B=Gi[E];C=Ly.clone(B.uniforms)}else C=T.uniforms;return C}function L(T,E){let C;for(let B=0,z=u.length;B<z;B++){const X=u[B];if(X.cacheKey===E){C=X,++C.usedTimes;break}}return C===void 0&&(C=new uw(n,E,T,r),u.push(C)),C}function R(T){if(--T.usedTimes===0){const E=u.indexOf(T);u[E]=u[u.length-1],u.pop(),T.destroy()}}function U(T){l.remove(T)}function N(){l.dispose()}return{getParameters:m,getProgramCacheKey:p,getUniforms:v,acquireProgram:L,releaseProgram:R,releaseShaderCache:U,programs:u,dispose:N}}function mw(){let n=new WeakMap;function e(o){return n.has(o)}function t(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:e,get:t,remove:i,update:s,dispose:r}}function _w(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.material.id!==e.material.id?n.material.id-e.material.id:n.z!==e.z?n.z-e.z:n.id-e.id}function qp(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.z!==e.z?e.z-n.z:n.id-e.id}function $p(){const n=[];let e=0;const t=[],i=[],s=[];function r(){e=0,t.length=0,i.length=0,s.length=0}function o(f,d,h,_,x,m){let p=n[e];return p===void 0?(p={id:f.id,object:f,geometry:d,material:h,groupOrder:_,renderOrder:f.renderOrder,z:x,group:m},n[e]=p):(p.id=f.id,p.object=f,p.geometry=d,p.material=h,p.groupOrder=_,p.renderOrder=f.renderOrder,p.z=x,p.group=m),e++,p}function a(f,d,h,_,x,m){const p=o(f,d,h,_,x,m);h.transmission>0?i.push(p):h.transparent===!0?s.push(p):t.push(p)}function l(f,d,h,_,x,m){const p=o(f,d,h,_,x,m);h.transmission>0?i.unshift(p):h.transparent===!0?s.unshift(p):t.unshift(p)}function c(f,d){t.length>1&&t.sort(f||_w),i.length>1&&i.sort(d||qp),s.length>1&&s.sort(d||qp)}function u(){for(let f=e,d=n.length;f<d;f++){const h=n[f];if(h.id===null)break;h.id=null,h.object=null,h.geometry=null,h.material=null,h.group=null}}return{opaque:t,transmissive:i,transparent:s,init:r,push:a,unshift:l,finish:u,sort:c}}function gw(){let n=new WeakMap;function e(i,s){const r=n.get(i);let o;return r===void 0?(o=new $p,n.set(i,[o])):s>=r.length?(o=new $p,r.push(o)):o=r[s],o}function t(){n=new WeakMap}return{get:e,dispose:t}}function vw(){const n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"DirectionalLight":t={direction:new k,color:new Je};break;case"SpotLight":t={position:new k,direction:new k,color:new Je,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new k,color:new Je,distance:0,decay:0};break;case"HemisphereLight":t={direction:new k,skyColor:new Je,groundColor:new Je};break;case"RectAreaLight":t={color:new Je,position:new k,halfWidth:new k,halfHeight:new k};break}return n[e.id]=t,t}}}function xw(){const n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ke};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ke};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ke,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[e.id]=t,t}}}let yw=0;function Mw(n,e){return(e.castShadow?2:0)-(n.castShadow?2:0)+(e.map?1:0)-(n.map?1:0)}function Sw(n){const e=new vw,t=xw(),i={version:0,hash:{directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new k);const s=new k,r=new Pt,o=new Pt;function a(c){let u=0,f=0,d=0;for(let T=0;T<9;T++)i.probe[T].set(0,0,0);let h=0,_=0,x=0,m=0,p=0,M=0,b=0,v=0,L=0,R=0,U=0;c.sort(Mw);for(let T=0,E=c.length;T<E;T++){const C=c[T],B=C.color,z=C.intensity,X=C.distance,W=C.shadow&&C.shadow.map?C.shadow.map.texture:null;if(C.isAmbientLight)u+=B.r*z,f+=B.g*z,d+=B.b*z;else if(C.isLightProbe){for(let q=0;q<9;q++)i.probe[q].addScaledVector(C.sh.coefficients[q],z);U++}else if(C.isDirectionalLight){const q=e.get(C);if(q.color.copy(C.color).multiplyScalar(C.intensity),C.castShadow){const j=C.shadow,K=t.get(C);K.shadowIntensity=j.intensity,K.shadowBias=j.bias,K.shadowNormalBias=j.normalBias,K.shadowRadius=j.radius,K.shadowMapSize=j.mapSize,i.directionalShadow[h]=K,i.directionalShadowMap[h]=W,i.directionalShadowMatrix[h]=C.shadow.matrix,M++}i.directional[h]=q,h++}else if(C.isSpotLight){const q=e.get(C);q.position.setFromMatrixPosition(C.matrixWorld),q.color.copy(B).multiplyScalar(z),q.distance=X,q.coneCos=Math.cos(C.angle),q.penumbraCos=Math.cos(C.angle*(1-C.penumbra)),q.decay=C.decay,i.spot[x]=q;const j=C.shadow;if(C.map&&(i.spotLightMap[L]=C.map,L++,j.updateMatrices(C),C.castShadow&&R++),i.spotLightMatrix[x]=j.matrix,C.castShadow){const K=t.get(C);K.shadowIntensity=j.intensity,K.shadowBias=j.bias,K.shadowNormalBias=j.normalBias,K.shadowRadius=j.radius,K.shadowMapSize=j.mapSize,i.spotShadow[x]=K,i.spotShadowMap[x]=W,v++}x++}else if(C.isRectAreaLight){const q=e.get(C);q.color.copy(B).multiplyScalar(z),q.halfWidth.set(C.width*.5,0,0),q.halfHeight.set(0,C.height*.5,0),i.rectArea[m]=q,m++}else if(C.isPointLight){const q=e.get(C);if(q.color.copy(C.color).multiplyScalar(C.intensity),q.distance=C.distance,q.decay=C.decay,C.castShadow){const j=C.shadow,K=t.get(C);K.shadowIntensity=j.intensity,K.shadowBias=j.bias,K.shadowNormalBias=j.normalBias,K.shadowRadius=j.radius,K.shadowMapSize=j.mapSize,K.shadowCameraNear=j.camera.near,K.shadowCameraFar=j.camera.far,i.pointShadow[_]=K,i.pointShadowMap[_]=W,i.pointShadowMatrix[_]=C.shadow.matrix,b++}i.point[_]=q,_++}else if(C.isHemisphereLight){const q=e.get(C);q.skyColor.copy(C.color).multiplyScalar(z),q.groundColor.copy(C.groundColor).multiplyScalar(z),i.hemi[p]=q,p++}}m>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=Ee.LTC_FLOAT_1,i.rectAreaLTC2=Ee.LTC_FLOAT_2):(i.rectAreaLTC1=Ee.LTC_HALF_1,i.rectAreaLTC2=Ee.LTC_HALF_2)),i.ambient[0]=u,i.ambient[1]=f,i.ambient[2]=d;const N=i.hash;(N.directionalLength!==h||N.pointLength!==_||N.spotLength!==x||N.rectAreaLength!==m||N.hemiLength!==p||N.numDirectionalShadows!==M||N.numPointShadows!==b||N.numSpotShadows!==v||N.numSpotMaps!==L||N.numLightProbes!==U)&&(i.directional.length=h,i.spot.length=x,i.rectArea.length=m,i.point.length=_,i.hemi.length=p,i.directionalShadow.length=M,i.directionalShadowMap.length=M,i.pointShadow.length=b,i.pointShadowMap.length=b,i.spotShadow.length=v,i.spotShadowMap.length=v,i.directionalShadowMatrix.length=M,i.pointShadowMatrix.length=b,i.spotLightMatrix.length=v+L-R,i.spotLightMap.length=L,i.numSpotLightShadowsWithMaps=R,i.numLightProbes=U,N.directionalLength=h,N.pointLength=_,N.spotLength=x,N.rectAreaLength=m,N.hemiLength=p,N.numDirectionalShadows=M,N.numPointShadows=b,N.numSpotShadows=v,N.numSpotMaps=L,N.numLightProbes=U,i.version=yw++)}function l(c,u){let f=0,d=0,h=0,_=0,x=0;const m=u.matrixWorldInverse;for(let p=0,M=c.length;p<M;p++){const b=c[p];if(b.isDirectionalLight){const v=i.directional[f];v.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),v.direction.sub(s),v.direction.transformDirection(m),f++}else if(b.isSpotLight){const v=i.spot[h];v.position.setFromMatrixPosition(b.matrixWorld),v.position.applyMatrix4(m),v.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),v.direction.sub(s),v.direction.transformDirection(m),h++}else if(b.isRectAreaLight){const v=i.rectArea[_];v.position.setFromMatrixPosition(b.matrixWorld),v.position.applyMatrix4(m),o.identity(),r.copy(b.matrixWorld),r.premultiply(m),o.extractRotation(r),v.halfWidth.set(b.width*.5,0,0),v.halfHeight.set(0,b.height*.5,0),v.halfWidth.applyMatrix4(o),v.halfHeight.applyMatrix4(o),_++}else if(b.isPointLight){const v=i.point[d];v.position.setFromMatrixPosition(b.matrixWorld),v.position.applyMatrix4(m),d++}else if(b.isHemisphereLight){const v=i.hemi[x];v.direction.setFromMatrixPosition(b.matrixWorld),v.direction.transformDirection(m),x++}}}return{setup:a,setupView:l,state:i}}function jp(n){const e=new Sw(n),t=[],i=[];function s(u){c.camera=u,t.length=0,i.length=0}function r(u){t.push(u)}function o(u){i.push(u)}function a(){e.setup(t)}function l(u){e.setupView(t,u)}const c={lightsArray:t,shadowsArray:i,camera:null,lights:e,transmissionRenderTarget:{}};return{init:s,state:c,setupLights:a,setupLightsView:l,pushLight:r,pushShadow:o}}function Ew(n){let e=new WeakMap;function t(s,r=0){const o=e.get(s);let a;return o===void 0?(a=new jp(n),e.set(s,[a])):r>=o.length?(a=new jp(n),o.push(a)):a=o[r],a}function i(){e=new WeakMap}return{get:t,dispose:i}}const bw=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,ww=`uniform sampler2D shadow_pass;
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
}`;function Tw(n,e,t){let i=new ff;const s=new Ke,r=new Ke,o=new en,a=new Zy({depthPacking:ey}),l=new Ky,c={},u=t.maxTextureSize,f={[ds]:Jn,[Jn]:ds,[Xi]:Xi},d=new ps({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Ke},radius:{value:4}},vertexShader:bw,fragmentShader:ww}),h=d.clone();h.defines.HORIZONTAL_PASS=1;const _=new rn;_.setAttribute("position",new Pn(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));const x=new be(_,d),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=C_;let p=this.type;this.render=function(R,U,N){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||R.length===0)return;const T=n.getRenderTarget(),E=n.getActiveCubeFace(),C=n.getActiveMipmapLevel(),B=n.state;B.setBlending(Ns),B.buffers.depth.getReversed()===!0?B.buffers.color.setClear(0,0,0,0):B.buffers.color.setClear(1,1,1,1),B.buffers.depth.setTest(!0),B.setScissorTest(!1);const z=p!==as&&this.type===as,X=p===as&&this.type!==as;for(let W=0,q=R.length;W<q;W++){const j=R[W],K=j.shadow;if(K===void 0){console.warn("THREE.WebGLShadowMap:",j,"has no shadow.");continue}if(K.autoUpdate===!1&&K.needsUpdate===!1)continue;s.copy(K.mapSize);const re=K.getFrameExtents();if(s.multiply(re),r.copy(K.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/re.x),s.x=r.x*re.x,K.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/re.y),s.y=r.y*re.y,K.mapSize.y=r.y)),K.map===null||z===!0||X===!0){const me=this.type!==as?{minFilter:li,magFilter:li}:{};K.map!==null&&K.map.dispose(),K.map=new yr(s.x,s.y,me),K.map.texture.name=j.name+".shadowMap",K.camera.updateProjectionMatrix()}n.setRenderTarget(K.map),n.clear();const ae=K.getViewportCount();for(let me=0;me<ae;me++){const xe=K.getViewport(me);o.set(r.x*xe.x,r.y*xe.y,r.x*xe.z,r.y*xe.w),B.viewport(o),K.updateMatrices(j,me),i=K.getFrustum(),v(U,N,K.camera,j,this.type)}K.isPointLightShadow!==!0&&this.type===as&&M(K,N),K.needsUpdate=!1}p=this.type,m.needsUpdate=!1,n.setRenderTarget(T,E,C)};function M(R,U){const N=e.update(x);d.defines.VSM_SAMPLES!==R.blurSamples&&(d.defines.VSM_SAMPLES=R.blurSamples,h.defines.VSM_SAMPLES=R.blurSamples,d.needsUpdate=!0,h.needsUpdate=!0),R.mapPass===null&&(R.mapPass=new yr(s.x,s.y)),d.uniforms.shadow_pass.value=R.map.texture,d.uniforms.resolution.value=R.mapSize,d.uniforms.radius.value=R.radius,n.setRenderTarget(R.mapPass),n.clear(),n.renderBufferDirect(U,null,N,d,x,null),h.uniforms.shadow_pass.value=R.mapPass.texture,h.uniforms.resolution.value=R.mapSize,h.uniforms.radius.value=R.radius,n.setRenderTarget(R.map),n.clear(),n.renderBufferDirect(U,null,N,h,x,null)}function b(R,U,N,T){let E=null;const C=N.isPointLight===!0?R.customDistanceMaterial:R.customDepthMaterial;if(C!==void 0)E=C;else if(E=N.isPointLight===!0?l:a,n.localClippingEnabled&&U.clipShadows===!0&&Array.isArray(U.clippingPlanes)&&U.clippingPlanes.length!==0||U.displacementMap&&U.displacementScale!==0||U.alphaMap&&U.alphaTest>0||U.map&&U.alphaTest>0||U.alphaToCoverage===!0){const B=E.uuid,z=U.uuid;let X=c[B];X===void 0&&(X={},c[B]=X);let W=X[z];W===void 0&&(W=E.clone(),X[z]=W,U.addEventListener("dispose",L)),E=W}if(E.visible=U.visible,E.wireframe=U.wireframe,T===as?E.side=U.shadowSide!==null?U.shadowSide:U.side:E.side=U.shadowSide!==null?U.shadowSide:f[U.side],E.alphaMap=U.alphaMap,E.alphaTest=U.alphaToCoverage===!0?.5:U.alphaTest,E.map=U.map,E.clipShadows=U.clipShadows,E.clippingPlanes=U.clippingPlanes,E.clipIntersection=U.clipIntersection,E.displacementMap=U.displacementMap,E.displacementScale=U.displacementScale,E.displacementBias=U.displacementBias,E.wireframeLinewidth=U.wireframeLinewidth,E.linewidth=U.linewidth,N.isPointLight===!0&&E.isMeshDistanceMaterial===!0){const B=n.properties.get(E);B.light=N}return E}function v(R,U,N,T,E){if(R.visible===!1)return;if(R.layers.test(U.layers)&&(R.isMesh||R.isLine||R.isPoints)&&(R.castShadow||R.receiveShadow&&E===as)&&(!R.frustumCulled||i.intersectsObject(R))){R.modelViewMatrix.multiplyMatrices(N.matrixWorldInverse,R.matrixWorld);const z=e.update(R),X=R.material;if(Array.isArray(X)){const W=z.groups;for(let q=0,j=W.length;q<j;q++){const K=W[q],re=X[K.materialIndex];if(re&&re.visible){const ae=b(R,re,T,E);R.onBeforeShadow(n,R,U,N,z,ae,K),n.renderBufferDirect(N,null,z,ae,R,K),R.onAfterShadow(n,R,U,N,z,ae,K)}}}else if(X.visible){const W=b(R,X,T,E);R.onBeforeShadow(n,R,U,N,z,W,null),n.renderBufferDirect(N,null,z,W,R,null),R.onAfterShadow(n,R,U,N,z,W,null)}}const B=R.children;for(let z=0,X=B.length;z<X;z++)v(B[z],U,N,T,E)}function L(R){R.target.removeEventListener("dispose",L);for(const N in c){const T=c[N],E=R.target.uuid;E in T&&(T[E].dispose(),delete T[E])}}}const Aw={[Bu]:zu,[Hu]:Wu,[Vu]:Xu,[_o]:Gu,[zu]:Bu,[Wu]:Hu,[Xu]:Vu,[Gu]:_o};function Rw(n,e){function t(){let H=!1;const fe=new en;let pe=null;const De=new en(0,0,0,0);return{setMask:function(ue){pe!==ue&&!H&&(n.colorMask(ue,ue,ue,ue),pe=ue)},setLocked:function(ue){H=ue},setClear:function(ue,oe,Oe,nt,Dt){Dt===!0&&(ue*=nt,oe*=nt,Oe*=nt),fe.set(ue,oe,Oe,nt),De.equals(fe)===!1&&(n.clearColor(ue,oe,Oe,nt),De.copy(fe))},reset:function(){H=!1,pe=null,De.set(-1,0,0,0)}}}function i(){let H=!1,fe=!1,pe=null,De=null,ue=null;return{setReversed:function(oe){if(fe!==oe){const Oe=e.get("EXT_clip_control");oe?Oe.clipControlEXT(Oe.LOWER_LEFT_EXT,Oe.ZERO_TO_ONE_EXT):Oe.clipControlEXT(Oe.LOWER_LEFT_EXT,Oe.NEGATIVE_ONE_TO_ONE_EXT),fe=oe;const nt=ue;ue=null,this.setClear(nt)}},getReversed:function(){return fe},setTest:function(oe){oe?ne(n.DEPTH_TEST):we(n.DEPTH_TEST)},setMask:function(oe){pe!==oe&&!H&&(n.depthMask(oe),pe=oe)},setFunc:function(oe){if(fe&&(oe=Aw[oe]),De!==oe){switch(oe){case Bu:n.depthFunc(n.NEVER);break;case zu:n.depthFunc(n.ALWAYS);break;case Hu:n.depthFunc(n.LESS);break;case _o:n.depthFunc(n.LEQUAL);break;case Vu:n.depthFunc(n.EQUAL);break;case Gu:n.depthFunc(n.GEQUAL);break;case Wu:n.depthFunc(n.GREATER);break;case Xu:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}De=oe}},setLocked:function(oe){H=oe},setClear:function(oe){ue!==oe&&(fe&&(oe=1-oe),n.clearDepth(oe),ue=oe)},reset:function(){H=!1,pe=null,De=null,ue=null,fe=!1}}}function s(){let H=!1,fe=null,pe=null,De=null,ue=null,oe=null,Oe=null,nt=null,Dt=null;return{setTest:function(_t){H||(_t?ne(n.STENCIL_TEST):we(n.STENCIL_TEST))},setMask:function(_t){fe!==_t&&!H&&(n.stencilMask(_t),fe=_t)},setFunc:function(_t,Tn,Nt){(pe!==_t||De!==Tn||ue!==Nt)&&(n.stencilFunc(_t,Tn,Nt),pe=_t,De=Tn,ue=Nt)},setOp:function(_t,Tn,Nt){(oe!==_t||Oe!==Tn||nt!==Nt)&&(n.stencilOp(_t,Tn,Nt),oe=_t,Oe=Tn,nt=Nt)},setLocked:function(_t){H=_t},setClear:function(_t){Dt!==_t&&(n.clearStencil(_t),Dt=_t)},reset:function(){H=!1,fe=null,pe=null,De=null,ue=null,oe=null,Oe=null,nt=null,Dt=null}}}const r=new t,o=new i,a=new s,l=new WeakMap,c=new WeakMap;let u={},f={},d=new WeakMap,h=[],_=null,x=!1,m=null,p=null,M=null,b=null,v=null,L=null,R=null,U=new Je(0,0,0),N=0,T=!1,E=null,C=null,B=null,z=null,X=null;const W=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS);let q=!1,j=0;const K=n.getParameter(n.VERSION);K.indexOf("WebGL")!==-1?(j=parseFloat(/^WebGL (\d)/.exec(K)[1]),q=j>=1):K.indexOf("OpenGL ES")!==-1&&(j=parseFloat(/^OpenGL ES (\d)/.exec(K)[1]),q=j>=2);let re=null,ae={};const me=n.getParameter(n.SCISSOR_BOX),xe=n.getParameter(n.VIEWPORT),ge=new en().fromArray(me),Qe=new en().fromArray(xe);function et(H,fe,pe,De){const ue=new Uint8Array(4),oe=n.createTexture();n.bindTexture(H,oe),n.texParameteri(H,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(H,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let Oe=0;Oe<pe;Oe++)H===n.TEXTURE_3D||H===n.TEXTURE_2D_ARRAY?n.texImage3D(fe,0,n.RGBA,1,1,De,0,n.RGBA,n.UNSIGNED_BYTE,ue):n.texImage2D(fe+Oe,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,ue);return oe}const ee={};ee[n.TEXTURE_2D]=et(n.TEXTURE_2D,n.TEXTURE_2D,1),ee[n.TEXTURE_CUBE_MAP]=et(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),ee[n.TEXTURE_2D_ARRAY]=et(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),ee[n.TEXTURE_3D]=et(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),ne(n.DEPTH_TEST),o.setFunc(_o),We(!1),Ne(Vd),ne(n.CULL_FACE),mt(Ns);function ne(H){u[H]!==!0&&(n.enable(H),u[H]=!0)}function we(H){u[H]!==!1&&(n.disable(H),u[H]=!1)}function ze(H,fe){return f[H]!==fe?(n.bindFramebuffer(H,fe),f[H]=fe,H===n.DRAW_FRAMEBUFFER&&(f[n.FRAMEBUFFER]=fe),H===n.FRAMEBUFFER&&(f[n.DRAW_FRAMEBUFFER]=fe),!0):!1}function ye(H,fe){let pe=h,De=!1;if(H){pe=d.get(fe),pe===void 0&&(pe=[],d.set(fe,pe));const ue=H.textures;if(pe.length!==ue.length||pe[0]!==n.COLOR_ATTACHMENT0){for(let oe=0,Oe=ue.length;oe<Oe;oe++)pe[oe]=n.COLOR_ATTACHMENT0+oe;pe.length=ue.length,De=!0}}else pe[0]!==n.BACK&&(pe[0]=n.BACK,De=!0);De&&n.drawBuffers(pe)}function tt(H){return _!==H?(n.useProgram(H),_=H,!0):!1}const Bt={[lr]:n.FUNC_ADD,[Ax]:n.FUNC_SUBTRACT,[Rx]:n.FUNC_REVERSE_SUBTRACT};Bt[Cx]=n.MIN,Bt[Px]=n.MAX;const F={[Dx]:n.ZERO,[Lx]:n.ONE,[Ix]:n.SRC_COLOR,[Ou]:n.SRC_ALPHA,[Bx]:n.SRC_ALPHA_SATURATE,[Ox]:n.DST_COLOR,[Nx]:n.DST_ALPHA,[Ux]:n.ONE_MINUS_SRC_COLOR,[ku]:n.ONE_MINUS_SRC_ALPHA,[kx]:n.ONE_MINUS_DST_COLOR,[Fx]:n.ONE_MINUS_DST_ALPHA,[zx]:n.CONSTANT_COLOR,[Hx]:n.ONE_MINUS_CONSTANT_COLOR,[Vx]:n.CONSTANT_ALPHA,[Gx]:n.ONE_MINUS_CONSTANT_ALPHA};function mt(H,fe,pe,De,ue,oe,Oe,nt,Dt,_t){if(H===Ns){x===!0&&(we(n.BLEND),x=!1);return}if(x===!1&&(ne(n.BLEND),x=!0),H!==Tx){if(H!==m||_t!==T){if((p!==lr||v!==lr)&&(n.blendEquation(n.FUNC_ADD),p=lr,v=lr),_t)switch(H){case so:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Gd:n.blendFunc(n.ONE,n.ONE);break;case Wd:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case Xd:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:console.error("THREE.WebGLState: Invalid blending: ",H);break}else switch(H){case so:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Gd:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case Wd:console.error("THREE.WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Xd:console.error("THREE.WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:console.error("THREE.WebGLState: Invalid blending: ",H);break}M=null,b=null,L=null,R=null,U.set(0,0,0),N=0,m=H,T=_t}return}ue=ue||fe,oe=oe||pe,Oe=Oe||De,(fe!==p||ue!==v)&&(n.blendEquationSeparate(Bt[fe],Bt[ue]),p=fe,v=ue),(pe!==M||De!==b||oe!==L||Oe!==R)&&(n.blendFuncSeparate(F[pe],F[De],F[oe],F[Oe]),M=pe,b=De,L=oe,R=Oe),(nt.equals(U)===!1||Dt!==N)&&(n.blendColor(nt.r,nt.g,nt.b,Dt),U.copy(nt),N=Dt),m=H,T=!1}function $e(H,fe){H.side===Xi?we(n.CULL_FACE):ne(n.CULL_FACE);let pe=H.side===Jn;fe&&(pe=!pe),We(pe),H.blending===so&&H.transparent===!1?mt(Ns):mt(H.blending,H.blendEquation,H.blendSrc,H.blendDst,H.blendEquationAlpha,H.blendSrcAlpha,H.blendDstAlpha,H.blendColor,H.blendAlpha,H.premultipliedAlpha),o.setFunc(H.depthFunc),o.setTest(H.depthTest),o.setMask(H.depthWrite),r.setMask(H.colorWrite);const De=H.stencilWrite;a.setTest(De),De&&(a.setMask(H.stencilWriteMask),a.setFunc(H.stencilFunc,H.stencilRef,H.stencilFuncMask),a.setOp(H.stencilFail,H.stencilZFail,H.stencilZPass)),Pe(H.polygonOffset,H.polygonOffsetFactor,H.polygonOffsetUnits),H.alphaToCoverage===!0?ne(n.SAMPLE_ALPHA_TO_COVERAGE):we(n.SAMPLE_ALPHA_TO_COVERAGE)}function We(H){E!==H&&(H?n.frontFace(n.CW):n.frontFace(n.CCW),E=H)}function Ne(H){H!==bx?(ne(n.CULL_FACE),H!==C&&(H===Vd?n.cullFace(n.BACK):H===wx?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):we(n.CULL_FACE),C=H}function At(H){H!==B&&(q&&n.lineWidth(H),B=H)}function Pe(H,fe,pe){H?(ne(n.POLYGON_OFFSET_FILL),(z!==fe||X!==pe)&&(n.polygonOffset(fe,pe),z=fe,X=pe)):we(n.POLYGON_OFFSET_FILL)}function Ge(H){H?ne(n.SCISSOR_TEST):we(n.SCISSOR_TEST)}function Gt(H){H===void 0&&(H=n.TEXTURE0+W-1),re!==H&&(n.activeTexture(H),re=H)}function Mt(H,fe,pe){pe===void 0&&(re===null?pe=n.TEXTURE0+W-1:pe=re);let De=ae[pe];De===void 0&&(De={type:void 0,texture:void 0},ae[pe]=De),(De.type!==H||De.texture!==fe)&&(re!==pe&&(n.activeTexture(pe),re=pe),n.bindTexture(H,fe||ee[H]),De.type=H,De.texture=fe)}function D(){const H=ae[re];H!==void 0&&H.type!==void 0&&(n.bindTexture(H.type,null),H.type=void 0,H.texture=void 0)}function y(){try{n.compressedTexImage2D(...arguments)}catch(H){console.error("THREE.WebGLState:",H)}}function O(){try{n.compressedTexImage3D(...arguments)}catch(H){console.error("THREE.WebGLState:",H)}}function J(){try{n.texSubImage2D(...arguments)}catch(H){console.error("THREE.WebGLState:",H)}}function ie(){try{n.texSubImage3D(...arguments)}catch(H){console.error("THREE.WebGLState:",H)}}function te(){try{n.compressedTexSubImage2D(...arguments)}catch(H){console.error("THREE.WebGLState:",H)}}function Fe(){try{n.compressedTexSubImage3D(...arguments)}catch(H){console.error("THREE.WebGLState:",H)}}function he(){try{n.texStorage2D(...arguments)}catch(H){console.error("THREE.WebGLState:",H)}}function Le(){try{n.texStorage3D(...arguments)}catch(H){console.error("THREE.WebGLState:",H)}}function Re(){try{n.texImage2D(...arguments)}catch(H){console.error("THREE.WebGLState:",H)}}function le(){try{n.texImage3D(...arguments)}catch(H){console.error("THREE.WebGLState:",H)}}function ve(H){ge.equals(H)===!1&&(n.scissor(H.x,H.y,H.z,H.w),ge.copy(H))}function Be(H){Qe.equals(H)===!1&&(n.viewport(H.x,H.y,H.z,H.w),Qe.copy(H))}function ke(H,fe){let pe=c.get(fe);pe===void 0&&(pe=new WeakMap,c.set(fe,pe));let De=pe.get(H);De===void 0&&(De=n.getUniformBlockIndex(fe,H.name),pe.set(H,De))}function Me(H,fe){const De=c.get(fe).get(H);l.get(fe)!==De&&(n.uniformBlockBinding(fe,De,H.__bindingPointIndex),l.set(fe,De))}function Ze(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),u={},re=null,ae={},f={},d=new WeakMap,h=[],_=null,x=!1,m=null,p=null,M=null,b=null,v=null,L=null,R=null,U=new Je(0,0,0),N=0,T=!1,E=null,C=null,B=null,z=null,X=null,ge.set(0,0,n.canvas.width,n.canvas.height),Qe.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:ne,disable:we,bindFramebuffer:ze,drawBuffers:ye,useProgram:tt,setBlending:mt,setMaterial:$e,setFlipSided:We,setCullFace:Ne,setLineWidth:At,setPolygonOffset:Pe,setScissorTest:Ge,activeTexture:Gt,bindTexture:Mt,unbindTexture:D,compressedTexImage2D:y,compressedTexImage3D:O,texImage2D:Re,texImage3D:le,updateUBOMapping:ke,uniformBlockBinding:Me,texStorage2D:he,texStorage3D:Le,texSubImage2D:J,texSubImage3D:ie,compressedTexSubImage2D:te,compressedTexSubImage3D:Fe,scissor:ve,viewport:Be,reset:Ze}}function Cw(n,e,t,i,s,r,o){const a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Ke,u=new WeakMap;let f;const d=new WeakMap;let h=!1;try{h=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function _(D,y){return h?new OffscreenCanvas(D,y):ql("canvas")}function x(D,y,O){let J=1;const ie=Mt(D);if((ie.width>O||ie.height>O)&&(J=O/Math.max(ie.width,ie.height)),J<1)if(typeof HTMLImageElement<"u"&&D instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&D instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&D instanceof ImageBitmap||typeof VideoFrame<"u"&&D instanceof VideoFrame){const te=Math.floor(J*ie.width),Fe=Math.floor(J*ie.height);f===void 0&&(f=_(te,Fe));const he=y?_(te,Fe):f;return he.width=te,he.height=Fe,he.getContext("2d").drawImage(D,0,0,te,Fe),console.warn("THREE.WebGLRenderer: Texture has been resized from ("+ie.width+"x"+ie.height+") to ("+te+"x"+Fe+")."),he}else return"data"in D&&console.warn("THREE.WebGLRenderer: Image in DataTexture is too big ("+ie.width+"x"+ie.height+")."),D;return D}function m(D){return D.generateMipmaps}function p(D){n.generateMipmap(D)}function M(D){return D.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:D.isWebGL3DRenderTarget?n.TEXTURE_3D:D.isWebGLArrayRenderTarget||D.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function b(D,y,O,J,ie=!1){if(D!==null){if(n[D]!==void 0)return n[D];console.warn("THREE.WebGLRenderer: Attempt to use non-existing WebGL internal format '"+D+"'")}let te=y;if(y===n.RED&&(O===n.FLOAT&&(te=n.R32F),O===n.HALF_FLOAT&&(te=n.R16F),O===n.UNSIGNED_BYTE&&(te=n.R8)),y===n.RED_INTEGER&&(O===n.UNSIGNED_BYTE&&(te=n.R8UI),O===n.UNSIGNED_SHORT&&(te=n.R16UI),O===n.UNSIGNED_INT&&(te=n.R32UI),O===n.BYTE&&(te=n.R8I),O===n.SHORT&&(te=n.R16I),O===n.INT&&(te=n.R32I)),y===n.RG&&(O===n.FLOAT&&(te=n.RG32F),O===n.HALF_FLOAT&&(te=n.RG16F),O===n.UNSIGNED_BYTE&&(te=n.RG8)),y===n.RG_INTEGER&&(O===n.UNSIGNED_BYTE&&(te=n.RG8UI),O===n.UNSIGNED_SHORT&&(te=n.RG16UI),O===n.UNSIGNED_INT&&(te=n.RG32UI),O===n.BYTE&&(te=n.RG8I),O===n.SHORT&&(te=n.RG16I),O===n.INT&&(te=n.RG32I)),y===n.RGB_INTEGER&&(O===n.UNSIGNED_BYTE&&(te=n.RGB8UI),O===n.UNSIGNED_SHORT&&(te=n.RGB16UI),O===n.UNSIGNED_INT&&(te=n.RGB32UI),O===n.BYTE&&(te=n.RGB8I),O===n.SHORT&&(te=n.RGB16I),O===n.INT&&(te=n.RGB32I)),y===n.RGBA_INTEGER&&(O===n.UNSIGNED_BYTE&&(te=n.RGBA8UI),O===n.UNSIGNED_SHORT&&(te=n.RGBA16UI),O===n.UNSIGNED_INT&&(te=n.RGBA32UI),O===n.BYTE&&(te=n.RGBA8I),O===n.SHORT&&(te=n.RGBA16I),O===n.INT&&(te=n.RGBA32I)),y===n.RGB&&(O===n.UNSIGNED_INT_5_9_9_9_REV&&(te=n.RGB9_E5),O===n.UNSIGNED_INT_10F_11F_11F_REV&&(te=n.R11F_G11F_B10F)),y===n.RGBA){const Fe=ie?Xl:xt.getTransfer(J);O===n.FLOAT&&(te=n.RGBA32F),O===n.HALF_FLOAT&&(te=n.RGBA16F),O===n.UNSIGNED_BYTE&&(te=Fe===It?n.SRGB8_ALPHA8:n.RGBA8),O===n.UNSIGNED_SHORT_4_4_4_4&&(te=n.RGBA4),O===n.UNSIGNED_SHORT_5_5_5_1&&(te=n.RGB5_A1)}return(te===n.R16F||te===n.R32F||te===n.RG16F||te===n.RG32F||te===n.RGBA16F||te===n.RGBA32F)&&e.get("EXT_color_buffer_float"),te}function v(D,y){let O;return D?y===null||y===xr||y===Ea?O=n.DEPTH24_STENCIL8:y===qi?O=n.DEPTH32F_STENCIL8:y===Sa&&(O=n.DEPTH24_STENCIL8,console.warn("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):y===null||y===xr||y===Ea?O=n.DEPTH_COMPONENT24:y===qi?O=n.DEPTH_COMPONENT32F:y===Sa&&(O=n.DEPTH_COMPONENT16),O}function L(D,y){return m(D)===!0||D.isFramebufferTexture&&D.minFilter!==li&&D.minFilter!==Yi?Math.log2(Math.max(y.width,y.height))+1:D.mipmaps!==void 0&&D.mipmaps.length>0?D.mipmaps.length:D.isCompressedTexture&&Array.isArray(D.image)?y.mipmaps.length:1}function R(D){const y=D.target;y.removeEventListener("dispose",R),N(y),y.isVideoTexture&&u.delete(y)}function U(D){const y=D.target;y.removeEventListener("dispose",U),E(y)}function N(D){const y=i.get(D);if(y.__webglInit===void 0)return;const O=D.source,J=d.get(O);if(J){const ie=J[y.__cacheKey];ie.usedTimes--,ie.usedTimes===0&&T(D),Object.keys(J).length===0&&d.delete(O)}i.remove(D)}function T(D){const y=i.get(D);n.deleteTexture(y.__webglTexture);const O=D.source,J=d.get(O);delete J[y.__cacheKey],o.memory.textures--}function E(D){const y=i.get(D);if(D.depthTexture&&(D.depthTexture.dispose(),i.remove(D.depthTexture)),D.isWebGLCubeRenderTarget)for(let J=0;J<6;J++){if(Array.isArray(y.__webglFramebuffer[J]))for(let ie=0;ie<y.__webglFramebuffer[J].length;ie++)n.deleteFramebuffer(y.__webglFramebuffer[J][ie]);else n.deleteFramebuffer(y.__webglFramebuffer[J]);y.__webglDepthbuffer&&n.deleteRenderbuffer(y.__webglDepthbuffer[J])}else{if(Array.isArray(y.__webglFramebuffer))for(let J=0;J<y.__webglFramebuffer.length;J++)n.deleteFramebuffer(y.__webglFramebuffer[J]);else n.deleteFramebuffer(y.__webglFramebuffer);if(y.__webglDepthbuffer&&n.deleteRenderbuffer(y.__webglDepthbuffer),y.__webglMultisampledFramebuffer&&n.deleteFramebuffer(y.__webglMultisampledFramebuffer),y.__webglColorRenderbuffer)for(let J=0;J<y.__webglColorRenderbuffer.length;J++)y.__webglColorRenderbuffer[J]&&n.deleteRenderbuffer(y.__webglColorRenderbuffer[J]);y.__webglDepthRenderbuffer&&n.deleteRenderbuffer(y.__webglDepthRenderbuffer)}const O=D.textures;for(let J=0,ie=O.length;J<ie;J++){const te=i.get(O[J]);te.__webglTexture&&(n.deleteTexture(te.__webglTexture),o.memory.textures--),i.remove(O[J])}i.remove(D)}let C=0;function B(){C=0}function z(){const D=C;return D>=s.maxTextures&&console.warn("THREE.WebGLTextures: Trying to use "+D+" texture units while this GPU supports only "+s.maxTextures),C+=1,D}function X(D){const y=[];return y.push(D.wrapS),y.push(D.wrapT),y.push(D.wrapR||0),y.push(D.magFilter),y.push(D.minFilter),y.push(D.anisotropy),y.push(D.internalFormat),y.push(D.format),y.push(D.type),y.push(D.generateMipmaps),y.push(D.premultiplyAlpha),y.push(D.flipY),y.push(D.unpackAlignment),y.push(D.colorSpace),y.join()}function W(D,y){const O=i.get(D);if(D.isVideoTexture&&Ge(D),D.isRenderTargetTexture===!1&&D.isExternalTexture!==!0&&D.version>0&&O.__version!==D.version){const J=D.image;if(J===null)console.warn("THREE.WebGLRenderer: Texture marked for update but no image data found.");else if(J.complete===!1)console.warn("THREE.WebGLRenderer: Texture marked for update but image is incomplete");else{ee(O,D,y);return}}else D.isExternalTexture&&(O.__webglTexture=D.sourceTexture?D.sourceTexture:null);t.bindTexture(n.TEXTURE_2D,O.__webglTexture,n.TEXTURE0+y)}function q(D,y){const O=i.get(D);if(D.isRenderTargetTexture===!1&&D.version>0&&O.__version!==D.version){ee(O,D,y);return}t.bindTexture(n.TEXTURE_2D_ARRAY,O.__webglTexture,n.TEXTURE0+y)}function j(D,y){const O=i.get(D);if(D.isRenderTargetTexture===!1&&D.version>0&&O.__version!==D.version){ee(O,D,y);return}t.bindTexture(n.TEXTURE_3D,O.__webglTexture,n.TEXTURE0+y)}function K(D,y){const O=i.get(D);if(D.version>0&&O.__version!==D.version){ne(O,D,y);return}t.bindTexture(n.TEXTURE_CUBE_MAP,O.__webglTexture,n.TEXTURE0+y)}const re={[$u]:n.REPEAT,[fr]:n.CLAMP_TO_EDGE,[ju]:n.MIRRORED_REPEAT},ae={[li]:n.NEAREST,[Jx]:n.NEAREST_MIPMAP_NEAREST,[Xa]:n.NEAREST_MIPMAP_LINEAR,[Yi]:n.LINEAR,[Fc]:n.LINEAR_MIPMAP_NEAREST,[dr]:n.LINEAR_MIPMAP_LINEAR},me={[ny]:n.NEVER,[ly]:n.ALWAYS,[iy]:n.LESS,[z_]:n.LEQUAL,[sy]:n.EQUAL,[ay]:n.GEQUAL,[ry]:n.GREATER,[oy]:n.NOTEQUAL};function xe(D,y){if(y.type===qi&&e.has("OES_texture_float_linear")===!1&&(y.magFilter===Yi||y.magFilter===Fc||y.magFilter===Xa||y.magFilter===dr||y.minFilter===Yi||y.minFilter===Fc||y.minFilter===Xa||y.minFilter===dr)&&console.warn("THREE.WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(D,n.TEXTURE_WRAP_S,re[y.wrapS]),n.texParameteri(D,n.TEXTURE_WRAP_T,re[y.wrapT]),(D===n.TEXTURE_3D||D===n.TEXTURE_2D_ARRAY)&&n.texParameteri(D,n.TEXTURE_WRAP_R,re[y.wrapR]),n.texParameteri(D,n.TEXTURE_MAG_FILTER,ae[y.magFilter]),n.texParameteri(D,n.TEXTURE_MIN_FILTER,ae[y.minFilter]),y.compareFunction&&(n.texParameteri(D,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(D,n.TEXTURE_COMPARE_FUNC,me[y.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(y.magFilter===li||y.minFilter!==Xa&&y.minFilter!==dr||y.type===qi&&e.has("OES_texture_float_linear")===!1)return;if(y.anisotropy>1||i.get(y).__currentAnisotropy){const O=e.get("EXT_texture_filter_anisotropic");n.texParameterf(D,O.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(y.anisotropy,s.getMaxAnisotropy())),i.get(y).__currentAnisotropy=y.anisotropy}}}function ge(D,y){let O=!1;D.__webglInit===void 0&&(D.__webglInit=!0,y.addEventListener("dispose",R));const J=y.source;let ie=d.get(J);ie===void 0&&(ie={},d.set(J,ie));const te=X(y);if(te!==D.__cacheKey){ie[te]===void 0&&(ie[te]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,O=!0),ie[te].usedTimes++;const Fe=ie[D.__cacheKey];Fe!==void 0&&(ie[D.__cacheKey].usedTimes--,Fe.usedTimes===0&&T(y)),D.__cacheKey=te,D.__webglTexture=ie[te].texture}return O}function Qe(D,y,O){return Math.floor(Math.floor(D/O)/y)}function et(D,y,O,J){const te=D.updateRanges;if(te.length===0)t.texSubImage2D(n.TEXTURE_2D,0,0,0,y.width,y.height,O,J,y.data);else{te.sort((le,ve)=>le.start-ve.start);let Fe=0;for(let le=1;le<te.length;le++){const ve=te[Fe],Be=te[le],ke=ve.start+ve.count,Me=Qe(Be.start,y.width,4),Ze=Qe(ve.start,y.width,4);Be.start<=ke+1&&Me===Ze&&Qe(Be.start+Be.count-1,y.width,4)===Me?ve.count=Math.max(ve.count,Be.start+Be.count-ve.start):(++Fe,te[Fe]=Be)}te.length=Fe+1;const he=n.getParameter(n.UNPACK_ROW_LENGTH),Le=n.getParameter(n.UNPACK_SKIP_PIXELS),Re=n.getParameter(n.UNPACK_SKIP_ROWS);n.pixelStorei(n.UNPACK_ROW_LENGTH,y.width);for(let le=0,ve=te.length;le<ve;le++){const Be=te[le],ke=Math.floor(Be.start/4),Me=Math.ceil(Be.count/4),Ze=ke%y.width,H=Math.floor(ke/y.width),fe=Me,pe=1;n.pixelStorei(n.UNPACK_SKIP_PIXELS,Ze),n.pixelStorei(n.UNPACK_SKIP_ROWS,H),t.texSubImage2D(n.TEXTURE_2D,0,Ze,H,fe,pe,O,J,y.data)}D.clearUpdateRanges(),n.pixelStorei(n.UNPACK_ROW_LENGTH,he),n.pixelStorei(n.UNPACK_SKIP_PIXELS,Le),n.pixelStorei(n.UNPACK_SKIP_ROWS,Re)}}function ee(D,y,O){let J=n.TEXTURE_2D;(y.isDataArrayTexture||y.isCompressedArrayTexture)&&(J=n.TEXTURE_2D_ARRAY),y.isData3DTexture&&(J=n.TEXTURE_3D);const ie=ge(D,y),te=y.source;t.bindTexture(J,D.__webglTexture,n.TEXTURE0+O);const Fe=i.get(te);if(te.version!==Fe.__version||ie===!0){t.activeTexture(n.TEXTURE0+O);const he=xt.getPrimaries(xt.workingColorSpace),Le=y.colorSpace===Is?null:xt.getPrimaries(y.colorSpace),Re=y.colorSpace===Is||he===Le?n.NONE:n.BROWSER_DEFAULT_WEBGL;n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,y.flipY),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,y.premultiplyAlpha),n.pixelStorei(n.UNPACK_ALIGNMENT,y.unpackAlignment),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,Re);let le=x(y.image,!1,s.maxTextureSize);le=Gt(y,le);const ve=r.convert(y.format,y.colorSpace),Be=r.convert(y.type);let ke=b(y.internalFormat,ve,Be,y.colorSpace,y.isVideoTexture);xe(J,y);let Me;const Ze=y.mipmaps,H=y.isVideoTexture!==!0,fe=Fe.__version===void 0||ie===!0,pe=te.dataReady,De=L(y,le);if(y.isDepthTexture)ke=v(y.format===wa,y.type),fe&&(H?t.texStorage2D(n.TEXTURE_2D,1,ke,le.width,le.height):t.texImage2D(n.TEXTURE_2D,0,ke,le.width,le.height,0,ve,Be,null));else if(y.isDataTexture)if(Ze.length>0){H&&fe&&t.texStorage2D(n.TEXTURE_2D,De,ke,Ze[0].width,Ze[0].height);for(let ue=0,oe=Ze.length;ue<oe;ue++)Me=Ze[ue],H?pe&&t.texSubImage2D(n.TEXTURE_2D,ue,0,0,Me.width,Me.height,ve,Be,Me.data):t.texImage2D(n.TEXTURE_2D,ue,ke,Me.width,Me.height,0,ve,Be,Me.data);y.generateMipmaps=!1}else H?(fe&&t.texStorage2D(n.TEXTURE_2D,De,ke,le.width,le.height),pe&&et(y,le,ve,Be)):t.texImage2D(n.TEXTURE_2D,0,ke,le.width,le.height,0,ve,Be,le.data);else if(y.isCompressedTexture)if(y.isCompressedArrayTexture){H&&fe&&t.texStorage3D(n.TEXTURE_2D_ARRAY,De,ke,Ze[0].width,Ze[0].height,le.depth);for(let ue=0,oe=Ze.length;ue<oe;ue++)if(Me=Ze[ue],y.format!==Li)if(ve!==null)if(H){if(pe)if(y.layerUpdates.size>0){const Oe=wp(Me.width,Me.height,y.format,y.type);for(const nt of y.layerUpdates){const Dt=Me.data.subarray(nt*Oe/Me.data.BYTES_PER_ELEMENT,(nt+1)*Oe/Me.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ue,0,0,nt,Me.width,Me.height,1,ve,Dt)}y.clearLayerUpdates()}else t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ue,0,0,0,Me.width,Me.height,le.depth,ve,Me.data)}else t.compressedTexImage3D(n.TEXTURE_2D_ARRAY,ue,ke,Me.width,Me.height,le.depth,0,Me.data,0,0);else console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else H?pe&&t.texSubImage3D(n.TEXTURE_2D_ARRAY,ue,0,0,0,Me.width,Me.height,le.depth,ve,Be,Me.data):t.texImage3D(n.TEXTURE_2D_ARRAY,ue,ke,Me.width,Me.height,le.depth,0,ve,Be,Me.data)}else{H&&fe&&t.texStorage2D(n.TEXTURE_2D,De,ke,Ze[0].width,Ze[0].height);for(let ue=0,oe=Ze.length;ue<oe;ue++)Me=Ze[ue],y.format!==Li?ve!==null?H?pe&&t.compressedTexSubImage2D(n.TEXTURE_2D,ue,0,0,Me.width,Me.height,ve,Me.data):t.compressedTexImage2D(n.TEXTURE_2D,ue,ke,Me.width,Me.height,0,Me.data):console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):H?pe&&t.texSubImage2D(n.TEXTURE_2D,ue,0,0,Me.width,Me.height,ve,Be,Me.data):t.texImage2D(n.TEXTURE_2D,ue,ke,Me.width,Me.height,0,ve,Be,Me.data)}else if(y.isDataArrayTexture)if(H){if(fe&&t.texStorage3D(n.TEXTURE_2D_ARRAY,De,ke,le.width,le.height,le.depth),pe)if(y.layerUpdates.size>0){const ue=wp(le.width,le.height,y.format,y.type);for(const oe of y.layerUpdates){const Oe=le.data.subarray(oe*ue/le.data.BYTES_PER_ELEMENT,(oe+1)*ue/le.data.BYTES_PER_ELEMENT);t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,oe,le.width,le.height,1,ve,Be,Oe)}y.clearLayerUpdates()}else t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,le.width,le.height,le.depth,ve,Be,le.data)}else t.texImage3D(n.TEXTURE_2D_ARRAY,0,ke,le.width,le.height,le.depth,0,ve,Be,le.data);else if(y.isData3DTexture)H?(fe&&t.texStorage3D(n.TEXTURE_3D,De,ke,le.width,le.height,le.depth),pe&&t.texSubImage3D(n.TEXTURE_3D,0,0,0,0,le.width,le.height,le.depth,ve,Be,le.data)):t.texImage3D(n.TEXTURE_3D,0,ke,le.width,le.height,le.depth,0,ve,Be,le.data);else if(y.isFramebufferTexture){if(fe)if(H)t.texStorage2D(n.TEXTURE_2D,De,ke,le.width,le.height);else{let ue=le.width,oe=le.height;for(let Oe=0;Oe<De;Oe++)t.texImage2D(n.TEXTURE_2D,Oe,ke,ue,oe,0,ve,Be,null),ue>>=1,oe>>=1}}else if(Ze.length>0){if(H&&fe){const ue=Mt(Ze[0]);t.texStorage2D(n.TEXTURE_2D,De,ke,ue.width,ue.height)}for(let ue=0,oe=Ze.length;ue<oe;ue++)Me=Ze[ue],H?pe&&t.texSubImage2D(n.TEXTURE_2D,ue,0,0,ve,Be,Me):t.texImage2D(n.TEXTURE_2D,ue,ke,ve,Be,Me);y.generateMipmaps=!1}else if(H){if(fe){const ue=Mt(le);t.texStorage2D(n.TEXTURE_2D,De,ke,ue.width,ue.height)}pe&&t.texSubImage2D(n.TEXTURE_2D,0,0,0,ve,Be,le)}else t.texImage2D(n.TEXTURE_2D,0,ke,ve,Be,le);m(y)&&p(J),Fe.__version=te.version,y.onUpdate&&y.onUpdate(y)}D.__version=y.version}function ne(D,y,O){if(y.image.length!==6)return;const J=ge(D,y),ie=y.source;t.bindTexture(n.TEXTURE_CUBE_MAP,D.__webglTexture,n.TEXTURE0+O);const te=i.get(ie);if(ie.version!==te.__version||J===!0){t.activeTexture(n.TEXTURE0+O);const Fe=xt.getPrimaries(xt.workingColorSpace),he=y.colorSpace===Is?null:xt.getPrimaries(y.colorSpace),Le=y.colorSpace===Is||Fe===he?n.NONE:n.BROWSER_DEFAULT_WEBGL;n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,y.flipY),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,y.premultiplyAlpha),n.pixelStorei(n.UNPACK_ALIGNMENT,y.unpackAlignment),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,Le);const Re=y.isCompressedTexture||y.image[0].isCompressedTexture,le=y.image[0]&&y.image[0].isDataTexture,ve=[];for(let oe=0;oe<6;oe++)!Re&&!le?ve[oe]=x(y.image[oe],!0,s.maxCubemapSize):ve[oe]=le?y.image[oe].image:y.image[oe],ve[oe]=Gt(y,ve[oe]);const Be=ve[0],ke=r.convert(y.format,y.colorSpace),Me=r.convert(y.type),Ze=b(y.internalFormat,ke,Me,y.colorSpace),H=y.isVideoTexture!==!0,fe=te.__version===void 0||J===!0,pe=ie.dataReady;let De=L(y,Be);xe(n.TEXTURE_CUBE_MAP,y);let ue;if(Re){H&&fe&&t.texStorage2D(n.TEXTURE_CUBE_MAP,De,Ze,Be.width,Be.height);for(let oe=0;oe<6;oe++){ue=ve[oe].mipmaps;for(let Oe=0;Oe<ue.length;Oe++){const nt=ue[Oe];y.format!==Li?ke!==null?H?pe&&t.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+oe,Oe,0,0,nt.width,nt.height,ke,nt.data):t.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+oe,Oe,Ze,nt.width,nt.height,0,nt.data):console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):H?pe&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+oe,Oe,0,0,nt.width,nt.height,ke,Me,nt.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+oe,Oe,Ze,nt.width,nt.height,0,ke,Me,nt.data)}}}else{if(ue=y.mipmaps,H&&fe){ue.length>0&&De++;const oe=Mt(ve[0]);t.texStorage2D(n.TEXTURE_CUBE_MAP,De,Ze,oe.width,oe.height)}for(let oe=0;oe<6;oe++)if(le){H?pe&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+oe,0,0,0,ve[oe].width,ve[oe].height,ke,Me,ve[oe].data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+oe,0,Ze,ve[oe].width,ve[oe].height,0,ke,Me,ve[oe].data);for(let Oe=0;Oe<ue.length;Oe++){const Dt=ue[Oe].image[oe].image;H?pe&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+oe,Oe+1,0,0,Dt.width,Dt.height,ke,Me,Dt.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+oe,Oe+1,Ze,Dt.width,Dt.height,0,ke,Me,Dt.data)}}else{H?pe&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+oe,0,0,0,ke,Me,ve[oe]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+oe,0,Ze,ke,Me,ve[oe]);for(let Oe=0;Oe<ue.length;Oe++){const nt=ue[Oe];H?pe&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+oe,Oe+1,0,0,ke,Me,nt.image[oe]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+oe,Oe+1,Ze,ke,Me,nt.image[oe])}}}m(y)&&p(n.TEXTURE_CUBE_MAP),te.__version=ie.version,y.onUpdate&&y.onUpdate(y)}D.__version=y.version}function we(D,y,O,J,ie,te){const Fe=r.convert(O.format,O.colorSpace),he=r.convert(O.type),Le=b(O.internalFormat,Fe,he,O.colorSpace),Re=i.get(y),le=i.get(O);if(le.__renderTarget=y,!Re.__hasExternalTextures){const ve=Math.max(1,y.width>>te),Be=Math.max(1,y.height>>te);ie===n.TEXTURE_3D||ie===n.TEXTURE_2D_ARRAY?t.texImage3D(ie,te,Le,ve,Be,y.depth,0,Fe,he,null):t.texImage2D(ie,te,Le,ve,Be,0,Fe,he,null)}t.bindFramebuffer(n.FRAMEBUFFER,D),Pe(y)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,J,ie,le.__webglTexture,0,At(y)):(ie===n.TEXTURE_2D||ie>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&ie<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,J,ie,le.__webglTexture,te),t.bindFramebuffer(n.FRAMEBUFFER,null)}function ze(D,y,O){if(n.bindRenderbuffer(n.RENDERBUFFER,D),y.depthBuffer){const J=y.depthTexture,ie=J&&J.isDepthTexture?J.type:null,te=v(y.stencilBuffer,ie),Fe=y.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,he=At(y);Pe(y)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,he,te,y.width,y.height):O?n.renderbufferStorageMultisample(n.RENDERBUFFER,he,te,y.width,y.height):n.renderbufferStorage(n.RENDERBUFFER,te,y.width,y.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,Fe,n.RENDERBUFFER,D)}else{const J=y.textures;for(let ie=0;ie<J.length;ie++){const te=J[ie],Fe=r.convert(te.format,te.colorSpace),he=r.convert(te.type),Le=b(te.internalFormat,Fe,he,te.colorSpace),Re=At(y);O&&Pe(y)===!1?n.renderbufferStorageMultisample(n.RENDERBUFFER,Re,Le,y.width,y.height):Pe(y)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,Re,Le,y.width,y.height):n.renderbufferStorage(n.RENDERBUFFER,Le,y.width,y.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function ye(D,y){if(y&&y.isWebGLCubeRenderTarget)throw new Error("Depth Texture with cube render targets is not supported");if(t.bindFramebuffer(n.FRAMEBUFFER,D),!(y.depthTexture&&y.depthTexture.isDepthTexture))throw new Error("renderTarget.depthTexture must be an instance of THREE.DepthTexture");const J=i.get(y.depthTexture);J.__renderTarget=y,(!J.__webglTexture||y.depthTexture.image.width!==y.width||y.depthTexture.image.height!==y.height)&&(y.depthTexture.image.width=y.width,y.depthTexture.image.height=y.height,y.depthTexture.needsUpdate=!0),W(y.depthTexture,0);const ie=J.__webglTexture,te=At(y);if(y.depthTexture.format===ba)Pe(y)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,n.DEPTH_ATTACHMENT,n.TEXTURE_2D,ie,0,te):n.framebufferTexture2D(n.FRAMEBUFFER,n.DEPTH_ATTACHMENT,n.TEXTURE_2D,ie,0);else if(y.depthTexture.format===wa)Pe(y)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,n.DEPTH_STENCIL_ATTACHMENT,n.TEXTURE_2D,ie,0,te):n.framebufferTexture2D(n.FRAMEBUFFER,n.DEPTH_STENCIL_ATTACHMENT,n.TEXTURE_2D,ie,0);else throw new Error("Unknown depthTexture format")}function tt(D){const y=i.get(D),O=D.isWebGLCubeRenderTarget===!0;if(y.__boundDepthTexture!==D.depthTexture){const J=D.depthTexture;if(y.__depthDisposeCallback&&y.__depthDisposeCallback(),J){const ie=()=>{delete y.__boundDepthTexture,delete y.__depthDisposeCallback,J.removeEventListener("dispose",ie)};J.addEventListener("dispose",ie),y.__depthDisposeCallback=ie}y.__boundDepthTexture=J}if(D.depthTexture&&!y.__autoAllocateDepthBuffer){if(O)throw new Error("target.depthTexture not supported in Cube render targets");const J=D.texture.mipmaps;J&&J.length>0?ye(y.__webglFramebuffer[0],D):ye(y.__webglFramebuffer,D)}else if(O){y.__webglDepthbuffer=[];for(let J=0;J<6;J++)if(t.bindFramebuffer(n.FRAMEBUFFER,y.__webglFramebuffer[J]),y.__webglDepthbuffer[J]===void 0)y.__webglDepthbuffer[J]=n.createRenderbuffer(),ze(y.__webglDepthbuffer[J],D,!1);else{const ie=D.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,te=y.__webglDepthbuffer[J];n.bindRenderbuffer(n.RENDERBUFFER,te),n.framebufferRenderbuffer(n.FRAMEBUFFER,ie,n.RENDERBUFFER,te)}}else{const J=D.texture.mipmaps;if(J&&J.length>0?t.bindFramebuffer(n.FRAMEBUFFER,y.__webglFramebuffer[0]):t.bindFramebuffer(n.FRAMEBUFFER,y.__webglFramebuffer),y.__webglDepthbuffer===void 0)y.__webglDepthbuffer=n.createRenderbuffer(),ze(y.__webglDepthbuffer,D,!1);else{const ie=D.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,te=y.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,te),n.framebufferRenderbuffer(n.FRAMEBUFFER,ie,n.RENDERBUFFER,te)}}t.bindFramebuffer(n.FRAMEBUFFER,null)}function Bt(D,y,O){const J=i.get(D);y!==void 0&&we(J.__webglFramebuffer,D,D.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),O!==void 0&&tt(D)}function F(D){const y=D.texture,O=i.get(D),J=i.get(y);D.addEventListener("dispose",U);const ie=D.textures,te=D.isWebGLCubeRenderTarget===!0,Fe=ie.length>1;if(Fe||(J.__webglTexture===void 0&&(J.__webglTexture=n.createTexture()),J.__version=y.version,o.memory.textures++),te){O.__webglFramebuffer=[];for(let he=0;he<6;he++)if(y.mipmaps&&y.mipmaps.length>0){O.__webglFramebuffer[he]=[];for(let Le=0;Le<y.mipmaps.length;Le++)O.__webglFramebuffer[he][Le]=n.createFramebuffer()}else O.__webglFramebuffer[he]=n.createFramebuffer()}else{if(y.mipmaps&&y.mipmaps.length>0){O.__webglFramebuffer=[];for(let he=0;he<y.mipmaps.length;he++)O.__webglFramebuffer[he]=n.createFramebuffer()}else O.__webglFramebuffer=n.createFramebuffer();if(Fe)for(let he=0,Le=ie.length;he<Le;he++){const Re=i.get(ie[he]);Re.__webglTexture===void 0&&(Re.__webglTexture=n.createTexture(),o.memory.textures++)}if(D.samples>0&&Pe(D)===!1){O.__webglMultisampledFramebuffer=n.createFramebuffer(),O.__webglColorRenderbuffer=[],t.bindFramebuffer(n.FRAMEBUFFER,O.__webglMultisampledFramebuffer);for(let he=0;he<ie.length;he++){const Le=ie[he];O.__webglColorRenderbuffer[he]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,O.__webglColorRenderbuffer[he]);const Re=r.convert(Le.format,Le.colorSpace),le=r.convert(Le.type),ve=b(Le.internalFormat,Re,le,Le.colorSpace,D.isXRRenderTarget===!0),Be=At(D);n.renderbufferStorageMultisample(n.RENDERBUFFER,Be,ve,D.width,D.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+he,n.RENDERBUFFER,O.__webglColorRenderbuffer[he])}n.bindRenderbuffer(n.RENDERBUFFER,null),D.depthBuffer&&(O.__webglDepthRenderbuffer=n.createRenderbuffer(),ze(O.__webglDepthRenderbuffer,D,!0)),t.bindFramebuffer(n.FRAMEBUFFER,null)}}if(te){t.bindTexture(n.TEXTURE_CUBE_MAP,J.__webglTexture),xe(n.TEXTURE_CUBE_MAP,y);for(let he=0;he<6;he++)if(y.mipmaps&&y.mipmaps.length>0)for(let Le=0;Le<y.mipmaps.length;Le++)we(O.__webglFramebuffer[he][Le],D,y,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+he,Le);else we(O.__webglFramebuffer[he],D,y,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+he,0);m(y)&&p(n.TEXTURE_CUBE_MAP),t.unbindTexture()}else if(Fe){for(let he=0,Le=ie.length;he<Le;he++){const Re=ie[he],le=i.get(Re);let ve=n.TEXTURE_2D;(D.isWebGL3DRenderTarget||D.isWebGLArrayRenderTarget)&&(ve=D.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(ve,le.__webglTexture),xe(ve,Re),we(O.__webglFramebuffer,D,Re,n.COLOR_ATTACHMENT0+he,ve,0),m(Re)&&p(ve)}t.unbindTexture()}else{let he=n.TEXTURE_2D;if((D.isWebGL3DRenderTarget||D.isWebGLArrayRenderTarget)&&(he=D.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(he,J.__webglTexture),xe(he,y),y.mipmaps&&y.mipmaps.length>0)for(let Le=0;Le<y.mipmaps.length;Le++)we(O.__webglFramebuffer[Le],D,y,n.COLOR_ATTACHMENT0,he,Le);else we(O.__webglFramebuffer,D,y,n.COLOR_ATTACHMENT0,he,0);m(y)&&p(he),t.unbindTexture()}D.depthBuffer&&tt(D)}function mt(D){const y=D.textures;for(let O=0,J=y.length;O<J;O++){const ie=y[O];if(m(ie)){const te=M(D),Fe=i.get(ie).__webglTexture;t.bindTexture(te,Fe),p(te),t.unbindTexture()}}}const $e=[],We=[];function Ne(D){if(D.samples>0){if(Pe(D)===!1){const y=D.textures,O=D.width,J=D.height;let ie=n.COLOR_BUFFER_BIT;const te=D.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,Fe=i.get(D),he=y.length>1;if(he)for(let Re=0;Re<y.length;Re++)t.bindFramebuffer(n.FRAMEBUFFER,Fe.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+Re,n.RENDERBUFFER,null),t.bindFramebuffer(n.FRAMEBUFFER,Fe.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+Re,n.TEXTURE_2D,null,0);t.bindFramebuffer(n.READ_FRAMEBUFFER,Fe.__webglMultisampledFramebuffer);const Le=D.texture.mipmaps;Le&&Le.length>0?t.bindFramebuffer(n.DRAW_FRAMEBUFFER,Fe.__webglFramebuffer[0]):t.bindFramebuffer(n.DRAW_FRAMEBUFFER,Fe.__webglFramebuffer);for(let Re=0;Re<y.length;Re++){if(D.resolveDepthBuffer&&(D.depthBuffer&&(ie|=n.DEPTH_BUFFER_BIT),D.stencilBuffer&&D.resolveStencilBuffer&&(ie|=n.STENCIL_BUFFER_BIT)),he){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,Fe.__webglColorRenderbuffer[Re]);const le=i.get(y[Re]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,le,0)}n.blitFramebuffer(0,0,O,J,0,0,O,J,ie,n.NEAREST),l===!0&&($e.length=0,We.length=0,$e.push(n.COLOR_ATTACHMENT0+Re),D.depthBuffer&&D.resolveDepthBuffer===!1&&($e.push(te),We.push(te),n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,We)),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,$e))}if(t.bindFramebuffer(n.READ_FRAMEBUFFER,null),t.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),he)for(let Re=0;Re<y.length;Re++){t.bindFramebuffer(n.FRAMEBUFFER,Fe.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+Re,n.RENDERBUFFER,Fe.__webglColorRenderbuffer[Re]);const le=i.get(y[Re]).__webglTexture;t.bindFramebuffer(n.FRAMEBUFFER,Fe.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+Re,n.TEXTURE_2D,le,0)}t.bindFramebuffer(n.DRAW_FRAMEBUFFER,Fe.__webglMultisampledFramebuffer)}else if(D.depthBuffer&&D.resolveDepthBuffer===!1&&l){const y=D.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[y])}}}function At(D){return Math.min(s.maxSamples,D.samples)}function Pe(D){const y=i.get(D);return D.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&y.__useRenderToTexture!==!1}function Ge(D){const y=o.render.frame;u.get(D)!==y&&(u.set(D,y),D.update())}function Gt(D,y){const O=D.colorSpace,J=D.format,ie=D.type;return D.isCompressedTexture===!0||D.isVideoTexture===!0||O!==xo&&O!==Is&&(xt.getTransfer(O)===It?(J!==Li||ie!==Ki)&&console.warn("THREE.WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):console.error("THREE.WebGLTextures: Unsupported texture color space:",O)),y}function Mt(D){return typeof HTMLImageElement<"u"&&D instanceof HTMLImageElement?(c.width=D.naturalWidth||D.width,c.height=D.naturalHeight||D.height):typeof VideoFrame<"u"&&D instanceof VideoFrame?(c.width=D.displayWidth,c.height=D.displayHeight):(c.width=D.width,c.height=D.height),c}this.allocateTextureUnit=z,this.resetTextureUnits=B,this.setTexture2D=W,this.setTexture2DArray=q,this.setTexture3D=j,this.setTextureCube=K,this.rebindTextures=Bt,this.setupRenderTarget=F,this.updateRenderTargetMipmap=mt,this.updateMultisampleRenderTarget=Ne,this.setupDepthRenderbuffer=tt,this.setupFrameBufferTexture=we,this.useMultisampledRTT=Pe}function Pw(n,e){function t(i,s=Is){let r;const o=xt.getTransfer(s);if(i===Ki)return n.UNSIGNED_BYTE;if(i===nf)return n.UNSIGNED_SHORT_4_4_4_4;if(i===sf)return n.UNSIGNED_SHORT_5_5_5_1;if(i===N_)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===F_)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===I_)return n.BYTE;if(i===U_)return n.SHORT;if(i===Sa)return n.UNSIGNED_SHORT;if(i===tf)return n.INT;if(i===xr)return n.UNSIGNED_INT;if(i===qi)return n.FLOAT;if(i===Pa)return n.HALF_FLOAT;if(i===O_)return n.ALPHA;if(i===k_)return n.RGB;if(i===Li)return n.RGBA;if(i===ba)return n.DEPTH_COMPONENT;if(i===wa)return n.DEPTH_STENCIL;if(i===rf)return n.RED;if(i===of)return n.RED_INTEGER;if(i===B_)return n.RG;if(i===af)return n.RG_INTEGER;if(i===lf)return n.RGBA_INTEGER;if(i===Tl||i===Al||i===Rl||i===Cl)if(o===It)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===Tl)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===Al)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===Rl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===Cl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===Tl)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===Al)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===Rl)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===Cl)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===Zu||i===Ku||i===Ju||i===Qu)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===Zu)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===Ku)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===Ju)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===Qu)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===eh||i===th||i===nh)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(i===eh||i===th)return o===It?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===nh)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC}else return null;if(i===ih||i===sh||i===rh||i===oh||i===ah||i===lh||i===ch||i===uh||i===hh||i===fh||i===dh||i===ph||i===mh||i===_h)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(i===ih)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===sh)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===rh)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===oh)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===ah)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===lh)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===ch)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===uh)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===hh)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===fh)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===dh)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===ph)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===mh)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===_h)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===gh||i===vh||i===xh)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(i===gh)return o===It?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===vh)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===xh)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===yh||i===Mh||i===Sh||i===Eh)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(i===yh)return r.COMPRESSED_RED_RGTC1_EXT;if(i===Mh)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===Sh)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===Eh)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===Ea?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:t}}const Dw=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,Lw=`
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

}`;class Iw{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){const i=new Z_(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=i}}getMesh(e){if(this.texture!==null&&this.mesh===null){const t=e.cameras[0].viewport,i=new ps({vertexShader:Dw,fragmentShader:Lw,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new be(new Os(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}}class Uw extends Er{constructor(e,t){super();const i=this;let s=null,r=1,o=null,a="local-floor",l=1,c=null,u=null,f=null,d=null,h=null,_=null;const x=typeof XRWebGLBinding<"u",m=new Iw,p={},M=t.getContextAttributes();let b=null,v=null;const L=[],R=[],U=new Ke;let N=null;const T=new xi;T.viewport=new en;const E=new xi;E.viewport=new en;const C=[T,E],B=new tM;let z=null,X=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(ee){let ne=L[ee];return ne===void 0&&(ne=new su,L[ee]=ne),ne.getTargetRaySpace()},this.getControllerGrip=function(ee){let ne=L[ee];return ne===void 0&&(ne=new su,L[ee]=ne),ne.getGripSpace()},this.getHand=function(ee){let ne=L[ee];return ne===void 0&&(ne=new su,L[ee]=ne),ne.getHandSpace()};function W(ee){const ne=R.indexOf(ee.inputSource);if(ne===-1)return;const we=L[ne];we!==void 0&&(we.update(ee.inputSource,ee.frame,c||o),we.dispatchEvent({type:ee.type,data:ee.inputSource}))}function q(){s.removeEventListener("select",W),s.removeEventListener("selectstart",W),s.removeEventListener("selectend",W),s.removeEventListener("squeeze",W),s.removeEventListener("squeezestart",W),s.removeEventListener("squeezeend",W),s.removeEventListener("end",q),s.removeEventListener("inputsourceschange",j);for(let ee=0;ee<L.length;ee++){const ne=R[ee];ne!==null&&(R[ee]=null,L[ee].disconnect(ne))}z=null,X=null,m.reset();for(const ee in p)delete p[ee];e.setRenderTarget(b),h=null,d=null,f=null,s=null,v=null,et.stop(),i.isPresenting=!1,e.setPixelRatio(N),e.setSize(U.width,U.height,!1),i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(ee){r=ee,i.isPresenting===!0&&console.warn("THREE.WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(ee){a=ee,i.isPresenting===!0&&console.warn("THREE.WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(ee){c=ee},this.getBaseLayer=function(){return d!==null?d:h},this.getBinding=function(){return f===null&&x&&(f=new XRWebGLBinding(s,t)),f},this.getFrame=function(){return _},this.getSession=function(){return s},this.setSession=async function(ee){if(s=ee,s!==null){if(b=e.getRenderTarget(),s.addEventListener("select",W),s.addEventListener("selectstart",W),s.addEventListener("selectend",W),s.addEventListener("squeeze",W),s.addEventListener("squeezestart",W),s.addEventListener("squeezeend",W),s.addEventListener("end",q),s.addEventListener("inputsourceschange",j),M.xrCompatible!==!0&&await t.makeXRCompatible(),N=e.getPixelRatio(),e.getSize(U),x&&"createProjectionLayer"in XRWebGLBinding.prototype){let we=null,ze=null,ye=null;M.depth&&(ye=M.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,we=M.stencil?wa:ba,ze=M.stencil?Ea:xr);const tt={colorFormat:t.RGBA8,depthFormat:ye,scaleFactor:r};f=this.getBinding(),d=f.createProjectionLayer(tt),s.updateRenderState({layers:[d]}),e.setPixelRatio(1),e.setSize(d.textureWidth,d.textureHeight,!1),v=new yr(d.textureWidth,d.textureHeight,{format:Li,type:Ki,depthTexture:new j_(d.textureWidth,d.textureHeight,ze,void 0,void 0,void 0,void 0,void 0,void 0,we),stencilBuffer:M.stencil,colorSpace:e.outputColorSpace,samples:M.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1})}else{const we={antialias:M.antialias,alpha:!0,depth:M.depth,stencil:M.stencil,framebufferScaleFactor:r};h=new XRWebGLLayer(s,t,we),s.updateRenderState({baseLayer:h}),e.setPixelRatio(1),e.setSize(h.framebufferWidth,h.framebufferHeight,!1),v=new yr(h.framebufferWidth,h.framebufferHeight,{format:Li,type:Ki,colorSpace:e.outputColorSpace,stencilBuffer:M.stencil,resolveDepthBuffer:h.ignoreDepthValues===!1,resolveStencilBuffer:h.ignoreDepthValues===!1})}v.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),et.setContext(s),et.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return m.getDepthTexture()};function j(ee){for(let ne=0;ne<ee.removed.length;ne++){const we=ee.removed[ne],ze=R.indexOf(we);ze>=0&&(R[ze]=null,L[ze].disconnect(we))}for(let ne=0;ne<ee.added.length;ne++){const we=ee.added[ne];let ze=R.indexOf(we);if(ze===-1){for(let tt=0;tt<L.length;tt++)if(tt>=R.length){R.push(we),ze=tt;break}else if(R[tt]===null){R[tt]=we,ze=tt;break}if(ze===-1)break}const ye=L[ze];ye&&ye.connect(we)}}const K=new k,re=new k;function ae(ee,ne,we){K.setFromMatrixPosition(ne.matrixWorld),re.setFromMatrixPosition(we.matrixWorld);const ze=K.distanceTo(re),ye=ne.projectionMatrix.elements,tt=we.projectionMatrix.elements,Bt=ye[14]/(ye[10]-1),F=ye[14]/(ye[10]+1),mt=(ye[9]+1)/ye[5],$e=(ye[9]-1)/ye[5],We=(ye[8]-1)/ye[0],Ne=(tt[8]+1)/tt[0],At=Bt*We,Pe=Bt*Ne,Ge=ze/(-We+Ne),Gt=Ge*-We;if(ne.matrixWorld.decompose(ee.position,ee.quaternion,ee.scale),ee.translateX(Gt),ee.translateZ(Ge),ee.matrixWorld.compose(ee.position,ee.quaternion,ee.scale),ee.matrixWorldInverse.copy(ee.matrixWorld).invert(),ye[10]===-1)ee.projectionMatrix.copy(ne.projectionMatrix),ee.projectionMatrixInverse.copy(ne.projectionMatrixInverse);else{const Mt=Bt+Ge,D=F+Ge,y=At-Gt,O=Pe+(ze-Gt),J=mt*F/D*Mt,ie=$e*F/D*Mt;ee.projectionMatrix.makePerspective(y,O,J,ie,Mt,D),ee.projectionMatrixInverse.copy(ee.projectionMatrix).invert()}}function me(ee,ne){ne===null?ee.matrixWorld.copy(ee.matrix):ee.matrixWorld.multiplyMatrices(ne.matrixWorld,ee.matrix),ee.matrixWorldInverse.copy(ee.matrixWorld).invert()}this.updateCamera=function(ee){if(s===null)return;let ne=ee.near,we=ee.far;m.texture!==null&&(m.depthNear>0&&(ne=m.depthNear),m.depthFar>0&&(we=m.depthFar)),B.near=E.near=T.near=ne,B.far=E.far=T.far=we,(z!==B.near||X!==B.far)&&(s.updateRenderState({depthNear:B.near,depthFar:B.far}),z=B.near,X=B.far),B.layers.mask=ee.layers.mask|6,T.layers.mask=B.layers.mask&3,E.layers.mask=B.layers.mask&5;const ze=ee.parent,ye=B.cameras;me(B,ze);for(let tt=0;tt<ye.length;tt++)me(ye[tt],ze);ye.length===2?ae(B,T,E):B.projectionMatrix.copy(T.projectionMatrix),xe(ee,B,ze)};function xe(ee,ne,we){we===null?ee.matrix.copy(ne.matrixWorld):(ee.matrix.copy(we.matrixWorld),ee.matrix.invert(),ee.matrix.multiply(ne.matrixWorld)),ee.matrix.decompose(ee.position,ee.quaternion,ee.scale),ee.updateMatrixWorld(!0),ee.projectionMatrix.copy(ne.projectionMatrix),ee.projectionMatrixInverse.copy(ne.projectionMatrixInverse),ee.isPerspectiveCamera&&(ee.fov=bh*2*Math.atan(1/ee.projectionMatrix.elements[5]),ee.zoom=1)}this.getCamera=function(){return B},this.getFoveation=function(){if(!(d===null&&h===null))return l},this.setFoveation=function(ee){l=ee,d!==null&&(d.fixedFoveation=ee),h!==null&&h.fixedFoveation!==void 0&&(h.fixedFoveation=ee)},this.hasDepthSensing=function(){return m.texture!==null},this.getDepthSensingMesh=function(){return m.getMesh(B)},this.getCameraTexture=function(ee){return p[ee]};let ge=null;function Qe(ee,ne){if(u=ne.getViewerPose(c||o),_=ne,u!==null){const we=u.views;h!==null&&(e.setRenderTargetFramebuffer(v,h.framebuffer),e.setRenderTarget(v));let ze=!1;we.length!==B.cameras.length&&(B.cameras.length=0,ze=!0);for(let F=0;F<we.length;F++){const mt=we[F];let $e=null;if(h!==null)$e=h.getViewport(mt);else{const Ne=f.getViewSubImage(d,mt);$e=Ne.viewport,F===0&&(e.setRenderTargetTextures(v,Ne.colorTexture,Ne.depthStencilTexture),e.setRenderTarget(v))}let We=C[F];We===void 0&&(We=new xi,We.layers.enable(F),We.viewport=new en,C[F]=We),We.matrix.fromArray(mt.transform.matrix),We.matrix.decompose(We.position,We.quaternion,We.scale),We.projectionMatrix.fromArray(mt.projectionMatrix),We.projectionMatrixInverse.copy(We.projectionMatrix).invert(),We.viewport.set($e.x,$e.y,$e.width,$e.height),F===0&&(B.matrix.copy(We.matrix),B.matrix.decompose(B.position,B.quaternion,B.scale)),ze===!0&&B.cameras.push(We)}const ye=s.enabledFeatures;if(ye&&ye.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&x){f=i.getBinding();const F=f.getDepthInformation(we[0]);F&&F.isValid&&F.texture&&m.init(F,s.renderState)}if(ye&&ye.includes("camera-access")&&x){e.state.unbindTexture(),f=i.getBinding();for(let F=0;F<we.length;F++){const mt=we[F].camera;if(mt){let $e=p[mt];$e||($e=new Z_,p[mt]=$e);const We=f.getCameraImage(mt);$e.sourceTexture=We}}}}for(let we=0;we<L.length;we++){const ze=R[we],ye=L[we];ze!==null&&ye!==void 0&&ye.update(ze,ne,c||o)}ge&&ge(ee,ne),ne.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:ne}),_=null}const et=new tg;et.setAnimationLoop(Qe),this.setAnimationLoop=function(ee){ge=ee},this.dispose=function(){}}}const er=new Mi,Nw=new Pt;function Fw(n,e){function t(m,p){m.matrixAutoUpdate===!0&&m.updateMatrix(),p.value.copy(m.matrix)}function i(m,p){p.color.getRGB(m.fogColor.value,Y_(n)),p.isFog?(m.fogNear.value=p.near,m.fogFar.value=p.far):p.isFogExp2&&(m.fogDensity.value=p.density)}function s(m,p,M,b,v){p.isMeshBasicMaterial||p.isMeshLambertMaterial?r(m,p):p.isMeshToonMaterial?(r(m,p),f(m,p)):p.isMeshPhongMaterial?(r(m,p),u(m,p)):p.isMeshStandardMaterial?(r(m,p),d(m,p),p.isMeshPhysicalMaterial&&h(m,p,v)):p.isMeshMatcapMaterial?(r(m,p),_(m,p)):p.isMeshDepthMaterial?r(m,p):p.isMeshDistanceMaterial?(r(m,p),x(m,p)):p.isMeshNormalMaterial?r(m,p):p.isLineBasicMaterial?(o(m,p),p.isLineDashedMaterial&&a(m,p)):p.isPointsMaterial?l(m,p,M,b):p.isSpriteMaterial?c(m,p):p.isShadowMaterial?(m.color.value.copy(p.color),m.opacity.value=p.opacity):p.isShaderMaterial&&(p.uniformsNeedUpdate=!1)}function r(m,p){m.opacity.value=p.opacity,p.color&&m.diffuse.value.copy(p.color),p.emissive&&m.emissive.value.copy(p.emissive).multiplyScalar(p.emissiveIntensity),p.map&&(m.map.value=p.map,t(p.map,m.mapTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,t(p.alphaMap,m.alphaMapTransform)),p.bumpMap&&(m.bumpMap.value=p.bumpMap,t(p.bumpMap,m.bumpMapTransform),m.bumpScale.value=p.bumpScale,p.side===Jn&&(m.bumpScale.value*=-1)),p.normalMap&&(m.normalMap.value=p.normalMap,t(p.normalMap,m.normalMapTransform),m.normalScale.value.copy(p.normalScale),p.side===Jn&&m.normalScale.value.negate()),p.displacementMap&&(m.displacementMap.value=p.displacementMap,t(p.displacementMap,m.displacementMapTransform),m.displacementScale.value=p.displacementScale,m.displacementBias.value=p.displacementBias),p.emissiveMap&&(m.emissiveMap.value=p.emissiveMap,t(p.emissiveMap,m.emissiveMapTransform)),p.specularMap&&(m.specularMap.value=p.specularMap,t(p.specularMap,m.specularMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest);const M=e.get(p),b=M.envMap,v=M.envMapRotation;b&&(m.envMap.value=b,er.copy(v),er.x*=-1,er.y*=-1,er.z*=-1,b.isCubeTexture&&b.isRenderTargetTexture===!1&&(er.y*=-1,er.z*=-1),m.envMapRotation.value.setFromMatrix4(Nw.makeRotationFromEuler(er)),m.flipEnvMap.value=b.isCubeTexture&&b.isRenderTargetTexture===!1?-1:1,m.reflectivity.value=p.reflectivity,m.ior.value=p.ior,m.refractionRatio.value=p.refractionRatio),p.lightMap&&(m.lightMap.value=p.lightMap,m.lightMapIntensity.value=p.lightMapIntensity,t(p.lightMap,m.lightMapTransform)),p.aoMap&&(m.aoMap.value=p.aoMap,m.aoMapIntensity.value=p.aoMapIntensity,t(p.aoMap,m.aoMapTransform))}function o(m,p){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,p.map&&(m.map.value=p.map,t(p.map,m.mapTransform))}function a(m,p){m.dashSize.value=p.dashSize,m.totalSize.value=p.dashSize+p.gapSize,m.scale.value=p.scale}function l(m,p,M,b){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,m.size.value=p.size*M,m.scale.value=b*.5,p.map&&(m.map.value=p.map,t(p.map,m.uvTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,t(p.alphaMap,m.alphaMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest)}function c(m,p){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,m.rotation.value=p.rotation,p.map&&(m.map.value=p.map,t(p.map,m.mapTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,t(p.alphaMap,m.alphaMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest)}function u(m,p){m.specular.value.copy(p.specular),m.shininess.value=Math.max(p.shininess,1e-4)}function f(m,p){p.gradientMap&&(m.gradientMap.value=p.gradientMap)}function d(m,p){m.metalness.value=p.metalness,p.metalnessMap&&(m.metalnessMap.value=p.metalnessMap,t(p.metalnessMap,m.metalnessMapTransform)),m.roughness.value=p.roughness,p.roughnessMap&&(m.roughnessMap.value=p.roughnessMap,t(p.roughnessMap,m.roughnessMapTransform)),p.envMap&&(m.envMapIntensity.value=p.envMapIntensity)}function h(m,p,M){m.ior.value=p.ior,p.sheen>0&&(m.sheenColor.value.copy(p.sheenColor).multiplyScalar(p.sheen),m.sheenRoughness.value=p.sheenRoughness,p.sheenColorMap&&(m.sheenColorMap.value=p.sheenColorMap,t(p.sheenColorMap,m.sheenColorMapTransform)),p.sheenRoughnessMap&&(m.sheenRoughnessMap.value=p.sheenRoughnessMap,t(p.sheenRoughnessMap,m.sheenRoughnessMapTransform))),p.clearcoat>0&&(m.clearcoat.value=p.clearcoat,m.clearcoatRoughness.value=p.clearcoatRoughness,p.clearcoatMap&&(m.clearcoatMap.value=p.clearcoatMap,t(p.clearcoatMap,m.clearcoatMapTransform)),p.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=p.clearcoatRoughnessMap,t(p.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),p.clearcoatNormalMap&&(m.clearcoatNormalMap.value=p.clearcoatNormalMap,t(p.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(p.clearcoatNormalScale),p.side===Jn&&m.clearcoatNormalScale.value.negate())),p.dispersion>0&&(m.dispersion.value=p.dispersion),p.iridescence>0&&(m.iridescence.value=p.iridescence,m.iridescenceIOR.value=p.iridescenceIOR,m.iridescenceThicknessMinimum.value=p.iridescenceThicknessRange[0],m.iridescenceThicknessMaximum.value=p.iridescenceThicknessRange[1],p.iridescenceMap&&(m.iridescenceMap.value=p.iridescenceMap,t(p.iridescenceMap,m.iridescenceMapTransform)),p.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=p.iridescenceThicknessMap,t(p.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),p.transmission>0&&(m.transmission.value=p.transmission,m.transmissionSamplerMap.value=M.texture,m.transmissionSamplerSize.value.set(M.width,M.height),p.transmissionMap&&(m.transmissionMap.value=p.transmissionMap,t(p.transmissionMap,m.transmissionMapTransform)),m.thickness.value=p.thickness,p.thicknessMap&&(m.thicknessMap.value=p.thicknessMap,t(p.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=p.attenuationDistance,m.attenuationColor.value.copy(p.attenuationColor)),p.anisotropy>0&&(m.anisotropyVector.value.set(p.anisotropy*Math.cos(p.anisotropyRotation),p.anisotropy*Math.sin(p.anisotropyRotation)),p.anisotropyMap&&(m.anisotropyMap.value=p.anisotropyMap,t(p.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=p.specularIntensity,m.specularColor.value.copy(p.specularColor),p.specularColorMap&&(m.specularColorMap.value=p.specularColorMap,t(p.specularColorMap,m.specularColorMapTransform)),p.specularIntensityMap&&(m.specularIntensityMap.value=p.specularIntensityMap,t(p.specularIntensityMap,m.specularIntensityMapTransform))}function _(m,p){p.matcap&&(m.matcap.value=p.matcap)}function x(m,p){const M=e.get(p).light;m.referencePosition.value.setFromMatrixPosition(M.matrixWorld),m.nearDistance.value=M.shadow.camera.near,m.farDistance.value=M.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function Ow(n,e,t,i){let s={},r={},o=[];const a=n.getParameter(n.MAX_UNIFORM_BUFFER_BINDINGS);function l(M,b){const v=b.program;i.uniformBlockBinding(M,v)}function c(M,b){let v=s[M.id];v===void 0&&(_(M),v=u(M),s[M.id]=v,M.addEventListener("dispose",m));const L=b.program;i.updateUBOMapping(M,L);const R=e.render.frame;r[M.id]!==R&&(d(M),r[M.id]=R)}function u(M){const b=f();M.__bindingPointIndex=b;const v=n.createBuffer(),L=M.__size,R=M.usage;return n.bindBuffer(n.UNIFORM_BUFFER,v),n.bufferData(n.UNIFORM_BUFFER,L,R),n.bindBuffer(n.UNIFORM_BUFFER,null),n.bindBufferBase(n.UNIFORM_BUFFER,b,v),v}function f(){for(let M=0;M<a;M++)if(o.indexOf(M)===-1)return o.push(M),M;return console.error("THREE.WebGLRenderer: Maximum number of simultaneously usable uniforms groups reached."),0}function d(M){const b=s[M.id],v=M.uniforms,L=M.__cache;n.bindBuffer(n.UNIFORM_BUFFER,b);for(let R=0,U=v.length;R<U;R++){const N=Array.isArray(v[R])?v[R]:[v[R]];for(let T=0,E=N.length;T<E;T++){const C=N[T];if(h(C,R,T,L)===!0){const B=C.__offset,z=Array.isArray(C.value)?C.value:[C.value];let X=0;for(let W=0;W<z.length;W++){const q=z[W],j=x(q);typeof q=="number"||typeof q=="boolean"?(C.__data[0]=q,n.bufferSubData(n.UNIFORM_BUFFER,B+X,C.__data)):q.isMatrix3?(C.__data[0]=q.elements[0],C.__data[1]=q.elements[1],C.__data[2]=q.elements[2],C.__data[3]=0,C.__data[4]=q.elements[3],C.__data[5]=q.elements[4],C.__data[6]=q.elements[5],C.__data[7]=0,C.__data[8]=q.elements[6],C.__data[9]=q.elements[7],C.__data[10]=q.elements[8],C.__data[11]=0):(q.toArray(C.__data,X),X+=j.storage/Float32Array.BYTES_PER_ELEMENT)}n.bufferSubData(n.UNIFORM_BUFFER,B,C.__data)}}}n.bindBuffer(n.UNIFORM_BUFFER,null)}function h(M,b,v,L){const R=M.value,U=b+"_"+v;if(L[U]===void 0)return typeof R=="number"||typeof R=="boolean"?L[U]=R:L[U]=R.clone(),!0;{const N=L[U];if(typeof R=="number"||typeof R=="boolean"){if(N!==R)return L[U]=R,!0}else if(N.equals(R)===!1)return N.copy(R),!0}return!1}function _(M){const b=M.uniforms;let v=0;const L=16;for(let U=0,N=b.length;U<N;U++){const T=Array.isArray(b[U])?b[U]:[b[U]];for(let E=0,C=T.length;E<C;E++){const B=T[E],z=Array.isArray(B.value)?B.value:[B.value];for(let X=0,W=z.length;X<W;X++){const q=z[X],j=x(q),K=v%L,re=K%j.boundary,ae=K+re;v+=re,ae!==0&&L-ae<j.storage&&(v+=L-ae),B.__data=new Float32Array(j.storage/Float32Array.BYTES_PER_ELEMENT),B.__offset=v,v+=j.storage}}}const R=v%L;return R>0&&(v+=L-R),M.__size=v,M.__cache={},this}function x(M){const b={boundary:0,storage:0};return typeof M=="number"||typeof M=="boolean"?(b.boundary=4,b.storage=4):M.isVector2?(b.boundary=8,b.storage=8):M.isVector3||M.isColor?(b.boundary=16,b.storage=12):M.isVector4?(b.boundary=16,b.storage=16):M.isMatrix3?(b.boundary=48,b.storage=48):M.isMatrix4?(b.boundary=64,b.storage=64):M.isTexture?console.warn("THREE.WebGLRenderer: Texture samplers can not be part of an uniforms group."):console.warn("THREE.WebGLRenderer: Unsupported uniform value type.",M),b}function m(M){const b=M.target;b.removeEventListener("dispose",m);const v=o.indexOf(b.__bindingPointIndex);o.splice(v,1),n.deleteBuffer(s[b.id]),delete s[b.id],delete r[b.id]}function p(){for(const M in s)n.deleteBuffer(s[M]);o=[],s={},r={}}return{bind:l,update:c,dispose:p}}class kw{constructor(e={}){const{canvas:t=fy(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:f=!1,reversedDepthBuffer:d=!1}=e;this.isWebGLRenderer=!0;let h;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");h=i.getContextAttributes().alpha}else h=o;const _=new Uint32Array(4),x=new Int32Array(4);let m=null,p=null;const M=[],b=[];this.domElement=t,this.debug={checkShaderErrors:!0,onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=Fs,this.toneMappingExposure=1,this.transmissionResolutionScale=1;const v=this;let L=!1;this._outputColorSpace=vi;let R=0,U=0,N=null,T=-1,E=null;const C=new en,B=new en;let z=null;const X=new Je(0);let W=0,q=t.width,j=t.height,K=1,re=null,ae=null;const me=new en(0,0,q,j),xe=new en(0,0,q,j);let ge=!1;const Qe=new ff;let et=!1,ee=!1;const ne=new Pt,we=new k,ze=new en,ye={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0};let tt=!1;function Bt(){return N===null?K:1}let F=i;function mt(A,G){return t.getContext(A,G)}try{const A={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:f};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${Qh}`),t.addEventListener("webglcontextlost",pe,!1),t.addEventListener("webglcontextrestored",De,!1),t.addEventListener("webglcontextcreationerror",ue,!1),F===null){const G="webgl2";if(F=mt(G,A),F===null)throw mt(G)?new Error("Error creating WebGL context with your selected attributes."):new Error("Error creating WebGL context.")}}catch(A){throw console.error("THREE.WebGLRenderer: "+A.message),A}let $e,We,Ne,At,Pe,Ge,Gt,Mt,D,y,O,J,ie,te,Fe,he,Le,Re,le,ve,Be,ke,Me,Ze;function H(){$e=new $E(F),$e.init(),ke=new Pw(F,$e),We=new HE(F,$e,e,ke),Ne=new Rw(F,$e),We.reversedDepthBuffer&&d&&Ne.buffers.depth.setReversed(!0),At=new KE(F),Pe=new mw,Ge=new Cw(F,$e,Ne,Pe,We,ke,At),Gt=new GE(v),Mt=new qE(v),D=new iM(F),Me=new BE(F,D),y=new jE(F,D,At,Me),O=new QE(F,y,D,At),le=new JE(F,We,Ge),he=new VE(Pe),J=new pw(v,Gt,Mt,$e,We,Me,he),ie=new Fw(v,Pe),te=new gw,Fe=new Ew($e),Re=new kE(v,Gt,Mt,Ne,O,h,l),Le=new Tw(v,O,We),Ze=new Ow(F,At,We,Ne),ve=new zE(F,$e,At),Be=new ZE(F,$e,At),At.programs=J.programs,v.capabilities=We,v.extensions=$e,v.properties=Pe,v.renderLists=te,v.shadowMap=Le,v.state=Ne,v.info=At}H();const fe=new Uw(v,F);this.xr=fe,this.getContext=function(){return F},this.getContextAttributes=function(){return F.getContextAttributes()},this.forceContextLoss=function(){const A=$e.get("WEBGL_lose_context");A&&A.loseContext()},this.forceContextRestore=function(){const A=$e.get("WEBGL_lose_context");A&&A.restoreContext()},this.getPixelRatio=function(){return K},this.setPixelRatio=function(A){A!==void 0&&(K=A,this.setSize(q,j,!1))},this.getSize=function(A){return A.set(q,j)},this.setSize=function(A,G,Q=!0){if(fe.isPresenting){console.warn("THREE.WebGLRenderer: Can't change size while VR device is presenting.");return}q=A,j=G,t.width=Math.floor(A*K),t.height=Math.floor(G*K),Q===!0&&(t.style.width=A+"px",t.style.height=G+"px"),this.setViewport(0,0,A,G)},this.getDrawingBufferSize=function(A){return A.set(q*K,j*K).floor()},this.setDrawingBufferSize=function(A,G,Q){q=A,j=G,K=Q,t.width=Math.floor(A*Q),t.height=Math.floor(G*Q),this.setViewport(0,0,A,G)},this.getCurrentViewport=function(A){return A.copy(C)},this.getViewport=function(A){return A.copy(me)},this.setViewport=function(A,G,Q,Z){A.isVector4?me.set(A.x,A.y,A.z,A.w):me.set(A,G,Q,Z),Ne.viewport(C.copy(me).multiplyScalar(K).round())},this.getScissor=function(A){return A.copy(xe)},this.setScissor=function(A,G,Q,Z){A.isVector4?xe.set(A.x,A.y,A.z,A.w):xe.set(A,G,Q,Z),Ne.scissor(B.copy(xe).multiplyScalar(K).round())},this.getScissorTest=function(){return ge},this.setScissorTest=function(A){Ne.setScissorTest(ge=A)},this.setOpaqueSort=function(A){re=A},this.setTransparentSort=function(A){ae=A},this.getClearColor=function(A){return A.copy(Re.getClearColor())},this.setClearColor=function(){Re.setClearColor(...arguments)},this.getClearAlpha=function(){return Re.getClearAlpha()},this.setClearAlpha=function(){Re.setClearAlpha(...arguments)},this.clear=function(A=!0,G=!0,Q=!0){let Z=0;if(A){let Y=!1;if(N!==null){const de=N.texture.format;Y=de===lf||de===af||de===of}if(Y){const de=N.texture.type,Se=de===Ki||de===xr||de===Sa||de===Ea||de===nf||de===sf,Ie=Re.getClearColor(),Te=Re.getClearAlpha(),Ye=Ie.r,qe=Ie.g,He=Ie.b;Se?(_[0]=Ye,_[1]=qe,_[2]=He,_[3]=Te,F.clearBufferuiv(F.COLOR,0,_)):(x[0]=Ye,x[1]=qe,x[2]=He,x[3]=Te,F.clearBufferiv(F.COLOR,0,x))}else Z|=F.COLOR_BUFFER_BIT}G&&(Z|=F.DEPTH_BUFFER_BIT),Q&&(Z|=F.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),F.clear(Z)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.dispose=function(){t.removeEventListener("webglcontextlost",pe,!1),t.removeEventListener("webglcontextrestored",De,!1),t.removeEventListener("webglcontextcreationerror",ue,!1),Re.dispose(),te.dispose(),Fe.dispose(),Pe.dispose(),Gt.dispose(),Mt.dispose(),O.dispose(),Me.dispose(),Ze.dispose(),J.dispose(),fe.dispose(),fe.removeEventListener("sessionstart",Nt),fe.removeEventListener("sessionend",Qn),qn.stop()};function pe(A){A.preventDefault(),console.log("THREE.WebGLRenderer: Context Lost."),L=!0}function De(){console.log("THREE.WebGLRenderer: Context Restored."),L=!1;const A=At.autoReset,G=Le.enabled,Q=Le.autoUpdate,Z=Le.needsUpdate,Y=Le.type;H(),At.autoReset=A,Le.enabled=G,Le.autoUpdate=Q,Le.needsUpdate=Z,Le.type=Y}function ue(A){console.error("THREE.WebGLRenderer: A WebGL context could not be created. Reason: ",A.statusMessage)}function oe(A){const G=A.target;G.removeEventListener("dispose",oe),Oe(G)}function Oe(A){nt(A),Pe.remove(A)}function nt(A){const G=Pe.get(A).programs;G!==void 0&&(G.forEach(function(Q){J.releaseProgram(Q)}),A.isShaderMaterial&&J.releaseShaderCache(A))}this.renderBufferDirect=function(A,G,Q,Z,Y,de){G===null&&(G=ye);const Se=Y.isMesh&&Y.matrixWorld.determinant()<0,Ie=es(A,G,Q,Z,Y);Ne.setMaterial(Z,Se);let Te=Q.index,Ye=1;if(Z.wireframe===!0){if(Te=y.getWireframeAttribute(Q),Te===void 0)return;Ye=2}const qe=Q.drawRange,He=Q.attributes.position;let ct=qe.start*Ye,gt=(qe.start+qe.count)*Ye;de!==null&&(ct=Math.max(ct,de.start*Ye),gt=Math.min(gt,(de.start+de.count)*Ye)),Te!==null?(ct=Math.max(ct,0),gt=Math.min(gt,Te.count)):He!=null&&(ct=Math.max(ct,0),gt=Math.min(gt,He.count));const zt=gt-ct;if(zt<0||zt===1/0)return;Me.setup(Y,Z,Ie,Q,Te);let Rt,ot=ve;if(Te!==null&&(Rt=D.get(Te),ot=Be,ot.setIndex(Rt)),Y.isMesh)Z.wireframe===!0?(Ne.setLineWidth(Z.wireframeLinewidth*Bt()),ot.setMode(F.LINES)):ot.setMode(F.TRIANGLES);else if(Y.isLine){let Xe=Z.linewidth;Xe===void 0&&(Xe=1),Ne.setLineWidth(Xe*Bt()),Y.isLineSegments?ot.setMode(F.LINES):Y.isLineLoop?ot.setMode(F.LINE_LOOP):ot.setMode(F.LINE_STRIP)}else Y.isPoints?ot.setMode(F.POINTS):Y.isSprite&&ot.setMode(F.TRIANGLES);if(Y.isBatchedMesh)if(Y._multiDrawInstances!==null)Ta("THREE.WebGLRenderer: renderMultiDrawInstances has been deprecated and will be removed in r184. Append to renderMultiDraw arguments and use indirection."),ot.renderMultiDrawInstances(Y._multiDrawStarts,Y._multiDrawCounts,Y._multiDrawCount,Y._multiDrawInstances);else if($e.get("WEBGL_multi_draw"))ot.renderMultiDraw(Y._multiDrawStarts,Y._multiDrawCounts,Y._multiDrawCount);else{const Xe=Y._multiDrawStarts,Ht=Y._multiDrawCounts,dt=Y._multiDrawCount,Ln=Te?D.get(Te).bytesPerElement:1,ms=Pe.get(Z).currentProgram.getUniforms();for(let Bn=0;Bn<dt;Bn++)ms.setValue(F,"_gl_DrawID",Bn),ot.render(Xe[Bn]/Ln,Ht[Bn])}else if(Y.isInstancedMesh)ot.renderInstances(ct,zt,Y.count);else if(Q.isInstancedBufferGeometry){const Xe=Q._maxInstanceCount!==void 0?Q._maxInstanceCount:1/0,Ht=Math.min(Q.instanceCount,Xe);ot.renderInstances(ct,zt,Ht)}else ot.render(ct,zt)};function Dt(A,G,Q){A.transparent===!0&&A.side===Xi&&A.forceSinglePass===!1?(A.side=Jn,A.needsUpdate=!0,Gs(A,G,Q),A.side=ds,A.needsUpdate=!0,Gs(A,G,Q),A.side=Xi):Gs(A,G,Q)}this.compile=function(A,G,Q=null){Q===null&&(Q=A),p=Fe.get(Q),p.init(G),b.push(p),Q.traverseVisible(function(Y){Y.isLight&&Y.layers.test(G.layers)&&(p.pushLight(Y),Y.castShadow&&p.pushShadow(Y))}),A!==Q&&A.traverseVisible(function(Y){Y.isLight&&Y.layers.test(G.layers)&&(p.pushLight(Y),Y.castShadow&&p.pushShadow(Y))}),p.setupLights();const Z=new Set;return A.traverse(function(Y){if(!(Y.isMesh||Y.isPoints||Y.isLine||Y.isSprite))return;const de=Y.material;if(de)if(Array.isArray(de))for(let Se=0;Se<de.length;Se++){const Ie=de[Se];Dt(Ie,Q,Y),Z.add(Ie)}else Dt(de,Q,Y),Z.add(de)}),p=b.pop(),Z},this.compileAsync=function(A,G,Q=null){const Z=this.compile(A,G,Q);return new Promise(Y=>{function de(){if(Z.forEach(function(Se){Pe.get(Se).currentProgram.isReady()&&Z.delete(Se)}),Z.size===0){Y(A);return}setTimeout(de,10)}$e.get("KHR_parallel_shader_compile")!==null?de():setTimeout(de,10)})};let _t=null;function Tn(A){_t&&_t(A)}function Nt(){qn.stop()}function Qn(){qn.start()}const qn=new tg;qn.setAnimationLoop(Tn),typeof self<"u"&&qn.setContext(self),this.setAnimationLoop=function(A){_t=A,fe.setAnimationLoop(A),A===null?qn.stop():qn.start()},fe.addEventListener("sessionstart",Nt),fe.addEventListener("sessionend",Qn),this.render=function(A,G){if(G!==void 0&&G.isCamera!==!0){console.error("THREE.WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(L===!0)return;if(A.matrixWorldAutoUpdate===!0&&A.updateMatrixWorld(),G.parent===null&&G.matrixWorldAutoUpdate===!0&&G.updateMatrixWorld(),fe.enabled===!0&&fe.isPresenting===!0&&(fe.cameraAutoUpdate===!0&&fe.updateCamera(G),G=fe.getCamera()),A.isScene===!0&&A.onBeforeRender(v,A,G,N),p=Fe.get(A,b.length),p.init(G),b.push(p),ne.multiplyMatrices(G.projectionMatrix,G.matrixWorldInverse),Qe.setFromProjectionMatrix(ne,$i,G.reversedDepth),ee=this.localClippingEnabled,et=he.init(this.clippingPlanes,ee),m=te.get(A,M.length),m.init(),M.push(m),fe.enabled===!0&&fe.isPresenting===!0){const de=v.xr.getDepthSensingMesh();de!==null&&Ui(de,G,-1/0,v.sortObjects)}Ui(A,G,0,v.sortObjects),m.finish(),v.sortObjects===!0&&m.sort(re,ae),tt=fe.enabled===!1||fe.isPresenting===!1||fe.hasDepthSensing()===!1,tt&&Re.addToRenderList(m,A),this.info.render.frame++,et===!0&&he.beginShadows();const Q=p.state.shadowsArray;Le.render(Q,A,G),et===!0&&he.endShadows(),this.info.autoReset===!0&&this.info.reset();const Z=m.opaque,Y=m.transmissive;if(p.setupLights(),G.isArrayCamera){const de=G.cameras;if(Y.length>0)for(let Se=0,Ie=de.length;Se<Ie;Se++){const Te=de[Se];Qi(Z,Y,A,Te)}tt&&Re.render(A);for(let Se=0,Ie=de.length;Se<Ie;Se++){const Te=de[Se];kn(m,A,Te,Te.viewport)}}else Y.length>0&&Qi(Z,Y,A,G),tt&&Re.render(A),kn(m,A,G);N!==null&&U===0&&(Ge.updateMultisampleRenderTarget(N),Ge.updateRenderTargetMipmap(N)),A.isScene===!0&&A.onAfterRender(v,A,G),Me.resetDefaultState(),T=-1,E=null,b.pop(),b.length>0?(p=b[b.length-1],et===!0&&he.setGlobalState(v.clippingPlanes,p.state.camera)):p=null,M.pop(),M.length>0?m=M[M.length-1]:m=null};function Ui(A,G,Q,Z){if(A.visible===!1)return;if(A.layers.test(G.layers)){if(A.isGroup)Q=A.renderOrder;else if(A.isLOD)A.autoUpdate===!0&&A.update(G);else if(A.isLight)p.pushLight(A),A.castShadow&&p.pushShadow(A);else if(A.isSprite){if(!A.frustumCulled||Qe.intersectsSprite(A)){Z&&ze.setFromMatrixPosition(A.matrixWorld).applyMatrix4(ne);const Se=O.update(A),Ie=A.material;Ie.visible&&m.push(A,Se,Ie,Q,ze.z,null)}}else if((A.isMesh||A.isLine||A.isPoints)&&(!A.frustumCulled||Qe.intersectsObject(A))){const Se=O.update(A),Ie=A.material;if(Z&&(A.boundingSphere!==void 0?(A.boundingSphere===null&&A.computeBoundingSphere(),ze.copy(A.boundingSphere.center)):(Se.boundingSphere===null&&Se.computeBoundingSphere(),ze.copy(Se.boundingSphere.center)),ze.applyMatrix4(A.matrixWorld).applyMatrix4(ne)),Array.isArray(Ie)){const Te=Se.groups;for(let Ye=0,qe=Te.length;Ye<qe;Ye++){const He=Te[Ye],ct=Ie[He.materialIndex];ct&&ct.visible&&m.push(A,Se,ct,Q,ze.z,He)}}else Ie.visible&&m.push(A,Se,Ie,Q,ze.z,null)}}const de=A.children;for(let Se=0,Ie=de.length;Se<Ie;Se++)Ui(de[Se],G,Q,Z)}function kn(A,G,Q,Z){const Y=A.opaque,de=A.transmissive,Se=A.transparent;p.setupLightsView(Q),et===!0&&he.setGlobalState(v.clippingPlanes,Q),Z&&Ne.viewport(C.copy(Z)),Y.length>0&&Si(Y,G,Q),de.length>0&&Si(de,G,Q),Se.length>0&&Si(Se,G,Q),Ne.buffers.depth.setTest(!0),Ne.buffers.depth.setMask(!0),Ne.buffers.color.setMask(!0),Ne.setPolygonOffset(!1)}function Qi(A,G,Q,Z){if((Q.isScene===!0?Q.overrideMaterial:null)!==null)return;p.state.transmissionRenderTarget[Z.id]===void 0&&(p.state.transmissionRenderTarget[Z.id]=new yr(1,1,{generateMipmaps:!0,type:$e.has("EXT_color_buffer_half_float")||$e.has("EXT_color_buffer_float")?Pa:Ki,minFilter:dr,samples:4,stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,colorSpace:xt.workingColorSpace}));const de=p.state.transmissionRenderTarget[Z.id],Se=Z.viewport||C;de.setSize(Se.z*v.transmissionResolutionScale,Se.w*v.transmissionResolutionScale);const Ie=v.getRenderTarget(),Te=v.getActiveCubeFace(),Ye=v.getActiveMipmapLevel();v.setRenderTarget(de),v.getClearColor(X),W=v.getClearAlpha(),W<1&&v.setClearColor(16777215,.5),v.clear(),tt&&Re.render(Q);const qe=v.toneMapping;v.toneMapping=Fs;const He=Z.viewport;if(Z.viewport!==void 0&&(Z.viewport=void 0),p.setupLightsView(Z),et===!0&&he.setGlobalState(v.clippingPlanes,Z),Si(A,Q,Z),Ge.updateMultisampleRenderTarget(de),Ge.updateRenderTargetMipmap(de),$e.has("WEBGL_multisampled_render_to_texture")===!1){let ct=!1;for(let gt=0,zt=G.length;gt<zt;gt++){const Rt=G[gt],ot=Rt.object,Xe=Rt.geometry,Ht=Rt.material,dt=Rt.group;if(Ht.side===Xi&&ot.layers.test(Z.layers)){const Ln=Ht.side;Ht.side=Jn,Ht.needsUpdate=!0,Ro(ot,Q,Z,Xe,Ht,dt),Ht.side=Ln,Ht.needsUpdate=!0,ct=!0}}ct===!0&&(Ge.updateMultisampleRenderTarget(de),Ge.updateRenderTargetMipmap(de))}v.setRenderTarget(Ie,Te,Ye),v.setClearColor(X,W),He!==void 0&&(Z.viewport=He),v.toneMapping=qe}function Si(A,G,Q){const Z=G.isScene===!0?G.overrideMaterial:null;for(let Y=0,de=A.length;Y<de;Y++){const Se=A[Y],Ie=Se.object,Te=Se.geometry,Ye=Se.group;let qe=Se.material;qe.allowOverride===!0&&Z!==null&&(qe=Z),Ie.layers.test(Q.layers)&&Ro(Ie,G,Q,Te,qe,Ye)}}function Ro(A,G,Q,Z,Y,de){A.onBeforeRender(v,G,Q,Z,Y,de),A.modelViewMatrix.multiplyMatrices(Q.matrixWorldInverse,A.matrixWorld),A.normalMatrix.getNormalMatrix(A.modelViewMatrix),Y.onBeforeRender(v,G,Q,Z,A,de),Y.transparent===!0&&Y.side===Xi&&Y.forceSinglePass===!1?(Y.side=Jn,Y.needsUpdate=!0,v.renderBufferDirect(Q,G,Z,Y,A,de),Y.side=ds,Y.needsUpdate=!0,v.renderBufferDirect(Q,G,Z,Y,A,de),Y.side=Xi):v.renderBufferDirect(Q,G,Z,Y,A,de),A.onAfterRender(v,G,Q,Z,Y,de)}function Gs(A,G,Q){G.isScene!==!0&&(G=ye);const Z=Pe.get(A),Y=p.state.lights,de=p.state.shadowsArray,Se=Y.state.version,Ie=J.getParameters(A,Y.state,de,G,Q),Te=J.getProgramCacheKey(Ie);let Ye=Z.programs;Z.environment=A.isMeshStandardMaterial?G.environment:null,Z.fog=G.fog,Z.envMap=(A.isMeshStandardMaterial?Mt:Gt).get(A.envMap||Z.environment),Z.envMapRotation=Z.environment!==null&&A.envMap===null?G.environmentRotation:A.envMapRotation,Ye===void 0&&(A.addEventListener("dispose",oe),Ye=new Map,Z.programs=Ye);let qe=Ye.get(Te);if(qe!==void 0){if(Z.currentProgram===qe&&Z.lightsStateVersion===Se)return Ia(A,Ie),qe}else Ie.uniforms=J.getUniforms(A),A.onBeforeCompile(Ie,v),qe=J.acquireProgram(Ie,Te),Ye.set(Te,qe),Z.uniforms=Ie.uniforms;const He=Z.uniforms;return(!A.isShaderMaterial&&!A.isRawShaderMaterial||A.clipping===!0)&&(He.clippingPlanes=he.uniform),Ia(A,Ie),Z.needsLights=Ws(A),Z.lightsStateVersion=Se,Z.needsLights&&(He.ambientLightColor.value=Y.state.ambient,He.lightProbe.value=Y.state.probe,He.directionalLights.value=Y.state.directional,He.directionalLightShadows.value=Y.state.directionalShadow,He.spotLights.value=Y.state.spot,He.spotLightShadows.value=Y.state.spotShadow,He.rectAreaLights.value=Y.state.rectArea,He.ltc_1.value=Y.state.rectAreaLTC1,He.ltc_2.value=Y.state.rectAreaLTC2,He.pointLights.value=Y.state.point,He.pointLightShadows.value=Y.state.pointShadow,He.hemisphereLights.value=Y.state.hemi,He.directionalShadowMap.value=Y.state.directionalShadowMap,He.directionalShadowMatrix.value=Y.state.directionalShadowMatrix,He.spotShadowMap.value=Y.state.spotShadowMap,He.spotLightMatrix.value=Y.state.spotLightMatrix,He.spotLightMap.value=Y.state.spotLightMap,He.pointShadowMap.value=Y.state.pointShadowMap,He.pointShadowMatrix.value=Y.state.pointShadowMatrix),Z.currentProgram=qe,Z.uniformsList=null,qe}function La(A){if(A.uniformsList===null){const G=A.currentProgram.getUniforms();A.uniformsList=Dl.seqWithValue(G.seq,A.uniforms)}return A.uniformsList}function Ia(A,G){const Q=Pe.get(A);Q.outputColorSpace=G.outputColorSpace,Q.batching=G.batching,Q.batchingColor=G.batchingColor,Q.instancing=G.instancing,Q.instancingColor=G.instancingColor,Q.instancingMorph=G.instancingMorph,Q.skinning=G.skinning,Q.morphTargets=G.morphTargets,Q.morphNormals=G.morphNormals,Q.morphColors=G.morphColors,Q.morphTargetsCount=G.morphTargetsCount,Q.numClippingPlanes=G.numClippingPlanes,Q.numIntersection=G.numClipIntersection,Q.vertexAlphas=G.vertexAlphas,Q.vertexTangents=G.vertexTangents,Q.toneMapping=G.toneMapping}function es(A,G,Q,Z,Y){G.isScene!==!0&&(G=ye),Ge.resetTextureUnits();const de=G.fog,Se=Z.isMeshStandardMaterial?G.environment:null,Ie=N===null?v.outputColorSpace:N.isXRRenderTarget===!0?N.texture.colorSpace:xo,Te=(Z.isMeshStandardMaterial?Mt:Gt).get(Z.envMap||Se),Ye=Z.vertexColors===!0&&!!Q.attributes.color&&Q.attributes.color.itemSize===4,qe=!!Q.attributes.tangent&&(!!Z.normalMap||Z.anisotropy>0),He=!!Q.morphAttributes.position,ct=!!Q.morphAttributes.normal,gt=!!Q.morphAttributes.color;let zt=Fs;Z.toneMapped&&(N===null||N.isXRRenderTarget===!0)&&(zt=v.toneMapping);const Rt=Q.morphAttributes.position||Q.morphAttributes.normal||Q.morphAttributes.color,ot=Rt!==void 0?Rt.length:0,Xe=Pe.get(Z),Ht=p.state.lights;if(et===!0&&(ee===!0||A!==E)){const xn=A===E&&Z.id===T;he.setState(Z,A,xn)}let dt=!1;Z.version===Xe.__version?(Xe.needsLights&&Xe.lightsStateVersion!==Ht.state.version||Xe.outputColorSpace!==Ie||Y.isBatchedMesh&&Xe.batching===!1||!Y.isBatchedMesh&&Xe.batching===!0||Y.isBatchedMesh&&Xe.batchingColor===!0&&Y.colorTexture===null||Y.isBatchedMesh&&Xe.batchingColor===!1&&Y.colorTexture!==null||Y.isInstancedMesh&&Xe.instancing===!1||!Y.isInstancedMesh&&Xe.instancing===!0||Y.isSkinnedMesh&&Xe.skinning===!1||!Y.isSkinnedMesh&&Xe.skinning===!0||Y.isInstancedMesh&&Xe.instancingColor===!0&&Y.instanceColor===null||Y.isInstancedMesh&&Xe.instancingColor===!1&&Y.instanceColor!==null||Y.isInstancedMesh&&Xe.instancingMorph===!0&&Y.morphTexture===null||Y.isInstancedMesh&&Xe.instancingMorph===!1&&Y.morphTexture!==null||Xe.envMap!==Te||Z.fog===!0&&Xe.fog!==de||Xe.numClippingPlanes!==void 0&&(Xe.numClippingPlanes!==he.numPlanes||Xe.numIntersection!==he.numIntersection)||Xe.vertexAlphas!==Ye||Xe.vertexTangents!==qe||Xe.morphTargets!==He||Xe.morphNormals!==ct||Xe.morphColors!==gt||Xe.toneMapping!==zt||Xe.morphTargetsCount!==ot)&&(dt=!0):(dt=!0,Xe.__version=Z.version);let Ln=Xe.currentProgram;dt===!0&&(Ln=Gs(Z,G,Y));let ms=!1,Bn=!1,Xs=!1;const Vt=Ln.getUniforms(),zn=Xe.uniforms;if(Ne.useProgram(Ln.program)&&(ms=!0,Bn=!0,Xs=!0),Z.id!==T&&(T=Z.id,Bn=!0),ms||E!==A){Ne.buffers.depth.getReversed()&&A.reversedDepth!==!0&&(A._reversedDepth=!0,A.updateProjectionMatrix()),Vt.setValue(F,"projectionMatrix",A.projectionMatrix),Vt.setValue(F,"viewMatrix",A.matrixWorldInverse);const yn=Vt.map.cameraPosition;yn!==void 0&&yn.setValue(F,we.setFromMatrixPosition(A.matrixWorld)),We.logarithmicDepthBuffer&&Vt.setValue(F,"logDepthBufFC",2/(Math.log(A.far+1)/Math.LN2)),(Z.isMeshPhongMaterial||Z.isMeshToonMaterial||Z.isMeshLambertMaterial||Z.isMeshBasicMaterial||Z.isMeshStandardMaterial||Z.isShaderMaterial)&&Vt.setValue(F,"isOrthographic",A.isOrthographicCamera===!0),E!==A&&(E=A,Bn=!0,Xs=!0)}if(Y.isSkinnedMesh){Vt.setOptional(F,Y,"bindMatrix"),Vt.setOptional(F,Y,"bindMatrixInverse");const xn=Y.skeleton;xn&&(xn.boneTexture===null&&xn.computeBoneTexture(),Vt.setValue(F,"boneTexture",xn.boneTexture,Ge))}Y.isBatchedMesh&&(Vt.setOptional(F,Y,"batchingTexture"),Vt.setValue(F,"batchingTexture",Y._matricesTexture,Ge),Vt.setOptional(F,Y,"batchingIdTexture"),Vt.setValue(F,"batchingIdTexture",Y._indirectTexture,Ge),Vt.setOptional(F,Y,"batchingColorTexture"),Y._colorsTexture!==null&&Vt.setValue(F,"batchingColorTexture",Y._colorsTexture,Ge));const $n=Q.morphAttributes;if(($n.position!==void 0||$n.normal!==void 0||$n.color!==void 0)&&le.update(Y,Q,Ln),(Bn||Xe.receiveShadow!==Y.receiveShadow)&&(Xe.receiveShadow=Y.receiveShadow,Vt.setValue(F,"receiveShadow",Y.receiveShadow)),Z.isMeshGouraudMaterial&&Z.envMap!==null&&(zn.envMap.value=Te,zn.flipEnvMap.value=Te.isCubeTexture&&Te.isRenderTargetTexture===!1?-1:1),Z.isMeshStandardMaterial&&Z.envMap===null&&G.environment!==null&&(zn.envMapIntensity.value=G.environmentIntensity),Bn&&(Vt.setValue(F,"toneMappingExposure",v.toneMappingExposure),Xe.needsLights&&dc(zn,Xs),de&&Z.fog===!0&&ie.refreshFogUniforms(zn,de),ie.refreshMaterialUniforms(zn,Z,K,j,p.state.transmissionRenderTarget[A.id]),Dl.upload(F,La(Xe),zn,Ge)),Z.isShaderMaterial&&Z.uniformsNeedUpdate===!0&&(Dl.upload(F,La(Xe),zn,Ge),Z.uniformsNeedUpdate=!1),Z.isSpriteMaterial&&Vt.setValue(F,"center",Y.center),Vt.setValue(F,"modelViewMatrix",Y.modelViewMatrix),Vt.setValue(F,"normalMatrix",Y.normalMatrix),Vt.setValue(F,"modelMatrix",Y.matrixWorld),Z.isShaderMaterial||Z.isRawShaderMaterial){const xn=Z.uniformsGroups;for(let yn=0,_s=xn.length;yn<_s;yn++){const hi=xn[yn];Ze.update(hi,Ln),Ze.bind(hi,Ln)}}return Ln}function dc(A,G){A.ambientLightColor.needsUpdate=G,A.lightProbe.needsUpdate=G,A.directionalLights.needsUpdate=G,A.directionalLightShadows.needsUpdate=G,A.pointLights.needsUpdate=G,A.pointLightShadows.needsUpdate=G,A.spotLights.needsUpdate=G,A.spotLightShadows.needsUpdate=G,A.rectAreaLights.needsUpdate=G,A.hemisphereLights.needsUpdate=G}function Ws(A){return A.isMeshLambertMaterial||A.isMeshToonMaterial||A.isMeshPhongMaterial||A.isMeshStandardMaterial||A.isShadowMaterial||A.isShaderMaterial&&A.lights===!0}this.getActiveCubeFace=function(){return R},this.getActiveMipmapLevel=function(){return U},this.getRenderTarget=function(){return N},this.setRenderTargetTextures=function(A,G,Q){const Z=Pe.get(A);Z.__autoAllocateDepthBuffer=A.resolveDepthBuffer===!1,Z.__autoAllocateDepthBuffer===!1&&(Z.__useRenderToTexture=!1),Pe.get(A.texture).__webglTexture=G,Pe.get(A.depthTexture).__webglTexture=Z.__autoAllocateDepthBuffer?void 0:Q,Z.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(A,G){const Q=Pe.get(A);Q.__webglFramebuffer=G,Q.__useDefaultFramebuffer=G===void 0};const Ua=F.createFramebuffer();this.setRenderTarget=function(A,G=0,Q=0){N=A,R=G,U=Q;let Z=!0,Y=null,de=!1,Se=!1;if(A){const Te=Pe.get(A);if(Te.__useDefaultFramebuffer!==void 0)Ne.bindFramebuffer(F.FRAMEBUFFER,null),Z=!1;else if(Te.__webglFramebuffer===void 0)Ge.setupRenderTarget(A);else if(Te.__hasExternalTextures)Ge.rebindTextures(A,Pe.get(A.texture).__webglTexture,Pe.get(A.depthTexture).__webglTexture);else if(A.depthBuffer){const He=A.depthTexture;if(Te.__boundDepthTexture!==He){if(He!==null&&Pe.has(He)&&(A.width!==He.image.width||A.height!==He.image.height))throw new Error("WebGLRenderTarget: Attached DepthTexture is initialized to the incorrect size.");Ge.setupDepthRenderbuffer(A)}}const Ye=A.texture;(Ye.isData3DTexture||Ye.isDataArrayTexture||Ye.isCompressedArrayTexture)&&(Se=!0);const qe=Pe.get(A).__webglFramebuffer;A.isWebGLCubeRenderTarget?(Array.isArray(qe[G])?Y=qe[G][Q]:Y=qe[G],de=!0):A.samples>0&&Ge.useMultisampledRTT(A)===!1?Y=Pe.get(A).__webglMultisampledFramebuffer:Array.isArray(qe)?Y=qe[Q]:Y=qe,C.copy(A.viewport),B.copy(A.scissor),z=A.scissorTest}else C.copy(me).multiplyScalar(K).floor(),B.copy(xe).multiplyScalar(K).floor(),z=ge;if(Q!==0&&(Y=Ua),Ne.bindFramebuffer(F.FRAMEBUFFER,Y)&&Z&&Ne.drawBuffers(A,Y),Ne.viewport(C),Ne.scissor(B),Ne.setScissorTest(z),de){const Te=Pe.get(A.texture);F.framebufferTexture2D(F.FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_CUBE_MAP_POSITIVE_X+G,Te.__webglTexture,Q)}else if(Se){const Te=G;for(let Ye=0;Ye<A.textures.length;Ye++){const qe=Pe.get(A.textures[Ye]);F.framebufferTextureLayer(F.FRAMEBUFFER,F.COLOR_ATTACHMENT0+Ye,qe.__webglTexture,Q,Te)}}else if(A!==null&&Q!==0){const Te=Pe.get(A.texture);F.framebufferTexture2D(F.FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_2D,Te.__webglTexture,Q)}T=-1},this.readRenderTargetPixels=function(A,G,Q,Z,Y,de,Se,Ie=0){if(!(A&&A.isWebGLRenderTarget)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Te=Pe.get(A).__webglFramebuffer;if(A.isWebGLCubeRenderTarget&&Se!==void 0&&(Te=Te[Se]),Te){Ne.bindFramebuffer(F.FRAMEBUFFER,Te);try{const Ye=A.textures[Ie],qe=Ye.format,He=Ye.type;if(!We.textureFormatReadable(qe)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(!We.textureTypeReadable(He)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}G>=0&&G<=A.width-Z&&Q>=0&&Q<=A.height-Y&&(A.textures.length>1&&F.readBuffer(F.COLOR_ATTACHMENT0+Ie),F.readPixels(G,Q,Z,Y,ke.convert(qe),ke.convert(He),de))}finally{const Ye=N!==null?Pe.get(N).__webglFramebuffer:null;Ne.bindFramebuffer(F.FRAMEBUFFER,Ye)}}},this.readRenderTargetPixelsAsync=async function(A,G,Q,Z,Y,de,Se,Ie=0){if(!(A&&A.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Te=Pe.get(A).__webglFramebuffer;if(A.isWebGLCubeRenderTarget&&Se!==void 0&&(Te=Te[Se]),Te)if(G>=0&&G<=A.width-Z&&Q>=0&&Q<=A.height-Y){Ne.bindFramebuffer(F.FRAMEBUFFER,Te);const Ye=A.textures[Ie],qe=Ye.format,He=Ye.type;if(!We.textureFormatReadable(qe))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(!We.textureTypeReadable(He))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");const ct=F.createBuffer();F.bindBuffer(F.PIXEL_PACK_BUFFER,ct),F.bufferData(F.PIXEL_PACK_BUFFER,de.byteLength,F.STREAM_READ),A.textures.length>1&&F.readBuffer(F.COLOR_ATTACHMENT0+Ie),F.readPixels(G,Q,Z,Y,ke.convert(qe),ke.convert(He),0);const gt=N!==null?Pe.get(N).__webglFramebuffer:null;Ne.bindFramebuffer(F.FRAMEBUFFER,gt);const zt=F.fenceSync(F.SYNC_GPU_COMMANDS_COMPLETE,0);return F.flush(),await dy(F,zt,4),F.bindBuffer(F.PIXEL_PACK_BUFFER,ct),F.getBufferSubData(F.PIXEL_PACK_BUFFER,0,de),F.deleteBuffer(ct),F.deleteSync(zt),de}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(A,G=null,Q=0){const Z=Math.pow(2,-Q),Y=Math.floor(A.image.width*Z),de=Math.floor(A.image.height*Z),Se=G!==null?G.x:0,Ie=G!==null?G.y:0;Ge.setTexture2D(A,0),F.copyTexSubImage2D(F.TEXTURE_2D,Q,0,0,Se,Ie,Y,de),Ne.unbindTexture()};const Ni=F.createFramebuffer(),hn=F.createFramebuffer();this.copyTextureToTexture=function(A,G,Q=null,Z=null,Y=0,de=null){de===null&&(Y!==0?(Ta("WebGLRenderer: copyTextureToTexture function signature has changed to support src and dst mipmap levels."),de=Y,Y=0):de=0);let Se,Ie,Te,Ye,qe,He,ct,gt,zt;const Rt=A.isCompressedTexture?A.mipmaps[de]:A.image;if(Q!==null)Se=Q.max.x-Q.min.x,Ie=Q.max.y-Q.min.y,Te=Q.isBox3?Q.max.z-Q.min.z:1,Ye=Q.min.x,qe=Q.min.y,He=Q.isBox3?Q.min.z:0;else{const $n=Math.pow(2,-Y);Se=Math.floor(Rt.width*$n),Ie=Math.floor(Rt.height*$n),A.isDataArrayTexture?Te=Rt.depth:A.isData3DTexture?Te=Math.floor(Rt.depth*$n):Te=1,Ye=0,qe=0,He=0}Z!==null?(ct=Z.x,gt=Z.y,zt=Z.z):(ct=0,gt=0,zt=0);const ot=ke.convert(G.format),Xe=ke.convert(G.type);let Ht;G.isData3DTexture?(Ge.setTexture3D(G,0),Ht=F.TEXTURE_3D):G.isDataArrayTexture||G.isCompressedArrayTexture?(Ge.setTexture2DArray(G,0),Ht=F.TEXTURE_2D_ARRAY):(Ge.setTexture2D(G,0),Ht=F.TEXTURE_2D),F.pixelStorei(F.UNPACK_FLIP_Y_WEBGL,G.flipY),F.pixelStorei(F.UNPACK_PREMULTIPLY_ALPHA_WEBGL,G.premultiplyAlpha),F.pixelStorei(F.UNPACK_ALIGNMENT,G.unpackAlignment);const dt=F.getParameter(F.UNPACK_ROW_LENGTH),Ln=F.getParameter(F.UNPACK_IMAGE_HEIGHT),ms=F.getParameter(F.UNPACK_SKIP_PIXELS),Bn=F.getParameter(F.UNPACK_SKIP_ROWS),Xs=F.getParameter(F.UNPACK_SKIP_IMAGES);F.pixelStorei(F.UNPACK_ROW_LENGTH,Rt.width),F.pixelStorei(F.UNPACK_IMAGE_HEIGHT,Rt.height),F.pixelStorei(F.UNPACK_SKIP_PIXELS,Ye),F.pixelStorei(F.UNPACK_SKIP_ROWS,qe),F.pixelStorei(F.UNPACK_SKIP_IMAGES,He);const Vt=A.isDataArrayTexture||A.isData3DTexture,zn=G.isDataArrayTexture||G.isData3DTexture;if(A.isDepthTexture){const $n=Pe.get(A),xn=Pe.get(G),yn=Pe.get($n.__renderTarget),_s=Pe.get(xn.__renderTarget);Ne.bindFramebuffer(F.READ_FRAMEBUFFER,yn.__webglFramebuffer),Ne.bindFramebuffer(F.DRAW_FRAMEBUFFER,_s.__webglFramebuffer);for(let hi=0;hi<Te;hi++)Vt&&(F.framebufferTextureLayer(F.READ_FRAMEBUFFER,F.COLOR_ATTACHMENT0,Pe.get(A).__webglTexture,Y,He+hi),F.framebufferTextureLayer(F.DRAW_FRAMEBUFFER,F.COLOR_ATTACHMENT0,Pe.get(G).__webglTexture,de,zt+hi)),F.blitFramebuffer(Ye,qe,Se,Ie,ct,gt,Se,Ie,F.DEPTH_BUFFER_BIT,F.NEAREST);Ne.bindFramebuffer(F.READ_FRAMEBUFFER,null),Ne.bindFramebuffer(F.DRAW_FRAMEBUFFER,null)}else if(Y!==0||A.isRenderTargetTexture||Pe.has(A)){const $n=Pe.get(A),xn=Pe.get(G);Ne.bindFramebuffer(F.READ_FRAMEBUFFER,Ni),Ne.bindFramebuffer(F.DRAW_FRAMEBUFFER,hn);for(let yn=0;yn<Te;yn++)Vt?F.framebufferTextureLayer(F.READ_FRAMEBUFFER,F.COLOR_ATTACHMENT0,$n.__webglTexture,Y,He+yn):F.framebufferTexture2D(F.READ_FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_2D,$n.__webglTexture,Y),zn?F.framebufferTextureLayer(F.DRAW_FRAMEBUFFER,F.COLOR_ATTACHMENT0,xn.__webglTexture,de,zt+yn):F.framebufferTexture2D(F.DRAW_FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_2D,xn.__webglTexture,de),Y!==0?F.blitFramebuffer(Ye,qe,Se,Ie,ct,gt,Se,Ie,F.COLOR_BUFFER_BIT,F.NEAREST):zn?F.copyTexSubImage3D(Ht,de,ct,gt,zt+yn,Ye,qe,Se,Ie):F.copyTexSubImage2D(Ht,de,ct,gt,Ye,qe,Se,Ie);Ne.bindFramebuffer(F.READ_FRAMEBUFFER,null),Ne.bindFramebuffer(F.DRAW_FRAMEBUFFER,null)}else zn?A.isDataTexture||A.isData3DTexture?F.texSubImage3D(Ht,de,ct,gt,zt,Se,Ie,Te,ot,Xe,Rt.data):G.isCompressedArrayTexture?F.compressedTexSubImage3D(Ht,de,ct,gt,zt,Se,Ie,Te,ot,Rt.data):F.texSubImage3D(Ht,de,ct,gt,zt,Se,Ie,Te,ot,Xe,Rt):A.isDataTexture?F.texSubImage2D(F.TEXTURE_2D,de,ct,gt,Se,Ie,ot,Xe,Rt.data):A.isCompressedTexture?F.compressedTexSubImage2D(F.TEXTURE_2D,de,ct,gt,Rt.width,Rt.height,ot,Rt.data):F.texSubImage2D(F.TEXTURE_2D,de,ct,gt,Se,Ie,ot,Xe,Rt);F.pixelStorei(F.UNPACK_ROW_LENGTH,dt),F.pixelStorei(F.UNPACK_IMAGE_HEIGHT,Ln),F.pixelStorei(F.UNPACK_SKIP_PIXELS,ms),F.pixelStorei(F.UNPACK_SKIP_ROWS,Bn),F.pixelStorei(F.UNPACK_SKIP_IMAGES,Xs),de===0&&G.generateMipmaps&&F.generateMipmap(Ht),Ne.unbindTexture()},this.initRenderTarget=function(A){Pe.get(A).__webglFramebuffer===void 0&&Ge.setupRenderTarget(A)},this.initTexture=function(A){A.isCubeTexture?Ge.setTextureCube(A,0):A.isData3DTexture?Ge.setTexture3D(A,0):A.isDataArrayTexture||A.isCompressedArrayTexture?Ge.setTexture2DArray(A,0):Ge.setTexture2D(A,0),Ne.unbindTexture()},this.resetState=function(){R=0,U=0,N=null,Ne.reset(),Me.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return $i}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;const t=this.getContext();t.drawingBufferColorSpace=xt._getDrawingBufferColorSpace(e),t.unpackColorSpace=xt._getUnpackColorSpace()}}const Zp={type:"change"},gf={type:"start"},og={type:"end"},ml=new uc,Kp=new Ls,Bw=Math.cos(70*hy.DEG2RAD),fn=new k,Zn=2*Math.PI,Ut={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},pu=1e-6;class zw extends eg{constructor(e,t=null){super(e,t),this.state=Ut.NONE,this.target=new k,this.cursor=new k,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:io.ROTATE,MIDDLE:io.DOLLY,RIGHT:io.PAN},this.touches={ONE:Jr.ROTATE,TWO:Jr.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._domElementKeyEvents=null,this._lastPosition=new k,this._lastQuaternion=new Rn,this._lastTargetPosition=new k,this._quat=new Rn().setFromUnitVectors(e.up,new k(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new bp,this._sphericalDelta=new bp,this._scale=1,this._panOffset=new k,this._rotateStart=new Ke,this._rotateEnd=new Ke,this._rotateDelta=new Ke,this._panStart=new Ke,this._panEnd=new Ke,this._panDelta=new Ke,this._dollyStart=new Ke,this._dollyEnd=new Ke,this._dollyDelta=new Ke,this._dollyDirection=new k,this._mouse=new Ke,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=Vw.bind(this),this._onPointerDown=Hw.bind(this),this._onPointerUp=Gw.bind(this),this._onContextMenu=Zw.bind(this),this._onMouseWheel=Yw.bind(this),this._onKeyDown=qw.bind(this),this._onTouchStart=$w.bind(this),this._onTouchMove=jw.bind(this),this._onMouseDown=Ww.bind(this),this._onMouseMove=Xw.bind(this),this._interceptControlDown=Kw.bind(this),this._interceptControlUp=Jw.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}connect(e){super.connect(e),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.getRootNode().addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.removeEventListener("pointermove",this._onPointerMove),this.domElement.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.getRootNode().removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.style.touchAction="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(e){e.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=e}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(Zp),this.update(),this.state=Ut.NONE}update(e=null){const t=this.object.position;fn.copy(t).sub(this.target),fn.applyQuaternion(this._quat),this._spherical.setFromVector3(fn),this.autoRotate&&this.state===Ut.NONE&&this._rotateLeft(this._getAutoRotationAngle(e)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let i=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(i)&&isFinite(s)&&(i<-Math.PI?i+=Zn:i>Math.PI&&(i-=Zn),s<-Math.PI?s+=Zn:s>Math.PI&&(s-=Zn),i<=s?this._spherical.theta=Math.max(i,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(i+s)/2?Math.max(i,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{const o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(fn.setFromSpherical(this._spherical),fn.applyQuaternion(this._quatInverse),t.copy(this.target).add(fn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){const a=fn.length();o=this._clampDistance(a*this._scale);const l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){const a=new k(this._mouse.x,this._mouse.y,0);a.unproject(this.object);const l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;const c=new k(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=fn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(ml.origin.copy(this.object.position),ml.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(ml.direction))<Bw?this.object.lookAt(this.target):(Kp.setFromNormalAndCoplanarPoint(this.object.up,this.target),ml.intersectPlane(Kp,this.target))))}else if(this.object.isOrthographicCamera){const o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>pu||8*(1-this._lastQuaternion.dot(this.object.quaternion))>pu||this._lastTargetPosition.distanceToSquared(this.target)>pu?(this.dispatchEvent(Zp),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(e){return e!==null?Zn/60*this.autoRotateSpeed*e:Zn/60/60*this.autoRotateSpeed}_getZoomScale(e){const t=Math.abs(e*.01);return Math.pow(.95,this.zoomSpeed*t)}_rotateLeft(e){this._sphericalDelta.theta-=e}_rotateUp(e){this._sphericalDelta.phi-=e}_panLeft(e,t){fn.setFromMatrixColumn(t,0),fn.multiplyScalar(-e),this._panOffset.add(fn)}_panUp(e,t){this.screenSpacePanning===!0?fn.setFromMatrixColumn(t,1):(fn.setFromMatrixColumn(t,0),fn.crossVectors(this.object.up,fn)),fn.multiplyScalar(e),this._panOffset.add(fn)}_pan(e,t){const i=this.domElement;if(this.object.isPerspectiveCamera){const s=this.object.position;fn.copy(s).sub(this.target);let r=fn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*e*r/i.clientHeight,this.object.matrix),this._panUp(2*t*r/i.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(e*(this.object.right-this.object.left)/this.object.zoom/i.clientWidth,this.object.matrix),this._panUp(t*(this.object.top-this.object.bottom)/this.object.zoom/i.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(e,t){if(!this.zoomToCursor)return;this._performCursorZoom=!0;const i=this.domElement.getBoundingClientRect(),s=e-i.left,r=t-i.top,o=i.width,a=i.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(e){return Math.max(this.minDistance,Math.min(this.maxDistance,e))}_handleMouseDownRotate(e){this._rotateStart.set(e.clientX,e.clientY)}_handleMouseDownDolly(e){this._updateZoomParameters(e.clientX,e.clientX),this._dollyStart.set(e.clientX,e.clientY)}_handleMouseDownPan(e){this._panStart.set(e.clientX,e.clientY)}_handleMouseMoveRotate(e){this._rotateEnd.set(e.clientX,e.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);const t=this.domElement;this._rotateLeft(Zn*this._rotateDelta.x/t.clientHeight),this._rotateUp(Zn*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(e){this._dollyEnd.set(e.clientX,e.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.update()}_handleMouseMovePan(e){this._panEnd.set(e.clientX,e.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(e){this._updateZoomParameters(e.clientX,e.clientY),e.deltaY<0?this._dollyIn(this._getZoomScale(e.deltaY)):e.deltaY>0&&this._dollyOut(this._getZoomScale(e.deltaY)),this.update()}_handleKeyDown(e){let t=!1;switch(e.code){case this.keys.UP:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(Zn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),t=!0;break;case this.keys.BOTTOM:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(-Zn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),t=!0;break;case this.keys.LEFT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(Zn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),t=!0;break;case this.keys.RIGHT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(-Zn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),t=!0;break}t&&(e.preventDefault(),this.update())}_handleTouchStartRotate(e){if(this._pointers.length===1)this._rotateStart.set(e.pageX,e.pageY);else{const t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._rotateStart.set(i,s)}}_handleTouchStartPan(e){if(this._pointers.length===1)this._panStart.set(e.pageX,e.pageY);else{const t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panStart.set(i,s)}}_handleTouchStartDolly(e){const t=this._getSecondPointerPosition(e),i=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(i*i+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enablePan&&this._handleTouchStartPan(e)}_handleTouchStartDollyRotate(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enableRotate&&this._handleTouchStartRotate(e)}_handleTouchMoveRotate(e){if(this._pointers.length==1)this._rotateEnd.set(e.pageX,e.pageY);else{const i=this._getSecondPointerPosition(e),s=.5*(e.pageX+i.x),r=.5*(e.pageY+i.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);const t=this.domElement;this._rotateLeft(Zn*this._rotateDelta.x/t.clientHeight),this._rotateUp(Zn*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(e){if(this._pointers.length===1)this._panEnd.set(e.pageX,e.pageY);else{const t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panEnd.set(i,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(e){const t=this._getSecondPointerPosition(e),i=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(i*i+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);const o=(e.pageX+t.x)*.5,a=(e.pageY+t.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enablePan&&this._handleTouchMovePan(e)}_handleTouchMoveDollyRotate(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enableRotate&&this._handleTouchMoveRotate(e)}_addPointer(e){this._pointers.push(e.pointerId)}_removePointer(e){delete this._pointerPositions[e.pointerId];for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId){this._pointers.splice(t,1);return}}_isTrackingPointer(e){for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId)return!0;return!1}_trackPointer(e){let t=this._pointerPositions[e.pointerId];t===void 0&&(t=new Ke,this._pointerPositions[e.pointerId]=t),t.set(e.pageX,e.pageY)}_getSecondPointerPosition(e){const t=e.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[t]}_customWheelEvent(e){const t=e.deltaMode,i={clientX:e.clientX,clientY:e.clientY,deltaY:e.deltaY};switch(t){case 1:i.deltaY*=16;break;case 2:i.deltaY*=100;break}return e.ctrlKey&&!this._controlActive&&(i.deltaY*=10),i}}function Hw(n){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(n.pointerId),this.domElement.addEventListener("pointermove",this._onPointerMove),this.domElement.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(n)&&(this._addPointer(n),n.pointerType==="touch"?this._onTouchStart(n):this._onMouseDown(n)))}function Vw(n){this.enabled!==!1&&(n.pointerType==="touch"?this._onTouchMove(n):this._onMouseMove(n))}function Gw(n){switch(this._removePointer(n),this._pointers.length){case 0:this.domElement.releasePointerCapture(n.pointerId),this.domElement.removeEventListener("pointermove",this._onPointerMove),this.domElement.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(og),this.state=Ut.NONE;break;case 1:const e=this._pointers[0],t=this._pointerPositions[e];this._onTouchStart({pointerId:e,pageX:t.x,pageY:t.y});break}}function Ww(n){let e;switch(n.button){case 0:e=this.mouseButtons.LEFT;break;case 1:e=this.mouseButtons.MIDDLE;break;case 2:e=this.mouseButtons.RIGHT;break;default:e=-1}switch(e){case io.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(n),this.state=Ut.DOLLY;break;case io.ROTATE:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Ut.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Ut.ROTATE}break;case io.PAN:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Ut.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Ut.PAN}break;default:this.state=Ut.NONE}this.state!==Ut.NONE&&this.dispatchEvent(gf)}function Xw(n){switch(this.state){case Ut.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(n);break;case Ut.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(n);break;case Ut.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(n);break}}function Yw(n){this.enabled===!1||this.enableZoom===!1||this.state!==Ut.NONE||(n.preventDefault(),this.dispatchEvent(gf),this._handleMouseWheel(this._customWheelEvent(n)),this.dispatchEvent(og))}function qw(n){this.enabled!==!1&&this._handleKeyDown(n)}function $w(n){switch(this._trackPointer(n),this._pointers.length){case 1:switch(this.touches.ONE){case Jr.ROTATE:if(this.enableRotate===!1)return;this._handleTouchStartRotate(n),this.state=Ut.TOUCH_ROTATE;break;case Jr.PAN:if(this.enablePan===!1)return;this._handleTouchStartPan(n),this.state=Ut.TOUCH_PAN;break;default:this.state=Ut.NONE}break;case 2:switch(this.touches.TWO){case Jr.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(n),this.state=Ut.TOUCH_DOLLY_PAN;break;case Jr.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(n),this.state=Ut.TOUCH_DOLLY_ROTATE;break;default:this.state=Ut.NONE}break;default:this.state=Ut.NONE}this.state!==Ut.NONE&&this.dispatchEvent(gf)}function jw(n){switch(this._trackPointer(n),this.state){case Ut.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(n),this.update();break;case Ut.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(n),this.update();break;case Ut.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(n),this.update();break;case Ut.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(n),this.update();break;default:this.state=Ut.NONE}}function Zw(n){this.enabled!==!1&&n.preventDefault()}function Kw(n){n.key==="Control"&&(this._controlActive=!0,this.domElement.getRootNode().addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function Jw(n){n.key==="Control"&&(this._controlActive=!1,this.domElement.getRootNode().removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}async function Qw(n){const e=Qg(n);if(e)return e;const t=await fetch(`/mesh/${n}`);return t.ok?t.arrayBuffer():null}const eT=new Je(8141549),tT=new Je(0);class nT{constructor(e){this.invalidate=e}invalidate;object=new ji;links=[];parts=[];axes=[];collision=[];cache=new Map;matrices=null;generation=0;async load(e){const t=++this.generation,i=new Map,s=new Set(e.links.flatMap(r=>r.parts.map(o=>o.mesh)));await Promise.all([...s].map(async r=>i.set(r,await this.geometry(r)))),t===this.generation&&(this.object.clear(),this.links=[],this.parts=[],this.axes=[],this.collision=[],e.links.forEach((r,o)=>{const a=new ji;a.name=r.name,a.matrixAutoUpdate=!1;for(const c of r.parts){const u=i.get(c.mesh);if(!u)continue;const[f,d,h,_]=c.color,x=new $y({color:new Je().setRGB(f,d,h,"srgb"),roughness:.46,metalness:.08,side:ds,opacity:_,transparent:_<1,wireframe:c.collision}),m=new be(u,x);m.castShadow=m.receiveShadow=!c.collision,m.visible=!c.collision,vf(m,c.placed),c.collision?this.collision.push(m):this.parts.push({geometry:u,placed:m.matrix.clone(),link:o}),a.add(m)}const l=new Q_(.11*e.reach);l.visible=!1,this.axes.push(l),a.add(l),this.links.push(a),this.object.add(a)}),this.matrices&&this.move(this.matrices),this.invalidate())}geometry(e){let t=this.cache.get(e);return t||(t=Qw(e).then(i=>{const s=new rn,r=i?n0(i):null;return r&&(s.setAttribute("position",new Pn(r.positions,3)),s.setAttribute("normal",new Pn(r.normals,3)),s.setIndex(new Pn(r.indices,1))),s}),this.cache.set(e,t)),t}move(e){this.matrices=e,!(e.length<16*this.links.length)&&this.links.forEach((t,i)=>{t.matrix.fromArray(e,16*i),t.matrixWorldNeedsUpdate=!0})}highlight(e){this.links.forEach((t,i)=>{for(const s of t.children)if(s instanceof be){const r=s.material;r.emissive=i===e?eT:tT,r.emissiveIntensity=i===e?.75:0}}),this.invalidate()}showFrames(e){for(const t of this.axes)t.visible=e;this.invalidate()}showCollision(e){for(const t of this.collision)t.visible=e;this.invalidate()}}const mu=16,iT=new Je(8141549);class sT{object=new ji;meshes=[];plainColor=new Je(7042182);frame=null;hidden=[];pointed=null;load(e){this.object.clear(),this.meshes.forEach(({mesh:t})=>t.dispose()),this.meshes=e.parts.map(t=>{const i=new jy({transparent:!0,opacity:.17,depthWrite:!1,polygonOffset:!0,polygonOffsetFactor:3,polygonOffsetUnits:12}),s=new Hy(t.geometry,i,mu);return s.frustumCulled=!1,s.count=0,s.renderOrder=2,this.object.add(s),{mesh:s,part:t}}),this.frame&&this.move(this.frame,this.hidden)}setDark(e){this.plainColor=new Je(e?11187141:5989496),this.paint()}move(e,t){this.frame=e,this.hidden=t;const i=[];for(let r=0;r<Math.min(e.count,mu);r++)t[r]||i.push(r);const s=new Pt;for(const{mesh:r,part:o}of this.meshes){r.count=0;for(const a of i){const l=16*(a*e.links+o.link);l+16>e.matrices.length||r.setMatrixAt(r.count++,s.fromArray(e.matrices,l).multiply(o.placed))}r.instanceMatrix.needsUpdate=!0}this.paint()}point(e){this.pointed=e,this.paint()}paint(){if(!this.frame)return;const e=[];for(let t=0;t<Math.min(this.frame.count,mu);t++)this.hidden[t]||e.push(t);for(const{mesh:t}of this.meshes)e.forEach((i,s)=>t.setColorAt(s,i===this.pointed?iT:this.plainColor)),t.instanceColor&&(t.instanceColor.needsUpdate=!0),t.material.opacity=this.pointed===null?.17:.24}}const rT=`
varying vec2 place;
void main() { place = position.xy; gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0); }`,oT=`
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
}`;class aT{object=new ji;grid;shadow=new qy({opacity:.2,depthWrite:!1});planes;constructor(){this.grid=new ps({vertexShader:rT,fragmentShader:oT,transparent:!0,depthWrite:!1,uniforms:{ink:{value:new Je(3883602)},strength:{value:.34},span:{value:4},cell:{value:.1}}});const e=new be(new Os(2,2),this.grid),t=new be(new Os(2,2),this.shadow);t.receiveShadow=!0,t.position.z=-5e-4,e.renderOrder=t.renderOrder=-1,this.planes=[e,t],this.object.add(e,t)}resize(e){const t=3.2*e;for(const o of this.planes)o.geometry.dispose(),o.geometry=new Os(2*t,2*t),o.position.z=-.001*e;const i=e/8,s=10**Math.floor(Math.log10(i)),r=s*([1,2,5,10].find(o=>o*s>=i)??10);this.grid.uniforms.span.value=t,this.grid.uniforms.cell.value=r/1}setDark(e){this.grid.uniforms.ink.value.set(e?11187400:3883602),this.grid.uniforms.strength.value=e?.22:.3,this.shadow.opacity=e?.42:.2}}const Jp=600;class lT{object=new ji;way=new _i(new rn,new oo({color:8141549,transparent:!0,opacity:.85}));trail;points=new Float32Array(3*Jp);length=0;reach=new Yy(new rn,new oo({transparent:!0,opacity:.6}));constructor(){const e=new rn;e.setAttribute("position",new Pn(this.points,3).setUsage(cy)),e.setDrawRange(0,0),this.trail=new _i(e,new oo({color:15227148,transparent:!0,opacity:.9})),this.trail.frustumCulled=this.way.frustumCulled=!1,this.reach.visible=!1,this.object.add(this.way,this.trail,this.reach)}setDark(e){this.way.material.color=new Je(e?10980346:7153881),this.trail.material.color=new Je(e?16486972:14239759),this.reach.material.color=new Je(e?6220500:1013358)}setWay(e){this.way.geometry.dispose(),this.way.geometry=new rn,this.way.geometry.setAttribute("position",new Pn(new Float32Array(e.flat()),3))}add(e){const t=3*(this.length-1);if(this.length>0&&Math.hypot(...e.map((r,o)=>r-this.points[t+o]))<1e-5)return;this.length===Jp&&(this.points.copyWithin(0,3),this.length-=1),this.points.set(e,3*this.length),this.length+=1;const{geometry:i}=this.trail;i.setDrawRange(0,this.length),i.attributes.position.needsUpdate=!0}clearTrail(){this.length=0,this.trail.geometry.setDrawRange(0,0)}showTrail(e){this.trail.visible=this.way.visible=e}outline(e){const t=e.outline.map(([s,r])=>[s,0,r]),i=[...e.outline].reverse().map(([s,r])=>[-s,0,r]);this.reach.geometry.dispose(),this.reach.geometry=new rn,this.reach.geometry.setAttribute("position",new Pn(new Float32Array([...t,...i].flat()),3)),vf(this.reach,e.outline_frame),this.clearTrail()}showOutline(e){this.reach.visible=e}}const qo=new URLSearchParams(location.search).has("plain");class cT{constructor(e){this.canvas=e,this.renderer=new kw({canvas:e,antialias:!qo,alpha:!0,preserveDrawingBuffer:qo,powerPreference:"high-performance"}),this.renderer.toneMapping=D_,this.renderer.toneMappingExposure=1.05,this.renderer.shadowMap.enabled=!qo,this.renderer.shadowMap.type=P_,this.perspective.up.set(0,0,1),this.orthographic.up.set(0,0,1),this.controls=new zw(this.perspective,e),this.controls.zoomToCursor=!0,this.controls.enableDamping=!1,this.controls.addEventListener("change",()=>this.invalidate()),this.arm=new nT(()=>this.invalidate()),this.ghosts=new sT,this.sun.castShadow=!qo,this.sun.shadow.mapSize.set(2048,2048),this.sun.shadow.radius=6,this.sun.shadow.bias=-4e-4,this.sun.shadow.normalBias=.01,this.tool.add(this.triad),this.scene.add(this.sky,this.sun,this.sun.target,this.fill,this.ground.object,this.arm.object,this.ghosts.object,this.path.object,this.tool),new ResizeObserver(()=>this.resize()).observe(e.parentElement),this.resize()}canvas;renderer;scene=new ky;perspective=new xi(38,1,.01,200);orthographic=new mf(-1,1,1,-1,-100,200);camera=this.perspective;controls;arm;ghosts;ground=new aT;path=new lT;tool=new ji;triad=new Q_(1);sun=new Mp(16777215,2.2);sky=new Jy(16777215,9080730,1.5);fill=new Mp(14673663,.7);reach=1;wanted=!1;statistics={pictures:0,calls:0,triangles:0,milliseconds:0};beforeDraw=[];invalidate(){this.wanted||(this.wanted=!0,requestAnimationFrame(()=>{this.wanted=!1,this.draw()}))}onDraw(e){this.beforeDraw.push(e)}draw(){const e=performance.now();for(const s of this.beforeDraw)s();this.renderer.render(this.scene,this.camera);const{calls:t,triangles:i}=this.renderer.info.render;Object.assign(this.statistics,{calls:t,triangles:i,milliseconds:performance.now()-e}),this.statistics.pictures+=1}resize(){const e=this.canvas.parentElement,[t,i]=[Math.max(1,e.clientWidth),Math.max(1,e.clientHeight)];this.renderer.setPixelRatio(qo?1:Math.min(devicePixelRatio,2)),this.renderer.setSize(t,i,!1),this.perspective.aspect=t/i,this.perspective.updateProjectionMatrix(),this.matchOrthographic(),this.invalidate()}async show(e,t){this.reach=e.reach,this.perspective.near=e.reach/200,this.perspective.far=e.reach*200;const i=e.reach;this.sun.position.set(1.2*i,-1.6*i,3.2*i),this.fill.position.set(-2*i,1.5*i,1.2*i);const s=this.sun.shadow.camera;Object.assign(s,{left:-1.7*i,right:1.7*i,top:1.7*i,bottom:-1.7*i,near:.2*i,far:8*i}),s.updateProjectionMatrix(),this.triad.scale.setScalar(.12*i),this.ground.resize(i),await this.arm.load(e),this.ghosts.load(this.arm),this.path.outline(e),t||this.fit("home"),this.invalidate()}setDark(e){this.scene.background=null,this.sky.intensity=e?1.05:1.5,this.sky.groundColor=new Je(e?2764086:10133160),this.ground.setDark(e),this.path.setDark(e),this.ghosts.setDark(e),this.invalidate()}fit(e){const t=new Hs().setFromObject(this.arm.object);t.isEmpty()&&t.setFromCenterAndSize(new k(0,0,this.reach/2),new k(1,1,1).multiplyScalar(this.reach));const i=t.getBoundingSphere(new br),s={home:new k(1,-1.25,.62),front:new k(1,0,0),right:new k(0,-1,0),top:new k(0,-1e-4,1),here:this.camera.position.clone().sub(this.controls.target)},r=Math.min(1,this.perspective.aspect),o=.94*i.radius/Math.sin(this.perspective.fov*Math.PI/360)/r;this.controls.target.copy(i.center),this.perspective.position.copy(i.center).addScaledVector(s[e].normalize(),o),this.orthographic.position.copy(this.perspective.position),this.matchOrthographic(),this.controls.update(),this.invalidate()}toggleProjection(){const e=this.camera===this.perspective?this.orthographic:this.perspective;e.position.copy(this.camera.position),this.camera=e,this.controls.object=e,this.matchOrthographic(),this.controls.update(),this.invalidate()}matchOrthographic(){const e=this.controls?this.camera.position.distanceTo(this.controls.target)*Math.tan(this.perspective.fov*Math.PI/360):1,{aspect:t}=this.perspective;Object.assign(this.orthographic,{left:-e*t,right:e*t,top:e,bottom:-e}),this.orthographic.updateProjectionMatrix()}ray(e){const t=this.canvas.getBoundingClientRect(),i=new Ke(2*(e.clientX-t.left)/t.width-1,1-2*(e.clientY-t.top)/t.height),s=new J_;return s.setFromCamera(i,this.camera),{origin:s.ray.origin.toArray(),direction:s.ray.direction.toArray()}}project(e){const t=this.canvas.getBoundingClientRect(),i=new k(...e).project(this.camera);return[t.left+(i.x+1)/2*t.width,t.top+(1-i.y)/2*t.height]}setTool(e){vf(this.tool,e),this.tool.updateMatrixWorld()}get size(){return this.reach}}function vf(n,e){n.matrixAutoUpdate=!1;const t=e.flat();n.matrix.set(...t),n.matrixWorldNeedsUpdate=!0}const tr=new J_,Fn=new k,Rs=new k,Zt=new Rn,Qp={X:new k(1,0,0),Y:new k(0,1,0),Z:new k(0,0,1)},_u={type:"change"},em={type:"mouseDown",mode:null},tm={type:"mouseUp",mode:null},nm={type:"objectChange"};class uT extends eg{constructor(e,t=null){super(void 0,t);const i=new _T(this);this._root=i;const s=new gT;this._gizmo=s,i.add(s);const r=new vT;this._plane=r,i.add(r);const o=this;function a(b,v){let L=v;Object.defineProperty(o,b,{get:function(){return L!==void 0?L:v},set:function(R){L!==R&&(L=R,r[b]=R,s[b]=R,o.dispatchEvent({type:b+"-changed",value:R}),o.dispatchEvent(_u))}}),o[b]=v,r[b]=v,s[b]=v}a("camera",e),a("object",void 0),a("enabled",!0),a("axis",null),a("mode","translate"),a("translationSnap",null),a("rotationSnap",null),a("scaleSnap",null),a("space","world"),a("size",1),a("dragging",!1),a("showX",!0),a("showY",!0),a("showZ",!0),a("minX",-1/0),a("maxX",1/0),a("minY",-1/0),a("maxY",1/0),a("minZ",-1/0),a("maxZ",1/0);const l=new k,c=new k,u=new Rn,f=new Rn,d=new k,h=new Rn,_=new k,x=new k,m=new k,p=0,M=new k;a("worldPosition",l),a("worldPositionStart",c),a("worldQuaternion",u),a("worldQuaternionStart",f),a("cameraPosition",d),a("cameraQuaternion",h),a("pointStart",_),a("pointEnd",x),a("rotationAxis",m),a("rotationAngle",p),a("eye",M),this._offset=new k,this._startNorm=new k,this._endNorm=new k,this._cameraScale=new k,this._parentPosition=new k,this._parentQuaternion=new Rn,this._parentQuaternionInv=new Rn,this._parentScale=new k,this._worldScaleStart=new k,this._worldQuaternionInv=new Rn,this._worldScale=new k,this._positionStart=new k,this._quaternionStart=new Rn,this._scaleStart=new k,this._getPointer=hT.bind(this),this._onPointerDown=dT.bind(this),this._onPointerHover=fT.bind(this),this._onPointerMove=pT.bind(this),this._onPointerUp=mT.bind(this),t!==null&&this.connect(t)}connect(e){super.connect(e),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointermove",this._onPointerHover),this.domElement.addEventListener("pointerup",this._onPointerUp),this.domElement.style.touchAction="none"}disconnect(){this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.removeEventListener("pointermove",this._onPointerHover),this.domElement.removeEventListener("pointermove",this._onPointerMove),this.domElement.removeEventListener("pointerup",this._onPointerUp),this.domElement.style.touchAction="auto"}getHelper(){return this._root}pointerHover(e){if(this.object===void 0||this.dragging===!0)return;e!==null&&tr.setFromCamera(e,this.camera);const t=gu(this._gizmo.picker[this.mode],tr);t?this.axis=t.object.name:this.axis=null}pointerDown(e){if(!(this.object===void 0||this.dragging===!0||e!=null&&e.button!==0)&&this.axis!==null){e!==null&&tr.setFromCamera(e,this.camera);const t=gu(this._plane,tr,!0);t&&(this.object.updateMatrixWorld(),this.object.parent.updateMatrixWorld(),this._positionStart.copy(this.object.position),this._quaternionStart.copy(this.object.quaternion),this._scaleStart.copy(this.object.scale),this.object.matrixWorld.decompose(this.worldPositionStart,this.worldQuaternionStart,this._worldScaleStart),this.pointStart.copy(t.point).sub(this.worldPositionStart)),this.dragging=!0,em.mode=this.mode,this.dispatchEvent(em)}}pointerMove(e){const t=this.axis,i=this.mode,s=this.object;let r=this.space;if(i==="scale"?r="local":(t==="E"||t==="XYZE"||t==="XYZ")&&(r="world"),s===void 0||t===null||this.dragging===!1||e!==null&&e.button!==-1)return;e!==null&&tr.setFromCamera(e,this.camera);const o=gu(this._plane,tr,!0);if(o){if(this.pointEnd.copy(o.point).sub(this.worldPositionStart),i==="translate")this._offset.copy(this.pointEnd).sub(this.pointStart),r==="local"&&t!=="XYZ"&&this._offset.applyQuaternion(this._worldQuaternionInv),t.indexOf("X")===-1&&(this._offset.x=0),t.indexOf("Y")===-1&&(this._offset.y=0),t.indexOf("Z")===-1&&(this._offset.z=0),r==="local"&&t!=="XYZ"?this._offset.applyQuaternion(this._quaternionStart).divide(this._parentScale):this._offset.applyQuaternion(this._parentQuaternionInv).divide(this._parentScale),s.position.copy(this._offset).add(this._positionStart),this.translationSnap&&(r==="local"&&(s.position.applyQuaternion(Zt.copy(this._quaternionStart).invert()),t.search("X")!==-1&&(s.position.x=Math.round(s.position.x/this.translationSnap)*this.translationSnap),t.search("Y")!==-1&&(s.position.y=Math.round(s.position.y/this.translationSnap)*this.translationSnap),t.search("Z")!==-1&&(s.position.z=Math.round(s.position.z/this.translationSnap)*this.translationSnap),s.position.applyQuaternion(this._quaternionStart)),r==="world"&&(s.parent&&s.position.add(Fn.setFromMatrixPosition(s.parent.matrixWorld)),t.search("X")!==-1&&(s.position.x=Math.round(s.position.x/this.translationSnap)*this.translationSnap),t.search("Y")!==-1&&(s.position.y=Math.round(s.position.y/this.translationSnap)*this.translationSnap),t.search("Z")!==-1&&(s.position.z=Math.round(s.position.z/this.translationSnap)*this.translationSnap),s.parent&&s.position.sub(Fn.setFromMatrixPosition(s.parent.matrixWorld)))),s.position.x=Math.max(this.minX,Math.min(this.maxX,s.position.x)),s.position.y=Math.max(this.minY,Math.min(this.maxY,s.position.y)),s.position.z=Math.max(this.minZ,Math.min(this.maxZ,s.position.z));else if(i==="scale"){if(t.search("XYZ")!==-1){let a=this.pointEnd.length()/this.pointStart.length();this.pointEnd.dot(this.pointStart)<0&&(a*=-1),Rs.set(a,a,a)}else Fn.copy(this.pointStart),Rs.copy(this.pointEnd),Fn.applyQuaternion(this._worldQuaternionInv),Rs.applyQuaternion(this._worldQuaternionInv),Rs.divide(Fn),t.search("X")===-1&&(Rs.x=1),t.search("Y")===-1&&(Rs.y=1),t.search("Z")===-1&&(Rs.z=1);s.scale.copy(this._scaleStart).multiply(Rs),this.scaleSnap&&(t.search("X")!==-1&&(s.scale.x=Math.round(s.scale.x/this.scaleSnap)*this.scaleSnap||this.scaleSnap),t.search("Y")!==-1&&(s.scale.y=Math.round(s.scale.y/this.scaleSnap)*this.scaleSnap||this.scaleSnap),t.search("Z")!==-1&&(s.scale.z=Math.round(s.scale.z/this.scaleSnap)*this.scaleSnap||this.scaleSnap))}else if(i==="rotate"){this._offset.copy(this.pointEnd).sub(this.pointStart);const a=20/this.worldPosition.distanceTo(Fn.setFromMatrixPosition(this.camera.matrixWorld));let l=!1;t==="XYZE"?(this.rotationAxis.copy(this._offset).cross(this.eye).normalize(),this.rotationAngle=this._offset.dot(Fn.copy(this.rotationAxis).cross(this.eye))*a):(t==="X"||t==="Y"||t==="Z")&&(this.rotationAxis.copy(Qp[t]),Fn.copy(Qp[t]),r==="local"&&Fn.applyQuaternion(this.worldQuaternion),Fn.cross(this.eye),Fn.length()===0?l=!0:this.rotationAngle=this._offset.dot(Fn.normalize())*a),(t==="E"||l)&&(this.rotationAxis.copy(this.eye),this.rotationAngle=this.pointEnd.angleTo(this.pointStart),this._startNorm.copy(this.pointStart).normalize(),this._endNorm.copy(this.pointEnd).normalize(),this.rotationAngle*=this._endNorm.cross(this._startNorm).dot(this.eye)<0?1:-1),this.rotationSnap&&(this.rotationAngle=Math.round(this.rotationAngle/this.rotationSnap)*this.rotationSnap),r==="local"&&t!=="E"&&t!=="XYZE"?(s.quaternion.copy(this._quaternionStart),s.quaternion.multiply(Zt.setFromAxisAngle(this.rotationAxis,this.rotationAngle)).normalize()):(this.rotationAxis.applyQuaternion(this._parentQuaternionInv),s.quaternion.copy(Zt.setFromAxisAngle(this.rotationAxis,this.rotationAngle)),s.quaternion.multiply(this._quaternionStart).normalize())}this.dispatchEvent(_u),this.dispatchEvent(nm)}}pointerUp(e){e!==null&&e.button!==0||(this.dragging&&this.axis!==null&&(tm.mode=this.mode,this.dispatchEvent(tm)),this.dragging=!1,this.axis=null)}dispose(){this.disconnect(),this._root.dispose()}attach(e){return this.object=e,this._root.visible=!0,this}detach(){return this.object=void 0,this.axis=null,this._root.visible=!1,this}reset(){this.enabled&&this.dragging&&(this.object.position.copy(this._positionStart),this.object.quaternion.copy(this._quaternionStart),this.object.scale.copy(this._scaleStart),this.dispatchEvent(_u),this.dispatchEvent(nm),this.pointStart.copy(this.pointEnd))}getRaycaster(){return tr}getMode(){return this.mode}setMode(e){this.mode=e}setTranslationSnap(e){this.translationSnap=e}setRotationSnap(e){this.rotationSnap=e}setScaleSnap(e){this.scaleSnap=e}setSize(e){this.size=e}setSpace(e){this.space=e}setColors(e,t,i,s){const r=this._gizmo.materialLib;r.xAxis.color.set(e),r.yAxis.color.set(t),r.zAxis.color.set(i),r.active.color.set(s),r.xAxisTransparent.color.set(e),r.yAxisTransparent.color.set(t),r.zAxisTransparent.color.set(i),r.activeTransparent.color.set(s),r.xAxis._color&&r.xAxis._color.set(e),r.yAxis._color&&r.yAxis._color.set(t),r.zAxis._color&&r.zAxis._color.set(i),r.active._color&&r.active._color.set(s),r.xAxisTransparent._color&&r.xAxisTransparent._color.set(e),r.yAxisTransparent._color&&r.yAxisTransparent._color.set(t),r.zAxisTransparent._color&&r.zAxisTransparent._color.set(i),r.activeTransparent._color&&r.activeTransparent._color.set(s)}}function hT(n){if(this.domElement.ownerDocument.pointerLockElement)return{x:0,y:0,button:n.button};{const e=this.domElement.getBoundingClientRect();return{x:(n.clientX-e.left)/e.width*2-1,y:-(n.clientY-e.top)/e.height*2+1,button:n.button}}}function fT(n){if(this.enabled)switch(n.pointerType){case"mouse":case"pen":this.pointerHover(this._getPointer(n));break}}function dT(n){this.enabled&&(document.pointerLockElement||this.domElement.setPointerCapture(n.pointerId),this.domElement.addEventListener("pointermove",this._onPointerMove),this.pointerHover(this._getPointer(n)),this.pointerDown(this._getPointer(n)))}function pT(n){this.enabled&&this.pointerMove(this._getPointer(n))}function mT(n){this.enabled&&(this.domElement.releasePointerCapture(n.pointerId),this.domElement.removeEventListener("pointermove",this._onPointerMove),this.pointerUp(this._getPointer(n)))}function gu(n,e,t){const i=e.intersectObject(n,!0);for(let s=0;s<i.length;s++)if(i[s].object.visible||t)return i[s];return!1}const _l=new Mi,Ft=new k(0,1,0),im=new k(0,0,0),sm=new Pt,gl=new Rn,Ll=new Rn,Hi=new k,rm=new Pt,sa=new k(1,0,0),rr=new k(0,1,0),ra=new k(0,0,1),vl=new k,$o=new k,jo=new k;class _T extends tn{constructor(e){super(),this.isTransformControlsRoot=!0,this.controls=e,this.visible=!1}updateMatrixWorld(e){const t=this.controls;t.object!==void 0&&(t.object.updateMatrixWorld(),t.object.parent===null?console.error("TransformControls: The attached 3D object must be a part of the scene graph."):t.object.parent.matrixWorld.decompose(t._parentPosition,t._parentQuaternion,t._parentScale),t.object.matrixWorld.decompose(t.worldPosition,t.worldQuaternion,t._worldScale),t._parentQuaternionInv.copy(t._parentQuaternion).invert(),t._worldQuaternionInv.copy(t.worldQuaternion).invert()),t.camera.updateMatrixWorld(),t.camera.matrixWorld.decompose(t.cameraPosition,t.cameraQuaternion,t._cameraScale),t.camera.isOrthographicCamera?t.camera.getWorldDirection(t.eye).negate():t.eye.copy(t.cameraPosition).sub(t.worldPosition).normalize(),super.updateMatrixWorld(e)}dispose(){this.traverse(function(e){e.geometry&&e.geometry.dispose(),e.material&&e.material.dispose()})}}class gT extends tn{constructor(){super(),this.isTransformControlsGizmo=!0,this.type="TransformControlsGizmo";const e=new hc({depthTest:!1,depthWrite:!1,fog:!1,toneMapped:!1,transparent:!0}),t=new oo({depthTest:!1,depthWrite:!1,fog:!1,toneMapped:!1,transparent:!0}),i=e.clone();i.opacity=.15;const s=t.clone();s.opacity=.5;const r=e.clone();r.color.setHex(16711680);const o=e.clone();o.color.setHex(65280);const a=e.clone();a.color.setHex(255);const l=e.clone();l.color.setHex(16711680),l.opacity=.5;const c=e.clone();c.color.setHex(65280),c.opacity=.5;const u=e.clone();u.color.setHex(255),u.opacity=.5;const f=e.clone();f.opacity=.25;const d=e.clone();d.color.setHex(16776960),d.opacity=.25;const h=e.clone();h.color.setHex(16776960);const _=e.clone();_.color.setHex(7895160),this.materialLib={xAxis:r,yAxis:o,zAxis:a,active:h,xAxisTransparent:l,yAxisTransparent:c,zAxisTransparent:u,activeTransparent:d};const x=new Nn(0,.04,.1,12);x.translate(0,.05,0);const m=new ln(.08,.08,.08);m.translate(0,.04,0);const p=new rn;p.setAttribute("position",new $t([0,0,0,1,0,0],3));const M=new Nn(.0075,.0075,.5,3);M.translate(0,.25,0);function b(W,q){const j=new cr(W,.0075,3,64,q*Math.PI*2);return j.rotateY(Math.PI/2),j.rotateX(Math.PI/2),j}function v(){const W=new rn;return W.setAttribute("position",new $t([0,0,0,1,1,1],3)),W}const L={X:[[new be(x,r),[.5,0,0],[0,0,-Math.PI/2]],[new be(x,r),[-.5,0,0],[0,0,Math.PI/2]],[new be(M,r),[0,0,0],[0,0,-Math.PI/2]]],Y:[[new be(x,o),[0,.5,0]],[new be(x,o),[0,-.5,0],[Math.PI,0,0]],[new be(M,o)]],Z:[[new be(x,a),[0,0,.5],[Math.PI/2,0,0]],[new be(x,a),[0,0,-.5],[-Math.PI/2,0,0]],[new be(M,a),null,[Math.PI/2,0,0]]],XYZ:[[new be(new Qr(.1,0),f),[0,0,0]]],XY:[[new be(new ln(.15,.15,.01),u),[.15,.15,0]]],YZ:[[new be(new ln(.15,.15,.01),l),[0,.15,.15],[0,Math.PI/2,0]]],XZ:[[new be(new ln(.15,.15,.01),c),[.15,0,.15],[-Math.PI/2,0,0]]]},R={X:[[new be(new Nn(.2,0,.6,4),i),[.3,0,0],[0,0,-Math.PI/2]],[new be(new Nn(.2,0,.6,4),i),[-.3,0,0],[0,0,Math.PI/2]]],Y:[[new be(new Nn(.2,0,.6,4),i),[0,.3,0]],[new be(new Nn(.2,0,.6,4),i),[0,-.3,0],[0,0,Math.PI]]],Z:[[new be(new Nn(.2,0,.6,4),i),[0,0,.3],[Math.PI/2,0,0]],[new be(new Nn(.2,0,.6,4),i),[0,0,-.3],[-Math.PI/2,0,0]]],XYZ:[[new be(new Qr(.2,0),i)]],XY:[[new be(new ln(.2,.2,.01),i),[.15,.15,0]]],YZ:[[new be(new ln(.2,.2,.01),i),[0,.15,.15],[0,Math.PI/2,0]]],XZ:[[new be(new ln(.2,.2,.01),i),[.15,0,.15],[-Math.PI/2,0,0]]]},U={START:[[new be(new Qr(.01,2),s),null,null,null,"helper"]],END:[[new be(new Qr(.01,2),s),null,null,null,"helper"]],DELTA:[[new _i(v(),s),null,null,null,"helper"]],X:[[new _i(p,s),[-1e3,0,0],null,[1e6,1,1],"helper"]],Y:[[new _i(p,s),[0,-1e3,0],[0,0,Math.PI/2],[1e6,1,1],"helper"]],Z:[[new _i(p,s),[0,0,-1e3],[0,-Math.PI/2,0],[1e6,1,1],"helper"]]},N={XYZE:[[new be(b(.5,1),_),null,[0,Math.PI/2,0]]],X:[[new be(b(.5,.5),r)]],Y:[[new be(b(.5,.5),o),null,[0,0,-Math.PI/2]]],Z:[[new be(b(.5,.5),a),null,[0,Math.PI/2,0]]],E:[[new be(b(.75,1),d),null,[0,Math.PI/2,0]]]},T={AXIS:[[new _i(p,s),[-1e3,0,0],null,[1e6,1,1],"helper"]]},E={XYZE:[[new be(new pf(.25,10,8),i)]],X:[[new be(new cr(.5,.1,4,24),i),[0,0,0],[0,-Math.PI/2,-Math.PI/2]]],Y:[[new be(new cr(.5,.1,4,24),i),[0,0,0],[Math.PI/2,0,0]]],Z:[[new be(new cr(.5,.1,4,24),i),[0,0,0],[0,0,-Math.PI/2]]],E:[[new be(new cr(.75,.1,2,24),i)]]},C={X:[[new be(m,r),[.5,0,0],[0,0,-Math.PI/2]],[new be(M,r),[0,0,0],[0,0,-Math.PI/2]],[new be(m,r),[-.5,0,0],[0,0,Math.PI/2]]],Y:[[new be(m,o),[0,.5,0]],[new be(M,o)],[new be(m,o),[0,-.5,0],[0,0,Math.PI]]],Z:[[new be(m,a),[0,0,.5],[Math.PI/2,0,0]],[new be(M,a),[0,0,0],[Math.PI/2,0,0]],[new be(m,a),[0,0,-.5],[-Math.PI/2,0,0]]],XY:[[new be(new ln(.15,.15,.01),u),[.15,.15,0]]],YZ:[[new be(new ln(.15,.15,.01),l),[0,.15,.15],[0,Math.PI/2,0]]],XZ:[[new be(new ln(.15,.15,.01),c),[.15,0,.15],[-Math.PI/2,0,0]]],XYZ:[[new be(new ln(.1,.1,.1),f)]]},B={X:[[new be(new Nn(.2,0,.6,4),i),[.3,0,0],[0,0,-Math.PI/2]],[new be(new Nn(.2,0,.6,4),i),[-.3,0,0],[0,0,Math.PI/2]]],Y:[[new be(new Nn(.2,0,.6,4),i),[0,.3,0]],[new be(new Nn(.2,0,.6,4),i),[0,-.3,0],[0,0,Math.PI]]],Z:[[new be(new Nn(.2,0,.6,4),i),[0,0,.3],[Math.PI/2,0,0]],[new be(new Nn(.2,0,.6,4),i),[0,0,-.3],[-Math.PI/2,0,0]]],XY:[[new be(new ln(.2,.2,.01),i),[.15,.15,0]]],YZ:[[new be(new ln(.2,.2,.01),i),[0,.15,.15],[0,Math.PI/2,0]]],XZ:[[new be(new ln(.2,.2,.01),i),[.15,0,.15],[-Math.PI/2,0,0]]],XYZ:[[new be(new ln(.2,.2,.2),i),[0,0,0]]]},z={X:[[new _i(p,s),[-1e3,0,0],null,[1e6,1,1],"helper"]],Y:[[new _i(p,s),[0,-1e3,0],[0,0,Math.PI/2],[1e6,1,1],"helper"]],Z:[[new _i(p,s),[0,0,-1e3],[0,-Math.PI/2,0],[1e6,1,1],"helper"]]};function X(W){const q=new tn;for(const j in W)for(let K=W[j].length;K--;){const re=W[j][K][0].clone(),ae=W[j][K][1],me=W[j][K][2],xe=W[j][K][3],ge=W[j][K][4];re.name=j,re.tag=ge,ae&&re.position.set(ae[0],ae[1],ae[2]),me&&re.rotation.set(me[0],me[1],me[2]),xe&&re.scale.set(xe[0],xe[1],xe[2]),re.updateMatrix();const Qe=re.geometry.clone();Qe.applyMatrix4(re.matrix),re.geometry=Qe,re.renderOrder=1/0,re.position.set(0,0,0),re.rotation.set(0,0,0),re.scale.set(1,1,1),q.add(re)}return q}this.gizmo={},this.picker={},this.helper={},this.add(this.gizmo.translate=X(L)),this.add(this.gizmo.rotate=X(N)),this.add(this.gizmo.scale=X(C)),this.add(this.picker.translate=X(R)),this.add(this.picker.rotate=X(E)),this.add(this.picker.scale=X(B)),this.add(this.helper.translate=X(U)),this.add(this.helper.rotate=X(T)),this.add(this.helper.scale=X(z)),this.picker.translate.visible=!1,this.picker.rotate.visible=!1,this.picker.scale.visible=!1}updateMatrixWorld(e){const i=(this.mode==="scale"?"local":this.space)==="local"?this.worldQuaternion:Ll;this.gizmo.translate.visible=this.mode==="translate",this.gizmo.rotate.visible=this.mode==="rotate",this.gizmo.scale.visible=this.mode==="scale",this.helper.translate.visible=this.mode==="translate",this.helper.rotate.visible=this.mode==="rotate",this.helper.scale.visible=this.mode==="scale";let s=[];s=s.concat(this.picker[this.mode].children),s=s.concat(this.gizmo[this.mode].children),s=s.concat(this.helper[this.mode].children);for(let r=0;r<s.length;r++){const o=s[r];o.visible=!0,o.rotation.set(0,0,0),o.position.copy(this.worldPosition);let a;if(this.camera.isOrthographicCamera?a=(this.camera.top-this.camera.bottom)/this.camera.zoom:a=this.worldPosition.distanceTo(this.cameraPosition)*Math.min(1.9*Math.tan(Math.PI*this.camera.fov/360)/this.camera.zoom,7),o.scale.set(1,1,1).multiplyScalar(a*this.size/4),o.tag==="helper"){o.visible=!1,o.name==="AXIS"?(o.visible=!!this.axis,this.axis==="X"&&(Zt.setFromEuler(_l.set(0,0,0)),o.quaternion.copy(i).multiply(Zt),Math.abs(Ft.copy(sa).applyQuaternion(i).dot(this.eye))>.9&&(o.visible=!1)),this.axis==="Y"&&(Zt.setFromEuler(_l.set(0,0,Math.PI/2)),o.quaternion.copy(i).multiply(Zt),Math.abs(Ft.copy(rr).applyQuaternion(i).dot(this.eye))>.9&&(o.visible=!1)),this.axis==="Z"&&(Zt.setFromEuler(_l.set(0,Math.PI/2,0)),o.quaternion.copy(i).multiply(Zt),Math.abs(Ft.copy(ra).applyQuaternion(i).dot(this.eye))>.9&&(o.visible=!1)),this.axis==="XYZE"&&(Zt.setFromEuler(_l.set(0,Math.PI/2,0)),Ft.copy(this.rotationAxis),o.quaternion.setFromRotationMatrix(sm.lookAt(im,Ft,rr)),o.quaternion.multiply(Zt),o.visible=this.dragging),this.axis==="E"&&(o.visible=!1)):o.name==="START"?(o.position.copy(this.worldPositionStart),o.visible=this.dragging):o.name==="END"?(o.position.copy(this.worldPosition),o.visible=this.dragging):o.name==="DELTA"?(o.position.copy(this.worldPositionStart),o.quaternion.copy(this.worldQuaternionStart),Fn.set(1e-10,1e-10,1e-10).add(this.worldPositionStart).sub(this.worldPosition).multiplyScalar(-1),Fn.applyQuaternion(this.worldQuaternionStart.clone().invert()),o.scale.copy(Fn),o.visible=this.dragging):(o.quaternion.copy(i),this.dragging?o.position.copy(this.worldPositionStart):o.position.copy(this.worldPosition),this.axis&&(o.visible=this.axis.search(o.name)!==-1));continue}o.quaternion.copy(i),this.mode==="translate"||this.mode==="scale"?(o.name==="X"&&Math.abs(Ft.copy(sa).applyQuaternion(i).dot(this.eye))>.99&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1),o.name==="Y"&&Math.abs(Ft.copy(rr).applyQuaternion(i).dot(this.eye))>.99&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1),o.name==="Z"&&Math.abs(Ft.copy(ra).applyQuaternion(i).dot(this.eye))>.99&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1),o.name==="XY"&&Math.abs(Ft.copy(ra).applyQuaternion(i).dot(this.eye))<.2&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1),o.name==="YZ"&&Math.abs(Ft.copy(sa).applyQuaternion(i).dot(this.eye))<.2&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1),o.name==="XZ"&&Math.abs(Ft.copy(rr).applyQuaternion(i).dot(this.eye))<.2&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1)):this.mode==="rotate"&&(gl.copy(i),Ft.copy(this.eye).applyQuaternion(Zt.copy(i).invert()),o.name.search("E")!==-1&&o.quaternion.setFromRotationMatrix(sm.lookAt(this.eye,im,rr)),o.name==="X"&&(Zt.setFromAxisAngle(sa,Math.atan2(-Ft.y,Ft.z)),Zt.multiplyQuaternions(gl,Zt),o.quaternion.copy(Zt)),o.name==="Y"&&(Zt.setFromAxisAngle(rr,Math.atan2(Ft.x,Ft.z)),Zt.multiplyQuaternions(gl,Zt),o.quaternion.copy(Zt)),o.name==="Z"&&(Zt.setFromAxisAngle(ra,Math.atan2(Ft.y,Ft.x)),Zt.multiplyQuaternions(gl,Zt),o.quaternion.copy(Zt))),o.visible=o.visible&&(o.name.indexOf("X")===-1||this.showX),o.visible=o.visible&&(o.name.indexOf("Y")===-1||this.showY),o.visible=o.visible&&(o.name.indexOf("Z")===-1||this.showZ),o.visible=o.visible&&(o.name.indexOf("E")===-1||this.showX&&this.showY&&this.showZ),o.material._color=o.material._color||o.material.color.clone(),o.material._opacity=o.material._opacity||o.material.opacity,o.material.color.copy(o.material._color),o.material.opacity=o.material._opacity,this.enabled&&this.axis&&(o.name===this.axis?(o.material.color.copy(this.materialLib.active.color),o.material.opacity=1):this.axis.split("").some(function(l){return o.name===l})&&(o.material.color.copy(this.materialLib.active.color),o.material.opacity=1))}super.updateMatrixWorld(e)}}class vT extends be{constructor(){super(new Os(1e5,1e5,2,2),new hc({visible:!1,wireframe:!0,side:Xi,transparent:!0,opacity:.1,toneMapped:!1})),this.isTransformControlsPlane=!0,this.type="TransformControlsPlane"}updateMatrixWorld(e){let t=this.space;switch(this.position.copy(this.worldPosition),this.mode==="scale"&&(t="local"),vl.copy(sa).applyQuaternion(t==="local"?this.worldQuaternion:Ll),$o.copy(rr).applyQuaternion(t==="local"?this.worldQuaternion:Ll),jo.copy(ra).applyQuaternion(t==="local"?this.worldQuaternion:Ll),Ft.copy($o),this.mode){case"translate":case"scale":switch(this.axis){case"X":Ft.copy(this.eye).cross(vl),Hi.copy(vl).cross(Ft);break;case"Y":Ft.copy(this.eye).cross($o),Hi.copy($o).cross(Ft);break;case"Z":Ft.copy(this.eye).cross(jo),Hi.copy(jo).cross(Ft);break;case"XY":Hi.copy(jo);break;case"YZ":Hi.copy(vl);break;case"XZ":Ft.copy(jo),Hi.copy($o);break;case"XYZ":case"E":Hi.set(0,0,0);break}break;default:Hi.set(0,0,0)}Hi.length()===0?this.quaternion.copy(this.cameraQuaternion):(rm.lookAt(Fn.set(0,0,0),Hi,Ft),this.quaternion.setFromRotationMatrix(rm)),super.updateMatrixWorld(e)}}const xT=420;function yT(n,e){const{canvas:t}=n;let i=null,s=0;const r=new co(h=>Ii.send(h),h=>{if(i)return;const _=h;Ms.value=_?.link??null}),o=new co(h=>Ii.send(h),()=>{},h=>Kn(h.message)),a=h=>{e.style.setProperty("transform",`translate(${h.offsetX+16}px, ${h.offsetY+12}px)`),r.push({do:"pick",...n.ray(h)})};t.addEventListener("pointermove",h=>{if(i?.pointer===h.pointerId){e.style.setProperty("transform",`translate(${h.offsetX+16}px, ${h.offsetY+12}px)`),o.push({do:"drag",...n.ray(h)}),h.stopImmediatePropagation();return}h.buttons===0&&h.pointerType!=="touch"&&d.axis===null&&a(h)},{capture:!0}),t.addEventListener("pointerleave",()=>{i||(Ms.value=null)});const l=async h=>{i={pointer:h.pointerId},bl.value=!0,n.controls.enabled=!1,t.setPointerCapture(h.pointerId);const _=await st({do:"grab",...n.ray(h),arm:h.ctrlKey||h.metaKey});if(!_)return c(!1);kh.value||Um(),Ms.value=_.link},c=h=>{i&&(i=null,bl.value=!1,n.controls.enabled=!0,o.settled().then(()=>st({do:"release",cancel:h})).then(ag))};let u;t.addEventListener("pointerdown",h=>{if(s=h.timeStamp,d.axis!==null)return;if(h.pointerType==="touch"){const x=h;u=setTimeout(()=>{l(x)},xT);return}const _=Ms.value!==null&&mn.value?.links[Ms.value]?.joint!==null;h.button===0&&_&&!h.shiftKey&&(h.stopImmediatePropagation(),l(h))},{capture:!0}),t.addEventListener("pointermove",h=>{u&&Math.hypot(h.movementX,h.movementY)>2&&clearTimeout(u)});const f=h=>{clearTimeout(u),i?.pointer===h.pointerId&&c(h.type==="pointercancel")};t.addEventListener("pointerup",f),t.addEventListener("pointercancel",f),addEventListener("keydown",h=>{h.key==="Escape"&&i&&c(!0)}),t.addEventListener("dblclick",()=>{const h=Ms.value===null?null:n.arm.links[Ms.value];!h||performance.now()-s>5e3||(n.controls.target.setFromMatrixPosition(h.matrixWorld),n.controls.update())}),sn(()=>{const h=Ms.value,_=h===null?null:mn.value?.links[h]?.joint??null;n.arm.highlight(h),t.style.setProperty("cursor",bl.value?"grabbing":_!==null&&h!==null?"grab":"default");const x=mn.value?.joints,m=_===null?void 0:x?.[_];if(e.hidden=m===void 0,m&&_!==null){const p=ya(m);e.textContent=`${m.label}  ${uo(ec.value[_]??0,p,Ct.value)} ${Hl(p,Ct.value)}`}});const d=MT(n)}function ag(){const n=Ji.value?.tool;n&&(Lm.value=`Tool at ${n.position.map(e=>`${(1e3*e).toFixed(0)}`).join(", ")} millimetres`)}function MT(n){const e=new tn;n.scene.add(e);const t=new uT(n.camera,n.canvas);t.size=.75,t.attach(e),n.scene.add(t.getHelper());let i="",s=!1;const r=new co(l=>Ii.send(l),l=>{const c=l;c.reached||Kn(c.sentence)},l=>Kn(l.message)),o=()=>{s||n.tool.matrix.decompose(e.position,e.quaternion,new k)};t.addEventListener("dragging-changed",l=>{s=l.value,n.controls.enabled=!s,bl.value=s,s?i=xa("gizmo"):r.settled().then(o).then(ag).then(()=>n.invalidate())}),t.addEventListener("objectChange",()=>{const l=e.quaternion;r.push({do:"tool",position:e.position.toArray(),quaternion:[l.w,l.x,l.y,l.z],gesture:i})}),t.addEventListener("change",()=>n.invalidate()),n.onDraw(()=>{t.camera=n.camera,o()}),addEventListener("keydown",l=>l.key==="Control"&&a(!0)),addEventListener("keyup",l=>l.key==="Control"&&a(!1));const a=l=>{t.setTranslationSnap(l?.01:null),t.setRotationSnap(l?Math.PI/36:null)};return sn(()=>{const l=rt.gizmo.value;t.enabled=l!=="off",t.getHelper().visible=l!=="off",l!=="off"&&t.setMode(l),t.setSpace(rt.local.value?"local":"world"),n.invalidate()}),t}const vu=/[?&]frame=(\d+)x(\d+)/.exec(location.search);let Cn=null;function ST(){const n=Zi(null),e=Zi(null);return Ra(()=>{const t=new cT(n.current);Cn=t,window.pieperViewer=t,yT(t,e.current),ET(t)},[]),w("div",{class:"view",children:[w("canvas",{ref:n,tabIndex:0,"aria-label":"3D view of the arm. Every action is in the panels too; press ? for keys."}),w("div",{ref:e,class:"touch-label",hidden:!0})]})}function ET(n){let e=0,t=null,i="";i0(r=>{r.kind==="pose"?n.arm.move(r.matrices):(t=r,s()),n.invalidate()});const s=()=>{if(!t)return;const r=fs.value?.solutions??[];n.ghosts.move(t,Array.from({length:t.count},(o,a)=>r[a]?.current??!1)),n.invalidate()};sn(()=>{const r=mn.value;if(!r||r.revision===e)return;e=r.revision;const o=i===r.id;i=r.id,n.show(r,o).then(()=>{document.documentElement.dataset.ready="1",vu&&wT(Number(vu[1]),Number(vu[2]))})}),sn(()=>n.setDark(mr.value)),sn(()=>{const r=Ji.value?.matrix;r&&(n.setTool(r),rt.trail.value&&n.path.add([r[0][3],r[1][3],r[2][3]]),n.invalidate())}),sn(()=>{n.path.setWay(Ca.value?.tool??[]),n.invalidate()}),sn(()=>{n.arm.showFrames(rt.frames.value),n.arm.showCollision(rt.collision.value),n.path.showTrail(rt.trail.value),n.path.showOutline(rt.outline.value),n.ghosts.object.visible=rt.ghosts.value&&gr.value?.playing!==!0,n.invalidate()}),sn(()=>{fs.value,s()}),sn(()=>{n.ghosts.point(Qo.value),n.invalidate()})}function bT(n,e){const t=document.createElement("a");t.href=URL.createObjectURL(e),t.download=n,t.click(),setTimeout(()=>URL.revokeObjectURL(t.href),1e4)}async function wT(n,e){if(!Cn)return;const{renderer:t,canvas:i,perspective:s}=Cn;t.setPixelRatio(1),t.setSize(n,e,!1),s.aspect=n/e,s.updateProjectionMatrix(),Cn.fit("home"),t.render(Cn.scene,Cn.camera);const r=document.createElement("canvas");[r.width,r.height]=[n,e];const o=r.getContext("2d"),a=getComputedStyle(document.documentElement),l=o.createRadialGradient(n/2,.35*e,0,n/2,.35*e,.75*Math.max(n,e));l.addColorStop(0,a.getPropertyValue("--bg-1")),l.addColorStop(1,a.getPropertyValue("--bg-2")),o.fillStyle=l,o.fillRect(0,0,n,e),o.drawImage(i,0,0);const c=await new Promise(u=>r.toBlob(u,"image/png"));c&&await fetch("/api/picture",{method:"POST",body:c})}async function Ah(n){if(!Cn)return;const{renderer:e,canvas:t}=Cn,i=e.getPixelRatio();e.setPixelRatio(n),e.render(Cn.scene,Cn.camera);const s=await new Promise(r=>t.toBlob(r,"image/png"));e.setPixelRatio(i),Cn.invalidate(),s?bT(`${mn.value?.id??"arm"}.png`,s):Kn("The picture could not be made")}const TT=new co(n=>Ii.send(n),()=>{},n=>Kn(n.message));function AT(n){const t=[n.shoulder,n.elbow&&`elbow ${n.elbow}`,n.wrist].filter(i=>typeof i=="string");return t.length>0?t:[n.branch]}function RT({family:n,index:e}){const t=Zi("");return w("div",{class:"family",children:[w("p",{children:[w("strong",{children:"Infinitely many."})," ",n.name,"."]}),w("input",{type:"range",min:0,max:1,step:1/96,value:n.at,"aria-label":`Family ${e+1}: ${n.name}`,onPointerDown:()=>t.current=xa("family"),onKeyDown:i=>{i.repeat||(t.current=xa("family")),i.stopPropagation()},onInput:i=>TT.push({do:"family",index:e,at:Number(i.currentTarget.value),gesture:t.current})})]})}function CT(){const n=fs.value,e=Ji.value?.unlocked??!1;if(!n)return null;if(n.status==="playing")return w("p",{class:"quiet",children:"The list is made when the motion stands."});const t=n.solutions.length,i={solved:`${t} solution${t===1?"":"s"} for this pose`,singular:`A singular pose: ${n.families.length===1?"a family":`${n.families.length} families`}${t>0?` and ${t} more`:""}`,redundant:"More joints than the pose needs",unreachable:"No solution",none:"No solver takes this arm",playing:""}[n.status];return w("section",{"aria-label":"IK solutions",children:[w("div",{class:"row spread",children:[w("strong",{children:i}),w("label",{class:"check",children:[w("input",{type:"checkbox",checked:rt.ghosts.value,onChange:s=>{rt.ghosts.value=s.currentTarget.checked,st({do:"ghosts",on:rt.ghosts.value})}})," Ghosts"]})]}),n.missed&&w("p",{class:"banner",children:[w(yi,{name:"warn"})," The pose asked for cannot be reached: ",n.reason??"every solution lies outside the limits",". The arm stands at the nearest."]}),n.families.map((s,r)=>w(RT,{family:s,index:r},r)),w("ol",{class:"solutions",children:n.solutions.map((s,r)=>{const o=!s.within_limits&&!e;return w("li",{children:w("button",{type:"button",class:`solution ${s.current?"current":""}`,"aria-current":s.current,disabled:o,onMouseEnter:()=>Qo.value=r,onMouseLeave:()=>Qo.value=null,onFocus:()=>Qo.value=r,onBlur:()=>Qo.value=null,onClick:()=>{st({do:"solution",index:r})},children:[w("span",{class:"number-of",children:r+1}),w("span",{class:"flags",children:[AT(s).map(a=>w("span",{class:"flag",children:a},a)),s.multiplicity>1&&w("span",{class:"flag",children:["×",s.multiplicity]})]}),w("span",{class:"details",children:[s.current?w("span",{class:"here",children:[w(yi,{name:"check"})," here"]}):w("span",{children:[(s.distance*180/Math.PI).toFixed(0),"° away"]}),o&&w("span",{class:"outside",children:[w(yi,{name:"lock"})," outside limits"]}),w("span",{class:"residual",title:"What forward kinematics misses the pose by",children:Bm(s.residual)})]})]})},r)})}),n.microseconds!==void 0&&w("p",{class:"quiet small",children:["Solved by ",w("em",{children:n.solver})," in ",n.microseconds.toFixed(1)," µs. ",w("kbd",{children:"["})," ",w("kbd",{children:"]"})," step through."]})]})}function om(n){const e=fs.value?.solutions??[],t=Ji.value?.unlocked??!1,i=Math.max(0,e.findIndex(s=>s.current));for(let s=1;s<=e.length;s++){const r=(i+n*s+e.length*s)%e.length;if(e[r].within_limits||t)return void st({do:"solution",index:r})}}async function PT(n){const e=zl.value.find(s=>s.id===n.value),t={};for(const s of e?.needs??[]){const r=prompt(`${e.name}: the length ${s}, as in 0.3 or 250 mm`,"0.3");if(r===null){n.value=mn.value?.id??"";return}t[s]=r}await st({do:"load",robot:n.value,values:t})===void 0&&(n.value=mn.value?.id??"")}async function DT(n){const e=await n.text();n.name.endsWith(".json")?await st({do:"open",text:e}):await st({do:"load",file:{name:n.name,text:e}})}function LT(){const{undo:n,redo:e}=Cm.value,t=zl.value.some(r=>r.id===mn.value?.id),i={system:"light",light:"dark",dark:"system"},s=Dm.value;return Eo?w(IT,{}):w("header",{class:"top",children:[w("span",{class:"brand",children:[w("svg",{viewBox:"0 0 32 32","aria-hidden":"true",children:[w("path",{d:"M9 25h14M12 25l-1-9 9-6 4 4"}),w("circle",{cx:"11",cy:"16",r:"2.6"}),w("circle",{cx:"20",cy:"10",r:"2.6"})]}),w("span",{children:"pieper"})]}),w("div",{class:"picker",children:[w("select",{"aria-label":"Robot",value:mn.value?.id??"",onChange:r=>{PT(r.currentTarget)},children:[!t&&mn.value&&w("option",{value:mn.value.id,children:mn.value.name}),zl.value.map(r=>w("option",{value:r.id,children:r.name},r.id))]}),w(yi,{name:"down"})]}),w("label",{class:"icon-button",title:"Open a robot (.toml, .urdf) or a project (.json)",children:[w(yi,{name:"upload"}),w("span",{class:"visually-hidden",children:"Open a robot or project file"}),w("input",{type:"file",class:"visually-hidden",accept:".toml,.urdf,.xml,.json",onChange:r=>{const o=r.currentTarget.files?.[0];o&&DT(o),r.currentTarget.value=""}})]}),w("span",{class:"group",children:[w(bt,{icon:"undo",label:n?`Undo: ${n}`:"Nothing to undo",keys:"Ctrl+Z",disabled:!n,onClick:()=>{st({do:"undo"})}}),w(bt,{icon:"redo",label:e?`Redo: ${e}`:"Nothing to redo",keys:"Ctrl+Shift+Z",disabled:!e,onClick:()=>{st({do:"redo"})}})]}),w("span",{class:"grow"}),w("span",{class:"group wide",children:[w(bt,{icon:"move",label:"Move the tool by a gizmo",keys:"W",pressed:rt.gizmo.value==="translate",onClick:()=>rt.gizmo.value=rt.gizmo.value==="translate"?"off":"translate"}),w(bt,{icon:"rotate",label:"Turn the tool by a gizmo",keys:"E",pressed:rt.gizmo.value==="rotate",onClick:()=>rt.gizmo.value=rt.gizmo.value==="rotate"?"off":"rotate"})]}),w("span",{class:"group wide",children:[w(bt,{icon:"ghost",label:"Ghosts of all solutions",keys:"G",pressed:rt.ghosts.value,onClick:xf}),w(bt,{icon:"axes",label:"Link frames",keys:"T",pressed:rt.frames.value,onClick:()=>rt.frames.value=!rt.frames.value}),w(bt,{icon:"trail",label:"The tool's way",pressed:rt.trail.value,onClick:()=>rt.trail.value=!rt.trail.value}),w(bt,{icon:"reach",label:"Outline of the reach",keys:"O",pressed:rt.outline.value,onClick:()=>rt.outline.value=!rt.outline.value})]}),w("span",{class:"group",children:[w("button",{type:"button",class:"text-button",title:"Units (U)","aria-label":`Units: ${Ct.value.angle} and ${Ct.value.length}`,onClick:yf,children:[Ct.value.angle==="deg"?"°":"rad"," · ",Ct.value.length]}),w(bt,{icon:"download",label:"Share: this view as one file that needs no program",onClick:()=>location.assign("/api/share.html")}),w(bt,{icon:"camera",label:"Snapshot as PNG",keys:"P",onClick:()=>{Ah(2)}}),w(bt,{icon:oi.value==="system"?"auto":oi.value==="light"?"sun":"moon",label:`Theme: ${oi.value}`,onClick:()=>{oi.value=i[oi.value],va("theme",oi.value)}}),w(bt,{icon:"help",label:"Keys and gestures",keys:"?",onClick:()=>Bs.value="help"}),w(bt,{icon:"panel",label:"Side panel",pressed:Us.value,onClick:()=>Us.value=!Us.value})]}),w("span",{class:`connection ${to.value}`,role:"status",title:"Time for a message to the program and back",children:[w("span",{class:"dot","aria-hidden":"true"}),to.value==="open"?s===null?"connected":`${s.toFixed(1)} ms`:to.value]})]})}function IT(){const n={system:"light",light:"dark",dark:"system"};return w("header",{class:"top",children:[w("span",{class:"brand",children:w("span",{children:mn.value?.name})}),w("span",{class:"quiet small",children:"shared from pieper studio"}),w("span",{class:"grow"}),w("span",{class:"group",children:[w(bt,{icon:"ghost",label:"Ghosts of all solutions",keys:"G",pressed:rt.ghosts.value,onClick:xf}),w(bt,{icon:"axes",label:"Link frames",keys:"T",pressed:rt.frames.value,onClick:()=>rt.frames.value=!rt.frames.value}),w(bt,{icon:"reach",label:"Outline of the reach",keys:"O",pressed:rt.outline.value,onClick:()=>rt.outline.value=!rt.outline.value})]}),w("span",{class:"group",children:[w("button",{type:"button",class:"text-button",title:"Units (U)",onClick:yf,children:[Ct.value.angle==="deg"?"°":"rad"," · ",Ct.value.length]}),w(bt,{icon:oi.value==="system"?"auto":oi.value==="light"?"sun":"moon",label:`Theme: ${oi.value}`,onClick:()=>oi.value=n[oi.value]}),w(bt,{icon:"panel",label:"Side panel",pressed:Us.value,onClick:()=>Us.value=!Us.value})]})]})}function xf(){rt.ghosts.value=!rt.ghosts.value,st({do:"ghosts",on:rt.ghosts.value})}function yf(){const{angle:n,length:e}=Ct.value;Ct.value=n==="deg"&&e==="mm"?{angle:"rad",length:"m"}:{angle:"deg",length:"mm"},va("angle",Ct.value.angle),va("length",Ct.value.length),Kn(`Shown in ${Ct.value.angle==="deg"?"degrees":"radians"} and ${Ct.value.length==="mm"?"millimetres":"metres"}`,"note")}const xl=n=>()=>{n.value=!n.value},am=n=>()=>{rt.gizmo.value=rt.gizmo.value===n?"off":n},Zl=[{name:"Fit the arm",keys:"F",run:()=>Cn?.fit("here")},{name:"Recentre the view",keys:"V",run:()=>Cn?.fit("home")},{name:"Front view",keys:"1",run:()=>Cn?.fit("front")},{name:"Right view",keys:"3",run:()=>Cn?.fit("right")},{name:"Top view",keys:"7",run:()=>Cn?.fit("top")},{name:"Parallel or central projection",keys:"5",run:()=>Cn?.toggleProjection()},{name:"Home posture",keys:"H",run:()=>{st({do:"named",to:"home"})}},{name:"Zero posture",keys:"0",run:()=>{st({do:"named",to:"zero"})}},{name:"Random posture",keys:"",run:()=>{st({do:"named",to:"random"})}},{name:"Play or pause",keys:"Space",run:R_},{name:"Add a keyframe",keys:"K",run:A_},{name:"Ghosts of all solutions",keys:"G",run:xf},{name:"Next solution",keys:"]",run:()=>om(1)},{name:"Previous solution",keys:"[",run:()=>om(-1)},{name:"Link frames",keys:"T",run:xl(rt.frames)},{name:"Collision shapes",keys:"C",run:xl(rt.collision)},{name:"Outline of the reach",keys:"O",run:xl(rt.outline)},{name:"Move the tool by a gizmo",keys:"W",run:am("translate")},{name:"Turn the tool by a gizmo",keys:"E",run:am("rotate")},{name:"Gizmo in the tool’s or the base’s axes",keys:"X",run:xl(rt.local)},{name:"Snapshot",keys:"P",run:()=>{Ah(2)}},{name:"Snapshot at four times the size",keys:"",run:()=>{Ah(4)}},{name:"Share this view as one file",keys:"",run:()=>location.assign("/api/share.html")},{name:"Units",keys:"U",run:yf},{name:"Plots",keys:"",run:()=>Ps.value=Ps.value==="plots"?null:"plots"},{name:"Formulas",keys:"",run:()=>Ps.value=Ps.value==="formulas"?null:"formulas"},{name:"Script",keys:"",run:()=>Ps.value=Ps.value==="script"?null:"script"},{name:"Stop the script",keys:"",run:Fu},{name:"Undo",keys:"Ctrl+Z",run:()=>{st({do:"undo"})}},{name:"Redo",keys:"Ctrl+Shift+Z",run:()=>{st({do:"redo"})}},{name:"Save the project",keys:"Ctrl+S",run:()=>location.assign("/api/project.json?download")},{name:"All commands",keys:"Ctrl+K",run:()=>Bs.value="palette"},{name:"Keys and gestures",keys:"?",run:()=>Bs.value="help"}];function UT(){addEventListener("keydown",n=>{const e=n.target instanceof HTMLElement&&n.target.closest("input:not([type=range]):not([type=checkbox]), textarea, select, .cm-editor, dialog");if(n.ctrlKey||n.metaKey){const s=`Ctrl+${n.shiftKey?"Shift+":""}${n.key.toUpperCase()}`,r=Zl.find(o=>o.keys===s);return!r||e&&s!=="Ctrl+K"?void 0:(n.preventDefault(),r.run())}if(e||n.altKey||!El.value||Bs.value)return;const t=n.key===" "?"Space":n.key.length===1?n.key.toUpperCase():"";if(t==="Space"&&n.target instanceof HTMLElement&&n.target.closest("button, input"))return;const i=Zl.find(s=>s.keys===t);!i||t===""||(n.preventDefault(),i.run())})}function lg({title:n,children:e}){const t=Zi(null);return Bg(()=>t.current?.showModal(),[]),w("dialog",{ref:t,"aria-label":n,onClose:()=>Bs.value=null,onClick:i=>{i.target===t.current&&t.current?.close()},children:w("div",{class:"dialog-body",children:[w("div",{class:"row spread",children:[w("h2",{children:n}),w(bt,{icon:"close",label:"Close",onClick:()=>t.current?.close()})]}),e]})})}const NT=[["Drag a link","turn its joint"],["Ctrl + drag a link","the whole arm follows"],["Drag empty space","turn the view"],["Right or Shift + drag","shift the view"],["Wheel, pinch","zoom to the pointer"],["Double-click a link","turn about it"],["Esc while dragging","back to where it began"],["Touch: hold, then drag","take hold of a link"]];function FT(){return w(lg,{title:"Keys and gestures",children:[w("div",{class:"sheet",children:[w("dl",{children:NT.map(([n,e])=>w(ci,{children:[w("dt",{children:n},n),w("dd",{children:e})]}))}),w("dl",{children:Zl.filter(n=>n.keys).map(n=>w(ci,{children:[w("dt",{children:w("kbd",{children:n.keys})},n.name),w("dd",{children:n.name})]}))})]}),w("label",{class:"check",children:[w("input",{type:"checkbox",checked:El.value,onChange:n=>{El.value=n.currentTarget.checked,va("letters",El.value?"on":"off")}})," Single letters act as keys"]})]})}function OT(){const[n,e]=lo(""),[t,i]=lo(0),s=Zl.filter(o=>o.name.toLowerCase().includes(n.toLowerCase())),r=o=>{Bs.value=null,s[o]?.run()};return w(lg,{title:"Commands",children:[w("input",{class:"search",type:"text",role:"combobox","aria-expanded":"true","aria-controls":"palette-list","aria-label":"Search commands",placeholder:"Search commands",value:n,autofocus:!0,onInput:o=>{e(o.currentTarget.value),i(0)},onKeyDown:o=>{(o.key==="ArrowDown"||o.key==="ArrowUp")&&(o.preventDefault(),i((t+(o.key==="ArrowDown"?1:s.length-1))%Math.max(1,s.length))),o.key==="Enter"&&r(t)}}),w("ul",{class:"palette",id:"palette-list",role:"listbox","aria-label":"Commands",children:s.map((o,a)=>w("li",{role:"option","aria-selected":a===t,onClick:()=>r(a),children:[w("span",{children:o.name}),o.keys&&w("kbd",{children:o.keys})]},o.name))})]})}function kT(){return w(ci,{children:[Bs.value==="help"&&w(FT,{}),Bs.value==="palette"&&w(OT,{}),to.value==="lost"&&w("div",{class:"notice",role:"alert",children:[w(yi,{name:"warn"})," The connection to the program is lost. Trying again…"]}),to.value==="refused"&&w("div",{class:"notice",role:"alert",children:[w(yi,{name:"warn"})," ",Pm.value]}),w("div",{class:"toasts",children:Jo.value.map(n=>w("div",{class:`toast ${n.kind}`,role:n.kind==="error"?"alert":"status",children:n.text},n.id))}),!kh.value&&w("div",{class:"hint",role:"note",children:[w("p",{children:[w("strong",{children:"Drag a link"})," to turn its joint."]}),w("p",{children:[w("strong",{children:"Ctrl + drag"})," pulls the whole arm."]}),w("p",{children:[w("strong",{children:"?"})," shows every key and gesture."]}),w("button",{type:"button",class:"link",onClick:Um,children:"Got it"})]}),w("div",{class:"visually-hidden","aria-live":"polite",children:Lm.value})]})}const BT={theta:"θ",alpha:"α",d:"d",a:"a"};function zT(){const n=mn.value;return n?w("section",{"aria-label":"Robot",children:[w("h2",{children:n.name}),n.summary&&w("p",{class:"quiet",children:n.summary}),n.problems.map(e=>w("p",{class:"banner",children:[w(yi,{name:"warn"})," ",e]},e)),n.table&&w("div",{class:"scroll",children:w("table",{class:"dh",children:[w("caption",{children:[n.table.convention==="standard"?"Standard":"Modified"," Denavit-Hartenberg"]}),w("thead",{children:w("tr",{children:[w("th",{scope:"col",children:"#"}),n.table.columns.map(e=>w("th",{scope:"col",children:BT[e]??e},e))]})}),w("tbody",{children:n.table.rows.map((e,t)=>w("tr",{children:[w("th",{scope:"row",children:t+1}),e.map((i,s)=>w("td",{children:i},s))]},t))})]})}),n.parameters.length>0&&w("dl",{class:"facts",children:n.parameters.map(([e,t])=>w(ci,{children:[w("dt",{children:e},e),w("dd",{children:t??"?"})]}))}),w("dl",{class:"facts",children:n.facts.map(([e,t])=>w(ci,{children:[w("dt",{children:e},e),w("dd",{children:t})]}))}),n.source&&w("p",{class:"quiet small",children:n.source})]}):null}const Zo=[["joints","Joints"],["tool","Tool"],["ik","Solutions"],["robot","Robot"]];function HT(){const n=Tc.value,e=(fs.value?.solutions.length??0)+(fs.value?.families.length??0);return w("aside",{class:"panel","aria-label":"Control panel",children:[w("div",{class:"tabs",role:"tablist","aria-label":"Control panel",onKeyDown:i=>{const s={ArrowRight:1,ArrowLeft:3}[i.key];if(s===void 0)return;const r=(Zo.findIndex(([o])=>o===n)+s)%Zo.length;Tc.value=Zo[r][0],document.getElementById(`tab-${Zo[r][0]}`)?.focus()},children:Zo.map(([i,s])=>w("button",{type:"button",id:`tab-${i}`,role:"tab","aria-selected":n===i,"aria-controls":"panel-body",tabIndex:n===i?0:-1,onClick:()=>Tc.value=i,children:[s,i==="ik"&&e>0&&w("span",{class:"badge",children:e})]},i))}),w("div",{class:"panel-body",id:"panel-body",role:"tabpanel","aria-labelledby":`tab-${n}`,tabIndex:0,children:[w("fieldset",{class:"bare",disabled:Eo,children:[n==="joints"&&w(Ex,{}),n==="tool"&&w(h0,{}),n==="ik"&&w(CT,{})]}),n==="robot"&&w(zT,{})]}),w(VT,{})]})}function VT(){const n=Ji.value?.tool;return n?w("dl",{class:"readout","aria-label":"Tool position",children:[["X","Y","Z"].map((e,t)=>w("div",{children:[w("dt",{class:`axis axis-${e.toLowerCase()}`,children:e}),w("dd",{children:uo(n.position[t],"length",Ct.value)})]},e)),w("div",{children:w("dt",{children:Ct.value.length})})]}):null}function GT(){return Ra(()=>sn(()=>{document.documentElement.dataset.theme=mr.value?"dark":"light"}),[]),w("div",{class:`app ${Us.value?"":"no-panel"}`,children:[w(LT,{}),w("main",{class:"stage","aria-label":"3D view",children:w(ST,{})}),Us.value&&w(HT,{}),w(_x,{}),w(kT,{})]})}Ng(w(GT,{}),document.getElementById("app"));UT();window.pieperConnection=Ii;Ii.open();
