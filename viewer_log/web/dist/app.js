var Cr={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},Pr={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},Vg=0,Vf=1,Gg=2;var no=1,Wg=2,da=3,Ls=0,bi=1,ci=2,io=0,fa=1,Gf=2,Wf=3,Xf=4,Xg=5;var so=100,qg=101,Yg=102,jg=103,Zg=104,$g=200,Jg=201,Kg=202,Qg=203,qf=204,Yf=205,t0=206,e0=207,n0=208,i0=209,s0=210,r0=211,o0=212,a0=213,l0=214,eh=0,nh=1,ih=2,jo=3,sh=4,rh=5,oh=6,ah=7,Il=0,c0=1,h0=2,Ji=0,jf=1,Zf=2,$f=3,Ll=4,Jf=5,Kf=6,Qf=7,Af="attached",u0="detached",tp=300,ro=301,pa=302,Ah=303,Rh=304,ds=1e3,_i=1001,lh=1002,Zn=1003,d0=1004;var Nl=1005;var jn=1006,Ch=1007;var Ki=1008;var Ri=1009,ep=1010,np=1011,ma=1012,Ph=1013,ms=1014,Bi=1015,gs=1016,Ih=1017,Lh=1018,oo=1020,ip=35902,sp=35899,rp=1021,op=1022,Qi=1023,$s=1026,rr=1027,Nh=1028,Dh=1029,Ir=1030,Uh=1031;var Fh=1033,Dl=33776,Ul=33777,Fl=33778,kl=33779,kh=35840,Oh=35841,Bh=35842,zh=35843,Hh=36196,Vh=37492,Gh=37496,Wh=37488,Xh=37489,Ol=37490,qh=37491,Yh=37808,jh=37809,Zh=37810,$h=37811,Jh=37812,Kh=37813,Qh=37814,tu=37815,eu=37816,nu=37817,iu=37818,su=37819,ru=37820,ou=37821,au=36492,lu=36494,cu=36495,hu=36283,uu=36284,Bl=36285,du=36286;var Xr=2300,ch=2301,Qc=2302,sl=2303,Rf=2400,Cf=2401,Pf=2402,f0=2500;var p0=3200;var ga=0,m0=1,or="",Pe="srgb",rl="srgb-linear",ol="linear",Ne="srgb";var th=7680;var g0=519,x0=512,_0=513,y0=514,ap=515,b0=516,v0=517,lp=518,cp=519,w0=35044;var hp="300 es",Yi=2e3,Zo=2001;function ab(s){for(let t=s.length-1;t>=0;--t)if(s[t]>=65535)return!0;return!1}function lb(s){return ArrayBuffer.isView(s)&&!(s instanceof DataView)}function $o(s){return document.createElementNS("http://www.w3.org/1999/xhtml",s)}function S0(){let s=$o("canvas");return s.style.display="block",s}var Jm={},Jo=null;function up(...s){let t="THREE."+s.shift();Jo?Jo("log",t,...s):console.log(t,...s)}function M0(s){let t=s[0];if(typeof t=="string"&&t.startsWith("TSL:")){let e=s[1];e&&e.isStackTrace?s[0]+=" "+e.getLocation():s[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return s}function Zt(...s){s=M0(s);let t="THREE."+s.shift();if(Jo)Jo("warn",t,...s);else{let e=s[0];e&&e.isStackTrace?console.warn(e.getError(t)):console.warn(t,...s)}}function te(...s){s=M0(s);let t="THREE."+s.shift();if(Jo)Jo("error",t,...s);else{let e=s[0];e&&e.isStackTrace?console.error(e.getError(t)):console.error(t,...s)}}function nl(...s){let t=s.join(" ");t in Jm||(Jm[t]=!0,Zt(...s))}function E0(s,t,e){return new Promise(function(n,i){function r(){switch(s.clientWaitSync(t,s.SYNC_FLUSH_COMMANDS_BIT,0)){case s.WAIT_FAILED:i();break;case s.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:n()}}setTimeout(r,e)})}var T0={[eh]:eh,[ih]:oh,[sh]:sh,[jo]:rh,[nh]:nh,[oh]:ih,[ah]:ah,[rh]:jo},fs=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[t]===void 0&&(n[t]=[]),n[t].indexOf(e)===-1&&n[t].push(e)}hasEventListener(t,e){let n=this._listeners;return n===void 0?!1:n[t]!==void 0&&n[t].indexOf(e)!==-1}removeEventListener(t,e){let n=this._listeners;if(n===void 0)return;let i=n[t];if(i!==void 0){let r=i.indexOf(e);r!==-1&&i.splice(r,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let n=e[t.type];if(n!==void 0){t.target=this;let i=n.slice(0);for(let r=0,o=i.length;r<o;r++)i[r].call(this,t);t.target=null}}},ii=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],Km=1234567,Xo=Math.PI/180,qr=180/Math.PI;function Lr(){let s=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(ii[s&255]+ii[s>>8&255]+ii[s>>16&255]+ii[s>>24&255]+"-"+ii[t&255]+ii[t>>8&255]+"-"+ii[t>>16&15|64]+ii[t>>24&255]+"-"+ii[e&63|128]+ii[e>>8&255]+"-"+ii[e>>16&255]+ii[e>>24&255]+ii[n&255]+ii[n>>8&255]+ii[n>>16&255]+ii[n>>24&255]).toLowerCase()}function _e(s,t,e){return Math.max(t,Math.min(e,s))}function dp(s,t){return(s%t+t)%t}function cb(s,t,e,n,i){return n+(s-t)*(i-n)/(e-t)}function hb(s,t,e){return s!==t?(e-s)/(t-s):0}function il(s,t,e){return(1-e)*s+e*t}function ub(s,t,e,n){return il(s,t,1-Math.exp(-e*n))}function db(s,t=1){return t-Math.abs(dp(s,t*2)-t)}function fb(s,t,e){return s<=t?0:s>=e?1:(s=(s-t)/(e-t),s*s*(3-2*s))}function pb(s,t,e){return s<=t?0:s>=e?1:(s=(s-t)/(e-t),s*s*s*(s*(s*6-15)+10))}function mb(s,t){return s+Math.floor(Math.random()*(t-s+1))}function gb(s,t){return s+Math.random()*(t-s)}function xb(s){return s*(.5-Math.random())}function _b(s){s!==void 0&&(Km=s);let t=Km+=1831565813;return t=Math.imul(t^t>>>15,t|1),t^=t+Math.imul(t^t>>>7,t|61),((t^t>>>14)>>>0)/4294967296}function yb(s){return s*Xo}function bb(s){return s*qr}function vb(s){return s>0&&Number.isInteger(s)&&2**Math.round(Math.log2(s))===s}function wb(s){return Math.pow(2,Math.ceil(Math.log(s)/Math.LN2))}function fp(s){return Math.pow(2,Math.floor(Math.log(s)/Math.LN2))}function Sb(s,t,e,n,i){let r=Math.cos,o=Math.sin,a=r(e/2),c=o(e/2),l=r((t+n)/2),h=o((t+n)/2),u=r((t-n)/2),d=o((t-n)/2),f=r((n-t)/2),g=o((n-t)/2);switch(i){case"XYX":s.set(a*h,c*u,c*d,a*l);break;case"YZY":s.set(c*d,a*h,c*u,a*l);break;case"ZXZ":s.set(c*u,c*d,a*h,a*l);break;case"XZX":s.set(a*h,c*g,c*f,a*l);break;case"YXY":s.set(c*f,a*h,c*g,a*l);break;case"ZYZ":s.set(c*g,c*f,a*h,a*l);break;default:Zt("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+i)}}function pp(s){switch(s.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function A0(s,t){if(t.constructor===Float32Array)return s;let e=pp(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(s/e,-1)}function R0(s,t){if(t.constructor===Float32Array)return s;let e=pp(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(s*e)}var vi={DEG2RAD:Xo,RAD2DEG:qr,generateUUID:Lr,clamp:_e,euclideanModulo:dp,mapLinear:cb,inverseLerp:hb,lerp:il,damp:ub,pingpong:db,smoothstep:fb,smootherstep:pb,randInt:mb,randFloat:gb,randFloatSpread:xb,seededRandom:_b,degToRad:yb,radToDeg:bb,isPowerOfTwo:vb,ceilPowerOfTwo:wb,floorPowerOfTwo:fp,setQuaternionFromProperEuler:Sb,normalize:R0,denormalize:A0},Vt=class{static{this.prototype.isVector2=!0}constructor(t=0,e=0){this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("THREE.Vector2: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,n=this.y,i=t.elements;return this.x=i[0]*e+i[3]*n+i[6],this.y=i[1]*e+i[4]*n+i[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=_e(this.x,t.x,e.x),this.y=_e(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=_e(this.x,t,e),this.y=_e(this.y,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(_e(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let n=this.dot(t)/e;return Math.acos(_e(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,n=this.y-t.y;return e*e+n*n}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let n=Math.cos(e),i=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*n-o*i+t.x,this.y=r*i+o*n+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},ve=class{constructor(t=0,e=0,n=0,i=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=n,this._w=i}static slerpFlat(t,e,n,i,r,o,a){let c=n[i+0],l=n[i+1],h=n[i+2],u=n[i+3],d=r[o+0],f=r[o+1],g=r[o+2],y=r[o+3];if(u!==y||c!==d||l!==f||h!==g){let p=c*d+l*f+h*g+u*y;p<0&&(d=-d,f=-f,g=-g,y=-y,p=-p);let m=1-a;if(p<.9995){let x=Math.acos(p),v=Math.sin(x);m=Math.sin(m*x)/v,a=Math.sin(a*x)/v,c=c*m+d*a,l=l*m+f*a,h=h*m+g*a,u=u*m+y*a}else{c=c*m+d*a,l=l*m+f*a,h=h*m+g*a,u=u*m+y*a;let x=1/Math.sqrt(c*c+l*l+h*h+u*u);c*=x,l*=x,h*=x,u*=x}}t[e]=c,t[e+1]=l,t[e+2]=h,t[e+3]=u}static multiplyQuaternionsFlat(t,e,n,i,r,o){let a=n[i],c=n[i+1],l=n[i+2],h=n[i+3],u=r[o],d=r[o+1],f=r[o+2],g=r[o+3];return t[e]=a*g+h*u+c*f-l*d,t[e+1]=c*g+h*d+l*u-a*f,t[e+2]=l*g+h*f+a*d-c*u,t[e+3]=h*g-a*u-c*d-l*f,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,n,i){return this._x=t,this._y=e,this._z=n,this._w=i,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let n=t._x,i=t._y,r=t._z,o=t._order,a=Math.cos,c=Math.sin,l=a(n/2),h=a(i/2),u=a(r/2),d=c(n/2),f=c(i/2),g=c(r/2);switch(o){case"XYZ":this._x=d*h*u+l*f*g,this._y=l*f*u-d*h*g,this._z=l*h*g+d*f*u,this._w=l*h*u-d*f*g;break;case"YXZ":this._x=d*h*u+l*f*g,this._y=l*f*u-d*h*g,this._z=l*h*g-d*f*u,this._w=l*h*u+d*f*g;break;case"ZXY":this._x=d*h*u-l*f*g,this._y=l*f*u+d*h*g,this._z=l*h*g+d*f*u,this._w=l*h*u-d*f*g;break;case"ZYX":this._x=d*h*u-l*f*g,this._y=l*f*u+d*h*g,this._z=l*h*g-d*f*u,this._w=l*h*u+d*f*g;break;case"YZX":this._x=d*h*u+l*f*g,this._y=l*f*u+d*h*g,this._z=l*h*g-d*f*u,this._w=l*h*u-d*f*g;break;case"XZY":this._x=d*h*u-l*f*g,this._y=l*f*u-d*h*g,this._z=l*h*g+d*f*u,this._w=l*h*u+d*f*g;break;default:Zt("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let n=e/2,i=Math.sin(n);return this._x=t.x*i,this._y=t.y*i,this._z=t.z*i,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,n=e[0],i=e[4],r=e[8],o=e[1],a=e[5],c=e[9],l=e[2],h=e[6],u=e[10],d=n+a+u;if(d>0){let f=.5/Math.sqrt(d+1);this._w=.25/f,this._x=(h-c)*f,this._y=(r-l)*f,this._z=(o-i)*f}else if(n>a&&n>u){let f=2*Math.sqrt(1+n-a-u);this._w=(h-c)/f,this._x=.25*f,this._y=(i+o)/f,this._z=(r+l)/f}else if(a>u){let f=2*Math.sqrt(1+a-n-u);this._w=(r-l)/f,this._x=(i+o)/f,this._y=.25*f,this._z=(c+h)/f}else{let f=2*Math.sqrt(1+u-n-a);this._w=(o-i)/f,this._x=(r+l)/f,this._y=(c+h)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let n=t.dot(e)+1;return n<1e-8?(n=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=n):(this._x=0,this._y=-t.z,this._z=t.y,this._w=n)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=n),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(_e(this.dot(t),-1,1)))}rotateTowards(t,e){let n=this.angleTo(t);if(n===0)return this;let i=Math.min(1,e/n);return this.slerp(t,i),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let n=t._x,i=t._y,r=t._z,o=t._w,a=e._x,c=e._y,l=e._z,h=e._w;return this._x=n*h+o*a+i*l-r*c,this._y=i*h+o*c+r*a-n*l,this._z=r*h+o*l+n*c-i*a,this._w=o*h-n*a-i*c-r*l,this._onChangeCallback(),this}slerp(t,e){let n=t._x,i=t._y,r=t._z,o=t._w,a=this.dot(t);a<0&&(n=-n,i=-i,r=-r,o=-o,a=-a);let c=1-e;if(a<.9995){let l=Math.acos(a),h=Math.sin(l);c=Math.sin(c*l)/h,e=Math.sin(e*l)/h,this._x=this._x*c+n*e,this._y=this._y*c+i*e,this._z=this._z*c+r*e,this._w=this._w*c+o*e,this._onChangeCallback()}else this._x=this._x*c+n*e,this._y=this._y*c+i*e,this._z=this._z*c+r*e,this._w=this._w*c+o*e,this.normalize();return this}slerpQuaternions(t,e,n){return this.copy(t).slerp(e,n)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),n=Math.random(),i=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(i*Math.sin(t),i*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},F=class{static{this.prototype.isVector3=!0}constructor(t=0,e=0,n=0){this.x=t,this.y=e,this.z=n}set(t,e,n){return n===void 0&&(n=this.z),this.x=t,this.y=e,this.z=n,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("THREE.Vector3: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(Qm.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(Qm.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,n=this.y,i=this.z,r=t.elements;return this.x=r[0]*e+r[3]*n+r[6]*i,this.y=r[1]*e+r[4]*n+r[7]*i,this.z=r[2]*e+r[5]*n+r[8]*i,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,n=this.y,i=this.z,r=t.elements,o=1/(r[3]*e+r[7]*n+r[11]*i+r[15]);return this.x=(r[0]*e+r[4]*n+r[8]*i+r[12])*o,this.y=(r[1]*e+r[5]*n+r[9]*i+r[13])*o,this.z=(r[2]*e+r[6]*n+r[10]*i+r[14])*o,this}applyQuaternion(t){let e=this.x,n=this.y,i=this.z,r=t.x,o=t.y,a=t.z,c=t.w,l=2*(o*i-a*n),h=2*(a*e-r*i),u=2*(r*n-o*e);return this.x=e+c*l+o*u-a*h,this.y=n+c*h+a*l-r*u,this.z=i+c*u+r*h-o*l,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,n=this.y,i=this.z,r=t.elements;return this.x=r[0]*e+r[4]*n+r[8]*i,this.y=r[1]*e+r[5]*n+r[9]*i,this.z=r[2]*e+r[6]*n+r[10]*i,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=_e(this.x,t.x,e.x),this.y=_e(this.y,t.y,e.y),this.z=_e(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=_e(this.x,t,e),this.y=_e(this.y,t,e),this.z=_e(this.z,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(_e(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let n=t.x,i=t.y,r=t.z,o=e.x,a=e.y,c=e.z;return this.x=i*c-r*a,this.y=r*o-n*c,this.z=n*a-i*o,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let n=t.dot(this)/e;return this.copy(t).multiplyScalar(n)}projectOnPlane(t){return ef.copy(this).projectOnVector(t),this.sub(ef)}reflect(t){return this.sub(ef.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let n=this.dot(t)/e;return Math.acos(_e(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,n=this.y-t.y,i=this.z-t.z;return e*e+n*n+i*i}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,n){let i=Math.sin(e)*t;return this.x=i*Math.sin(n),this.y=Math.cos(e)*t,this.z=i*Math.cos(n),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,n){return this.x=t*Math.sin(e),this.y=n,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),n=this.setFromMatrixColumn(t,1).length(),i=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=n,this.z=i,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,n=Math.sqrt(1-e*e);return this.x=n*Math.cos(t),this.y=e,this.z=n*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},ef=new F,Qm=new ve,ie=class{static{this.prototype.isMatrix3=!0}constructor(t,e,n,i,r,o,a,c,l){this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,n,i,r,o,a,c,l)}set(t,e,n,i,r,o,a,c,l){let h=this.elements;return h[0]=t,h[1]=i,h[2]=a,h[3]=e,h[4]=r,h[5]=c,h[6]=n,h[7]=o,h[8]=l,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],this}extractBasis(t,e,n){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let n=t.elements,i=e.elements,r=this.elements,o=n[0],a=n[3],c=n[6],l=n[1],h=n[4],u=n[7],d=n[2],f=n[5],g=n[8],y=i[0],p=i[3],m=i[6],x=i[1],v=i[4],_=i[7],E=i[2],w=i[5],b=i[8];return r[0]=o*y+a*x+c*E,r[3]=o*p+a*v+c*w,r[6]=o*m+a*_+c*b,r[1]=l*y+h*x+u*E,r[4]=l*p+h*v+u*w,r[7]=l*m+h*_+u*b,r[2]=d*y+f*x+g*E,r[5]=d*p+f*v+g*w,r[8]=d*m+f*_+g*b,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],n=t[1],i=t[2],r=t[3],o=t[4],a=t[5],c=t[6],l=t[7],h=t[8];return e*o*h-e*a*l-n*r*h+n*a*c+i*r*l-i*o*c}invert(){let t=this.elements,e=t[0],n=t[1],i=t[2],r=t[3],o=t[4],a=t[5],c=t[6],l=t[7],h=t[8],u=h*o-a*l,d=a*c-h*r,f=l*r-o*c,g=e*u+n*d+i*f;if(g===0)return this.set(0,0,0,0,0,0,0,0,0);let y=1/g;return t[0]=u*y,t[1]=(i*l-h*n)*y,t[2]=(a*n-i*o)*y,t[3]=d*y,t[4]=(h*e-i*c)*y,t[5]=(i*r-a*e)*y,t[6]=f*y,t[7]=(n*c-l*e)*y,t[8]=(o*e-n*r)*y,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,n,i,r,o,a){let c=Math.cos(r),l=Math.sin(r);return this.set(n*c,n*l,-n*(c*o+l*a)+o+t,-i*l,i*c,-i*(-l*o+c*a)+a+e,0,0,1),this}scale(t,e){return nl("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(nf.makeScale(t,e)),this}rotate(t){return nl("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(nf.makeRotation(-t)),this}translate(t,e){return nl("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(nf.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,n,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,n=t.elements;for(let i=0;i<9;i++)if(e[i]!==n[i])return!1;return!0}fromArray(t,e=0){for(let n=0;n<9;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){let n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t}clone(){return new this.constructor().fromArray(this.elements)}},nf=new ie,tg=new ie().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),eg=new ie().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function Mb(){let s={enabled:!0,workingColorSpace:rl,spaces:{},convert:function(i,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Ne&&(i.r=Zs(i.r),i.g=Zs(i.g),i.b=Zs(i.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(i.applyMatrix3(this.spaces[r].toXYZ),i.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Ne&&(i.r=qo(i.r),i.g=qo(i.g),i.b=qo(i.b))),i},workingToColorSpace:function(i,r){return this.convert(i,this.workingColorSpace,r)},colorSpaceToWorking:function(i,r){return this.convert(i,r,this.workingColorSpace)},getPrimaries:function(i){return this.spaces[i].primaries},getTransfer:function(i){return i===or?ol:this.spaces[i].transfer},getToneMappingMode:function(i){return this.spaces[i].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(i,r=this.workingColorSpace){return i.fromArray(this.spaces[r].luminanceCoefficients)},define:function(i){Object.assign(this.spaces,i)},_getMatrix:function(i,r,o){return i.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(i){return this.spaces[i].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(i=this.workingColorSpace){return this.spaces[i].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],n=[.3127,.329];return s.define({[rl]:{primaries:t,whitePoint:n,transfer:ol,toXYZ:tg,fromXYZ:eg,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:Pe},outputColorSpaceConfig:{drawingBufferColorSpace:Pe}},[Pe]:{primaries:t,whitePoint:n,transfer:Ne,toXYZ:tg,fromXYZ:eg,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:Pe}}}),s}var he=Mb();function Zs(s){return s<.04045?s*.0773993808:Math.pow(s*.9478672986+.0521327014,2.4)}function qo(s){return s<.0031308?s*12.92:1.055*Math.pow(s,.41666)-.055}var Io,hh=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let n;if(t instanceof HTMLCanvasElement)n=t;else{Io===void 0&&(Io=$o("canvas")),Io.width=t.width,Io.height=t.height;let i=Io.getContext("2d");t instanceof ImageData?i.putImageData(t,0,0):i.drawImage(t,0,0,t.width,t.height),n=Io}return n.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=$o("canvas");e.width=t.width,e.height=t.height;let n=e.getContext("2d");n.drawImage(t,0,0,t.width,t.height);let i=n.getImageData(0,0,t.width,t.height),r=i.data;for(let o=0;o<r.length;o++)r[o]=Zs(r[o]/255)*255;return n.putImageData(i,0,0),e}else if(t.data){let e=t.data.slice(0);for(let n=0;n<e.length;n++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[n]=Math.floor(Zs(e[n]/255)*255):e[n]=Zs(e[n]);return{data:e,width:t.width,height:t.height}}else return Zt("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},Eb=0,Ko=class{constructor(t=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:Eb++}),this.uuid=Lr(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):typeof VideoFrame<"u"&&e instanceof VideoFrame?t.set(e.displayWidth,e.displayHeight,0):e!==null?t.set(e.width||0,e.height||0,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let n={uuid:this.uuid,url:""},i=this.data;if(i!==null){let r;if(Array.isArray(i)){r=[];for(let o=0,a=i.length;o<a;o++)i[o].isDataTexture?r.push(sf(i[o].image)):r.push(sf(i[o]))}else r=sf(i);n.url=r}return e||(t.images[this.uuid]=n),n}};function sf(s){return typeof HTMLImageElement<"u"&&s instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&s instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&s instanceof ImageBitmap?hh.getDataURL(s):s.data?{data:Array.from(s.data),width:s.width,height:s.height,type:s.data.constructor.name}:(Zt("Texture: Unable to serialize Texture."),{})}var Tb=0,rf=new F,ri=class s extends fs{constructor(t=s.DEFAULT_IMAGE,e=s.DEFAULT_MAPPING,n=_i,i=_i,r=jn,o=Ki,a=Qi,c=Ri,l=s.DEFAULT_ANISOTROPY,h=or){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:Tb++}),this.uuid=Lr(),this.name="",this.source=new Ko(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=n,this.wrapT=i,this.magFilter=r,this.minFilter=o,this.anisotropy=l,this.format=a,this.internalFormat=null,this.type=c,this.offset=new Vt(0,0),this.repeat=new Vt(1,1),this.center=new Vt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new ie,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(rf).x}get height(){return this.source.getSize(rf).y}get depth(){return this.source.getSize(rf).z}get image(){return this.source.data}set image(t){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.normalized=t.normalized,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.mipmapsAutoUpdate=t.mipmapsAutoUpdate,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isPMREMTexture=t.isPMREMTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let n=t[e];if(n===void 0){Zt(`Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let i=this[e];if(i===void 0){Zt(`Texture.setValues(): property '${e}' does not exist.`);continue}i&&n&&i.isVector2&&n.isVector2||i&&n&&i.isVector3&&n.isVector3||i&&n&&i.isMatrix3&&n.isMatrix3?i.copy(n):this[e]=n}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),e||(t.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==tp)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case ds:t.x=t.x-Math.floor(t.x);break;case _i:t.x=t.x<0?0:1;break;case lh:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case ds:t.y=t.y-Math.floor(t.y);break;case _i:t.y=t.y<0?0:1;break;case lh:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};ri.DEFAULT_IMAGE=null;ri.DEFAULT_MAPPING=tp;ri.DEFAULT_ANISOTROPY=1;var ze=class{static{this.prototype.isVector4=!0}constructor(t=0,e=0,n=0,i=1){this.x=t,this.y=e,this.z=n,this.w=i}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,n,i){return this.x=t,this.y=e,this.z=n,this.w=i,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("THREE.Vector4: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,n=this.y,i=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*n+o[8]*i+o[12]*r,this.y=o[1]*e+o[5]*n+o[9]*i+o[13]*r,this.z=o[2]*e+o[6]*n+o[10]*i+o[14]*r,this.w=o[3]*e+o[7]*n+o[11]*i+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,n,i,r,c=t.elements,l=c[0],h=c[4],u=c[8],d=c[1],f=c[5],g=c[9],y=c[2],p=c[6],m=c[10];if(Math.abs(h-d)<.01&&Math.abs(u-y)<.01&&Math.abs(g-p)<.01){if(Math.abs(h+d)<.1&&Math.abs(u+y)<.1&&Math.abs(g+p)<.1&&Math.abs(l+f+m-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let v=(l+1)/2,_=(f+1)/2,E=(m+1)/2,w=(h+d)/4,b=(u+y)/4,M=(g+p)/4;return v>_&&v>E?v<.01?(n=0,i=.707106781,r=.707106781):(n=Math.sqrt(v),i=w/n,r=b/n):_>E?_<.01?(n=.707106781,i=0,r=.707106781):(i=Math.sqrt(_),n=w/i,r=M/i):E<.01?(n=.707106781,i=.707106781,r=0):(r=Math.sqrt(E),n=b/r,i=M/r),this.set(n,i,r,e),this}let x=Math.sqrt((p-g)*(p-g)+(u-y)*(u-y)+(d-h)*(d-h));return Math.abs(x)<.001&&(x=1),this.x=(p-g)/x,this.y=(u-y)/x,this.z=(d-h)/x,this.w=Math.acos((l+f+m-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=_e(this.x,t.x,e.x),this.y=_e(this.y,t.y,e.y),this.z=_e(this.z,t.z,e.z),this.w=_e(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=_e(this.x,t,e),this.y=_e(this.y,t,e),this.z=_e(this.z,t,e),this.w=_e(this.w,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(_e(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this.w=t.w+(e.w-t.w)*n,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},uh=class extends fs{constructor(t=1,e=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:jn,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=n.depth,this.scissor=new ze(0,0,t,e),this.scissorTest=!1,this.viewport=new ze(0,0,t,e),this.textures=[];let i=n.count;for(let r=0;r<i;r++)this.textures[r]=new ri({width:t,height:e,depth:n.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(t={}){let e={minFilter:jn,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.mipmapsAutoUpdate!==void 0&&(e.mipmapsAutoUpdate=t.mipmapsAutoUpdate),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),t!==null&&t.renderTarget===null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,n=1){if(this.width!==t||this.height!==e||this.depth!==n){this.width=t,this.height=e,this.depth=n;for(let i=0,r=this.textures.length;i<r;i++)this.textures[i].image.width=t,this.textures[i].image.height=e,this.textures[i].image.depth=n,this.textures[i].isData3DTexture!==!0&&(this.textures[i].isArrayTexture=this.textures[i].image.depth>1);this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,n=t.textures.length;e<n;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let i=Object.assign({},t.textures[e].image);this.textures[e].source=new Ko(i)}if(this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveColorBuffer=t.resolveColorBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,this.storeMultisampledColorBuffer=t.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=t.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=t.storeMultisampledStencilBuffer,t.depthTexture!==null)if(t.depthTexture.renderTarget===t){let e=t.depthTexture.clone();e.renderTarget=null,this.depthTexture=e}else this.depthTexture=t.depthTexture;else this.depthTexture=null;return this.samples=t.samples,this.multiview=t.multiview,this.useArrayDepthTexture=t.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},ki=class extends uh{constructor(t=1,e=1,n={}){super(t,e,n),this.isWebGLRenderTarget=!0}},al=class extends ri{constructor(t=null,e=1,n=1,i=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:n,depth:i},this.magFilter=Zn,this.minFilter=Zn,this.wrapR=_i,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var dh=class extends ri{constructor(t=null,e=1,n=1,i=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:n,depth:i},this.magFilter=Zn,this.minFilter=Zn,this.wrapR=_i,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}};var Gt=class s{static{this.prototype.isMatrix4=!0}constructor(t,e,n,i,r,o,a,c,l,h,u,d,f,g,y,p){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,n,i,r,o,a,c,l,h,u,d,f,g,y,p)}set(t,e,n,i,r,o,a,c,l,h,u,d,f,g,y,p){let m=this.elements;return m[0]=t,m[4]=e,m[8]=n,m[12]=i,m[1]=r,m[5]=o,m[9]=a,m[13]=c,m[2]=l,m[6]=h,m[10]=u,m[14]=d,m[3]=f,m[7]=g,m[11]=y,m[15]=p,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new s().fromArray(this.elements)}copy(t){let e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],e[9]=n[9],e[10]=n[10],e[11]=n[11],e[12]=n[12],e[13]=n[13],e[14]=n[14],e[15]=n[15],this}copyPosition(t){let e=this.elements,n=t.elements;return e[12]=n[12],e[13]=n[13],e[14]=n[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,n){return this.determinantAffine()===0?(t.set(1,0,0),e.set(0,1,0),n.set(0,0,1),this):(t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(t,e,n){return this.set(t.x,e.x,n.x,0,t.y,e.y,n.y,0,t.z,e.z,n.z,0,0,0,0,1),this}extractRotation(t){if(t.determinantAffine()===0)return this.identity();let e=this.elements,n=t.elements,i=1/Lo.setFromMatrixColumn(t,0).length(),r=1/Lo.setFromMatrixColumn(t,1).length(),o=1/Lo.setFromMatrixColumn(t,2).length();return e[0]=n[0]*i,e[1]=n[1]*i,e[2]=n[2]*i,e[3]=0,e[4]=n[4]*r,e[5]=n[5]*r,e[6]=n[6]*r,e[7]=0,e[8]=n[8]*o,e[9]=n[9]*o,e[10]=n[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,n=t.x,i=t.y,r=t.z,o=Math.cos(n),a=Math.sin(n),c=Math.cos(i),l=Math.sin(i),h=Math.cos(r),u=Math.sin(r);if(t.order==="XYZ"){let d=o*h,f=o*u,g=a*h,y=a*u;e[0]=c*h,e[4]=-c*u,e[8]=l,e[1]=f+g*l,e[5]=d-y*l,e[9]=-a*c,e[2]=y-d*l,e[6]=g+f*l,e[10]=o*c}else if(t.order==="YXZ"){let d=c*h,f=c*u,g=l*h,y=l*u;e[0]=d+y*a,e[4]=g*a-f,e[8]=o*l,e[1]=o*u,e[5]=o*h,e[9]=-a,e[2]=f*a-g,e[6]=y+d*a,e[10]=o*c}else if(t.order==="ZXY"){let d=c*h,f=c*u,g=l*h,y=l*u;e[0]=d-y*a,e[4]=-o*u,e[8]=g+f*a,e[1]=f+g*a,e[5]=o*h,e[9]=y-d*a,e[2]=-o*l,e[6]=a,e[10]=o*c}else if(t.order==="ZYX"){let d=o*h,f=o*u,g=a*h,y=a*u;e[0]=c*h,e[4]=g*l-f,e[8]=d*l+y,e[1]=c*u,e[5]=y*l+d,e[9]=f*l-g,e[2]=-l,e[6]=a*c,e[10]=o*c}else if(t.order==="YZX"){let d=o*c,f=o*l,g=a*c,y=a*l;e[0]=c*h,e[4]=y-d*u,e[8]=g*u+f,e[1]=u,e[5]=o*h,e[9]=-a*h,e[2]=-l*h,e[6]=f*u+g,e[10]=d-y*u}else if(t.order==="XZY"){let d=o*c,f=o*l,g=a*c,y=a*l;e[0]=c*h,e[4]=-u,e[8]=l*h,e[1]=d*u+y,e[5]=o*h,e[9]=f*u-g,e[2]=g*u-f,e[6]=a*h,e[10]=y*u+d}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(Ab,t,Rb)}lookAt(t,e,n){let i=this.elements;return Ui.subVectors(t,e),Ui.lengthSq()===0&&(Ui.z=1),Ui.normalize(),gr.crossVectors(n,Ui),gr.lengthSq()===0&&(Math.abs(n.z)===1?Ui.x+=1e-4:Ui.z+=1e-4,Ui.normalize(),gr.crossVectors(n,Ui)),gr.normalize(),wc.crossVectors(Ui,gr),i[0]=gr.x,i[4]=wc.x,i[8]=Ui.x,i[1]=gr.y,i[5]=wc.y,i[9]=Ui.y,i[2]=gr.z,i[6]=wc.z,i[10]=Ui.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let n=t.elements,i=e.elements,r=this.elements,o=n[0],a=n[4],c=n[8],l=n[12],h=n[1],u=n[5],d=n[9],f=n[13],g=n[2],y=n[6],p=n[10],m=n[14],x=n[3],v=n[7],_=n[11],E=n[15],w=i[0],b=i[4],M=i[8],I=i[12],P=i[1],C=i[5],D=i[9],B=i[13],L=i[2],z=i[6],O=i[10],H=i[14],tt=i[3],X=i[7],Z=i[11],$=i[15];return r[0]=o*w+a*P+c*L+l*tt,r[4]=o*b+a*C+c*z+l*X,r[8]=o*M+a*D+c*O+l*Z,r[12]=o*I+a*B+c*H+l*$,r[1]=h*w+u*P+d*L+f*tt,r[5]=h*b+u*C+d*z+f*X,r[9]=h*M+u*D+d*O+f*Z,r[13]=h*I+u*B+d*H+f*$,r[2]=g*w+y*P+p*L+m*tt,r[6]=g*b+y*C+p*z+m*X,r[10]=g*M+y*D+p*O+m*Z,r[14]=g*I+y*B+p*H+m*$,r[3]=x*w+v*P+_*L+E*tt,r[7]=x*b+v*C+_*z+E*X,r[11]=x*M+v*D+_*O+E*Z,r[15]=x*I+v*B+_*H+E*$,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],n=t[4],i=t[8],r=t[12],o=t[1],a=t[5],c=t[9],l=t[13],h=t[2],u=t[6],d=t[10],f=t[14],g=t[3],y=t[7],p=t[11],m=t[15],x=c*f-l*d,v=a*f-l*u,_=a*d-c*u,E=o*f-l*h,w=o*d-c*h,b=o*u-a*h;return e*(y*x-p*v+m*_)-n*(g*x-p*E+m*w)+i*(g*v-y*E+m*b)-r*(g*_-y*w+p*b)}determinantAffine(){let t=this.elements,e=t[0],n=t[4],i=t[8],r=t[1],o=t[5],a=t[9],c=t[2],l=t[6],h=t[10];return e*(o*h-a*l)-n*(r*h-a*c)+i*(r*l-o*c)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,n){let i=this.elements;return t.isVector3?(i[12]=t.x,i[13]=t.y,i[14]=t.z):(i[12]=t,i[13]=e,i[14]=n),this}invert(){let t=this.elements,e=t[0],n=t[1],i=t[2],r=t[3],o=t[4],a=t[5],c=t[6],l=t[7],h=t[8],u=t[9],d=t[10],f=t[11],g=t[12],y=t[13],p=t[14],m=t[15],x=e*a-n*o,v=e*c-i*o,_=e*l-r*o,E=n*c-i*a,w=n*l-r*a,b=i*l-r*c,M=h*y-u*g,I=h*p-d*g,P=h*m-f*g,C=u*p-d*y,D=u*m-f*y,B=d*m-f*p,L=x*B-v*D+_*C+E*P-w*I+b*M;if(L===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let z=1/L;return t[0]=(a*B-c*D+l*C)*z,t[1]=(i*D-n*B-r*C)*z,t[2]=(y*b-p*w+m*E)*z,t[3]=(d*w-u*b-f*E)*z,t[4]=(c*P-o*B-l*I)*z,t[5]=(e*B-i*P+r*I)*z,t[6]=(p*_-g*b-m*v)*z,t[7]=(h*b-d*_+f*v)*z,t[8]=(o*D-a*P+l*M)*z,t[9]=(n*P-e*D-r*M)*z,t[10]=(g*w-y*_+m*x)*z,t[11]=(u*_-h*w-f*x)*z,t[12]=(a*I-o*C-c*M)*z,t[13]=(e*C-n*I+i*M)*z,t[14]=(y*v-g*E-p*x)*z,t[15]=(h*E-u*v+d*x)*z,this}scale(t){let e=this.elements,n=t.x,i=t.y,r=t.z;return e[0]*=n,e[4]*=i,e[8]*=r,e[1]*=n,e[5]*=i,e[9]*=r,e[2]*=n,e[6]*=i,e[10]*=r,e[3]*=n,e[7]*=i,e[11]*=r,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],n=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],i=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,n,i))}makeTranslation(t,e,n){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,n,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),n=Math.sin(t);return this.set(1,0,0,0,0,e,-n,0,0,n,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,0,n,0,0,1,0,0,-n,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,0,n,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let n=Math.cos(e),i=Math.sin(e),r=1-n,o=t.x,a=t.y,c=t.z,l=r*o,h=r*a;return this.set(l*o+n,l*a-i*c,l*c+i*a,0,l*a+i*c,h*a+n,h*c-i*o,0,l*c-i*a,h*c+i*o,r*c*c+n,0,0,0,0,1),this}makeScale(t,e,n){return this.set(t,0,0,0,0,e,0,0,0,0,n,0,0,0,0,1),this}makeShear(t,e,n,i,r,o){return this.set(1,n,r,0,t,1,o,0,e,i,1,0,0,0,0,1),this}compose(t,e,n){let i=this.elements,r=e._x,o=e._y,a=e._z,c=e._w,l=r+r,h=o+o,u=a+a,d=r*l,f=r*h,g=r*u,y=o*h,p=o*u,m=a*u,x=c*l,v=c*h,_=c*u,E=n.x,w=n.y,b=n.z;return i[0]=(1-(y+m))*E,i[1]=(f+_)*E,i[2]=(g-v)*E,i[3]=0,i[4]=(f-_)*w,i[5]=(1-(d+m))*w,i[6]=(p+x)*w,i[7]=0,i[8]=(g+v)*b,i[9]=(p-x)*b,i[10]=(1-(d+y))*b,i[11]=0,i[12]=t.x,i[13]=t.y,i[14]=t.z,i[15]=1,this}decompose(t,e,n){let i=this.elements;t.x=i[12],t.y=i[13],t.z=i[14];let r=this.determinantAffine();if(r===0)return n.set(1,1,1),e.identity(),this;let o=Lo.set(i[0],i[1],i[2]).length(),a=Lo.set(i[4],i[5],i[6]).length(),c=Lo.set(i[8],i[9],i[10]).length();r<0&&(o=-o),ls.copy(this);let l=1/o,h=1/a,u=1/c;return ls.elements[0]*=l,ls.elements[1]*=l,ls.elements[2]*=l,ls.elements[4]*=h,ls.elements[5]*=h,ls.elements[6]*=h,ls.elements[8]*=u,ls.elements[9]*=u,ls.elements[10]*=u,e.setFromRotationMatrix(ls),n.x=o,n.y=a,n.z=c,this}makePerspective(t,e,n,i,r,o,a=Yi,c=!1){let l=this.elements,h=2*r/(e-t),u=2*r/(n-i),d=(e+t)/(e-t),f=(n+i)/(n-i),g,y;if(c)g=r/(o-r),y=o*r/(o-r);else if(a===Yi)g=-(o+r)/(o-r),y=-2*o*r/(o-r);else if(a===Zo)g=-o/(o-r),y=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return l[0]=h,l[4]=0,l[8]=d,l[12]=0,l[1]=0,l[5]=u,l[9]=f,l[13]=0,l[2]=0,l[6]=0,l[10]=g,l[14]=y,l[3]=0,l[7]=0,l[11]=-1,l[15]=0,this}makeOrthographic(t,e,n,i,r,o,a=Yi,c=!1){let l=this.elements,h=2/(e-t),u=2/(n-i),d=-(e+t)/(e-t),f=-(n+i)/(n-i),g,y;if(c)g=1/(o-r),y=o/(o-r);else if(a===Yi)g=-2/(o-r),y=-(o+r)/(o-r);else if(a===Zo)g=-1/(o-r),y=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return l[0]=h,l[4]=0,l[8]=0,l[12]=d,l[1]=0,l[5]=u,l[9]=0,l[13]=f,l[2]=0,l[6]=0,l[10]=g,l[14]=y,l[3]=0,l[7]=0,l[11]=0,l[15]=1,this}equals(t){let e=this.elements,n=t.elements;for(let i=0;i<16;i++)if(e[i]!==n[i])return!1;return!0}fromArray(t,e=0){for(let n=0;n<16;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){let n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t[e+9]=n[9],t[e+10]=n[10],t[e+11]=n[11],t[e+12]=n[12],t[e+13]=n[13],t[e+14]=n[14],t[e+15]=n[15],t}},Lo=new F,ls=new Gt,Ab=new F(0,0,0),Rb=new F(1,1,1),gr=new F,wc=new F,Ui=new F,ng=new Gt,ig=new ve,ti=class s{constructor(t=0,e=0,n=0,i=s.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=n,this._order=i}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,n,i=this._order){return this._x=t,this._y=e,this._z=n,this._order=i,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,n=!0){let i=t.elements,r=i[0],o=i[4],a=i[8],c=i[1],l=i[5],h=i[9],u=i[2],d=i[6],f=i[10];switch(e){case"XYZ":this._y=Math.asin(_e(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(d,l),this._z=0);break;case"YXZ":this._x=Math.asin(-_e(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(c,l)):(this._y=Math.atan2(-u,r),this._z=0);break;case"ZXY":this._x=Math.asin(_e(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-u,f),this._z=Math.atan2(-o,l)):(this._y=0,this._z=Math.atan2(c,r));break;case"ZYX":this._y=Math.asin(-_e(u,-1,1)),Math.abs(u)<.9999999?(this._x=Math.atan2(d,f),this._z=Math.atan2(c,r)):(this._x=0,this._z=Math.atan2(-o,l));break;case"YZX":this._z=Math.asin(_e(c,-1,1)),Math.abs(c)<.9999999?(this._x=Math.atan2(-h,l),this._y=Math.atan2(-u,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-_e(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(d,l),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-h,f),this._y=0);break;default:Zt("Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,n===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,n){return ng.makeRotationFromQuaternion(t),this.setFromRotationMatrix(ng,e,n)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return ig.setFromEuler(this),this.setFromQuaternion(ig,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};ti.DEFAULT_ORDER="XYZ";var Qo=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},Cb=0,sg=new F,No=new ve,Gs=new Gt,Sc=new F,qa=new F,Pb=new F,Ib=new ve,rg=new F(1,0,0),og=new F(0,1,0),ag=new F(0,0,1),lg={type:"added"},Lb={type:"removed"},Do={type:"childadded",child:null},of={type:"childremoved",child:null},De=class s extends fs{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:Cb++}),this.uuid=Lr(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=s.DEFAULT_UP.clone();let t=new F,e=new ti,n=new ve,i=new F(1,1,1);function r(){n.setFromEuler(e,!1)}function o(){e.setFromQuaternion(n,void 0,!1)}e._onChange(r),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:i},modelViewMatrix:{value:new Gt},normalMatrix:{value:new ie}}),this.matrix=new Gt,this.matrixWorld=new Gt,this.matrixAutoUpdate=s.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=s.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Qo,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return No.setFromAxisAngle(t,e),this.quaternion.multiply(No),this}rotateOnWorldAxis(t,e){return No.setFromAxisAngle(t,e),this.quaternion.premultiply(No),this}rotateX(t){return this.rotateOnAxis(rg,t)}rotateY(t){return this.rotateOnAxis(og,t)}rotateZ(t){return this.rotateOnAxis(ag,t)}translateOnAxis(t,e){return sg.copy(t).applyQuaternion(this.quaternion),this.position.add(sg.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(rg,t)}translateY(t){return this.translateOnAxis(og,t)}translateZ(t){return this.translateOnAxis(ag,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(Gs.copy(this.matrixWorld).invert())}lookAt(t,e,n){t.isVector3?Sc.copy(t):Sc.set(t,e,n);let i=this.parent;this.updateWorldMatrix(!0,!1),qa.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Gs.lookAt(qa,Sc,this.up):Gs.lookAt(Sc,qa,this.up),this.quaternion.setFromRotationMatrix(Gs),i&&(Gs.extractRotation(i.matrixWorld),No.setFromRotationMatrix(Gs),this.quaternion.premultiply(No.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(te("Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(lg),Do.child=t,this.dispatchEvent(Do),Do.child=null):te("Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(Lb),of.child=t,this.dispatchEvent(of),of.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),Gs.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),Gs.multiply(t.parent.matrixWorld)),t.applyMatrix4(Gs),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(lg),Do.child=t,this.dispatchEvent(Do),Do.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let n=0,i=this.children.length;n<i;n++){let o=this.children[n].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,n=[]){this[t]===e&&n.push(this);let i=this.children;for(let r=0,o=i.length;r<o;r++)i[r].getObjectsByProperty(t,e,n);return n}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(qa,t,Pb),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(qa,Ib,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(t){t(this);let e=this.children;for(let n=0,i=e.length;n<i;n++)e[n].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let n=0,i=e.length;n<i;n++)e[n].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let t=this.pivot;if(t!==null){let e=t.x,n=t.y,i=t.z,r=this.matrix.elements;r[12]+=e-r[0]*e-r[4]*n-r[8]*i,r[13]+=n-r[1]*e-r[5]*n-r[9]*i,r[14]+=i-r[2]*e-r[6]*n-r[10]*i}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let n=0,i=e.length;n<i;n++)e[n].updateMatrixWorld(t)}updateWorldMatrix(t,e,n=!1){let i=this.parent;if(t===!0&&i!==null&&i.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),e===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,n)}}toJSON(t){let e=t===void 0||typeof t=="string",n={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let i={};i.uuid=this.uuid,i.type=this.type,i.name=this.name,i.castShadow=this.castShadow,i.receiveShadow=this.receiveShadow,i.visible=this.visible,i.frustumCulled=this.frustumCulled,i.renderOrder=this.renderOrder,i.static=this.static,i.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(i.userData=this.userData),i.layers=this.layers.mask,i.matrix=this.matrix.toArray(),i.up=this.up.toArray(),this.pivot!==null&&(i.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(i.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(i.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(i.type="InstancedMesh",i.count=this.count,i.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(i.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(i.type="BatchedMesh",i.perObjectFrustumCulled=this.perObjectFrustumCulled,i.sortObjects=this.sortObjects,i.drawRanges=this._drawRanges,i.reservedRanges=this._reservedRanges,i.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),i.instanceInfo=this._instanceInfo.map(a=>({...a})),i.availableInstanceIds=this._availableInstanceIds.slice(),i.availableGeometryIds=this._availableGeometryIds.slice(),i.nextIndexStart=this._nextIndexStart,i.nextVertexStart=this._nextVertexStart,i.geometryCount=this._geometryCount,i.maxInstanceCount=this._maxInstanceCount,i.maxVertexCount=this._maxVertexCount,i.maxIndexCount=this._maxIndexCount,i.geometryInitialized=this._geometryInitialized,i.matricesTexture=this._matricesTexture.toJSON(t),i.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(i.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(i.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(i.boundingBox=this.boundingBox.toJSON()));function r(a,c){return a[c.uuid]===void 0&&(a[c.uuid]=c.toJSON(t)),c.uuid}if(this.isScene)this.background&&(this.background.isColor?i.background=this.background.toJSON():this.background.isTexture&&(i.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(i.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){i.geometry=r(t.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let c=a.shapes;if(Array.isArray(c))for(let l=0,h=c.length;l<h;l++){let u=c[l];r(t.shapes,u)}else r(t.shapes,c)}}if(this.isSkinnedMesh&&(i.bindMode=this.bindMode,i.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),i.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let c=0,l=this.material.length;c<l;c++)a.push(r(t.materials,this.material[c]));i.material=a}else i.material=r(t.materials,this.material);if(this.children.length>0){i.children=[];for(let a=0;a<this.children.length;a++)i.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){i.animations=[];for(let a=0;a<this.animations.length;a++){let c=this.animations[a];i.animations.push(r(t.animations,c))}}if(e){let a=o(t.geometries),c=o(t.materials),l=o(t.textures),h=o(t.images),u=o(t.shapes),d=o(t.skeletons),f=o(t.animations),g=o(t.nodes);a.length>0&&(n.geometries=a),c.length>0&&(n.materials=c),l.length>0&&(n.textures=l),h.length>0&&(n.images=h),u.length>0&&(n.shapes=u),d.length>0&&(n.skeletons=d),f.length>0&&(n.animations=f),g.length>0&&(n.nodes=g)}return n.object=i,n;function o(a){let c=[];for(let l in a){let h=a[l];delete h.metadata,c.push(h)}return c}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.pivot=t.pivot!==null?t.pivot.clone():null,this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.static=t.static,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let n=0;n<t.children.length;n++){let i=t.children[n];this.add(i.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};De.DEFAULT_UP=new F(0,1,0);De.DEFAULT_MATRIX_AUTO_UPDATE=!0;De.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Be=class extends De{constructor(){super(),this.isGroup=!0,this.type="Group"}},Nb={type:"move"},ta=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Be,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Be,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new F,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new F),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Be,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new F,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new F,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let n of t.hand.values())this._getHandJoint(e,n)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,n){let i=null,r=null,o=null,a=this._targetRay,c=this._grip,l=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(l&&t.hand){o=!0;for(let y of t.hand.values()){let p=e.getJointPose(y,n),m=this._getHandJoint(l,y);p!==null&&(m.matrix.fromArray(p.transform.matrix),m.matrix.decompose(m.position,m.quaternion,m.scale),m.matrixWorldNeedsUpdate=!0,m.jointRadius=p.radius),m.visible=p!==null}let h=l.joints["index-finger-tip"],u=l.joints["thumb-tip"],d=h.position.distanceTo(u.position),f=.02,g=.005;l.inputState.pinching&&d>f+g?(l.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!l.inputState.pinching&&d<=f-g&&(l.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else c!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,n),r!==null&&(c.matrix.fromArray(r.transform.matrix),c.matrix.decompose(c.position,c.quaternion,c.scale),c.matrixWorldNeedsUpdate=!0,r.linearVelocity?(c.hasLinearVelocity=!0,c.linearVelocity.copy(r.linearVelocity)):c.hasLinearVelocity=!1,r.angularVelocity?(c.hasAngularVelocity=!0,c.angularVelocity.copy(r.angularVelocity)):c.hasAngularVelocity=!1,c.eventsEnabled&&c.dispatchEvent({type:"gripUpdated",data:t,target:this})));a!==null&&(i=e.getPose(t.targetRaySpace,n),i===null&&r!==null&&(i=r),i!==null&&(a.matrix.fromArray(i.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,i.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(i.linearVelocity)):a.hasLinearVelocity=!1,i.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(i.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(Nb)))}return a!==null&&(a.visible=i!==null),c!==null&&(c.visible=r!==null),l!==null&&(l.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let n=new Be;n.matrixAutoUpdate=!1,n.visible=!1,t.joints[e.jointName]=n,t.add(n)}return t.joints[e.jointName]}},C0={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},xr={h:0,s:0,l:0},Mc={h:0,s:0,l:0};function af(s,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?s+(t-s)*6*e:e<1/2?t:e<2/3?s+(t-s)*6*(2/3-e):s}var qt=class{constructor(t,e,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,n)}set(t,e,n){if(e===void 0&&n===void 0){let i=t;i&&i.isColor?this.copy(i):typeof i=="number"?this.setHex(i):typeof i=="string"&&this.setStyle(i)}else this.setRGB(t,e,n);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=Pe){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,he.colorSpaceToWorking(this,e),this}setRGB(t,e,n,i=he.workingColorSpace){return this.r=t,this.g=e,this.b=n,he.colorSpaceToWorking(this,i),this}setHSL(t,e,n,i=he.workingColorSpace){if(t=dp(t,1),e=_e(e,0,1),n=_e(n,0,1),e===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+e):n+e-n*e,o=2*n-r;this.r=af(o,r,t+1/3),this.g=af(o,r,t),this.b=af(o,r,t-1/3)}return he.colorSpaceToWorking(this,i),this}setStyle(t,e=Pe){function n(r){r!==void 0&&parseFloat(r)<1&&Zt("Color: Alpha component of "+t+" will be ignored.")}let i;if(i=/^(\w+)\(([^\)]*)\)/.exec(t)){let r,o=i[1],a=i[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,e);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:Zt("Color: Unknown color model "+t)}}else if(i=/^\#([A-Fa-f\d]+)$/.exec(t)){let r=i[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);Zt("Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=Pe){let n=C0[t.toLowerCase()];return n!==void 0?this.setHex(n,e):Zt("Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=Zs(t.r),this.g=Zs(t.g),this.b=Zs(t.b),this}copyLinearToSRGB(t){return this.r=qo(t.r),this.g=qo(t.g),this.b=qo(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=Pe){return he.workingToColorSpace(si.copy(this),t),Math.round(_e(si.r*255,0,255))*65536+Math.round(_e(si.g*255,0,255))*256+Math.round(_e(si.b*255,0,255))}getHexString(t=Pe){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=he.workingColorSpace){he.workingToColorSpace(si.copy(this),e);let n=si.r,i=si.g,r=si.b,o=Math.max(n,i,r),a=Math.min(n,i,r),c,l,h=(a+o)/2;if(a===o)c=0,l=0;else{let u=o-a;switch(l=h<=.5?u/(o+a):u/(2-o-a),o){case n:c=(i-r)/u+(i<r?6:0);break;case i:c=(r-n)/u+2;break;case r:c=(n-i)/u+4;break}c/=6}return t.h=c,t.s=l,t.l=h,t}getRGB(t,e=he.workingColorSpace){return he.workingToColorSpace(si.copy(this),e),t.r=si.r,t.g=si.g,t.b=si.b,t}getStyle(t=Pe){he.workingToColorSpace(si.copy(this),t);let e=si.r,n=si.g,i=si.b;return t!==Pe?`color(${t} ${e.toFixed(3)} ${n.toFixed(3)} ${i.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(n*255)},${Math.round(i*255)})`}offsetHSL(t,e,n){return this.getHSL(xr),this.setHSL(xr.h+t,xr.s+e,xr.l+n)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,n){return this.r=t.r+(e.r-t.r)*n,this.g=t.g+(e.g-t.g)*n,this.b=t.b+(e.b-t.b)*n,this}lerpHSL(t,e){this.getHSL(xr),t.getHSL(Mc);let n=il(xr.h,Mc.h,e),i=il(xr.s,Mc.s,e),r=il(xr.l,Mc.l,e);return this.setHSL(n,i,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,n=this.g,i=this.b,r=t.elements;return this.r=r[0]*e+r[3]*n+r[6]*i,this.g=r[1]*e+r[4]*n+r[7]*i,this.b=r[2]*e+r[5]*n+r[8]*i,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},si=new qt;qt.NAMES=C0;var ll=class s{constructor(t,e=1,n=1e3){this.isFog=!0,this.name="",this.color=new qt(t),this.near=e,this.far=n}clone(){return new s(this.color,this.near,this.far)}toJSON(){return{type:"Fog",name:this.name,color:this.color.getHex(),near:this.near,far:this.far}}},Yr=class extends De{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new ti,this.environmentIntensity=1,this.environmentRotation=new ti,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),this.background=t.background!==null?t.background.clone():null,this.environment=t.environment!==null?t.environment.clone():null,this.fog=t.fog!==null?t.fog.clone():null,this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),this.overrideMaterial=t.overrideMaterial!==null?t.overrideMaterial.clone():null,this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),e.object.backgroundBlurriness=this.backgroundBlurriness,e.object.backgroundIntensity=this.backgroundIntensity,e.object.backgroundRotation=this.backgroundRotation.toArray(),e.object.environmentIntensity=this.environmentIntensity,e.object.environmentRotation=this.environmentRotation.toArray(),e}},cs=new F,Ws=new F,lf=new F,Xs=new F,Uo=new F,Fo=new F,cg=new F,cf=new F,hf=new F,uf=new F,df=new ze,ff=new ze,pf=new ze,us=class s{constructor(t=new F,e=new F,n=new F){this.a=t,this.b=e,this.c=n}static getNormal(t,e,n,i){i.subVectors(n,e),cs.subVectors(t,e),i.cross(cs);let r=i.lengthSq();return r>0?i.multiplyScalar(1/Math.sqrt(r)):i.set(0,0,0)}static getBarycoord(t,e,n,i,r){cs.subVectors(i,e),Ws.subVectors(n,e),lf.subVectors(t,e);let o=cs.dot(cs),a=cs.dot(Ws),c=cs.dot(lf),l=Ws.dot(Ws),h=Ws.dot(lf),u=o*l-a*a;if(u===0)return r.set(0,0,0),null;let d=1/u,f=(l*c-a*h)*d,g=(o*h-a*c)*d;return r.set(1-f-g,g,f)}static containsPoint(t,e,n,i){return this.getBarycoord(t,e,n,i,Xs)===null?!1:Xs.x>=0&&Xs.y>=0&&Xs.x+Xs.y<=1}static getInterpolation(t,e,n,i,r,o,a,c){return this.getBarycoord(t,e,n,i,Xs)===null?(c.x=0,c.y=0,"z"in c&&(c.z=0),"w"in c&&(c.w=0),null):(c.setScalar(0),c.addScaledVector(r,Xs.x),c.addScaledVector(o,Xs.y),c.addScaledVector(a,Xs.z),c)}static getInterpolatedAttribute(t,e,n,i,r,o){return df.setScalar(0),ff.setScalar(0),pf.setScalar(0),df.fromBufferAttribute(t,e),ff.fromBufferAttribute(t,n),pf.fromBufferAttribute(t,i),o.setScalar(0),o.addScaledVector(df,r.x),o.addScaledVector(ff,r.y),o.addScaledVector(pf,r.z),o}static isFrontFacing(t,e,n,i){return cs.subVectors(n,e),Ws.subVectors(t,e),cs.cross(Ws).dot(i)<0}set(t,e,n){return this.a.copy(t),this.b.copy(e),this.c.copy(n),this}setFromPointsAndIndices(t,e,n,i){return this.a.copy(t[e]),this.b.copy(t[n]),this.c.copy(t[i]),this}setFromAttributeAndIndices(t,e,n,i){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,n),this.c.fromBufferAttribute(t,i),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return cs.subVectors(this.c,this.b),Ws.subVectors(this.a,this.b),cs.cross(Ws).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return s.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return s.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,n,i,r){return s.getInterpolation(t,this.a,this.b,this.c,e,n,i,r)}containsPoint(t){return s.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return s.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let n=this.a,i=this.b,r=this.c,o,a;Uo.subVectors(i,n),Fo.subVectors(r,n),cf.subVectors(t,n);let c=Uo.dot(cf),l=Fo.dot(cf);if(c<=0&&l<=0)return e.copy(n);hf.subVectors(t,i);let h=Uo.dot(hf),u=Fo.dot(hf);if(h>=0&&u<=h)return e.copy(i);let d=c*u-h*l;if(d<=0&&c>=0&&h<=0&&c-h>0)return o=c/(c-h),e.copy(n).addScaledVector(Uo,o);uf.subVectors(t,r);let f=Uo.dot(uf),g=Fo.dot(uf);if(g>=0&&f<=g)return e.copy(r);let y=f*l-c*g;if(y<=0&&l>=0&&g<=0)return a=l/(l-g),e.copy(n).addScaledVector(Fo,a);let p=h*g-f*u;if(p<=0&&u-h>=0&&f-g>=0)return cg.subVectors(r,i),a=(u-h)/(u-h+(f-g)),e.copy(i).addScaledVector(cg,a);let m=1/(p+y+d);return o=y*m,a=d*m,e.copy(n).addScaledVector(Uo,o).addScaledVector(Fo,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},Oi=class{constructor(t=new F(1/0,1/0,1/0),e=new F(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e+=3)this.expandByPoint(hs.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,n=t.count;e<n;e++)this.expandByPoint(hs.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let n=hs.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(n),this.max.copy(t).add(n),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let n=t.geometry;if(n!==void 0){let r=n.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0&&t.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,hs):hs.fromBufferAttribute(r,o),hs.applyMatrix4(t.matrixWorld),this.expandByPoint(hs);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),Ec.copy(t.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),Ec.copy(n.boundingBox)),Ec.applyMatrix4(t.matrixWorld),this.union(Ec)}let i=t.children;for(let r=0,o=i.length;r<o;r++)this.expandByObject(i[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,hs),hs.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,n;return t.normal.x>0?(e=t.normal.x*this.min.x,n=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,n=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,n+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,n+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,n+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,n+=t.normal.z*this.min.z),e<=-t.constant&&n>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(Ya),Tc.subVectors(this.max,Ya),ko.subVectors(t.a,Ya),Oo.subVectors(t.b,Ya),Bo.subVectors(t.c,Ya),_r.subVectors(Oo,ko),yr.subVectors(Bo,Oo),Hr.subVectors(ko,Bo);let e=[0,-_r.z,_r.y,0,-yr.z,yr.y,0,-Hr.z,Hr.y,_r.z,0,-_r.x,yr.z,0,-yr.x,Hr.z,0,-Hr.x,-_r.y,_r.x,0,-yr.y,yr.x,0,-Hr.y,Hr.x,0];return!mf(e,ko,Oo,Bo,Tc)||(e=[1,0,0,0,1,0,0,0,1],!mf(e,ko,Oo,Bo,Tc))?!1:(Ac.crossVectors(_r,yr),e=[Ac.x,Ac.y,Ac.z],mf(e,ko,Oo,Bo,Tc))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,hs).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(hs).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(qs[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),qs[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),qs[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),qs[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),qs[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),qs[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),qs[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),qs[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(qs),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},qs=[new F,new F,new F,new F,new F,new F,new F,new F],hs=new F,Ec=new Oi,ko=new F,Oo=new F,Bo=new F,_r=new F,yr=new F,Hr=new F,Ya=new F,Tc=new F,Ac=new F,Vr=new F;function mf(s,t,e,n,i){for(let r=0,o=s.length-3;r<=o;r+=3){Vr.fromArray(s,r);let a=i.x*Math.abs(Vr.x)+i.y*Math.abs(Vr.y)+i.z*Math.abs(Vr.z),c=t.dot(Vr),l=e.dot(Vr),h=n.dot(Vr);if(Math.max(-Math.max(c,l,h),Math.min(c,l,h))>a)return!1}return!0}var In=new F,Rc=new Vt,Db=0,Xe=class extends fs{constructor(t,e,n=!1){if(super(),Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:Db++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=n,this.usage=w0,this.updateRanges=[],this.gpuType=Bi,this.version=0,this._normalizationScale=t!==void 0?pp(t):void 0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this._normalizationScale=t._normalizationScale,this}copyAt(t,e,n){t*=this.itemSize,n*=e.itemSize;for(let i=0,r=this.itemSize;i<r;i++)this.array[t+i]=e.array[n+i];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,n=this.count;e<n;e++)Rc.fromBufferAttribute(this,e),Rc.applyMatrix3(t),this.setXY(e,Rc.x,Rc.y);else if(this.itemSize===3)for(let e=0,n=this.count;e<n;e++)In.fromBufferAttribute(this,e),In.applyMatrix3(t),this.setXYZ(e,In.x,In.y,In.z);return this}applyMatrix4(t){for(let e=0,n=this.count;e<n;e++)In.fromBufferAttribute(this,e),In.applyMatrix4(t),this.setXYZ(e,In.x,In.y,In.z);return this}applyNormalMatrix(t){for(let e=0,n=this.count;e<n;e++)In.fromBufferAttribute(this,e),In.applyNormalMatrix(t),this.setXYZ(e,In.x,In.y,In.z);return this}transformDirection(t){for(let e=0,n=this.count;e<n;e++)In.fromBufferAttribute(this,e),In.transformDirection(t),this.setXYZ(e,In.x,In.y,In.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let n=this.array[t*this.itemSize+e];return this.normalized&&(n=this._denormalize(n)),n}setComponent(t,e,n){return this.normalized&&(n=this._normalize(n)),this.array[t*this.itemSize+e]=n,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=this._denormalize(e)),e}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=this._denormalize(e)),e}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=this._denormalize(e)),e}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=this._denormalize(e)),e}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,n){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n)),this.array[t+0]=e,this.array[t+1]=n,this}setXYZ(t,e,n,i){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n),i=this._normalize(i)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=i,this}setXYZW(t,e,n,i,r){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n),i=this._normalize(i),r=this._normalize(r)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=i,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return t.name=this.name,t.usage=this.usage,t.gpuType=this.gpuType,t}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):A0(t,this.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):R0(t,this.array)}};var cl=class extends Xe{constructor(t,e,n){super(new Uint16Array(t),e,n)}};var hl=class extends Xe{constructor(t,e,n){super(new Uint32Array(t),e,n)}};var Xt=class extends Xe{constructor(t,e,n){super(new Float32Array(t),e,n)}},Ub=new Oi,ja=new F,gf=new F,ji=class{constructor(t=new F,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let n=this.center;e!==void 0?n.copy(e):Ub.setFromPoints(t).getCenter(n);let i=0;for(let r=0,o=t.length;r<o;r++)i=Math.max(i,n.distanceToSquared(t[r]));return this.radius=Math.sqrt(i),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let n=this.center.distanceToSquared(t);return e.copy(t),n>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;ja.subVectors(t,this.center);let e=ja.lengthSq();if(e>this.radius*this.radius){let n=Math.sqrt(e),i=(n-this.radius)*.5;this.center.addScaledVector(ja,i/n),this.radius+=i}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(gf.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(ja.copy(t.center).add(gf)),this.expandByPoint(ja.copy(t.center).sub(gf))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},Fb=0,qi=new Gt,xf=new De,zo=new F,Fi=new Oi,Za=new Oi,Yn=new F,ue=class s extends fs{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:Fb++}),this.uuid=Lr(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(ab(t)?hl:cl)(t,1):this.index=t,this}setIndirect(t,e=0){return this.indirect=t,this.indirectOffset=e,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,n=0){this.groups.push({start:t,count:e,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let r=new ie().getNormalMatrix(t);n.applyNormalMatrix(r),n.needsUpdate=!0}let i=this.attributes.tangent;return i!==void 0&&(i.transformDirection(t),i.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(t){return qi.makeRotationFromQuaternion(t),this.applyMatrix4(qi),this}rotateX(t){return qi.makeRotationX(t),this.applyMatrix4(qi),this}rotateY(t){return qi.makeRotationY(t),this.applyMatrix4(qi),this}rotateZ(t){return qi.makeRotationZ(t),this.applyMatrix4(qi),this}translate(t,e,n){return qi.makeTranslation(t,e,n),this.applyMatrix4(qi),this}scale(t,e,n){return qi.makeScale(t,e,n),this.applyMatrix4(qi),this}lookAt(t){return xf.lookAt(t),xf.updateMatrix(),this.applyMatrix4(xf.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(zo).negate(),this.translate(zo.x,zo.y,zo.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let n=[];for(let i=0,r=t.length;i<r;i++){let o=t[i];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Xt(n,3))}else{let n=Math.min(t.length,e.count);for(let i=0;i<n;i++){let r=t[i];e.setXYZ(i,r.x,r.y,r.z||0)}t.length>e.count&&Zt("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Oi);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){te("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new F(-1/0,-1/0,-1/0),new F(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let n=0,i=e.length;n<i;n++){let r=e[n];Fi.setFromBufferAttribute(r),this.morphTargetsRelative?(Yn.addVectors(this.boundingBox.min,Fi.min),this.boundingBox.expandByPoint(Yn),Yn.addVectors(this.boundingBox.max,Fi.max),this.boundingBox.expandByPoint(Yn)):(this.boundingBox.expandByPoint(Fi.min),this.boundingBox.expandByPoint(Fi.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&te('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new ji);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){te("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new F,1/0);return}if(t){let n=this.boundingSphere.center;if(Fi.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){let a=e[r];Za.setFromBufferAttribute(a),this.morphTargetsRelative?(Yn.addVectors(Fi.min,Za.min),Fi.expandByPoint(Yn),Yn.addVectors(Fi.max,Za.max),Fi.expandByPoint(Yn)):(Fi.expandByPoint(Za.min),Fi.expandByPoint(Za.max))}Fi.getCenter(n);let i=0;for(let r=0,o=t.count;r<o;r++)Yn.fromBufferAttribute(t,r),i=Math.max(i,n.distanceToSquared(Yn));if(e)for(let r=0,o=e.length;r<o;r++){let a=e[r],c=this.morphTargetsRelative;for(let l=0,h=a.count;l<h;l++)Yn.fromBufferAttribute(a,l),c&&(zo.fromBufferAttribute(t,l),Yn.add(zo)),i=Math.max(i,n.distanceToSquared(Yn))}this.boundingSphere.radius=Math.sqrt(i),isNaN(this.boundingSphere.radius)&&te('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){te("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=e.position,i=e.normal,r=e.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==n.count)&&(o=new Xe(new Float32Array(4*n.count),4),this.setAttribute("tangent",o));let a=[],c=[],l=new Uint8Array(n.count);for(let I=0;I<n.count;I++)a[I]=new F,c[I]=new F;let h=new F,u=new F,d=new F,f=new Vt,g=new Vt,y=new Vt,p=new F,m=new F;function x(I,P,C){l[I]=l[P]=l[C]=1,h.fromBufferAttribute(n,I),u.fromBufferAttribute(n,P),d.fromBufferAttribute(n,C),f.fromBufferAttribute(r,I),g.fromBufferAttribute(r,P),y.fromBufferAttribute(r,C),u.sub(h),d.sub(h),g.sub(f),y.sub(f);let D=1/(g.x*y.y-y.x*g.y);isFinite(D)&&(p.copy(u).multiplyScalar(y.y).addScaledVector(d,-g.y).multiplyScalar(D),m.copy(d).multiplyScalar(g.x).addScaledVector(u,-y.x).multiplyScalar(D),a[I].add(p),a[P].add(p),a[C].add(p),c[I].add(m),c[P].add(m),c[C].add(m))}let v=this.groups;v.length===0&&(v=[{start:0,count:t.count}]);for(let I=0,P=v.length;I<P;++I){let C=v[I],D=C.start,B=C.count;for(let L=D,z=D+B;L<z;L+=3)x(t.getX(L+0),t.getX(L+1),t.getX(L+2))}let _=new F,E=new F,w=new F,b=new F;function M(I){w.fromBufferAttribute(i,I),b.copy(w);let P=a[I];_.copy(P),_.sub(w.multiplyScalar(w.dot(P))).normalize(),E.crossVectors(b,P);let D=E.dot(c[I])<0?-1:1;o.setXYZW(I,_.x,_.y,_.z,D)}for(let I=0,P=n.count;I<P;++I)l[I]&&M(I);this._transformed=!0}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==e.count)n=new Xe(new Float32Array(e.count*3),3),this.setAttribute("normal",n);else for(let d=0,f=n.count;d<f;d++)n.setXYZ(d,0,0,0);let i=new F,r=new F,o=new F,a=new F,c=new F,l=new F,h=new F,u=new F;if(t)for(let d=0,f=t.count;d<f;d+=3){let g=t.getX(d+0),y=t.getX(d+1),p=t.getX(d+2);i.fromBufferAttribute(e,g),r.fromBufferAttribute(e,y),o.fromBufferAttribute(e,p),h.subVectors(o,r),u.subVectors(i,r),h.cross(u),a.fromBufferAttribute(n,g),c.fromBufferAttribute(n,y),l.fromBufferAttribute(n,p),a.add(h),c.add(h),l.add(h),n.setXYZ(g,a.x,a.y,a.z),n.setXYZ(y,c.x,c.y,c.z),n.setXYZ(p,l.x,l.y,l.z)}else for(let d=0,f=e.count;d<f;d+=3)i.fromBufferAttribute(e,d+0),r.fromBufferAttribute(e,d+1),o.fromBufferAttribute(e,d+2),h.subVectors(o,r),u.subVectors(i,r),h.cross(u),n.setXYZ(d+0,h.x,h.y,h.z),n.setXYZ(d+1,h.x,h.y,h.z),n.setXYZ(d+2,h.x,h.y,h.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,n=t.count;e<n;e++)Yn.fromBufferAttribute(t,e),Yn.normalize(),t.setXYZ(e,Yn.x,Yn.y,Yn.z)}toNonIndexed(){function t(a,c){let l=a.array,h=a.itemSize,u=a.normalized,d=new l.constructor(c.length*h),f=0,g=0;for(let y=0,p=c.length;y<p;y++){a.isInterleavedBufferAttribute?f=c[y]*a.data.stride+a.offset:f=c[y]*h;for(let m=0;m<h;m++)d[g++]=l[f++]}return new Xe(d,h,u)}if(this.index===null)return Zt("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new s,n=this.index.array,i=this.attributes;for(let a in i){let c=i[a],l=t(c,n);e.setAttribute(a,l)}let r=this.morphAttributes;for(let a in r){let c=[],l=r[a];for(let h=0,u=l.length;h<u;h++){let d=l[h],f=t(d,n);c.push(f)}e.morphAttributes[a]=c}e.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,c=o.length;a<c;a++){let l=o[a];e.addGroup(l.start,l.count,l.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,t.name=this.name,Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let c=this.parameters;for(let l in c)c[l]!==void 0&&(t[l]=c[l]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let n=this.attributes;for(let c in n){let l=n[c];t.data.attributes[c]=l.toJSON(t.data)}let i={},r=!1;for(let c in this.morphAttributes){let l=this.morphAttributes[c],h=[];for(let u=0,d=l.length;u<d;u++){let f=l[u];h.push(f.toJSON(t.data))}h.length>0&&(i[c]=h,r=!0)}r&&(t.data.morphAttributes=i,t.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(t.data.boundingSphere=a.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let n=t.index;n!==null&&this.setIndex(n.clone());let i=t.attributes;for(let l in i){let h=i[l];this.setAttribute(l,h.clone(e))}let r=t.morphAttributes;for(let l in r){let h=[],u=r[l];for(let d=0,f=u.length;d<f;d++)h.push(u[d].clone(e));this.morphAttributes[l]=h}this.morphTargetsRelative=t.morphTargetsRelative;let o=t.groups;for(let l=0,h=o.length;l<h;l++){let u=o[l];this.addGroup(u.start,u.count,u.materialIndex)}let a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());let c=t.boundingSphere;return c!==null&&(this.boundingSphere=c.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this._transformed=t._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var _f=new F,kb=new F,Ob=new ie,xi=class{constructor(t=new F(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,n,i){return this.normal.set(t,e,n),this.constant=i,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,n){let i=_f.subVectors(n,e).cross(kb.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(i,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e,n=!0){let i=t.delta(_f),r=this.normal.dot(i);if(r===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let o=-(t.start.dot(this.normal)+this.constant)/r;return n===!0&&(o<0||o>1)?null:e.copy(t.start).addScaledVector(i,o)}intersectsLine(t){let e=this.distanceToPoint(t.start),n=this.distanceToPoint(t.end);return e<0&&n>0||n<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let n=e||Ob.getNormalMatrix(t),i=this.coplanarPoint(_f).applyMatrix4(t),r=this.normal.applyMatrix3(n).normalize();return this.constant=-i.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(t){return this.normal.fromArray(t.normal),this.constant=t.constant,this}},Bb=0,yi=class extends fs{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:Bb++}),this.uuid=Lr(),this.name="",this.type="Material",this.blending=fa,this.side=Ls,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=qf,this.blendDst=Yf,this.blendEquation=so,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new qt(0,0,0),this.blendAlpha=0,this.depthFunc=jo,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=g0,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=th,this.stencilZFail=th,this.stencilZPass=th,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let n=t[e];if(n===void 0){Zt(`Material: parameter '${e}' has value of undefined.`);continue}let i=this[e];if(i===void 0){Zt(`Material: '${e}' is not a property of THREE.${this.type}.`);continue}i&&i.isColor?i.set(n):i&&i.isVector2&&n&&n.isVector2||i&&i.isEuler&&n&&n.isEuler||i&&i.isVector3&&n&&n.isVector3?i.copy(n):this[e]=n}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(t).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(t).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(t).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(t).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(t).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(t).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function i(r){let o=[];for(let a in r){let c=r[a];delete c.metadata,o.push(c)}return o}if(e){let r=i(t.textures),o=i(t.images);r.length>0&&(n.textures=r),o.length>0&&(n.images=o)}return n}fromJSON(t,e){if(t.uuid!==void 0&&(this.uuid=t.uuid),t.name!==void 0&&(this.name=t.name),t.color!==void 0&&this.color!==void 0&&this.color.setHex(t.color),t.roughness!==void 0&&(this.roughness=t.roughness),t.metalness!==void 0&&(this.metalness=t.metalness),t.sheen!==void 0&&(this.sheen=t.sheen),t.sheenColor!==void 0&&(this.sheenColor=new qt().setHex(t.sheenColor)),t.sheenRoughness!==void 0&&(this.sheenRoughness=t.sheenRoughness),t.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(t.emissive),t.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(t.specular),t.specularIntensity!==void 0&&(this.specularIntensity=t.specularIntensity),t.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(t.specularColor),t.shininess!==void 0&&(this.shininess=t.shininess),t.clearcoat!==void 0&&(this.clearcoat=t.clearcoat),t.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=t.clearcoatRoughness),t.diffuseRoughness!==void 0&&(this.diffuseRoughness=t.diffuseRoughness),t.dispersion!==void 0&&(this.dispersion=t.dispersion),t.retroreflectivity!==void 0&&(this.retroreflectivity=t.retroreflectivity),t.iridescence!==void 0&&(this.iridescence=t.iridescence),t.iridescenceIOR!==void 0&&(this.iridescenceIOR=t.iridescenceIOR),t.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessMinimum),t.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=t.iridescenceThicknessMaximum),t.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=t.iridescenceThicknessRange[1]),t.transmission!==void 0&&(this.transmission=t.transmission),t.thickness!==void 0&&(this.thickness=t.thickness),t.attenuationDistance!==void 0&&(this.attenuationDistance=t.attenuationDistance),t.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(t.attenuationColor),t.anisotropy!==void 0&&(this.anisotropy=t.anisotropy),t.anisotropyRotation!==void 0&&(this.anisotropyRotation=t.anisotropyRotation),t.fog!==void 0&&(this.fog=t.fog),t.flatShading!==void 0&&(this.flatShading=t.flatShading),t.blending!==void 0&&(this.blending=t.blending),t.combine!==void 0&&(this.combine=t.combine),t.side!==void 0&&(this.side=t.side),t.shadowSide!==void 0&&(this.shadowSide=t.shadowSide),t.opacity!==void 0&&(this.opacity=t.opacity),t.transparent!==void 0&&(this.transparent=t.transparent),t.alphaTest!==void 0&&(this.alphaTest=t.alphaTest),t.alphaHash!==void 0&&(this.alphaHash=t.alphaHash),t.depthFunc!==void 0&&(this.depthFunc=t.depthFunc),t.depthTest!==void 0&&(this.depthTest=t.depthTest),t.depthWrite!==void 0&&(this.depthWrite=t.depthWrite),t.colorWrite!==void 0&&(this.colorWrite=t.colorWrite),t.clippingPlanes!==void 0&&(this.clippingPlanes=t.clippingPlanes.map(n=>new xi().fromJSON(n))),t.clipIntersection!==void 0&&(this.clipIntersection=t.clipIntersection),t.clipShadows!==void 0&&(this.clipShadows=t.clipShadows),t.depthPacking!==void 0&&(this.depthPacking=t.depthPacking),t.blendSrc!==void 0&&(this.blendSrc=t.blendSrc),t.blendDst!==void 0&&(this.blendDst=t.blendDst),t.blendEquation!==void 0&&(this.blendEquation=t.blendEquation),t.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=t.blendSrcAlpha),t.blendDstAlpha!==void 0&&(this.blendDstAlpha=t.blendDstAlpha),t.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=t.blendEquationAlpha),t.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(t.blendColor),t.blendAlpha!==void 0&&(this.blendAlpha=t.blendAlpha),t.stencilWriteMask!==void 0&&(this.stencilWriteMask=t.stencilWriteMask),t.stencilFunc!==void 0&&(this.stencilFunc=t.stencilFunc),t.stencilRef!==void 0&&(this.stencilRef=t.stencilRef),t.stencilFuncMask!==void 0&&(this.stencilFuncMask=t.stencilFuncMask),t.stencilFail!==void 0&&(this.stencilFail=t.stencilFail),t.stencilZFail!==void 0&&(this.stencilZFail=t.stencilZFail),t.stencilZPass!==void 0&&(this.stencilZPass=t.stencilZPass),t.stencilWrite!==void 0&&(this.stencilWrite=t.stencilWrite),t.wireframe!==void 0&&(this.wireframe=t.wireframe),t.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=t.wireframeLinewidth),t.wireframeLinecap!==void 0&&(this.wireframeLinecap=t.wireframeLinecap),t.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=t.wireframeLinejoin),t.rotation!==void 0&&(this.rotation=t.rotation),t.linewidth!==void 0&&(this.linewidth=t.linewidth),t.linecap!==void 0&&(this.linecap=t.linecap),t.linejoin!==void 0&&(this.linejoin=t.linejoin),t.dashSize!==void 0&&(this.dashSize=t.dashSize),t.gapSize!==void 0&&(this.gapSize=t.gapSize),t.scale!==void 0&&(this.scale=t.scale),t.polygonOffset!==void 0&&(this.polygonOffset=t.polygonOffset),t.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=t.polygonOffsetFactor),t.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=t.polygonOffsetUnits),t.dithering!==void 0&&(this.dithering=t.dithering),t.alphaToCoverage!==void 0&&(this.alphaToCoverage=t.alphaToCoverage),t.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=t.premultipliedAlpha),t.forceSinglePass!==void 0&&(this.forceSinglePass=t.forceSinglePass),t.allowOverride!==void 0&&(this.allowOverride=t.allowOverride),t.visible!==void 0&&(this.visible=t.visible),t.toneMapped!==void 0&&(this.toneMapped=t.toneMapped),t.userData!==void 0&&(this.userData=t.userData),t.vertexColors!==void 0&&(typeof t.vertexColors=="number"?this.vertexColors=t.vertexColors>0:this.vertexColors=t.vertexColors),t.size!==void 0&&(this.size=t.size),t.sizeAttenuation!==void 0&&(this.sizeAttenuation=t.sizeAttenuation),t.map!==void 0&&(this.map=e[t.map]||null),t.matcap!==void 0&&(this.matcap=e[t.matcap]||null),t.alphaMap!==void 0&&(this.alphaMap=e[t.alphaMap]||null),t.bumpMap!==void 0&&(this.bumpMap=e[t.bumpMap]||null),t.bumpScale!==void 0&&(this.bumpScale=t.bumpScale),t.normalMap!==void 0&&(this.normalMap=e[t.normalMap]||null),t.normalMapType!==void 0&&(this.normalMapType=t.normalMapType),t.normalScale!==void 0){let n=t.normalScale;Array.isArray(n)===!1&&(n=[n,n]),this.normalScale=new Vt().fromArray(n)}return t.displacementMap!==void 0&&(this.displacementMap=e[t.displacementMap]||null),t.displacementScale!==void 0&&(this.displacementScale=t.displacementScale),t.displacementBias!==void 0&&(this.displacementBias=t.displacementBias),t.roughnessMap!==void 0&&(this.roughnessMap=e[t.roughnessMap]||null),t.metalnessMap!==void 0&&(this.metalnessMap=e[t.metalnessMap]||null),t.emissiveMap!==void 0&&(this.emissiveMap=e[t.emissiveMap]||null),t.emissiveIntensity!==void 0&&(this.emissiveIntensity=t.emissiveIntensity),t.specularMap!==void 0&&(this.specularMap=e[t.specularMap]||null),t.specularIntensityMap!==void 0&&(this.specularIntensityMap=e[t.specularIntensityMap]||null),t.specularColorMap!==void 0&&(this.specularColorMap=e[t.specularColorMap]||null),t.envMap!==void 0&&(this.envMap=e[t.envMap]||null),t.envMapRotation!==void 0&&this.envMapRotation.fromArray(t.envMapRotation),t.envMapIntensity!==void 0&&(this.envMapIntensity=t.envMapIntensity),t.reflectivity!==void 0&&(this.reflectivity=t.reflectivity),t.refractionRatio!==void 0&&(this.refractionRatio=t.refractionRatio),t.lightMap!==void 0&&(this.lightMap=e[t.lightMap]||null),t.lightMapIntensity!==void 0&&(this.lightMapIntensity=t.lightMapIntensity),t.aoMap!==void 0&&(this.aoMap=e[t.aoMap]||null),t.aoMapIntensity!==void 0&&(this.aoMapIntensity=t.aoMapIntensity),t.gradientMap!==void 0&&(this.gradientMap=e[t.gradientMap]||null),t.clearcoatMap!==void 0&&(this.clearcoatMap=e[t.clearcoatMap]||null),t.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=e[t.clearcoatRoughnessMap]||null),t.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=e[t.clearcoatNormalMap]||null),t.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Vt().fromArray(t.clearcoatNormalScale)),t.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=e[t.diffuseRoughnessMap]||null),t.iridescenceMap!==void 0&&(this.iridescenceMap=e[t.iridescenceMap]||null),t.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=e[t.iridescenceThicknessMap]||null),t.transmissionMap!==void 0&&(this.transmissionMap=e[t.transmissionMap]||null),t.thicknessMap!==void 0&&(this.thicknessMap=e[t.thicknessMap]||null),t.anisotropyMap!==void 0&&(this.anisotropyMap=e[t.anisotropyMap]||null),t.sheenColorMap!==void 0&&(this.sheenColorMap=e[t.sheenColorMap]||null),t.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=e[t.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,n=null;if(e!==null){let i=e.length;n=new Array(i);for(let r=0;r!==i;++r)n[r]=e[r].clone()}return this.clippingPlanes=n,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.allowOverride=t.allowOverride,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}};var Ys=new F,yf=new F,Cc=new F,Pc=new F,Cs=class{constructor(t=new F,e=new F(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,Ys)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let n=e.dot(this.direction);return n<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=Ys.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(Ys.copy(this.origin).addScaledVector(this.direction,e),Ys.distanceToSquared(t))}distanceSqToSegment(t,e,n,i){yf.copy(t).add(e).multiplyScalar(.5),Cc.copy(e).sub(t).normalize(),Pc.copy(this.origin).sub(yf);let r=t.distanceTo(e)*.5,o=-this.direction.dot(Cc),a=Pc.dot(this.direction),c=-Pc.dot(Cc),l=Pc.lengthSq(),h=Math.abs(1-o*o),u,d,f,g;if(h>0)if(u=o*c-a,d=o*a-c,g=r*h,u>=0)if(d>=-g)if(d<=g){let y=1/h;u*=y,d*=y,f=u*(u+o*d+2*a)+d*(o*u+d+2*c)+l}else d=r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*c)+l;else d=-r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*c)+l;else d<=-g?(u=Math.max(0,-(-o*r+a)),d=u>0?-r:Math.min(Math.max(-r,-c),r),f=-u*u+d*(d+2*c)+l):d<=g?(u=0,d=Math.min(Math.max(-r,-c),r),f=d*(d+2*c)+l):(u=Math.max(0,-(o*r+a)),d=u>0?r:Math.min(Math.max(-r,-c),r),f=-u*u+d*(d+2*c)+l);else d=o>0?-r:r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*c)+l;return n&&n.copy(this.origin).addScaledVector(this.direction,u),i&&i.copy(yf).addScaledVector(Cc,d),f}intersectSphere(t,e){if(t.radius<0)return null;Ys.subVectors(t.center,this.origin);let n=Ys.dot(this.direction),i=Ys.dot(Ys)-n*n,r=t.radius*t.radius;if(i>r)return null;let o=Math.sqrt(r-i),a=n-o,c=n+o;return c<0?null:a<0?this.at(c,e):this.at(a,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(t.normal)+t.constant)/e;return n>=0?n:null}intersectPlane(t,e){let n=this.distanceToPlane(t);return n===null?null:this.at(n,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let n,i,r,o,a,c,l=1/this.direction.x,h=1/this.direction.y,u=1/this.direction.z,d=this.origin;return l>=0?(n=(t.min.x-d.x)*l,i=(t.max.x-d.x)*l):(n=(t.max.x-d.x)*l,i=(t.min.x-d.x)*l),h>=0?(r=(t.min.y-d.y)*h,o=(t.max.y-d.y)*h):(r=(t.max.y-d.y)*h,o=(t.min.y-d.y)*h),n>o||r>i||((r>n||isNaN(n))&&(n=r),(o<i||isNaN(i))&&(i=o),u>=0?(a=(t.min.z-d.z)*u,c=(t.max.z-d.z)*u):(a=(t.max.z-d.z)*u,c=(t.min.z-d.z)*u),n>c||a>i)||((a>n||n!==n)&&(n=a),(c<i||i!==i)&&(i=c),i<0)?null:this.at(n>=0?n:i,e)}intersectsBox(t){return this.intersectBox(t,Ys)!==null}intersectTriangle(t,e,n,i,r){let o=this.origin,a=this.direction,c=a.x,l=a.y,h=a.z,u=t.x-o.x,d=t.y-o.y,f=t.z-o.z,g=e.x-o.x,y=e.y-o.y,p=e.z-o.z,m=n.x-o.x,x=n.y-o.y,v=n.z-o.z,_=Math.abs(c),E=Math.abs(l),w=Math.abs(h),b,M,I,P,C,D,B,L,z,O,H,tt;if(_>=E&&_>=w?(I=c,D=u,z=g,tt=m,c>=0?(b=l,M=h,P=d,C=f,B=y,L=p,O=x,H=v):(b=h,M=l,P=f,C=d,B=p,L=y,O=v,H=x)):E>=w?(I=l,D=d,z=y,tt=x,l>=0?(b=h,M=c,P=f,C=u,B=p,L=g,O=v,H=m):(b=c,M=h,P=u,C=f,B=g,L=p,O=m,H=v)):(I=h,D=f,z=p,tt=v,h>=0?(b=c,M=l,P=u,C=d,B=g,L=y,O=m,H=x):(b=l,M=c,P=d,C=u,B=y,L=g,O=x,H=m)),I===0)return null;let X=b/I,Z=M/I,$=1/I,at=P-X*D,it=C-Z*D,Y=B-X*z,st=L-Z*z,nt=O-X*tt,lt=H-Z*tt,mt=nt*st-lt*Y,Ut=at*lt-it*nt,Jt=Y*it-st*at;if(i){if(mt<0||Ut<0||Jt<0)return null}else if((mt<0||Ut<0||Jt<0)&&(mt>0||Ut>0||Jt>0))return null;let Ot=mt+Ut+Jt;if(Ot===0)return null;let me=$*(mt*D+Ut*z+Jt*tt);return(Ot>0?me<0:me>0)?null:this.at(me/Ot,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},Qe=class extends yi{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new qt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new ti,this.combine=Il,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}},hg=new Gt,Gr=new Cs,Ic=new ji,ug=new F,Lc=new F,Nc=new F,Dc=new F,bf=new F,Uc=new F,dg=new F,Fc=new F,gt=class extends De{constructor(t=new ue,e=new Qe){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let i=e[n[0]];if(i!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=i.length;r<o;r++){let a=i[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){let n=this.geometry,i=n.attributes.position,r=n.morphAttributes.position,o=n.morphTargetsRelative;e.fromBufferAttribute(i,t);let a=this.morphTargetInfluences;if(r&&a){Uc.set(0,0,0);for(let c=0,l=r.length;c<l;c++){let h=a[c],u=r[c];h!==0&&(bf.fromBufferAttribute(u,t),o?Uc.addScaledVector(bf,h):Uc.addScaledVector(bf.sub(e),h))}e.add(Uc)}return e}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let n=this.geometry,i=this.material,r=this.matrixWorld;i!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),Ic.copy(n.boundingSphere),Ic.applyMatrix4(r),Gr.copy(t.ray).recast(t.near),!(Ic.containsPoint(Gr.origin)===!1&&(Gr.intersectSphere(Ic,ug)===null||Gr.origin.distanceToSquared(ug)>(t.far-t.near)**2))&&(hg.copy(r).invert(),Gr.copy(t.ray).applyMatrix4(hg),!(n.boundingBox!==null&&Gr.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(t,e,Gr)))}_computeIntersections(t,e,n){let i,r=this.geometry,o=this.material,a=r.index,c=r.attributes.position,l=r.attributes.uv,h=r.attributes.uv1,u=r.attributes.normal,d=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let g=0,y=d.length;g<y;g++){let p=d[g],m=o[p.materialIndex],x=Math.max(p.start,f.start),v=Math.min(a.count,Math.min(p.start+p.count,f.start+f.count));for(let _=x,E=v;_<E;_+=3){let w=a.getX(_),b=a.getX(_+1),M=a.getX(_+2);i=kc(this,m,t,n,l,h,u,w,b,M),i&&(i.faceIndex=Math.floor(_/3),i.face.materialIndex=p.materialIndex,e.push(i))}}else{let g=Math.max(0,f.start),y=Math.min(a.count,f.start+f.count);for(let p=g,m=y;p<m;p+=3){let x=a.getX(p),v=a.getX(p+1),_=a.getX(p+2);i=kc(this,o,t,n,l,h,u,x,v,_),i&&(i.faceIndex=Math.floor(p/3),e.push(i))}}else if(c!==void 0)if(Array.isArray(o))for(let g=0,y=d.length;g<y;g++){let p=d[g],m=o[p.materialIndex],x=Math.max(p.start,f.start),v=Math.min(c.count,Math.min(p.start+p.count,f.start+f.count));for(let _=x,E=v;_<E;_+=3){let w=_,b=_+1,M=_+2;i=kc(this,m,t,n,l,h,u,w,b,M),i&&(i.faceIndex=Math.floor(_/3),i.face.materialIndex=p.materialIndex,e.push(i))}}else{let g=Math.max(0,f.start),y=Math.min(c.count,f.start+f.count);for(let p=g,m=y;p<m;p+=3){let x=p,v=p+1,_=p+2;i=kc(this,o,t,n,l,h,u,x,v,_),i&&(i.faceIndex=Math.floor(p/3),e.push(i))}}}};function zb(s,t,e,n,i,r,o,a){let c;if(t.side===bi?c=n.intersectTriangle(o,r,i,!0,a):c=n.intersectTriangle(i,r,o,t.side===Ls,a),c===null)return null;Fc.copy(a),Fc.applyMatrix4(s.matrixWorld);let l=e.ray.origin.distanceTo(Fc);return l<e.near||l>e.far?null:{distance:l,point:Fc.clone(),object:s}}function kc(s,t,e,n,i,r,o,a,c,l){s.getVertexPosition(a,Lc),s.getVertexPosition(c,Nc),s.getVertexPosition(l,Dc);let h=zb(s,t,e,n,Lc,Nc,Dc,dg);if(h){let u=new F;us.getBarycoord(dg,Lc,Nc,Dc,u),i&&(h.uv=us.getInterpolatedAttribute(i,a,c,l,u,new Vt)),r&&(h.uv1=us.getInterpolatedAttribute(r,a,c,l,u,new Vt)),o&&(h.normal=us.getInterpolatedAttribute(o,a,c,l,u,new F),h.normal.dot(n.direction)>0&&h.normal.multiplyScalar(-1));let d={a,b:c,c:l,normal:new F,materialIndex:0};us.getNormal(Lc,Nc,Dc,d.normal),h.face=d,h.barycoord=u}return h}var $a=new ze,fg=new ze,pg=new ze,Hb=new ze,mg=new Gt,Oc=new F,vf=new ji,gg=new Gt,wf=new Cs,ul=class extends gt{constructor(t,e){super(t,e),this.isSkinnedMesh=!0,this.type="SkinnedMesh",this.bindMode=Af,this.bindMatrix=new Gt,this.bindMatrixInverse=new Gt,this.boundingBox=null,this.boundingSphere=null}computeBoundingBox(){let t=this.geometry;this.boundingBox===null&&(this.boundingBox=new Oi),this.boundingBox.makeEmpty();let e=t.getAttribute("position");for(let n=0;n<e.count;n++)this.getVertexPosition(n,Oc),this.boundingBox.expandByPoint(Oc)}computeBoundingSphere(){let t=this.geometry;this.boundingSphere===null&&(this.boundingSphere=new ji),this.boundingSphere.makeEmpty();let e=t.getAttribute("position");for(let n=0;n<e.count;n++)this.getVertexPosition(n,Oc),this.boundingSphere.expandByPoint(Oc)}copy(t,e){return super.copy(t,e),this.bindMode=t.bindMode,this.bindMatrix.copy(t.bindMatrix),this.bindMatrixInverse.copy(t.bindMatrixInverse),this.skeleton=t.skeleton,this.boundingBox=t.boundingBox!==null?t.boundingBox.clone():null,this.boundingSphere=t.boundingSphere!==null?t.boundingSphere.clone():null,this}raycast(t,e){let n=this.material,i=this.matrixWorld;n!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),vf.copy(this.boundingSphere),vf.applyMatrix4(i),t.ray.intersectsSphere(vf)!==!1&&(gg.copy(i).invert(),wf.copy(t.ray).applyMatrix4(gg),!(this.boundingBox!==null&&wf.intersectsBox(this.boundingBox)===!1)&&this._computeIntersections(t,e,wf)))}getVertexPosition(t,e){return super.getVertexPosition(t,e),this.applyBoneTransform(t,e),e}bind(t,e){this.skeleton=t,e===void 0&&(this.updateMatrixWorld(!0),this.skeleton.calculateInverses(),e=this.matrixWorld),this.bindMatrix.copy(e),this.bindMatrixInverse.copy(e).invert()}pose(){this.skeleton.pose()}normalizeSkinWeights(){let t=new ze,e=this.geometry.attributes.skinWeight;for(let n=0,i=e.count;n<i;n++){t.fromBufferAttribute(e,n);let r=1/t.manhattanLength();r!==1/0?t.multiplyScalar(r):t.set(1,0,0,0),e.setXYZW(n,t.x,t.y,t.z,t.w)}}updateMatrixWorld(t){super.updateMatrixWorld(t),this.bindMode===Af?this.bindMatrixInverse.copy(this.matrixWorld).invert():this.bindMode===u0?this.bindMatrixInverse.copy(this.bindMatrix).invert():Zt("SkinnedMesh: Unrecognized bindMode: "+this.bindMode)}applyBoneTransform(t,e){let n=this.skeleton,i=this.geometry;fg.fromBufferAttribute(i.attributes.skinIndex,t),pg.fromBufferAttribute(i.attributes.skinWeight,t),e.isVector4?($a.copy(e),e.set(0,0,0,0)):($a.set(e.x,e.y,e.z,1),e.set(0,0,0)),$a.applyMatrix4(this.bindMatrix);for(let r=0;r<4;r++){let o=pg.getComponent(r);if(o!==0){let a=fg.getComponent(r);mg.multiplyMatrices(n.bones[a].matrixWorld,n.boneInverses[a]),e.addScaledVector(Hb.copy($a).applyMatrix4(mg),o)}}return e.isVector4&&(e.w=$a.w),e.applyMatrix4(this.bindMatrixInverse)}},ea=class extends De{constructor(){super(),this.isBone=!0,this.type="Bone"}},wr=class extends ri{constructor(t=null,e=1,n=1,i,r,o,a,c,l=Zn,h=Zn,u,d){super(null,o,a,c,l,h,i,r,u,d),this.isDataTexture=!0,this.image={data:t,width:e,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}},xg=new Gt,Vb=new Gt,dl=class s{constructor(t=[],e=[]){this.uuid=Lr(),this.bones=t.slice(0),this.boneInverses=e,this.boneMatrices=null,this.previousBoneMatrices=null,this.boneTexture=null,this.previousBoneTexture=null,this.init()}init(){let t=this.bones,e=this.boneInverses;if(this.boneMatrices=new Float32Array(t.length*16),e.length===0)this.calculateInverses();else if(t.length!==e.length){Zt("Skeleton: Number of inverse bone matrices does not match amount of bones."),this.boneInverses=[];for(let n=0,i=this.bones.length;n<i;n++)this.boneInverses.push(new Gt)}}calculateInverses(){this.boneInverses.length=0;for(let t=0,e=this.bones.length;t<e;t++){let n=new Gt;this.bones[t]&&n.copy(this.bones[t].matrixWorld).invert(),this.boneInverses.push(n)}}pose(){for(let t=0,e=this.bones.length;t<e;t++){let n=this.bones[t];n&&n.matrixWorld.copy(this.boneInverses[t]).invert()}for(let t=0,e=this.bones.length;t<e;t++){let n=this.bones[t];n&&(n.parent&&n.parent.isBone?(n.matrix.copy(n.parent.matrixWorld).invert(),n.matrix.multiply(n.matrixWorld)):n.matrix.copy(n.matrixWorld),n.matrix.decompose(n.position,n.quaternion,n.scale))}}update(){let t=this.bones,e=this.boneInverses,n=this.boneMatrices,i=this.boneTexture;for(let r=0,o=t.length;r<o;r++){let a=t[r]?t[r].matrixWorld:Vb;xg.multiplyMatrices(a,e[r]),xg.toArray(n,r*16)}i!==null&&(i.needsUpdate=!0)}clone(){return new s(this.bones,this.boneInverses)}computeBoneTexture(){let t=Math.sqrt(this.bones.length*4);t=Math.ceil(t/4)*4,t=Math.max(t,4);let e=new Float32Array(t*t*4);e.set(this.boneMatrices);let n=new wr(e,t,t,Qi,Bi);return n.needsUpdate=!0,this.boneMatrices=e,this.boneTexture=n,this}getBoneByName(t){for(let e=0,n=this.bones.length;e<n;e++){let i=this.bones[e];if(i.name===t)return i}}dispose(){this.boneTexture!==null&&(this.boneTexture.dispose(),this.boneTexture=null),this.previousBoneTexture!==null&&(this.previousBoneTexture.dispose(),this.previousBoneTexture=null)}fromJSON(t,e){this.uuid=t.uuid;for(let n=0,i=t.bones.length;n<i;n++){let r=t.bones[n],o=e[r];o===void 0&&(Zt("Skeleton: No bone found with UUID:",r),o=new ea),this.bones.push(o),this.boneInverses.push(new Gt().fromArray(t.boneInverses[n]))}return this.init(),this}toJSON(){let t={metadata:{version:4.7,type:"Skeleton",generator:"Skeleton.toJSON"},bones:[],boneInverses:[]};t.uuid=this.uuid;let e=this.bones,n=this.boneInverses;for(let i=0,r=e.length;i<r;i++){let o=e[i];t.bones.push(o.uuid);let a=n[i];t.boneInverses.push(a.toArray())}return t}},na=class extends Xe{constructor(t,e,n,i=1){super(t,e,n),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=i}copy(t){return super.copy(t),this.meshPerAttribute=t.meshPerAttribute,this}toJSON(){let t=super.toJSON();return t.meshPerAttribute=this.meshPerAttribute,t.isInstancedBufferAttribute=!0,t}},Ho=new Gt,_g=new Gt,Bc=[],yg=new Oi,Gb=new Gt,Ja=new gt,Ka=new ji,Sr=class extends gt{constructor(t,e,n){super(t,e),this.isInstancedMesh=!0,this.instanceMatrix=new na(new Float32Array(n*16),16),this.instanceColor=null,this.morphTexture=null,this.count=n,this.boundingBox=null,this.boundingSphere=null;for(let i=0;i<n;i++)this.setMatrixAt(i,Gb)}computeBoundingBox(){let t=this.geometry,e=this.count;this.boundingBox===null&&(this.boundingBox=new Oi),t.boundingBox===null&&t.computeBoundingBox(),this.boundingBox.makeEmpty();for(let n=0;n<e;n++)this.getMatrixAt(n,Ho),yg.copy(t.boundingBox).applyMatrix4(Ho),this.boundingBox.union(yg)}computeBoundingSphere(){let t=this.geometry,e=this.count;this.boundingSphere===null&&(this.boundingSphere=new ji),t.boundingSphere===null&&t.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let n=0;n<e;n++)this.getMatrixAt(n,Ho),Ka.copy(t.boundingSphere).applyMatrix4(Ho),this.boundingSphere.union(Ka)}copy(t,e){return super.copy(t,e),this.instanceMatrix.copy(t.instanceMatrix),this.morphTexture=t.morphTexture!==null?t.morphTexture.clone():null,this.instanceColor=t.instanceColor!==null?t.instanceColor.clone():null,this.count=t.count,this.boundingBox=t.boundingBox!==null?t.boundingBox.clone():null,this.boundingSphere=t.boundingSphere!==null?t.boundingSphere.clone():null,this}getColorAt(t,e){return this.instanceColor===null?e.setRGB(1,1,1):e.fromArray(this.instanceColor.array,t*3)}getMatrixAt(t,e){return e.fromArray(this.instanceMatrix.array,t*16)}getMorphAt(t,e){let n=e.morphTargetInfluences,i=this.morphTexture.source.data.data,r=n.length+1,o=t*r+1;for(let a=0;a<n.length;a++)n[a]=i[o+a]}raycast(t,e){let n=this.matrixWorld,i=this.count;if(Ja.geometry=this.geometry,Ja.material=this.material,Ja.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),Ka.copy(this.boundingSphere),Ka.applyMatrix4(n),t.ray.intersectsSphere(Ka)!==!1))for(let r=0;r<i;r++){this.getMatrixAt(r,Ho),_g.multiplyMatrices(n,Ho),Ja.matrixWorld=_g,Ja.raycast(t,Bc);for(let o=0,a=Bc.length;o<a;o++){let c=Bc[o];c.instanceId=r,c.object=this,e.push(c)}Bc.length=0}}setColorAt(t,e){return this.instanceColor===null&&(this.instanceColor=new na(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),e.toArray(this.instanceColor.array,t*3),this}setMatrixAt(t,e){return e.toArray(this.instanceMatrix.array,t*16),this}setMorphAt(t,e){let n=e.morphTargetInfluences,i=n.length+1;this.morphTexture===null&&(this.morphTexture=new wr(new Float32Array(i*this.count),i,this.count,Nh,Bi));let r=this.morphTexture.source.data.data,o=0;for(let l=0;l<n.length;l++)o+=n[l];let a=this.geometry.morphTargetsRelative?1:1-o,c=i*t;return r[c]=a,r.set(n,c+1),this}updateMorphTargets(){}dispose(){super.dispose(),this.instanceMatrix.dispose(),this.instanceColor!==null&&this.instanceColor.dispose(),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}},Wr=new ji,Wb=new Vt(.5,.5),zc=new F,Mr=class{constructor(t=new xi,e=new xi,n=new xi,i=new xi,r=new xi,o=new xi){this.planes=[t,e,n,i,r,o]}set(t,e,n,i,r,o){let a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(n),a[3].copy(i),a[4].copy(r),a[5].copy(o),this}copy(t){let e=this.planes;for(let n=0;n<6;n++)e[n].copy(t.planes[n]);return this}setFromProjectionMatrix(t,e=Yi,n=!1){let i=this.planes,r=t.elements,o=r[0],a=r[1],c=r[2],l=r[3],h=r[4],u=r[5],d=r[6],f=r[7],g=r[8],y=r[9],p=r[10],m=r[11],x=r[12],v=r[13],_=r[14],E=r[15];if(i[0].setComponents(l-o,f-h,m-g,E-x).normalize(),i[1].setComponents(l+o,f+h,m+g,E+x).normalize(),i[2].setComponents(l+a,f+u,m+y,E+v).normalize(),i[3].setComponents(l-a,f-u,m-y,E-v).normalize(),n)i[4].setComponents(c,d,p,_).normalize(),i[5].setComponents(l-c,f-d,m-p,E-_).normalize();else if(i[4].setComponents(l-c,f-d,m-p,E-_).normalize(),e===Yi)i[5].setComponents(l+c,f+d,m+p,E+_).normalize();else if(e===Zo)i[5].setComponents(c,d,p,_).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),Wr.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),Wr.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(Wr)}intersectsSprite(t){Wr.center.set(0,0,0);let e=Wb.distanceTo(t.center);return Wr.radius=.7071067811865476+e,Wr.applyMatrix4(t.matrixWorld),this.intersectsSphere(Wr)}intersectsSphere(t){let e=this.planes,n=t.center,i=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(n)<i)return!1;return!0}intersectsBox(t){let e=this.planes;for(let n=0;n<6;n++){let i=e[n];if(zc.x=i.normal.x>0?t.max.x:t.min.x,zc.y=i.normal.y>0?t.max.y:t.min.y,zc.z=i.normal.z>0?t.max.z:t.min.z,i.distanceToPoint(zc)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let n=0;n<6;n++)if(e[n].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},bg=new Gt,fh=class s{constructor(){this.coordinateSystem=Yi,this._frustums=[],this._count=0}setFromArrayCamera(t){let e=t.cameras,n=this._frustums;for(let i=0;i<e.length;i++){let r=e[i];bg.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),n[i]===void 0&&(n[i]=new Mr),n[i].setFromProjectionMatrix(bg,r.coordinateSystem,r.reversedDepth)}return this._count=e.length,this}getFrustum(t){return this._frustums[t]}intersectsObject(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsObject(t))return!0;return!1}intersectsSprite(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsSprite(t))return!0;return!1}intersectsSphere(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsSphere(t))return!0;return!1}intersectsBox(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsBox(t))return!0;return!1}containsPoint(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].containsPoint(t))return!0;return!1}copy(t){this.coordinateSystem=t.coordinateSystem;let e=this._frustums,n=t._frustums;for(let i=0;i<t._count;i++)e[i]===void 0&&(e[i]=new Mr),e[i].copy(n[i]);return this._count=t._count,this}clone(){return new s().copy(this)}};var pn=class extends yi{constructor(t){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new qt(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}},ph=new F,mh=new F,vg=new Gt,Qa=new Cs,Hc=new ji,Sf=new F,wg=new F,Fn=class extends De{constructor(t=new ue,e=new pn){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,n=[0];for(let i=1,r=e.count;i<r;i++)ph.fromBufferAttribute(e,i-1),mh.fromBufferAttribute(e,i),n[i]=n[i-1],n[i]+=ph.distanceTo(mh);t.setAttribute("lineDistance",new Xt(n,1))}else Zt("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let n=this.geometry,i=this.matrixWorld,r=t.params.Line.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),Hc.copy(n.boundingSphere),Hc.applyMatrix4(i),Hc.radius+=r,t.ray.intersectsSphere(Hc)===!1)return;vg.copy(i).invert(),Qa.copy(t.ray).applyMatrix4(vg);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),c=a*a,l=this.isLineSegments?2:1,h=n.index,d=n.attributes.position;if(h!==null){let f=Math.max(0,o.start),g=Math.min(h.count,o.start+o.count);for(let y=f,p=g-1;y<p;y+=l){let m=h.getX(y),x=h.getX(y+1),v=Vc(this,t,Qa,c,m,x,y);v&&e.push(v)}if(this.isLineLoop){let y=h.getX(g-1),p=h.getX(f),m=Vc(this,t,Qa,c,y,p,g-1);m&&e.push(m)}}else{let f=Math.max(0,o.start),g=Math.min(d.count,o.start+o.count);for(let y=f,p=g-1;y<p;y+=l){let m=Vc(this,t,Qa,c,y,y+1,y);m&&e.push(m)}if(this.isLineLoop){let y=Vc(this,t,Qa,c,g-1,f,g-1);y&&e.push(y)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let i=e[n[0]];if(i!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=i.length;r<o;r++){let a=i[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Vc(s,t,e,n,i,r,o){let a=s.geometry.attributes.position;if(ph.fromBufferAttribute(a,i),mh.fromBufferAttribute(a,r),e.distanceSqToSegment(ph,mh,Sf,wg)>n)return;Sf.applyMatrix4(s.matrixWorld);let l=t.ray.origin.distanceTo(Sf);if(!(l<t.near||l>t.far))return{distance:l,point:wg.clone().applyMatrix4(s.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:s}}var Sg=new F,Mg=new F,Ti=class extends Fn{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,n=[];for(let i=0,r=e.count;i<r;i+=2)Sg.fromBufferAttribute(e,i),Mg.fromBufferAttribute(e,i+1),n[i]=i===0?0:n[i-1],n[i+1]=n[i]+Sg.distanceTo(Mg);t.setAttribute("lineDistance",new Xt(n,1))}else Zt("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}},jr=class extends Fn{constructor(t,e){super(t,e),this.isLineLoop=!0,this.type="LineLoop"}},ps=class extends yi{constructor(t){super(),this.isPointsMaterial=!0,this.type="PointsMaterial",this.color=new qt(16777215),this.map=null,this.alphaMap=null,this.size=1,this.sizeAttenuation=!0,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.alphaMap=t.alphaMap,this.size=t.size,this.sizeAttenuation=t.sizeAttenuation,this.fog=t.fog,this}},Eg=new Gt,If=new Cs,Gc=new ji,Wc=new F,Js=class extends De{constructor(t=new ue,e=new ps){super(),this.isPoints=!0,this.type="Points",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let n=this.geometry,i=this.matrixWorld,r=t.params.Points.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),Gc.copy(n.boundingSphere),Gc.applyMatrix4(i),Gc.radius+=r,t.ray.intersectsSphere(Gc)===!1)return;Eg.copy(i).invert(),If.copy(t.ray).applyMatrix4(Eg);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),c=a*a,l=n.index,u=n.attributes.position;if(l!==null){let d=Math.max(0,o.start),f=Math.min(l.count,o.start+o.count);for(let g=d,y=f;g<y;g++){let p=l.getX(g);Wc.fromBufferAttribute(u,p),Tg(Wc,p,c,i,t,e,this)}}else{let d=Math.max(0,o.start),f=Math.min(u.count,o.start+o.count);for(let g=d,y=f;g<y;g++)Wc.fromBufferAttribute(u,g),Tg(Wc,g,c,i,t,e,this)}}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let i=e[n[0]];if(i!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=i.length;r<o;r++){let a=i[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Tg(s,t,e,n,i,r,o){let a=If.distanceSqToPoint(s);if(a<e){let c=new F;If.closestPointToPoint(s,c),c.applyMatrix4(n);let l=i.ray.origin.distanceTo(c);if(l<i.near||l>i.far)return;r.push({distance:l,distanceToRay:Math.sqrt(a),point:c,index:t,face:null,faceIndex:null,barycoord:null,object:o})}}var fl=class extends ri{constructor(t=[],e=ro,n,i,r,o,a,c,l,h){super(t,e,n,i,r,o,a,c,l,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}},pl=class extends ri{constructor(t,e,n,i,r,o,a,c,l){super(t,e,n,i,r,o,a,c,l),this.isCanvasTexture=!0,this.needsUpdate=!0}};var Ks=class extends ri{constructor(t,e,n=ms,i,r,o,a=Zn,c=Zn,l,h=$s,u=1){if(h!==$s&&h!==rr)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let d={width:t,height:e,depth:u};super(d,i,r,o,a,c,h,n,l),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new Ko(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return e.compareFunction=this.compareFunction,e}},ml=class extends Ks{constructor(t,e=ms,n=ro,i,r,o=Zn,a=Zn,c,l=$s){let h={width:t,height:t,depth:1},u=[h,h,h,h,h,h];super(t,t,e,n,i,r,o,a,c,l),this.image=u,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(t){this.image=t}},gl=class extends ri{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}},qe=class s extends ue{constructor(t=1,e=1,n=1,i=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:n,widthSegments:i,heightSegments:r,depthSegments:o};let a=this;i=Math.floor(i),r=Math.floor(r),o=Math.floor(o);let c=[],l=[],h=[],u=[],d=0,f=0;g("z","y","x",-1,-1,n,e,t,o,r,0),g("z","y","x",1,-1,n,e,-t,o,r,1),g("x","z","y",1,1,t,n,e,i,o,2),g("x","z","y",1,-1,t,n,-e,i,o,3),g("x","y","z",1,-1,t,e,n,i,r,4),g("x","y","z",-1,-1,t,e,-n,i,r,5),this.setIndex(c),this.setAttribute("position",new Xt(l,3)),this.setAttribute("normal",new Xt(h,3)),this.setAttribute("uv",new Xt(u,2));function g(y,p,m,x,v,_,E,w,b,M,I){let P=_/b,C=E/M,D=_/2,B=E/2,L=w/2,z=b+1,O=M+1,H=0,tt=0,X=new F;for(let Z=0;Z<O;Z++){let $=Z*C-B;for(let at=0;at<z;at++){let it=at*P-D;X[y]=it*x,X[p]=$*v,X[m]=L,l.push(X.x,X.y,X.z),X[y]=0,X[p]=0,X[m]=w>0?1:-1,h.push(X.x,X.y,X.z),u.push(at/b),u.push(1-Z/M),H+=1}}for(let Z=0;Z<M;Z++)for(let $=0;$<b;$++){let at=d+$+z*Z,it=d+$+z*(Z+1),Y=d+($+1)+z*(Z+1),st=d+($+1)+z*Z;c.push(at,it,st),c.push(it,Y,st),tt+=6}a.addGroup(f,tt,I),f+=tt,d+=H}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new s(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}};var xl=class s extends ue{constructor(t=1,e=32,n=0,i=Math.PI*2){super(),this.type="CircleGeometry",this.parameters={radius:t,segments:e,thetaStart:n,thetaLength:i},e=Math.max(3,e);let r=[],o=[],a=[],c=[],l=new F,h=new Vt;o.push(0,0,0),a.push(0,0,1),c.push(.5,.5);for(let u=0,d=3;u<=e;u++,d+=3){let f=n+u/e*i;l.x=t*Math.cos(f),l.y=t*Math.sin(f),o.push(l.x,l.y,l.z),a.push(0,0,1),h.x=(o[d]/t+1)/2,h.y=(o[d+1]/t+1)/2,c.push(h.x,h.y)}for(let u=1;u<=e;u++)r.push(u,u+1,0);this.setIndex(r),this.setAttribute("position",new Xt(o,3)),this.setAttribute("normal",new Xt(a,3)),this.setAttribute("uv",new Xt(c,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new s(t.radius,t.segments,t.thetaStart,t.thetaLength)}},Ye=class s extends ue{constructor(t=1,e=1,n=1,i=32,r=1,o=!1,a=0,c=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:t,radiusBottom:e,height:n,radialSegments:i,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:c};let l=this;i=Math.floor(i),r=Math.floor(r);let h=[],u=[],d=[],f=[],g=0,y=[],p=n/2,m=0;x(),o===!1&&(t>0&&v(!0),e>0&&v(!1)),this.setIndex(h),this.setAttribute("position",new Xt(u,3)),this.setAttribute("normal",new Xt(d,3)),this.setAttribute("uv",new Xt(f,2));function x(){let _=new F,E=new F,w=0,b=(e-t)/n;for(let M=0;M<=r;M++){let I=[],P=M/r,C=P*(e-t)+t;for(let D=0;D<=i;D++){let B=D/i,L=B*c+a,z=Math.sin(L),O=Math.cos(L);E.x=C*z,E.y=-P*n+p,E.z=C*O,u.push(E.x,E.y,E.z),_.set(z,b,O).normalize(),d.push(_.x,_.y,_.z),f.push(B,1-P),I.push(g++)}y.push(I)}for(let M=0;M<i;M++)for(let I=0;I<r;I++){let P=y[I][M],C=y[I+1][M],D=y[I+1][M+1],B=y[I][M+1];(t>0||I!==0)&&(h.push(P,C,B),w+=3),(e>0||I!==r-1)&&(h.push(C,D,B),w+=3)}l.addGroup(m,w,0),m+=w}function v(_){let E=g,w=new Vt,b=new F,M=0,I=_===!0?t:e,P=_===!0?1:-1;for(let D=1;D<=i;D++)u.push(0,p*P,0),d.push(0,P,0),f.push(.5,.5),g++;let C=g;for(let D=0;D<=i;D++){let L=D/i*c+a,z=Math.cos(L),O=Math.sin(L);b.x=I*O,b.y=p*P,b.z=I*z,u.push(b.x,b.y,b.z),d.push(0,P,0),w.x=z*.5+.5,w.y=O*.5*P+.5,f.push(w.x,w.y),g++}for(let D=0;D<i;D++){let B=E+D,L=C+D;_===!0?h.push(L,L+1,B):h.push(L+1,L,B),M+=3}l.addGroup(m,M,_===!0?1:2),m+=M}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new s(t.radiusTop,t.radiusBottom,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}},ia=class s extends Ye{constructor(t=1,e=1,n=32,i=1,r=!1,o=0,a=Math.PI*2){super(0,t,e,n,i,r,o,a),this.type="ConeGeometry",this.parameters={radius:t,height:e,radialSegments:n,heightSegments:i,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(t){return new s(t.radius,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}},gh=class s extends ue{constructor(t=[],e=[],n=1,i=0){super(),this.type="PolyhedronGeometry",this.parameters={vertices:t,indices:e,radius:n,detail:i};let r=[],o=[];a(i),l(n),h(),this.setAttribute("position",new Xt(r,3)),this.setAttribute("normal",new Xt(r.slice(),3)),this.setAttribute("uv",new Xt(o,2)),i===0?this.computeVertexNormals():this.normalizeNormals();function a(x){let v=new F,_=new F,E=new F;for(let w=0;w<e.length;w+=3)f(e[w+0],v),f(e[w+1],_),f(e[w+2],E),c(v,_,E,x)}function c(x,v,_,E){let w=E+1,b=[];for(let M=0;M<=w;M++){b[M]=[];let I=x.clone().lerp(_,M/w),P=v.clone().lerp(_,M/w),C=w-M;for(let D=0;D<=C;D++)D===0&&M===w?b[M][D]=I:b[M][D]=I.clone().lerp(P,D/C)}for(let M=0;M<w;M++)for(let I=0;I<2*(w-M)-1;I++){let P=Math.floor(I/2);I%2===0?(d(b[M][P+1]),d(b[M+1][P]),d(b[M][P])):(d(b[M][P+1]),d(b[M+1][P+1]),d(b[M+1][P]))}}function l(x){let v=new F;for(let _=0;_<r.length;_+=3)v.x=r[_+0],v.y=r[_+1],v.z=r[_+2],v.normalize().multiplyScalar(x),r[_+0]=v.x,r[_+1]=v.y,r[_+2]=v.z}function h(){let x=new F;for(let v=0;v<r.length;v+=3){x.x=r[v+0],x.y=r[v+1],x.z=r[v+2];let _=p(x)/2/Math.PI+.5,E=m(x)/Math.PI+.5;o.push(_,1-E)}g(),u()}function u(){for(let x=0;x<o.length;x+=6){let v=o[x+0],_=o[x+2],E=o[x+4],w=Math.max(v,_,E),b=Math.min(v,_,E);w>.9&&b<.1&&(v<.2&&(o[x+0]+=1),_<.2&&(o[x+2]+=1),E<.2&&(o[x+4]+=1))}}function d(x){r.push(x.x,x.y,x.z)}function f(x,v){let _=x*3;v.x=t[_+0],v.y=t[_+1],v.z=t[_+2]}function g(){let x=new F,v=new F,_=new F,E=new F,w=new Vt,b=new Vt,M=new Vt;for(let I=0,P=0;I<r.length;I+=9,P+=6){x.set(r[I+0],r[I+1],r[I+2]),v.set(r[I+3],r[I+4],r[I+5]),_.set(r[I+6],r[I+7],r[I+8]),w.set(o[P+0],o[P+1]),b.set(o[P+2],o[P+3]),M.set(o[P+4],o[P+5]),E.copy(x).add(v).add(_).divideScalar(3);let C=p(E);y(w,P+0,x,C),y(b,P+2,v,C),y(M,P+4,_,C)}}function y(x,v,_,E){E<0&&x.x===1&&(o[v]=x.x-1),_.x===0&&_.z===0&&(o[v]=E/2/Math.PI+.5)}function p(x){return Math.atan2(x.z,-x.x)}function m(x){return Math.atan2(-x.y,Math.sqrt(x.x*x.x+x.z*x.z))}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new s(t.vertices,t.indices,t.radius,t.detail)}};var Xc=new F,qc=new F,Mf=new F,Yc=new us,_l=class extends ue{constructor(t=null,e=1){if(super(),this.type="EdgesGeometry",this.parameters={geometry:t,thresholdAngle:e},t!==null){let i=Math.pow(10,4),r=Math.cos(Xo*e),o=t.getIndex(),a=t.getAttribute("position"),c=o?o.count:a.count,l=[0,0,0],h=["a","b","c"],u=new Array(3),d=new Map,f=[];for(let g=0;g<c;g+=3){o?(l[0]=o.getX(g),l[1]=o.getX(g+1),l[2]=o.getX(g+2)):(l[0]=g,l[1]=g+1,l[2]=g+2);let{a:y,b:p,c:m}=Yc;if(y.fromBufferAttribute(a,l[0]),p.fromBufferAttribute(a,l[1]),m.fromBufferAttribute(a,l[2]),Yc.getNormal(Mf),u[0]=`${Math.round(y.x*i)},${Math.round(y.y*i)},${Math.round(y.z*i)}`,u[1]=`${Math.round(p.x*i)},${Math.round(p.y*i)},${Math.round(p.z*i)}`,u[2]=`${Math.round(m.x*i)},${Math.round(m.y*i)},${Math.round(m.z*i)}`,!(u[0]===u[1]||u[1]===u[2]||u[2]===u[0]))for(let x=0;x<3;x++){let v=(x+1)%3,_=u[x],E=u[v],w=Yc[h[x]],b=Yc[h[v]],M=`${_}_${E}`,I=`${E}_${_}`,P=d.get(I);P?(Mf.dot(P.normal)<=r&&(f.push(w.x,w.y,w.z),f.push(b.x,b.y,b.z)),d.set(I,null)):d.has(M)||d.set(M,{index0:l[x],index1:l[v],normal:Mf.clone()})}}for(let g of d.values())if(g){let{index0:y,index1:p}=g;Xc.fromBufferAttribute(a,y),qc.fromBufferAttribute(a,p),f.push(Xc.x,Xc.y,Xc.z),f.push(qc.x,qc.y,qc.z)}this.setAttribute("position",new Xt(f,3))}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}};function Xb(s,t,e=2){let n=t&&t.length,i=n?t[0]*e:s.length,r=P0(s,0,i,e,!0),o=[];if(!r||r.next===r.prev)return o;let a,c,l;if(n&&(r=$b(s,t,r,e)),s.length>80*e){a=s[0],c=s[1];let h=a,u=c;for(let d=e;d<i;d+=e){let f=s[d],g=s[d+1];f<a&&(a=f),g<c&&(c=g),f>h&&(h=f),g>u&&(u=g)}l=Math.max(h-a,u-c),l=l!==0?32767/l:0}return yl(r,o,e,a,c,l,0),o}function P0(s,t,e,n,i){let r;if(i===av(s,t,e,n)>0)for(let o=t;o<e;o+=n)r=Ag(o/n|0,s[o],s[o+1],r);else for(let o=e-n;o>=t;o-=n)r=Ag(o/n|0,s[o],s[o+1],r);return r&&sa(r,r.next)&&(vl(r),r=r.next),r}function Zr(s,t){if(!s)return s;t||(t=s);let e=s,n;do if(n=!1,!e.steiner&&(sa(e,e.next)||fn(e.prev,e,e.next)===0)){if(vl(e),e=t=e.prev,e===e.next)break;n=!0}else e=e.next;while(n||e!==t);return t}function yl(s,t,e,n,i,r,o){if(!s)return;!o&&r&&ev(s,n,i,r);let a=s;for(;s.prev!==s.next;){let c=s.prev,l=s.next;if(r?Yb(s,n,i,r):qb(s)){t.push(c.i,s.i,l.i),vl(s),s=l.next,a=l.next;continue}if(s=l,s===a){o?o===1?(s=jb(Zr(s),t),yl(s,t,e,n,i,r,2)):o===2&&Zb(s,t,e,n,i,r):yl(Zr(s),t,e,n,i,r,1);break}}}function qb(s){let t=s.prev,e=s,n=s.next;if(fn(t,e,n)>=0)return!1;let i=t.x,r=e.x,o=n.x,a=t.y,c=e.y,l=n.y,h=Math.min(i,r,o),u=Math.min(a,c,l),d=Math.max(i,r,o),f=Math.max(a,c,l),g=n.next;for(;g!==t;){if(g.x>=h&&g.x<=d&&g.y>=u&&g.y<=f&&tl(i,a,r,c,o,l,g.x,g.y)&&fn(g.prev,g,g.next)>=0)return!1;g=g.next}return!0}function Yb(s,t,e,n){let i=s.prev,r=s,o=s.next;if(fn(i,r,o)>=0)return!1;let a=i.x,c=r.x,l=o.x,h=i.y,u=r.y,d=o.y,f=Math.min(a,c,l),g=Math.min(h,u,d),y=Math.max(a,c,l),p=Math.max(h,u,d),m=Lf(f,g,t,e,n),x=Lf(y,p,t,e,n),v=s.prevZ,_=s.nextZ;for(;v&&v.z>=m&&_&&_.z<=x;){if(v.x>=f&&v.x<=y&&v.y>=g&&v.y<=p&&v!==i&&v!==o&&tl(a,h,c,u,l,d,v.x,v.y)&&fn(v.prev,v,v.next)>=0||(v=v.prevZ,_.x>=f&&_.x<=y&&_.y>=g&&_.y<=p&&_!==i&&_!==o&&tl(a,h,c,u,l,d,_.x,_.y)&&fn(_.prev,_,_.next)>=0))return!1;_=_.nextZ}for(;v&&v.z>=m;){if(v.x>=f&&v.x<=y&&v.y>=g&&v.y<=p&&v!==i&&v!==o&&tl(a,h,c,u,l,d,v.x,v.y)&&fn(v.prev,v,v.next)>=0)return!1;v=v.prevZ}for(;_&&_.z<=x;){if(_.x>=f&&_.x<=y&&_.y>=g&&_.y<=p&&_!==i&&_!==o&&tl(a,h,c,u,l,d,_.x,_.y)&&fn(_.prev,_,_.next)>=0)return!1;_=_.nextZ}return!0}function jb(s,t){let e=s;do{let n=e.prev,i=e.next.next;!sa(n,i)&&L0(n,e,e.next,i)&&bl(n,i)&&bl(i,n)&&(t.push(n.i,e.i,i.i),vl(e),vl(e.next),e=s=i),e=e.next}while(e!==s);return Zr(e)}function Zb(s,t,e,n,i,r){let o=s;do{let a=o.next.next;for(;a!==o.prev;){if(o.i!==a.i&&sv(o,a)){let c=N0(o,a);o=Zr(o,o.next),c=Zr(c,c.next),yl(o,t,e,n,i,r,0),yl(c,t,e,n,i,r,0);return}a=a.next}o=o.next}while(o!==s)}function $b(s,t,e,n){let i=[];for(let r=0,o=t.length;r<o;r++){let a=t[r]*n,c=r<o-1?t[r+1]*n:s.length,l=P0(s,a,c,n,!1);l===l.next&&(l.steiner=!0),i.push(iv(l))}i.sort(Jb);for(let r=0;r<i.length;r++)e=Kb(i[r],e);return e}function Jb(s,t){let e=s.x-t.x;if(e===0&&(e=s.y-t.y,e===0)){let n=(s.next.y-s.y)/(s.next.x-s.x),i=(t.next.y-t.y)/(t.next.x-t.x);e=n-i}return e}function Kb(s,t){let e=Qb(s,t);if(!e)return t;let n=N0(e,s);return Zr(n,n.next),Zr(e,e.next)}function Qb(s,t){let e=t,n=s.x,i=s.y,r=-1/0,o;if(sa(s,e))return e;do{if(sa(s,e.next))return e.next;if(i<=e.y&&i>=e.next.y&&e.next.y!==e.y){let u=e.x+(i-e.y)*(e.next.x-e.x)/(e.next.y-e.y);if(u<=n&&u>r&&(r=u,o=e.x<e.next.x?e:e.next,u===n))return o}e=e.next}while(e!==t);if(!o)return null;let a=o,c=o.x,l=o.y,h=1/0;e=o;do{if(n>=e.x&&e.x>=c&&n!==e.x&&I0(i<l?n:r,i,c,l,i<l?r:n,i,e.x,e.y)){let u=Math.abs(i-e.y)/(n-e.x);bl(e,s)&&(u<h||u===h&&(e.x>o.x||e.x===o.x&&tv(o,e)))&&(o=e,h=u)}e=e.next}while(e!==a);return o}function tv(s,t){return fn(s.prev,s,t.prev)<0&&fn(t.next,s,s.next)<0}function ev(s,t,e,n){let i=s;do i.z===0&&(i.z=Lf(i.x,i.y,t,e,n)),i.prevZ=i.prev,i.nextZ=i.next,i=i.next;while(i!==s);i.prevZ.nextZ=null,i.prevZ=null,nv(i)}function nv(s){let t,e=1;do{let n=s,i;s=null;let r=null;for(t=0;n;){t++;let o=n,a=0;for(let l=0;l<e&&(a++,o=o.nextZ,!!o);l++);let c=e;for(;a>0||c>0&&o;)a!==0&&(c===0||!o||n.z<=o.z)?(i=n,n=n.nextZ,a--):(i=o,o=o.nextZ,c--),r?r.nextZ=i:s=i,i.prevZ=r,r=i;n=o}r.nextZ=null,e*=2}while(t>1);return s}function Lf(s,t,e,n,i){return s=(s-e)*i|0,t=(t-n)*i|0,s=(s|s<<8)&16711935,s=(s|s<<4)&252645135,s=(s|s<<2)&858993459,s=(s|s<<1)&1431655765,t=(t|t<<8)&16711935,t=(t|t<<4)&252645135,t=(t|t<<2)&858993459,t=(t|t<<1)&1431655765,s|t<<1}function iv(s){let t=s,e=s;do(t.x<e.x||t.x===e.x&&t.y<e.y)&&(e=t),t=t.next;while(t!==s);return e}function I0(s,t,e,n,i,r,o,a){return(i-o)*(t-a)>=(s-o)*(r-a)&&(s-o)*(n-a)>=(e-o)*(t-a)&&(e-o)*(r-a)>=(i-o)*(n-a)}function tl(s,t,e,n,i,r,o,a){return!(s===o&&t===a)&&I0(s,t,e,n,i,r,o,a)}function sv(s,t){return s.next.i!==t.i&&s.prev.i!==t.i&&!rv(s,t)&&(bl(s,t)&&bl(t,s)&&ov(s,t)&&(fn(s.prev,s,t.prev)||fn(s,t.prev,t))||sa(s,t)&&fn(s.prev,s,s.next)>0&&fn(t.prev,t,t.next)>0)}function fn(s,t,e){return(t.y-s.y)*(e.x-t.x)-(t.x-s.x)*(e.y-t.y)}function sa(s,t){return s.x===t.x&&s.y===t.y}function L0(s,t,e,n){let i=Zc(fn(s,t,e)),r=Zc(fn(s,t,n)),o=Zc(fn(e,n,s)),a=Zc(fn(e,n,t));return!!(i!==r&&o!==a||i===0&&jc(s,e,t)||r===0&&jc(s,n,t)||o===0&&jc(e,s,n)||a===0&&jc(e,t,n))}function jc(s,t,e){return t.x<=Math.max(s.x,e.x)&&t.x>=Math.min(s.x,e.x)&&t.y<=Math.max(s.y,e.y)&&t.y>=Math.min(s.y,e.y)}function Zc(s){return s>0?1:s<0?-1:0}function rv(s,t){let e=s;do{if(e.i!==s.i&&e.next.i!==s.i&&e.i!==t.i&&e.next.i!==t.i&&L0(e,e.next,s,t))return!0;e=e.next}while(e!==s);return!1}function bl(s,t){return fn(s.prev,s,s.next)<0?fn(s,t,s.next)>=0&&fn(s,s.prev,t)>=0:fn(s,t,s.prev)<0||fn(s,s.next,t)<0}function ov(s,t){let e=s,n=!1,i=(s.x+t.x)/2,r=(s.y+t.y)/2;do e.y>r!=e.next.y>r&&e.next.y!==e.y&&i<(e.next.x-e.x)*(r-e.y)/(e.next.y-e.y)+e.x&&(n=!n),e=e.next;while(e!==s);return n}function N0(s,t){let e=Nf(s.i,s.x,s.y),n=Nf(t.i,t.x,t.y),i=s.next,r=t.prev;return s.next=t,t.prev=s,e.next=i,i.prev=e,n.next=e,e.prev=n,r.next=n,n.prev=r,n}function Ag(s,t,e,n){let i=Nf(s,t,e);return n?(i.next=n.next,i.prev=n,n.next.prev=i,n.next=i):(i.prev=i,i.next=i),i}function vl(s){s.next.prev=s.prev,s.prev.next=s.next,s.prevZ&&(s.prevZ.nextZ=s.nextZ),s.nextZ&&(s.nextZ.prevZ=s.prevZ)}function Nf(s,t,e){return{i:s,x:t,y:e,prev:null,next:null,z:0,prevZ:null,nextZ:null,steiner:!1}}function av(s,t,e,n){let i=0;for(let r=t,o=e-n;r<e;r+=n)i+=(s[o]-s[r])*(s[r+1]+s[o+1]),o=r;return i}var Df=class{static triangulate(t,e,n=2){return Xb(t,e,n)}},ra=class s{static area(t){let e=t.length,n=0;for(let i=e-1,r=0;r<e;i=r++)n+=t[i].x*t[r].y-t[r].x*t[i].y;return n*.5}static isClockWise(t){return s.area(t)<0}static triangulateShape(t,e){let n=[],i=[],r=[];Rg(t),Cg(n,t);let o=t.length;e.forEach(Rg);for(let c=0;c<e.length;c++)i.push(o),o+=e[c].length,Cg(n,e[c]);let a=Df.triangulate(n,i);for(let c=0;c<a.length;c+=3)r.push(a.slice(c,c+3));return r}};function Rg(s){let t=s.length;t>2&&s[t-1].equals(s[0])&&s.pop()}function Cg(s,t){for(let e=0;e<t.length;e++)s.push(t[e].x),s.push(t[e].y)}var Er=class s extends gh{constructor(t=1,e=0){let n=[1,0,0,-1,0,0,0,1,0,0,-1,0,0,0,1,0,0,-1],i=[0,2,4,0,4,3,0,3,5,0,5,2,1,2,5,1,5,3,1,3,4,1,4,2];super(n,i,t,e),this.type="OctahedronGeometry",this.parameters={radius:t,detail:e}}static fromJSON(t){return new s(t.radius,t.detail)}},Qs=class s extends ue{constructor(t=1,e=1,n=1,i=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:n,heightSegments:i};let r=t/2,o=e/2,a=Math.floor(n),c=Math.floor(i),l=a+1,h=c+1,u=t/a,d=e/c,f=[],g=[],y=[],p=[];for(let m=0;m<h;m++){let x=m*d-o;for(let v=0;v<l;v++){let _=v*u-r;g.push(_,-x,0),y.push(0,0,1),p.push(v/a),p.push(1-m/c)}}for(let m=0;m<c;m++)for(let x=0;x<a;x++){let v=x+l*m,_=x+l*(m+1),E=x+1+l*(m+1),w=x+1+l*m;f.push(v,_,w),f.push(_,E,w)}this.setIndex(f),this.setAttribute("position",new Xt(g,3)),this.setAttribute("normal",new Xt(y,3)),this.setAttribute("uv",new Xt(p,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new s(t.width,t.height,t.widthSegments,t.heightSegments)}},tr=class s extends ue{constructor(t=.5,e=1,n=32,i=1,r=0,o=Math.PI*2){super(),this.type="RingGeometry",this.parameters={innerRadius:t,outerRadius:e,thetaSegments:n,phiSegments:i,thetaStart:r,thetaLength:o},n=Math.max(3,n),i=Math.max(1,i);let a=[],c=[],l=[],h=[],u=t,d=(e-t)/i,f=new F,g=new Vt;for(let y=0;y<=i;y++){for(let p=0;p<=n;p++){let m=r+p/n*o;f.x=u*Math.cos(m),f.y=u*Math.sin(m),c.push(f.x,f.y,f.z),l.push(0,0,1),g.x=(f.x/e+1)/2,g.y=(f.y/e+1)/2,h.push(g.x,g.y)}u+=d}for(let y=0;y<i;y++){let p=y*(n+1);for(let m=0;m<n;m++){let x=m+p,v=x,_=x+n+1,E=x+n+2,w=x+1;a.push(v,_,w),a.push(_,E,w)}}this.setIndex(a),this.setAttribute("position",new Xt(c,3)),this.setAttribute("normal",new Xt(l,3)),this.setAttribute("uv",new Xt(h,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new s(t.innerRadius,t.outerRadius,t.thetaSegments,t.phiSegments,t.thetaStart,t.thetaLength)}};var oi=class s extends ue{constructor(t=1,e=32,n=16,i=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:t,widthSegments:e,heightSegments:n,phiStart:i,phiLength:r,thetaStart:o,thetaLength:a},e=Math.max(3,Math.floor(e)),n=Math.max(2,Math.floor(n));let c=Math.min(o+a,Math.PI),l=0,h=[],u=new F,d=new F,f=[],g=[],y=[],p=[];for(let m=0;m<=n;m++){let x=[],v=m/n,_=o+v*a,E=t*Math.cos(_),w=Math.sqrt(t*t-E*E),b=0;m===0&&o===0?b=.5/e:m===n&&c===Math.PI&&(b=-.5/e);for(let M=0;M<=e;M++){let I=M/e,P=i+I*r;u.x=-w*Math.cos(P),u.y=E,u.z=w*Math.sin(P),g.push(u.x,u.y,u.z),d.copy(u).normalize(),y.push(d.x,d.y,d.z),p.push(I+b,1-v),x.push(l++)}h.push(x)}for(let m=0;m<n;m++)for(let x=0;x<e;x++){let v=h[m][x+1],_=h[m][x],E=h[m+1][x],w=h[m+1][x+1];(m!==0||o>0)&&f.push(v,_,w),(m!==n-1||c<Math.PI)&&f.push(_,E,w)}this.setIndex(f),this.setAttribute("position",new Xt(g,3)),this.setAttribute("normal",new Xt(y,3)),this.setAttribute("uv",new Xt(p,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new s(t.radius,t.widthSegments,t.heightSegments,t.phiStart,t.phiLength,t.thetaStart,t.thetaLength)}};var er=class s extends ue{constructor(t=1,e=.4,n=12,i=48,r=Math.PI*2,o=0,a=Math.PI*2){super(),this.type="TorusGeometry",this.parameters={radius:t,tube:e,radialSegments:n,tubularSegments:i,arc:r,thetaStart:o,thetaLength:a},n=Math.floor(n),i=Math.floor(i);let c=[],l=[],h=[],u=[],d=new F,f=new F,g=new F;for(let y=0;y<=n;y++){let p=o+y/n*a;for(let m=0;m<=i;m++){let x=m/i*r;f.x=(t+e*Math.cos(p))*Math.cos(x),f.y=(t+e*Math.cos(p))*Math.sin(x),f.z=e*Math.sin(p),l.push(f.x,f.y,f.z),d.x=t*Math.cos(x),d.y=t*Math.sin(x),g.subVectors(f,d).normalize(),h.push(g.x,g.y,g.z),u.push(m/i),u.push(y/n)}}for(let y=1;y<=n;y++)for(let p=1;p<=i;p++){let m=(i+1)*y+p-1,x=(i+1)*(y-1)+p-1,v=(i+1)*(y-1)+p,_=(i+1)*y+p;c.push(m,x,_),c.push(x,v,_)}this.setIndex(c),this.setAttribute("position",new Xt(l,3)),this.setAttribute("normal",new Xt(h,3)),this.setAttribute("uv",new Xt(u,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new s(t.radius,t.tube,t.radialSegments,t.tubularSegments,t.arc,t.thetaStart,t.thetaLength)}};function ao(s){let t={};for(let e in s){t[e]={};for(let n in s[e]){let i=s[e][n];if(Pg(i))i.isRenderTargetTexture?(Zt("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][n]=null):t[e][n]=i.clone();else if(Array.isArray(i))if(Pg(i[0])){let r=[];for(let o=0,a=i.length;o<a;o++)r[o]=i[o].clone();t[e][n]=r}else t[e][n]=i.slice();else t[e][n]=i}}return t}function hi(s){let t={};for(let e=0;e<s.length;e++){let n=ao(s[e]);for(let i in n)t[i]=n[i]}return t}function Pg(s){return s&&(s.isColor||s.isMatrix3||s.isMatrix4||s.isVector2||s.isVector3||s.isVector4||s.isTexture||s.isQuaternion)}function lv(s){let t=[];for(let e=0;e<s.length;e++)t.push(s[e].clone());return t}function mp(s){let t=s.getRenderTarget();return t===null?s.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:he.workingColorSpace}var D0={clone:ao,merge:hi},cv=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,hv=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Zi=class extends yi{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=cv,this.fragmentShader=hv,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=ao(t.uniforms),this.uniformsGroups=lv(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this.defaultAttributeValues=Object.assign({},t.defaultAttributeValues),this.index0AttributeName=t.index0AttributeName,this.uniformsNeedUpdate=t.uniformsNeedUpdate,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let i in this.uniforms){let o=this.uniforms[i].value;o&&o.isTexture?e.uniforms[i]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[i]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[i]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[i]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[i]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[i]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[i]={type:"m4",value:o.toArray()}:e.uniforms[i]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let n={};for(let i in this.extensions)this.extensions[i]===!0&&(n[i]=!0);return Object.keys(n).length>0&&(e.extensions=n),e}fromJSON(t,e){if(super.fromJSON(t,e),t.uniforms!==void 0)for(let n in t.uniforms){let i=t.uniforms[n];switch(this.uniforms[n]={},i.type){case"t":this.uniforms[n].value=e[i.value]||null;break;case"c":this.uniforms[n].value=new qt().setHex(i.value);break;case"v2":this.uniforms[n].value=new Vt().fromArray(i.value);break;case"v3":this.uniforms[n].value=new F().fromArray(i.value);break;case"v4":this.uniforms[n].value=new ze().fromArray(i.value);break;case"m3":this.uniforms[n].value=new ie().fromArray(i.value);break;case"m4":this.uniforms[n].value=new Gt().fromArray(i.value);break;default:this.uniforms[n].value=i.value}}if(t.defines!==void 0&&(this.defines=t.defines),t.vertexShader!==void 0&&(this.vertexShader=t.vertexShader),t.fragmentShader!==void 0&&(this.fragmentShader=t.fragmentShader),t.glslVersion!==void 0&&(this.glslVersion=t.glslVersion),t.extensions!==void 0)for(let n in t.extensions)this.extensions[n]=t.extensions[n];return t.lights!==void 0&&(this.lights=t.lights),t.clipping!==void 0&&(this.clipping=t.clipping),this}},xh=class extends Zi{constructor(t){super(t),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}},nr=class extends yi{constructor(t){super(),this.isMeshStandardMaterial=!0,this.type="MeshStandardMaterial",this.defines={STANDARD:""},this.color=new qt(16777215),this.roughness=1,this.metalness=0,this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new qt(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=ga,this.normalScale=new Vt(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.roughnessMap=null,this.metalnessMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new ti,this.envMapIntensity=1,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.defines={STANDARD:""},this.color.copy(t.color),this.roughness=t.roughness,this.metalness=t.metalness,this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.roughnessMap=t.roughnessMap,this.metalnessMap=t.metalnessMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.envMapIntensity=t.envMapIntensity,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}};var $i=class extends yi{constructor(t){super(),this.isMeshPhongMaterial=!0,this.type="MeshPhongMaterial",this.color=new qt(16777215),this.specular=new qt(1118481),this.shininess=30,this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new qt(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=ga,this.normalScale=new Vt(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new ti,this.combine=Il,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.specular.copy(t.specular),this.shininess=t.shininess,this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.envMapIntensity=t.envMapIntensity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}};var $r=class extends yi{constructor(t){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new qt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new qt(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=ga,this.normalScale=new Vt(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new ti,this.combine=Il,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.envMapIntensity=t.envMapIntensity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}},_h=class extends yi{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=p0,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},yh=class extends yi{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};var wl=class extends pn{constructor(t){super(),this.isLineDashedMaterial=!0,this.type="LineDashedMaterial",this.scale=1,this.dashSize=3,this.gapSize=1,this.setValues(t)}copy(t){return super.copy(t),this.scale=t.scale,this.dashSize=t.dashSize,this.gapSize=t.gapSize,this}};function vr(s,t){return!s||s.constructor===t?s:typeof t.BYTES_PER_ELEMENT=="number"?new t(s):Array.prototype.slice.call(s)}function el(s){return s!==void 0&&s.inTangents!==void 0&&s.outTangents!==void 0}function uv(s){function t(i,r){return s[i]-s[r]}let e=s.length,n=new Array(e);for(let i=0;i!==e;++i)n[i]=i;return n.sort(t),n}function Ig(s,t,e){let n=s.length,i=new s.constructor(n);for(let r=0,o=0;o!==n;++r){let a=e[r]*t;for(let c=0;c!==t;++c)i[o++]=s[a+c]}return i}function dv(s,t,e,n){let i=1,r=s[0];for(;r!==void 0&&r[n]===void 0;)r=s[i++];if(r===void 0)return;let o=r[n];if(o!==void 0)if(Array.isArray(o))do o=r[n],o!==void 0&&(t.push(r.time),e.push(...o)),r=s[i++];while(r!==void 0);else if(o.toArray!==void 0)do o=r[n],o!==void 0&&(t.push(r.time),o.toArray(e,e.length)),r=s[i++];while(r!==void 0);else do o=r[n],o!==void 0&&(t.push(r.time),e.push(o)),r=s[i++];while(r!==void 0)}var Tr=class{constructor(t,e,n,i){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=i!==void 0?i:new e.constructor(n),this.sampleValues=e,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,n=this._cachedIndex,i=e[n],r=e[n-1];n:{t:{let o;e:{i:if(!(t<i)){for(let a=n+2;;){if(i===void 0){if(t<r)break i;return n=e.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===a)break;if(r=i,i=e[++n],t<i)break t}o=e.length;break e}if(!(t>=r)){let a=e[1];t<a&&(n=2,r=a);for(let c=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===c)break;if(i=r,r=e[--n-1],t>=r)break t}o=n,n=0;break e}break n}for(;n<o;){let a=n+o>>>1;t<e[a]?o=a:n=a+1}if(i=e[n],r=e[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===void 0)return n=e.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,i)}return this.interpolate_(n,r,t,i)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,n=this.sampleValues,i=this.valueSize,r=t*i;for(let o=0;o!==i;++o)e[o]=n[r+o];return e}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},bh=class extends Tr{constructor(t,e,n,i){super(t,e,n,i),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Rf,endingEnd:Rf}}intervalChanged_(t,e,n){let i=this.parameterPositions,r=t-2,o=t+1,a=i[r],c=i[o];if(a===void 0)switch(this.getSettings_().endingStart){case Cf:r=t,a=2*e-n;break;case Pf:r=i.length-2,a=e+i[r]-i[r+1];break;default:r=t,a=n}if(c===void 0)switch(this.getSettings_().endingEnd){case Cf:o=t,c=2*n-e;break;case Pf:o=1,c=n+i[1]-i[0];break;default:o=t-1,c=e}let l=(n-e)*.5,h=this.valueSize;this._weightPrev=l/(e-a),this._weightNext=l/(c-n),this._offsetPrev=r*h,this._offsetNext=o*h}interpolate_(t,e,n,i){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=t*a,l=c-a,h=this._offsetPrev,u=this._offsetNext,d=this._weightPrev,f=this._weightNext,g=(n-e)/(i-e),y=g*g,p=y*g,m=-d*p+2*d*y-d*g,x=(1+d)*p+(-1.5-2*d)*y+(-.5+d)*g+1,v=(-1-f)*p+(1.5+f)*y+.5*g,_=f*p-f*y;for(let E=0;E!==a;++E)r[E]=m*o[h+E]+x*o[l+E]+v*o[c+E]+_*o[u+E];return r}},vh=class extends Tr{constructor(t,e,n,i){super(t,e,n,i)}interpolate_(t,e,n,i){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=t*a,l=c-a,h=(n-e)/(i-e),u=1-h;for(let d=0;d!==a;++d)r[d]=o[l+d]*u+o[c+d]*h;return r}},wh=class extends Tr{constructor(t,e,n,i){super(t,e,n,i)}interpolate_(t){return this.copySampleValue_(t-1)}},Sh=class extends Tr{interpolate_(t,e,n,i){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=t*a,l=c-a,h=this.inTangents,u=this.outTangents;if(!h||!u){let g=(n-e)/(i-e),y=1-g;for(let p=0;p!==a;++p)r[p]=o[l+p]*y+o[c+p]*g;return r}let d=a*2,f=t-1;for(let g=0;g!==a;++g){let y=o[l+g],p=o[c+g],m=f*d+g*2,x=u[m],v=u[m+1],_=t*d+g*2,E=h[_],w=h[_+1],b=pv(n,e,x,E,i);r[g]=U0(b,y,v,w,p)}return r}};function U0(s,t,e,n,i){let r=1-s;return r*r*r*t+3*r*r*s*e+3*r*s*s*n+s*s*s*i}function fv(s,t,e,n,i){let r=1-s;return 3*r*r*(e-t)+6*r*s*(n-e)+3*s*s*(i-n)}function pv(s,t,e,n,i){let r=(s-t)/(i-t);for(let o=0;o<8;o++){let a=U0(r,t,e,n,i)-s;if(Math.abs(a)<1e-10)break;let c=fv(r,t,e,n,i);if(Math.abs(c)<1e-10)break;r=Math.max(0,Math.min(1,r-a/c))}return r}var Ai=class{constructor(t,e,n,i){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=vr(e,this.TimeBufferType),this.values=vr(n,this.ValueBufferType),this.setInterpolation(i||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,n;if(e.toJSON!==this.toJSON)n=e.toJSON(t);else{n={name:t.name,times:vr(t.times,Array),values:vr(t.values,Array)};let i=t.getInterpolation();i!==t.DefaultInterpolation&&(n.interpolation=i),el(t.settings)&&(n.settings={inTangents:vr(t.settings.inTangents,Array),outTangents:vr(t.settings.outTangents,Array)})}return n.type=t.ValueTypeName,n}InterpolantFactoryMethodDiscrete(t){return new wh(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new vh(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new bh(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodBezier(t){let e=new Sh(this.times,this.values,this.getValueSize(),t);return this.settings&&(e.inTangents=this.settings.inTangents,e.outTangents=this.settings.outTangents),e}setInterpolation(t){let e;switch(t){case Xr:e=this.InterpolantFactoryMethodDiscrete;break;case ch:e=this.InterpolantFactoryMethodLinear;break;case Qc:e=this.InterpolantFactoryMethodSmooth;break;case sl:e=this.InterpolantFactoryMethodBezier;break}if(e===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return Zt("KeyframeTrack:",n),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Xr;case this.InterpolantFactoryMethodLinear:return ch;case this.InterpolantFactoryMethodSmooth:return Qc;case this.InterpolantFactoryMethodBezier:return sl}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let n=0,i=e.length;n!==i;++n)e[n]+=t;el(this.settings)&&(Lg(this.settings.inTangents,t),Lg(this.settings.outTangents,t))}return this}scale(t){if(t!==1){let e=this.times;for(let n=0,i=e.length;n!==i;++n)e[n]*=t;el(this.settings)&&(Ng(this.settings.inTangents,t),Ng(this.settings.outTangents,t))}return this}trim(t,e){let n=this.times,i=n.length,r=0,o=i-1;for(;r!==i&&n[r]<t;)++r;for(;o!==-1&&n[o]>e;)--o;if(++o,r!==0||o!==i){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=n.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(te("KeyframeTrack: Invalid value size in track.",this),t=!1);let n=this.times,i=this.values,r=n.length;r===0&&(te("KeyframeTrack: Track is empty.",this),t=!1);let o=null;for(let a=0;a!==r;a++){let c=n[a];if(typeof c=="number"&&isNaN(c)){te("KeyframeTrack: Time is not a valid number.",this,a,c),t=!1;break}if(o!==null&&o>c){te("KeyframeTrack: Out of order keys.",this,a,c,o),t=!1;break}o=c}if(i!==void 0&&lb(i))for(let a=0,c=i.length;a!==c;++a){let l=i[a];if(isNaN(l)){te("KeyframeTrack: Value is not a valid number.",this,a,l),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),n=this.getValueSize(),i=this.getInterpolation()===Qc,r=t.length-1,o=1;for(let a=1;a<r;++a){let c=!1,l=t[a],h=t[a+1];if(l!==h&&(a!==1||l!==t[0]))if(i)c=!0;else{let u=a*n,d=u-n,f=u+n;for(let g=0;g!==n;++g){let y=e[u+g];if(y!==e[d+g]||y!==e[f+g]){c=!0;break}}}if(c){if(a!==o){t[o]=t[a];let u=a*n,d=o*n;for(let f=0;f!==n;++f)e[d+f]=e[u+f]}++o}}if(r>0){t[o]=t[r];for(let a=r*n,c=o*n,l=0;l!==n;++l)e[c+l]=e[a+l];++o}return o!==t.length?(this.times=t.slice(0,o),this.values=e.slice(0,o*n)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),n=this.constructor,i=new n(this.name,t,e);return i.createInterpolant=this.createInterpolant,el(this.settings)&&(i.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),i}};function Lg(s,t){for(let e=0,n=s.length;e!==n;e+=2)s[e]+=t}function Ng(s,t){for(let e=0,n=s.length;e!==n;e+=2)s[e]*=t}Ai.prototype.ValueTypeName="";Ai.prototype.TimeBufferType=Float32Array;Ai.prototype.ValueBufferType=Float32Array;Ai.prototype.DefaultInterpolation=ch;var ir=class extends Ai{constructor(t,e,n){super(t,e,n)}};ir.prototype.ValueTypeName="bool";ir.prototype.ValueBufferType=Array;ir.prototype.DefaultInterpolation=Xr;ir.prototype.InterpolantFactoryMethodLinear=void 0;ir.prototype.InterpolantFactoryMethodSmooth=void 0;var Sl=class extends Ai{constructor(t,e,n,i){super(t,e,n,i)}};Sl.prototype.ValueTypeName="color";var oa=class extends Ai{constructor(t,e,n,i){super(t,e,n,i)}};oa.prototype.ValueTypeName="number";var Mh=class extends Tr{constructor(t,e,n,i){super(t,e,n,i)}interpolate_(t,e,n,i){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=(n-e)/(i-e),l=t*a;for(let h=l+a;l!==h;l+=4)ve.slerpFlat(r,0,o,l-a,o,l,c);return r}},Ps=class extends Ai{constructor(t,e,n,i){super(t,e,n,i)}InterpolantFactoryMethodLinear(t){return new Mh(this.times,this.values,this.getValueSize(),t)}};Ps.prototype.ValueTypeName="quaternion";Ps.prototype.InterpolantFactoryMethodSmooth=void 0;var sr=class extends Ai{constructor(t,e,n){super(t,e,n)}};sr.prototype.ValueTypeName="string";sr.prototype.ValueBufferType=Array;sr.prototype.DefaultInterpolation=Xr;sr.prototype.InterpolantFactoryMethodLinear=void 0;sr.prototype.InterpolantFactoryMethodSmooth=void 0;var ai=class extends Ai{constructor(t,e,n,i){super(t,e,n,i)}};ai.prototype.ValueTypeName="vector";var aa=class{constructor(t="",e=-1,n=[],i=f0){this.name=t,this.tracks=n,this.duration=e,this.blendMode=i,this.uuid=Lr(),this.userData={},this.duration<0&&this.resetDuration()}static parse(t){let e=[],n=t.tracks,i=1/(t.fps||1);for(let o=0,a=n.length;o!==a;++o)e.push(gv(n[o]).scale(i));let r=new this(t.name,t.duration,e,t.blendMode);return r.uuid=t.uuid,r.userData=JSON.parse(t.userData||"{}"),r}static toJSON(t){let e=[],n=t.tracks,i={name:t.name,duration:t.duration,tracks:e,uuid:t.uuid,blendMode:t.blendMode,userData:JSON.stringify(t.userData)};for(let r=0,o=n.length;r!==o;++r)e.push(Ai.toJSON(n[r]));return i}static CreateFromMorphTargetSequence(t,e,n,i){let r=e.length,o=[];for(let a=0;a<r;a++){let c=[],l=[];c.push((a+r-1)%r,a,(a+1)%r),l.push(0,1,0);let h=uv(c);c=Ig(c,1,h),l=Ig(l,1,h),!i&&c[0]===0&&(c.push(r),l.push(l[0])),o.push(new oa(".morphTargetInfluences["+e[a].name+"]",c,l).scale(1/n))}return new this(t,-1,o)}static findByName(t,e){let n=t;if(!Array.isArray(t)){let i=t;n=i.geometry&&i.geometry.animations||i.animations}for(let i=0;i<n.length;i++)if(n[i].name===e)return n[i];return null}static CreateClipsFromMorphTargetSequences(t,e,n){let i={},r=/^([\w-]*?)([\d]+)$/;for(let a=0,c=t.length;a<c;a++){let l=t[a],h=l.name.match(r);if(h&&h.length>1){let u=h[1],d=i[u];d||(i[u]=d=[]),d.push(l)}}let o=[];for(let a in i)o.push(this.CreateFromMorphTargetSequence(a,i[a],e,n));return o}resetDuration(){let t=this.tracks,e=0;for(let n=0,i=t.length;n!==i;++n){let r=this.tracks[n];e=Math.max(e,r.times[r.times.length-1])}return this.duration=e,this}trim(){for(let t=0;t<this.tracks.length;t++)this.tracks[t].trim(0,this.duration);return this}validate(){let t=!0;for(let e=0;e<this.tracks.length;e++)t=t&&this.tracks[e].validate();return t}optimize(){for(let t=0;t<this.tracks.length;t++)this.tracks[t].optimize();return this}clone(){let t=[];for(let n=0;n<this.tracks.length;n++)t.push(this.tracks[n].clone());let e=new this.constructor(this.name,this.duration,t,this.blendMode);return e.userData=JSON.parse(JSON.stringify(this.userData)),e}toJSON(){return this.constructor.toJSON(this)}};function mv(s){switch(s.toLowerCase()){case"scalar":case"double":case"float":case"number":case"integer":return oa;case"vector":case"vector2":case"vector3":case"vector4":return ai;case"color":return Sl;case"quaternion":return Ps;case"bool":case"boolean":return ir;case"string":return sr}throw new Error("THREE.KeyframeTrack: Unsupported typeName: "+s)}function gv(s){if(s.type===void 0)throw new Error("THREE.KeyframeTrack: track type undefined, can not parse");let t=mv(s.type);if(s.times===void 0){let n=[],i=[];dv(s.keys,n,i,"value"),s.times=n,s.values=i}let e;return t.parse!==void 0?e=t.parse(s):e=new t(s.name,s.times,s.values,s.interpolation),el(s.settings)&&(e.settings={inTangents:vr(s.settings.inTangents,Float32Array),outTangents:vr(s.settings.outTangents,Float32Array)}),e}var Yo={enabled:!1,files:{},add:function(s,t){this.enabled!==!1&&(Dg(s)||(this.files[s]=t))},get:function(s){if(this.enabled!==!1&&!Dg(s))return this.files[s]},remove:function(s){delete this.files[s]},clear:function(){this.files={}}};function Dg(s){try{let t=s.slice(s.indexOf(":")+1);return new URL(t).protocol==="blob:"}catch{return!1}}var la=class{constructor(t,e,n){let i=this,r=!1,o=0,a=0,c,l=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=n,this._abortController=null,this.itemStart=function(h){a++,r===!1&&i.onStart!==void 0&&i.onStart(h,o,a),r=!0},this.itemEnd=function(h){o++,i.onProgress!==void 0&&i.onProgress(h,o,a),o===a&&(r=!1,i.onLoad!==void 0&&i.onLoad())},this.itemError=function(h){i.onError!==void 0&&i.onError(h)},this.resolveURL=function(h){return h=h.normalize("NFC"),c?c(h):h},this.setURLModifier=function(h){return c=h,this},this.addHandler=function(h,u){return l.push(h,u),this},this.removeHandler=function(h){let u=l.indexOf(h);return u!==-1&&l.splice(u,2),this},this.getHandler=function(h){for(let u=0,d=l.length;u<d;u+=2){let f=l[u],g=l[u+1];if(f.global&&(f.lastIndex=0),f.test(h))return g}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},fu=new la,li=class{constructor(t){this.manager=t!==void 0?t:fu,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(t,e){let n=this;return new Promise(function(i,r){n.load(t,i,e,r)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}setPriority(t){return this.priority=t,this}setCache(t){return this.cache=t,this}abort(){return this}};li.DEFAULT_MATERIAL_NAME="__DEFAULT";var js={},Uf=class extends Error{constructor(t,e){super(t),this.response=e}},Is=class extends li{constructor(t){super(t),this.mimeType="",this.responseType="",this._abortController=new AbortController}load(t,e,n,i){t===void 0&&(t=""),this.path!==void 0&&(t=this.path+t),t=this.manager.resolveURL(t);let r=Yo.get(`file:${t}`);if(r!==void 0){this.manager.itemStart(t),setTimeout(()=>{e&&e(r),this.manager.itemEnd(t)},0);return}if(js[t]!==void 0){js[t].push({onLoad:e,onProgress:n,onError:i});return}js[t]=[],js[t].push({onLoad:e,onProgress:n,onError:i});let o=new Request(t,{headers:new Headers(this.requestHeader),credentials:this.withCredentials?"include":"same-origin",priority:this.priority,cache:this.cache,signal:typeof AbortSignal.any=="function"?AbortSignal.any([this._abortController.signal,this.manager.abortController.signal]):this._abortController.signal}),a=this.mimeType,c=this.responseType;fetch(o).then(l=>{if(l.status===200||l.status===0){if(l.status===0&&Zt("FileLoader: HTTP Status 0 received."),typeof ReadableStream>"u"||l.body===void 0||l.body.getReader===void 0)return l;let h=js[t],u=l.body.getReader(),d=l.headers.get("X-File-Size")||l.headers.get("Content-Length"),f=d?parseInt(d):0,g=f!==0,y=0,p=new ReadableStream({start(m){x();function x(){u.read().then(({done:v,value:_})=>{if(v)m.close();else{y+=_.byteLength;let E=new ProgressEvent("progress",{lengthComputable:g,loaded:y,total:f});for(let w=0,b=h.length;w<b;w++){let M=h[w];M.onProgress&&M.onProgress(E)}m.enqueue(_),x()}},v=>{m.error(v)})}}});return new Response(p)}else throw new Uf(`fetch for "${l.url}" responded with ${l.status}: ${l.statusText}`,l)}).then(l=>{switch(c){case"arraybuffer":return l.arrayBuffer();case"blob":return l.blob();case"document":return l.text().then(h=>new DOMParser().parseFromString(h,a));case"json":return l.json();default:if(a==="")return l.text();{let u=/charset="?([^;"\s]*)"?/i.exec(a),d=u&&u[1]?u[1].toLowerCase():void 0,f=new TextDecoder(d);return l.arrayBuffer().then(g=>f.decode(g))}}}).then(l=>{Yo.add(`file:${t}`,l);let h=js[t];delete js[t];for(let u=0,d=h.length;u<d;u++){let f=h[u];f.onLoad&&f.onLoad(l)}}).catch(l=>{let h=js[t];if(h===void 0)throw this.manager.itemError(t),l;delete js[t];for(let u=0,d=h.length;u<d;u++){let f=h[u];f.onError&&f.onError(l)}this.manager.itemError(t)}).finally(()=>{this.manager.itemEnd(t)}),this.manager.itemStart(t)}setResponseType(t){return this.responseType=t,this}setMimeType(t){return this.mimeType=t,this}abort(){return this._abortController.abort(),this._abortController=new AbortController,this}};var Vo=new WeakMap,Eh=class extends li{constructor(t){super(t)}load(t,e,n,i){this.path!==void 0&&(t=this.path+t),t=this.manager.resolveURL(t);let r=this,o=Yo.get(`image:${t}`);if(o!==void 0){if(o.complete===!0)r.manager.itemStart(t),setTimeout(function(){e&&e(o),r.manager.itemEnd(t)},0);else{let u=Vo.get(o);u===void 0&&(u=[],Vo.set(o,u)),u.push({onLoad:e,onError:i})}return o}let a=$o("img");function c(){h(),e&&e(this);let u=Vo.get(this)||[];for(let d=0;d<u.length;d++){let f=u[d];f.onLoad&&f.onLoad(this)}Vo.delete(this),r.manager.itemEnd(t)}function l(u){h(),i&&i(u),Yo.remove(`image:${t}`);let d=Vo.get(this)||[];for(let f=0;f<d.length;f++){let g=d[f];g.onError&&g.onError(u)}Vo.delete(this),r.manager.itemError(t),r.manager.itemEnd(t)}function h(){a.removeEventListener("load",c,!1),a.removeEventListener("error",l,!1)}return a.addEventListener("load",c,!1),a.addEventListener("error",l,!1),t.slice(0,5)!=="data:"&&this.crossOrigin!==void 0&&(a.crossOrigin=this.crossOrigin),Yo.add(`image:${t}`,a),r.manager.itemStart(t),a.fetchPriority=this.priority,a.src=t,a}};var Ml=class extends li{constructor(t){super(t)}load(t,e,n,i){let r=this,o=new wr,a=new Is(this.manager);return a.setPriority(this.priority),a.setCache(this.cache),a.setResponseType("arraybuffer"),a.setRequestHeader(this.requestHeader),a.setPath(this.path),a.setWithCredentials(r.withCredentials),a.load(t,function(c){let l;try{l=r.parse(c)}catch(h){i!==void 0?i(h):te(h);return}r._applyTexData(o,l),e&&e(o,l)},n,i),o}createDataTexture(t){let e=new wr;return this._applyTexData(e,this.parse(t)),e}_applyTexData(t,e){e.image!==void 0?t.image=e.image:e.data!==void 0&&(t.image.width=e.width,t.image.height=e.height,t.image.data=e.data),t.wrapS=e.wrapS!==void 0?e.wrapS:_i,t.wrapT=e.wrapT!==void 0?e.wrapT:_i,t.magFilter=e.magFilter!==void 0?e.magFilter:jn,t.minFilter=e.minFilter!==void 0?e.minFilter:jn,t.anisotropy=e.anisotropy!==void 0?e.anisotropy:1,e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.mipmaps!==void 0&&(t.mipmaps=e.mipmaps,t.minFilter=Ki),e.mipmapCount===1&&(t.minFilter=jn),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),t.needsUpdate=!0}},Jr=class extends li{constructor(t){super(t)}load(t,e,n,i){let r=new ri,o=new Eh(this.manager);return o.setPriority(this.priority),o.setCache(this.cache),o.setCrossOrigin(this.crossOrigin),o.setPath(this.path),o.load(t,function(a){r.image=a,r.needsUpdate=!0,e!==void 0&&e(r)},n,i),r}},Ar=class extends De{static registerNode(t){this.prototype._lightNode=t}constructor(t,e=1){super(),this.isLight=!0,this.type="Light",this.color=new qt(t),this.intensity=e}copy(t,e){return super.copy(t,e),this.color.copy(t.color),this.intensity=t.intensity,this}toJSON(t){let e=super.toJSON(t);return e.object.color=this.color.getHex(),e.object.intensity=this.intensity,e}},El=class extends Ar{constructor(t,e,n){super(t,n),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(De.DEFAULT_UP),this.updateMatrix(),this.groundColor=new qt(e)}copy(t,e){return super.copy(t,e),this.groundColor.copy(t.groundColor),this}toJSON(t){let e=super.toJSON(t);return e.object.groundColor=this.groundColor.getHex(),e}},Ef=new Gt,Ug=new F,Fg=new F,ca=class{constructor(t){this.camera=t,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Vt(512,512),this.mapType=Ri,this.map=null,this.mapPass=null,this.matrix=new Gt,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new Mr,this._frameExtents=new Vt(1,1),this._viewportCount=1,this._viewports=[new ze(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(t){let e=this.camera;Ug.setFromMatrixPosition(t.matrixWorld),e.position.copy(Ug),Fg.setFromMatrixPosition(t.target.matrixWorld),e.lookAt(Fg),e.updateMatrixWorld(),this._updateMatrix(e,this.matrix,this._frustum)}_updateMatrix(t,e,n,i){Ef.multiplyMatrices(t.projectionMatrix,t.matrixWorldInverse),n.setFromProjectionMatrix(Ef,t.coordinateSystem,t.reversedDepth);let r=this._frameExtents,o=i?i.z/r.x:1,a=i?i.w/r.y:1,c=i?i.x/r.x:0,l=i?i.y/r.y:0;t.coordinateSystem===Zo||t.reversedDepth?e.set(.5*o,0,0,.5*o+c,0,.5*a,0,.5*a+l,0,0,1,0,0,0,0,1):e.set(.5*o,0,0,.5*o+c,0,.5*a,0,.5*a+l,0,0,.5,.5,0,0,0,1),e.multiply(Ef)}getViewport(t){return this._viewports[t]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(t){return this.camera=t.camera.clone(),this.intensity=t.intensity,this.bias=t.bias,this.radius=t.radius,this.autoUpdate=t.autoUpdate,this.needsUpdate=t.needsUpdate,this.normalBias=t.normalBias,this.blurSamples=t.blurSamples,this.mapSize.copy(t.mapSize),this.mapType=t.mapType,this.biasNode=t.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let t={};return t.intensity=this.intensity,t.bias=this.bias,t.normalBias=this.normalBias,t.radius=this.radius,t.blurSamples=this.blurSamples,t.mapSize=this.mapSize.toArray(),t.mapType=this.mapType,t.camera=this.camera.toJSON(!1).object,delete t.camera.matrix,t}},$c=new F,Jc=new ve,Rs=new F,Tl=class extends De{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Gt,this.projectionMatrix=new Gt,this.projectionMatrixInverse=new Gt,this.coordinateSystem=Yi,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorld.decompose($c,Jc,Rs),Rs.x===1&&Rs.y===1&&Rs.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose($c,Jc,Rs.set(1,1,1)).invert()}updateWorldMatrix(t,e,n=!1){super.updateWorldMatrix(t,e,n),this.matrixWorld.decompose($c,Jc,Rs),Rs.x===1&&Rs.y===1&&Rs.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose($c,Jc,Rs.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},br=new F,kg=new Vt,Og=new Vt,vn=class extends Tl{constructor(t=50,e=1,n=.1,i=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=n,this.far=i,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=qr*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(Xo*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return qr*2*Math.atan(Math.tan(Xo*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,n){br.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(br.x,br.y).multiplyScalar(-t/br.z),br.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(br.x,br.y).multiplyScalar(-t/br.z)}getViewSize(t,e){return this.getViewBounds(t,kg,Og),e.subVectors(Og,kg)}setViewOffset(t,e,n,i,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=i,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan(Xo*.5*this.fov)/this.zoom,n=2*e,i=this.aspect*n,r=-.5*i,o=this.view;if(this.view!==null&&this.view.enabled){let c=o.fullWidth,l=o.fullHeight;r+=o.offsetX*i/c,e-=o.offsetY*n/l,i*=o.width/c,n*=o.height/l}let a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+i,e,e-n,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}},Ff=class extends ca{constructor(){super(new vn(50,1,.5,500)),this.isSpotLightShadow=!0,this.focus=1,this.aspect=1}updateMatrices(t){let e=this.camera,n=qr*2*t.angle*this.focus,i=this.mapSize.width/this.mapSize.height*this.aspect,r=t.distance||e.far;(n!==e.fov||i!==e.aspect||r!==e.far)&&(e.fov=n,e.aspect=i,e.far=r,e.updateProjectionMatrix()),super.updateMatrices(t)}copy(t){return super.copy(t),this.focus=t.focus,this.aspect=t.aspect,this}toJSON(){let t=super.toJSON();return t.focus=this.focus,t.aspect=this.aspect,t}},Al=class extends Ar{constructor(t,e,n=0,i=Math.PI/3,r=0,o=2){super(t,e),this.isSpotLight=!0,this.type="SpotLight",this.position.copy(De.DEFAULT_UP),this.updateMatrix(),this.target=new De,this.distance=n,this.angle=i,this.penumbra=r,this.decay=o,this.map=null,this.shadow=new Ff}get power(){return this.intensity*Math.PI}set power(t){this.intensity=t/Math.PI}dispose(){super.dispose(),this.shadow.dispose()}copy(t,e){return super.copy(t,e),this.distance=t.distance,this.angle=t.angle,this.penumbra=t.penumbra,this.decay=t.decay,this.target=t.target.clone(),this.map=t.map,this.shadow=t.shadow.clone(),this}toJSON(t){let e=super.toJSON(t);return e.object.distance=this.distance,e.object.angle=this.angle,e.object.decay=this.decay,e.object.penumbra=this.penumbra,e.object.target=this.target.uuid,this.map&&this.map.isTexture&&(e.object.map=this.map.toJSON(t).uuid),e.object.shadow=this.shadow.toJSON(),e}},kf=class extends ca{constructor(){super(new vn(90,1,.5,500)),this.isPointLightShadow=!0}},Rl=class extends Ar{constructor(t,e,n=0,i=2){super(t,e),this.isPointLight=!0,this.type="PointLight",this.distance=n,this.decay=i,this.shadow=new kf}get power(){return this.intensity*4*Math.PI}set power(t){this.intensity=t/(4*Math.PI)}dispose(){super.dispose(),this.shadow.dispose()}copy(t,e){return super.copy(t,e),this.distance=t.distance,this.decay=t.decay,this.shadow=t.shadow.clone(),this}toJSON(t){let e=super.toJSON(t);return e.object.distance=this.distance,e.object.decay=this.decay,e.object.shadow=this.shadow.toJSON(),e}},Kr=class extends Tl{constructor(t=-1,e=1,n=1,i=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=n,this.bottom=i,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,n,i,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=i,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,i=(this.top+this.bottom)/2,r=n-t,o=n+t,a=i+e,c=i-e;if(this.view!==null&&this.view.enabled){let l=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=l*this.view.offsetX,o=r+l*this.view.width,a-=h*this.view.offsetY,c=a-h*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,c,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}},Of=class extends ca{constructor(){super(new Kr(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},Rr=class extends Ar{constructor(t,e){super(t,e),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(De.DEFAULT_UP),this.updateMatrix(),this.target=new De,this.shadow=new Of}dispose(){super.dispose(),this.shadow.dispose()}copy(t){return super.copy(t),this.target=t.target.clone(),this.shadow=t.shadow.clone(),this}toJSON(t){let e=super.toJSON(t);return e.object.shadow=this.shadow.toJSON(),e.object.target=this.target.uuid,e}},Cl=class extends Ar{constructor(t,e){super(t,e),this.isAmbientLight=!0,this.type="AmbientLight"}};var Qr=class{static extractUrlBase(t){let e=t.lastIndexOf("/");return e===-1?"./":t.slice(0,e+1)}static resolveURL(t,e){return typeof t!="string"||t===""?"":(/^https?:\/\//i.test(e)&&/^\//.test(t)&&(e=e.replace(/(^https?:\/\/[^\/]+).*/i,"$1")),/^(https?:)?\/\//i.test(t)||/^data:.*,.*$/i.test(t)||/^blob:.*$/i.test(t)?t:e+t)}};var Go=-90,Wo=1,ha=class extends De{constructor(t,e,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let i=new vn(Go,Wo,t,e);i.layers=this.layers,this.add(i);let r=new vn(Go,Wo,t,e);r.layers=this.layers,this.add(r);let o=new vn(Go,Wo,t,e);o.layers=this.layers,this.add(o);let a=new vn(Go,Wo,t,e);a.layers=this.layers,this.add(a);let c=new vn(Go,Wo,t,e);c.layers=this.layers,this.add(c);let l=new vn(Go,Wo,t,e);l.layers=this.layers,this.add(l)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[n,i,r,o,a,c]=e;for(let l of e)this.remove(l);if(t===Yi)n.up.set(0,1,0),n.lookAt(1,0,0),i.up.set(0,1,0),i.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),c.up.set(0,1,0),c.lookAt(0,0,-1);else if(t===Zo)n.up.set(0,-1,0),n.lookAt(-1,0,0),i.up.set(0,-1,0),i.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),c.up.set(0,-1,0),c.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let l of e)this.add(l),l.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:i}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,c,l,h]=this.children,u=t.getRenderTarget(),d=t.getActiveCubeFace(),f=t.getActiveMipmapLevel(),g=t.xr.enabled;t.xr.enabled=!1;let y=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let p=!1;t.isWebGLRenderer===!0?p=t.state.buffers.depth.getReversed():p=t.reversedDepthBuffer,t.setRenderTarget(n,0,i),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,r),t.setRenderTarget(n,1,i),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,o),t.setRenderTarget(n,2,i),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,a),t.setRenderTarget(n,3,i),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,c),t.setRenderTarget(n,4,i),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,l),n.texture.mipmapsAutoUpdate=y,t.setRenderTarget(n,5,i),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,h),t.setRenderTarget(u,d,f),t.xr.enabled=g,n.texture.needsPMREMUpdate=!0}},Th=class extends vn{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t,this.perCameraFrustumCulled=!1}};var gp="\\[\\]\\.:\\/",xv=new RegExp("["+gp+"]","g"),xp="[^"+gp+"]",_v="[^"+gp.replace("\\.","")+"]",yv=/((?:WC+[\/:])*)/.source.replace("WC",xp),bv=/(WCOD+)?/.source.replace("WCOD",_v),vv=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",xp),wv=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",xp),Sv=new RegExp("^"+yv+bv+vv+wv+"$"),Mv=["material","materials","bones","map"],Bf=class{constructor(t,e,n){let i=n||rn.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,i)}getValue(t,e){this.bind();let n=this._targetGroup.nCachedObjects_,i=this._bindings[n];i!==void 0&&i.getValue(t,e)}setValue(t,e){let n=this._bindings;for(let i=this._targetGroup.nCachedObjects_,r=n.length;i!==r;++i)n[i].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,n=t.length;e!==n;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,n=t.length;e!==n;++e)t[e].unbind()}},rn=class s{constructor(t,e,n){this.path=e,this.parsedPath=n||s.parseTrackName(e),this.node=s.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,n){return t&&t.isAnimationObjectGroup?new s.Composite(t,e,n):new s(t,e,n)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(xv,"")}static parseTrackName(t){let e=Sv.exec(t);if(e===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+t);let n={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},i=n.nodeName&&n.nodeName.lastIndexOf(".");if(i!==void 0&&i!==-1){let r=n.nodeName.substring(i+1);Mv.indexOf(r)!==-1&&(n.nodeName=n.nodeName.substring(0,i),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+t);return n}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let n=t.skeleton.getBoneByName(e);if(n!==void 0)return n}if(t.children){let n=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===e||a.uuid===e)return a;let c=n(a.children);if(c)return c}return null},i=n(t.children);if(i)return i}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let n=this.resolvedProperty;for(let i=0,r=n.length;i!==r;++i)t[e++]=n[i]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let n=this.resolvedProperty;for(let i=0,r=n.length;i!==r;++i)n[i]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let n=this.resolvedProperty;for(let i=0,r=n.length;i!==r;++i)n[i]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let n=this.resolvedProperty;for(let i=0,r=n.length;i!==r;++i)n[i]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,n=e.objectName,i=e.propertyName,r=e.propertyIndex;if(t||(t=s.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){Zt("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let l=e.objectIndex;switch(n){case"materials":if(!t.material){te("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){te("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){te("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let h=0;h<t.length;h++)if(t[h].name===l){l=h;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){te("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){te("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[n]===void 0){te("PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[n]}if(l!==void 0){if(t[l]===void 0){te("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[l]}}let o=t[i];if(o===void 0){let l=e.nodeName;te("PropertyBinding: Trying to update property for track: "+l+"."+i+" but it wasn't found.",t);return}let a=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?a=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let c=this.BindingType.Direct;if(r!==void 0){if(i==="morphTargetInfluences"){if(!t.geometry){te("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){te("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[r]!==void 0&&(r=t.morphTargetDictionary[r])}c=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(c=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(c=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=i;this.getValue=this.GetterByBindingType[c],this.setValue=this.SetterByBindingTypeAndVersioning[c][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};rn.Composite=Bf;rn.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};rn.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};rn.prototype.GetterByBindingType=[rn.prototype._getValue_direct,rn.prototype._getValue_array,rn.prototype._getValue_arrayElement,rn.prototype._getValue_toArray];rn.prototype.SetterByBindingTypeAndVersioning=[[rn.prototype._setValue_direct,rn.prototype._setValue_direct_setNeedsUpdate,rn.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[rn.prototype._setValue_array,rn.prototype._setValue_array_setNeedsUpdate,rn.prototype._setValue_array_setMatrixWorldNeedsUpdate],[rn.prototype._setValue_arrayElement,rn.prototype._setValue_arrayElement_setNeedsUpdate,rn.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[rn.prototype._setValue_fromArray,rn.prototype._setValue_fromArray_setNeedsUpdate,rn.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var nC=new Float32Array(1);var Bg=new Gt,to=class{constructor(t,e,n=0,i=1/0){this.ray=new Cs(t,e),this.near=n,this.far=i,this.camera=null,this.layers=new Qo,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(t,e){this.ray.set(t,e)}setFromCamera(t,e){e.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(t.x,t.y,.5).unproject(e).sub(this.ray.origin).normalize(),this.camera=e):e.isOrthographicCamera?(this.ray.origin.set(t.x,t.y,e.projectionMatrix.elements[14]).unproject(e),this.ray.direction.set(0,0,-1).transformDirection(e.matrixWorld),this.camera=e):te("Raycaster: Unsupported camera type: "+e.type)}setFromXRController(t){return Bg.identity().extractRotation(t.matrixWorld),this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(Bg),this}intersectObject(t,e=!0,n=[]){return zf(t,this,n,e),n.sort(zg),n}intersectObjects(t,e=!0,n=[]){for(let i=0,r=t.length;i<r;i++)zf(t[i],this,n,e);return n.sort(zg),n}};function zg(s,t){return s.distance-t.distance}function zf(s,t,e,n){let i=!0;if(s.layers.test(t.layers)&&s.raycast(t,e)===!1&&(i=!1),i===!0&&n===!0){let r=s.children;for(let o=0,a=r.length;o<a;o++)zf(r[o],t,e,!0)}}var ua=class{constructor(t=1,e=0,n=0){this.radius=t,this.phi=e,this.theta=n}set(t,e,n){return this.radius=t,this.phi=e,this.theta=n,this}copy(t){return this.radius=t.radius,this.phi=t.phi,this.theta=t.theta,this}makeSafe(){return this.phi=_e(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(t){return this.setFromCartesianCoords(t.x,t.y,t.z)}setFromCartesianCoords(t,e,n){return this.radius=Math.sqrt(t*t+e*e+n*n),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(t,n),this.phi=Math.acos(_e(e/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var Hf=class{static{this.prototype.isMatrix2=!0}constructor(t,e,n,i){this.elements=[1,0,0,1],t!==void 0&&this.set(t,e,n,i)}identity(){return this.set(1,0,0,1),this}fromArray(t,e=0){for(let n=0;n<4;n++)this.elements[n]=t[n+e];return this}set(t,e,n,i){let r=this.elements;return r[0]=t,r[2]=e,r[1]=n,r[3]=i,this}};var Hg=new F,Kc,Tf,Pl=class extends De{constructor(t=new F(0,0,1),e=new F(0,0,0),n=1,i=16776960,r=n*.2,o=r*.2){super(),this.type="ArrowHelper",Kc===void 0&&(Kc=new ue,Kc.setAttribute("position",new Xt([0,0,0,0,1,0],3)),Tf=new ia(.5,1,5,1),Tf.translate(0,-.5,0)),this.position.copy(e),this.line=new Fn(Kc,new pn({color:i,toneMapped:!1})),this.line.matrixAutoUpdate=!1,this.add(this.line),this.cone=new gt(Tf,new Qe({color:i,toneMapped:!1})),this.cone.matrixAutoUpdate=!1,this.add(this.cone),this.setDirection(t),this.setLength(n,r,o)}setDirection(t){if(t.y>.99999)this.quaternion.set(0,0,0,1);else if(t.y<-.99999)this.quaternion.set(1,0,0,0);else{Hg.set(t.z,0,-t.x).normalize();let e=Math.acos(t.y);this.quaternion.setFromAxisAngle(Hg,e)}}setLength(t,e=t*.2,n=e*.2){this.line.scale.set(1,Math.max(1e-4,t-e),1),this.line.updateMatrix(),this.cone.scale.set(n,e,n),this.cone.position.y=t,this.cone.updateMatrix()}setColor(t){this.line.material.color.set(t),this.cone.material.color.set(t)}copy(t){return super.copy(t,!1),this.line.copy(t.line),this.cone.copy(t.cone),this}dispose(){super.dispose(),this.line.geometry.dispose(),this.line.material.dispose(),this.cone.geometry.dispose(),this.cone.material.dispose()}};var eo=class extends fs{constructor(t,e=null){super(),this.object=t,this.domElement=e,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(t){this.domElement!==null&&this.disconnect(),this.domElement=t}disconnect(){}dispose(){}update(){}};function _p(s,t,e,n){let i=Ev(n);switch(e){case rp:return s*t;case Nh:return s*t/i.components*i.byteLength;case Dh:return s*t/i.components*i.byteLength;case Ir:return s*t*2/i.components*i.byteLength;case Uh:return s*t*2/i.components*i.byteLength;case op:return s*t*3/i.components*i.byteLength;case Qi:return s*t*4/i.components*i.byteLength;case Fh:return s*t*4/i.components*i.byteLength;case Dl:case Ul:return Math.floor((s+3)/4)*Math.floor((t+3)/4)*8;case Fl:case kl:return Math.floor((s+3)/4)*Math.floor((t+3)/4)*16;case Oh:case zh:return Math.max(s,16)*Math.max(t,8)/4;case kh:case Bh:return Math.max(s,8)*Math.max(t,8)/2;case Hh:case Vh:case Wh:case Xh:return Math.floor((s+3)/4)*Math.floor((t+3)/4)*8;case Gh:case Ol:case qh:return Math.floor((s+3)/4)*Math.floor((t+3)/4)*16;case Yh:return Math.floor((s+3)/4)*Math.floor((t+3)/4)*16;case jh:return Math.floor((s+4)/5)*Math.floor((t+3)/4)*16;case Zh:return Math.floor((s+4)/5)*Math.floor((t+4)/5)*16;case $h:return Math.floor((s+5)/6)*Math.floor((t+4)/5)*16;case Jh:return Math.floor((s+5)/6)*Math.floor((t+5)/6)*16;case Kh:return Math.floor((s+7)/8)*Math.floor((t+4)/5)*16;case Qh:return Math.floor((s+7)/8)*Math.floor((t+5)/6)*16;case tu:return Math.floor((s+7)/8)*Math.floor((t+7)/8)*16;case eu:return Math.floor((s+9)/10)*Math.floor((t+4)/5)*16;case nu:return Math.floor((s+9)/10)*Math.floor((t+5)/6)*16;case iu:return Math.floor((s+9)/10)*Math.floor((t+7)/8)*16;case su:return Math.floor((s+9)/10)*Math.floor((t+9)/10)*16;case ru:return Math.floor((s+11)/12)*Math.floor((t+9)/10)*16;case ou:return Math.floor((s+11)/12)*Math.floor((t+11)/12)*16;case au:case lu:case cu:return Math.ceil(s/4)*Math.ceil(t/4)*16;case hu:case uu:return Math.ceil(s/4)*Math.ceil(t/4)*8;case Bl:case du:return Math.ceil(s/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function Ev(s){switch(s){case Ri:case ep:return{byteLength:1,components:1};case ma:case np:case gs:return{byteLength:2,components:1};case Ih:case Lh:return{byteLength:2,components:4};case ms:case Ph:case Bi:return{byteLength:4,components:1};case ip:case sp:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${s}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Zt("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function ix(){let s=null,t=!1,e=null,n=null;function i(r,o){n=s.requestAnimationFrame(i),e(r,o)}return{start:function(){t!==!0&&e!==null&&s!==null&&(n=s.requestAnimationFrame(i),t=!0)},stop:function(){s!==null&&s.cancelAnimationFrame(n),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){s=r}}}function Lv(s){let t=new WeakMap;function e(a,c){let l=a.array,h=a.usage,u=l.byteLength,d=s.createBuffer();s.bindBuffer(c,d),s.bufferData(c,l,h),a.onUploadCallback();let f;if(l instanceof Float32Array)f=s.FLOAT;else if(typeof Float16Array<"u"&&l instanceof Float16Array)f=s.HALF_FLOAT;else if(l instanceof Uint16Array)a.isFloat16BufferAttribute?f=s.HALF_FLOAT:f=s.UNSIGNED_SHORT;else if(l instanceof Int16Array)f=s.SHORT;else if(l instanceof Uint32Array)f=s.UNSIGNED_INT;else if(l instanceof Int32Array)f=s.INT;else if(l instanceof Int8Array)f=s.BYTE;else if(l instanceof Uint8Array)f=s.UNSIGNED_BYTE;else if(l instanceof Uint8ClampedArray)f=s.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+l);return{buffer:d,type:f,bytesPerElement:l.BYTES_PER_ELEMENT,version:a.version,size:u}}function n(a,c,l){let h=c.array,u=c.updateRanges;if(s.bindBuffer(l,a),u.length===0)s.bufferSubData(l,0,h);else{u.sort((f,g)=>f.start-g.start);let d=0;for(let f=1;f<u.length;f++){let g=u[d],y=u[f];y.start<=g.start+g.count+1?g.count=Math.max(g.count,y.start+y.count-g.start):(++d,u[d]=y)}u.length=d+1;for(let f=0,g=u.length;f<g;f++){let y=u[f];s.bufferSubData(l,y.start*h.BYTES_PER_ELEMENT,h,y.start,y.count)}c.clearUpdateRanges()}c.onUploadCallback()}function i(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let c=t.get(a);c&&(s.deleteBuffer(c.buffer),t.delete(a))}function o(a,c){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let h=t.get(a);(!h||h.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let l=t.get(a);if(l===void 0)t.set(a,e(a,c));else if(l.version<a.version){if(l.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(l.buffer,a,c),l.version=a.version}}return{get:i,remove:r,update:o}}var Nv=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,Dv=`#ifdef USE_ALPHAHASH
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
#endif`,Uv=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,Fv=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,kv=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,Ov=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,Bv=`#ifdef USE_AOMAP
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
#endif`,zv=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,Hv=`#ifdef USE_BATCHING
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
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,Vv=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,Gv=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,Wv=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,Xv=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,qv=`#ifdef USE_IRIDESCENCE
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
#endif`,Yv=`#ifdef USE_BUMPMAP
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
#endif`,jv=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,Zv=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,$v=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,Jv=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,Kv=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,Qv=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,tw=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,ew=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,nw=`#define PI 3.141592653589793
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
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
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
} // validated`,iw=`vec3 transformedNormal = objectNormal;
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
#endif`,sw=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,rw=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,ow=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,aw=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,lw="gl_FragColor = linearToOutputTexel( gl_FragColor );",cw=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,hw=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,uw=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,dw=`#ifdef USE_ENVMAP
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
#endif`,fw=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,pw=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,mw=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,gw=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,xw=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,_w=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,yw=`#ifdef USE_GRADIENTMAP
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
}`,bw=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,vw=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,ww=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,Sw=`uniform bool receiveShadow;
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
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
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
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
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
#endif
#include <lightprobes_pars_fragment>`,Mw=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,Ew=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,Tw=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,Aw=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,Rw=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,Cw=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
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
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
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
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
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
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
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
#endif`,Pw=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
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
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
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
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
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
		return 0.5 / max( gv + gl, EPSILON );
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
		float roughness = max( material.clearcoatRoughness, 0.045 );
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
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
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
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
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
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
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
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
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
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
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
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,Iw=`
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
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
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
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
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
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
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
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,Lw=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,Nw=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,Dw=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,Uw=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,Fw=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,kw=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Ow=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,Bw=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,zw=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,Hw=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,Vw=`#if defined( USE_POINTS_UV )
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
#endif`,Gw=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,Ww=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,Xw=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,qw=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,Yw=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,jw=`#ifdef USE_MORPHTARGETS
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
#endif`,Zw=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,$w=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
	#ifdef DOUBLE_SIDED
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
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,Jw=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,Kw=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Qw=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,tS=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,eS=`#ifdef USE_NORMALMAP
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
#endif`,nS=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,iS=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,sS=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,rS=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,oS=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,aS=`vec3 packNormalToRGB( const in vec3 normal ) {
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
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,lS=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,cS=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,hS=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,uS=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,dS=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,fS=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,pS=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
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
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
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
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
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
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,mS=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
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
#endif`,gS=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
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
#endif`,xS=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
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
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
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
}`,_S=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,yS=`#ifdef USE_SKINNING
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
#endif`,bS=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,vS=`#ifdef USE_SKINNING
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
#endif`,wS=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,SS=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,MS=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,ES=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,TS=`#ifdef USE_TRANSMISSION
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
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,AS=`#ifdef USE_TRANSMISSION
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
#endif`,RS=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
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
#endif`,CS=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
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
#endif`,PS=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
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
#endif`,IS=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,LS=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,NS=`uniform sampler2D t2D;
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
}`,DS=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,US=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,FS=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,kS=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,OS=`#include <common>
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
}`,BS=`#if DEPTH_PACKING == 3200
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
}`,zS=`#define DISTANCE
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
}`,HS=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,VS=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,GS=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,WS=`uniform float scale;
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
}`,XS=`uniform vec3 diffuse;
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
}`,qS=`#include <common>
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
}`,YS=`uniform vec3 diffuse;
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
}`,jS=`#define LAMBERT
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
}`,ZS=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
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
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
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
}`,$S=`#define MATCAP
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
}`,JS=`#define MATCAP
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
}`,KS=`#define NORMAL
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
}`,QS=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
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
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,tM=`#define PHONG
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
}`,eM=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
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
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
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
}`,nM=`#define STANDARD
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
}`,iM=`#define STANDARD
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
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
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
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
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
}`,sM=`#define TOON
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
}`,rM=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
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
}`,oM=`uniform float size;
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
}`,aM=`uniform vec3 diffuse;
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
}`,lM=`#include <common>
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
}`,cM=`uniform vec3 color;
uniform float opacity;
#include <common>
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
	#include <premultiplied_alpha_fragment>
}`,hM=`uniform float rotation;
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
}`,uM=`uniform vec3 diffuse;
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
}`,pe={alphahash_fragment:Nv,alphahash_pars_fragment:Dv,alphamap_fragment:Uv,alphamap_pars_fragment:Fv,alphatest_fragment:kv,alphatest_pars_fragment:Ov,aomap_fragment:Bv,aomap_pars_fragment:zv,batching_pars_vertex:Hv,batching_vertex:Vv,begin_vertex:Gv,beginnormal_vertex:Wv,bsdfs:Xv,iridescence_fragment:qv,bumpmap_pars_fragment:Yv,clipping_planes_fragment:jv,clipping_planes_pars_fragment:Zv,clipping_planes_pars_vertex:$v,clipping_planes_vertex:Jv,color_fragment:Kv,color_pars_fragment:Qv,color_pars_vertex:tw,color_vertex:ew,common:nw,defaultnormal_vertex:iw,displacementmap_pars_vertex:sw,displacementmap_vertex:rw,emissivemap_fragment:ow,emissivemap_pars_fragment:aw,colorspace_fragment:lw,colorspace_pars_fragment:cw,envmap_fragment:hw,envmap_common_pars_fragment:uw,envmap_pars_fragment:dw,envmap_pars_vertex:fw,envmap_physical_pars_fragment:Mw,envmap_vertex:pw,fog_vertex:mw,fog_pars_vertex:gw,fog_fragment:xw,fog_pars_fragment:_w,gradientmap_pars_fragment:yw,lightmap_pars_fragment:bw,lights_lambert_fragment:vw,lights_lambert_pars_fragment:ww,lights_pars_begin:Sw,lights_toon_fragment:Ew,lights_toon_pars_fragment:Tw,lights_phong_fragment:Aw,lights_phong_pars_fragment:Rw,lights_physical_fragment:Cw,lights_physical_pars_fragment:Pw,lights_fragment_begin:Iw,lights_fragment_maps:Lw,lights_fragment_end:Nw,lightprobes_pars_fragment:Dw,logdepthbuf_fragment:Uw,logdepthbuf_pars_fragment:Fw,logdepthbuf_pars_vertex:kw,logdepthbuf_vertex:Ow,map_fragment:Bw,map_pars_fragment:zw,map_particle_fragment:Hw,map_particle_pars_fragment:Vw,metalnessmap_fragment:Gw,metalnessmap_pars_fragment:Ww,morphinstance_vertex:Xw,morphcolor_vertex:qw,morphnormal_vertex:Yw,morphtarget_pars_vertex:jw,morphtarget_vertex:Zw,normal_fragment_begin:$w,normal_fragment_maps:Jw,normal_pars_fragment:Kw,normal_pars_vertex:Qw,normal_vertex:tS,normalmap_pars_fragment:eS,clearcoat_normal_fragment_begin:nS,clearcoat_normal_fragment_maps:iS,clearcoat_pars_fragment:sS,iridescence_pars_fragment:rS,opaque_fragment:oS,packing:aS,premultiplied_alpha_fragment:lS,project_vertex:cS,dithering_fragment:hS,dithering_pars_fragment:uS,roughnessmap_fragment:dS,roughnessmap_pars_fragment:fS,shadowmap_pars_fragment:pS,shadowmap_pars_vertex:mS,shadowmap_vertex:gS,shadowmask_pars_fragment:xS,skinbase_vertex:_S,skinning_pars_vertex:yS,skinning_vertex:bS,skinnormal_vertex:vS,specularmap_fragment:wS,specularmap_pars_fragment:SS,tonemapping_fragment:MS,tonemapping_pars_fragment:ES,transmission_fragment:TS,transmission_pars_fragment:AS,uv_pars_fragment:RS,uv_pars_vertex:CS,uv_vertex:PS,worldpos_vertex:IS,background_vert:LS,background_frag:NS,backgroundCube_vert:DS,backgroundCube_frag:US,cube_vert:FS,cube_frag:kS,depth_vert:OS,depth_frag:BS,distance_vert:zS,distance_frag:HS,equirect_vert:VS,equirect_frag:GS,linedashed_vert:WS,linedashed_frag:XS,meshbasic_vert:qS,meshbasic_frag:YS,meshlambert_vert:jS,meshlambert_frag:ZS,meshmatcap_vert:$S,meshmatcap_frag:JS,meshnormal_vert:KS,meshnormal_frag:QS,meshphong_vert:tM,meshphong_frag:eM,meshphysical_vert:nM,meshphysical_frag:iM,meshtoon_vert:sM,meshtoon_frag:rM,points_vert:oM,points_frag:aM,shadow_vert:lM,shadow_frag:cM,sprite_vert:hM,sprite_frag:uM},Lt={common:{diffuse:{value:new qt(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new ie},alphaMap:{value:null},alphaMapTransform:{value:new ie},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new ie}},envmap:{envMap:{value:null},envMapRotation:{value:new ie},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new ie}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new ie}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new ie},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new ie},normalScale:{value:new Vt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new ie},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new ie}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new ie}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new ie}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new qt(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new qt(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new ie},alphaTest:{value:0},uvTransform:{value:new ie}},sprite:{diffuse:{value:new qt(16777215)},opacity:{value:1},center:{value:new Vt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new ie},alphaMap:{value:null},alphaMapTransform:{value:new ie},alphaTest:{value:0}}},Ds={basic:{uniforms:hi([Lt.common,Lt.specularmap,Lt.envmap,Lt.aomap,Lt.lightmap,Lt.fog]),vertexShader:pe.meshbasic_vert,fragmentShader:pe.meshbasic_frag},lambert:{uniforms:hi([Lt.common,Lt.specularmap,Lt.envmap,Lt.aomap,Lt.lightmap,Lt.emissivemap,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,Lt.fog,Lt.lights,{emissive:{value:new qt(0)},envMapIntensity:{value:1}}]),vertexShader:pe.meshlambert_vert,fragmentShader:pe.meshlambert_frag},phong:{uniforms:hi([Lt.common,Lt.specularmap,Lt.envmap,Lt.aomap,Lt.lightmap,Lt.emissivemap,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,Lt.fog,Lt.lights,{emissive:{value:new qt(0)},specular:{value:new qt(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:pe.meshphong_vert,fragmentShader:pe.meshphong_frag},standard:{uniforms:hi([Lt.common,Lt.envmap,Lt.aomap,Lt.lightmap,Lt.emissivemap,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,Lt.roughnessmap,Lt.metalnessmap,Lt.fog,Lt.lights,{emissive:{value:new qt(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:pe.meshphysical_vert,fragmentShader:pe.meshphysical_frag},toon:{uniforms:hi([Lt.common,Lt.aomap,Lt.lightmap,Lt.emissivemap,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,Lt.gradientmap,Lt.fog,Lt.lights,{emissive:{value:new qt(0)}}]),vertexShader:pe.meshtoon_vert,fragmentShader:pe.meshtoon_frag},matcap:{uniforms:hi([Lt.common,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,Lt.fog,{matcap:{value:null}}]),vertexShader:pe.meshmatcap_vert,fragmentShader:pe.meshmatcap_frag},points:{uniforms:hi([Lt.points,Lt.fog]),vertexShader:pe.points_vert,fragmentShader:pe.points_frag},dashed:{uniforms:hi([Lt.common,Lt.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:pe.linedashed_vert,fragmentShader:pe.linedashed_frag},depth:{uniforms:hi([Lt.common,Lt.displacementmap]),vertexShader:pe.depth_vert,fragmentShader:pe.depth_frag},normal:{uniforms:hi([Lt.common,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,{opacity:{value:1}}]),vertexShader:pe.meshnormal_vert,fragmentShader:pe.meshnormal_frag},sprite:{uniforms:hi([Lt.sprite,Lt.fog]),vertexShader:pe.sprite_vert,fragmentShader:pe.sprite_frag},background:{uniforms:{uvTransform:{value:new ie},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:pe.background_vert,fragmentShader:pe.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new ie}},vertexShader:pe.backgroundCube_vert,fragmentShader:pe.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:pe.cube_vert,fragmentShader:pe.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:pe.equirect_vert,fragmentShader:pe.equirect_frag},distance:{uniforms:hi([Lt.common,Lt.displacementmap,{referencePosition:{value:new F},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:pe.distance_vert,fragmentShader:pe.distance_frag},shadow:{uniforms:hi([Lt.lights,Lt.fog,{color:{value:new qt(0)},opacity:{value:1}}]),vertexShader:pe.shadow_vert,fragmentShader:pe.shadow_frag}};Ds.physical={uniforms:hi([Ds.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new ie},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new ie},clearcoatNormalScale:{value:new Vt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new ie},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new ie},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new ie},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new ie},sheen:{value:0},sheenColor:{value:new qt(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new ie},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new ie},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new ie},transmissionSamplerSize:{value:new Vt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new ie},attenuationDistance:{value:0},attenuationColor:{value:new qt(0)},specularColor:{value:new qt(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new ie},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new ie},anisotropyVector:{value:new Vt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new ie}}]),vertexShader:pe.meshphysical_vert,fragmentShader:pe.meshphysical_frag};var pu={r:0,b:0,g:0},dM=new Gt,sx=new ie;sx.set(-1,0,0,0,1,0,0,0,1);function fM(s,t,e,n,i,r){let o=new qt(0),a=i===!0?0:1,c,l,h=null,u=0,d=null;function f(x){let v=x.isScene===!0?x.background:null;if(v&&v.isTexture){let _=x.backgroundBlurriness>0;v=t.get(v,_)}return v}function g(x){let v=!1,_=f(x);_===null?p(o,a):_&&_.isColor&&(p(_,1),v=!0);let E=s.xr.getEnvironmentBlendMode();E==="additive"?e.buffers.color.setClear(0,0,0,1,r):E==="alpha-blend"&&e.buffers.color.setClear(0,0,0,0,r),(s.autoClear||v)&&(e.buffers.depth.setTest(!0),e.buffers.depth.setMask(!0),e.buffers.color.setMask(!0),s.clear(s.autoClearColor,s.autoClearDepth,s.autoClearStencil))}function y(x,v){let _=f(v);_&&_.isCubeTexture?(l===void 0&&(l=new gt(new qe(1,1,1),new Zi({name:"BackgroundCubeMaterial",uniforms:ao(Ds.backgroundCube.uniforms),vertexShader:Ds.backgroundCube.vertexShader,fragmentShader:Ds.backgroundCube.fragmentShader,side:bi,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),l.geometry.deleteAttribute("uv"),l.onBeforeRender=function(E,w,b){this.matrixWorld.copyPosition(b.matrixWorld)},Object.defineProperty(l.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),n.update(l)),l.material.uniforms.envMap.value=_,l.material.uniforms.backgroundBlurriness.value=v.backgroundBlurriness,l.material.uniforms.backgroundIntensity.value=v.backgroundIntensity,l.material.uniforms.backgroundRotation.value.setFromMatrix4(dM.makeRotationFromEuler(v.backgroundRotation)).transpose(),_.isRenderTargetTexture===!1&&l.material.uniforms.backgroundRotation.value.premultiply(sx),l.material.toneMapped=he.getTransfer(_.colorSpace)!==Ne,(h!==_||u!==_.version||d!==s.toneMapping)&&(l.material.needsUpdate=!0,h=_,u=_.version,d=s.toneMapping),l.layers.enableAll(),x.unshift(l,l.geometry,l.material,0,0,null)):_&&_.isTexture&&(c===void 0&&(c=new gt(new Qs(2,2),new Zi({name:"BackgroundMaterial",uniforms:ao(Ds.background.uniforms),vertexShader:Ds.background.vertexShader,fragmentShader:Ds.background.fragmentShader,side:Ls,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),Object.defineProperty(c.material,"map",{get:function(){return this.uniforms.t2D.value}}),n.update(c)),c.material.uniforms.t2D.value=_,c.material.uniforms.backgroundIntensity.value=v.backgroundIntensity,c.material.toneMapped=he.getTransfer(_.colorSpace)!==Ne,_.matrixAutoUpdate===!0&&_.updateMatrix(),c.material.uniforms.uvTransform.value.copy(_.matrix),(h!==_||u!==_.version||d!==s.toneMapping)&&(c.material.needsUpdate=!0,h=_,u=_.version,d=s.toneMapping),c.layers.enableAll(),x.unshift(c,c.geometry,c.material,0,0,null))}function p(x,v){x.getRGB(pu,mp(s)),e.buffers.color.setClear(pu.r,pu.g,pu.b,v,r)}function m(){l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0),c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0)}return{getClearColor:function(){return o},setClearColor:function(x,v=1){o.set(x),a=v,p(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(x){a=x,p(o,a)},render:g,addToRenderList:y,dispose:m}}function pM(s,t){let e=s.getParameter(s.MAX_VERTEX_ATTRIBS),n={},i=d(null),r=i,o=!1;function a(C,D,B,L,z){let O=!1,H=u(C,L,B,D);r!==H&&(r=H,l(r.object)),O=f(C,L,B,z),O&&g(C,L,B,z),z!==null&&t.update(z,s.ELEMENT_ARRAY_BUFFER),(O||o)&&(o=!1,_(C,D,B,L),z!==null&&s.bindBuffer(s.ELEMENT_ARRAY_BUFFER,t.get(z).buffer))}function c(){return s.createVertexArray()}function l(C){return s.bindVertexArray(C)}function h(C){return s.deleteVertexArray(C)}function u(C,D,B,L){let z=L.wireframe===!0,O=n[D.id];O===void 0&&(O={},n[D.id]=O);let H=C.isInstancedMesh===!0?C.id:0,tt=O[H];tt===void 0&&(tt={},O[H]=tt);let X=tt[B.id];X===void 0&&(X={},tt[B.id]=X);let Z=X[z];return Z===void 0&&(Z=d(c()),X[z]=Z),Z}function d(C){let D=[],B=[],L=[];for(let z=0;z<e;z++)D[z]=0,B[z]=0,L[z]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:D,enabledAttributes:B,attributeDivisors:L,object:C,attributes:{},index:null}}function f(C,D,B,L){let z=r.attributes,O=D.attributes,H=0,tt=B.getAttributes();for(let X in tt)if(tt[X].location>=0){let $=z[X],at=O[X];if(at===void 0&&(X==="instanceMatrix"&&C.instanceMatrix&&(at=C.instanceMatrix),X==="instanceColor"&&C.instanceColor&&(at=C.instanceColor)),$===void 0||$.attribute!==at||at&&$.data!==at.data)return!0;H++}return r.attributesNum!==H||r.index!==L}function g(C,D,B,L){let z={},O=D.attributes,H=0,tt=B.getAttributes();for(let X in tt)if(tt[X].location>=0){let $=O[X];$===void 0&&(X==="instanceMatrix"&&C.instanceMatrix&&($=C.instanceMatrix),X==="instanceColor"&&C.instanceColor&&($=C.instanceColor));let at={};at.attribute=$,$&&$.data&&(at.data=$.data),z[X]=at,H++}r.attributes=z,r.attributesNum=H,r.index=L}function y(){let C=r.newAttributes;for(let D=0,B=C.length;D<B;D++)C[D]=0}function p(C){m(C,0)}function m(C,D){let B=r.newAttributes,L=r.enabledAttributes,z=r.attributeDivisors;B[C]=1,L[C]===0&&(s.enableVertexAttribArray(C),L[C]=1),z[C]!==D&&(s.vertexAttribDivisor(C,D),z[C]=D)}function x(){let C=r.newAttributes,D=r.enabledAttributes;for(let B=0,L=D.length;B<L;B++)D[B]!==C[B]&&(s.disableVertexAttribArray(B),D[B]=0)}function v(C,D,B,L,z,O,H){H===!0?s.vertexAttribIPointer(C,D,B,z,O):s.vertexAttribPointer(C,D,B,L,z,O)}function _(C,D,B,L){y();let z=L.attributes,O=B.getAttributes(),H=D.defaultAttributeValues;for(let tt in O){let X=O[tt];if(X.location>=0){let Z=z[tt];if(Z===void 0&&(tt==="instanceMatrix"&&C.instanceMatrix&&(Z=C.instanceMatrix),tt==="instanceColor"&&C.instanceColor&&(Z=C.instanceColor)),Z!==void 0){let $=Z.normalized,at=Z.itemSize,it=t.get(Z);if(it===void 0)continue;let Y=it.buffer,st=it.type,nt=it.bytesPerElement,lt=st===s.INT||st===s.UNSIGNED_INT||Z.gpuType===Ph;if(Z.isInterleavedBufferAttribute){let mt=Z.data,Ut=mt.isInterleavedBuffer===!0?mt.stride:mt.itemSize,Jt=Z.offset;if(mt.isInstancedInterleavedBuffer||mt.isInstancedBufferAttribute){for(let Ot=0;Ot<X.locationSize;Ot++)m(X.location+Ot,mt.meshPerAttribute);C.isInstancedMesh!==!0&&L._maxInstanceCount===void 0&&(L._maxInstanceCount=mt.meshPerAttribute*mt.count)}else for(let Ot=0;Ot<X.locationSize;Ot++)p(X.location+Ot);s.bindBuffer(s.ARRAY_BUFFER,Y);for(let Ot=0;Ot<X.locationSize;Ot++)v(X.location+Ot,at/X.locationSize,st,$,Ut*nt,(Jt+at/X.locationSize*Ot)*nt,lt)}else{if(Z.isInstancedBufferAttribute){for(let mt=0;mt<X.locationSize;mt++)m(X.location+mt,Z.meshPerAttribute);C.isInstancedMesh!==!0&&L._maxInstanceCount===void 0&&(L._maxInstanceCount=Z.meshPerAttribute*Z.count)}else for(let mt=0;mt<X.locationSize;mt++)p(X.location+mt);s.bindBuffer(s.ARRAY_BUFFER,Y);for(let mt=0;mt<X.locationSize;mt++)v(X.location+mt,at/X.locationSize,st,$,at*nt,at/X.locationSize*mt*nt,lt)}}else if(H!==void 0){let $=H[tt];if($!==void 0)switch($.length){case 2:s.vertexAttrib2fv(X.location,$);break;case 3:s.vertexAttrib3fv(X.location,$);break;case 4:s.vertexAttrib4fv(X.location,$);break;default:s.vertexAttrib1fv(X.location,$)}}}}x()}function E(){I();for(let C in n){let D=n[C];for(let B in D){let L=D[B];for(let z in L){let O=L[z];for(let H in O)h(O[H].object),delete O[H];delete L[z]}}delete n[C]}}function w(C){if(n[C.id]===void 0)return;let D=n[C.id];for(let B in D){let L=D[B];for(let z in L){let O=L[z];for(let H in O)h(O[H].object),delete O[H];delete L[z]}}delete n[C.id]}function b(C){for(let D in n){let B=n[D];for(let L in B){let z=B[L];if(z[C.id]===void 0)continue;let O=z[C.id];for(let H in O)h(O[H].object),delete O[H];delete z[C.id]}}}function M(C){for(let D in n){let B=n[D],L=C.isInstancedMesh===!0?C.id:0,z=B[L];if(z!==void 0){for(let O in z){let H=z[O];for(let tt in H)h(H[tt].object),delete H[tt];delete z[O]}delete B[L],Object.keys(B).length===0&&delete n[D]}}}function I(){P(),o=!0,r!==i&&(r=i,l(r.object))}function P(){i.geometry=null,i.program=null,i.wireframe=!1}return{setup:a,reset:I,resetDefaultState:P,dispose:E,releaseStatesOfGeometry:w,releaseStatesOfObject:M,releaseStatesOfProgram:b,initAttributes:y,enableAttribute:p,disableUnusedAttributes:x}}function mM(s,t,e){let n;function i(c){n=c}function r(c,l){s.drawArrays(n,c,l),e.update(l,n,1)}function o(c,l,h){h!==0&&(s.drawArraysInstanced(n,c,l,h),e.update(l,n,h))}function a(c,l,h){if(h===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,c,0,l,0,h);let d=0;for(let f=0;f<h;f++)d+=l[f];e.update(d,n,1)}this.setMode=i,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function gM(s,t,e,n){let i;function r(){if(i!==void 0)return i;if(t.has("EXT_texture_filter_anisotropic")===!0){let b=t.get("EXT_texture_filter_anisotropic");i=s.getParameter(b.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else i=0;return i}function o(b){return!(b!==Qi&&n.convert(b)!==s.getParameter(s.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(b){let M=b===gs&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(b!==Ri&&b!==Bi&&!M&&n.convert(b)!==s.getParameter(s.IMPLEMENTATION_COLOR_READ_TYPE))}function c(b){if(b==="highp"){if(s.getShaderPrecisionFormat(s.VERTEX_SHADER,s.HIGH_FLOAT).precision>0&&s.getShaderPrecisionFormat(s.FRAGMENT_SHADER,s.HIGH_FLOAT).precision>0)return"highp";b="mediump"}return b==="mediump"&&s.getShaderPrecisionFormat(s.VERTEX_SHADER,s.MEDIUM_FLOAT).precision>0&&s.getShaderPrecisionFormat(s.FRAGMENT_SHADER,s.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let l=e.precision!==void 0?e.precision:"highp",h=c(l);h!==l&&(Zt("WebGLRenderer:",l,"not supported, using",h,"instead."),l=h);let u=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),d=e.logarithmicDepthBuffer===!0&&u===!1;e.reversedDepthBuffer===!0&&u===!1&&Zt("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),e.logarithmicDepthBuffer===!0&&u===!0&&Zt("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=s.getParameter(s.MAX_TEXTURE_IMAGE_UNITS),g=s.getParameter(s.MAX_VERTEX_TEXTURE_IMAGE_UNITS),y=s.getParameter(s.MAX_TEXTURE_SIZE),p=s.getParameter(s.MAX_CUBE_MAP_TEXTURE_SIZE),m=s.getParameter(s.MAX_VERTEX_ATTRIBS),x=s.getParameter(s.MAX_VERTEX_UNIFORM_VECTORS),v=s.getParameter(s.MAX_VARYING_VECTORS),_=s.getParameter(s.MAX_FRAGMENT_UNIFORM_VECTORS),E=s.getParameter(s.MAX_SAMPLES),w=s.getParameter(s.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:c,textureFormatReadable:o,textureTypeReadable:a,precision:l,logarithmicDepthBuffer:d,reversedDepthBuffer:u,maxTextures:f,maxVertexTextures:g,maxTextureSize:y,maxCubemapSize:p,maxAttributes:m,maxVertexUniforms:x,maxVaryings:v,maxFragmentUniforms:_,maxSamples:E,samples:w}}function xM(s){let t=this,e=null,n=0,i=!1,r=!1,o=new xi,a=new ie,c={value:null,needsUpdate:!1};this.uniform=c,this.numPlanes=0,this.numIntersection=0,this.init=function(u,d){let f=u.length!==0||d||n!==0||i;return i=d,n=u.length,f},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(u,d){e=h(u,d,0)},this.setState=function(u,d,f){let g=u.clippingPlanes,y=u.clipIntersection,p=u.clipShadows,m=s.get(u);if(!i||g===null||g.length===0||r&&!p)r?h(null):l();else{let x=r?0:n,v=x*4,_=m.clippingState||null;c.value=_,_=h(g,d,v,f);for(let E=0;E!==v;++E)_[E]=e[E];m.clippingState=_,this.numIntersection=y?this.numPlanes:0,this.numPlanes+=x}};function l(){c.value!==e&&(c.value=e,c.needsUpdate=n>0),t.numPlanes=n,t.numIntersection=0}function h(u,d,f,g){let y=u!==null?u.length:0,p=null;if(y!==0){if(p=c.value,g!==!0||p===null){let m=f+y*4,x=d.matrixWorldInverse;a.getNormalMatrix(x),(p===null||p.length<m)&&(p=new Float32Array(m));for(let v=0,_=f;v!==y;++v,_+=4)o.copy(u[v]).applyMatrix4(x,a),o.normal.toArray(p,_),p[_+3]=o.constant}c.value=p,c.needsUpdate=!0}return t.numPlanes=y,t.numIntersection=0,p}}var Vl=class extends ki{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let n={width:t,height:t,depth:1},i=[n,n,n,n,n,n];this.texture=new fl(i),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},i=new qe(5,5,5),r=new Zi({name:"CubemapFromEquirect",uniforms:ao(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:bi,blending:io});r.uniforms.tEquirect.value=e;let o=new gt(i,r),a=e.minFilter;return e.minFilter===Ki&&(e.minFilter=jn),new ha(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e=!0,n=!0,i=!0){let r=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,n,i);t.setRenderTarget(r)}},F0=256,_M=3,yM=20,rx=256,ox=16,bM=3,vM=new F,wM=new qt,gu=class s{constructor(t){this._renderer=t,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new ha(1,10,null),this._boxMesh=new gt(new qe(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(t,e=0,n=.1,i=100,r={}){let{size:o=256,position:a=vM}=r,c=this._renderer;this._setSize(o);let l=this._allocateTarget(),h=this._getSourceTarget(!0);e>0&&(h.texture.mipmapsAutoUpdate=!1);let u=c.autoClear,d=c.autoClearColor,f=c.autoClearDepth,g=c.autoClearStencil,y=t.background;c.autoClear=!0,c.autoClearColor=!0,c.autoClearDepth=!0,c.autoClearStencil=!0,y===null&&(t.background=c.getClearColor(wM));let p=new ha(n,i,h);return p.position.copy(a),p.update(c,t),c.autoClear=u,c.autoClearColor=d,c.autoClearDepth=f,c.autoClearStencil=g,t.background=y,e>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(l,e)),this._applyPMREM(l),l}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=B0(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=O0(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(t,e){return e>0?1-Math.sqrt(1-t/e):0}_setSize(t){this._cubeSize=Math.max(F0,fp(t))}_fromTexture(t,e){t.mapping===ro||t.mapping===pa?this._setSize(t.image.length===0?F0:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4);let n=e||this._allocateTarget();return this._textureToCubemap(t),this._applyPMREM(n),n}_allocateTarget(){let t=this._cubeSize,e=k0(t,!1,!1),n=Math.log2(t)-_M;for(let i=0;i<=n;i++)e.texture.mipmaps.push({width:t>>i,height:t>>i});return e.texture.name="PMREM",e.texture.isPMREMTexture=!0,e}_getSourceTarget(t=!1){let e=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==e||t&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=k0(e,!0,t)),this._sourceTarget}_compileMaterial(t){this._boxMesh.material=t,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(t,e,n){let i=this._boxMesh,r=this._cubeCamera;i.material=n,r.renderTarget=t,r.activeMipmapLevel=e;let o=t.width>>e;t.viewport.set(0,0,o,o),r.update(this._renderer,i),t.viewport.set(0,0,t.width,t.height)}_textureToCubemap(t){let e;t.mapping===ro||t.mapping===pa?(this._cubemapMaterial===null&&(this._cubemapMaterial=B0()),e=this._cubemapMaterial,e.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=O0()),e=this._equirectMaterial),e.uniforms.envMap.value=t,this._renderCube(this._getSourceTarget(),0,e)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=SM(),this._integrationMaterial=MM());let e=this._cubeSize,n=t.texture.mipmaps.length-1,i=this._ggxMaterial.uniforms;i.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(e/ox);for(let o=0;o<=n;o++){let a=s.lodToRoughness(o,n);if(o>n-bM)r.roughness.value=a,this._renderCube(t,o,this._integrationMaterial);else{let c=a>0?Math.log2(e)+.5*Math.log2(6/(rx*Math.pow(a,4)))+.5:0;i.roughness.value=a,i.lodBias.value=c,this._renderCube(t,o,this._ggxMaterial)}}}_blur(t,e){this._blurMaterial===null&&(this._blurMaterial=EM());let n=this._blurMaterial,i=n.uniforms,r=this._sourceTarget;i.sigma.value=Math.min(e,Math.PI)/Math.SQRT2,i.envMap.value=r.texture,this._renderCube(t,0,n),i.envMap.value=t.texture,this._renderCube(r,0,n)}};function k0(s,t,e){return new Vl(s,{minFilter:Ki,generateMipmaps:t,type:gs,colorSpace:rl,depthBuffer:e})}function Gl(s,t,e){return new Zi({name:s,uniforms:t,vertexShader:pe.cube_vert,fragmentShader:e,side:bi,blending:io,depthTest:!1,depthWrite:!1})}function SM(){return Gl("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${rx}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function MM(){return Gl("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:ox}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function EM(){return Gl("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${yM}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function O0(){return Gl("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function B0(){return Gl("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function TM(s){let t=new WeakMap,e=new WeakMap,n=null;function i(d,f=!1){return d==null?null:f?o(d):r(d)}function r(d){if(d&&d.isTexture){let f=d.mapping;if(f===Ah||f===Rh)if(t.has(d)){let g=t.get(d).texture;return a(g,d.mapping)}else{let g=d.image;if(g&&g.height>0){let y=new Vl(g.height);return y.fromEquirectangularTexture(s,d),t.set(d,y),d.addEventListener("dispose",l),a(y.texture,d.mapping)}else return null}}return d}function o(d){if(d&&d.isTexture&&d.isPMREMTexture!==!0){let f=d.mapping,g=f===Ah||f===Rh,y=f===ro||f===pa;if(g||y){let p=e.get(d),m=p!==void 0?p.texture.pmremVersion:0;if(d.isRenderTargetTexture&&d.pmremVersion!==m)return n===null&&(n=new gu(s)),p=g?n.fromEquirectangular(d,p):n.fromCubemap(d,p),p.texture.pmremVersion=d.pmremVersion,e.set(d,p),p.texture;if(p!==void 0)return p.texture;{let x=d.image;return g&&x&&x.height>0||y&&x&&c(x)?(n===null&&(n=new gu(s)),p=g?n.fromEquirectangular(d):n.fromCubemap(d),p.texture.pmremVersion=d.pmremVersion,e.set(d,p),d.addEventListener("dispose",h),p.texture):null}}}return d}function a(d,f){return f===Ah?d.mapping=ro:f===Rh&&(d.mapping=pa),d}function c(d){let f=0,g=6;for(let y=0;y<g;y++)d[y]!==void 0&&f++;return f===g}function l(d){let f=d.target;f.removeEventListener("dispose",l);let g=t.get(f);g!==void 0&&(t.delete(f),g.dispose())}function h(d){let f=d.target;f.removeEventListener("dispose",h);let g=e.get(f);g!==void 0&&(e.delete(f),g.dispose())}function u(){t=new WeakMap,e=new WeakMap,n!==null&&(n.dispose(),n=null)}return{get:i,dispose:u}}function AM(s){let t={};function e(n){if(t[n]!==void 0)return t[n];let i=s.getExtension(n);return t[n]=i,i}return{has:function(n){return e(n)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(n){let i=e(n);return i===null&&nl("WebGLRenderer: "+n+" extension not supported."),i}}}function RM(s,t,e,n){let i={},r=new WeakMap,o=new FinalizationRegistry(g=>delete i[g]);function a(g){c(g.target)}function c(g){g.index!==null&&t.remove(g.index);for(let p in g.attributes)t.remove(g.attributes[p]);g.removeEventListener("dispose",a),delete i[g.id],o.unregister(g);let y=r.get(g);y&&(t.remove(y),r.delete(g)),n.releaseStatesOfGeometry(g),g.isInstancedBufferGeometry===!0&&delete g._maxInstanceCount,e.memory.geometries--}function l(g,y){return i[y.id]!==void 0||(y.addEventListener("dispose",a),i[y.id]=new WeakRef(y),o.register(y,y.id,y),e.memory.geometries++),y}function h(g){let y=g.attributes;for(let p in y)t.update(y[p],s.ARRAY_BUFFER)}function u(g){let y=g.index,p=g.attributes.position,m=0;if(p===void 0)return;let x=y!==null?y.array.length:p.array.length/3-1,v=p.count>=65535?hl:cl,_=new v(Math.ceil(x/3)*6,1),E=_.array;if(y!==null){let b=y.array;m=y.version;for(let M=0,I=0;M<x;M+=3){let P=b[M+0],C=b[M+1],D=b[M+2];E[I++]=P,E[I++]=C,E[I++]=C,E[I++]=D,E[I++]=D,E[I++]=P}}else{m=p.version;for(let b=0,M=0;b<x;b+=3){let I=b+0,P=b+1,C=b+2;E[M++]=I,E[M++]=P,E[M++]=P,E[M++]=C,E[M++]=C,E[M++]=I}}_.version=m;let w=r.get(g);w&&t.remove(w),r.set(g,_)}function d(g){let y=r.get(g);if(y){let p=g.index;p!==null&&y.version<p.version&&u(g)}else u(g);return r.get(g)}function f(){for(let g in i){let y=i[g].deref();y!==void 0&&c(y)}}return{get:l,update:h,getWireframeAttribute:d,dispose:f}}function CM(s,t,e){let n;function i(u){n=u}let r,o;function a(u){r=u.type,o=u.bytesPerElement}function c(u,d){s.drawElements(n,d,r,u*o),e.update(d,n,1)}function l(u,d,f){f!==0&&(s.drawElementsInstanced(n,d,r,u*o,f),e.update(d,n,f))}function h(u,d,f){if(f===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,d,0,r,u,0,f);let y=0;for(let p=0;p<f;p++)y+=d[p];e.update(y,n,1)}this.setMode=i,this.setIndex=a,this.render=c,this.renderInstances=l,this.renderMultiDraw=h}function PM(s){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,o,a){switch(e.calls++,o){case s.TRIANGLES:e.triangles+=a*(r/3);break;case s.LINES:e.lines+=a*(r/2);break;case s.LINE_STRIP:e.lines+=a*(r-1);break;case s.LINE_LOOP:e.lines+=a*r;break;case s.POINTS:e.points+=a*r;break;default:te("WebGLInfo: Unknown draw mode:",o);break}}function i(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:i,update:n}}function IM(s,t,e){let n=new WeakMap,i=new ze;function r(o,a,c){let l=o.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,u=h!==void 0?h.length:0,d=n.get(a);if(d===void 0||d.count!==u){let I=function(){b.dispose(),n.delete(a),a.removeEventListener("dispose",I)};d!==void 0&&d.texture.dispose();let f=a.morphAttributes.position!==void 0,g=a.morphAttributes.normal!==void 0,y=a.morphAttributes.color!==void 0,p=a.morphAttributes.position||[],m=a.morphAttributes.normal||[],x=a.morphAttributes.color||[],v=0;f===!0&&(v=1),g===!0&&(v=2),y===!0&&(v=3);let _=a.attributes.position.count*v,E=1;_>t.maxTextureSize&&(E=Math.ceil(_/t.maxTextureSize),_=t.maxTextureSize);let w=new Float32Array(_*E*4*u),b=new al(w,_,E,u);b.type=Bi,b.needsUpdate=!0;let M=v*4;for(let P=0;P<u;P++){let C=p[P],D=m[P],B=x[P],L=_*E*4*P;for(let z=0;z<C.count;z++){let O=z*M;f===!0&&(i.fromBufferAttribute(C,z),w[L+O+0]=i.x,w[L+O+1]=i.y,w[L+O+2]=i.z,w[L+O+3]=0),g===!0&&(i.fromBufferAttribute(D,z),w[L+O+4]=i.x,w[L+O+5]=i.y,w[L+O+6]=i.z,w[L+O+7]=0),y===!0&&(i.fromBufferAttribute(B,z),w[L+O+8]=i.x,w[L+O+9]=i.y,w[L+O+10]=i.z,w[L+O+11]=B.itemSize===4?i.w:1)}}d={count:u,texture:b,size:new Vt(_,E)},n.set(a,d),a.addEventListener("dispose",I)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)c.getUniforms().setValue(s,"morphTexture",o.morphTexture,e);else{let f=0;for(let y=0;y<l.length;y++)f+=l[y];let g=a.morphTargetsRelative?1:1-f;c.getUniforms().setValue(s,"morphTargetBaseInfluence",g),c.getUniforms().setValue(s,"morphTargetInfluences",l)}c.getUniforms().setValue(s,"morphTargetsTexture",d.texture,e),c.getUniforms().setValue(s,"morphTargetsTextureSize",d.size)}return{update:r}}function LM(s,t,e,n,i){let r=new WeakMap;function o(l){let h=i.render.frame,u=l.geometry,d=t.get(l,u);if(r.get(d)!==h&&(t.update(d),r.set(d,h)),l.isInstancedMesh&&(l.hasEventListener("dispose",c)===!1&&l.addEventListener("dispose",c),r.get(l)!==h&&(e.update(l.instanceMatrix,s.ARRAY_BUFFER),l.instanceColor!==null&&e.update(l.instanceColor,s.ARRAY_BUFFER),r.set(l,h))),l.isSkinnedMesh){let f=l.skeleton;r.get(f)!==h&&(f.update(),r.set(f,h))}return d}function a(){r=new WeakMap}function c(l){let h=l.target;h.removeEventListener("dispose",c),n.releaseStatesOfObject(h),e.remove(h.instanceMatrix),h.instanceColor!==null&&e.remove(h.instanceColor)}return{update:o,dispose:a}}var NM={[jf]:"LINEAR_TONE_MAPPING",[Zf]:"REINHARD_TONE_MAPPING",[$f]:"CINEON_TONE_MAPPING",[Ll]:"ACES_FILMIC_TONE_MAPPING",[Kf]:"AGX_TONE_MAPPING",[Qf]:"NEUTRAL_TONE_MAPPING",[Jf]:"CUSTOM_TONE_MAPPING"};function DM(s,t,e,n,i,r){let o=new ki(t,e,{type:s,depthBuffer:i,stencilBuffer:r,samples:n?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,c=null,l=null,h=new ue;h.setAttribute("position",new Xt([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new Xt([0,2,0,0,2,0],2));let u=new xh({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),d=new gt(h,u),f=new Kr(-1,1,1,-1,0,1),g=null,y=null,p=!1,m,x=null,v=[],_=!1;this.setSize=function(E,w){o.setSize(E,w),a!==null&&a.setSize(E,w),c!==null&&c.setSize(E,w);for(let b=0;b<v.length;b++){let M=v[b];M.setSize&&M.setSize(E,w)}},this.setEffects=function(E){v=E,_=v.length>0&&v[0].isRenderPass===!0;let w=o.width,b=o.height;v.length>0&&a===null&&(a=new ki(w,b,{type:gs,depthBuffer:!1,stencilBuffer:!1}),c=new ki(w,b,{type:gs,depthBuffer:!1,stencilBuffer:!1}));let M=i===!0&&v.some(I=>I.needsDepthTexture===!0);M!==(o.depthTexture!==null)&&(M===!0&&l===null&&(l=new Ks(w,b),r===!0&&(l.format=rr,l.type=oo)),o.dispose(),o.depthTexture=M?l:null,o.resolveDepthBuffer=M,o.storeMultisampledDepthBuffer=M);for(let I=0;I<v.length;I++){let P=v[I];P.setSize&&P.setSize(w,b),M&&P.needsDepthTexture===!0&&P.setDepthTexture&&P.setDepthTexture(l)}},this.begin=function(E,w){if(p||E.toneMapping===Ji&&v.length===0)return!1;if(x=w,w!==null){let b=w.width,M=w.height;(o.width!==b||o.height!==M)&&this.setSize(b,M)}return _===!1&&E.setRenderTarget(o),m=E.toneMapping,E.toneMapping=Ji,!0},this.hasRenderPass=function(){return _},this.end=function(E,w){E.toneMapping=m,p=!0;let b=o,M=a;for(let I=0;I<v.length;I++){let P=v[I];P.enabled!==!1&&(P.render(E,M,b,w),P.needsSwap!==!1&&(b=M,M=M===a?c:a))}if(g!==E.outputColorSpace||y!==E.toneMapping){g=E.outputColorSpace,y=E.toneMapping,u.defines={},he.getTransfer(g)===Ne&&(u.defines.SRGB_TRANSFER="");let I=NM[y];I&&(u.defines[I]=""),u.needsUpdate=!0}u.uniforms.tDiffuse.value=b.texture,E.setRenderTarget(x),E.render(d,f),x=null,p=!1},this.isCompositing=function(){return p},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),c!==null&&c.dispose(),h.dispose(),u.dispose()}}var ax=new ri,lx=new Ks(1,1),cx=new ml(1),hx=new al,ux=new dh,dx=new fl,z0=[],H0=[],V0=new Float32Array(16),G0=new Float32Array(9),W0=new Float32Array(4);function _a(s,t,e){let n=s[0];if(n<=0||n>0)return s;let i=t*e,r=z0[i];if(r===void 0&&(r=new Float32Array(i),z0[i]=r),t!==0){n.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,s[o].toArray(r,a)}return r}function kn(s,t){if(s.length!==t.length)return!1;for(let e=0,n=s.length;e<n;e++)if(s[e]!==t[e])return!1;return!0}function On(s,t){for(let e=0,n=t.length;e<n;e++)s[e]=t[e]}function _u(s,t){let e=H0[t];e===void 0&&(e=new Int32Array(t),H0[t]=e);for(let n=0;n!==t;++n)e[n]=s.allocateTextureUnit();return e}function UM(s,t){let e=this.cache;e[0]!==t&&(s.uniform1f(this.addr,t),e[0]=t)}function FM(s,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(s.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(kn(e,t))return;s.uniform2fv(this.addr,t),On(e,t)}}function kM(s,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(s.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(s.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(kn(e,t))return;s.uniform3fv(this.addr,t),On(e,t)}}function OM(s,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(s.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(kn(e,t))return;s.uniform4fv(this.addr,t),On(e,t)}}function BM(s,t){let e=this.cache,n=t.elements;if(n===void 0){if(kn(e,t))return;s.uniformMatrix2fv(this.addr,!1,t),On(e,t)}else{if(kn(e,n))return;W0.set(n),s.uniformMatrix2fv(this.addr,!1,W0),On(e,n)}}function zM(s,t){let e=this.cache,n=t.elements;if(n===void 0){if(kn(e,t))return;s.uniformMatrix3fv(this.addr,!1,t),On(e,t)}else{if(kn(e,n))return;G0.set(n),s.uniformMatrix3fv(this.addr,!1,G0),On(e,n)}}function HM(s,t){let e=this.cache,n=t.elements;if(n===void 0){if(kn(e,t))return;s.uniformMatrix4fv(this.addr,!1,t),On(e,t)}else{if(kn(e,n))return;V0.set(n),s.uniformMatrix4fv(this.addr,!1,V0),On(e,n)}}function VM(s,t){let e=this.cache;e[0]!==t&&(s.uniform1i(this.addr,t),e[0]=t)}function GM(s,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(s.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(kn(e,t))return;s.uniform2iv(this.addr,t),On(e,t)}}function WM(s,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(s.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(kn(e,t))return;s.uniform3iv(this.addr,t),On(e,t)}}function XM(s,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(s.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(kn(e,t))return;s.uniform4iv(this.addr,t),On(e,t)}}function qM(s,t){let e=this.cache;e[0]!==t&&(s.uniform1ui(this.addr,t),e[0]=t)}function YM(s,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(s.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(kn(e,t))return;s.uniform2uiv(this.addr,t),On(e,t)}}function jM(s,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(s.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(kn(e,t))return;s.uniform3uiv(this.addr,t),On(e,t)}}function ZM(s,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(s.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(kn(e,t))return;s.uniform4uiv(this.addr,t),On(e,t)}}function yu(s){return s.version===0&&(s.compareFunction=cp,s.needsUpdate=!0),s}function $M(s,t,e){let n=this.cache,i=e.allocateTextureUnit();n[0]!==i&&(s.uniform1i(this.addr,i),n[0]=i);let r;this.type===s.SAMPLER_2D_SHADOW?r=yu(lx):r=ax,e.setTexture2D(t||r,i)}function JM(s,t,e){let n=this.cache,i=e.allocateTextureUnit();n[0]!==i&&(s.uniform1i(this.addr,i),n[0]=i),e.setTexture3D(t||ux,i)}function KM(s,t,e){let n=this.cache,i=e.allocateTextureUnit();n[0]!==i&&(s.uniform1i(this.addr,i),n[0]=i);let r;this.type===s.SAMPLER_CUBE_SHADOW?r=yu(cx):r=dx,e.setTextureCube(t||r,i)}function QM(s,t,e){let n=this.cache,i=e.allocateTextureUnit();n[0]!==i&&(s.uniform1i(this.addr,i),n[0]=i),e.setTexture2DArray(t||hx,i)}function t1(s){switch(s){case 5126:return UM;case 35664:return FM;case 35665:return kM;case 35666:return OM;case 35674:return BM;case 35675:return zM;case 35676:return HM;case 5124:case 35670:return VM;case 35667:case 35671:return GM;case 35668:case 35672:return WM;case 35669:case 35673:return XM;case 5125:return qM;case 36294:return YM;case 36295:return jM;case 36296:return ZM;case 35678:case 36198:case 36298:case 36306:case 35682:return $M;case 35679:case 36299:case 36307:return JM;case 35680:case 36300:case 36308:case 36293:return KM;case 36289:case 36303:case 36311:case 36292:return QM}}function e1(s,t){s.uniform1fv(this.addr,t)}function n1(s,t){let e=_a(t,this.size,2);s.uniform2fv(this.addr,e)}function i1(s,t){let e=_a(t,this.size,3);s.uniform3fv(this.addr,e)}function s1(s,t){let e=_a(t,this.size,4);s.uniform4fv(this.addr,e)}function r1(s,t){let e=_a(t,this.size,4);s.uniformMatrix2fv(this.addr,!1,e)}function o1(s,t){let e=_a(t,this.size,9);s.uniformMatrix3fv(this.addr,!1,e)}function a1(s,t){let e=_a(t,this.size,16);s.uniformMatrix4fv(this.addr,!1,e)}function l1(s,t){s.uniform1iv(this.addr,t)}function c1(s,t){s.uniform2iv(this.addr,t)}function h1(s,t){s.uniform3iv(this.addr,t)}function u1(s,t){s.uniform4iv(this.addr,t)}function d1(s,t){s.uniform1uiv(this.addr,t)}function f1(s,t){s.uniform2uiv(this.addr,t)}function p1(s,t){s.uniform3uiv(this.addr,t)}function m1(s,t){s.uniform4uiv(this.addr,t)}function g1(s,t,e){let n=this.cache,i=t.length,r=_u(e,i);kn(n,r)||(s.uniform1iv(this.addr,r),On(n,r));let o;this.type===s.SAMPLER_2D_SHADOW?o=yu(lx):o=ax;for(let a=0;a!==i;++a)e.setTexture2D(t[a]||o,r[a])}function x1(s,t,e){let n=this.cache,i=t.length,r=_u(e,i);kn(n,r)||(s.uniform1iv(this.addr,r),On(n,r));for(let o=0;o!==i;++o)e.setTexture3D(t[o]||ux,r[o])}function _1(s,t,e){let n=this.cache,i=t.length,r=_u(e,i);kn(n,r)||(s.uniform1iv(this.addr,r),On(n,r));let o;this.type===s.SAMPLER_CUBE_SHADOW?o=yu(cx):o=dx;for(let a=0;a!==i;++a)e.setTextureCube(t[a]||o,r[a])}function y1(s,t,e){let n=this.cache,i=t.length,r=_u(e,i);kn(n,r)||(s.uniform1iv(this.addr,r),On(n,r));for(let o=0;o!==i;++o)e.setTexture2DArray(t[o]||hx,r[o])}function b1(s){switch(s){case 5126:return e1;case 35664:return n1;case 35665:return i1;case 35666:return s1;case 35674:return r1;case 35675:return o1;case 35676:return a1;case 5124:case 35670:return l1;case 35667:case 35671:return c1;case 35668:case 35672:return h1;case 35669:case 35673:return u1;case 5125:return d1;case 36294:return f1;case 36295:return p1;case 36296:return m1;case 35678:case 36198:case 36298:case 36306:case 35682:return g1;case 35679:case 36299:case 36307:return x1;case 35680:case 36300:case 36308:case 36293:return _1;case 36289:case 36303:case 36311:case 36292:return y1}}var vp=class{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.setValue=t1(e.type)}},wp=class{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=b1(e.type)}},Sp=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,n){let i=this.seq;for(let r=0,o=i.length;r!==o;++r){let a=i[r];a.setValue(t,e[a.id],n)}}},yp=/(\w+)(\])?(\[|\.)?/g;function X0(s,t){s.seq.push(t),s.map[t.id]=t}function v1(s,t,e){let n=s.name,i=n.length;for(yp.lastIndex=0;;){let r=yp.exec(n),o=yp.lastIndex,a=r[1],c=r[2]==="]",l=r[3];if(c&&(a=a|0),l===void 0||l==="["&&o+2===i){X0(e,l===void 0?new vp(a,s,t):new wp(a,s,t));break}else{let u=e.map[a];u===void 0&&(u=new Sp(a),X0(e,u)),e=u}}}var xa=class{constructor(t,e){this.seq=[],this.map={};let n=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let o=0;o<n;++o){let a=t.getActiveUniform(e,o),c=t.getUniformLocation(e,a.name);v1(a,c,this)}let i=[],r=[];for(let o of this.seq)o.type===t.SAMPLER_2D_SHADOW||o.type===t.SAMPLER_CUBE_SHADOW||o.type===t.SAMPLER_2D_ARRAY_SHADOW?i.push(o):r.push(o);i.length>0&&(this.seq=i.concat(r))}setValue(t,e,n,i){let r=this.map[e];r!==void 0&&r.setValue(t,n,i)}setOptional(t,e,n){let i=e[n];i!==void 0&&this.setValue(t,n,i)}static upload(t,e,n,i){for(let r=0,o=e.length;r!==o;++r){let a=e[r],c=n[a.id];c.needsUpdate!==!1&&a.setValue(t,c.value,i)}}static seqWithValue(t,e){let n=[];for(let i=0,r=t.length;i!==r;++i){let o=t[i];o.id in e&&n.push(o)}return n}};function q0(s,t,e){let n=s.createShader(t);return s.shaderSource(n,e),s.compileShader(n),n}var w1=37297,S1=0;function M1(s,t){let e=s.split(`
`),n=[],i=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=i;o<r;o++){let a=o+1;n.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return n.join(`
`)}var Y0=new ie;function E1(s){he._getMatrix(Y0,he.workingColorSpace,s);let t=`mat3( ${Y0.elements.map(e=>e.toFixed(4))} )`;switch(he.getTransfer(s)){case ol:return[t,"LinearTransferOETF"];case Ne:return[t,"sRGBTransferOETF"];default:return Zt("WebGLProgram: Unsupported color space: ",s),[t,"LinearTransferOETF"]}}function j0(s,t,e){let n=s.getShaderParameter(t,s.COMPILE_STATUS),r=(s.getShaderInfoLog(t)||"").trim();if(n&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return e.toUpperCase()+`

`+r+`

`+M1(s.getShaderSource(t),a)}else return r}function T1(s,t){let e=E1(t);return[`vec4 ${s}( vec4 value ) {`,`	return ${e[1]}( vec4( ${e[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var A1={[jf]:"Linear",[Zf]:"Reinhard",[$f]:"Cineon",[Ll]:"ACESFilmic",[Kf]:"AgX",[Qf]:"Neutral",[Jf]:"Custom"};function R1(s,t){let e=A1[t];return e===void 0?(Zt("WebGLProgram: Unsupported toneMapping:",t),"vec3 "+s+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+s+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var mu=new F;function C1(){he.getLuminanceCoefficients(mu);let s=mu.x.toFixed(4),t=mu.y.toFixed(4),e=mu.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${s}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function P1(s){return[s.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",s.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Hl).join(`
`)}function I1(s){let t=[];for(let e in s){let n=s[e];n!==!1&&t.push("#define "+e+" "+n)}return t.join(`
`)}function L1(s,t){let e={},n=s.getProgramParameter(t,s.ACTIVE_ATTRIBUTES);for(let i=0;i<n;i++){let r=s.getActiveAttrib(t,i),o=r.name,a=1;r.type===s.FLOAT_MAT2&&(a=2),r.type===s.FLOAT_MAT3&&(a=3),r.type===s.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:s.getAttribLocation(t,o),locationSize:a}}return e}function Hl(s){return s!==""}function Z0(s,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return s.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function $0(s,t){return s.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var N1=/^[ \t]*#include +<([\w\d./]+)>/gm;function Mp(s){return s.replace(N1,D1)}function D1(s,t){let e=pe[t];if(e===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+t+">");return Mp(e)}var U1=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function J0(s){return s.replace(U1,F1)}function F1(s,t,e,n){let i="";for(let r=parseInt(t);r<parseInt(e);r++)i+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return i}function K0(s){let t=`precision ${s.precision} float;
	precision ${s.precision} int;
	precision ${s.precision} sampler2D;
	precision ${s.precision} samplerCube;
	precision ${s.precision} sampler3D;
	precision ${s.precision} sampler2DArray;
	precision ${s.precision} sampler2DShadow;
	precision ${s.precision} samplerCubeShadow;
	precision ${s.precision} sampler2DArrayShadow;
	precision ${s.precision} isampler2D;
	precision ${s.precision} isampler3D;
	precision ${s.precision} isamplerCube;
	precision ${s.precision} isampler2DArray;
	precision ${s.precision} usampler2D;
	precision ${s.precision} usampler3D;
	precision ${s.precision} usamplerCube;
	precision ${s.precision} usampler2DArray;
	`;return s.precision==="highp"?t+=`
#define HIGH_PRECISION`:s.precision==="mediump"?t+=`
#define MEDIUM_PRECISION`:s.precision==="lowp"&&(t+=`
#define LOW_PRECISION`),t}var k1={[no]:"SHADOWMAP_TYPE_PCF",[da]:"SHADOWMAP_TYPE_VSM"};function O1(s){return k1[s.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var B1={[pa]:"ENVMAP_MODE_REFRACTION"};function z1(s){return s.envMap===!1?"ENVMAP_MODE_REFLECTION":B1[s.envMapMode]||"ENVMAP_MODE_REFLECTION"}var H1={[Il]:"ENVMAP_BLENDING_MULTIPLY",[c0]:"ENVMAP_BLENDING_MIX",[h0]:"ENVMAP_BLENDING_ADD"};function V1(s){return s.envMap===!1?"ENVMAP_BLENDING_NONE":H1[s.combine]||"ENVMAP_BLENDING_NONE"}function G1(s,t,e,n){let i=s.getContext(),r=e.defines,o=e.vertexShader,a=e.fragmentShader,c=O1(e),l=e.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=z1(e),u=V1(e),d=P1(e),f=I1(r),g=i.createProgram(),y,p,m=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(y=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(Hl).join(`
`),y.length>0&&(y+=`
`),p=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(Hl).join(`
`),p.length>0&&(p+=`
`)):(y=[K0(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+h:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+e.diffuseRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexNormals?"#define HAS_NORMAL":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+c:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Hl).join(`
`),p=[K0(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+l:"",e.envMap?"#define "+h:"",e.envMap?"#define "+u:"",e.envMapPMREM?"#define ENVMAP_MAX_LOD "+e.envMapMaxLod+".0":"",e.envMapPMREM?"#define ENVMAP_SIZE "+e.envMapSize+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.retroreflection?"#define USE_RETROREFLECTION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor?"#define USE_COLOR":"",e.vertexAlphas||e.batchingColor?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+c:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==Ji?"#define TONE_MAPPING":"",e.toneMapping!==Ji?pe.tonemapping_pars_fragment:"",e.toneMapping!==Ji?R1("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",pe.colorspace_pars_fragment,T1("linearToOutputTexel",e.outputColorSpace),C1(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(Hl).join(`
`)),o=Mp(o),o=Z0(o,e),o=$0(o,e),a=Mp(a),a=Z0(a,e),a=$0(a,e),o=J0(o),a=J0(a),e.isRawShaderMaterial!==!0&&(m=`#version 300 es
`,y=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+y,p=["#define varying in",e.glslVersion===hp?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===hp?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+p);let x=m+y+o,v=m+p+a,_=q0(i,i.VERTEX_SHADER,x),E=q0(i,i.FRAGMENT_SHADER,v);i.attachShader(g,_),i.attachShader(g,E),e.index0AttributeName!==void 0?i.bindAttribLocation(g,0,e.index0AttributeName):e.hasPositionAttribute===!0&&i.bindAttribLocation(g,0,"position"),i.linkProgram(g);function w(P){if(s.debug.checkShaderErrors){let C=i.getProgramInfoLog(g)||"",D=i.getShaderInfoLog(_)||"",B=i.getShaderInfoLog(E)||"",L=C.trim(),z=D.trim(),O=B.trim(),H=!0,tt=!0;if(i.getProgramParameter(g,i.LINK_STATUS)===!1)if(H=!1,typeof s.debug.onShaderError=="function")s.debug.onShaderError(i,g,_,E);else{let X=j0(i,_,"vertex"),Z=j0(i,E,"fragment");te("WebGLProgram: Shader Error "+i.getError()+" - VALIDATE_STATUS "+i.getProgramParameter(g,i.VALIDATE_STATUS)+`

Material Name: `+P.name+`
Material Type: `+P.type+`

Program Info Log: `+L+`
`+X+`
`+Z)}else L!==""?Zt("WebGLProgram: Program Info Log:",L):(z===""||O==="")&&(tt=!1);tt&&(P.diagnostics={runnable:H,programLog:L,vertexShader:{log:z,prefix:y},fragmentShader:{log:O,prefix:p}})}i.deleteShader(_),i.deleteShader(E),b=new xa(i,g),M=L1(i,g)}let b;this.getUniforms=function(){return b===void 0&&w(this),b};let M;this.getAttributes=function(){return M===void 0&&w(this),M};let I=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return I===!1&&(I=i.getProgramParameter(g,w1)),I},this.destroy=function(){n.releaseStatesOfProgram(this),i.deleteProgram(g),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=S1++,this.cacheKey=t,this.usedTimes=1,this.program=g,this.vertexShader=_,this.fragmentShader=E,this}var W1=0,Ep=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t,e,n){let i=this._getShaderCacheForMaterial(t);return i.has(e)===!1&&(i.add(e),e.usedTimes++),i.has(n)===!1&&(i.add(n),n.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let n of e)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(t),this}getVertexShaderStage(t){return this._getShaderStage(t.vertexShader)}getFragmentShaderStage(t){return this._getShaderStage(t.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,n=e.get(t);return n===void 0&&(n=new Set,e.set(t,n)),n}_getShaderStage(t){let e=this.shaderCache,n=e.get(t);return n===void 0&&(n=new Tp(t),e.set(t,n)),n}},Tp=class{constructor(t){this.id=W1++,this.code=t,this.usedTimes=0}};function X1(s){return s===Ir||s===Ol||s===Bl}function q1(s,t,e,n,i,r){let o=new Qo,a=new Ep,c=new Set,l=[],h=new Map,u=n.logarithmicDepthBuffer,d={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(b){return c.add(b),b===0?"uv":`uv${b}`}function g(b,M,I,P,C,D){let B=P.fog,L=C.geometry,z=b.isMeshStandardMaterial||b.isMeshLambertMaterial||b.isMeshPhongMaterial?P.environment:null,O=b.isMeshStandardMaterial||b.isMeshLambertMaterial&&!b.envMap||b.isMeshPhongMaterial&&!b.envMap,H=t.get(b.envMap||z,O),tt=d[b.type],X=n.precision;b.precision!==null&&(X=n.getMaxPrecision(b.precision),X!==b.precision&&Zt("WebGLProgram.getParameters:",b.precision,"not supported, using",X,"instead."));let Z=L.morphAttributes.position||L.morphAttributes.normal||L.morphAttributes.color,$=Z!==void 0?Z.length:0,at=0;L.morphAttributes.position!==void 0&&(at=1),L.morphAttributes.normal!==void 0&&(at=2),L.morphAttributes.color!==void 0&&(at=3);let it,Y,st,nt;if(tt){let Rt=Ds[tt];it=Rt.vertexShader,Y=Rt.fragmentShader}else{it=b.vertexShader,Y=b.fragmentShader;let Rt=a.getVertexShaderStage(b),ce=a.getFragmentShaderStage(b);a.update(b,Rt,ce),st=Rt.id,nt=ce.id}let lt=s.getRenderTarget(),mt=s.state.buffers.depth.getReversed(),Ut=C.isInstancedMesh===!0,Jt=C.isBatchedMesh===!0,Ot=!!b.map,me=!!b.matcap,de=!!H,oe=de&&H.isPMREMTexture===!0,an=!!b.aoMap,Ke=!!b.lightMap,En=!!b.bumpMap&&b.wireframe===!1,Ve=!!b.normalMap,Vn=!!b.displacementMap,Ee=!!b.emissiveMap,Dn=!!b.metalnessMap,gn=!!b.roughnessMap,Tn=b.anisotropy>0,G=b.clearcoat>0,Ct=b.diffuseRoughness>0,Kt=b.dispersion>0,le=b.retroreflectivity>0,Mt=b.iridescence>0,We=b.sheen>0,Wt=b.transmission>0,$t=Tn&&!!b.anisotropyMap,N=G&&!!b.clearcoatMap,T=G&&!!b.clearcoatNormalMap,j=G&&!!b.clearcoatRoughnessMap,pt=Ct&&!!b.diffuseRoughnessMap,ut=Mt&&!!b.iridescenceMap,bt=Mt&&!!b.iridescenceThicknessMap,vt=We&&!!b.sheenColorMap,rt=We&&!!b.sheenRoughnessMap,ct=!!b.specularMap,_t=!!b.specularColorMap,V=!!b.specularIntensityMap,ht=Wt&&!!b.transmissionMap,ot=Wt&&!!b.thicknessMap,Et=!!b.gradientMap,yt=!!b.alphaMap,St=b.alphaTest>0,Yt=!!b.alphaHash,ee=!!b.extensions,ft=Ji;b.toneMapped&&(lt===null||lt.isXRRenderTarget===!0)&&(ft=s.toneMapping);let Bt=oe?H.isCompressedCubeTexture?H.image[0].mipmaps:H.mipmaps:null,ne={shaderID:tt,shaderType:b.type,shaderName:b.name,vertexShader:it,fragmentShader:Y,defines:b.defines,customVertexShaderID:st,customFragmentShaderID:nt,isRawShaderMaterial:b.isRawShaderMaterial===!0,glslVersion:b.glslVersion,precision:X,batching:Jt,batchingColor:Jt&&C._colorsTexture!==null,instancing:Ut,instancingColor:Ut&&C.instanceColor!==null,instancingMorph:Ut&&C.morphTexture!==null,outputColorSpace:lt===null?s.outputColorSpace:lt.isXRRenderTarget===!0?lt.texture.colorSpace:he.workingColorSpace,alphaToCoverage:!!b.alphaToCoverage,map:Ot,matcap:me,envMap:de,envMapMode:de&&H.mapping,envMapPMREM:oe,envMapMaxLod:oe?Bt.length-1:null,envMapSize:oe?Bt[0].width:null,aoMap:an,lightMap:Ke,bumpMap:En,normalMap:Ve,displacementMap:Vn,emissiveMap:Ee,normalMapObjectSpace:Ve&&b.normalMapType===m0,normalMapTangentSpace:Ve&&b.normalMapType===ga,packedNormalMap:Ve&&b.normalMapType===ga&&X1(b.normalMap.format),metalnessMap:Dn,roughnessMap:gn,anisotropy:Tn,anisotropyMap:$t,clearcoat:G,clearcoatMap:N,clearcoatNormalMap:T,clearcoatRoughnessMap:j,diffuseRoughness:Ct,diffuseRoughnessMap:pt,dispersion:Kt,retroreflection:le,iridescence:Mt,iridescenceMap:ut,iridescenceThicknessMap:bt,sheen:We,sheenColorMap:vt,sheenRoughnessMap:rt,specularMap:ct,specularColorMap:_t,specularIntensityMap:V,transmission:Wt,transmissionMap:ht,thicknessMap:ot,gradientMap:Et,opaque:b.transparent===!1&&b.blending===fa&&b.alphaToCoverage===!1,alphaMap:yt,alphaTest:St,alphaHash:Yt,combine:b.combine,mapUv:Ot&&f(b.map.channel),aoMapUv:an&&f(b.aoMap.channel),lightMapUv:Ke&&f(b.lightMap.channel),bumpMapUv:En&&f(b.bumpMap.channel),normalMapUv:Ve&&f(b.normalMap.channel),displacementMapUv:Vn&&f(b.displacementMap.channel),emissiveMapUv:Ee&&f(b.emissiveMap.channel),metalnessMapUv:Dn&&f(b.metalnessMap.channel),roughnessMapUv:gn&&f(b.roughnessMap.channel),anisotropyMapUv:$t&&f(b.anisotropyMap.channel),clearcoatMapUv:N&&f(b.clearcoatMap.channel),clearcoatNormalMapUv:T&&f(b.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:j&&f(b.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:pt&&f(b.diffuseRoughnessMap.channel),iridescenceMapUv:ut&&f(b.iridescenceMap.channel),iridescenceThicknessMapUv:bt&&f(b.iridescenceThicknessMap.channel),sheenColorMapUv:vt&&f(b.sheenColorMap.channel),sheenRoughnessMapUv:rt&&f(b.sheenRoughnessMap.channel),specularMapUv:ct&&f(b.specularMap.channel),specularColorMapUv:_t&&f(b.specularColorMap.channel),specularIntensityMapUv:V&&f(b.specularIntensityMap.channel),transmissionMapUv:ht&&f(b.transmissionMap.channel),thicknessMapUv:ot&&f(b.thicknessMap.channel),alphaMapUv:yt&&f(b.alphaMap.channel),vertexTangents:!!L.attributes.tangent&&(Ve||Tn),vertexNormals:!!L.attributes.normal,vertexColors:b.vertexColors,vertexAlphas:b.vertexColors===!0&&!!L.attributes.color&&L.attributes.color.itemSize===4,pointsUvs:C.isPoints===!0&&!!L.attributes.uv&&(Ot||yt),fog:!!B,useFog:b.fog===!0,fogExp2:!!B&&B.isFogExp2,flatShading:b.wireframe===!1&&(b.flatShading===!0||L.attributes.normal===void 0&&Ve===!1&&(b.isMeshLambertMaterial||b.isMeshPhongMaterial||b.isMeshStandardMaterial||b.isMeshPhysicalMaterial)),sizeAttenuation:b.sizeAttenuation===!0,logarithmicDepthBuffer:u,reversedDepthBuffer:mt,skinning:C.isSkinnedMesh===!0,hasPositionAttribute:L.attributes.position!==void 0,morphTargets:L.morphAttributes.position!==void 0,morphNormals:L.morphAttributes.normal!==void 0,morphColors:L.morphAttributes.color!==void 0,morphTargetsCount:$,morphTextureStride:at,numSunLights:M.sun.length,numDirLights:M.directional.length,numPointLights:M.point.length,numSpotLights:M.spot.length,numSpotLightMaps:M.spotLightMap.length,numRectAreaLights:M.rectArea.length,numHemiLights:M.hemi.length,numSunLightShadows:M.sunShadowMap.length,numDirLightShadows:M.directionalShadowMap.length,numPointLightShadows:M.pointShadowMap.length,numSpotLightShadows:M.spotShadowMap.length,numSpotLightShadowsWithMaps:M.numSpotLightShadowsWithMaps,numLightProbes:M.numLightProbes,numLightProbeGrids:D.filter(Rt=>Rt.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:b.dithering,shadowMapEnabled:s.shadowMap.enabled&&I.length>0,shadowMapType:s.shadowMap.type,toneMapping:ft,decodeVideoTexture:Ot&&b.map.isVideoTexture===!0&&he.getTransfer(b.map.colorSpace)===Ne,decodeVideoTextureEmissive:Ee&&b.emissiveMap.isVideoTexture===!0&&he.getTransfer(b.emissiveMap.colorSpace)===Ne,premultipliedAlpha:b.premultipliedAlpha,doubleSided:b.side===ci,flipSided:b.side===bi,useDepthPacking:b.depthPacking>=0,depthPacking:b.depthPacking||0,index0AttributeName:b.index0AttributeName,extensionClipCullDistance:ee&&b.extensions.clipCullDistance===!0&&e.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(ee&&b.extensions.multiDraw===!0||Jt)&&e.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:e.has("KHR_parallel_shader_compile"),customProgramCacheKey:b.customProgramCacheKey()};return ne.vertexUv1s=c.has(1),ne.vertexUv2s=c.has(2),ne.vertexUv3s=c.has(3),c.clear(),ne}function y(b){let M=[];if(b.shaderID?M.push(b.shaderID):(M.push(b.customVertexShaderID),M.push(b.customFragmentShaderID)),b.defines!==void 0)for(let I in b.defines)M.push(I),M.push(b.defines[I]);return b.isRawShaderMaterial===!1&&(p(M,b),m(M,b),M.push(s.outputColorSpace)),M.push(b.customProgramCacheKey),M.join()}function p(b,M){b.push(M.precision),b.push(M.outputColorSpace),b.push(M.envMapMode),b.push(M.envMapPMREM),b.push(M.envMapMaxLod),b.push(M.envMapSize),b.push(M.mapUv),b.push(M.alphaMapUv),b.push(M.lightMapUv),b.push(M.aoMapUv),b.push(M.bumpMapUv),b.push(M.normalMapUv),b.push(M.displacementMapUv),b.push(M.emissiveMapUv),b.push(M.metalnessMapUv),b.push(M.roughnessMapUv),b.push(M.anisotropyMapUv),b.push(M.clearcoatMapUv),b.push(M.clearcoatNormalMapUv),b.push(M.clearcoatRoughnessMapUv),b.push(M.diffuseRoughnessMapUv),b.push(M.iridescenceMapUv),b.push(M.iridescenceThicknessMapUv),b.push(M.sheenColorMapUv),b.push(M.sheenRoughnessMapUv),b.push(M.specularMapUv),b.push(M.specularColorMapUv),b.push(M.specularIntensityMapUv),b.push(M.transmissionMapUv),b.push(M.thicknessMapUv),b.push(M.combine),b.push(M.fogExp2),b.push(M.sizeAttenuation),b.push(M.morphTargetsCount),b.push(M.numSunLights),b.push(M.numDirLights),b.push(M.numPointLights),b.push(M.numSpotLights),b.push(M.numSpotLightMaps),b.push(M.numHemiLights),b.push(M.numRectAreaLights),b.push(M.numSunLightShadows),b.push(M.numDirLightShadows),b.push(M.numPointLightShadows),b.push(M.numSpotLightShadows),b.push(M.numSpotLightShadowsWithMaps),b.push(M.numLightProbes),b.push(M.numLightProbeGrids),b.push(M.shadowMapType),b.push(M.toneMapping),b.push(M.numClippingPlanes),b.push(M.numClipIntersection),b.push(M.depthPacking)}function m(b,M){o.disableAll(),M.instancing&&o.enable(0),M.instancingColor&&o.enable(1),M.instancingMorph&&o.enable(2),M.matcap&&o.enable(3),M.envMap&&o.enable(4),M.normalMapObjectSpace&&o.enable(5),M.normalMapTangentSpace&&o.enable(6),M.clearcoat&&o.enable(7),M.iridescence&&o.enable(8),M.alphaTest&&o.enable(9),M.vertexColors&&o.enable(10),M.vertexAlphas&&o.enable(11),M.vertexUv1s&&o.enable(12),M.vertexUv2s&&o.enable(13),M.vertexUv3s&&o.enable(14),M.vertexTangents&&o.enable(15),M.anisotropy&&o.enable(16),M.alphaHash&&o.enable(17),M.batching&&o.enable(18),M.dispersion&&o.enable(19),M.retroreflection&&o.enable(24),M.diffuseRoughness&&o.enable(25),M.batchingColor&&o.enable(20),M.gradientMap&&o.enable(21),M.packedNormalMap&&o.enable(22),M.vertexNormals&&o.enable(23),b.push(o.mask),o.disableAll(),M.fog&&o.enable(0),M.useFog&&o.enable(1),M.flatShading&&o.enable(2),M.logarithmicDepthBuffer&&o.enable(3),M.reversedDepthBuffer&&o.enable(4),M.skinning&&o.enable(5),M.morphTargets&&o.enable(6),M.morphNormals&&o.enable(7),M.morphColors&&o.enable(8),M.premultipliedAlpha&&o.enable(9),M.shadowMapEnabled&&o.enable(10),M.doubleSided&&o.enable(11),M.flipSided&&o.enable(12),M.useDepthPacking&&o.enable(13),M.dithering&&o.enable(14),M.transmission&&o.enable(15),M.sheen&&o.enable(16),M.opaque&&o.enable(17),M.pointsUvs&&o.enable(18),M.decodeVideoTexture&&o.enable(19),M.decodeVideoTextureEmissive&&o.enable(20),M.alphaToCoverage&&o.enable(21),M.numLightProbeGrids>0&&o.enable(22),M.hasPositionAttribute&&o.enable(23),b.push(o.mask)}function x(b){let M=d[b.type],I;if(M){let P=Ds[M];I=D0.clone(P.uniforms)}else I=b.uniforms;return I}function v(b,M){let I=h.get(M);return I!==void 0?++I.usedTimes:(I=new G1(s,M,b,i),l.push(I),h.set(M,I)),I}function _(b){if(--b.usedTimes===0){let M=l.indexOf(b);l[M]=l[l.length-1],l.pop(),h.delete(b.cacheKey),b.destroy()}}function E(b){a.remove(b)}function w(){a.dispose()}return{getParameters:g,getProgramCacheKey:y,getUniforms:x,acquireProgram:v,releaseProgram:_,releaseShaderCache:E,programs:l,dispose:w}}function Y1(){let s=new WeakMap;function t(o){return s.has(o)}function e(o){let a=s.get(o);return a===void 0&&(a={},s.set(o,a)),a}function n(o){s.delete(o)}function i(o,a,c){s.get(o)[a]=c}function r(){s=new WeakMap}return{has:t,get:e,remove:n,update:i,dispose:r}}function j1(s,t){return s.groupOrder!==t.groupOrder?s.groupOrder-t.groupOrder:s.renderOrder!==t.renderOrder?s.renderOrder-t.renderOrder:s.material.id!==t.material.id?s.material.id-t.material.id:s.materialVariant!==t.materialVariant?s.materialVariant-t.materialVariant:s.z!==t.z?s.z-t.z:s.id-t.id}function Q0(s,t){return s.groupOrder!==t.groupOrder?s.groupOrder-t.groupOrder:s.renderOrder!==t.renderOrder?s.renderOrder-t.renderOrder:s.z!==t.z?t.z-s.z:s.id-t.id}function tx(){let s=[],t=0,e=[],n=[],i=[];function r(){t=0,e.length=0,n.length=0,i.length=0}function o(d){let f=0;return d.isInstancedMesh&&(f+=2),d.isSkinnedMesh&&(f+=1),f}function a(d,f,g,y,p,m){let x=s[t];return x===void 0?(x={id:d.id,object:d,geometry:f,material:g,materialVariant:o(d),groupOrder:y,renderOrder:d.renderOrder,z:p,group:m},s[t]=x):(x.id=d.id,x.object=d,x.geometry=f,x.material=g,x.materialVariant=o(d),x.groupOrder=y,x.renderOrder=d.renderOrder,x.z=p,x.group=m),t++,x}function c(d,f,g,y,p,m,x){x.reversedDepth===!0&&(p=-p);let v=a(d,f,g,y,p,m);g.transmission>0?n.push(v):g.transparent===!0?i.push(v):e.push(v)}function l(d,f,g,y,p,m){let x=a(d,f,g,y,p,m);g.transmission>0?n.unshift(x):g.transparent===!0?i.unshift(x):e.unshift(x)}function h(d,f){e.length>1&&e.sort(d||j1),n.length>1&&n.sort(f||Q0),i.length>1&&i.sort(f||Q0)}function u(){for(let d=t,f=s.length;d<f;d++){let g=s[d];if(g.id===null)break;g.id=null,g.object=null,g.geometry=null,g.material=null,g.group=null}}return{opaque:e,transmissive:n,transparent:i,init:r,push:c,unshift:l,finish:u,sort:h}}function Z1(){let s=new WeakMap;function t(n,i){let r=s.get(n),o;return r===void 0?(o=new tx,s.set(n,[o])):i>=r.length?(o=new tx,r.push(o)):o=r[i],o}function e(){s=new WeakMap}return{get:t,dispose:e}}function $1(){let s={};return{get:function(t){if(s[t.id]!==void 0)return s[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={direction:new F,color:new qt};break;case"SpotLight":e={position:new F,direction:new F,color:new qt,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new F,color:new qt,distance:0,decay:0};break;case"HemisphereLight":e={direction:new F,skyColor:new qt,groundColor:new qt};break;case"RectAreaLight":e={color:new qt,position:new F,halfWidth:new F,halfHeight:new F};break}return s[t.id]=e,e}}}function J1(){let s={};return{get:function(t){if(s[t.id]!==void 0)return s[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Vt};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Vt};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Vt,shadowCameraNear:1,shadowCameraFar:1e3};break}return s[t.id]=e,e}}}var K1=0;function Q1(s,t){return(t.castShadow?2:0)-(s.castShadow?2:0)+(t.map?1:0)-(s.map?1:0)}function tE(s){let t=new $1,e=J1(),n={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let l=0;l<9;l++)n.probe.push(new F);let i=new F,r=new Gt,o=new Gt;function a(l){let h=0,u=0,d=0;for(let D=0;D<9;D++)n.probe[D].set(0,0,0);let f=0,g=0,y=0,p=0,m=0,x=0,v=0,_=0,E=0,w=0,b=0,M=0,I=0,P=0;l.sort(Q1);for(let D=0,B=l.length;D<B;D++){let L=l[D],z=L.color,O=L.intensity,H=L.distance,tt=null;if(L.shadow&&L.shadow.map&&(L.shadow.map.texture.format===Ir?tt=L.shadow.map.texture:tt=L.shadow.map.depthTexture||L.shadow.map.texture),L.isAmbientLight)h+=z.r*O,u+=z.g*O,d+=z.b*O;else if(L.isLightProbe){for(let X=0;X<9;X++)n.probe[X].addScaledVector(L.sh.coefficients[X],O);P++}else if(L.isSunLight){let X=t.get(L);if(X.color.copy(L.color).multiplyScalar(L.intensity),L.castShadow){let Z=L.shadow,$=e.get(L);$.shadowIntensity=Z.intensity,$.shadowBias=Z.bias,$.shadowNormalBias=Z.normalBias,$.shadowRadius=Z.radius,$.shadowMapSize.copy(Z.mapSize).multiply(Z.getFrameExtents()),n.sunShadow[g]=$,n.sunShadowMap[g]=tt;let at=Z.getViewportCount();for(let it=0;it<at;it++)n.sunShadowMatrix[y+it]=Z.getMatrix(it),n.sunShadowCascade[y+it]=Z._cascadeData[it];y+=at,g++}n.sun[f]=X,f++}else if(L.isDirectionalLight){let X=t.get(L);if(X.color.copy(L.color).multiplyScalar(L.intensity),L.castShadow){let Z=L.shadow,$=e.get(L);$.shadowIntensity=Z.intensity,$.shadowBias=Z.bias,$.shadowNormalBias=Z.normalBias,$.shadowRadius=Z.radius,$.shadowMapSize=Z.mapSize,n.directionalShadow[p]=$,n.directionalShadowMap[p]=tt,n.directionalShadowMatrix[p]=L.shadow.matrix,E++}n.directional[p]=X,p++}else if(L.isSpotLight){let X=t.get(L);X.position.setFromMatrixPosition(L.matrixWorld),X.color.copy(z).multiplyScalar(O),X.distance=H,X.coneCos=Math.cos(L.angle),X.penumbraCos=Math.cos(L.angle*(1-L.penumbra)),X.decay=L.decay,n.spot[x]=X;let Z=L.shadow;if(L.map&&(n.spotLightMap[M]=L.map,M++,Z.updateMatrices(L),L.castShadow&&I++),n.spotLightMatrix[x]=Z.matrix,L.castShadow){let $=e.get(L);$.shadowIntensity=Z.intensity,$.shadowBias=Z.bias,$.shadowNormalBias=Z.normalBias,$.shadowRadius=Z.radius,$.shadowMapSize=Z.mapSize,n.spotShadow[x]=$,n.spotShadowMap[x]=tt,b++}x++}else if(L.isRectAreaLight){let X=t.get(L);X.color.copy(z).multiplyScalar(O),X.halfWidth.set(L.width*.5,0,0),X.halfHeight.set(0,L.height*.5,0),n.rectArea[v]=X,v++}else if(L.isPointLight){let X=t.get(L);if(X.color.copy(L.color).multiplyScalar(L.intensity),X.distance=L.distance,X.decay=L.decay,L.castShadow){let Z=L.shadow,$=e.get(L);$.shadowIntensity=Z.intensity,$.shadowBias=Z.bias,$.shadowNormalBias=Z.normalBias,$.shadowRadius=Z.radius,$.shadowMapSize=Z.mapSize,$.shadowCameraNear=Z.camera.near,$.shadowCameraFar=Z.camera.far,n.pointShadow[m]=$,n.pointShadowMap[m]=tt,n.pointShadowMatrix[m]=L.shadow.matrix,w++}n.point[m]=X,m++}else if(L.isHemisphereLight){let X=t.get(L);X.skyColor.copy(L.color).multiplyScalar(O),X.groundColor.copy(L.groundColor).multiplyScalar(O),n.hemi[_]=X,_++}}v>0&&(s.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=Lt.LTC_FLOAT_1,n.rectAreaLTC2=Lt.LTC_FLOAT_2):(n.rectAreaLTC1=Lt.LTC_HALF_1,n.rectAreaLTC2=Lt.LTC_HALF_2)),n.ambient[0]=h,n.ambient[1]=u,n.ambient[2]=d;let C=n.hash;(C.sunLength!==f||C.directionalLength!==p||C.pointLength!==m||C.spotLength!==x||C.rectAreaLength!==v||C.hemiLength!==_||C.numSunShadows!==g||C.numDirectionalShadows!==E||C.numPointShadows!==w||C.numSpotShadows!==b||C.numSpotMaps!==M||C.numLightProbes!==P)&&(n.sun.length=f,n.directional.length=p,n.spot.length=x,n.rectArea.length=v,n.point.length=m,n.hemi.length=_,n.sunShadow.length=g,n.sunShadowMap.length=g,n.sunShadowMatrix.length=y,n.sunShadowCascade.length=y,n.directionalShadow.length=E,n.directionalShadowMap.length=E,n.directionalShadowMatrix.length=E,n.pointShadow.length=w,n.pointShadowMap.length=w,n.pointShadowMatrix.length=w,n.spotShadow.length=b,n.spotShadowMap.length=b,n.spotLightMatrix.length=b+M-I,n.spotLightMap.length=M,n.numSpotLightShadowsWithMaps=I,n.numLightProbes=P,C.sunLength=f,C.directionalLength=p,C.pointLength=m,C.spotLength=x,C.rectAreaLength=v,C.hemiLength=_,C.numSunShadows=g,C.numDirectionalShadows=E,C.numPointShadows=w,C.numSpotShadows=b,C.numSpotMaps=M,C.numLightProbes=P,n.version=K1++)}function c(l,h){let u=0,d=0,f=0,g=0,y=0,p=0,m=h.matrixWorldInverse;for(let x=0,v=l.length;x<v;x++){let _=l[x];if(_.isSunLight){let E=n.sun[u];E.direction.setFromMatrixPosition(_.matrixWorld),E.direction.transformDirection(m),u++}else if(_.isDirectionalLight){let E=n.directional[d];E.direction.setFromMatrixPosition(_.matrixWorld),i.setFromMatrixPosition(_.target.matrixWorld),E.direction.sub(i),E.direction.transformDirection(m),d++}else if(_.isSpotLight){let E=n.spot[g];E.position.setFromMatrixPosition(_.matrixWorld),E.position.applyMatrix4(m),E.direction.setFromMatrixPosition(_.matrixWorld),i.setFromMatrixPosition(_.target.matrixWorld),E.direction.sub(i),E.direction.transformDirection(m),g++}else if(_.isRectAreaLight){let E=n.rectArea[y];E.position.setFromMatrixPosition(_.matrixWorld),E.position.applyMatrix4(m),o.identity(),r.copy(_.matrixWorld),r.premultiply(m),o.extractRotation(r),E.halfWidth.set(_.width*.5,0,0),E.halfHeight.set(0,_.height*.5,0),E.halfWidth.applyMatrix4(o),E.halfHeight.applyMatrix4(o),y++}else if(_.isPointLight){let E=n.point[f];E.position.setFromMatrixPosition(_.matrixWorld),E.position.applyMatrix4(m),f++}else if(_.isHemisphereLight){let E=n.hemi[p];E.direction.setFromMatrixPosition(_.matrixWorld),E.direction.transformDirection(m),p++}}}return{setup:a,setupView:c,state:n}}function ex(s){let t=new tE(s),e=[],n=[],i=[];function r(u){h.camera=u,e.length=0,n.length=0,i.length=0}function o(u){u.isLightProbeGrid?i.push(u):e.push(u)}function a(u){n.push(u)}function c(){t.setup(e),i.sort((u,d)=>u.priority-d.priority||u.id-d.id)}function l(u){t.setupView(e,u)}let h={lightsArray:e,shadowsArray:n,lightProbeGridArray:i,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:h,setupLights:c,setupLightsView:l,pushLight:o,pushShadow:a}}function eE(s){let t=new WeakMap;function e(i,r=0){let o=t.get(i),a;return o===void 0?(a=new ex(s),t.set(i,[a])):r>=o.length?(a=new ex(s),o.push(a)):a=o[r],a}function n(){t=new WeakMap}return{get:e,dispose:n}}var nE=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,iE=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,sE=[new F(1,0,0),new F(-1,0,0),new F(0,1,0),new F(0,-1,0),new F(0,0,1),new F(0,0,-1)],rE=[new F(0,-1,0),new F(0,-1,0),new F(0,0,1),new F(0,0,-1),new F(0,-1,0),new F(0,-1,0)],nx=new Gt,zl=new F,bp=new F;function oE(s,t,e){let n=new Mr,i=new Vt,r=new Vt,o=new ze,a=new _h,c=new yh,l={},h=e.maxTextureSize,u={[Ls]:bi,[bi]:Ls,[ci]:ci},d=new Zi({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Vt},radius:{value:4}},vertexShader:nE,fragmentShader:iE}),f=d.clone();f.defines.HORIZONTAL_PASS=1;let g=new ue;g.setAttribute("position",new Xe(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let y=new gt(g,d),p=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=no;let m=this.type;this.render=function(w,b,M){if(p.enabled===!1||p.autoUpdate===!1&&p.needsUpdate===!1||w.length===0)return;this.type===Wg&&(Zt("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=no);let I=s.getRenderTarget(),P=s.getActiveCubeFace(),C=s.getActiveMipmapLevel(),D=s.state;D.setBlending(io),D.buffers.depth.getReversed()===!0?D.buffers.color.setClear(0,0,0,0):D.buffers.color.setClear(1,1,1,1),D.buffers.depth.setTest(!0),D.setScissorTest(!1);let B=m!==this.type;B&&b.traverse(function(L){L.material&&(Array.isArray(L.material)?L.material.forEach(z=>z.needsUpdate=!0):L.material.needsUpdate=!0)});for(let L=0,z=w.length;L<z;L++){let O=w[L],H=O.shadow;if(H===void 0){Zt("WebGLShadowMap:",O,"has no shadow.");continue}if(H.autoUpdate===!1&&H.needsUpdate===!1)continue;i.copy(H.mapSize);let tt=H.getFrameExtents();i.multiply(tt),r.copy(H.mapSize),(i.x>h||i.y>h)&&(i.x>h&&(r.x=Math.floor(h/tt.x),i.x=r.x*tt.x,H.mapSize.x=r.x),i.y>h&&(r.y=Math.floor(h/tt.y),i.y=r.y*tt.y,H.mapSize.y=r.y));let X=s.state.buffers.depth.getReversed();if(H.camera._reversedDepth=X,H.map===null||B===!0){if(H.map!==null&&(H.map.depthTexture!==null&&(H.map.depthTexture.dispose(),H.map.depthTexture=null),H.map.dispose()),this.type===da){if(O.isPointLight){Zt("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}H.map=new ki(i.x,i.y,{format:Ir,type:gs,minFilter:jn,magFilter:jn,generateMipmaps:!1}),H.map.texture.name=O.name+".shadowMap",H.map.depthTexture=new Ks(i.x,i.y,Bi),H.map.depthTexture.name=O.name+".shadowMapDepth",H.map.depthTexture.format=$s,H.map.depthTexture.compareFunction=null,H.map.depthTexture.minFilter=Zn,H.map.depthTexture.magFilter=Zn}else O.isPointLight?(H.map=new Vl(i.x),H.map.depthTexture=new ml(i.x,ms)):(H.map=new ki(i.x,i.y),H.map.depthTexture=new Ks(i.x,i.y,ms)),H.map.depthTexture.name=O.name+".shadowMap",H.map.depthTexture.format=$s,this.type===no?(H.map.depthTexture.compareFunction=X?lp:ap,H.map.depthTexture.minFilter=jn,H.map.depthTexture.magFilter=jn):(H.map.depthTexture.compareFunction=null,H.map.depthTexture.minFilter=Zn,H.map.depthTexture.magFilter=Zn);H.camera.updateProjectionMatrix()}H.map.isWebGLCubeRenderTarget!==!0&&(H.map.width!==i.x||H.map.height!==i.y)&&H.map.setSize(i.x,i.y);let Z=H.map.isWebGLCubeRenderTarget?6:H.getViewportCount();O.isPointLight!==!0&&H.updateMatrices(O,M);let $=(H.camera.layers.mask&4294967294)!==0?H.camera.layers:M.layers;for(let at=0;at<Z;at++){let it=H.getCamera(at);if(O.isPointLight){let Y=H.camera,st=H.matrix,nt=O.distance||Y.far;nt!==Y.far&&(Y.far=nt,Y.updateProjectionMatrix()),zl.setFromMatrixPosition(O.matrixWorld),Y.position.copy(zl),bp.copy(Y.position),bp.add(sE[at]),Y.up.copy(rE[at]),Y.lookAt(bp),Y.updateMatrixWorld(),st.makeTranslation(-zl.x,-zl.y,-zl.z),nx.multiplyMatrices(Y.projectionMatrix,Y.matrixWorldInverse),H._frustum.setFromProjectionMatrix(nx,Y.coordinateSystem,Y.reversedDepth)}if(H.map.isWebGLCubeRenderTarget)s.setRenderTarget(H.map,at),s.clear();else{at===0&&(s.setRenderTarget(H.map),s.clear());let Y=H.getViewport(at);o.set(r.x*Y.x,r.y*Y.y,r.x*Y.z,r.y*Y.w),D.viewport(o)}n=H.getFrustum(at),_(b,M,it,O,$,this.type)}H.isPointLightShadow!==!0&&this.type===da&&x(H,M),H.needsUpdate=!1}m=this.type,p.needsUpdate=!1,s.setRenderTarget(I,P,C)};function x(w,b){let M=t.update(y);d.defines.VSM_SAMPLES!==w.blurSamples&&(d.defines.VSM_SAMPLES=w.blurSamples,f.defines.VSM_SAMPLES=w.blurSamples,d.needsUpdate=!0,f.needsUpdate=!0),w.mapPass===null?w.mapPass=new ki(i.x,i.y,{format:Ir,type:gs}):(w.mapPass.width!==w.map.width||w.mapPass.height!==w.map.height)&&w.mapPass.setSize(w.map.width,w.map.height),d.uniforms.shadow_pass.value=w.map.depthTexture,d.uniforms.resolution.value.set(w.map.width,w.map.height),d.uniforms.radius.value=w.radius,s.setRenderTarget(w.mapPass),s.clear(),s.renderBufferDirect(b,null,M,d,y,null),f.uniforms.shadow_pass.value=w.mapPass.texture,f.uniforms.resolution.value.set(w.map.width,w.map.height),f.uniforms.radius.value=w.radius,s.setRenderTarget(w.map),s.clear(),s.renderBufferDirect(b,null,M,f,y,null)}function v(w,b,M,I){let P=null,C=M.isPointLight===!0?w.customDistanceMaterial:w.customDepthMaterial;if(C!==void 0)P=C;else if(P=M.isPointLight===!0?c:a,s.localClippingEnabled&&b.clipShadows===!0&&Array.isArray(b.clippingPlanes)&&b.clippingPlanes.length!==0||b.displacementMap&&b.displacementScale!==0||b.alphaMap&&b.alphaTest>0||b.map&&b.alphaTest>0||b.alphaToCoverage===!0){let D=P.uuid,B=b.uuid,L=l[D];L===void 0&&(L={},l[D]=L);let z=L[B];z===void 0&&(z=P.clone(),L[B]=z,b.addEventListener("dispose",E)),P=z}if(P.visible=b.visible,P.wireframe=b.wireframe,I===da?P.side=b.shadowSide!==null?b.shadowSide:b.side:P.side=b.shadowSide!==null?b.shadowSide:u[b.side],P.alphaMap=b.alphaMap,P.alphaTest=b.alphaToCoverage===!0?.5:b.alphaTest,P.map=b.map,P.clipShadows=b.clipShadows,P.clippingPlanes=b.clippingPlanes,P.clipIntersection=b.clipIntersection,P.displacementMap=b.displacementMap,P.displacementScale=b.displacementScale,P.displacementBias=b.displacementBias,P.wireframeLinewidth=b.wireframeLinewidth,P.linewidth=b.linewidth,M.isPointLight===!0&&P.isMeshDistanceMaterial===!0){let D=s.properties.get(P);D.light=M}return P}function _(w,b,M,I,P,C){if(w.visible===!1)return;if(w.layers.test(P)&&(w.isMesh||w.isLine||w.isPoints)&&(w.castShadow||w.receiveShadow&&C===da)&&(!w.frustumCulled||w.intersectsFrustum(n))){w.modelViewMatrix.multiplyMatrices(M.matrixWorldInverse,w.matrixWorld);let L=t.update(w),z=w.material;if(Array.isArray(z)){let O=L.groups;for(let H=0,tt=O.length;H<tt;H++){let X=O[H],Z=z[X.materialIndex];if(Z&&Z.visible){let $=v(w,Z,I,C);w.onBeforeShadow(s,w,b,M,L,$,X),s.renderBufferDirect(M,null,L,$,w,X),w.onAfterShadow(s,w,b,M,L,$,X)}}}else if(z.visible){let O=v(w,z,I,C);w.onBeforeShadow(s,w,b,M,L,O,null),s.renderBufferDirect(M,null,L,O,w,null),w.onAfterShadow(s,w,b,M,L,O,null)}}let B=w.children;for(let L=0,z=B.length;L<z;L++)_(B[L],b,M,I,P,C)}function E(w){w.target.removeEventListener("dispose",E);for(let M in l){let I=l[M],P=w.target.uuid;P in I&&(I[P].dispose(),delete I[P])}}}function aE(s,t){function e(){let V=!1,ht=new ze,ot=null,Et=new ze(0,0,0,0);return{setMask:function(yt){ot!==yt&&!V&&(s.colorMask(yt,yt,yt,yt),ot=yt)},setLocked:function(yt){V=yt},setClear:function(yt,St,Yt,ee,ft){ft===!0&&(yt*=ee,St*=ee,Yt*=ee),ht.set(yt,St,Yt,ee),Et.equals(ht)===!1&&(s.clearColor(yt,St,Yt,ee),Et.copy(ht))},reset:function(){V=!1,ot=null,Et.set(-1,0,0,0)}}}function n(){let V=!1,ht=!1,ot=null,Et=null,yt=null;return{setReversed:function(St){if(ht!==St){let Yt=t.get("EXT_clip_control");St?Yt.clipControlEXT(Yt.LOWER_LEFT_EXT,Yt.ZERO_TO_ONE_EXT):Yt.clipControlEXT(Yt.LOWER_LEFT_EXT,Yt.NEGATIVE_ONE_TO_ONE_EXT),ht=St;let ee=yt;yt=null,this.setClear(ee)}},getReversed:function(){return ht},setTest:function(St){St?mt(s.DEPTH_TEST):Ut(s.DEPTH_TEST)},setMask:function(St){ot!==St&&!V&&(s.depthMask(St),ot=St)},setFunc:function(St){if(ht&&(St=T0[St]),Et!==St){switch(St){case eh:s.depthFunc(s.NEVER);break;case nh:s.depthFunc(s.ALWAYS);break;case ih:s.depthFunc(s.LESS);break;case jo:s.depthFunc(s.LEQUAL);break;case sh:s.depthFunc(s.EQUAL);break;case rh:s.depthFunc(s.GEQUAL);break;case oh:s.depthFunc(s.GREATER);break;case ah:s.depthFunc(s.NOTEQUAL);break;default:s.depthFunc(s.LEQUAL)}Et=St}},setLocked:function(St){V=St},setClear:function(St){yt!==St&&(yt=St,ht&&(St=1-St),s.clearDepth(St))},reset:function(){V=!1,ot=null,Et=null,yt=null,ht=!1}}}function i(){let V=!1,ht=null,ot=null,Et=null,yt=null,St=null,Yt=null,ee=null,ft=null;return{setTest:function(Bt){V||(Bt?mt(s.STENCIL_TEST):Ut(s.STENCIL_TEST))},setMask:function(Bt){ht!==Bt&&!V&&(s.stencilMask(Bt),ht=Bt)},setFunc:function(Bt,ne,Rt){(ot!==Bt||Et!==ne||yt!==Rt)&&(s.stencilFunc(Bt,ne,Rt),ot=Bt,Et=ne,yt=Rt)},setOp:function(Bt,ne,Rt){(St!==Bt||Yt!==ne||ee!==Rt)&&(s.stencilOp(Bt,ne,Rt),St=Bt,Yt=ne,ee=Rt)},setLocked:function(Bt){V=Bt},setClear:function(Bt){ft!==Bt&&(s.clearStencil(Bt),ft=Bt)},reset:function(){V=!1,ht=null,ot=null,Et=null,yt=null,St=null,Yt=null,ee=null,ft=null}}}let r=new e,o=new n,a=new i,c={},l=new WeakMap,h={},u={},d={},f=new WeakMap,g=[],y=null,p=!1,m=null,x=null,v=null,_=null,E=null,w=null,b=null,M=new qt(0,0,0),I=0,P=!1,C=null,D=null,B=null,L=null,z=null,O=s.getParameter(s.MAX_COMBINED_TEXTURE_IMAGE_UNITS),H=!1,tt=0,X=s.getParameter(s.VERSION);X.indexOf("WebGL")!==-1?(tt=parseFloat(/^WebGL (\d)/.exec(X)[1]),H=tt>=1):X.indexOf("OpenGL ES")!==-1&&(tt=parseFloat(/^OpenGL ES (\d)/.exec(X)[1]),H=tt>=2);let Z=null,$={},at=s.getParameter(s.SCISSOR_BOX),it=s.getParameter(s.VIEWPORT),Y=new ze().fromArray(at),st=new ze().fromArray(it);function nt(V,ht,ot,Et){let yt=new Uint8Array(4),St=s.createTexture();s.bindTexture(V,St),s.texParameteri(V,s.TEXTURE_MIN_FILTER,s.NEAREST),s.texParameteri(V,s.TEXTURE_MAG_FILTER,s.NEAREST);for(let Yt=0;Yt<ot;Yt++)V===s.TEXTURE_3D||V===s.TEXTURE_2D_ARRAY?s.texImage3D(ht,0,s.RGBA,1,1,Et,0,s.RGBA,s.UNSIGNED_BYTE,yt):s.texImage2D(ht+Yt,0,s.RGBA,1,1,0,s.RGBA,s.UNSIGNED_BYTE,yt);return St}let lt={};lt[s.TEXTURE_2D]=nt(s.TEXTURE_2D,s.TEXTURE_2D,1),lt[s.TEXTURE_CUBE_MAP]=nt(s.TEXTURE_CUBE_MAP,s.TEXTURE_CUBE_MAP_POSITIVE_X,6),lt[s.TEXTURE_2D_ARRAY]=nt(s.TEXTURE_2D_ARRAY,s.TEXTURE_2D_ARRAY,1,1),lt[s.TEXTURE_3D]=nt(s.TEXTURE_3D,s.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),mt(s.DEPTH_TEST),o.setFunc(jo),En(!1),Ve(Vf),mt(s.CULL_FACE),an(io);function mt(V){h[V]!==!0&&(s.enable(V),h[V]=!0)}function Ut(V){h[V]!==!1&&(s.disable(V),h[V]=!1)}function Jt(V,ht){return d[V]!==ht?(s.bindFramebuffer(V,ht),d[V]=ht,V===s.DRAW_FRAMEBUFFER&&(d[s.FRAMEBUFFER]=ht),V===s.FRAMEBUFFER&&(d[s.DRAW_FRAMEBUFFER]=ht),!0):!1}function Ot(V,ht){let ot=g,Et=!1;if(V){ot=f.get(ht),ot===void 0&&(ot=[],f.set(ht,ot));let yt=V.textures;if(ot.length!==yt.length||ot[0]!==s.COLOR_ATTACHMENT0){for(let St=0,Yt=yt.length;St<Yt;St++)ot[St]=s.COLOR_ATTACHMENT0+St;ot.length=yt.length,Et=!0}}else ot[0]!==s.BACK&&(ot[0]=s.BACK,Et=!0);Et&&s.drawBuffers(ot)}function me(V){return y!==V?(s.useProgram(V),y=V,!0):!1}let de={[so]:s.FUNC_ADD,[qg]:s.FUNC_SUBTRACT,[Yg]:s.FUNC_REVERSE_SUBTRACT};de[jg]=s.MIN,de[Zg]=s.MAX;let oe={[$g]:s.ZERO,[Jg]:s.ONE,[Kg]:s.SRC_COLOR,[qf]:s.SRC_ALPHA,[s0]:s.SRC_ALPHA_SATURATE,[n0]:s.DST_COLOR,[t0]:s.DST_ALPHA,[Qg]:s.ONE_MINUS_SRC_COLOR,[Yf]:s.ONE_MINUS_SRC_ALPHA,[i0]:s.ONE_MINUS_DST_COLOR,[e0]:s.ONE_MINUS_DST_ALPHA,[r0]:s.CONSTANT_COLOR,[o0]:s.ONE_MINUS_CONSTANT_COLOR,[a0]:s.CONSTANT_ALPHA,[l0]:s.ONE_MINUS_CONSTANT_ALPHA};function an(V,ht,ot,Et,yt,St,Yt,ee,ft,Bt){if(V===io){p===!0&&(Ut(s.BLEND),p=!1);return}if(p===!1&&(mt(s.BLEND),p=!0),V!==Xg){if(V!==m||Bt!==P){if((x!==so||E!==so)&&(s.blendEquation(s.FUNC_ADD),x=so,E=so),Bt)switch(V){case fa:s.blendFuncSeparate(s.ONE,s.ONE_MINUS_SRC_ALPHA,s.ONE,s.ONE_MINUS_SRC_ALPHA);break;case Gf:s.blendFunc(s.ONE,s.ONE);break;case Wf:s.blendFuncSeparate(s.ZERO,s.ONE_MINUS_SRC_COLOR,s.ZERO,s.ONE);break;case Xf:s.blendFuncSeparate(s.DST_COLOR,s.ONE_MINUS_SRC_ALPHA,s.ZERO,s.ONE);break;default:te("WebGLState: Invalid blending: ",V);break}else switch(V){case fa:s.blendFuncSeparate(s.SRC_ALPHA,s.ONE_MINUS_SRC_ALPHA,s.ONE,s.ONE_MINUS_SRC_ALPHA);break;case Gf:s.blendFuncSeparate(s.SRC_ALPHA,s.ONE,s.ONE,s.ONE);break;case Wf:te("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Xf:te("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:te("WebGLState: Invalid blending: ",V);break}v=null,_=null,w=null,b=null,M.set(0,0,0),I=0,m=V,P=Bt}return}yt=yt||ht,St=St||ot,Yt=Yt||Et,(ht!==x||yt!==E)&&(s.blendEquationSeparate(de[ht],de[yt]),x=ht,E=yt),(ot!==v||Et!==_||St!==w||Yt!==b)&&(s.blendFuncSeparate(oe[ot],oe[Et],oe[St],oe[Yt]),v=ot,_=Et,w=St,b=Yt),(ee.equals(M)===!1||ft!==I)&&(s.blendColor(ee.r,ee.g,ee.b,ft),M.copy(ee),I=ft),m=V,P=!1}function Ke(V,ht){V.side===ci?Ut(s.CULL_FACE):mt(s.CULL_FACE);let ot=V.side===bi;ht&&(ot=!ot),En(ot),V.blending===fa&&V.transparent===!1?an(io):an(V.blending,V.blendEquation,V.blendSrc,V.blendDst,V.blendEquationAlpha,V.blendSrcAlpha,V.blendDstAlpha,V.blendColor,V.blendAlpha,V.premultipliedAlpha),o.setFunc(V.depthFunc),o.setTest(V.depthTest),o.setMask(V.depthWrite),r.setMask(V.colorWrite);let Et=V.stencilWrite;a.setTest(Et),Et&&(a.setMask(V.stencilWriteMask),a.setFunc(V.stencilFunc,V.stencilRef,V.stencilFuncMask),a.setOp(V.stencilFail,V.stencilZFail,V.stencilZPass)),Ee(V.polygonOffset,V.polygonOffsetFactor,V.polygonOffsetUnits),V.alphaToCoverage===!0?mt(s.SAMPLE_ALPHA_TO_COVERAGE):Ut(s.SAMPLE_ALPHA_TO_COVERAGE)}function En(V){C!==V&&(V?s.frontFace(s.CW):s.frontFace(s.CCW),C=V)}function Ve(V){V!==Vg?(mt(s.CULL_FACE),V!==D&&(V===Vf?s.cullFace(s.BACK):V===Gg?s.cullFace(s.FRONT):s.cullFace(s.FRONT_AND_BACK))):Ut(s.CULL_FACE),D=V}function Vn(V){V!==B&&(H&&s.lineWidth(V),B=V)}function Ee(V,ht,ot){V?(mt(s.POLYGON_OFFSET_FILL),(L!==ht||z!==ot)&&(L=ht,z=ot,o.getReversed()&&(ht=-ht,ot=-ot),s.polygonOffset(ht,ot))):Ut(s.POLYGON_OFFSET_FILL)}function Dn(V){V?mt(s.SCISSOR_TEST):Ut(s.SCISSOR_TEST)}function gn(V){V===void 0&&(V=s.TEXTURE0+O-1),Z!==V&&(s.activeTexture(V),Z=V)}function Tn(V,ht,ot){ot===void 0&&(Z===null?ot=s.TEXTURE0+O-1:ot=Z);let Et=$[ot];Et===void 0&&(Et={type:void 0,texture:void 0},$[ot]=Et),(Et.type!==V||Et.texture!==ht)&&(Z!==ot&&(s.activeTexture(ot),Z=ot),s.bindTexture(V,ht||lt[V]),Et.type=V,Et.texture=ht)}function G(){let V=$[Z];V!==void 0&&V.type!==void 0&&(s.bindTexture(V.type,null),V.type=void 0,V.texture=void 0)}function Ct(){try{s.compressedTexImage2D(...arguments)}catch(V){te("WebGLState:",V)}}function Kt(){try{s.compressedTexImage3D(...arguments)}catch(V){te("WebGLState:",V)}}function le(){try{s.texSubImage2D(...arguments)}catch(V){te("WebGLState:",V)}}function Mt(){try{s.texSubImage3D(...arguments)}catch(V){te("WebGLState:",V)}}function We(){try{s.compressedTexSubImage2D(...arguments)}catch(V){te("WebGLState:",V)}}function Wt(){try{s.compressedTexSubImage3D(...arguments)}catch(V){te("WebGLState:",V)}}function $t(){try{s.texStorage2D(...arguments)}catch(V){te("WebGLState:",V)}}function N(){try{s.texStorage3D(...arguments)}catch(V){te("WebGLState:",V)}}function T(){try{s.texImage2D(...arguments)}catch(V){te("WebGLState:",V)}}function j(){try{s.texImage3D(...arguments)}catch(V){te("WebGLState:",V)}}function pt(V){return u[V]!==void 0?u[V]:s.getParameter(V)}function ut(V,ht){u[V]!==ht&&(s.pixelStorei(V,ht),u[V]=ht)}function bt(V){Y.equals(V)===!1&&(s.scissor(V.x,V.y,V.z,V.w),Y.copy(V))}function vt(V){st.equals(V)===!1&&(s.viewport(V.x,V.y,V.z,V.w),st.copy(V))}function rt(V,ht){let ot=l.get(ht);ot===void 0&&(ot=new WeakMap,l.set(ht,ot));let Et=ot.get(V);Et===void 0&&(Et=s.getUniformBlockIndex(ht,V.name),s.uniformBlockBinding(ht,Et,Et),ot.set(V,Et))}function ct(V,ht,ot){let yt=l.get(ht).get(V);c[yt]!==ot&&(s.bindBufferBase(s.UNIFORM_BUFFER,yt,ot),c[yt]=ot)}function _t(){s.disable(s.BLEND),s.disable(s.CULL_FACE),s.disable(s.DEPTH_TEST),s.disable(s.POLYGON_OFFSET_FILL),s.disable(s.SCISSOR_TEST),s.disable(s.STENCIL_TEST),s.disable(s.SAMPLE_ALPHA_TO_COVERAGE),s.blendEquation(s.FUNC_ADD),s.blendFunc(s.ONE,s.ZERO),s.blendFuncSeparate(s.ONE,s.ZERO,s.ONE,s.ZERO),s.blendColor(0,0,0,0),s.colorMask(!0,!0,!0,!0),s.clearColor(0,0,0,0),s.depthMask(!0),s.depthFunc(s.LESS),o.setReversed(!1),s.clearDepth(1),s.stencilMask(4294967295),s.stencilFunc(s.ALWAYS,0,4294967295),s.stencilOp(s.KEEP,s.KEEP,s.KEEP),s.clearStencil(0),s.cullFace(s.BACK),s.frontFace(s.CCW),s.polygonOffset(0,0),s.activeTexture(s.TEXTURE0),s.bindFramebuffer(s.FRAMEBUFFER,null),s.bindFramebuffer(s.DRAW_FRAMEBUFFER,null),s.bindFramebuffer(s.READ_FRAMEBUFFER,null),s.useProgram(null),s.lineWidth(1),s.scissor(0,0,s.canvas.width,s.canvas.height),s.viewport(0,0,s.canvas.width,s.canvas.height),s.pixelStorei(s.PACK_ALIGNMENT,4),s.pixelStorei(s.UNPACK_ALIGNMENT,4),s.pixelStorei(s.UNPACK_FLIP_Y_WEBGL,!1),s.pixelStorei(s.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),s.pixelStorei(s.UNPACK_COLORSPACE_CONVERSION_WEBGL,s.BROWSER_DEFAULT_WEBGL),s.pixelStorei(s.PACK_ROW_LENGTH,0),s.pixelStorei(s.PACK_SKIP_PIXELS,0),s.pixelStorei(s.PACK_SKIP_ROWS,0),s.pixelStorei(s.UNPACK_ROW_LENGTH,0),s.pixelStorei(s.UNPACK_IMAGE_HEIGHT,0),s.pixelStorei(s.UNPACK_SKIP_PIXELS,0),s.pixelStorei(s.UNPACK_SKIP_ROWS,0),s.pixelStorei(s.UNPACK_SKIP_IMAGES,0),h={},u={},Z=null,$={},d={},c={},f=new WeakMap,g=[],y=null,p=!1,m=null,x=null,v=null,_=null,E=null,w=null,b=null,M=new qt(0,0,0),I=0,P=!1,C=null,D=null,B=null,L=null,z=null,Y.set(0,0,s.canvas.width,s.canvas.height),st.set(0,0,s.canvas.width,s.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:mt,disable:Ut,bindFramebuffer:Jt,drawBuffers:Ot,useProgram:me,setBlending:an,setMaterial:Ke,setFlipSided:En,setCullFace:Ve,setLineWidth:Vn,setPolygonOffset:Ee,setScissorTest:Dn,activeTexture:gn,bindTexture:Tn,unbindTexture:G,compressedTexImage2D:Ct,compressedTexImage3D:Kt,texImage2D:T,texImage3D:j,pixelStorei:ut,getParameter:pt,updateUBOMapping:rt,uniformBlockBinding:ct,texStorage2D:$t,texStorage3D:N,texSubImage2D:le,texSubImage3D:Mt,compressedTexSubImage2D:We,compressedTexSubImage3D:Wt,scissor:bt,viewport:vt,reset:_t}}function lE(s,t,e,n,i,r,o){let a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,c=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),l=new Vt,h=new WeakMap,u=new Set,d,f=new WeakMap,g=new Set,y=new FinalizationRegistry(N=>g.delete(N)),p=!1;try{p=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function m(N,T){return p?new OffscreenCanvas(N,T):$o("canvas")}function x(N,T,j){let pt=1,ut=$t(N);if((ut.width>j||ut.height>j)&&(pt=j/Math.max(ut.width,ut.height)),pt<1)if(typeof HTMLImageElement<"u"&&N instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&N instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&N instanceof ImageBitmap||typeof VideoFrame<"u"&&N instanceof VideoFrame){let bt=Math.floor(pt*ut.width),vt=Math.floor(pt*ut.height);d===void 0&&(d=m(bt,vt));let rt=T?m(bt,vt):d;return rt.width=bt,rt.height=vt,rt.getContext("2d").drawImage(N,0,0,bt,vt),Zt("WebGLRenderer: Texture has been resized from ("+ut.width+"x"+ut.height+") to ("+bt+"x"+vt+")."),rt}else return"data"in N&&Zt("WebGLRenderer: Image in DataTexture is too big ("+ut.width+"x"+ut.height+")."),N;return N}function v(N){return N.generateMipmaps}function _(N){s.generateMipmap(N)}function E(N){return N.isWebGLCubeRenderTarget?s.TEXTURE_CUBE_MAP:N.isWebGL3DRenderTarget?s.TEXTURE_3D:N.isWebGLArrayRenderTarget||N.isCompressedArrayTexture?s.TEXTURE_2D_ARRAY:s.TEXTURE_2D}function w(N,T,j,pt,ut,bt=!1){if(N!==null){if(s[N]!==void 0)return s[N];Zt("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+N+"'")}let vt;pt&&(vt=t.get("EXT_texture_norm16"),vt||Zt("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let rt=T;if(T===s.RED&&(j===s.FLOAT&&(rt=s.R32F),j===s.HALF_FLOAT&&(rt=s.R16F),j===s.UNSIGNED_BYTE&&(rt=s.R8),j===s.UNSIGNED_SHORT&&vt&&(rt=vt.R16_EXT),j===s.SHORT&&vt&&(rt=vt.R16_SNORM_EXT)),T===s.RED_INTEGER&&(j===s.UNSIGNED_BYTE&&(rt=s.R8UI),j===s.UNSIGNED_SHORT&&(rt=s.R16UI),j===s.UNSIGNED_INT&&(rt=s.R32UI),j===s.BYTE&&(rt=s.R8I),j===s.SHORT&&(rt=s.R16I),j===s.INT&&(rt=s.R32I)),T===s.RG&&(j===s.FLOAT&&(rt=s.RG32F),j===s.HALF_FLOAT&&(rt=s.RG16F),j===s.UNSIGNED_BYTE&&(rt=s.RG8),j===s.UNSIGNED_SHORT&&vt&&(rt=vt.RG16_EXT),j===s.SHORT&&vt&&(rt=vt.RG16_SNORM_EXT)),T===s.RG_INTEGER&&(j===s.UNSIGNED_BYTE&&(rt=s.RG8UI),j===s.UNSIGNED_SHORT&&(rt=s.RG16UI),j===s.UNSIGNED_INT&&(rt=s.RG32UI),j===s.BYTE&&(rt=s.RG8I),j===s.SHORT&&(rt=s.RG16I),j===s.INT&&(rt=s.RG32I)),T===s.RGB_INTEGER&&(j===s.UNSIGNED_BYTE&&(rt=s.RGB8UI),j===s.UNSIGNED_SHORT&&(rt=s.RGB16UI),j===s.UNSIGNED_INT&&(rt=s.RGB32UI),j===s.BYTE&&(rt=s.RGB8I),j===s.SHORT&&(rt=s.RGB16I),j===s.INT&&(rt=s.RGB32I)),T===s.RGBA_INTEGER&&(j===s.UNSIGNED_BYTE&&(rt=s.RGBA8UI),j===s.UNSIGNED_SHORT&&(rt=s.RGBA16UI),j===s.UNSIGNED_INT&&(rt=s.RGBA32UI),j===s.BYTE&&(rt=s.RGBA8I),j===s.SHORT&&(rt=s.RGBA16I),j===s.INT&&(rt=s.RGBA32I)),T===s.RGB&&(j===s.UNSIGNED_SHORT&&vt&&(rt=vt.RGB16_EXT),j===s.SHORT&&vt&&(rt=vt.RGB16_SNORM_EXT),j===s.UNSIGNED_INT_5_9_9_9_REV&&(rt=s.RGB9_E5),j===s.UNSIGNED_INT_10F_11F_11F_REV&&(rt=s.R11F_G11F_B10F)),T===s.RGBA){let ct=bt?ol:he.getTransfer(ut);j===s.FLOAT&&(rt=s.RGBA32F),j===s.HALF_FLOAT&&(rt=s.RGBA16F),j===s.UNSIGNED_BYTE&&(rt=ct===Ne?s.SRGB8_ALPHA8:s.RGBA8),j===s.UNSIGNED_SHORT&&vt&&(rt=vt.RGBA16_EXT),j===s.SHORT&&vt&&(rt=vt.RGBA16_SNORM_EXT),j===s.UNSIGNED_SHORT_4_4_4_4&&(rt=s.RGBA4),j===s.UNSIGNED_SHORT_5_5_5_1&&(rt=s.RGB5_A1)}return(rt===s.R16F||rt===s.R32F||rt===s.RG16F||rt===s.RG32F||rt===s.RGBA16F||rt===s.RGBA32F)&&t.get("EXT_color_buffer_float"),rt}function b(N,T){let j;return N?T===null||T===ms||T===oo?j=s.DEPTH24_STENCIL8:T===Bi?j=s.DEPTH32F_STENCIL8:T===ma&&(j=s.DEPTH24_STENCIL8,Zt("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):T===null||T===ms||T===oo?j=s.DEPTH_COMPONENT24:T===Bi?j=s.DEPTH_COMPONENT32F:T===ma&&(j=s.DEPTH_COMPONENT16),j}function M(N,T){return v(N)===!0||N.isFramebufferTexture&&N.minFilter!==Zn&&N.minFilter!==jn?Math.log2(Math.max(T.width,T.height))+1:N.mipmaps.length>0?N.mipmaps.length:N.isCompressedTexture&&Array.isArray(N.image)?T.mipmaps.length:1}function I(N){let T=new WeakRef(N);n.get(N).__ref=T,g.add(T),y.register(N,T,T)}function P(N){let T=n.get(N).__ref;T!==void 0&&(g.delete(T),y.unregister(T))}function C(N){B(N.target)}function D(N){L(N.target)}function B(N){N.removeEventListener("dispose",C),P(N),O(N),N.isVideoTexture&&h.delete(N),N.isHTMLTexture&&u.delete(N)}function L(N){N.removeEventListener("dispose",D),P(N),tt(N)}function z(){for(let N of g){let T=N.deref();T!==void 0&&(T.isRenderTarget===!0?L(T):B(T))}g.clear(),u.clear()}function O(N){let T=n.get(N);if(T.__webglInit===void 0)return;let j=N.source,pt=f.get(j);if(pt){let ut=pt[T.__cacheKey];ut.usedTimes--,ut.usedTimes===0&&H(N),Object.keys(pt).length===0&&f.delete(j)}n.remove(N)}function H(N){let T=n.get(N);s.deleteTexture(T.__webglTexture);let j=N.source,pt=f.get(j);delete pt[T.__cacheKey],o.memory.textures--}function tt(N){let T=n.get(N);T.__depthDisposeCallback&&T.__depthDisposeCallback();let j=N.depthTexture;if(j&&j.renderTarget===N&&B(j),N.isWebGLCubeRenderTarget)for(let ut=0;ut<6;ut++){if(Array.isArray(T.__webglFramebuffer[ut]))for(let bt=0;bt<T.__webglFramebuffer[ut].length;bt++)s.deleteFramebuffer(T.__webglFramebuffer[ut][bt]);else s.deleteFramebuffer(T.__webglFramebuffer[ut]);T.__webglDepthbuffer&&s.deleteRenderbuffer(T.__webglDepthbuffer[ut])}else{if(Array.isArray(T.__webglFramebuffer))for(let ut=0;ut<T.__webglFramebuffer.length;ut++)s.deleteFramebuffer(T.__webglFramebuffer[ut]);else s.deleteFramebuffer(T.__webglFramebuffer);if(T.__webglDepthbuffer&&s.deleteRenderbuffer(T.__webglDepthbuffer),T.__webglMultisampledFramebuffer&&s.deleteFramebuffer(T.__webglMultisampledFramebuffer),T.__webglColorRenderbuffer)for(let ut=0;ut<T.__webglColorRenderbuffer.length;ut++)T.__webglColorRenderbuffer[ut]&&s.deleteRenderbuffer(T.__webglColorRenderbuffer[ut]);T.__webglDepthRenderbuffer&&s.deleteRenderbuffer(T.__webglDepthRenderbuffer)}let pt=N.textures;for(let ut=0,bt=pt.length;ut<bt;ut++){let vt=n.get(pt[ut]);vt.__webglTexture&&(s.deleteTexture(vt.__webglTexture),o.memory.textures--),n.remove(pt[ut])}n.remove(N)}let X=0;function Z(){X=0}function $(){return X}function at(N){X=N}function it(){let N=X;return N>=i.maxTextures&&Zt("WebGLTextures: Trying to use "+(N+1)+" texture units while this GPU supports only "+i.maxTextures),X+=1,N}function Y(N){let T=[];return T.push(N.wrapS),T.push(N.wrapT),T.push(N.wrapR||0),T.push(N.magFilter),T.push(N.minFilter),T.push(N.anisotropy),T.push(N.internalFormat),T.push(N.format),T.push(N.type),T.push(N.generateMipmaps),T.push(N.mipmapsAutoUpdate),T.push(N.premultiplyAlpha),T.push(N.flipY),T.push(N.unpackAlignment),T.push(N.colorSpace),T.join()}function st(N,T){let j=n.get(N);if(N.isVideoTexture&&We(N),N.isRenderTargetTexture===!1&&N.isExternalTexture!==!0&&N.version>0&&j.__version!==N.version){let pt=N.image;if(pt===null)Zt("WebGLRenderer: Texture marked for update but no image data found.");else if(pt.complete===!1)Zt("WebGLRenderer: Texture marked for update but image is incomplete");else{Ke(j,N,T);return}}else N.isExternalTexture&&(j.__webglTexture=N.sourceTexture?N.sourceTexture:null);e.bindTexture(s.TEXTURE_2D,j.__webglTexture,s.TEXTURE0+T)}function nt(N,T){let j=n.get(N);if(N.isRenderTargetTexture===!1&&N.version>0&&j.__version!==N.version){Ke(j,N,T);return}else N.isExternalTexture&&(j.__webglTexture=N.sourceTexture?N.sourceTexture:null);e.bindTexture(s.TEXTURE_2D_ARRAY,j.__webglTexture,s.TEXTURE0+T)}function lt(N,T){let j=n.get(N);if(N.isRenderTargetTexture===!1&&N.version>0&&j.__version!==N.version){Ke(j,N,T);return}e.bindTexture(s.TEXTURE_3D,j.__webglTexture,s.TEXTURE0+T)}function mt(N,T){let j=n.get(N);if(N.version>0&&j.__version!==N.version){En(j,N,T);return}e.bindTexture(s.TEXTURE_CUBE_MAP,j.__webglTexture,s.TEXTURE0+T)}let Ut={[ds]:s.REPEAT,[_i]:s.CLAMP_TO_EDGE,[lh]:s.MIRRORED_REPEAT},Jt={[Zn]:s.NEAREST,[d0]:s.NEAREST_MIPMAP_NEAREST,[Nl]:s.NEAREST_MIPMAP_LINEAR,[jn]:s.LINEAR,[Ch]:s.LINEAR_MIPMAP_NEAREST,[Ki]:s.LINEAR_MIPMAP_LINEAR},Ot={[x0]:s.NEVER,[cp]:s.ALWAYS,[_0]:s.LESS,[ap]:s.LEQUAL,[y0]:s.EQUAL,[lp]:s.GEQUAL,[b0]:s.GREATER,[v0]:s.NOTEQUAL};function me(N,T){if(T.type===Bi&&t.has("OES_texture_float_linear")===!1&&(T.magFilter===jn||T.magFilter===Ch||T.magFilter===Nl||T.magFilter===Ki||T.minFilter===jn||T.minFilter===Ch||T.minFilter===Nl||T.minFilter===Ki)&&Zt("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),s.texParameteri(N,s.TEXTURE_WRAP_S,Ut[T.wrapS]),s.texParameteri(N,s.TEXTURE_WRAP_T,Ut[T.wrapT]),(N===s.TEXTURE_3D||N===s.TEXTURE_2D_ARRAY)&&s.texParameteri(N,s.TEXTURE_WRAP_R,Ut[T.wrapR]),s.texParameteri(N,s.TEXTURE_MAG_FILTER,Jt[T.magFilter]),s.texParameteri(N,s.TEXTURE_MIN_FILTER,Jt[T.minFilter]),T.compareFunction&&(s.texParameteri(N,s.TEXTURE_COMPARE_MODE,s.COMPARE_REF_TO_TEXTURE),s.texParameteri(N,s.TEXTURE_COMPARE_FUNC,Ot[T.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(T.magFilter===Zn||T.minFilter!==Nl&&T.minFilter!==Ki||T.type===Bi&&t.has("OES_texture_float_linear")===!1)return;if(T.anisotropy>1||n.get(T).__currentAnisotropy){let j=t.get("EXT_texture_filter_anisotropic");s.texParameterf(N,j.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(T.anisotropy,i.getMaxAnisotropy())),n.get(T).__currentAnisotropy=T.anisotropy}}}function de(N,T){let j=!1;N.__webglInit===void 0&&(N.__webglInit=!0,T.addEventListener("dispose",C),I(T));let pt=T.source,ut=f.get(pt);ut===void 0&&(ut={},f.set(pt,ut));let bt=Y(T);if(bt!==N.__cacheKey){ut[bt]===void 0&&(ut[bt]={texture:s.createTexture(),usedTimes:0},o.memory.textures++,j=!0),ut[bt].usedTimes++;let vt=ut[N.__cacheKey];vt!==void 0&&(ut[N.__cacheKey].usedTimes--,vt.usedTimes===0&&H(T)),N.__cacheKey=bt,N.__webglTexture=ut[bt].texture}return j}function oe(N,T,j){return Math.floor(Math.floor(N/j)/T)}function an(N,T,j,pt){let bt=N.updateRanges;if(bt.length===0)e.texSubImage2D(s.TEXTURE_2D,0,0,0,T.width,T.height,j,pt,T.data);else{bt.sort((V,ht)=>V.start-ht.start);let vt=0;for(let V=1;V<bt.length;V++){let ht=bt[vt],ot=bt[V],Et=ht.start+ht.count,yt=oe(ot.start,T.width,4),St=oe(ht.start,T.width,4);ot.start<=Et+1&&yt===St&&oe(ot.start+ot.count-1,T.width,4)===yt?ht.count=Math.max(ht.count,ot.start+ot.count-ht.start):(++vt,bt[vt]=ot)}bt.length=vt+1;let rt=e.getParameter(s.UNPACK_ROW_LENGTH),ct=e.getParameter(s.UNPACK_SKIP_PIXELS),_t=e.getParameter(s.UNPACK_SKIP_ROWS);e.pixelStorei(s.UNPACK_ROW_LENGTH,T.width);for(let V=0,ht=bt.length;V<ht;V++){let ot=bt[V],Et=Math.floor(ot.start/4),yt=Math.ceil(ot.count/4),St=Et%T.width,Yt=Math.floor(Et/T.width),ee=yt,ft=1;e.pixelStorei(s.UNPACK_SKIP_PIXELS,St),e.pixelStorei(s.UNPACK_SKIP_ROWS,Yt),e.texSubImage2D(s.TEXTURE_2D,0,St,Yt,ee,ft,j,pt,T.data)}N.clearUpdateRanges(),e.pixelStorei(s.UNPACK_ROW_LENGTH,rt),e.pixelStorei(s.UNPACK_SKIP_PIXELS,ct),e.pixelStorei(s.UNPACK_SKIP_ROWS,_t)}}function Ke(N,T,j){let pt=s.TEXTURE_2D;(T.isDataArrayTexture||T.isCompressedArrayTexture)&&(pt=s.TEXTURE_2D_ARRAY),T.isData3DTexture&&(pt=s.TEXTURE_3D);let ut=de(N,T),bt=T.source;e.bindTexture(pt,N.__webglTexture,s.TEXTURE0+j);let vt=n.get(bt);if(bt.version!==vt.__version||ut===!0){if(e.activeTexture(s.TEXTURE0+j),(typeof ImageBitmap<"u"&&T.image instanceof ImageBitmap)===!1){let ft=he.getPrimaries(he.workingColorSpace),Bt=T.colorSpace===or?null:he.getPrimaries(T.colorSpace),ne=T.colorSpace===or||ft===Bt?s.NONE:s.BROWSER_DEFAULT_WEBGL;e.pixelStorei(s.UNPACK_FLIP_Y_WEBGL,T.flipY),e.pixelStorei(s.UNPACK_PREMULTIPLY_ALPHA_WEBGL,T.premultiplyAlpha),e.pixelStorei(s.UNPACK_COLORSPACE_CONVERSION_WEBGL,ne)}e.pixelStorei(s.UNPACK_ALIGNMENT,T.unpackAlignment);let ct=x(T.image,!1,i.maxTextureSize);ct=Wt(T,ct);let _t=r.convert(T.format,T.colorSpace),V=r.convert(T.type),ht=w(T.internalFormat,_t,V,T.normalized,T.colorSpace,T.isVideoTexture);me(pt,T);let ot,Et=T.mipmaps,yt=T.isVideoTexture!==!0,St=vt.__version===void 0||ut===!0,Yt=bt.dataReady,ee=M(T,ct);if(T.isDepthTexture)ht=b(T.format===rr,T.type),St&&(yt?e.texStorage2D(s.TEXTURE_2D,1,ht,ct.width,ct.height):e.texImage2D(s.TEXTURE_2D,0,ht,ct.width,ct.height,0,_t,V,null));else if(T.isDataTexture)if(Et.length>0){yt&&St&&e.texStorage2D(s.TEXTURE_2D,ee,ht,Et[0].width,Et[0].height);for(let ft=0,Bt=Et.length;ft<Bt;ft++)ot=Et[ft],yt?Yt&&e.texSubImage2D(s.TEXTURE_2D,ft,0,0,ot.width,ot.height,_t,V,ot.data):e.texImage2D(s.TEXTURE_2D,ft,ht,ot.width,ot.height,0,_t,V,ot.data);T.generateMipmaps=!1}else yt?(St&&e.texStorage2D(s.TEXTURE_2D,ee,ht,ct.width,ct.height),Yt&&an(T,ct,_t,V)):e.texImage2D(s.TEXTURE_2D,0,ht,ct.width,ct.height,0,_t,V,ct.data);else if(T.isCompressedTexture)if(T.isCompressedArrayTexture){yt&&St&&e.texStorage3D(s.TEXTURE_2D_ARRAY,ee,ht,Et[0].width,Et[0].height,ct.depth);for(let ft=0,Bt=Et.length;ft<Bt;ft++)if(ot=Et[ft],T.format!==Qi)if(_t!==null)if(yt){if(Yt)if(T.layerUpdates.size>0){let ne=_p(ot.width,ot.height,T.format,T.type);for(let Rt of T.layerUpdates){let ce=ot.data.subarray(Rt*ne/ot.data.BYTES_PER_ELEMENT,(Rt+1)*ne/ot.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(s.TEXTURE_2D_ARRAY,ft,0,0,Rt,ot.width,ot.height,1,_t,ce)}}else e.compressedTexSubImage3D(s.TEXTURE_2D_ARRAY,ft,0,0,0,ot.width,ot.height,ct.depth,_t,ot.data)}else e.compressedTexImage3D(s.TEXTURE_2D_ARRAY,ft,ht,ot.width,ot.height,ct.depth,0,ot.data,0,0);else Zt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else yt?Yt&&e.texSubImage3D(s.TEXTURE_2D_ARRAY,ft,0,0,0,ot.width,ot.height,ct.depth,_t,V,ot.data):e.texImage3D(s.TEXTURE_2D_ARRAY,ft,ht,ot.width,ot.height,ct.depth,0,_t,V,ot.data);T.layerUpdates.size>0&&T.clearLayerUpdates()}else{yt&&St&&e.texStorage2D(s.TEXTURE_2D,ee,ht,Et[0].width,Et[0].height);for(let ft=0,Bt=Et.length;ft<Bt;ft++)ot=Et[ft],T.format!==Qi?_t!==null?yt?Yt&&e.compressedTexSubImage2D(s.TEXTURE_2D,ft,0,0,ot.width,ot.height,_t,ot.data):e.compressedTexImage2D(s.TEXTURE_2D,ft,ht,ot.width,ot.height,0,ot.data):Zt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):yt?Yt&&e.texSubImage2D(s.TEXTURE_2D,ft,0,0,ot.width,ot.height,_t,V,ot.data):e.texImage2D(s.TEXTURE_2D,ft,ht,ot.width,ot.height,0,_t,V,ot.data)}else if(T.isDataArrayTexture)if(yt){if(St&&e.texStorage3D(s.TEXTURE_2D_ARRAY,ee,ht,ct.width,ct.height,ct.depth),Yt)if(T.layerUpdates.size>0){let ft=_p(ct.width,ct.height,T.format,T.type);for(let Bt of T.layerUpdates){let ne=ct.data.subarray(Bt*ft/ct.data.BYTES_PER_ELEMENT,(Bt+1)*ft/ct.data.BYTES_PER_ELEMENT);e.texSubImage3D(s.TEXTURE_2D_ARRAY,0,0,0,Bt,ct.width,ct.height,1,_t,V,ne)}T.clearLayerUpdates()}else e.texSubImage3D(s.TEXTURE_2D_ARRAY,0,0,0,0,ct.width,ct.height,ct.depth,_t,V,ct.data)}else e.texImage3D(s.TEXTURE_2D_ARRAY,0,ht,ct.width,ct.height,ct.depth,0,_t,V,ct.data);else if(T.isData3DTexture)yt?(St&&e.texStorage3D(s.TEXTURE_3D,ee,ht,ct.width,ct.height,ct.depth),Yt&&e.texSubImage3D(s.TEXTURE_3D,0,0,0,0,ct.width,ct.height,ct.depth,_t,V,ct.data)):e.texImage3D(s.TEXTURE_3D,0,ht,ct.width,ct.height,ct.depth,0,_t,V,ct.data);else if(T.isFramebufferTexture){if(St)if(yt)e.texStorage2D(s.TEXTURE_2D,ee,ht,ct.width,ct.height);else{let ft=ct.width,Bt=ct.height;for(let ne=0;ne<ee;ne++)e.texImage2D(s.TEXTURE_2D,ne,ht,ft,Bt,0,_t,V,null),ft>>=1,Bt>>=1}}else if(T.isHTMLTexture){if("texElementImage2D"in s){let ft=s.canvas;if(ft.hasAttribute("layoutsubtree")||ft.setAttribute("layoutsubtree","true"),ct.parentNode!==ft){ft.appendChild(ct),u.add(T),ft.onpaint=Bt=>{let ne=Bt.changedElements;for(let Rt of u)ne.includes(Rt.image)&&(Rt.needsUpdate=!0)},ft.requestPaint();return}if(s.texElementImage2D.length===3)s.texElementImage2D(s.TEXTURE_2D,s.RGBA8,ct);else{let ne=s.RGBA,Rt=s.RGBA,ce=s.UNSIGNED_BYTE;s.texElementImage2D(s.TEXTURE_2D,0,ne,Rt,ce,ct)}s.texParameteri(s.TEXTURE_2D,s.TEXTURE_MIN_FILTER,s.LINEAR),s.texParameteri(s.TEXTURE_2D,s.TEXTURE_WRAP_S,s.CLAMP_TO_EDGE),s.texParameteri(s.TEXTURE_2D,s.TEXTURE_WRAP_T,s.CLAMP_TO_EDGE)}}else if(Et.length>0){if(yt&&St){let ft=$t(Et[0]);e.texStorage2D(s.TEXTURE_2D,ee,ht,ft.width,ft.height)}for(let ft=0,Bt=Et.length;ft<Bt;ft++)ot=Et[ft],yt?Yt&&e.texSubImage2D(s.TEXTURE_2D,ft,0,0,_t,V,ot):e.texImage2D(s.TEXTURE_2D,ft,ht,_t,V,ot);T.generateMipmaps=!1}else if(yt){if(St){let ft=$t(ct);e.texStorage2D(s.TEXTURE_2D,ee,ht,ft.width,ft.height)}Yt&&e.texSubImage2D(s.TEXTURE_2D,0,0,0,_t,V,ct)}else e.texImage2D(s.TEXTURE_2D,0,ht,_t,V,ct);v(T)&&T.mipmapsAutoUpdate===!0&&_(pt),vt.__version=bt.version,T.onUpdate&&T.onUpdate(T)}N.__version=T.version}function En(N,T,j){if(T.image.length!==6)return;let pt=de(N,T),ut=T.source;e.bindTexture(s.TEXTURE_CUBE_MAP,N.__webglTexture,s.TEXTURE0+j);let bt=n.get(ut);if(ut.version!==bt.__version||pt===!0){e.activeTexture(s.TEXTURE0+j);let vt=he.getPrimaries(he.workingColorSpace),rt=T.colorSpace===or?null:he.getPrimaries(T.colorSpace),ct=T.colorSpace===or||vt===rt?s.NONE:s.BROWSER_DEFAULT_WEBGL;e.pixelStorei(s.UNPACK_FLIP_Y_WEBGL,T.flipY),e.pixelStorei(s.UNPACK_PREMULTIPLY_ALPHA_WEBGL,T.premultiplyAlpha),e.pixelStorei(s.UNPACK_ALIGNMENT,T.unpackAlignment),e.pixelStorei(s.UNPACK_COLORSPACE_CONVERSION_WEBGL,ct);let _t=T.isCompressedTexture||T.image[0].isCompressedTexture,V=T.image[0]&&T.image[0].isDataTexture,ht=[];for(let Rt=0;Rt<6;Rt++)!_t&&!V?ht[Rt]=x(T.image[Rt],!0,i.maxCubemapSize):ht[Rt]=V?T.image[Rt].image:T.image[Rt],ht[Rt]=Wt(T,ht[Rt]);let ot=ht[0],Et=r.convert(T.format,T.colorSpace),yt=r.convert(T.type),St=w(T.internalFormat,Et,yt,T.normalized,T.colorSpace),Yt=T.isVideoTexture!==!0,ee=bt.__version===void 0||pt===!0,ft=ut.dataReady,Bt=M(T,ot);me(s.TEXTURE_CUBE_MAP,T);let ne;if(T.isDepthTexture){if(St=b(T.format===rr,T.type),ee)if(Yt)e.texStorage2D(s.TEXTURE_CUBE_MAP,1,St,ot.width,ot.height);else for(let Rt=0;Rt<6;Rt++)e.texImage2D(s.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,0,St,ot.width,ot.height,0,Et,yt,null)}else if(_t){Yt&&ee&&e.texStorage2D(s.TEXTURE_CUBE_MAP,Bt,St,ot.width,ot.height);for(let Rt=0;Rt<6;Rt++){ne=ht[Rt].mipmaps;for(let ce=0;ce<ne.length;ce++){let tn=ne[ce];T.format!==Qi?Et!==null?Yt?ft&&e.compressedTexSubImage2D(s.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,ce,0,0,tn.width,tn.height,Et,tn.data):e.compressedTexImage2D(s.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,ce,St,tn.width,tn.height,0,tn.data):Zt("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Yt?ft&&e.texSubImage2D(s.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,ce,0,0,tn.width,tn.height,Et,yt,tn.data):e.texImage2D(s.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,ce,St,tn.width,tn.height,0,Et,yt,tn.data)}}}else{if(ne=T.mipmaps,Yt&&ee){ne.length>0&&Bt++;let Rt=$t(ht[0]);e.texStorage2D(s.TEXTURE_CUBE_MAP,Bt,St,Rt.width,Rt.height)}for(let Rt=0;Rt<6;Rt++)if(V){Yt?ft&&e.texSubImage2D(s.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,0,0,0,ht[Rt].width,ht[Rt].height,Et,yt,ht[Rt].data):e.texImage2D(s.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,0,St,ht[Rt].width,ht[Rt].height,0,Et,yt,ht[Rt].data);for(let ce=0;ce<ne.length;ce++){let di=ne[ce].image[Rt].image;Yt?ft&&e.texSubImage2D(s.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,ce+1,0,0,di.width,di.height,Et,yt,di.data):e.texImage2D(s.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,ce+1,St,di.width,di.height,0,Et,yt,di.data)}}else{Yt?ft&&e.texSubImage2D(s.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,0,0,0,Et,yt,ht[Rt]):e.texImage2D(s.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,0,St,Et,yt,ht[Rt]);for(let ce=0;ce<ne.length;ce++){let tn=ne[ce];Yt?ft&&e.texSubImage2D(s.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,ce+1,0,0,Et,yt,tn.image[Rt]):e.texImage2D(s.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,ce+1,St,Et,yt,tn.image[Rt])}}}v(T)&&T.mipmapsAutoUpdate===!0&&_(s.TEXTURE_CUBE_MAP),bt.__version=ut.version,T.onUpdate&&T.onUpdate(T)}N.__version=T.version}function Ve(N,T,j,pt,ut,bt){let vt=r.convert(j.format,j.colorSpace),rt=r.convert(j.type),ct=w(j.internalFormat,vt,rt,j.normalized,j.colorSpace),_t=n.get(T),V=n.get(j);if(V.__renderTarget=T,!_t.__hasExternalTextures){let ht=Math.max(1,T.width>>bt),ot=Math.max(1,T.height>>bt);ut===s.TEXTURE_3D||ut===s.TEXTURE_2D_ARRAY?e.texImage3D(ut,bt,ct,ht,ot,T.depth,0,vt,rt,null):e.texImage2D(ut,bt,ct,ht,ot,0,vt,rt,null)}e.bindFramebuffer(s.FRAMEBUFFER,N),Mt(T)?a.framebufferTexture2DMultisampleEXT(s.FRAMEBUFFER,pt,ut,V.__webglTexture,0,le(T)):(ut===s.TEXTURE_2D||ut>=s.TEXTURE_CUBE_MAP_POSITIVE_X&&ut<=s.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&s.framebufferTexture2D(s.FRAMEBUFFER,pt,ut,V.__webglTexture,bt),e.bindFramebuffer(s.FRAMEBUFFER,null)}function Vn(N,T,j){if(s.bindRenderbuffer(s.RENDERBUFFER,N),T.depthBuffer){let pt=T.depthTexture,ut=pt&&pt.isDepthTexture?pt.type:null,bt=b(T.stencilBuffer,ut),vt=T.stencilBuffer?s.DEPTH_STENCIL_ATTACHMENT:s.DEPTH_ATTACHMENT;Mt(T)?a.renderbufferStorageMultisampleEXT(s.RENDERBUFFER,le(T),bt,T.width,T.height):j?s.renderbufferStorageMultisample(s.RENDERBUFFER,le(T),bt,T.width,T.height):s.renderbufferStorage(s.RENDERBUFFER,bt,T.width,T.height),s.framebufferRenderbuffer(s.FRAMEBUFFER,vt,s.RENDERBUFFER,N)}else{let pt=T.textures;for(let ut=0;ut<pt.length;ut++){let bt=pt[ut],vt=r.convert(bt.format,bt.colorSpace),rt=r.convert(bt.type),ct=w(bt.internalFormat,vt,rt,bt.normalized,bt.colorSpace);Mt(T)?a.renderbufferStorageMultisampleEXT(s.RENDERBUFFER,le(T),ct,T.width,T.height):j?s.renderbufferStorageMultisample(s.RENDERBUFFER,le(T),ct,T.width,T.height):s.renderbufferStorage(s.RENDERBUFFER,ct,T.width,T.height)}}s.bindRenderbuffer(s.RENDERBUFFER,null)}function Ee(N,T,j){let pt=T.isWebGLCubeRenderTarget===!0;if(e.bindFramebuffer(s.FRAMEBUFFER,N),!(T.depthTexture&&T.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let ut=n.get(T.depthTexture);ut.__renderTarget=T;let bt=pt?T.depthTexture.image[0]:T.depthTexture.image;(!ut.__webglTexture||bt.width!==T.width||bt.height!==T.height)&&(bt.width=T.width,bt.height=T.height,T.depthTexture.needsUpdate=!0),pt?mt(T.depthTexture,0):st(T.depthTexture,0);let vt=ut.__webglTexture,rt=le(T),ct=pt?s.TEXTURE_CUBE_MAP_POSITIVE_X+j:s.TEXTURE_2D,_t=T.depthTexture.format===rr?s.DEPTH_STENCIL_ATTACHMENT:s.DEPTH_ATTACHMENT;if(T.depthTexture.format===$s)Mt(T)?a.framebufferTexture2DMultisampleEXT(s.FRAMEBUFFER,_t,ct,vt,0,rt):s.framebufferTexture2D(s.FRAMEBUFFER,_t,ct,vt,0);else if(T.depthTexture.format===rr)Mt(T)?a.framebufferTexture2DMultisampleEXT(s.FRAMEBUFFER,_t,ct,vt,0,rt):s.framebufferTexture2D(s.FRAMEBUFFER,_t,ct,vt,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function Dn(N){let T=n.get(N),j=N.isWebGLCubeRenderTarget===!0;if(T.__boundDepthTexture!==N.depthTexture){let pt=N.depthTexture;if(T.__depthDisposeCallback&&T.__depthDisposeCallback(),pt){let ut=()=>{delete T.__boundDepthTexture,delete T.__depthDisposeCallback,pt.removeEventListener("dispose",ut)};pt.addEventListener("dispose",ut),T.__depthDisposeCallback=ut}T.__boundDepthTexture=pt}if(N.depthTexture&&!T.__autoAllocateDepthBuffer)if(j)for(let pt=0;pt<6;pt++)Ee(T.__webglFramebuffer[pt],N,pt);else N.texture.mipmaps.length>0?Ee(T.__webglFramebuffer[0],N,0):Ee(T.__webglFramebuffer,N,0);else if(j){T.__webglDepthbuffer=[];for(let pt=0;pt<6;pt++)if(e.bindFramebuffer(s.FRAMEBUFFER,T.__webglFramebuffer[pt]),T.__webglDepthbuffer[pt]===void 0)T.__webglDepthbuffer[pt]=s.createRenderbuffer(),Vn(T.__webglDepthbuffer[pt],N,!1);else{let ut=N.stencilBuffer?s.DEPTH_STENCIL_ATTACHMENT:s.DEPTH_ATTACHMENT,bt=T.__webglDepthbuffer[pt];s.bindRenderbuffer(s.RENDERBUFFER,bt),s.framebufferRenderbuffer(s.FRAMEBUFFER,ut,s.RENDERBUFFER,bt)}}else if(N.texture.mipmaps.length>0?e.bindFramebuffer(s.FRAMEBUFFER,T.__webglFramebuffer[0]):e.bindFramebuffer(s.FRAMEBUFFER,T.__webglFramebuffer),T.__webglDepthbuffer===void 0)T.__webglDepthbuffer=s.createRenderbuffer(),Vn(T.__webglDepthbuffer,N,!1);else{let ut=N.stencilBuffer?s.DEPTH_STENCIL_ATTACHMENT:s.DEPTH_ATTACHMENT,bt=T.__webglDepthbuffer;s.bindRenderbuffer(s.RENDERBUFFER,bt),s.framebufferRenderbuffer(s.FRAMEBUFFER,ut,s.RENDERBUFFER,bt)}e.bindFramebuffer(s.FRAMEBUFFER,null)}function gn(N,T,j){let pt=n.get(N);T!==void 0&&Ve(pt.__webglFramebuffer,N,N.texture,s.COLOR_ATTACHMENT0,s.TEXTURE_2D,0),j!==void 0&&Dn(N)}function Tn(N){let T=N.texture,j=n.get(N),pt=n.get(T);N.addEventListener("dispose",D),I(N);let ut=N.textures,bt=N.isWebGLCubeRenderTarget===!0,vt=ut.length>1;if(vt||(pt.__webglTexture===void 0&&(pt.__webglTexture=s.createTexture()),pt.__version=T.version,o.memory.textures++),bt){j.__webglFramebuffer=[];for(let rt=0;rt<6;rt++)if(T.mipmaps.length>0){j.__webglFramebuffer[rt]=[];for(let ct=0;ct<T.mipmaps.length;ct++)j.__webglFramebuffer[rt][ct]=s.createFramebuffer()}else j.__webglFramebuffer[rt]=s.createFramebuffer()}else{if(T.mipmaps.length>0){j.__webglFramebuffer=[];for(let rt=0;rt<T.mipmaps.length;rt++)j.__webglFramebuffer[rt]=s.createFramebuffer()}else j.__webglFramebuffer=s.createFramebuffer();if(vt)for(let rt=0,ct=ut.length;rt<ct;rt++){let _t=n.get(ut[rt]);_t.__webglTexture===void 0&&(_t.__webglTexture=s.createTexture(),o.memory.textures++)}if(N.samples>0&&Mt(N)===!1){j.__webglMultisampledFramebuffer=s.createFramebuffer(),j.__webglColorRenderbuffer=[],e.bindFramebuffer(s.FRAMEBUFFER,j.__webglMultisampledFramebuffer);for(let rt=0;rt<ut.length;rt++){let ct=ut[rt];j.__webglColorRenderbuffer[rt]=s.createRenderbuffer(),s.bindRenderbuffer(s.RENDERBUFFER,j.__webglColorRenderbuffer[rt]);let _t=r.convert(ct.format,ct.colorSpace),V=r.convert(ct.type),ht=w(ct.internalFormat,_t,V,ct.normalized,ct.colorSpace,N.isXRRenderTarget===!0),ot=le(N);s.renderbufferStorageMultisample(s.RENDERBUFFER,ot,ht,N.width,N.height),s.framebufferRenderbuffer(s.FRAMEBUFFER,s.COLOR_ATTACHMENT0+rt,s.RENDERBUFFER,j.__webglColorRenderbuffer[rt])}s.bindRenderbuffer(s.RENDERBUFFER,null),N.depthBuffer&&(j.__webglDepthRenderbuffer=s.createRenderbuffer(),Vn(j.__webglDepthRenderbuffer,N,!0)),e.bindFramebuffer(s.FRAMEBUFFER,null)}}if(bt){e.bindTexture(s.TEXTURE_CUBE_MAP,pt.__webglTexture),me(s.TEXTURE_CUBE_MAP,T);for(let rt=0;rt<6;rt++)if(T.mipmaps.length>0)for(let ct=0;ct<T.mipmaps.length;ct++)Ve(j.__webglFramebuffer[rt][ct],N,T,s.COLOR_ATTACHMENT0,s.TEXTURE_CUBE_MAP_POSITIVE_X+rt,ct);else Ve(j.__webglFramebuffer[rt],N,T,s.COLOR_ATTACHMENT0,s.TEXTURE_CUBE_MAP_POSITIVE_X+rt,0);v(T)?_(s.TEXTURE_CUBE_MAP):T.mipmaps.length>0&&s.texParameteri(s.TEXTURE_CUBE_MAP,s.TEXTURE_MAX_LEVEL,T.mipmaps.length-1),e.unbindTexture()}else if(vt){for(let rt=0,ct=ut.length;rt<ct;rt++){let _t=ut[rt],V=n.get(_t),ht=s.TEXTURE_2D;(N.isWebGL3DRenderTarget||N.isWebGLArrayRenderTarget)&&(ht=N.isWebGL3DRenderTarget?s.TEXTURE_3D:s.TEXTURE_2D_ARRAY),e.bindTexture(ht,V.__webglTexture),me(ht,_t),Ve(j.__webglFramebuffer,N,_t,s.COLOR_ATTACHMENT0+rt,ht,0),v(_t)&&_(ht)}e.unbindTexture()}else{let rt=s.TEXTURE_2D;if((N.isWebGL3DRenderTarget||N.isWebGLArrayRenderTarget)&&(rt=N.isWebGL3DRenderTarget?s.TEXTURE_3D:s.TEXTURE_2D_ARRAY),e.bindTexture(rt,pt.__webglTexture),me(rt,T),T.mipmaps.length>0)for(let ct=0;ct<T.mipmaps.length;ct++)Ve(j.__webglFramebuffer[ct],N,T,s.COLOR_ATTACHMENT0,rt,ct);else Ve(j.__webglFramebuffer,N,T,s.COLOR_ATTACHMENT0,rt,0);v(T)?_(rt):T.mipmaps.length>0&&s.texParameteri(rt,s.TEXTURE_MAX_LEVEL,T.mipmaps.length-1),e.unbindTexture()}N.depthBuffer&&Dn(N)}function G(N){let T=N.textures;for(let j=0,pt=T.length;j<pt;j++){let ut=T[j];if(v(ut)&&ut.mipmapsAutoUpdate===!0){let bt=E(N),vt=n.get(ut).__webglTexture;e.bindTexture(bt,vt),_(bt),e.unbindTexture()}}}let Ct=[];function Kt(N){if(N.samples>0){if(Mt(N)===!1){let T=N.textures,j=N.width,pt=N.height,ut=s.COLOR_BUFFER_BIT,bt=N.stencilBuffer?s.DEPTH_STENCIL_ATTACHMENT:s.DEPTH_ATTACHMENT,vt=n.get(N),rt=T.length>1;if(rt)for(let _t=0;_t<T.length;_t++)e.bindFramebuffer(s.FRAMEBUFFER,vt.__webglMultisampledFramebuffer),s.framebufferRenderbuffer(s.FRAMEBUFFER,s.COLOR_ATTACHMENT0+_t,s.RENDERBUFFER,null),e.bindFramebuffer(s.FRAMEBUFFER,vt.__webglFramebuffer),s.framebufferTexture2D(s.DRAW_FRAMEBUFFER,s.COLOR_ATTACHMENT0+_t,s.TEXTURE_2D,null,0);e.bindFramebuffer(s.READ_FRAMEBUFFER,vt.__webglMultisampledFramebuffer),N.texture.mipmaps.length>0?e.bindFramebuffer(s.DRAW_FRAMEBUFFER,vt.__webglFramebuffer[0]):e.bindFramebuffer(s.DRAW_FRAMEBUFFER,vt.__webglFramebuffer);for(let _t=0;_t<T.length;_t++){if(N.resolveDepthBuffer&&(N.depthBuffer&&(ut|=s.DEPTH_BUFFER_BIT),N.stencilBuffer&&N.resolveStencilBuffer&&(ut|=s.STENCIL_BUFFER_BIT)),rt){s.framebufferRenderbuffer(s.READ_FRAMEBUFFER,s.COLOR_ATTACHMENT0,s.RENDERBUFFER,vt.__webglColorRenderbuffer[_t]);let V=n.get(T[_t]).__webglTexture;s.framebufferTexture2D(s.DRAW_FRAMEBUFFER,s.COLOR_ATTACHMENT0,s.TEXTURE_2D,V,0)}s.blitFramebuffer(0,0,j,pt,0,0,j,pt,ut,s.NEAREST),c===!0&&(Ct.length=0,Ct.push(s.COLOR_ATTACHMENT0+_t),N.depthBuffer&&N.storeMultisampledDepthBuffer===!1&&Ct.push(bt),s.invalidateFramebuffer(s.READ_FRAMEBUFFER,Ct))}if(e.bindFramebuffer(s.READ_FRAMEBUFFER,null),e.bindFramebuffer(s.DRAW_FRAMEBUFFER,null),rt)for(let _t=0;_t<T.length;_t++){e.bindFramebuffer(s.FRAMEBUFFER,vt.__webglMultisampledFramebuffer),s.framebufferRenderbuffer(s.FRAMEBUFFER,s.COLOR_ATTACHMENT0+_t,s.RENDERBUFFER,vt.__webglColorRenderbuffer[_t]);let V=n.get(T[_t]).__webglTexture;e.bindFramebuffer(s.FRAMEBUFFER,vt.__webglFramebuffer),s.framebufferTexture2D(s.DRAW_FRAMEBUFFER,s.COLOR_ATTACHMENT0+_t,s.TEXTURE_2D,V,0)}e.bindFramebuffer(s.DRAW_FRAMEBUFFER,vt.__webglMultisampledFramebuffer)}else if(N.depthBuffer&&N.storeMultisampledDepthBuffer===!1&&c){let T=N.stencilBuffer?s.DEPTH_STENCIL_ATTACHMENT:s.DEPTH_ATTACHMENT;s.invalidateFramebuffer(s.DRAW_FRAMEBUFFER,[T])}}}function le(N){return Math.min(i.maxSamples,N.samples)}function Mt(N){let T=n.get(N);return N.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&T.__useRenderToTexture!==!1}function We(N){let T=o.render.frame;h.get(N)!==T&&(h.set(N,T),N.update())}function Wt(N,T){let j=N.colorSpace,pt=N.format,ut=N.type;return N.isCompressedTexture===!0||N.isVideoTexture===!0||j!==rl&&j!==or&&(he.getTransfer(j)===Ne?(pt!==Qi||ut!==Ri)&&Zt("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):te("WebGLTextures: Unsupported texture color space:",j)),T}function $t(N){return typeof HTMLImageElement<"u"&&N instanceof HTMLImageElement?(l.width=N.naturalWidth||N.width,l.height=N.naturalHeight||N.height):typeof VideoFrame<"u"&&N instanceof VideoFrame?(l.width=N.displayWidth,l.height=N.displayHeight):(l.width=N.width,l.height=N.height),l}this.allocateTextureUnit=it,this.resetTextureUnits=Z,this.getTextureUnits=$,this.setTextureUnits=at,this.setTexture2D=st,this.setTexture2DArray=nt,this.setTexture3D=lt,this.setTextureCube=mt,this.rebindTextures=gn,this.setupRenderTarget=Tn,this.updateRenderTargetMipmap=G,this.updateMultisampleRenderTarget=Kt,this.setupDepthRenderbuffer=Dn,this.setupFrameBufferTexture=Ve,this.useMultisampledRTT=Mt,this.dispose=z}function cE(s,t){function e(n,i=or){let r,o=he.getTransfer(i);if(n===Ri)return s.UNSIGNED_BYTE;if(n===Ih)return s.UNSIGNED_SHORT_4_4_4_4;if(n===Lh)return s.UNSIGNED_SHORT_5_5_5_1;if(n===ip)return s.UNSIGNED_INT_5_9_9_9_REV;if(n===sp)return s.UNSIGNED_INT_10F_11F_11F_REV;if(n===ep)return s.BYTE;if(n===np)return s.SHORT;if(n===ma)return s.UNSIGNED_SHORT;if(n===Ph)return s.INT;if(n===ms)return s.UNSIGNED_INT;if(n===Bi)return s.FLOAT;if(n===gs)return s.HALF_FLOAT;if(n===rp)return s.ALPHA;if(n===op)return s.RGB;if(n===Qi)return s.RGBA;if(n===$s)return s.DEPTH_COMPONENT;if(n===rr)return s.DEPTH_STENCIL;if(n===Nh)return s.RED;if(n===Dh)return s.RED_INTEGER;if(n===Ir)return s.RG;if(n===Uh)return s.RG_INTEGER;if(n===Fh)return s.RGBA_INTEGER;if(n===Dl||n===Ul||n===Fl||n===kl)if(o===Ne)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===Dl)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===Ul)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===Fl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===kl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===Dl)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===Ul)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===Fl)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===kl)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===kh||n===Oh||n===Bh||n===zh)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===kh)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===Oh)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===Bh)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===zh)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===Hh||n===Vh||n===Gh||n===Wh||n===Xh||n===Ol||n===qh)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(n===Hh||n===Vh)return o===Ne?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===Gh)return o===Ne?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(n===Wh)return r.COMPRESSED_R11_EAC;if(n===Xh)return r.COMPRESSED_SIGNED_R11_EAC;if(n===Ol)return r.COMPRESSED_RG11_EAC;if(n===qh)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===Yh||n===jh||n===Zh||n===$h||n===Jh||n===Kh||n===Qh||n===tu||n===eu||n===nu||n===iu||n===su||n===ru||n===ou)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(n===Yh)return o===Ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===jh)return o===Ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===Zh)return o===Ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===$h)return o===Ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===Jh)return o===Ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===Kh)return o===Ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===Qh)return o===Ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===tu)return o===Ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===eu)return o===Ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===nu)return o===Ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===iu)return o===Ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===su)return o===Ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===ru)return o===Ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===ou)return o===Ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===au||n===lu||n===cu)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(n===au)return o===Ne?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===lu)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===cu)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===hu||n===uu||n===Bl||n===du)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(n===hu)return r.COMPRESSED_RED_RGTC1_EXT;if(n===uu)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===Bl)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===du)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===oo?s.UNSIGNED_INT_24_8:s[n]!==void 0?s[n]:null}return{convert:e}}var hE=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,uE=`
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

}`,Ap=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let n=new gl(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=n}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,n=new Zi({vertexShader:hE,fragmentShader:uE,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new gt(new Qs(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Rp=class extends fs{constructor(t,e){super();let n=this,i=null,r=1,o=null,a="local-floor",c=1,l=null,h=null,u=null,d=null,f=null,g=null,y=typeof XRWebGLBinding<"u",p=new Ap,m={},x=e.getContextAttributes(),v=null,_=null,E=[],w=[],b=new Vt,M=null,I=null,P=new vn;P.viewport=new ze;let C=new vn;C.viewport=new ze;let D=[P,C],B=new Th,L=null,z=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(Y){let st=E[Y];return st===void 0&&(st=new ta,E[Y]=st),st.getTargetRaySpace()},this.getControllerGrip=function(Y){let st=E[Y];return st===void 0&&(st=new ta,E[Y]=st),st.getGripSpace()},this.getHand=function(Y){let st=E[Y];return st===void 0&&(st=new ta,E[Y]=st),st.getHandSpace()};function O(Y){let st=w.indexOf(Y.inputSource);if(st===-1)return;let nt=E[st];nt!==void 0&&(nt.update(Y.inputSource,Y.frame,l||o),nt.dispatchEvent({type:Y.type,data:Y.inputSource}))}function H(){i.removeEventListener("select",O),i.removeEventListener("selectstart",O),i.removeEventListener("selectend",O),i.removeEventListener("squeeze",O),i.removeEventListener("squeezestart",O),i.removeEventListener("squeezeend",O),i.removeEventListener("end",H),i.removeEventListener("inputsourceschange",tt);for(let Y=0;Y<E.length;Y++){let st=w[Y];st!==null&&(w[Y]=null,E[Y].disconnect(st))}L=null,z=null,p.reset();for(let Y in m)delete m[Y];if(t.setRenderTarget(v),f=null,d=null,u=null,i=null,_=null,it.stop(),n.isPresenting=!1,t.setPixelRatio(M),t.setSize(b.width,b.height,!1),I!==null){let Y=I.camera;Y.fov=I.fov,Y.zoom=I.zoom,Y.updateProjectionMatrix(),I=null}n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(Y){r=Y,n.isPresenting===!0&&Zt("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(Y){a=Y,n.isPresenting===!0&&Zt("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return l||o},this.setReferenceSpace=function(Y){l=Y},this.getBaseLayer=function(){return d!==null?d:f},this.getBinding=function(){return u===null&&y&&(u=new XRWebGLBinding(i,e)),u},this.getFrame=function(){return g},this.getSession=function(){return i},this.setSession=async function(Y){if(i=Y,i!==null){if(v=t.getRenderTarget(),i.addEventListener("select",O),i.addEventListener("selectstart",O),i.addEventListener("selectend",O),i.addEventListener("squeeze",O),i.addEventListener("squeezestart",O),i.addEventListener("squeezeend",O),i.addEventListener("end",H),i.addEventListener("inputsourceschange",tt),x.xrCompatible!==!0&&await e.makeXRCompatible(),M=t.getPixelRatio(),t.getSize(b),y&&"createProjectionLayer"in XRWebGLBinding.prototype){let nt=null,lt=null,mt=null;x.depth&&(mt=x.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,nt=x.stencil?rr:$s,lt=x.stencil?oo:ms);let Ut={colorFormat:e.RGBA8,depthFormat:mt,scaleFactor:r};u=this.getBinding(),d=u.createProjectionLayer(Ut),i.updateRenderState({layers:[d]}),t.setPixelRatio(1),t.setSize(d.textureWidth,d.textureHeight,!1),_=new ki(d.textureWidth,d.textureHeight,{format:Qi,type:Ri,depthTexture:new Ks(d.textureWidth,d.textureHeight,lt,void 0,void 0,void 0,void 0,void 0,void 0,nt),stencilBuffer:x.stencil,colorSpace:t.outputColorSpace,samples:x.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{let nt={antialias:x.antialias,alpha:!0,depth:x.depth,stencil:x.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(i,e,nt),i.updateRenderState({baseLayer:f}),t.setPixelRatio(1),t.setSize(f.framebufferWidth,f.framebufferHeight,!1),_=new ki(f.framebufferWidth,f.framebufferHeight,{format:Qi,type:Ri,colorSpace:t.outputColorSpace,stencilBuffer:x.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}_.isXRRenderTarget=!0,this.setFoveation(c),l=null,o=await i.requestReferenceSpace(a),it.setContext(i),it.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(i!==null)return i.environmentBlendMode},this.getDepthTexture=function(){return p.getDepthTexture()};function tt(Y){for(let st=0;st<Y.removed.length;st++){let nt=Y.removed[st],lt=w.indexOf(nt);lt>=0&&(w[lt]=null,E[lt].disconnect(nt))}for(let st=0;st<Y.added.length;st++){let nt=Y.added[st],lt=w.indexOf(nt);if(lt===-1){for(let Ut=0;Ut<E.length;Ut++)if(Ut>=w.length){w.push(nt),lt=Ut;break}else if(w[Ut]===null){w[Ut]=nt,lt=Ut;break}if(lt===-1)break}let mt=E[lt];mt&&mt.connect(nt)}}function X(Y,st){st===null?Y.matrixWorld.copy(Y.matrix):Y.matrixWorld.multiplyMatrices(st.matrixWorld,Y.matrix),Y.matrixWorldInverse.copy(Y.matrixWorld).invert()}this.updateCamera=function(Y){if(i===null)return;let st=Y.near,nt=Y.far;p.texture!==null&&(p.depthNear>0&&(st=p.depthNear),p.depthFar>0&&(nt=p.depthFar)),B.near=C.near=P.near=st,B.far=C.far=P.far=nt,(L!==B.near||z!==B.far)&&(i.updateRenderState({depthNear:B.near,depthFar:B.far}),L=B.near,z=B.far),B.layers.mask=Y.layers.mask|6,P.layers.mask=B.layers.mask&-5,C.layers.mask=B.layers.mask&-3;let lt=Y.parent,mt=B.cameras;X(B,lt);for(let Ut=0;Ut<mt.length;Ut++)X(mt[Ut],lt);B.projectionMatrix.copy(P.projectionMatrix),B.projectionMatrixInverse.copy(P.projectionMatrixInverse),I===null&&Y.isPerspectiveCamera&&(I={camera:Y,fov:Y.fov,zoom:Y.zoom}),Z(Y,B,lt)};function Z(Y,st,nt){nt===null?Y.matrix.copy(st.matrixWorld):(Y.matrix.copy(nt.matrixWorld),Y.matrix.invert(),Y.matrix.multiply(st.matrixWorld)),Y.matrix.decompose(Y.position,Y.quaternion,Y.scale),Y.updateMatrixWorld(!0),Y.projectionMatrix.copy(st.projectionMatrix),Y.projectionMatrixInverse.copy(st.projectionMatrixInverse),Y.isPerspectiveCamera&&(Y.fov=qr*2*Math.atan(1/Y.projectionMatrix.elements[5]),Y.zoom=1)}this.getCamera=function(){return B},this.getFoveation=function(){if(!(d===null&&f===null))return c},this.setFoveation=function(Y){c=Y,d!==null&&(d.fixedFoveation=Y),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=Y)},this.hasDepthSensing=function(){return p.texture!==null},this.getDepthSensingMesh=function(){return p.getMesh(B)},this.getCameraTexture=function(Y){return m[Y]};let $=null;function at(Y,st){if(h=st.getViewerPose(l||o),g=st,h!==null){let nt=h.views;f!==null&&(t.setRenderTargetFramebuffer(_,f.framebuffer),t.setRenderTarget(_));let lt=!1;nt.length!==B.cameras.length&&(B.cameras.length=0,lt=!0);for(let Ot=0;Ot<nt.length;Ot++){let me=nt[Ot],de=null;if(f!==null)de=f.getViewport(me);else{let an=u.getViewSubImage(d,me);de=an.viewport,Ot===0&&(t.setRenderTargetTextures(_,an.colorTexture,an.depthStencilTexture),t.setRenderTarget(_))}let oe=D[Ot];oe===void 0&&(oe=new vn,oe.layers.enable(Ot),oe.viewport=new ze,D[Ot]=oe),oe.matrix.fromArray(me.transform.matrix),oe.matrix.decompose(oe.position,oe.quaternion,oe.scale),oe.projectionMatrix.fromArray(me.projectionMatrix),oe.projectionMatrixInverse.copy(oe.projectionMatrix).invert(),oe.viewport.set(de.x,de.y,de.width,de.height),Ot===0&&(B.matrix.copy(oe.matrix),B.matrix.decompose(B.position,B.quaternion,B.scale)),lt===!0&&B.cameras.push(oe)}let mt=i.enabledFeatures;if(mt&&mt.includes("depth-sensing")&&i.depthUsage=="gpu-optimized"&&y){u=n.getBinding();let Ot=u.getDepthInformation(nt[0]);Ot&&Ot.isValid&&Ot.texture&&p.init(Ot,i.renderState)}if(mt&&mt.includes("camera-access")&&y){t.state.unbindTexture(),u=n.getBinding();for(let Ot=0;Ot<nt.length;Ot++){let me=nt[Ot].camera;if(me){let de=m[me];de||(de=new gl,m[me]=de);let oe=u.getCameraImage(me);de.sourceTexture=oe}}}}for(let nt=0;nt<E.length;nt++){let lt=w[nt],mt=E[nt];lt!==null&&mt!==void 0&&mt.update(lt,st,l||o)}$&&$(Y,st),st.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:st}),g=null}let it=new ix;it.setAnimationLoop(at),this.setAnimationLoop=function(Y){$=Y},this.dispose=function(){}}},dE=new Gt,fx=new ie;fx.set(-1,0,0,0,1,0,0,0,1);function fE(s,t){function e(p,m){p.matrixAutoUpdate===!0&&p.updateMatrix(),m.value.copy(p.matrix)}function n(p,m){m.color.getRGB(p.fogColor.value,mp(s)),m.isFog?(p.fogNear.value=m.near,p.fogFar.value=m.far):m.isFogExp2&&(p.fogDensity.value=m.density)}function i(p,m,x,v,_){m.isNodeMaterial?m.uniformsNeedUpdate=!1:m.isMeshBasicMaterial?r(p,m):m.isMeshLambertMaterial?(r(p,m),m.envMap&&(p.envMapIntensity.value=m.envMapIntensity)):m.isMeshToonMaterial?(r(p,m),u(p,m)):m.isMeshPhongMaterial?(r(p,m),h(p,m),m.envMap&&(p.envMapIntensity.value=m.envMapIntensity)):m.isMeshStandardMaterial?(r(p,m),d(p,m),m.isMeshPhysicalMaterial&&f(p,m,_)):m.isMeshMatcapMaterial?(r(p,m),g(p,m)):m.isMeshDepthMaterial?r(p,m):m.isMeshDistanceMaterial?(r(p,m),y(p,m)):m.isMeshNormalMaterial?r(p,m):m.isLineBasicMaterial?(o(p,m),m.isLineDashedMaterial&&a(p,m)):m.isPointsMaterial?c(p,m,x,v):m.isSpriteMaterial?l(p,m):m.isShadowMaterial?(p.color.value.copy(m.color),p.opacity.value=m.opacity):m.isShaderMaterial&&(m.uniformsNeedUpdate=!1)}function r(p,m){p.opacity.value=m.opacity,m.color&&p.diffuse.value.copy(m.color),m.emissive&&p.emissive.value.copy(m.emissive).multiplyScalar(m.emissiveIntensity),m.map&&(p.map.value=m.map,e(m.map,p.mapTransform)),m.alphaMap&&(p.alphaMap.value=m.alphaMap,e(m.alphaMap,p.alphaMapTransform)),m.bumpMap&&(p.bumpMap.value=m.bumpMap,e(m.bumpMap,p.bumpMapTransform),p.bumpScale.value=m.bumpScale,m.side===bi&&(p.bumpScale.value*=-1)),m.normalMap&&(p.normalMap.value=m.normalMap,e(m.normalMap,p.normalMapTransform),p.normalScale.value.copy(m.normalScale),m.side===bi&&p.normalScale.value.negate()),m.displacementMap&&(p.displacementMap.value=m.displacementMap,e(m.displacementMap,p.displacementMapTransform),p.displacementScale.value=m.displacementScale,p.displacementBias.value=m.displacementBias),m.emissiveMap&&(p.emissiveMap.value=m.emissiveMap,e(m.emissiveMap,p.emissiveMapTransform)),m.specularMap&&(p.specularMap.value=m.specularMap,e(m.specularMap,p.specularMapTransform)),m.alphaTest>0&&(p.alphaTest.value=m.alphaTest);let x=t.get(m),v=x.envMap,_=x.envMapRotation;v&&(p.envMap.value=v,p.envMapRotation.value.setFromMatrix4(dE.makeRotationFromEuler(_)).transpose(),v.isCubeTexture&&v.isRenderTargetTexture===!1&&p.envMapRotation.value.premultiply(fx),p.reflectivity.value=m.reflectivity,p.ior.value=m.ior,p.refractionRatio.value=m.refractionRatio),m.lightMap&&(p.lightMap.value=m.lightMap,p.lightMapIntensity.value=m.lightMapIntensity,e(m.lightMap,p.lightMapTransform)),m.aoMap&&(p.aoMap.value=m.aoMap,p.aoMapIntensity.value=m.aoMapIntensity,e(m.aoMap,p.aoMapTransform))}function o(p,m){p.diffuse.value.copy(m.color),p.opacity.value=m.opacity,m.map&&(p.map.value=m.map,e(m.map,p.mapTransform))}function a(p,m){p.dashSize.value=m.dashSize,p.totalSize.value=m.dashSize+m.gapSize,p.scale.value=m.scale}function c(p,m,x,v){p.diffuse.value.copy(m.color),p.opacity.value=m.opacity,p.size.value=m.size*x,p.scale.value=v*.5,m.map&&(p.map.value=m.map,e(m.map,p.uvTransform)),m.alphaMap&&(p.alphaMap.value=m.alphaMap,e(m.alphaMap,p.alphaMapTransform)),m.alphaTest>0&&(p.alphaTest.value=m.alphaTest)}function l(p,m){p.diffuse.value.copy(m.color),p.opacity.value=m.opacity,p.rotation.value=m.rotation,m.map&&(p.map.value=m.map,e(m.map,p.mapTransform)),m.alphaMap&&(p.alphaMap.value=m.alphaMap,e(m.alphaMap,p.alphaMapTransform)),m.alphaTest>0&&(p.alphaTest.value=m.alphaTest)}function h(p,m){p.specular.value.copy(m.specular),p.shininess.value=Math.max(m.shininess,1e-4)}function u(p,m){m.gradientMap&&(p.gradientMap.value=m.gradientMap)}function d(p,m){p.metalness.value=m.metalness,m.metalnessMap&&(p.metalnessMap.value=m.metalnessMap,e(m.metalnessMap,p.metalnessMapTransform)),p.roughness.value=m.roughness,m.roughnessMap&&(p.roughnessMap.value=m.roughnessMap,e(m.roughnessMap,p.roughnessMapTransform)),m.envMap&&(p.envMapIntensity.value=m.envMapIntensity)}function f(p,m,x){p.ior.value=m.ior,m.diffuseRoughness>0&&(p.diffuseRoughness.value=m.diffuseRoughness,m.diffuseRoughnessMap&&(p.diffuseRoughnessMap.value=m.diffuseRoughnessMap,e(m.diffuseRoughnessMap,p.diffuseRoughnessMapTransform))),m.sheen>0&&(p.sheenColor.value.copy(m.sheenColor).multiplyScalar(m.sheen),p.sheenRoughness.value=m.sheenRoughness,m.sheenColorMap&&(p.sheenColorMap.value=m.sheenColorMap,e(m.sheenColorMap,p.sheenColorMapTransform)),m.sheenRoughnessMap&&(p.sheenRoughnessMap.value=m.sheenRoughnessMap,e(m.sheenRoughnessMap,p.sheenRoughnessMapTransform))),m.clearcoat>0&&(p.clearcoat.value=m.clearcoat,p.clearcoatRoughness.value=m.clearcoatRoughness,m.clearcoatMap&&(p.clearcoatMap.value=m.clearcoatMap,e(m.clearcoatMap,p.clearcoatMapTransform)),m.clearcoatRoughnessMap&&(p.clearcoatRoughnessMap.value=m.clearcoatRoughnessMap,e(m.clearcoatRoughnessMap,p.clearcoatRoughnessMapTransform)),m.clearcoatNormalMap&&(p.clearcoatNormalMap.value=m.clearcoatNormalMap,e(m.clearcoatNormalMap,p.clearcoatNormalMapTransform),p.clearcoatNormalScale.value.copy(m.clearcoatNormalScale),m.side===bi&&p.clearcoatNormalScale.value.negate())),m.dispersion>0&&(p.dispersion.value=m.dispersion),m.retroreflectivity>0&&(p.retroreflectivity.value=m.retroreflectivity),m.iridescence>0&&(p.iridescence.value=m.iridescence,p.iridescenceIOR.value=m.iridescenceIOR,p.iridescenceThicknessMinimum.value=m.iridescenceThicknessMinimum,p.iridescenceThicknessMaximum.value=m.iridescenceThicknessMaximum,m.iridescenceMap&&(p.iridescenceMap.value=m.iridescenceMap,e(m.iridescenceMap,p.iridescenceMapTransform)),m.iridescenceThicknessMap&&(p.iridescenceThicknessMap.value=m.iridescenceThicknessMap,e(m.iridescenceThicknessMap,p.iridescenceThicknessMapTransform))),m.transmission>0&&(p.transmission.value=m.transmission,p.transmissionSamplerMap.value=x.texture,p.transmissionSamplerSize.value.set(x.width,x.height),m.transmissionMap&&(p.transmissionMap.value=m.transmissionMap,e(m.transmissionMap,p.transmissionMapTransform)),p.thickness.value=m.thickness,m.thicknessMap&&(p.thicknessMap.value=m.thicknessMap,e(m.thicknessMap,p.thicknessMapTransform)),p.attenuationDistance.value=m.attenuationDistance,p.attenuationColor.value.copy(m.attenuationColor)),m.anisotropy>0&&(p.anisotropyVector.value.set(m.anisotropy*Math.cos(m.anisotropyRotation),m.anisotropy*Math.sin(m.anisotropyRotation)),m.anisotropyMap&&(p.anisotropyMap.value=m.anisotropyMap,e(m.anisotropyMap,p.anisotropyMapTransform))),p.specularIntensity.value=m.specularIntensity,p.specularColor.value.copy(m.specularColor),m.specularColorMap&&(p.specularColorMap.value=m.specularColorMap,e(m.specularColorMap,p.specularColorMapTransform)),m.specularIntensityMap&&(p.specularIntensityMap.value=m.specularIntensityMap,e(m.specularIntensityMap,p.specularIntensityMapTransform))}function g(p,m){m.matcap&&(p.matcap.value=m.matcap)}function y(p,m){let x=t.get(m).light;p.referencePosition.value.setFromMatrixPosition(x.matrixWorld),p.nearDistance.value=x.shadow.camera.near,p.farDistance.value=x.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:i}}function pE(s,t,e,n){let i={},r={};function o(x,v){let _=v.program;n.uniformBlockBinding(x,_,i[x.id])}function a(x,v){let _=i[x.id];_===void 0&&(g(x),_=c(x),i[x.id]=_,x.addEventListener("dispose",p));let E=v.program;n.updateUBOMapping(x,E);let w=t.render.frame;r[x.id]!==w&&(l(x),r[x.id]=w)}function c(x){let v=s.createBuffer(),_=x.__size,E=x.usage;return s.bindBuffer(s.UNIFORM_BUFFER,v),s.bufferData(s.UNIFORM_BUFFER,_,E),s.bindBuffer(s.UNIFORM_BUFFER,null),v}function l(x){let v=i[x.id],_=x.uniforms,E=x.__cache;s.bindBuffer(s.UNIFORM_BUFFER,v);for(let w=0,b=_.length;w<b;w++){let M=_[w];if(Array.isArray(M))for(let I=0,P=M.length;I<P;I++)h(M[I],w,I,E);else h(M,w,0,E)}s.bindBuffer(s.UNIFORM_BUFFER,null)}function h(x,v,_,E){if(d(x,v,_,E)===!0){let w=x.__offset,b=x.value;if(Array.isArray(b)){let M=0;for(let I=0;I<b.length;I++){let P=b[I],C=y(P,!0);u(P,x.__data,M),M+=C.storage/Float32Array.BYTES_PER_ELEMENT}}else u(b,x.__data,0);s.bufferSubData(s.UNIFORM_BUFFER,w,x.__data)}}function u(x,v,_){typeof x=="number"||typeof x=="boolean"?v[_]=x:x.isMatrix3?(v[_]=x.elements[0],v[_+1]=x.elements[1],v[_+2]=x.elements[2],v[_+3]=0,v[_+4]=x.elements[3],v[_+5]=x.elements[4],v[_+6]=x.elements[5],v[_+7]=0,v[_+8]=x.elements[6],v[_+9]=x.elements[7],v[_+10]=x.elements[8],v[_+11]=0):ArrayBuffer.isView(x)?v.set(x.subarray(0,v.length-_),_):x.toArray(v,_)}function d(x,v,_,E){let w=x.value,b=v+"_"+_;if(Array.isArray(w)){E[b]===void 0&&(E[b]=[]);let M=E[b],I=!1;for(let P=0;P<w.length;P++)f(w[P],M,P)===!0&&(I=!0);return I}return f(w,E,b)}function f(x,v,_){if(v[_]===void 0)return typeof x=="number"||typeof x=="boolean"?v[_]=x:ArrayBuffer.isView(x)?v[_]=x.slice():v[_]=x.clone(),!0;{let E=v[_];if(typeof x=="number"||typeof x=="boolean"){if(E!==x)return v[_]=x,!0}else{if(ArrayBuffer.isView(x))return!0;if(E.equals(x)===!1)return E.copy(x),!0}}return!1}function g(x){let v=x.uniforms,_=0,E=16;for(let b=0,M=v.length;b<M;b++){let I=Array.isArray(v[b])?v[b]:[v[b]];for(let P=0,C=I.length;P<C;P++){let D=I[P],B=Array.isArray(D.value)?D.value:[D.value],L=Array.isArray(v[b])||Array.isArray(D.value),z=_;for(let H=0,tt=B.length;H<tt;H++){let X=B[H],Z=y(X,L),$=_%E,at=$%Z.boundary,it=$+at;_+=at,it!==0&&E-it<Z.storage&&(_+=E-it),H===0&&(z=_),_+=Z.storage}let O=D.type==="int"?Int32Array:D.type==="uint"?Uint32Array:Float32Array;D.__data=new O((_-z)/Float32Array.BYTES_PER_ELEMENT),D.__offset=z}}let w=_%E;return w>0&&(_+=E-w),x.__size=_,x.__cache={},this}function y(x,v){let _={boundary:0,storage:0};return typeof x=="number"||typeof x=="boolean"?(_.boundary=4,_.storage=4):x.isVector2?(_.boundary=8,_.storage=8):x.isVector3||x.isColor?(_.boundary=16,_.storage=12):x.isVector4?(_.boundary=16,_.storage=16):x.isMatrix3?(_.boundary=16,_.storage=48):x.isMatrix4?(_.boundary=16,_.storage=64):x.isTexture?Zt("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(x)?(_.boundary=16,_.storage=x.byteLength):Zt("WebGLRenderer: Unsupported uniform value type.",x),v===!0&&(_.boundary=16,_.storage=Math.ceil(_.storage/16)*16),_}function p(x){let v=x.target;v.removeEventListener("dispose",p),s.deleteBuffer(i[v.id]),delete i[v.id],delete r[v.id]}function m(){for(let x in i)s.deleteBuffer(i[x]);i={},r={}}return{bind:o,update:a,dispose:m}}var mE=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),Ns=null;function gE(){return Ns===null&&(Ns=new wr(mE,16,16,Ir,gs),Ns.name="DFG_LUT",Ns.minFilter=jn,Ns.magFilter=jn,Ns.wrapS=_i,Ns.wrapT=_i,Ns.generateMipmaps=!1,Ns.needsUpdate=!0),Ns}var xu=class{constructor(t={}){let{canvas:e=S0(),context:n=null,depth:i=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:c=!0,preserveDrawingBuffer:l=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:u=!1,reversedDepthBuffer:d=!1,outputBufferType:f=Ri}=t;this.isWebGLRenderer=!0;let g;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");g=n.getContextAttributes().alpha}else g=o;let y=f,p=new Set([Fh,Uh,Dh]),m=new Set([Ri,ms,ma,oo,Ih,Lh]),x=new Uint32Array(4),v=new Int32Array(4),_={textures:[],min:[],max:[],resolution:[]},E=null,w=null,b=[],M=[],I=null;this.domElement=e,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=Ji,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let P=this,C=!1,D=null,B=null,L=null,z=null;this._outputColorSpace=Pe;let O=0,H=0,tt=null,X=-1,Z=null,$=new ze,at=new ze,it=null,Y=new qt(0),st=0,nt=e.width,lt=e.height,mt=1,Ut=null,Jt=null,Ot=new ze(0,0,nt,lt),me=new ze(0,0,nt,lt),de=!1,oe=new Mr,an=new fh,Ke=!1,En=!1,Ve=new Gt,Vn=new F,Ee=new ze,Dn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},gn=!1;function Tn(){return tt===null?mt:1}let G=n;function Ct(R,W){return e.getContext(R,W)}let Kt,le,Mt,We,Wt,$t,N,T,j,pt,ut,bt,vt,rt,ct,_t,V,ht,ot,Et,yt,St,Yt;try{let R={alpha:!0,depth:i,stencil:r,antialias:a,premultipliedAlpha:c,preserveDrawingBuffer:l,powerPreference:h,failIfMajorPerformanceCaveat:u};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"187"}`),e.addEventListener("webglcontextlost",Bt,!1),e.addEventListener("webglcontextrestored",ne,!1),e.addEventListener("webglcontextcreationerror",Rt,!1),G===null){let W="webgl2";if(G=Ct(W,R),G===null)throw Ct(W)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}ee()}catch(R){throw e.removeEventListener("webglcontextlost",Bt,!1),e.removeEventListener("webglcontextrestored",ne,!1),e.removeEventListener("webglcontextcreationerror",Rt,!1),te("WebGLRenderer: "+R.message),R}function ee(){Kt=new AM(G),Kt.init(),yt=new cE(G,Kt),le=new gM(G,Kt,t,yt),Mt=new aE(G,Kt),le.reversedDepthBuffer&&d&&Mt.buffers.depth.setReversed(!0),B=G.createFramebuffer(),L=G.createFramebuffer(),z=G.createFramebuffer(),We=new PM(G),Wt=new Y1,$t=new lE(G,Kt,Mt,Wt,le,yt,We),N=new TM(P),T=new Lv(G),St=new pM(G,T),j=new RM(G,T,We,St),pt=new LM(G,j,T,St,We),ht=new IM(G,le,$t),ct=new xM(Wt),ut=new q1(P,N,Kt,le,St,ct),bt=new fE(P,Wt),vt=new Z1,rt=new eE(Kt),V=new fM(P,N,Mt,pt,g,c),_t=new oE(P,pt,le),Yt=new pE(G,We,le,Mt),ot=new mM(G,Kt,We),Et=new CM(G,Kt,We),We.programs=ut.programs,P.capabilities=le,P.extensions=Kt,P.properties=Wt,P.renderLists=vt,P.shadowMap=_t,P.state=Mt,P.info=We}y!==Ri&&(I=new DM(y,e.width,e.height,a,i,r));let ft=new Rp(P,G);this.xr=ft,this.getContext=function(){return G},this.getContextAttributes=function(){return G.getContextAttributes()},this.forceContextLoss=function(){let R=Kt.get("WEBGL_lose_context");R&&R.loseContext()},this.forceContextRestore=function(){let R=Kt.get("WEBGL_lose_context");R&&R.restoreContext()},this.getPixelRatio=function(){return mt},this.setPixelRatio=function(R){R!==void 0&&(mt=R,this.setSize(nt,lt,!1))},this.getSize=function(R){return R.set(nt,lt)},this.setSize=function(R,W,et=!0){if(ft.isPresenting){Zt("WebGLRenderer: Can't change size while VR device is presenting.");return}nt=R,lt=W,e.width=Math.floor(R*mt),e.height=Math.floor(W*mt),et===!0&&(e.style.width=R+"px",e.style.height=W+"px"),I!==null&&I.setSize(e.width,e.height),this.setViewport(0,0,R,W)},this.getDrawingBufferSize=function(R){return R.set(nt*mt,lt*mt).floor()},this.setDrawingBufferSize=function(R,W,et){nt=R,lt=W,mt=et,e.width=Math.floor(R*et),e.height=Math.floor(W*et),this.setViewport(0,0,R,W)},this.setEffects=function(R){if(y===Ri){te("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(R){for(let W=0;W<R.length;W++)if(R[W].isOutputPass===!0){Zt("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}I.setEffects(R||[])},this.getCurrentViewport=function(R){return R.copy($)},this.getViewport=function(R){return R.copy(Ot)},this.setViewport=function(R,W,et,J){R.isVector4?Ot.set(R.x,R.y,R.z,R.w):Ot.set(R,W,et,J),Mt.viewport($.copy(Ot).multiplyScalar(Tn()).round())},this.getScissor=function(R){return R.copy(me)},this.setScissor=function(R,W,et,J){R.isVector4?me.set(R.x,R.y,R.z,R.w):me.set(R,W,et,J),Mt.scissor(at.copy(me).multiplyScalar(Tn()).round())},this.getScissorTest=function(){return de},this.setScissorTest=function(R){Mt.setScissorTest(de=R)},this.setOpaqueSort=function(R){Ut=R},this.setTransparentSort=function(R){Jt=R},this.getClearColor=function(R){return R.copy(V.getClearColor())},this.setClearColor=function(){V.setClearColor(...arguments)},this.getClearAlpha=function(){return V.getClearAlpha()},this.setClearAlpha=function(){V.setClearAlpha(...arguments)},this.clear=function(R=!0,W=!0,et=!0){let J=0;if(R){let K=!1;if(tt!==null){let Tt=tt.texture.format;K=p.has(Tt)}if(K){let Tt=tt.texture.type,Pt=m.has(Tt),At=V.getClearColor(),It=V.getClearAlpha(),Ht=At.r,se=At.g,ge=At.b;Pt?(x[0]=Ht,x[1]=se,x[2]=ge,x[3]=It,G.clearBufferuiv(G.COLOR,0,x)):(v[0]=Ht,v[1]=se,v[2]=ge,v[3]=It,G.clearBufferiv(G.COLOR,0,v))}else J|=G.COLOR_BUFFER_BIT}W&&(J|=G.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),et&&(J|=G.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),J!==0&&G.clear(J)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(R){R.setRenderer(this),D=R},this.dispose=function(){e.removeEventListener("webglcontextlost",Bt,!1),e.removeEventListener("webglcontextrestored",ne,!1),e.removeEventListener("webglcontextcreationerror",Rt,!1),V.dispose(),vt.dispose(),rt.dispose(),$t.dispose(),Wt.dispose(),N.dispose(),pt.dispose(),j.dispose(),St.dispose(),Yt.dispose(),ut.dispose(),ft.dispose(),ft.removeEventListener("sessionstart",_c),ft.removeEventListener("sessionend",vs),Os.stop()};function Bt(R){R.preventDefault(),up("WebGLRenderer: Context Lost."),C=!0}function ne(){up("WebGLRenderer: Context Restored."),C=!1;let R=We.autoReset,W=_t.enabled,et=_t.autoUpdate,J=_t.needsUpdate,K=_t.type;ee(),We.autoReset=R,_t.enabled=W,_t.autoUpdate=et,_t.needsUpdate=J,_t.type=K}function Rt(R){te("WebGLRenderer: A WebGL context could not be created. Reason: ",R.statusMessage)}function ce(R){let W=R.target;W.removeEventListener("dispose",ce),tn(W)}function tn(R){di(R),Wt.remove(R)}function di(R){let W=Wt.get(R).programs;W!==void 0&&(W.forEach(function(et){ut.releaseProgram(et)}),R.isShaderMaterial&&ut.releaseShaderCache(R))}this.renderBufferDirect=function(R,W,et,J,K,Tt){W===null&&(W=Dn);let Pt=K.isMesh&&K.matrixWorld.determinantAffine()<0,At=Ha(R,W,et,J,K);Mt.setMaterial(J,Pt);let It=et.index,Ht=1;if(J.wireframe===!0){if(It=j.getWireframeAttribute(et),It===void 0)return;Ht=2}let se=et.drawRange,ge=et.attributes.position,zt=se.start*Ht,xe=(se.start+se.count)*Ht;Tt!==null&&(zt=Math.max(zt,Tt.start*Ht),xe=Math.min(xe,(Tt.start+Tt.count)*Ht)),It!==null?(zt=Math.max(zt,0),xe=Math.min(xe,It.count)):ge!=null&&(zt=Math.max(zt,0),xe=Math.min(xe,ge.count));let dn=xe-zt;if(dn<0||dn===1/0)return;St.setup(K,J,At,et,It);let Fe,ke=ot;if(It!==null&&(Fe=T.get(It),ke=Et,ke.setIndex(Fe)),K.isMesh)J.wireframe===!0?(Mt.setLineWidth(J.wireframeLinewidth*Tn()),ke.setMode(G.LINES)):ke.setMode(G.TRIANGLES);else if(K.isLine){let Un=J.linewidth;Un===void 0&&(Un=1),Mt.setLineWidth(Un*Tn()),K.isLineSegments?ke.setMode(G.LINES):K.isLineLoop?ke.setMode(G.LINE_LOOP):ke.setMode(G.LINE_STRIP)}else K.isPoints?ke.setMode(G.POINTS):K.isSprite&&ke.setMode(G.TRIANGLES);if(K.isBatchedMesh)if(Kt.get("WEBGL_multi_draw"))ke.renderMultiDraw(K._multiDrawStarts,K._multiDrawCounts,K._multiDrawCount);else{let Un=K._multiDrawStarts,Ft=K._multiDrawCounts,An=K._multiDrawCount,we=It?T.get(It).bytesPerElement:1,zs=Wt.get(J).currentProgram.getUniforms();for(let Rn=0;Rn<An;Rn++)zs.setValue(G,"_gl_DrawID",Rn),ke.render(Un[Rn]/we,Ft[Rn])}else if(K.isInstancedMesh)ke.renderInstances(zt,dn,K.count);else if(et.isInstancedBufferGeometry){let Un=et._maxInstanceCount!==void 0?et._maxInstanceCount:1/0,Ft=Math.min(et.instanceCount,Un);ke.renderInstances(zt,dn,Ft)}else ke.render(zt,dn)};function Oa(R,W,et,J){D!==null&&R.isNodeMaterial&&D.setObject(J,R),Ke===!0&&ct.setState(R,et,!1),R.transparent===!0&&R.side===ci&&R.forceSinglePass===!1?(R.side=bi,R.needsUpdate=!0,ws(R,W,J),R.side=Ls,R.needsUpdate=!0,ws(R,W,J),R.side=ci):ws(R,W,J)}this.compile=function(R,W,et=null){et===null&&(et=R),D!==null&&D.renderStart(R,W,et),w=rt.get(et),w.init(W),M.push(w),et.traverseVisible(function(K){K.isLight&&K.layers.test(W.layers)&&(w.pushLight(K),K.castShadow&&w.pushShadow(K))}),R!==et&&R.traverseVisible(function(K){K.isLight&&K.layers.test(W.layers)&&(w.pushLight(K),K.castShadow&&w.pushShadow(K))}),w.setupLights(),D!==null&&D.updateLights(w.state.lightsArray),En=this.localClippingEnabled,Ke=ct.init(this.clippingPlanes,En),Ke===!0&&ct.setGlobalState(this.clippingPlanes,W),D!==null&&_t.render(w.state.shadowsArray,et,W);let J=new Set;return R.traverse(function(K){if(!(K.isMesh||K.isPoints||K.isLine||K.isSprite))return;let Tt=K.material;if(Tt)if(Array.isArray(Tt))for(let Pt=0;Pt<Tt.length;Pt++){let At=Tt[Pt];Oa(At,et,W,K),J.add(At)}else Oa(Tt,et,W,K),J.add(Tt)}),w=M.pop(),D!==null&&D.renderEnd(),J},this.compileAsync=function(R,W,et=null){let J=this.compile(R,W,et);return new Promise(K=>{function Tt(){if(J.forEach(function(Pt){let It=Wt.get(Pt).currentProgram;(It===void 0||It.isReady())&&J.delete(Pt)}),J.size===0){K(R);return}setTimeout(Tt,10)}Kt.get("KHR_parallel_shader_compile")!==null?Tt():setTimeout(Tt,10)})};let bo=null;function Xd(R){bo&&bo(R)}function _c(){Os.stop()}function vs(){Os.start()}let Os=new ix;Os.setAnimationLoop(Xd),typeof self<"u"&&Os.setContext(self),this.setAnimationLoop=function(R){bo=R,ft.setAnimationLoop(R),R===null?Os.stop():Os.start()},ft.addEventListener("sessionstart",_c),ft.addEventListener("sessionend",vs),this.render=function(R,W){if(W!==void 0&&W.isCamera!==!0){te("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(C===!0)return;D!==null&&D.renderStart(R,W);let et=ft.enabled===!0&&ft.isPresenting===!0,J=I!==null&&(tt===null||et)&&I.begin(P,tt);if(R.matrixWorldAutoUpdate===!0&&R.updateMatrixWorld(),W.parent===null&&W.matrixWorldAutoUpdate===!0&&W.updateMatrixWorld(),ft.enabled===!0&&ft.isPresenting===!0&&(I===null||I.isCompositing()===!1)&&(ft.cameraAutoUpdate===!0&&ft.updateCamera(W),W=ft.getCamera()),R.isScene===!0&&R.onBeforeRender(P,R,W,tt),w=rt.get(R,M.length),w.init(W),w.state.textureUnits=$t.getTextureUnits(),M.push(w),Ve.multiplyMatrices(W.projectionMatrix,W.matrixWorldInverse),W.isArrayCamera?an.setFromArrayCamera(W):oe.setFromProjectionMatrix(Ve,Yi,W.reversedDepth),En=this.localClippingEnabled,Ke=ct.init(this.clippingPlanes,En),E=vt.get(R,b.length),E.init(),b.push(E),this.info.render.frame++,ft.enabled===!0&&ft.isPresenting===!0){let Pt=P.xr.getDepthSensingMesh();Pt!==null&&Bs(Pt,W,-1/0,P.sortObjects)}Bs(R,W,0,P.sortObjects),E.finish(),D!==null&&D.updateLights(w.state.lightsArray),P.sortObjects===!0&&E.sort(Ut,Jt),gn=ft.enabled===!1||ft.isPresenting===!1||ft.hasDepthSensing()===!1,gn&&V.addToRenderList(E,R),this.info.autoReset===!0&&this.info.reset(),Ke===!0&&ct.beginShadows();let K=w.state.shadowsArray;if(_t.render(K,R,W),Ke===!0&&ct.endShadows(),(J&&I.hasRenderPass())===!1){let Pt=E.opaque,At=E.transmissive;if(w.setupLights(),W.isArrayCamera){let It=W.cameras;if(At.length>0)for(let Ht=0,se=It.length;Ht<se;Ht++){let ge=It[Ht];rs(Pt,At,R,ge)}gn&&V.render(R);for(let Ht=0,se=It.length;Ht<se;Ht++){let ge=It[Ht];Ba(E,R,ge,ge.viewport)}}else At.length>0&&rs(Pt,At,R,W),gn&&V.render(R),Ba(E,R,W)}tt!==null&&H===0&&($t.updateMultisampleRenderTarget(tt),$t.updateRenderTargetMipmap(tt)),J&&I.end(P),R.isScene===!0&&R.onAfterRender(P,R,W),St.resetDefaultState(),X=-1,Z=null,M.pop(),M.length>0?(w=M[M.length-1],$t.setTextureUnits(w.state.textureUnits),Ke===!0&&ct.setGlobalState(P.clippingPlanes,w.state.camera)):w=null,b.pop(),b.length>0?E=b[b.length-1]:E=null,D!==null&&D.renderEnd()};function Bs(R,W,et,J){if(R.visible===!1)return;if(R.layers.test(W.layers)){if(R.isGroup)et=R.renderOrder;else if(R.isLOD)R.autoUpdate===!0&&R.update(W);else if(R.isLight)w.pushLight(R),R.castShadow&&w.pushShadow(R);else if(R.isSprite){let Pt=W.isArrayCamera?an:oe;if(!R.frustumCulled||R.intersectsFrustum(Pt)){J&&Ee.setFromMatrixPosition(R.matrixWorld).applyMatrix4(Ve);let At=pt.update(R),It=R.material;It.visible&&E.push(R,At,It,et,Ee.z,null,W)}}else if(R.isMesh||R.isLine||R.isPoints){let Pt=W.isArrayCamera?an:oe;if(!R.frustumCulled||R.intersectsFrustum(Pt)){let At=pt.update(R),It=R.material;if(J&&(R.boundingSphere!==void 0?(R.boundingSphere===null&&R.computeBoundingSphere(),Ee.copy(R.boundingSphere.center)):(At.boundingSphere===null&&At.computeBoundingSphere(),Ee.copy(At.boundingSphere.center)),Ee.applyMatrix4(R.matrixWorld).applyMatrix4(Ve)),Array.isArray(It)){let Ht=At.groups;for(let se=0,ge=Ht.length;se<ge;se++){let zt=Ht[se],xe=It[zt.materialIndex];xe&&xe.visible&&E.push(R,At,xe,et,Ee.z,zt,W)}}else It.visible&&E.push(R,At,It,et,Ee.z,null,W)}}}let Tt=R.children;for(let Pt=0,At=Tt.length;Pt<At;Pt++)Bs(Tt[Pt],W,et,J)}function Ba(R,W,et,J){let{opaque:K,transmissive:Tt,transparent:Pt}=R;w.setupLightsView(et),Ke===!0&&ct.setGlobalState(P.clippingPlanes,et),J&&Mt.viewport($.copy(J)),K.length>0&&xn(K,W,et),Tt.length>0&&xn(Tt,W,et),Pt.length>0&&xn(Pt,W,et),Mt.buffers.depth.setTest(!0),Mt.buffers.depth.setMask(!0),Mt.buffers.color.setMask(!0),Mt.setPolygonOffset(!1)}function rs(R,W,et,J){if((et.isScene===!0?et.overrideMaterial:null)!==null)return;if(w.state.transmissionRenderTarget[J.id]===void 0){let zt=Kt.has("EXT_color_buffer_half_float")||Kt.has("EXT_color_buffer_float");w.state.transmissionRenderTarget[J.id]=new ki(1,1,{generateMipmaps:!0,type:zt?gs:Ri,minFilter:Ki,samples:Math.max(4,le.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:he.workingColorSpace})}let Tt=w.state.transmissionRenderTarget[J.id],Pt=J.viewport||$;Tt.setSize(Pt.z*P.transmissionResolutionScale,Pt.w*P.transmissionResolutionScale);let At=P.getRenderTarget(),It=P.getActiveCubeFace(),Ht=P.getActiveMipmapLevel();P.setRenderTarget(Tt),P.getClearColor(Y),st=P.getClearAlpha(),st<1&&P.setClearColor(16777215,.5),P.clear(),gn&&V.render(et);let se=P.toneMapping;P.toneMapping=Ji;let ge=J.viewport;if(J.viewport!==void 0&&(J.viewport=void 0),w.setupLightsView(J),Ke===!0&&ct.setGlobalState(P.clippingPlanes,J),xn(R,et,J),$t.updateMultisampleRenderTarget(Tt),$t.updateRenderTargetMipmap(Tt),Kt.has("WEBGL_multisampled_render_to_texture")===!1){let zt=!1;for(let xe=0,dn=W.length;xe<dn;xe++){let Fe=W[xe],{object:ke,geometry:Un,material:Ft,group:An}=Fe;if(Ft.side===ci&&ke.layers.test(J.layers)){let we=Ft.side;Ft.side=bi,Ft.needsUpdate=!0,Sn(ke,et,J,Un,Ft,An),Ft.side=we,Ft.needsUpdate=!0,zt=!0}}zt===!0&&($t.updateMultisampleRenderTarget(Tt),$t.updateRenderTargetMipmap(Tt))}P.setRenderTarget(At,It,Ht),P.setClearColor(Y,st),ge!==void 0&&(J.viewport=ge),P.toneMapping=se}function xn(R,W,et){let J=W.isScene===!0?W.overrideMaterial:null;for(let K=0,Tt=R.length;K<Tt;K++){let Pt=R[K],{object:At,geometry:It,group:Ht}=Pt,se=Pt.material;se.allowOverride===!0&&J!==null&&(se=J),At.layers.test(et.layers)&&Sn(At,W,et,It,se,Ht)}}function Sn(R,W,et,J,K,Tt){D!==null&&K.isNodeMaterial&&D.setObject(R,K),R.onBeforeRender(P,W,et,J,K,Tt),R.modelViewMatrix.multiplyMatrices(et.matrixWorldInverse,R.matrixWorld),R.normalMatrix.getNormalMatrix(R.modelViewMatrix),K.onBeforeRender(P,W,et,J,R,Tt),K.transparent===!0&&K.side===ci&&K.forceSinglePass===!1?(K.side=bi,K.needsUpdate=!0,P.renderBufferDirect(et,W,J,K,R,Tt),K.side=Ls,K.needsUpdate=!0,P.renderBufferDirect(et,W,J,K,R,Tt),K.side=ci):P.renderBufferDirect(et,W,J,K,R,Tt),R.onAfterRender(P,W,et,J,K,Tt)}function Mn(R){let W=0;for(let et of R)et.texture!==null&&W++;return W}function ws(R,W,et){W.isScene!==!0&&(W=Dn);let J=Wt.get(R),K=w.state.lights,Tt=w.state.shadowsArray,Pt=K.state.version,At=ut.getParameters(R,K.state,Tt,W,et,w.state.lightProbeGridArray),It=ut.getProgramCacheKey(At),Ht=J.programs;J.environment=R.isMeshStandardMaterial||R.isMeshLambertMaterial||R.isMeshPhongMaterial?W.environment:null,J.fog=W.fog;let se=R.isMeshStandardMaterial||R.isMeshLambertMaterial&&!R.envMap||R.isMeshPhongMaterial&&!R.envMap;J.envMap=N.get(R.envMap||J.environment,se),J.envMapRotation=J.environment!==null&&R.envMap===null?W.environmentRotation:R.envMapRotation,Ht===void 0&&(R.addEventListener("dispose",ce),Ht=new Map,J.programs=Ht,J.programVariants=new Map);let ge=Ht.get(It);if(ge!==void 0){if(J.currentProgram===ge&&J.lightsStateVersion===Pt)return za(R,At),ge}else At.uniforms=ut.getUniforms(R),D!==null&&R.isNodeMaterial&&D.build(R,et,At),R.onBeforeCompile(At,P),ge=ut.acquireProgram(At,It),Ht.set(It,ge),J.uniforms=At.uniforms;let zt=J.uniforms;return(!R.isShaderMaterial&&!R.isRawShaderMaterial||R.clipping===!0)&&(zt.clippingPlanes=ct.uniform),za(R,At),J.needsLights=ur(R),J.lightsStateVersion=Pt,J.needsLights&&(zt.ambientLightColor.value=K.state.ambient,zt.lightProbe.value=K.state.probe,zt.sunLights.value=K.state.sun,zt.sunLightShadows.value=K.state.sunShadow,zt.directionalLights.value=K.state.directional,zt.directionalLightShadows.value=K.state.directionalShadow,zt.spotLights.value=K.state.spot,zt.spotLightShadows.value=K.state.spotShadow,zt.rectAreaLights.value=K.state.rectArea,zt.ltc_1.value=K.state.rectAreaLTC1,zt.ltc_2.value=K.state.rectAreaLTC2,zt.pointLights.value=K.state.point,zt.pointLightShadows.value=K.state.pointShadow,zt.hemisphereLights.value=K.state.hemi,zt.sunShadowMatrix.value=K.state.sunShadowMatrix,zt.sunShadowCascade.value=K.state.sunShadowCascade,zt.directionalShadowMatrix.value=K.state.directionalShadowMatrix,zt.spotLightMatrix.value=K.state.spotLightMatrix,zt.spotLightMap.value=K.state.spotLightMap,zt.pointShadowMatrix.value=K.state.pointShadowMatrix),J.numLightProbeGrids=Mn(w.state.lightProbeGridArray),J.currentProgram=ge,J.uniformsList=null,ge}function Ii(R,W,et,J,K){let Tt=Wt.get(R),Pt=Tt.currentProgram.id+","+J+","+K,At=Tt.programVariants.get(Pt);return At===void 0?(At=ws(R,W,et),Tt.programVariants.set(Pt,At)):(Tt.currentProgram=At,Tt.uniformsList=null,Tt.outputColorSpace=J,Tt.toneMapping=K),At}function hr(R){if(R.uniformsList===null){let W=R.currentProgram.getUniforms();R.uniformsList=xa.seqWithValue(W.seq,R.uniforms)}return R.uniformsList}function za(R,W){let et=Wt.get(R);et.outputColorSpace=W.outputColorSpace,et.batching=W.batching,et.batchingColor=W.batchingColor,et.instancing=W.instancing,et.instancingColor=W.instancingColor,et.instancingMorph=W.instancingMorph,et.skinning=W.skinning,et.morphTargets=W.morphTargets,et.morphNormals=W.morphNormals,et.morphColors=W.morphColors,et.morphTargetsCount=W.morphTargetsCount,et.numClippingPlanes=W.numClippingPlanes,et.numIntersection=W.numClipIntersection,et.vertexAlphas=W.vertexAlphas,et.vertexTangents=W.vertexTangents,et.toneMapping=W.toneMapping}function Ha(R,W,et,J,K){W.isScene!==!0&&(W=Dn),$t.resetTextureUnits();let Tt=W.fog,Pt=J.isMeshStandardMaterial||J.isMeshLambertMaterial||J.isMeshPhongMaterial?W.environment:null,At=tt===null?P.outputColorSpace:tt.isXRRenderTarget===!0?tt.texture.colorSpace:he.workingColorSpace,It=J.isMeshStandardMaterial||J.isMeshLambertMaterial&&!J.envMap||J.isMeshPhongMaterial&&!J.envMap,Ht=N.get(J.envMap||Pt,It),se=J.vertexColors===!0&&!!et.attributes.color&&et.attributes.color.itemSize===4,ge=!!et.attributes.tangent&&(!!J.normalMap||J.anisotropy>0),zt=!!et.morphAttributes.position,xe=!!et.morphAttributes.normal,dn=!!et.morphAttributes.color,Fe=Ji;J.toneMapped&&(tt===null||tt.isXRRenderTarget===!0)&&(Fe=P.toneMapping);let ke=et.morphAttributes.position||et.morphAttributes.normal||et.morphAttributes.color,Un=ke!==void 0?ke.length:0,Ft=Wt.get(J),An=w.state.lights;if(Ke===!0&&(En===!0||R!==Z)){let Oe=R===Z&&J.id===X;ct.setState(J,R,Oe)}let we=!1,zs=!1;J.version===Ft.__version?Ft.needsLights&&Ft.lightsStateVersion!==An.state.version||K.isBatchedMesh&&Ft.batching===!1||!K.isBatchedMesh&&Ft.batching===!0||K.isBatchedMesh&&Ft.batchingColor===!0&&K._colorsTexture===null||K.isBatchedMesh&&Ft.batchingColor===!1&&K._colorsTexture!==null||K.isInstancedMesh&&Ft.instancing===!1||!K.isInstancedMesh&&Ft.instancing===!0||K.isSkinnedMesh&&Ft.skinning===!1||!K.isSkinnedMesh&&Ft.skinning===!0||K.isInstancedMesh&&Ft.instancingColor===!0&&K.instanceColor===null||K.isInstancedMesh&&Ft.instancingColor===!1&&K.instanceColor!==null||K.isInstancedMesh&&Ft.instancingMorph===!0&&K.morphTexture===null||K.isInstancedMesh&&Ft.instancingMorph===!1&&K.morphTexture!==null||Ft.envMap!==Ht||J.fog===!0&&Ft.fog!==Tt||Ft.numClippingPlanes!==void 0&&(Ft.numClippingPlanes!==ct.numPlanes||Ft.numIntersection!==ct.numIntersection)||Ft.vertexAlphas!==se||Ft.vertexTangents!==ge||Ft.morphTargets!==zt||Ft.morphNormals!==xe||Ft.morphColors!==dn||Ft.morphTargetsCount!==Un||Ft.numLightProbeGrids!==Mn(w.state.lightProbeGridArray)?we=!0:(Ft.outputColorSpace!==At||Ft.toneMapping!==Fe)&&(zs=!0):(we=!0,Ft.__version=J.version);let Rn=Ft.currentProgram;(we===!0||zs===!0)&&(Rn=zs===!0?Ii(J,W,K,At,Fe):ws(J,W,K),D&&J.isNodeMaterial&&D.onUpdateProgram(J,Rn,Ft));let So=!1,Ss=!1,Hs=!1,fe=Rn.getUniforms(),_n=Ft.uniforms;if(Mt.useProgram(Rn.program)&&(So=!0,Ss=!0,Hs=!0),J.id!==X&&(X=J.id,Ss=!0),So||Z!==R){Mt.buffers.depth.getReversed()&&R.reversedDepth!==!0&&(R._reversedDepth=!0,R.updateProjectionMatrix()),fe.setValue(G,"projectionMatrix",R.projectionMatrix),fe.setValue(G,"viewMatrix",R.matrixWorldInverse);let Cn=fe.map.cameraPosition;Cn!==void 0&&Cn.setValue(G,Vn.setFromMatrixPosition(R.matrixWorld)),le.logarithmicDepthBuffer&&fe.setValue(G,"logDepthBufFC",2/(Math.log(R.far+1)/Math.LN2)),(J.isMeshPhongMaterial||J.isMeshToonMaterial||J.isMeshLambertMaterial||J.isMeshBasicMaterial||J.isMeshStandardMaterial||J.isShaderMaterial)&&fe.setValue(G,"isOrthographic",R.isOrthographicCamera===!0),Z!==R&&(Z=R,Ss=!0,Hs=!0)}if(Ft.needsLights&&(An.state.sunShadowMap.length>0&&fe.setValue(G,"sunShadowMap",An.state.sunShadowMap,$t),An.state.directionalShadowMap.length>0&&fe.setValue(G,"directionalShadowMap",An.state.directionalShadowMap,$t),An.state.spotShadowMap.length>0&&fe.setValue(G,"spotShadowMap",An.state.spotShadowMap,$t),An.state.pointShadowMap.length>0&&fe.setValue(G,"pointShadowMap",An.state.pointShadowMap,$t)),K.isSkinnedMesh){fe.setOptional(G,K,"bindMatrix"),fe.setOptional(G,K,"bindMatrixInverse");let Oe=K.skeleton;Oe&&(Oe.boneTexture===null&&Oe.computeBoneTexture(),fe.setValue(G,"boneTexture",Oe.boneTexture,$t))}K.isBatchedMesh&&(fe.setOptional(G,K,"batchingTexture"),fe.setValue(G,"batchingTexture",K._matricesTexture,$t),fe.setOptional(G,K,"batchingIdTexture"),fe.setValue(G,"batchingIdTexture",K._indirectTexture,$t),fe.setOptional(G,K,"batchingColorTexture"),K._colorsTexture!==null&&fe.setValue(G,"batchingColorTexture",K._colorsTexture,$t));let fi=et.morphAttributes;if((fi.position!==void 0||fi.normal!==void 0||fi.color!==void 0)&&ht.update(K,et,Rn),(Ss||Ft.receiveShadow!==K.receiveShadow)&&(Ft.receiveShadow=K.receiveShadow,fe.setValue(G,"receiveShadow",K.receiveShadow)),(J.isMeshStandardMaterial||J.isMeshLambertMaterial||J.isMeshPhongMaterial)&&J.envMap===null&&W.environment!==null&&(_n.envMapIntensity.value=W.environmentIntensity),_n.dfgLUT!==void 0&&(_n.dfgLUT.value=gE()),Ss){if(fe.setValue(G,"toneMappingExposure",P.toneMappingExposure),Ft.needsLights&&vo(_n,Hs),Tt&&J.fog===!0&&bt.refreshFogUniforms(_n,Tt),bt.refreshMaterialUniforms(_n,J,mt,lt,w.state.transmissionRenderTarget[R.id]),Ft.needsLights&&Ft.numLightProbeGrids>0){let Oe=_,Cn=0;for(let ni of w.state.lightProbeGridArray)ni.texture!==null&&(Oe.textures[Cn]=ni.texture,Oe.min[Cn]=ni.boundingBox.min,Oe.max[Cn]=ni.boundingBox.max,Oe.resolution[Cn]=ni.resolution,Cn++);for(let ni in Oe)Oe[ni].length=Cn;_n.probesSH.value=Oe.textures,_n.probesMin.value=Oe.min,_n.probesMax.value=Oe.max,_n.probesResolution.value=Oe.resolution}xa.upload(G,hr(Ft),_n,$t)}if(J.isShaderMaterial&&J.uniformsNeedUpdate===!0&&(xa.upload(G,hr(Ft),_n,$t),J.uniformsNeedUpdate=!1),J.isSpriteMaterial&&fe.setValue(G,"center",K.center),fe.setValue(G,"modelViewMatrix",K.modelViewMatrix),fe.setValue(G,"normalMatrix",K.normalMatrix),fe.setValue(G,"modelMatrix",K.matrixWorld),J.uniformsGroups!==void 0){let Oe=J.uniformsGroups;for(let Cn=0,ni=Oe.length;Cn<ni;Cn++){let yc=Oe[Cn];Yt.update(yc,Rn),Yt.bind(yc,Rn)}}return Rn}function vo(R,W){R.ambientLightColor.needsUpdate=W,R.lightProbe.needsUpdate=W,R.sunLights.needsUpdate=W,R.sunLightShadows.needsUpdate=W,R.directionalLights.needsUpdate=W,R.directionalLightShadows.needsUpdate=W,R.pointLights.needsUpdate=W,R.pointLightShadows.needsUpdate=W,R.spotLights.needsUpdate=W,R.spotLightShadows.needsUpdate=W,R.rectAreaLights.needsUpdate=W,R.hemisphereLights.needsUpdate=W}function ur(R){return R.isMeshLambertMaterial||R.isMeshToonMaterial||R.isMeshPhongMaterial||R.isMeshStandardMaterial||R.isShadowMaterial||R.isShaderMaterial&&R.lights===!0}this.getActiveCubeFace=function(){return O},this.getActiveMipmapLevel=function(){return H},this.getRenderTarget=function(){return tt},this.setRenderTargetTextures=function(R,W,et){let J=Wt.get(R);J.__autoAllocateDepthBuffer=R.resolveDepthBuffer===!1,J.__autoAllocateDepthBuffer===!1&&(J.__useRenderToTexture=!1),Wt.get(R.texture).__webglTexture=W,Wt.get(R.depthTexture).__webglTexture=J.__autoAllocateDepthBuffer?void 0:et,J.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(R,W){let et=Wt.get(R);et.__webglFramebuffer=W,et.__useDefaultFramebuffer=W===void 0},this.setRenderTarget=function(R,W=0,et=0){tt=R,O=W,H=et;let J=null,K=!1,Tt=!1;if(R){let At=Wt.get(R);if(At.__useDefaultFramebuffer!==void 0){Mt.bindFramebuffer(G.FRAMEBUFFER,At.__webglFramebuffer),$.copy(R.viewport),at.copy(R.scissor),it=R.scissorTest,Mt.viewport($),Mt.scissor(at),Mt.setScissorTest(it),X=-1;return}else if(At.__webglFramebuffer===void 0)$t.setupRenderTarget(R);else if(At.__hasExternalTextures)$t.rebindTextures(R,Wt.get(R.texture).__webglTexture,Wt.get(R.depthTexture).__webglTexture);else if(R.depthBuffer){let se=R.depthTexture;if(At.__boundDepthTexture!==se){if(se!==null&&Wt.has(se)&&(R.width!==se.image.width||R.height!==se.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");$t.setupDepthRenderbuffer(R)}}let It=R.texture;(It.isData3DTexture||It.isDataArrayTexture||It.isCompressedArrayTexture)&&(Tt=!0);let Ht=Wt.get(R).__webglFramebuffer;R.isWebGLCubeRenderTarget?(Array.isArray(Ht[W])?J=Ht[W][et]:J=Ht[W],K=!0):R.samples>0&&$t.useMultisampledRTT(R)===!1?J=Wt.get(R).__webglMultisampledFramebuffer:Array.isArray(Ht)?J=Ht[et]:J=Ht,$.copy(R.viewport),at.copy(R.scissor),it=R.scissorTest}else $.copy(Ot).multiplyScalar(mt).floor(),at.copy(me).multiplyScalar(mt).floor(),it=de;if(et!==0&&(J=B),Mt.bindFramebuffer(G.FRAMEBUFFER,J)&&Mt.drawBuffers(R,J),Mt.viewport($),Mt.scissor(at),Mt.setScissorTest(it),K){let At=Wt.get(R.texture);G.framebufferTexture2D(G.FRAMEBUFFER,G.COLOR_ATTACHMENT0,G.TEXTURE_CUBE_MAP_POSITIVE_X+W,At.__webglTexture,et)}else if(Tt){let At=W;for(let It=0;It<R.textures.length;It++){let Ht=Wt.get(R.textures[It]);G.framebufferTextureLayer(G.FRAMEBUFFER,G.COLOR_ATTACHMENT0+It,Ht.__webglTexture,et,At)}}else if(R!==null&&et!==0){let At=Wt.get(R.texture);G.framebufferTexture2D(G.FRAMEBUFFER,G.COLOR_ATTACHMENT0,G.TEXTURE_2D,At.__webglTexture,et)}X=-1};function wo(R){let W=Wt.get(R);return(W.__readFormat!==R.format||W.__readType!==R.type)&&(W.__readFormat=R.format,W.__readType=R.type,W.__formatReadable=le.textureFormatReadable(R.format),W.__typeReadable=le.textureTypeReadable(R.type)),W}this.readRenderTargetPixels=function(R,W,et,J,K,Tt,Pt,At=0){if(!(R&&R.isWebGLRenderTarget)){te("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let It=Wt.get(R).__webglFramebuffer;if(R.isWebGLCubeRenderTarget&&Pt!==void 0&&(It=It[Pt],Array.isArray(It)&&(It=It[0])),It){Mt.bindFramebuffer(G.FRAMEBUFFER,It);try{let Ht=R.textures[At],se=Ht.format,ge=Ht.type;R.textures.length>1&&G.readBuffer(G.COLOR_ATTACHMENT0+At);let zt=wo(Ht);if(zt.__formatReadable===!1){te("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(zt.__typeReadable===!1){te("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}W>=0&&W<=R.width-J&&et>=0&&et<=R.height-K&&G.readPixels(W,et,J,K,yt.convert(se),yt.convert(ge),Tt)}finally{let Ht=tt!==null?Wt.get(tt).__webglFramebuffer:null;Mt.bindFramebuffer(G.FRAMEBUFFER,Ht)}}},this.readRenderTargetPixelsAsync=async function(R,W,et,J,K,Tt,Pt,At=0){if(!(R&&R.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let It=Wt.get(R).__webglFramebuffer;if(R.isWebGLCubeRenderTarget&&Pt!==void 0&&(It=It[Pt],Array.isArray(It)&&(It=It[0])),It)if(W>=0&&W<=R.width-J&&et>=0&&et<=R.height-K){Mt.bindFramebuffer(G.FRAMEBUFFER,It);let Ht=R.textures[At],se=Ht.format,ge=Ht.type;R.textures.length>1&&G.readBuffer(G.COLOR_ATTACHMENT0+At);let zt=wo(Ht);if(zt.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(zt.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let xe=G.createBuffer();G.bindBuffer(G.PIXEL_PACK_BUFFER,xe),G.bufferData(G.PIXEL_PACK_BUFFER,Tt.byteLength,G.STREAM_READ),G.readPixels(W,et,J,K,yt.convert(se),yt.convert(ge),0),G.bindBuffer(G.PIXEL_PACK_BUFFER,null);let dn=tt!==null?Wt.get(tt).__webglFramebuffer:null;Mt.bindFramebuffer(G.FRAMEBUFFER,dn);let Fe=G.fenceSync(G.SYNC_GPU_COMMANDS_COMPLETE,0);return G.flush(),await E0(G,Fe,4),G.bindBuffer(G.PIXEL_PACK_BUFFER,xe),G.getBufferSubData(G.PIXEL_PACK_BUFFER,0,Tt),G.bindBuffer(G.PIXEL_PACK_BUFFER,null),G.deleteBuffer(xe),G.deleteSync(Fe),Tt}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(R,W=null,et=0){let J=Math.pow(2,-et),K=Math.floor(R.image.width*J),Tt=Math.floor(R.image.height*J),Pt=W!==null?W.x:0,At=W!==null?W.y:0;$t.setTexture2D(R,0),G.copyTexSubImage2D(G.TEXTURE_2D,et,0,0,Pt,At,K,Tt),Mt.unbindTexture()},this.copyTextureToTexture=function(R,W,et=null,J=null,K=0,Tt=0){let Pt,At,It,Ht,se,ge,zt,xe,dn,Fe=R.isCompressedTexture?R.mipmaps[Tt]:R.image;if(et!==null)Pt=et.max.x-et.min.x,At=et.max.y-et.min.y,It=et.isBox3?et.max.z-et.min.z:1,Ht=et.min.x,se=et.min.y,ge=et.isBox3?et.min.z:0;else{let fe=Math.pow(2,-K);Pt=Math.floor(Fe.width*fe),At=Math.floor(Fe.height*fe),R.isDataArrayTexture?It=Fe.depth:R.isData3DTexture?It=Math.floor(Fe.depth*fe):It=1,Ht=0,se=0,ge=0}J!==null?(zt=J.x,xe=J.y,dn=J.z):(zt=0,xe=0,dn=0);let ke=yt.convert(W.format),Un=yt.convert(W.type),Ft;W.isData3DTexture?($t.setTexture3D(W,0),Ft=G.TEXTURE_3D):W.isDataArrayTexture||W.isCompressedArrayTexture?($t.setTexture2DArray(W,0),Ft=G.TEXTURE_2D_ARRAY):($t.setTexture2D(W,0),Ft=G.TEXTURE_2D),Mt.activeTexture(G.TEXTURE0),Mt.pixelStorei(G.UNPACK_FLIP_Y_WEBGL,W.flipY),Mt.pixelStorei(G.UNPACK_PREMULTIPLY_ALPHA_WEBGL,W.premultiplyAlpha),Mt.pixelStorei(G.UNPACK_ALIGNMENT,W.unpackAlignment);let An=Mt.getParameter(G.UNPACK_ROW_LENGTH),we=Mt.getParameter(G.UNPACK_IMAGE_HEIGHT),zs=Mt.getParameter(G.UNPACK_SKIP_PIXELS),Rn=Mt.getParameter(G.UNPACK_SKIP_ROWS),So=Mt.getParameter(G.UNPACK_SKIP_IMAGES);Mt.pixelStorei(G.UNPACK_ROW_LENGTH,Fe.width),Mt.pixelStorei(G.UNPACK_IMAGE_HEIGHT,Fe.height),Mt.pixelStorei(G.UNPACK_SKIP_PIXELS,Ht),Mt.pixelStorei(G.UNPACK_SKIP_ROWS,se),Mt.pixelStorei(G.UNPACK_SKIP_IMAGES,ge);let Ss=R.isDataArrayTexture||R.isData3DTexture,Hs=W.isDataArrayTexture||W.isData3DTexture;if(R.isDepthTexture){let fe=Wt.get(R),_n=Wt.get(W),fi=Wt.get(fe.__renderTarget),Oe=Wt.get(_n.__renderTarget);Mt.bindFramebuffer(G.READ_FRAMEBUFFER,fi.__webglFramebuffer),Mt.bindFramebuffer(G.DRAW_FRAMEBUFFER,Oe.__webglFramebuffer);for(let Cn=0;Cn<It;Cn++)Ss&&(G.framebufferTextureLayer(G.READ_FRAMEBUFFER,G.COLOR_ATTACHMENT0,Wt.get(R).__webglTexture,K,ge+Cn),G.framebufferTextureLayer(G.DRAW_FRAMEBUFFER,G.COLOR_ATTACHMENT0,Wt.get(W).__webglTexture,Tt,dn+Cn)),G.blitFramebuffer(Ht,se,Ht+Pt,se+At,zt,xe,zt+Pt,xe+At,G.DEPTH_BUFFER_BIT,G.NEAREST);Mt.bindFramebuffer(G.READ_FRAMEBUFFER,null),Mt.bindFramebuffer(G.DRAW_FRAMEBUFFER,null)}else if(K!==0||R.isRenderTargetTexture||Wt.has(R)){let fe=Wt.get(R),_n=Wt.get(W);Mt.bindFramebuffer(G.READ_FRAMEBUFFER,L),Mt.bindFramebuffer(G.DRAW_FRAMEBUFFER,z);for(let fi=0;fi<It;fi++)Ss?G.framebufferTextureLayer(G.READ_FRAMEBUFFER,G.COLOR_ATTACHMENT0,fe.__webglTexture,K,ge+fi):G.framebufferTexture2D(G.READ_FRAMEBUFFER,G.COLOR_ATTACHMENT0,G.TEXTURE_2D,fe.__webglTexture,K),Hs?G.framebufferTextureLayer(G.DRAW_FRAMEBUFFER,G.COLOR_ATTACHMENT0,_n.__webglTexture,Tt,dn+fi):G.framebufferTexture2D(G.DRAW_FRAMEBUFFER,G.COLOR_ATTACHMENT0,G.TEXTURE_2D,_n.__webglTexture,Tt),K!==0?G.blitFramebuffer(Ht,se,Ht+Pt,se+At,zt,xe,zt+Pt,xe+At,G.COLOR_BUFFER_BIT,G.NEAREST):Hs?G.copyTexSubImage3D(Ft,Tt,zt,xe,dn+fi,Ht,se,Pt,At):G.copyTexSubImage2D(Ft,Tt,zt,xe,Ht,se,Pt,At);Mt.bindFramebuffer(G.READ_FRAMEBUFFER,null),Mt.bindFramebuffer(G.DRAW_FRAMEBUFFER,null)}else Hs?R.isDataTexture||R.isData3DTexture?G.texSubImage3D(Ft,Tt,zt,xe,dn,Pt,At,It,ke,Un,Fe.data):W.isCompressedArrayTexture?G.compressedTexSubImage3D(Ft,Tt,zt,xe,dn,Pt,At,It,ke,Fe.data):G.texSubImage3D(Ft,Tt,zt,xe,dn,Pt,At,It,ke,Un,Fe):R.isDataTexture?G.texSubImage2D(G.TEXTURE_2D,Tt,zt,xe,Pt,At,ke,Un,Fe.data):R.isCompressedTexture?G.compressedTexSubImage2D(G.TEXTURE_2D,Tt,zt,xe,Fe.width,Fe.height,ke,Fe.data):G.texSubImage2D(G.TEXTURE_2D,Tt,zt,xe,Pt,At,ke,Un,Fe);Mt.pixelStorei(G.UNPACK_ROW_LENGTH,An),Mt.pixelStorei(G.UNPACK_IMAGE_HEIGHT,we),Mt.pixelStorei(G.UNPACK_SKIP_PIXELS,zs),Mt.pixelStorei(G.UNPACK_SKIP_ROWS,Rn),Mt.pixelStorei(G.UNPACK_SKIP_IMAGES,So),Tt===0&&W.generateMipmaps===!0&&W.mipmapsAutoUpdate===!0&&G.generateMipmap(Ft),Mt.unbindTexture()},this.initRenderTarget=function(R){Wt.get(R).__webglFramebuffer===void 0&&$t.setupRenderTarget(R)},this.initTexture=function(R){R.isCubeTexture?$t.setTextureCube(R,0):R.isData3DTexture?$t.setTexture3D(R,0):R.isDataArrayTexture||R.isCompressedArrayTexture?$t.setTexture2DArray(R,0):$t.setTexture2D(R,0),Mt.unbindTexture()},this.resetState=function(){O=0,H=0,tt=null,Mt.reset(),St.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Yi}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=he._getDrawingBufferColorSpace(t),e.unpackColorSpace=he._getUnpackColorSpace()}};var xE=4,px=400,bu=class{constructor(t){this.line=new Fn(new ue,new wl({color:8189392,dashSize:.03,gapSize:.012,depthTest:!1,transparent:!0})),this.line.geometry.setAttribute("position",new Xe(new Float32Array(3*px),3)),this.dots=new Js(this.line.geometry,new ps({color:8189392,size:5,sizeAttenuation:!1,depthTest:!1,transparent:!0})),this.group=new Be,this.group.add(this.line,this.dots),this.group.visible=!1;for(let e of[this.line,this.dots])e.frustumCulled=!1,e.renderOrder=12;t.add(this.group)}show(t,e,n,i,r){if(this.group.visible=!1,!e||!i||t.knots.length<2)return;let o=t.joints.map(l=>e.joints[l]??null);e.position.set(...i.base.slice(0,3)),e.quaternion.set(i.base[4],i.base[5],i.base[6],i.base[3]),r.forEach((l,h)=>e.joints[l]?.setJointValue(i.q[h]??0));let a=this.movedHand(n,e,o);if(!a)return;let c=t.knots.slice(0,px).map(l=>(o.forEach((h,u)=>h?.setJointValue(l[u]??0)),e.updateMatrixWorld(!0),new F(...a.at).applyMatrix4(e.links[a.link].matrixWorld)));c.forEach((l,h)=>this.line.geometry.attributes.position.setXYZ(h,l.x,l.y,l.z)),this.line.geometry.attributes.position.needsUpdate=!0,this.line.geometry.setDrawRange(0,c.length),this.line.computeLineDistances(),this.group.visible=!0,this.until=performance.now()+1e3*(t.seconds+xE)}movedHand(t,e,n){return t.find(i=>{if(!i||!e.links[i.link])return!1;for(let r=e.links[i.link];r;r=r.parent)if(n.includes(r))return!0;return!1})}tick(){this.group.visible&&performance.now()>this.until&&(this.group.visible=!1)}};var _E=s=>+s.toFixed(3);function Wl(){return new URLSearchParams(location.hash.slice(1))}function mx(s,t,e){let n=new URLSearchParams,i=Wl().get("token");if(i&&n.set("token",i),e.active){let{log:r,position:o,beside:a}=e.state;n.set("log",e.fileOf(r)),n.set("t",o.toFixed(3)),a&&(n.set("with",e.fileOf(a.log)),n.set("shift",String(a.shift)))}return n.set("cam",[...s.camera.position.toArray(),...s.controls.target.toArray()].map(_E).join(",")),s.follow||n.set("follow","0"),t.open&&(n.set("plots",JSON.stringify(t.plots.map(r=>[r.title,r.names]))),n.set("window",t.seconds.value)),`${location.origin}${location.pathname}#${n.toString().replaceAll("+","%20")}`}function gx(s,t){let e=Wl(),n=(e.get("cam")??"").split(",").map(Number);n.length===6&&n.every(Number.isFinite)&&(s.camera.position.set(...n.slice(0,3)),s.controls.target.set(...n.slice(3)),s.tookIn=s.turned=!0);let i=null;try{i=JSON.parse(e.get("plots"))}catch{}if(!Array.isArray(i))return!1;for(let[r,o]of i.slice(0,3))Array.isArray(o)&&t.add(String(r),o.map(String));return e.get("window")&&(t.seconds.value=e.get("window")),!0}function xx(s){let t=Wl(),e=[],n=t.get("log");if(!n)return e;let i=s.nameOf(n);i!==s.state.log&&e.push({do:"open",log:i});let r=t.get("with");r&&e.push({do:"beside",log:s.nameOf(r),shift:Number(t.get("shift"))||0});let o=Number(t.get("t"));return t.get("t")!==null&&Number.isFinite(o)&&e.push({do:"seek",s:Math.max(0,o)}),e}var vu=class{constructor(t,e,n){this.joystick=t,this.stop=e,this.label=n,this.driving=!1,this.pressedB=!1}tick(){let t=navigator.getGamepads?.().find(i=>i?.connected&&i.mapping==="standard");this.label.hidden=!t;let e=t?.buttons[1].pressed??!1;if(e&&!this.pressedB&&this.stop(),this.pressedB=e,(t?.buttons[4].pressed??!1)&&this.joystick.enabled){this.driving||this.joystick.take(),this.driving=!0;let i=Math.abs(t.axes[0])>Math.abs(t.axes[2]);this.joystick.push(i?t.axes[0]:t.axes[2],t.axes[1],i)}else this.driving&&(this.driving=!1,this.joystick.release())}};var yE=/swiftshader|llvmpipe|softpipe|software|basic render/i;function bE(){let s=document.createElement("canvas").getContext("webgl2");if(!s)return!1;let t=s.getExtension("WEBGL_debug_renderer_info"),e=String(s.getParameter(t?t.UNMASKED_RENDERER_WEBGL:s.RENDERER));return s.getExtension("WEBGL_lose_context")?.loseContext(),yE.test(e)}var mn=!new URLSearchParams(location.hash.slice(1)).has("fine")&&bE();function Us(s){if(!mn)return new nr(s);let{roughness:t,metalness:e,...n}=s;return new $r(n)}var wu=320,Su=240,vE=mn?400:100,wE=2e3,Mu=class{constructor(t){this.box=t,this.canvas=t.querySelector("canvas"),this.image=t.querySelector("img"),this.caption=t.querySelector("figcaption"),this.canvas.width=wu,this.canvas.height=Su,this.camera=new vn(60,wu/Su,.03,40),this.cameAt=-1/0,this.drawnAt=-1/0,this.wanted=!1}toggle(t){this.wanted=t,this.box.hidden=!t}picture({image:t}){this.image.src=t,this.cameAt=performance.now()}link(t){let e=Object.keys(t?.links??{});return e.find(n=>/camera/i.test(n))??e.find(n=>/head/i.test(n))??null}tick(t,e,n){if(!this.wanted)return;let i=performance.now(),r=i-this.cameAt<wE;this.image.hidden=!r,this.canvas.hidden=r;let o=r?null:this.link(e);if(this.caption.textContent=r?"camera":o?`from ${o}, drawn`:"this robot has no camera",!o||i-this.drawnAt<vE)return;this.drawnAt=i;let a=e.links[o];a.updateWorldMatrix(!0,!1);let c=p=>new F().setFromMatrixColumn(a.matrixWorld,p);this.camera.position.setFromMatrixPosition(a.matrixWorld),this.camera.up.copy(c(2)),this.camera.lookAt(c(0).add(this.camera.position));let l=n.map(p=>p.visible);for(let p of n)p.visible=!1;let{renderer:h}=t,u=h.getPixelRatio(),d=h.getSize(new Vt),[f,g]=[Math.min(wu/u,d.x),Math.min(Su/u,d.y)];h.setViewport(0,0,f,g),h.render(t.scene,this.camera),h.setViewport(0,0,d.x,d.y),n.forEach((p,m)=>{p.visible=l[m]});let y=h.domElement;this.canvas.getContext("2d").drawImage(y,0,y.height-g*u,f*u,g*u,0,0,wu,Su)}};var SE=.7,ME=100,EE=`
  uniform mat4 onScreen[PARTS];
  uniform mat3 turned[PARTS];
  uniform vec3 tone[PARTS];
  attribute float part;
  varying vec3 shade;
  void main() {
    int i = int(part);
    vec3 n = turned[i] * normal;
    shade = tone[i] * (0.42 + 0.16 * n.z + 0.62 * max(0.0, dot(n, vec3(0.423, -0.308, 0.852))));
    gl_Position = onScreen[i] * vec4(position, 1.0);
  }`,TE=`
  uniform float cover;
  varying vec3 shade;
  void main() {
    gl_FragColor = vec4(shade, cover);
    #include <colorspace_fragment>
  }`,AE=new Gt().makeScale(0,0,0),RE=new oi(1,10,7),CE=new Ye(1,1,1,12);function PE(s){return s.type==="SphereGeometry"?RE:s.type==="CylinderGeometry"?CE:s}function IE(s){let t=s;for(;t.parent&&!t.isURDFLink&&!t.isURDFJoint&&!t.isURDFRobot;)t=t.parent;return t}var Cp=class{constructor(){this.position=[],this.normal=[],this.part=[],this.index=[]}add(t,e){let n=new Map,{position:{array:i},normal:{array:r}}=t.attributes,o=l=>Math.round(1e5*l)+65536,a=l=>{let h=3*l,u=(o(i[h])*131072+o(i[h+1]))*131072+o(i[h+2]),d=n.get(u);d||n.set(u,d=[]);let f=d.find(g=>this.alike(3*g,i,r,h));f===void 0&&(f=this.part.length,d.push(f),this.position.push(i[h],i[h+1],i[h+2]),this.normal.push(0,0,0),this.part.push(e+.5));for(let g=0;g<3;++g)this.normal[3*f+g]+=r[h+g];return f},c=t.index?.count??i.length/3;for(let l=0;l<c;++l)this.index.push(a(t.index?t.index.getX(l):l))}alike(t,e,n,i){let{position:r,normal:o}=this;return Math.abs(r[t]-e[i])+Math.abs(r[t+1]-e[i+1])+Math.abs(r[t+2]-e[i+2])>.001?!1:o[t]*n[i]+o[t+1]*n[i+1]+o[t+2]*n[i+2]>SE*Math.hypot(o[t],o[t+1],o[t+2])}geometry(){for(let e=0;e<this.normal.length;e+=3){let n=Math.hypot(this.normal[e],this.normal[e+1],this.normal[e+2])||1;for(let i=0;i<3;++i)this.normal[e+i]/=n}let t=new ue;return t.setAttribute("position",new Xt(this.position,3)),t.setAttribute("normal",new Xt(this.normal,3)),t.setAttribute("part",new Xt(this.part,1)),t.setIndex(this.index),t}},Eu={of:"",geometry:null};function LE(s,t){let e=s.map(i=>i.geometry.uuid).join();if(Eu.of===e)return Eu.geometry;let n=new Cp;return s.forEach((i,r)=>{let o=PE(i.geometry).clone();o.attributes.normal||o.computeVertexNormals(),o.applyMatrix4(t[r].matrixWorld.clone().invert().multiply(i.matrixWorld)),n.add(o,r)}),Eu={of:e,geometry:n.geometry()},Eu.geometry}function Tu(s,{depthWrite:t=!0}={}){let e=[];if(s.traverse(h=>{h.isMesh&&e.push(h)}),e.length===0||e.length>ME)return;s.updateMatrixWorld(!0);let n=e.map(IE),i=e.map(()=>new Gt),r=e.map(()=>new ie),o=e.map(()=>new F),a=new F,c=new Gt,l=new gt(LE(e,n),new Zi({defines:{PARTS:e.length},vertexShader:EE,fragmentShader:TE,depthWrite:t,uniforms:{onScreen:{value:i},turned:{value:r},tone:{value:o},cover:{value:1}}}));l.drawsAll=!0,l.frustumCulled=!1,l.onBeforeRender=(h,u,d)=>{c.multiplyMatrices(d.projectionMatrix,d.matrixWorldInverse),e.forEach(({material:{color:g,emissive:y,emissiveIntensity:p}},m)=>{e[m].visible?i[m].multiplyMatrices(c,n[m].matrixWorld):i[m].copy(AE),r[m].setFromMatrix4(n[m].matrixWorld),o[m].set(g.r,g.g,g.b),y&&o[m].add(a.set(y.r,y.g,y.b).multiplyScalar(p))});let f=e[0].material;l.material.transparent=f.transparent,l.material.uniforms.cover.value=f.opacity,l.material.uniformsNeedUpdate=!0};for(let h of e)h.layers.disableAll();s.add(l)}var ya=class{constructor(t,e){this.scene=t,this.made=null,this.wanted=!1,this.material=Us({color:e,emissive:e,emissiveIntensity:.25,transparent:!0,opacity:.34,depthWrite:!1,roughness:.6})}adopt(t,e){this.made&&this.scene.remove(this.made),this.made=null,this.pattern=t,this.names=e}get model(){return!this.made&&this.pattern&&this.make(),this.made}make(){let t=this.made=this.pattern.clone();t.visible=!1,t.traverse(e=>{e.isMesh&&(e.material=this.material,e.castShadow=e.receiveShadow=!1)}),this.joints=this.names.map(e=>t.joints[e]??null);for(let e of this.joints)e&&(e.ignoreLimits=!0);mn&&Tu(t,{depthWrite:!1}),this.scene.add(t)}pose(t,e){let n=this.wanted&&t!=null;this.made&&(this.made.visible=n),!(!n||!this.model)&&(this.model.visible=!0,this.model.position.set(e[0],e[1],e[2]),this.model.quaternion.set(e[4],e[5],e[6],e[3]),t.forEach((i,r)=>this.joints[r]?.setJointValue(i??0)))}};var lo=new to,wn=new F,Nr=new F,cn=new ve,_x={X:new F(1,0,0),Y:new F(0,1,0),Z:new F(0,0,1)},Pp={type:"change"},yx={type:"mouseDown",mode:null},bx={type:"mouseUp",mode:null},vx={type:"objectChange"},Iu=class extends eo{constructor(t,e=null){super(void 0,e);let n=new Lp(this);this._root=n;let i=new Np;this._gizmo=i,n.add(i);let r=new Dp;this._plane=r,n.add(r);let o=this;function a(v,_){let E=_;Object.defineProperty(o,v,{get:function(){return E!==void 0?E:_},set:function(w){E!==w&&(E=w,r[v]=w,i[v]=w,o.dispatchEvent({type:v+"-changed",value:w}),o.dispatchEvent(Pp))}}),o[v]=_,r[v]=_,i[v]=_}a("camera",t),a("object",void 0),a("enabled",!0),a("axis",null),a("mode","translate"),a("translationSnap",null),a("rotationSnap",null),a("scaleSnap",null),a("space","world"),a("size",1),this.viewport=null,a("dragging",!1),a("showX",!0),a("showY",!0),a("showZ",!0),a("showXY",!0),a("showYZ",!0),a("showXZ",!0),a("showXYZE",!0),a("showE",!0),a("minX",-1/0),a("maxX",1/0),a("minY",-1/0),a("maxY",1/0),a("minZ",-1/0),a("maxZ",1/0);let c=new F,l=new F,h=new ve,u=new ve,d=new F,f=new ve,g=new F,y=new F,p=new F,m=0,x=new F;a("worldPosition",c),a("worldPositionStart",l),a("worldQuaternion",h),a("worldQuaternionStart",u),a("cameraPosition",d),a("cameraQuaternion",f),a("pointStart",g),a("pointEnd",y),a("rotationAxis",p),a("rotationAngle",m),a("eye",x),this._offset=new F,this._startNorm=new F,this._endNorm=new F,this._cameraScale=new F,this._parentPosition=new F,this._parentQuaternion=new ve,this._parentQuaternionInv=new ve,this._parentScale=new F,this._worldScaleStart=new F,this._worldQuaternionInv=new ve,this._worldScale=new F,this._positionStart=new F,this._quaternionStart=new ve,this._scaleStart=new F,this._getPointer=NE.bind(this),this._onPointerDown=UE.bind(this),this._onPointerHover=DE.bind(this),this._onPointerMove=FE.bind(this),this._onPointerUp=kE.bind(this),e!==null&&this.connect(e)}connect(t){super.connect(t),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointermove",this._onPointerHover),this.domElement.addEventListener("pointerup",this._onPointerUp),this.domElement.style.touchAction="none"}disconnect(){this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.removeEventListener("pointermove",this._onPointerHover),this.domElement.removeEventListener("pointermove",this._onPointerMove),this.domElement.removeEventListener("pointerup",this._onPointerUp),this.domElement.style.touchAction=""}getHelper(){return this._root}pointerHover(t){if(this.object===void 0||this.dragging===!0)return;t!==null&&lo.setFromCamera(t,this.camera);let e=Ip(this._gizmo.picker[this.mode],lo);e?this.axis=e.object.name:this.axis=null}pointerDown(t){if(!(this.object===void 0||this.dragging===!0||t!=null&&t.button!==0)&&this.axis!==null){t!==null&&lo.setFromCamera(t,this.camera);let e=Ip(this._plane,lo,!0);e&&(this.object.updateMatrixWorld(),this.object.parent.updateMatrixWorld(),this._positionStart.copy(this.object.position),this._quaternionStart.copy(this.object.quaternion),this._scaleStart.copy(this.object.scale),this.object.matrixWorld.decompose(this.worldPositionStart,this.worldQuaternionStart,this._worldScaleStart),this.pointStart.copy(e.point).sub(this.worldPositionStart)),this.dragging=!0,yx.mode=this.mode,this.dispatchEvent(yx)}}pointerMove(t){let e=this.axis,n=this.mode,i=this.object,r=this.space;if(n==="scale"?r="local":(e==="E"||e==="XYZE"||e==="XYZ")&&(r="world"),i===void 0||e===null||this.dragging===!1||t!==null&&t.button!==-1)return;t!==null&&lo.setFromCamera(t,this.camera);let o=Ip(this._plane,lo,!0);if(o){if(this.pointEnd.copy(o.point).sub(this.worldPositionStart),n==="translate")this._offset.copy(this.pointEnd).sub(this.pointStart),r==="local"&&e!=="XYZ"&&this._offset.applyQuaternion(this._worldQuaternionInv),e.indexOf("X")===-1&&(this._offset.x=0),e.indexOf("Y")===-1&&(this._offset.y=0),e.indexOf("Z")===-1&&(this._offset.z=0),r==="local"&&e!=="XYZ"?this._offset.applyQuaternion(this._quaternionStart).divide(this._parentScale):this._offset.applyQuaternion(this._parentQuaternionInv).divide(this._parentScale),i.position.copy(this._offset).add(this._positionStart),this.translationSnap&&(r==="local"&&(i.position.applyQuaternion(cn.copy(this._quaternionStart).invert()),e.search("X")!==-1&&(i.position.x=Math.round(i.position.x/this.translationSnap)*this.translationSnap),e.search("Y")!==-1&&(i.position.y=Math.round(i.position.y/this.translationSnap)*this.translationSnap),e.search("Z")!==-1&&(i.position.z=Math.round(i.position.z/this.translationSnap)*this.translationSnap),i.position.applyQuaternion(this._quaternionStart)),r==="world"&&(i.getWorldPosition(wn),e.search("X")!==-1&&(wn.x=Math.round(wn.x/this.translationSnap)*this.translationSnap),e.search("Y")!==-1&&(wn.y=Math.round(wn.y/this.translationSnap)*this.translationSnap),e.search("Z")!==-1&&(wn.z=Math.round(wn.z/this.translationSnap)*this.translationSnap),i.position.copy(i.parent.worldToLocal(wn)))),i.position.x=Math.max(this.minX,Math.min(this.maxX,i.position.x)),i.position.y=Math.max(this.minY,Math.min(this.maxY,i.position.y)),i.position.z=Math.max(this.minZ,Math.min(this.maxZ,i.position.z));else if(n==="scale"){if(e.search("XYZ")!==-1){let a=this.pointEnd.length()/this.pointStart.length();this.pointEnd.dot(this.pointStart)<0&&(a*=-1),Nr.set(a,a,a)}else wn.copy(this.pointStart),Nr.copy(this.pointEnd),wn.applyQuaternion(this._worldQuaternionInv),Nr.applyQuaternion(this._worldQuaternionInv),Nr.divide(wn),e.search("X")===-1&&(Nr.x=1),e.search("Y")===-1&&(Nr.y=1),e.search("Z")===-1&&(Nr.z=1);i.scale.copy(this._scaleStart).multiply(Nr),this.scaleSnap&&(e.search("X")!==-1&&(i.scale.x=Math.round(i.scale.x/this.scaleSnap)*this.scaleSnap||this.scaleSnap),e.search("Y")!==-1&&(i.scale.y=Math.round(i.scale.y/this.scaleSnap)*this.scaleSnap||this.scaleSnap),e.search("Z")!==-1&&(i.scale.z=Math.round(i.scale.z/this.scaleSnap)*this.scaleSnap||this.scaleSnap))}else if(n==="rotate"){this._offset.copy(this.pointEnd).sub(this.pointStart);let a=20/this.worldPosition.distanceTo(wn.setFromMatrixPosition(this.camera.matrixWorld)),c=!1;e==="XYZE"?(this.rotationAxis.copy(this._offset).cross(this.eye).normalize(),this.rotationAngle=this._offset.dot(wn.copy(this.rotationAxis).cross(this.eye))*a):(e==="X"||e==="Y"||e==="Z")&&(this.rotationAxis.copy(_x[e]),wn.copy(_x[e]),r==="local"&&wn.applyQuaternion(this.worldQuaternion),wn.cross(this.eye),wn.length()===0?c=!0:this.rotationAngle=this._offset.dot(wn.normalize())*a),(e==="E"||c)&&(this.rotationAxis.copy(this.eye),this.rotationAngle=this.pointEnd.angleTo(this.pointStart),this._startNorm.copy(this.pointStart).normalize(),this._endNorm.copy(this.pointEnd).normalize(),this.rotationAngle*=this._endNorm.cross(this._startNorm).dot(this.eye)<0?1:-1),this.rotationSnap&&(this.rotationAngle=Math.round(this.rotationAngle/this.rotationSnap)*this.rotationSnap),r==="local"&&e!=="E"&&e!=="XYZE"?(i.quaternion.copy(this._quaternionStart),i.quaternion.multiply(cn.setFromAxisAngle(this.rotationAxis,this.rotationAngle)).normalize()):(this.rotationAxis.applyQuaternion(this._parentQuaternionInv),i.quaternion.copy(cn.setFromAxisAngle(this.rotationAxis,this.rotationAngle)),i.quaternion.multiply(this._quaternionStart).normalize())}this.dispatchEvent(Pp),this.dispatchEvent(vx)}}pointerUp(t){t!==null&&t.button!==0||(this.dragging&&this.axis!==null&&(bx.mode=this.mode,this.dispatchEvent(bx)),this.dragging=!1,this.axis=null)}dispose(){this.disconnect(),this._root.dispose()}attach(t){return this.object=t,this._root.visible=!0,this}detach(){return this.object=void 0,this.axis=null,this._root.visible=!1,this}reset(){this.enabled&&this.dragging&&(this.object.position.copy(this._positionStart),this.object.quaternion.copy(this._quaternionStart),this.object.scale.copy(this._scaleStart),this.dispatchEvent(Pp),this.dispatchEvent(vx),this.pointStart.copy(this.pointEnd))}getRaycaster(){return lo}getMode(){return this.mode}setMode(t){this.mode=t}setTranslationSnap(t){this.translationSnap=t}setRotationSnap(t){this.rotationSnap=t}setScaleSnap(t){this.scaleSnap=t}setSize(t){this.size=t}setSpace(t){this.space=t}setColors(t,e,n,i){let r=this._gizmo.materialLib;r.xAxis.color.set(t),r.yAxis.color.set(e),r.zAxis.color.set(n),r.active.color.set(i),r.xAxisTransparent.color.set(t),r.yAxisTransparent.color.set(e),r.zAxisTransparent.color.set(n),r.activeTransparent.color.set(i),r.xAxis._color&&r.xAxis._color.set(t),r.yAxis._color&&r.yAxis._color.set(e),r.zAxis._color&&r.zAxis._color.set(n),r.active._color&&r.active._color.set(i),r.xAxisTransparent._color&&r.xAxisTransparent._color.set(t),r.yAxisTransparent._color&&r.yAxisTransparent._color.set(e),r.zAxisTransparent._color&&r.zAxisTransparent._color.set(n),r.activeTransparent._color&&r.activeTransparent._color.set(i)}};function NE(s){if(this.domElement.ownerDocument.pointerLockElement)return{x:0,y:0,button:s.button};{let t=this.domElement.getBoundingClientRect(),e=this.viewport,n,i,r,o;return e!==null?(n=e.x,i=t.height-e.y-e.w,r=e.z,o=e.w):(n=0,i=0,r=t.width,o=t.height),{x:(s.clientX-t.left-n)/r*2-1,y:-(s.clientY-t.top-i)/o*2+1,button:s.button}}}function DE(s){if(this.enabled)switch(s.pointerType){case"mouse":case"pen":this.pointerHover(this._getPointer(s));break}}function UE(s){this.enabled&&(document.pointerLockElement||this.domElement.setPointerCapture(s.pointerId),this.domElement.addEventListener("pointermove",this._onPointerMove),this.pointerHover(this._getPointer(s)),this.pointerDown(this._getPointer(s)))}function FE(s){this.enabled&&this.pointerMove(this._getPointer(s))}function kE(s){this.enabled&&(this.domElement.releasePointerCapture(s.pointerId),this.domElement.removeEventListener("pointermove",this._onPointerMove),this.pointerUp(this._getPointer(s)))}function Ip(s,t,e){let n=t.intersectObject(s,!0);for(let i=0;i<n.length;i++)if(n[i].object.visible||e)return n[i];return!1}var Au=new ti,je=new F(0,1,0),wx=new F(0,0,0),Sx=new Gt,Ru=new ve,Pu=new ve,Fs=new F,Lu=new Gt,Yl=new F(1,0,0),co=new F(0,1,0),jl=new F(0,0,1),Cu=new F,Xl=new F,ql=new F,Lp=class extends De{constructor(t){super(),this.isTransformControlsRoot=!0,this.controls=t,this.visible=!1}updateMatrixWorld(t){let e=this.controls;e.object!==void 0&&(e.object.updateMatrixWorld(),e.object.parent===null?console.error("TransformControls: The attached 3D object must be a part of the scene graph."):e.object.parent.matrixWorld.decompose(e._parentPosition,e._parentQuaternion,e._parentScale),e.object.matrixWorld.decompose(e.worldPosition,e.worldQuaternion,e._worldScale),e._parentQuaternionInv.copy(e._parentQuaternion).invert(),e._worldQuaternionInv.copy(e.worldQuaternion).invert()),e.camera.updateMatrixWorld(),e.camera.matrixWorld.decompose(e.cameraPosition,e.cameraQuaternion,e._cameraScale),e.camera.isOrthographicCamera?e.camera.getWorldDirection(e.eye).negate():e.eye.copy(e.cameraPosition).sub(e.worldPosition).normalize(),this.parent&&(Lu.copy(this.parent.matrixWorld).invert(),Lu.decompose(this.position,this.quaternion,this.scale)),super.updateMatrixWorld(t)}dispose(){this.traverse(function(t){t.geometry&&t.geometry.dispose(),t.material&&t.material.dispose()})}},Np=class extends De{constructor(){super(),this.isTransformControlsGizmo=!0,this.type="TransformControlsGizmo";let t=new Qe({depthTest:!1,depthWrite:!1,fog:!1,toneMapped:!1,transparent:!0}),e=new pn({depthTest:!1,depthWrite:!1,fog:!1,toneMapped:!1,transparent:!0}),n=t.clone();n.opacity=.15;let i=e.clone();i.opacity=.5;let r=t.clone();r.color.setHex(16711680);let o=t.clone();o.color.setHex(65280);let a=t.clone();a.color.setHex(255);let c=t.clone();c.color.setHex(16711680),c.opacity=.5;let l=t.clone();l.color.setHex(65280),l.opacity=.5;let h=t.clone();h.color.setHex(255),h.opacity=.5;let u=t.clone();u.opacity=.25;let d=t.clone();d.color.setHex(16776960),d.opacity=.25;let f=t.clone();f.color.setHex(16776960);let g=t.clone();g.color.setHex(7895160),this.materialLib={xAxis:r,yAxis:o,zAxis:a,active:f,xAxisTransparent:c,yAxisTransparent:l,zAxisTransparent:h,activeTransparent:d};let y=new Ye(0,.04,.1,12);y.translate(0,.05,0);let p=new qe(.08,.08,.08);p.translate(0,.04,0);let m=new ue;m.setAttribute("position",new Xt([0,0,0,1,0,0],3));let x=new Ye(.0075,.0075,.5,3);x.translate(0,.25,0);function v(z,O){let H=new er(z,.0075,3,64,O*Math.PI*2);return H.rotateY(Math.PI/2),H.rotateX(Math.PI/2),H}function _(){let z=new ue;return z.setAttribute("position",new Xt([0,0,0,1,1,1],3)),z}let E={X:[[new gt(y,r),[.5,0,0],[0,0,-Math.PI/2]],[new gt(y,r),[-.5,0,0],[0,0,Math.PI/2]],[new gt(x,r),[0,0,0],[0,0,-Math.PI/2]]],Y:[[new gt(y,o),[0,.5,0]],[new gt(y,o),[0,-.5,0],[Math.PI,0,0]],[new gt(x,o)]],Z:[[new gt(y,a),[0,0,.5],[Math.PI/2,0,0]],[new gt(y,a),[0,0,-.5],[-Math.PI/2,0,0]],[new gt(x,a),null,[Math.PI/2,0,0]]],XYZ:[[new gt(new Er(.1,0),u),[0,0,0]]],XY:[[new gt(new qe(.15,.15,.01),h),[.15,.15,0]]],YZ:[[new gt(new qe(.15,.15,.01),c),[0,.15,.15],[0,Math.PI/2,0]]],XZ:[[new gt(new qe(.15,.15,.01),l),[.15,0,.15],[-Math.PI/2,0,0]]]},w={X:[[new gt(new Ye(.2,0,.6,4),n),[.3,0,0],[0,0,-Math.PI/2]],[new gt(new Ye(.2,0,.6,4),n),[-.3,0,0],[0,0,Math.PI/2]]],Y:[[new gt(new Ye(.2,0,.6,4),n),[0,.3,0]],[new gt(new Ye(.2,0,.6,4),n),[0,-.3,0],[0,0,Math.PI]]],Z:[[new gt(new Ye(.2,0,.6,4),n),[0,0,.3],[Math.PI/2,0,0]],[new gt(new Ye(.2,0,.6,4),n),[0,0,-.3],[-Math.PI/2,0,0]]],XYZ:[[new gt(new Er(.2,0),n)]],XY:[[new gt(new qe(.2,.2,.01),n),[.15,.15,0]]],YZ:[[new gt(new qe(.2,.2,.01),n),[0,.15,.15],[0,Math.PI/2,0]]],XZ:[[new gt(new qe(.2,.2,.01),n),[.15,0,.15],[-Math.PI/2,0,0]]]},b={START:[[new gt(new Er(.01,2),i),null,null,null,"helper"]],END:[[new gt(new Er(.01,2),i),null,null,null,"helper"]],DELTA:[[new Fn(_(),i),null,null,null,"helper"]],X:[[new Fn(m,i),[-1e3,0,0],null,[1e6,1,1],"helper"]],Y:[[new Fn(m,i),[0,-1e3,0],[0,0,Math.PI/2],[1e6,1,1],"helper"]],Z:[[new Fn(m,i),[0,0,-1e3],[0,-Math.PI/2,0],[1e6,1,1],"helper"]]},M={XYZE:[[new gt(v(.5,1),g),null,[0,Math.PI/2,0]]],X:[[new gt(v(.5,.5),r)]],Y:[[new gt(v(.5,.5),o),null,[0,0,-Math.PI/2]]],Z:[[new gt(v(.5,.5),a),null,[0,Math.PI/2,0]]],E:[[new gt(v(.75,1),d),null,[0,Math.PI/2,0]]]},I={AXIS:[[new Fn(m,i),[-1e3,0,0],null,[1e6,1,1],"helper"]]},P={XYZE:[[new gt(new oi(.25,10,8),n)]],X:[[new gt(new er(.5,.1,4,24),n),[0,0,0],[0,-Math.PI/2,-Math.PI/2]]],Y:[[new gt(new er(.5,.1,4,24),n),[0,0,0],[Math.PI/2,0,0]]],Z:[[new gt(new er(.5,.1,4,24),n),[0,0,0],[0,0,-Math.PI/2]]],E:[[new gt(new er(.75,.1,2,24),n)]]},C={X:[[new gt(p,r),[.5,0,0],[0,0,-Math.PI/2]],[new gt(x,r),[0,0,0],[0,0,-Math.PI/2]],[new gt(p,r),[-.5,0,0],[0,0,Math.PI/2]]],Y:[[new gt(p,o),[0,.5,0]],[new gt(x,o)],[new gt(p,o),[0,-.5,0],[0,0,Math.PI]]],Z:[[new gt(p,a),[0,0,.5],[Math.PI/2,0,0]],[new gt(x,a),[0,0,0],[Math.PI/2,0,0]],[new gt(p,a),[0,0,-.5],[-Math.PI/2,0,0]]],XY:[[new gt(new qe(.15,.15,.01),h),[.15,.15,0]]],YZ:[[new gt(new qe(.15,.15,.01),c),[0,.15,.15],[0,Math.PI/2,0]]],XZ:[[new gt(new qe(.15,.15,.01),l),[.15,0,.15],[-Math.PI/2,0,0]]],XYZ:[[new gt(new qe(.1,.1,.1),u)]]},D={X:[[new gt(new Ye(.2,0,.6,4),n),[.3,0,0],[0,0,-Math.PI/2]],[new gt(new Ye(.2,0,.6,4),n),[-.3,0,0],[0,0,Math.PI/2]]],Y:[[new gt(new Ye(.2,0,.6,4),n),[0,.3,0]],[new gt(new Ye(.2,0,.6,4),n),[0,-.3,0],[0,0,Math.PI]]],Z:[[new gt(new Ye(.2,0,.6,4),n),[0,0,.3],[Math.PI/2,0,0]],[new gt(new Ye(.2,0,.6,4),n),[0,0,-.3],[-Math.PI/2,0,0]]],XY:[[new gt(new qe(.2,.2,.01),n),[.15,.15,0]]],YZ:[[new gt(new qe(.2,.2,.01),n),[0,.15,.15],[0,Math.PI/2,0]]],XZ:[[new gt(new qe(.2,.2,.01),n),[.15,0,.15],[-Math.PI/2,0,0]]],XYZ:[[new gt(new qe(.2,.2,.2),n),[0,0,0]]]},B={X:[[new Fn(m,i),[-1e3,0,0],null,[1e6,1,1],"helper"]],Y:[[new Fn(m,i),[0,-1e3,0],[0,0,Math.PI/2],[1e6,1,1],"helper"]],Z:[[new Fn(m,i),[0,0,-1e3],[0,-Math.PI/2,0],[1e6,1,1],"helper"]]};function L(z){let O=new De;for(let H in z)for(let tt=z[H].length;tt--;){let X=z[H][tt][0].clone(),Z=z[H][tt][1],$=z[H][tt][2],at=z[H][tt][3],it=z[H][tt][4];X.name=H,X.tag=it,Z&&X.position.set(Z[0],Z[1],Z[2]),$&&X.rotation.set($[0],$[1],$[2]),at&&X.scale.set(at[0],at[1],at[2]),X.updateMatrix();let Y=X.geometry.clone();Y.applyMatrix4(X.matrix),X.geometry=Y,X.renderOrder=1/0,X.position.set(0,0,0),X.rotation.set(0,0,0),X.scale.set(1,1,1),O.add(X)}return O}this.gizmo={},this.picker={},this.helper={},this.add(this.gizmo.translate=L(E)),this.add(this.gizmo.rotate=L(M)),this.add(this.gizmo.scale=L(C)),this.add(this.picker.translate=L(w)),this.add(this.picker.rotate=L(P)),this.add(this.picker.scale=L(D)),this.add(this.helper.translate=L(b)),this.add(this.helper.rotate=L(I)),this.add(this.helper.scale=L(B)),this.picker.translate.visible=!1,this.picker.rotate.visible=!1,this.picker.scale.visible=!1}updateMatrixWorld(t){let n=(this.mode==="scale"?"local":this.space)==="local"?this.worldQuaternion:Pu;this.gizmo.translate.visible=this.mode==="translate",this.gizmo.rotate.visible=this.mode==="rotate",this.gizmo.scale.visible=this.mode==="scale",this.helper.translate.visible=this.mode==="translate",this.helper.rotate.visible=this.mode==="rotate",this.helper.scale.visible=this.mode==="scale";let i=[];i=i.concat(this.picker[this.mode].children),i=i.concat(this.gizmo[this.mode].children),i=i.concat(this.helper[this.mode].children);for(let r=0;r<i.length;r++){let o=i[r];o.visible=!0,o.rotation.set(0,0,0),o.position.copy(this.worldPosition);let a;if(this.camera.isOrthographicCamera?a=(this.camera.top-this.camera.bottom)/this.camera.zoom:a=this.worldPosition.distanceTo(this.cameraPosition)*Math.min(1.9*Math.tan(Math.PI*this.camera.fov/360)/this.camera.zoom,7),o.scale.set(1,1,1).multiplyScalar(a*this.size/4),o.tag==="helper"){o.visible=!1,o.name==="AXIS"?(o.visible=!!this.axis,this.axis==="X"&&(cn.setFromEuler(Au.set(0,0,0)),o.quaternion.copy(n).multiply(cn),Math.abs(je.copy(Yl).applyQuaternion(n).dot(this.eye))>.9&&(o.visible=!1)),this.axis==="Y"&&(cn.setFromEuler(Au.set(0,0,Math.PI/2)),o.quaternion.copy(n).multiply(cn),Math.abs(je.copy(co).applyQuaternion(n).dot(this.eye))>.9&&(o.visible=!1)),this.axis==="Z"&&(cn.setFromEuler(Au.set(0,Math.PI/2,0)),o.quaternion.copy(n).multiply(cn),Math.abs(je.copy(jl).applyQuaternion(n).dot(this.eye))>.9&&(o.visible=!1)),this.axis==="XYZE"&&(cn.setFromEuler(Au.set(0,Math.PI/2,0)),je.copy(this.rotationAxis),o.quaternion.setFromRotationMatrix(Sx.lookAt(wx,je,co)),o.quaternion.multiply(cn),o.visible=this.dragging),this.axis==="E"&&(o.visible=!1)):o.name==="START"?(o.position.copy(this.worldPositionStart),o.visible=this.dragging):o.name==="END"?(o.position.copy(this.worldPosition),o.visible=this.dragging):o.name==="DELTA"?(o.position.copy(this.worldPositionStart),o.quaternion.copy(this.worldQuaternionStart),wn.set(1e-10,1e-10,1e-10).add(this.worldPositionStart).sub(this.worldPosition).multiplyScalar(-1),wn.applyQuaternion(this.worldQuaternionStart.clone().invert()),o.scale.copy(wn),o.visible=this.dragging):(o.quaternion.copy(n),this.dragging?o.position.copy(this.worldPositionStart):o.position.copy(this.worldPosition),this.axis&&(o.visible=this.axis.search(o.name)!==-1));continue}o.quaternion.copy(n),this.mode==="translate"||this.mode==="scale"?(o.name==="X"&&Math.abs(je.copy(Yl).applyQuaternion(n).dot(this.eye))>.99&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1),o.name==="Y"&&Math.abs(je.copy(co).applyQuaternion(n).dot(this.eye))>.99&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1),o.name==="Z"&&Math.abs(je.copy(jl).applyQuaternion(n).dot(this.eye))>.99&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1),o.name==="XY"&&Math.abs(je.copy(jl).applyQuaternion(n).dot(this.eye))<.2&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1),o.name==="YZ"&&Math.abs(je.copy(Yl).applyQuaternion(n).dot(this.eye))<.2&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1),o.name==="XZ"&&Math.abs(je.copy(co).applyQuaternion(n).dot(this.eye))<.2&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1)):this.mode==="rotate"&&(Ru.copy(n),je.copy(this.eye).applyQuaternion(cn.copy(n).invert()),o.name.search("E")!==-1&&o.quaternion.setFromRotationMatrix(Sx.lookAt(this.eye,wx,co)),o.name==="X"&&(cn.setFromAxisAngle(Yl,Math.atan2(-je.y,je.z)),cn.multiplyQuaternions(Ru,cn),o.quaternion.copy(cn)),o.name==="Y"&&(cn.setFromAxisAngle(co,Math.atan2(je.x,je.z)),cn.multiplyQuaternions(Ru,cn),o.quaternion.copy(cn)),o.name==="Z"&&(cn.setFromAxisAngle(jl,Math.atan2(je.y,je.x)),cn.multiplyQuaternions(Ru,cn),o.quaternion.copy(cn))),o.visible=o.visible&&(o.name.indexOf("X")===-1||this.showX),o.visible=o.visible&&(o.name.indexOf("Y")===-1||this.showY),o.visible=o.visible&&(o.name.indexOf("Z")===-1||this.showZ),o.visible=o.visible&&(o.name.indexOf("E")===-1||this.showX&&this.showY&&this.showZ),o.visible=o.visible&&(o.name.indexOf("XY")===-1||this.showXY),o.visible=o.visible&&(o.name.indexOf("YZ")===-1||this.showYZ),o.visible=o.visible&&(o.name.indexOf("XZ")===-1||this.showXZ),o.visible=o.visible&&(o.name!=="E"||this.showE),o.visible=o.visible&&(o.name!=="XYZE"||this.showXYZE),o.material._color=o.material._color||o.material.color.clone(),o.material._opacity=o.material._opacity||o.material.opacity,o.material.color.copy(o.material._color),o.material.opacity=o.material._opacity,this.enabled&&this.axis&&(o.name===this.axis?(o.material.color.copy(this.materialLib.active.color),o.material.opacity=1):this.axis.split("").some(function(c){return o.name===c})&&(o.material.color.copy(this.materialLib.active.color),o.material.opacity=1))}super.updateMatrixWorld(t)}},Dp=class extends gt{constructor(){super(new Qs(1e5,1e5,2,2),new Qe({visible:!1,wireframe:!0,side:ci,transparent:!0,opacity:.1,toneMapped:!1})),this.isTransformControlsPlane=!0,this.type="TransformControlsPlane"}updateMatrixWorld(t){let e=this.space;switch(this.position.copy(this.worldPosition),this.mode==="scale"&&(e="local"),Cu.copy(Yl).applyQuaternion(e==="local"?this.worldQuaternion:Pu),Xl.copy(co).applyQuaternion(e==="local"?this.worldQuaternion:Pu),ql.copy(jl).applyQuaternion(e==="local"?this.worldQuaternion:Pu),je.copy(Xl),this.mode){case"translate":case"scale":switch(this.axis){case"X":je.copy(this.eye).cross(Cu),Fs.copy(Cu).cross(je);break;case"Y":je.copy(this.eye).cross(Xl),Fs.copy(Xl).cross(je);break;case"Z":je.copy(this.eye).cross(ql),Fs.copy(ql).cross(je);break;case"XY":Fs.copy(ql);break;case"YZ":Fs.copy(Cu);break;case"XZ":je.copy(ql),Fs.copy(Xl);break;case"XYZ":case"E":Fs.set(0,0,0);break}break;default:Fs.set(0,0,0)}Fs.length()===0?this.quaternion.copy(this.cameraQuaternion):(Lu.lookAt(wn.set(0,0,0),Fs,je),this.quaternion.setFromRotationMatrix(Lu)),super.updateMatrixWorld(t)}};var Nu=class{constructor(t,e,n){this.stage=t,this.canvas=e,this.reach=n,this.side=null}make(){let{stage:t,canvas:e,reach:n}=this;this.ball=new gt(new oi(.03,24,16),Us({color:8189392,emissive:2072184,transparent:!0,opacity:.85,depthTest:!1})),this.ball.renderOrder=13,this.ball.visible=!1,this.handles=new Iu(t.camera,e),this.handles.setSize(.75),this.handles.attach(this.ball),this.handles.enabled=!1,this.helper=this.handles.getHelper(),this.helper.visible=!1,t.scene.add(this.ball,this.helper),this.handles.addEventListener("dragging-changed",i=>{t.controls.enabled=!i.value,!i.value&&this.side&&n(this.side,this.ball.position.toArray().map(r=>+r.toFixed(4)))})}offer(t,e){let n=e?.[t==="left"?0:1];return this.ball||this.make(),this.side=this.side===t||!n?null:t,this.side&&this.ball.position.set(...n),this.ball.visible=this.helper.visible=this.handles.enabled=this.side!==null,this.side!==null}};var Mx={abs:Math.abs,sqrt:Math.sqrt};function OE(s){let t=s.match(/[A-Za-z_][\w.]*|\d+\.?\d*(?:e-?\d+)?|[-+*/()]|\S/g)??[];if(t.some(e=>!/^([A-Za-z_][\w.]*|\d.*|[-+*/()])$/.test(e)))throw new Error("only names, numbers, + - * / and brackets");return t}function Du(s,t){let e=OE(s.replace(/^=/,"")),n=u=>{if(!t.columns.has(u))throw new Error(`nothing called ${u} was heard`);return d=>t.pick(u,d)},i=(u,d,f)=>g=>{let[y,p]=[u(g),d(g)];return y.map((m,x)=>m===null||p[x]===null||!Number.isFinite(f(m,p[x]))?null:f(m,p[x]))},r=u=>d=>{let f=u(d);return f.map((g,y)=>{let p=y===0?0:t.time[d[y]]-t.time[d[y-1]];return g===null||!(p>0)||f[y-1]===null?null:(g-f[y-1])/p})},o=()=>{let u=e.shift();if(u===void 0)throw new Error("something is missing at the end");if(u==="-"){let d=o();return f=>d(f).map(g=>g===null?null:-g)}if(u==="("){let d=l();return a(),d}if(/^\d/.test(u))return d=>d.map(()=>Number(u));if(e[0]==="("&&(u==="d"||Mx[u])){e.shift();let d=l();return a(),u==="d"?r(d):i(d,f=>f.map(()=>0),f=>Mx[u](f))}if(!/^[A-Za-z_]/.test(u))throw new Error(`a name or number was to stand where ${u} is`);return n(u)},a=()=>{if(e.shift()!==")")throw new Error("a bracket is not closed")},c=()=>{let u=o();for(;e[0]==="*"||e[0]==="/";)u=e.shift()==="*"?i(u,o(),(d,f)=>d*f):i(u,o(),(d,f)=>d/f);return u},l=()=>{let u=c();for(;e[0]==="+"||e[0]==="-";)u=e.shift()==="+"?i(u,c(),(d,f)=>d+f):i(u,c(),(d,f)=>d-f);return u},h=l();if(e.length>0)throw new Error(`${e[0]} is one too many`);return h}var ba=3600,Ex=1800,BE={2:["x","y"],3:["x","y","z"],4:["w","x","y","z"],6:["fx","fy","fz","tx","ty","tz"]},Uu=class{constructor(){this.joints=[],this.clear()}clear(){this.count=0,this.last=-1/0,this.time=new Float64Array(ba),this.pictures=new Array(Ex),this.columns=new Map,this.trees=new Map}add(t,e,n){if(t===this.last||t==null)return;t<this.last&&this.clear(),this.last=t;let i=this.count++%ba;for(let r of this.columns.values())r[i]=NaN;this.time[i]=t,this.pictures[(this.count-1)%Ex]={time:t,live:n};for(let[r,o]of Object.entries(e)){if(o==null)continue;let a=this.trees.get(r);a||this.trees.set(r,a={name:r,children:new Map,column:null}),this.put(a,o,i)}}put(t,e,n){if(e!=null)if(typeof e=="object")for(let i in e){let r=t.children.get(i);r||t.children.set(i,r={name:`${t.name}.${this.label(i,e)}`,children:new Map,column:null}),this.put(r,e[i],n)}else typeof e!="string"&&(t.column||this.columns.set(t.name,t.column=new Float64Array(ba).fill(NaN)),t.column[n]=Number(e))}label(t,e){return Array.isArray(e)?e.length===this.joints.length?this.joints[t]:BE[e.length]?.[t]??t:t}names(){return[...this.columns.keys()].sort()}rows(t,e=this.last){let n=[];for(let i=Math.max(0,this.count-ba);i<this.count;++i){let r=this.time[i%ba];r>=e-t&&r<=e&&n.push(i%ba)}return n}pick(t,e){if(t.startsWith("="))try{return Du(t,this)(e)}catch{return e.map(()=>null)}let n=this.columns.get(t);return e.map(i=>n&&!Number.isNaN(n[i])?n[i]:null)}pictureAt(t){let e=null;for(let n of this.pictures)n&&(!e||Math.abs(n.time-t)<Math.abs(e.time-t))&&(e=n);return e}};var Up={vx:.3,vy:.15,wz:.3},Fp=.12,Tx=s=>Math.abs(s)<Fp?0:Math.sign(s)*(Math.abs(s)-Fp)/(1-Fp),Fu=class{constructor(t,e,n,i){this.pad=t,this.readout=e,this.walk=n,this.wanted=i,this.stick=t.querySelector("i"),this.held=!1,this.side=!1,this.enabled=!0,this.velocity={vx:0,vy:0,wz:0},t.onpointerdown=r=>{this.enabled&&(t.setPointerCapture(r.pointerId),this.side=r.shiftKey||r.button===2,this.take(),this.move(r))},t.onpointermove=r=>{this.held&&this.move(r)},t.onpointerup=t.onpointercancel=t.onlostpointercapture=()=>this.release(),t.oncontextmenu=r=>r.preventDefault(),addEventListener("blur",()=>this.release()),document.addEventListener("visibilitychange",()=>{document.hidden&&this.release()}),setInterval(()=>this.say(),80),this.zeros=0}take(){this.held||(this.held=!0,this.wanted())}move(t){let e=this.pad.getBoundingClientRect(),n=(t.clientX-e.x-e.width/2)/(e.width/2),i=(t.clientY-e.y-e.height/2)/(e.height/2);this.push(Math.max(-1,Math.min(1,n)),Math.max(-1,Math.min(1,i)),this.side)}push(t,e,n){this.stick.style.transform=`translate(${.28*this.pad.clientWidth*t}px, ${.28*this.pad.clientWidth*e}px)`;let[i,r]=[Tx(t),Tx(e)];this.velocity={vx:-r*Up.vx,vy:n?-i*Up.vy:0,wz:n?0:-i*Up.wz},this.show()}release(){this.held&&(this.held=!1,this.push(0,0,!1),this.zeros=4,this.say())}say(){this.held?this.walk(this.velocity):this.zeros>0&&(--this.zeros,this.walk({vx:0,vy:0,wz:0}))}show(){let{vx:t,vy:e,wz:n}=this.velocity;this.readout.textContent=`${t.toFixed(2)} m/s \xB7 ${e.toFixed(2)} m/s \xB7 ${(n*180/Math.PI).toFixed(0)} \xB0/s`}};var zE=["range","checkbox","radio","button","color","file"],kp=s=>s?.tagName==="TEXTAREA"||s?.isContentEditable===!0||s?.tagName==="INPUT"&&!zE.includes(s.type),ku=class{constructor(t,e,n){this.sheet=n,n.querySelector("dl").replaceChildren(...[[" ","space","stop; twice: hold at once"],...t,["?","?","this table"]].filter(([,a])=>a).flatMap(([,a,c])=>{let l=document.createElement("dt"),h=document.createElement("dd");return l.className=h.className=c.startsWith("recording:")?"of-recording":c.startsWith("simulated world:")||c.startsWith("stop;")?"of-robot":"",l.append(Object.assign(document.createElement("kbd"),{textContent:a})),h.textContent=c,[l,h]})),n.onclick=()=>{n.hidden=!0},addEventListener("keydown",a=>{if(a.ctrlKey||a.altKey||a.metaKey||a.isComposing)return;let c=document.activeElement;if(kp(c)){a.key==="Escape"&&c.blur();return}if(a.key===" "){a.preventDefault(),a.repeat||e();return}if(c?.tagName==="SELECT"){a.key==="Escape"&&c.blur();return}a.repeat&&!a.key.startsWith("Arrow")||(a.key==="?"?n.hidden=!n.hidden:a.key==="Escape"&&!n.hidden?n.hidden=!0:t.find(([l])=>l===a.key||l===a.key.toLowerCase())?.[3](a))}),addEventListener("keyup",a=>{a.key===" "&&!kp(document.activeElement)&&a.preventDefault()});let i=document.querySelector("#stop small"),r=i?.textContent,o=()=>{i&&(i.textContent=kp(document.activeElement)?"click":r)};addEventListener("focusin",o),addEventListener("focusout",()=>setTimeout(o))}};var HE=new Set(["hello","note"]),VE=700,GE=new Set(["127.0.0.1","localhost"]),Ou=null;function Ax(){if(Ou?.address===location.hash)return Ou.token;let s=new URLSearchParams(location.hash.slice(1)).get("token");try{s?sessionStorage.setItem("token",s):s=sessionStorage.getItem("token")}catch{}return Ou={address:location.hash,token:s??""},Ou.token}function ho(s){let t=Ax();return!t||s.startsWith("blob:")||s.startsWith("data:")?s:`${s}${s.includes("?")?"&":"?"}token=${encodeURIComponent(t)}`}var Bu=class{constructor(t){this.on=t,this.socket=null,this.received=0}connect(){let t=Ax(),e=t?`?token=${encodeURIComponent(t)}`:"",n=new WebSocket(`ws://${location.host}/ws${e}`);this.socket=n,!t&&!GE.has(location.hostname)&&this.on.note?.({text:"This address is opened with its token: the whole of what ./twinbus up printed."}),n.onopen=()=>{this.on.connected(!0),this.send({do:"hello"})},n.onmessage=r=>{let o=JSON.parse(r.data);++this.received,HE.has(o.type)||n.send("ack"),this.on[o.type]?.(o)};let i=!1;n.addEventListener("open",()=>{i=!0}),n.onclose=()=>{this.on.connected(!1),!i&&t&&this.askWhy(),setTimeout(()=>this.connect(),VE)}}async askWhy(){try{(await fetch(ho("robot.urdf"),{cache:"no-store"})).status===403&&this.on.refused?.()}catch{}}send(t){return this.socket?.readyState!==WebSocket.OPEN?!1:(this.socket.send(JSON.stringify(t)),!0)}};var WE="./twinbus";function va(s,t=globalThis.document?.documentElement.dataset.command??WE){return s.replace(/(?<![./])\.\/twinbus(?![/_-])/g,t)}var un=s=>document.getElementById(s),XE={clear:"\u2713",near:"\u2022","will collide":"\u25B2","in collision":"\u2716"},qE={close:"\u25B2 ",touch:"\u2716 "},YE=["","\u25B2 ","\u2716 "],Rx={simulator:"SIMULATOR",robot:"ROBOT",replay:"REPLAY",none:"NO SOURCE"};function Ln(s,t){let e=un(s);e.textContent!==t&&(e.textContent=t)}function hn(s,t={},e=[]){let n=Object.assign(document.createElement(s),t);return n.append(...e),n}var Cx=va("The token of this address is wrong or of an earlier run: open the address that ./twinbus up prints now."),Op=s=>s>0?`${s.toFixed(0)} Hz`:"\u2013",Bp=s=>s===null?"never":s<1e3?`${Math.round(s)} ms`:`${(s/1e3).toFixed(1)} s`,jE=["balance","walk","sway","squat"],ZE=s=>new Date(s/1e3).toTimeString().slice(0,8),zu=class{constructor(t){this.send=t,this.trusted=!1,this.active=0,this.lastEvent=-1,this.weight=1e3,this.robot="";for(let e of document.querySelectorAll("#modes button"))e.onclick=()=>t({do:"mode",mode:e.dataset.mode})}hello(t){this.trusted=t.trusted&&!this.recording,this.weight=t.mass*9.81,this.robot=t.robot;for(let e of document.querySelectorAll("#modes button"))e.hidden=t.fixed&&jE.includes(e.dataset.mode);un("drive").hidden=t.fixed,document.querySelectorAll("#reach button").forEach((e,n)=>{e.hidden=!t.hands[n]}),document.title=`twinbus: ${t.robot}`,un("watching").hidden=t.trusted;for(let e of document.querySelectorAll("#modes button, #reach button, #sim-box button"))e.disabled=!t.trusted;document.body.classList.toggle("watching",!t.trusted),un("clear").disabled=!t.trusted}replaying(t){this.recording=t,Ln("drive-name","Mode"),this.trusted=!1}forget(){this.lastEvent=-1}live(t){let e=t.age_ms!==null&&t.age_ms<500,n=e?this.recording?"replay":t.source:"none";this.active=e?t.run:0,this.lived=!0;let i=`source-${n}`;this.badge!==i&&(document.body.classList.remove(this.badge),document.body.classList.add(i),this.badge=i),n==="none"&&!this.recording&&this.paused&&(n=t.source),Ln("badge-name",Rx[n]??n);let r=performance.now();r-(this.slow??0)<100||(this.slow=r,Ln("badge-detail",e&&this.recording?`${this.robot} \xB7 recorded from ${t.source}, ${t.role} \xB7 term ${t.term}`:e?`${this.robot} \xB7 ${t.role}, term ${t.term} \xB7 ${Bp(t.age_ms)} old`:t.age_ms===null?"waiting for STATE":`last state ${Bp(t.age_ms)} ago`),Ln("rate-time",`${(t.time??0).toFixed(1)} s`),Ln("rate-tick",String(t.tick)),this.feet(t),this.map(t),this.pairs(t.pairs))}feet(t){let e=t.loaded.filter(Boolean).length;un("balance-box").hidden=t.feet.length===0,Ln("margin",t.margin_mm!==null?`ZMP ${t.margin_mm.toFixed(0)} mm inside`:t.feet.length===0?"no feet":e===0?"no foot stands":`stands on ${e===1?"one foot":`${e} feet`}`);let n=t.feet.join();this.footNames!==n&&(this.footNames=n,un("feet").replaceChildren(...t.feet.map((i,r)=>hn("div",{},[hn("label",{textContent:`${i.replaceAll("_"," ")} `},[]),hn("b",{id:`force-${r}`}),hn("div",{className:"bar"},[hn("i",{id:`bar-${r}`})])])))),t.feet.forEach((i,r)=>{let o=t.foot_force[r]??0;Ln(`force-${r}`,`${o.toFixed(0)} N`),un(`bar-${r}`).style.width=`${Math.max(0,Math.min(100,100*o/this.weight))}%`})}map(t){let e=t.soles.flat();if(e.length===0)return;let[n,i]=e.reduce(([v,_],E)=>[v+E[0]/e.length,_+E[1]/e.length],[0,0]),[r,o,a,c]=t.base.slice(3),l=Math.atan2(2*(r*c+o*a),1-2*(a*a+c*c)),[h,u]=[Math.cos(l),Math.sin(l)],d=v=>[-(-u*(v[0]-n)+h*(v[1]-i)),-(h*(v[0]-n)+u*(v[1]-i))],f=v=>Math.max(.1,...e.map(_=>Math.abs(d(_)[v]))),g=Math.min(125/f(0),52/f(1)),y=v=>d(v).map(_=>(g*_).toFixed(1)),p=v=>v.map(_=>y(_).join(",")).join(" "),m=v=>v&&v.every(_=>_!==null),x=(v,_,E)=>m(v)?`<circle cx="${y(v)[0]}" cy="${y(v)[1]}" r="${_}" fill="${E}"/>`:"";un("map").innerHTML=`<polygon points="${p(t.polygon)}" fill="#3ecf8e2e" stroke="#3ecf8e" stroke-width=".8"/>`+t.soles.map((v,_)=>v.length>1?`<polygon points="${p(v)}" fill="${t.loaded[_]?"#58c4ff30":"none"}" stroke="#8fb3d9" stroke-width=".6"/>`:`<circle cx="${y(v[0])[0]}" cy="${y(v[0])[1]}" r="4" fill="${t.loaded[_]?"#58c4ff60":"none"}" stroke="#8fb3d9" stroke-width=".6"/>`).join("")+(m(t.zmp_reference)?`<circle cx="${y(t.zmp_reference)[0]}" cy="${y(t.zmp_reference)[1]}" r="3" fill="none" stroke="#ffffff99" stroke-width=".7"/>`:"")+x(t.dcm,1.7,"#7cf5d0")+x(t.com,2.4,"#ffd23f")+x(t.zmp,2.4,"#ff5ac8")}pairs(t){this.close=t.some(n=>n.level);let e=t.slice(0,4).map(n=>hn("div",{className:`pair ${n.level}`},[hn("span",{textContent:`${n.a} \u2013 ${n.b}`}),hn("b",{textContent:`${qE[n.level]??""}${n.mm.toFixed(0)} mm`})]));un("pairs").replaceChildren(...e)}limits(t){let e=t.slice(0,4).map(({name:n,words:i})=>`${n} ${i}`).join(", ");Ln("limits",e),un("limits-row").hidden=t.length===0,un("tint-row").hidden=t.length===0&&!this.close}status(t){if(!this.online)return;let{level:e,text:n,remedy:i}=t.health;e==="good"&&this.active===0&&this.lived&&!this.recording&&([e,n,i]=["waiting","No state comes at this moment.",""]);let r=e==="stopped"||(t.stop??"none")!=="none";i&&(n+=` ${this.trusted||this.recording?i:"It is ended at the computer where it runs."}`),this.recording&&(n=n.replace(/ ?Press (Clear|STOP).*$/,"")),un("health").className!==e&&(un("health").className=e),Ln("health-text",va(n)),document.body.classList.toggle("stopped",r),document.body.classList.toggle("bad",e==="bad"),un("clear").hidden=!r||!this.trusted,un("anew").hidden=!t.health.anew||!this.trusted;let o=t.sources.find(l=>l.run===(this.active||this.lastRun));this.active&&(this.lastRun=this.active),this.paused=o?.pace===4,this.slowed=o?.pace===5,un("sim-box").hidden=this.recording||o?.kind!=="simulator",Ln("sim-now",this.paused?"paused":this.slowed?`\xD7 ${t.realtime_factor.toFixed(2)}`:"runs"),Ln("sim-pause",this.paused?"Go on":"Pause"),Ln("sim-slow",this.slowed?"\xD7 1":"\xD7 0.1"),Ln("rate-state",Op(t.state_hz)),Ln("rate-command",Op(t.command_hz)),Ln("rate-guard",Op(t.guard_hz)),Ln("rate-factor",t.realtime_factor>0?`\xD7 ${t.realtime_factor.toFixed(2)}`:"\u2013");let a=t.controller;this.mode=a?.mode??null;let c=a?a.motion!=="none"?a.motion:a.mode:"\u2013";Ln("mode-now",a?a.stopping!=="none"?`stopping (${a.stopping})`:c:"no controller");for(let l of document.querySelectorAll("#modes button"))l.classList.toggle("on",l.dataset.mode===c);Ln("guard-now",t.guard?`${XE[t.guard.verdict]??""} ${t.guard.verdict} \xB7 ${t.guard.pairs} pairs`:"not heard"),this.sources(t.sources),this.processes(t.processes),this.events(t.events)}sources(t){if(t.length===0){un("sources").replaceChildren(hn("p",{className:"hint",textContent:this.recording?"None is told of here.":va("None heard. Start the stack with ./twinbus up.")}));return}let e=JSON.stringify([this.active,this.trusted,t.map(n=>[n.run,n.role,n.kind])]);e!==this.sourcesKey&&(this.sourcesKey=e,this.sourceNotes=new Map,un("sources").replaceChildren(...t.map(n=>{let r=n.run===this.active?hn("span",{className:"active",textContent:"active"}):hn("button",{textContent:this.active?"Switch to it":"Activate",disabled:!this.trusted,onclick:()=>this.send({do:"switch",run:n.run})}),o=hn("small");return this.sourceNotes.set(n.run,o),hn("div",{className:"source"},[hn("i",{className:`c-${n.kind}`}),hn("b",{textContent:Rx[n.kind]??n.kind}),r,o])})));for(let n of t){let i=[n.age_ms>1e3?`silent for ${Bp(n.age_ms)}`:n.role,`${n.missed} missed`,`${n.late} late`,`${n.rejected} rejected`];n.refusal&&i.push(n.refusal),this.sourceNotes.get(n.run).textContent=i.join(" \xB7 ")}}processes(t){let e=t.map(n=>{let i=n.age_ms>1e3;return hn("tr",{className:i?"silent":n.state===3?"degraded":n.state<2?"waiting":"",title:`pid ${n.pid}, rejected ${n.rejected}, lost ${n.lost}`},[hn("td",{},[hn("i")]),hn("td",{textContent:n.kind+(i?" (silent)":"")}),hn("td",{textContent:n.rate?n.rate.toFixed(0):"\u2013"}),hn("td",{textContent:n.p99_us?`${n.p99_us.toFixed(0)} \xB5s`:"\u2013"}),hn("td",{textContent:String(n.missed)})])});document.querySelector("#processes tbody").replaceChildren(...e)}events(t){let e=t.at(-1)?.n??0;e!==this.lastEvent&&(this.lastEvent=e,un("events").replaceChildren(...[...t].reverse().map(n=>hn("li",{className:`s${n.severity}`},[hn("small",{textContent:`${ZE(n.utime)} ${n.from}`}),`${YE[n.severity]??""}${va(n.text)}${n.count>1?` (\xD7${n.count})`:""}`]))))}connected(t){this.online!==t&&(this.online=t,document.body.classList.toggle("offline",!t),!t&&(this.lastEvent=-1,un("health").className="bad",Ln("health-text",this.wrongToken?Cx:"The viewer process does not answer: the picture is old. Trying again.")))}refused(){this.wrongToken=!0,un("health").className="bad",Ln("health-text",Cx)}toast(t){un("toast").textContent=va(t),un("toast").hidden=!1,clearTimeout(this.toastTimer),this.toastTimer=setTimeout(()=>{un("toast").hidden=!0},5e3)}};var $E=Math.PI/180,JE=150,KE=4e3;function Zl(s,t={},e=[]){let n=Object.assign(document.createElement(s),t);return n.append(...e),n}var Hu=class{constructor(t,e,{send:n,toast:i}){Object.assign(this,{box:t,robot:e,send:n,toast:i}),this.sliders=[],this.wanted={},this.hidden=new Set,this.model=null,this.renewedAt=0,this.askedAt=null,this.filter=t.querySelector("input"),this.filter.oninput=()=>this.narrow(),t.querySelector("button").onclick=()=>{for(let{name:r,box:o}of this.rows)o.checked||(o.checked=!0,this.show(r,!0))},this.list=t.querySelector("ol"),this.rows=[]}get open(){return!this.box.hidden}toggle(t){this.box.hidden=!t,document.body.classList.toggle("with-parts",t),t?this.build():this.wanted={}}build(){let{model:t}=this.robot;if(!t||t===this.model)return;this.model=t,this.wanted={},this.sliders=this.robot.joints.map(()=>null),this.rows=[];let e=t.links??{},n=(r,o,a)=>{if(r.isURDFJoint){for(let c of r.children)n(c,o,r);return}if(!(!r.isURDFLink&&r!==t)){this.row(r,o,a);for(let c of r.children)n(c,o+1,null)}},i=Object.values(e).find(r=>!r.parent?.isURDFJoint)??t;n(i,0,null),this.list.replaceChildren(...this.rows.map(({node:r})=>r));for(let r of this.hidden)this.show(r,!1);this.narrow()}row(t,e,n){let i=t.urdfName??t.name,r=Zl("input",{type:"checkbox",checked:!this.hidden.has(i),ariaLabel:`draw ${i}`});r.onchange=()=>this.show(i,r.checked);let o=Zl("span",{textContent:i,title:n?`${i}, moved by ${n.urdfName??n.name}`:i});o.style.paddingLeft=`${Math.min(6*e,48)}px`;let a=[r,o],c=n?this.robot.joints.indexOf(n):-1;c>=0&&a.push(...this.slider(n,c)),this.rows.push({name:i,box:r,words:`${i} ${n?.urdfName??n?.name??""}`.toLowerCase(),node:Zl("li",{},a)})}slider(t,e){let n=t.urdfName??t.name,i=t.jointType!=="prismatic",{lower:r,upper:o}=t.limit,a=r<o?[r,o]:[-Math.PI,Math.PI],c=d=>i?`${(d/$E).toFixed(1)}\xB0`:`${(1e3*d).toFixed(0)} mm`,l=Zl("output",{textContent:"\u2013"}),h=Zl("input",{type:"range",min:a[0],max:a[1],step:(a[1]-a[0])/1e3,ariaLabel:`move ${n}`,title:`${n}, ${c(a[0])} to ${c(a[1])}`});h.disabled=!this.mayAsk;let u={name:n,input:h,output:l,write:c};return h.oninput=()=>{this.askedAt=null,this.wanted[n]=Number(h.value),l.textContent=c(this.wanted[n])},h.onchange=()=>{this.send({do:"pose",joints:{[n]:Number(h.value)}})||this.toast("The viewer does not answer."),this.askedAt=performance.now(),h.blur()},this.sliders[e]=u,[h,l]}allow(t){this.mayAsk=t;for(let e of this.sliders)e&&(e.input.disabled=!t)}show(t,e){e?this.hidden.delete(t):this.hidden.add(t);let n=this.model.links[t],i=r=>{r.isMesh&&!r.drawsAll&&(r.visible=e);for(let o of r.children)o.isURDFJoint||i(o)};if(n)for(let r of n.children)r.isURDFJoint||i(r)}narrow(){let t=this.filter.value.trim().toLowerCase().split(/\s+/);for(let{node:e,words:n}of this.rows)e.hidden=!t.every(i=>n.includes(i))}tick(t){if(!this.open)return;this.build();let e=performance.now();e-this.renewedAt<JE||(this.renewedAt=e,this.askedAt!==null&&e-this.askedAt>KE&&(this.wanted={},this.askedAt=null),this.sliders.forEach((n,i)=>{!n||t[i]==null||n.name in this.wanted||(n.input.value=t[i],n.output.textContent=n.write(t[i]))}))}posture(t,e){return!this.open||Object.keys(this.wanted).length===0?null:t.map((n,i)=>this.wanted[n]??e[i])}};var QE=()=>matchMedia("(max-width: 700px)").matches;function Px(s){QE()&&s()}var tT="uplot",eT="u-hz",nT="u-vt",iT="u-title",sT="u-wrap",rT="u-under",oT="u-over",aT="u-axis",po="u-off",lT="u-select",cT="u-cursor-x",hT="u-cursor-y",uT="u-cursor-pt",dT="u-legend",fT="u-live",pT="u-inline",mT="u-series",gT="u-marker",Ix="u-label",xT="u-value",Jl="width",Kl="height";var Lx="bottom",wa="left",zp="right",im="#000",Nx=im+"0",Hp="mousemove",Dx="mousedown",Vp="mouseup",Ux="mouseenter",Fx="mouseleave",kx="dblclick",_T="resize",yT="scroll",Ox="change",qu="dppxchange",sm="--",Ca=typeof window<"u",Yp=Ca?document:null,Ma=Ca?window:null,bT=Ca?navigator:null,Ie,Vu;function jp(){let s=devicePixelRatio;Ie!=s&&(Ie=s,Vu&&$p(Ox,Vu,jp),Vu=matchMedia(`(min-resolution: ${Ie-.001}dppx) and (max-resolution: ${Ie+.001}dppx)`),mo(Ox,Vu,jp),Ma.dispatchEvent(new CustomEvent(qu)))}function Hi(s,t){if(t!=null){let e=s.classList;!e.contains(t)&&e.add(t)}}function Zp(s,t){let e=s.classList;e.contains(t)&&e.remove(t)}function on(s,t,e){s.style[t]=e+"px"}function xs(s,t,e,n){let i=Yp.createElement(s);return t!=null&&Hi(i,t),e?.insertBefore(i,n),i}function ts(s,t){return xs("div",s,t)}var Bx=new WeakMap;function ks(s,t,e,n,i){let r="translate("+t+"px,"+e+"px)",o=Bx.get(s);r!=o&&(s.style.transform=r,Bx.set(s,r),t<0||e<0||t>n||e>i?Hi(s,po):Zp(s,po))}var zx=new WeakMap;function Hx(s,t,e){let n=t+e,i=zx.get(s);n!=i&&(zx.set(s,n),s.style.background=t,s.style.borderColor=e)}var Vx=new WeakMap;function Gx(s,t,e,n){let i=t+""+e,r=Vx.get(s);i!=r&&(Vx.set(s,i),s.style.height=e+"px",s.style.width=t+"px",s.style.marginLeft=n?-t/2+"px":0,s.style.marginTop=n?-e/2+"px":0)}var rm={passive:!0},vT={...rm,capture:!0};function mo(s,t,e,n){t.addEventListener(s,e,n?vT:rm)}function $p(s,t,e,n){t.removeEventListener(s,e,rm)}Ca&&jp();function _s(s,t,e,n){let i;e=e||0,n=n||t.length-1;let r=n<=2147483647;for(;n-e>1;)i=r?e+n>>1:Vi((e+n)/2),t[i]<s?e=i:n=i;return s-t[e]<=t[n]-s?e:n}function x_(s){return(e,n,i)=>{let r=-1,o=-1;for(let a=n;a<=i;a++)if(s(e[a])){r=a;break}for(let a=i;a>=n;a--)if(s(e[a])){o=a;break}return[r,o]}}var __=s=>s!=null,y_=s=>s!=null&&s>0,Zu=x_(__),wT=x_(y_);function ST(s,t,e,n=0,i=!1){let r=i?wT:Zu,o=i?y_:__;[t,e]=r(s,t,e);let a=s[t],c=s[t];if(t>-1)if(n==1)a=s[t],c=s[e];else if(n==-1)a=s[e],c=s[t];else for(let l=t;l<=e;l++){let h=s[l];o(h)&&(h<a?a=h:h>c&&(c=h))}return[a??Ze,c??-Ze]}function $u(s,t,e,n){let i=qx(s),r=qx(t);s==t&&(i==-1?(s*=e,t/=e):(s/=e,t*=e));let o=e==10?ar:b_,a=i==1?Vi:es,c=r==1?es:Vi,l=a(o(zn(s))),h=c(o(zn(t))),u=Ea(e,l),d=Ea(e,h);return e==10&&(l<0&&(u=$e(u,-l)),h<0&&(d=$e(d,-h))),n||e==2?(s=u*i,t=d*r):(s=M_(s,u),t=Ju(t,d)),[s,t]}function om(s,t,e,n){let i=$u(s,t,e,n);return s==0&&(i[0]=0),t==0&&(i[1]=0),i}var am=.1,Wx={mode:3,pad:am},tc={pad:0,soft:null,mode:0},MT={min:tc,max:tc};function Yu(s,t,e,n){return Ku(e)?Xx(s,t,e):(tc.pad=e,tc.soft=n?0:null,tc.mode=n?3:0,Xx(s,t,MT))}function Re(s,t){return s??t}function ET(s,t,e){for(t=Re(t,0),e=Re(e,s.length-1);t<=e;){if(s[t]!=null)return!0;t++}return!1}function Xx(s,t,e){let n=e.min,i=e.max,r=Re(n.pad,0),o=Re(i.pad,0),a=Re(n.hard,-Ze),c=Re(i.hard,Ze),l=Re(n.soft,Ze),h=Re(i.soft,-Ze),u=Re(n.mode,0),d=Re(i.mode,0),f=t-s,g=ar(f),y=wi(zn(s),zn(t)),p=ar(y),m=zn(p-g);(f<1e-24||m>10)&&(f=0,(s==0||t==0)&&(f=1e-24,u==2&&l!=Ze&&(r=0),d==2&&h!=-Ze&&(o=0)));let x=f||y||1e3,v=ar(x),_=Ea(10,Vi(v)),E=x*(f==0?s==0?.1:1:r),w=$e(M_(s-E,_/10),24),b=s>=l&&(u==1||u==3&&w<=l||u==2&&w>=l)?l:Ze,M=wi(a,w<b&&s>=b?b:ys(b,w)),I=x*(f==0?t==0?.1:1:o),P=$e(Ju(t+I,_/10),24),C=t<=h&&(d==1||d==3&&P>=h||d==2&&P<=h)?h:-Ze,D=ys(c,P>C&&t<=C?C:wi(C,P));return M==D&&M==0&&(D=100),[M,D]}var TT=new Intl.NumberFormat(Ca?bT.language:"en-US"),lm=s=>TT.format(s),Gi=Math,Xu=Gi.PI,zn=Gi.abs,Vi=Gi.floor,Bn=Gi.round,es=Gi.ceil,ys=Gi.min,wi=Gi.max,Ea=Gi.pow,qx=Gi.sign,ar=Gi.log10,b_=Gi.log2,AT=(s,t=1)=>Gi.sinh(s)*t,Gp=(s,t=1)=>Gi.asinh(s/t),Ze=1/0;function Yx(s){return(ar((s^s>>31)-(s>>31))|0)+1}function Jp(s,t,e){return ys(wi(s,t),e)}function v_(s){return typeof s=="function"}function Se(s){return v_(s)?s:()=>s}var RT=()=>{},w_=s=>s,S_=(s,t)=>t,CT=s=>null,jx=s=>!0,Zx=(s,t)=>s==t,PT=/\.\d*?(?=9{6,}|0{6,})/gm,go=s=>{if(T_(s)||Ur.has(s))return s;let t=`${s}`,e=t.match(PT);if(e==null)return s;let n=e[0].length-1;if(t.indexOf("e-")!=-1){let[i,r]=t.split("e");return+`${go(i)}e${r}`}return $e(s,n)};function uo(s,t){return go($e(go(s/t))*t)}function Ju(s,t){return go(es(go(s/t))*t)}function M_(s,t){return go(Vi(go(s/t))*t)}function $e(s,t=0){if(T_(s))return s;let e=10**t,n=s*e*(1+Number.EPSILON);return Bn(n)/e}var Ur=new Map;function E_(s){return((""+s).split(".")[1]||"").length}function nc(s,t,e,n){let i=[],r=n.map(E_);for(let o=t;o<e;o++){let a=zn(o),c=$e(Ea(s,o),a);for(let l=0;l<n.length;l++){let h=s==10?+`${n[l]}e${o}`:n[l]*c,u=(o>=0?0:a)+(o>=r[l]?0:r[l]),d=s==10?h:$e(h,u);i.push(d),Ur.set(d,u)}}return i}var ec={},cm=[],Ta=[null,null],Dr=Array.isArray,T_=Number.isInteger,IT=s=>s===void 0;function $x(s){return typeof s=="string"}function Ku(s){let t=!1;if(s!=null){let e=s.constructor;t=e==null||e==Object}return t}function LT(s){return s!=null&&typeof s=="object"}var NT=Object.getPrototypeOf(Uint8Array),A_="__proto__";function Aa(s,t=Ku){let e;if(Dr(s)){let n=s.find(i=>i!=null);if(Dr(n)||t(n)){e=Array(s.length);for(let i=0;i<s.length;i++)e[i]=Aa(s[i],t)}else e=s.slice()}else if(s instanceof NT)e=s.slice();else if(t(s)){e={};for(let n in s)n!=A_&&(e[n]=Aa(s[n],t))}else e=s;return e}function Nn(s){let t=arguments;for(let e=1;e<t.length;e++){let n=t[e];for(let i in n)i!=A_&&(Ku(s[i])?Nn(s[i],Aa(n[i])):s[i]=Aa(n[i]))}return s}var DT=0,UT=1,FT=2;function kT(s,t,e){for(let n=0,i,r=-1;n<t.length;n++){let o=t[n];if(o>r){for(i=o-1;i>=0&&s[i]==null;)s[i--]=null;for(i=o+1;i<e&&s[i]==null;)s[r=i++]=null}}}function OT(s,t){if(HT(s)){let o=s[0].slice();for(let a=1;a<s.length;a++)o.push(...s[a].slice(1));return VT(o[0])||(o=zT(o)),o}let e=new Set;for(let o=0;o<s.length;o++){let c=s[o][0],l=c.length;for(let h=0;h<l;h++)e.add(c[h])}let n=[Array.from(e).sort((o,a)=>o-a)],i=n[0].length,r=new Map;for(let o=0;o<i;o++)r.set(n[0][o],o);for(let o=0;o<s.length;o++){let a=s[o],c=a[0];for(let l=1;l<a.length;l++){let h=a[l],u=Array(i).fill(void 0),d=t?t[o][l]:UT,f=[];for(let g=0;g<h.length;g++){let y=h[g],p=r.get(c[g]);y===null?d!=DT&&(u[p]=y,d==FT&&f.push(p)):u[p]=y}kT(u,f,i),n.push(u)}}return n}var BT=typeof queueMicrotask>"u"?s=>Promise.resolve().then(s):queueMicrotask;function zT(s){let t=s[0],e=t.length,n=Array(e);for(let r=0;r<n.length;r++)n[r]=r;n.sort((r,o)=>t[r]-t[o]);let i=[];for(let r=0;r<s.length;r++){let o=s[r],a=Array(e);for(let c=0;c<e;c++)a[c]=o[n[c]];i.push(a)}return i}function HT(s){let t=s[0][0],e=t.length;for(let n=1;n<s.length;n++){let i=s[n][0];if(i.length!=e)return!1;if(i!=t){for(let r=0;r<e;r++)if(i[r]!=t[r])return!1}}return!0}function VT(s,t=100){let e=s.length;if(e<=1)return!0;let n=0,i=e-1;for(;n<=i&&s[n]==null;)n++;for(;i>=n&&s[i]==null;)i--;if(i<=n)return!0;let r=wi(1,Vi((i-n+1)/t));for(let o=s[n],a=n+r;a<=i;a+=r){let c=s[a];if(c!=null){if(c<=o)return!1;o=c}}return!0}var R_=["January","February","March","April","May","June","July","August","September","October","November","December"],C_=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function P_(s){return s.slice(0,3)}var GT=C_.map(P_),WT=R_.map(P_),XT={MMMM:R_,MMM:WT,WWWW:C_,WWW:GT};function $l(s){return(s<10?"0":"")+s}function qT(s){return(s<10?"00":s<100?"0":"")+s}var YT={YYYY:s=>s.getFullYear(),YY:s=>(s.getFullYear()+"").slice(2),MMMM:(s,t)=>t.MMMM[s.getMonth()],MMM:(s,t)=>t.MMM[s.getMonth()],MM:s=>$l(s.getMonth()+1),M:s=>s.getMonth()+1,DD:s=>$l(s.getDate()),D:s=>s.getDate(),WWWW:(s,t)=>t.WWWW[s.getDay()],WWW:(s,t)=>t.WWW[s.getDay()],HH:s=>$l(s.getHours()),H:s=>s.getHours(),h:s=>{let t=s.getHours();return t==0?12:t>12?t-12:t},AA:s=>s.getHours()>=12?"PM":"AM",aa:s=>s.getHours()>=12?"pm":"am",a:s=>s.getHours()>=12?"p":"a",mm:s=>$l(s.getMinutes()),m:s=>s.getMinutes(),ss:s=>$l(s.getSeconds()),s:s=>s.getSeconds(),fff:s=>qT(s.getMilliseconds())};function hm(s,t){t=t||XT;let e=[],n=/\{([a-z]+)\}|[^{]+/gi,i;for(;i=n.exec(s);)e.push(i[0][0]=="{"?YT[i[1]]:i[0]);return r=>{let o="";for(let a=0;a<e.length;a++)o+=typeof e[a]=="string"?e[a]:e[a](r,t);return o}}var jT=new Intl.DateTimeFormat().resolvedOptions().timeZone;function ZT(s,t){let e;return t=="UTC"||t=="Etc/UTC"?e=new Date(+s+s.getTimezoneOffset()*6e4):t==jT?e=s:(e=new Date(s.toLocaleString("en-US",{timeZone:t})),e.setMilliseconds(s.getMilliseconds())),e}var I_=s=>s%1==0,ju=[1,2,2.5,5],$T=nc(10,-32,0,ju),L_=nc(10,0,32,ju),JT=L_.filter(I_),fo=$T.concat(L_),um=`
`,N_="{YYYY}",Jx=um+N_,D_="{M}/{D}",Ql=um+D_,Gu=Ql+"/{YY}",U_="{aa}",KT="{h}:{mm}",Sa=KT+U_,Kx=um+Sa,Qx=":{ss}",Ue=null;function F_(s){let t=s*1e3,e=t*60,n=e*60,i=n*24,r=i*30,o=i*365,c=(s==1?nc(10,0,3,ju).filter(I_):nc(10,-3,0,ju)).concat([t,t*5,t*10,t*15,t*30,e,e*5,e*10,e*15,e*30,n,n*2,n*3,n*4,n*6,n*8,n*12,i,i*2,i*3,i*4,i*5,i*6,i*7,i*8,i*9,i*10,i*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),l=[[o,N_,Ue,Ue,Ue,Ue,Ue,Ue,1],[i*28,"{MMM}",Jx,Ue,Ue,Ue,Ue,Ue,1],[i,D_,Jx,Ue,Ue,Ue,Ue,Ue,1],[n,"{h}"+U_,Gu,Ue,Ql,Ue,Ue,Ue,1],[e,Sa,Gu,Ue,Ql,Ue,Ue,Ue,1],[t,Qx,Gu+" "+Sa,Ue,Ql+" "+Sa,Ue,Kx,Ue,1],[s,Qx+".{fff}",Gu+" "+Sa,Ue,Ql+" "+Sa,Ue,Kx,Ue,1]];function h(u){return(d,f,g,y,p,m)=>{let x=[],v=p>=o,_=p>=r&&p<o,E=u(g),w=$e(E*s,3),b=Wp(E.getFullYear(),v?0:E.getMonth(),_||v?1:E.getDate()),M=$e(b*s,3);if(_||v){let I=_?p/r:0,P=v?p/o:0,C=w==M?w:$e(Wp(b.getFullYear()+P,b.getMonth()+I,1)*s,3),D=new Date(Bn(C/s)),B=D.getFullYear(),L=D.getMonth();for(let z=0;C<=y;z++){let O=Wp(B+P*z,L+I*z,1),H=O-u($e(O*s,3));C=$e((+O+H)*s,3),C<=y&&x.push(C)}}else{let I=p>=i?i:p,P=Vi(g)-Vi(w),C=M+P+Ju(w-M,I);x.push(C);let D=u(C),B=D.getHours()+D.getMinutes()/e+D.getSeconds()/n,L=p/n,z=d.axes[f]._space,O=m/z;for(;C=$e(C+p,s==1?0:3),!(C>y);)if(L>1){let H=Vi($e(B+L,6))%24,Z=u(C).getHours()-H;Z>1&&(Z=-1),C-=Z*n,B=(B+L)%24;let $=x[x.length-1];$e((C-$)/p,3)*O>=.7&&x.push(C)}else x.push(C)}return x}}return[c,l,h]}var[QT,tA,eA]=F_(1),[nA,iA,sA]=F_(.001);nc(2,-53,53,[1]);function t_(s,t){return s.map(e=>e.map((n,i)=>i==0||i==8||n==null?n:t(i==1||e[8]==0?n:e[1]+n)))}function e_(s,t){return(e,n,i,r,o)=>{let a=t.find(g=>o>=g[0])||t[t.length-1],c,l,h,u,d,f;return n.map(g=>{let y=s(g),p=y.getFullYear(),m=y.getMonth(),x=y.getDate(),v=y.getHours(),_=y.getMinutes(),E=y.getSeconds(),w=p!=c&&a[2]||m!=l&&a[3]||x!=h&&a[4]||v!=u&&a[5]||_!=d&&a[6]||E!=f&&a[7]||a[1];return c=p,l=m,h=x,u=v,d=_,f=E,w(y)})}}function rA(s,t){let e=hm(t);return(n,i,r,o,a)=>i.map(c=>e(s(c)))}function Wp(s,t,e){return new Date(s,t,e)}function n_(s,t){return t(s)}var oA="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function i_(s,t){return(e,n,i,r)=>r==null?sm:t(s(n))}function aA(s,t){let e=s.series[t];return e.width?e.stroke(s,t):e.points.width?e.points.stroke(s,t):null}function lA(s,t){return s.series[t].fill(s,t)}var cA={show:!0,live:!0,isolate:!1,mount:RT,markers:{show:!0,width:2,stroke:aA,fill:lA,dash:"solid"},idx:null,idxs:null,values:[]};function hA(s,t){let e=s.cursor.points,n=ts(),i=e.size(s,t);on(n,Jl,i),on(n,Kl,i);let r=i/-2;on(n,"marginLeft",r),on(n,"marginTop",r);let o=e.width(s,t,i);return o&&on(n,"borderWidth",o),n}function uA(s,t){let e=s.series[t].points;return e._fill||e._stroke}function dA(s,t){let e=s.series[t].points;return e._stroke||e._fill}function fA(s,t){return s.series[t].points.size}var Xp=[0,0];function pA(s,t,e){return Xp[0]=t,Xp[1]=e,Xp}function Wu(s,t,e,n=!0){return i=>{i.button==0&&(!n||i.target==t)&&e(i)}}function qp(s,t,e,n=!0){return i=>{(!n||i.target==t)&&e(i)}}var mA={show:!0,x:!0,y:!0,lock:!1,move:pA,points:{one:!1,show:hA,size:fA,width:0,stroke:dA,fill:uA},bind:{mousedown:Wu,mouseup:Wu,click:Wu,dblclick:Wu,mousemove:qp,mouseleave:qp,mouseenter:qp},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(s,t)=>{t.stopPropagation(),t.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(s,t,e,n,i)=>n-i,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},k_={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},dm=Nn({},k_,{filter:S_}),O_=Nn({},dm,{size:10}),B_=Nn({},k_,{show:!1}),fm='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',z_="bold "+fm,H_=1.5,s_={show:!0,scale:"x",stroke:im,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:z_,side:2,grid:dm,ticks:O_,border:B_,font:fm,lineGap:H_,rotate:0},gA="Value",xA="Time",r_={show:!0,scale:"x",auto:!1,sorted:1,min:Ze,max:-Ze,idxs:[]};function _A(s,t,e,n,i){return t.map(r=>r==null?"":lm(r))}function yA(s,t,e,n,i,r,o){let a=[],c=Ur.get(i)||0;e=o?e:$e(Ju(e,i),c);for(let l=e;l<=n;l=$e(l+i,c))a.push(Object.is(l,-0)?0:l);return a}function Kp(s,t,e,n,i,r,o){let a=[],c=s.scales[s.axes[t].scale].log,l=c==10?ar:b_,h=Vi(l(e));i=Ea(c,h),c==10&&(i=fo[_s(i,fo)]);let u=e,d=i*c;c==10&&(d=fo[_s(d,fo)]);do a.push(u),u=u+i,c==10&&!Ur.has(u)&&(u=$e(u,Ur.get(i))),u>=d&&(i=u,d=i*c,c==10&&(d=fo[_s(d,fo)]));while(u<=n);return a}function bA(s,t,e,n,i,r,o){let c=s.scales[s.axes[t].scale].asinh,l=n>c?Kp(s,t,wi(c,e),n,i):[c],h=n>=0&&e<=0?[0]:[];return(e<-c?Kp(s,t,wi(c,-n),-e,i):[c]).reverse().map(d=>-d).concat(h,l)}var V_=/./,vA=/[12357]/,wA=/[125]/,o_=/1/,Qp=(s,t,e,n)=>s.map((i,r)=>t==4&&i==0||r%n==0&&e.test(i.toExponential()[i<0?1:0])?i:null);function SA(s,t,e,n,i){let r=s.axes[e],o=r.scale,a=s.scales[o],c=s.valToPos,l=r._space,h=c(10,o),u=c(9,o)-h>=l?V_:c(7,o)-h>=l?vA:c(5,o)-h>=l?wA:o_;if(u==o_){let d=zn(c(1,o)-h);if(d<l)return Qp(t.slice().reverse(),a.distr,u,es(l/d)).reverse()}return Qp(t,a.distr,u,1)}function MA(s,t,e,n,i){let r=s.axes[e],o=r.scale,a=r._space,c=s.valToPos,l=zn(c(1,o)-c(2,o));return l<a?Qp(t.slice().reverse(),3,V_,es(a/l)).reverse():t}function EA(s,t,e,n){return n==null?sm:t==null?"":lm(t)}var a_={show:!0,scale:"y",stroke:im,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:z_,side:3,grid:dm,ticks:O_,border:B_,font:fm,lineGap:H_,rotate:0};function TA(s,t){let e=3+(s||1)*2;return $e(e*t,3)}function AA(s,t){let{scale:e,idxs:n}=s.series[0],i=s._data[0],r=s.valToPos(i[n[0]],e,!0),o=s.valToPos(i[n[1]],e,!0),a=zn(o-r),c=s.series[t],l=a/(c.points.space*Ie);return n[1]-n[0]<=l}var l_={scale:null,auto:!0,sorted:0,min:Ze,max:-Ze},G_=(s,t,e,n,i)=>i,c_={show:!0,auto:!0,sorted:0,gaps:G_,alpha:1,facets:[Nn({},l_,{scale:"x"}),Nn({},l_,{scale:"y"})]},h_={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:G_,alpha:1,points:{show:AA,filter:null},values:null,min:Ze,max:-Ze,idxs:[],path:null,clip:null};function RA(s,t,e,n,i){return e/10}var W_={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},CA=Nn({},W_,{time:!1,ori:1}),u_={};function X_(s,t){let e=u_[s];return e||(e={key:s,plots:[],sub(n){e.plots.push(n)},unsub(n){e.plots=e.plots.filter(i=>i!=n)},pub(n,i,r,o,a,c,l){for(let h=0;h<e.plots.length;h++)e.plots[h]!=i&&e.plots[h].pub(n,i,r,o,a,c,l)}},s!=null&&(u_[s]=e)),e}var Ra=1,tm=2;function xo(s,t,e){let n=s.mode,i=s.series[t],r=n==2?s._data[t]:s._data,o=s.scales,a=s.bbox,c=r[0],l=n==2?r[1]:r[t],h=n==2?o[i.facets[0].scale]:o[s.series[0].scale],u=n==2?o[i.facets[1].scale]:o[i.scale],d=a.left,f=a.top,g=a.width,y=a.height,p=s.valToPosH,m=s.valToPosV;return h.ori==0?e(i,c,l,h,u,p,m,d,f,g,y,td,Pa,nd,Y_,Z_):e(i,c,l,h,u,m,p,f,d,y,g,ed,Ia,gm,j_,$_)}function pm(s,t){let e=0,n=0,i=Re(s.bands,cm);for(let r=0;r<i.length;r++){let o=i[r];o.series[0]==t?e=o.dir:o.series[1]==t&&(o.dir==1?n|=1:n|=2)}return[e,n==1?-1:n==2?1:n==3?2:0]}function PA(s,t,e,n,i){let r=s.mode,o=s.series[t],a=r==2?o.facets[1].scale:o.scale,c=s.scales[a];return i==-1?c.min:i==1?c.max:c.distr==3?c.dir==1?c.min:c.max:0}function lr(s,t,e,n,i,r){return xo(s,t,(o,a,c,l,h,u,d,f,g,y,p)=>{let m=o.pxRound,x=l.dir*(l.ori==0?1:-1),v=l.ori==0?Pa:Ia,_,E;x==1?(_=e,E=n):(_=n,E=e);let w=m(u(a[_],l,y,f)),b=m(d(c[_],h,p,g)),M=m(u(a[E],l,y,f)),I=m(d(r==1?h.max:h.min,h,p,g)),P=new Path2D(i);return v(P,M,I),v(P,w,I),v(P,w,b),P})}function Qu(s,t,e,n,i,r){let o=null;if(s.length>0){o=new Path2D;let a=t==0?nd:gm,c=e;for(let u=0;u<s.length;u++){let d=s[u];if(d[1]>d[0]){let f=d[0]-c;f>0&&a(o,c,n,f,n+r),c=d[1]}}let l=e+i-c,h=10;l>0&&a(o,c,n-h/2,l,n+r+h)}return o}function IA(s,t,e){let n=s[s.length-1];n&&n[0]==t?n[1]=e:s.push([t,e])}function mm(s,t,e,n,i,r,o){let a=[],c=s.length;for(let l=i==1?e:n;l>=e&&l<=n;l+=i)if(t[l]===null){let u=l,d=l;if(i==1)for(;++l<=n&&t[l]===null;)d=l;else for(;--l>=e&&t[l]===null;)d=l;let f=r(s[u]),g=d==u?f:r(s[d]),y=u-i;f=o<=0&&y>=0&&y<c?r(s[y]):f;let m=d+i;g=o>=0&&m>=0&&m<c?r(s[m]):g,g>=f&&a.push([f,g])}return a}function d_(s){return s==0?w_:s==1?Bn:t=>uo(t,s)}function q_(s){let t=s==0?td:ed,e=s==0?(i,r,o,a,c,l)=>{i.arcTo(r,o,a,c,l)}:(i,r,o,a,c,l)=>{i.arcTo(o,r,c,a,l)},n=s==0?(i,r,o,a,c)=>{i.rect(r,o,a,c)}:(i,r,o,a,c)=>{i.rect(o,r,c,a)};return(i,r,o,a,c,l=0,h=0)=>{l==0&&h==0?n(i,r,o,a,c):(l=ys(l,a/2,c/2),h=ys(h,a/2,c/2),t(i,r+l,o),e(i,r+a,o,r+a,o+c,l),e(i,r+a,o+c,r,o+c,h),e(i,r,o+c,r,o,h),e(i,r,o,r+a,o,l),i.closePath())}}var td=(s,t,e)=>{s.moveTo(t,e)},ed=(s,t,e)=>{s.moveTo(e,t)},Pa=(s,t,e)=>{s.lineTo(t,e)},Ia=(s,t,e)=>{s.lineTo(e,t)},nd=q_(0),gm=q_(1),Y_=(s,t,e,n,i,r)=>{s.arc(t,e,n,i,r)},j_=(s,t,e,n,i,r)=>{s.arc(e,t,n,i,r)},Z_=(s,t,e,n,i,r,o)=>{s.bezierCurveTo(t,e,n,i,r,o)},$_=(s,t,e,n,i,r,o)=>{s.bezierCurveTo(e,t,i,n,o,r)};function J_(s){return(t,e,n,i,r)=>xo(t,e,(o,a,c,l,h,u,d,f,g,y,p)=>{let{pxRound:m,points:x}=o,v,_;l.ori==0?(v=td,_=Y_):(v=ed,_=j_);let E=$e(x.width*Ie,3),w=(x.size-x.width)/2*Ie,b=$e(w*2,3),M=new Path2D,I=new Path2D,{left:P,top:C,width:D,height:B}=t.bbox;nd(I,P-b,C-b,D+b*2,B+b*2);let L=z=>{if(c[z]!=null){let O=m(u(a[z],l,y,f)),H=m(d(c[z],h,p,g));v(M,O+w,H),_(M,O,H,w,0,Xu*2)}};if(r)r.forEach(L);else for(let z=n;z<=i;z++)L(z);return{stroke:E>0?M:null,fill:M,clip:I,flags:Ra|tm}})}function K_(s){return(t,e,n,i,r,o)=>{n!=i&&(r!=n&&o!=n&&s(t,e,n),r!=i&&o!=i&&s(t,e,i),s(t,e,o))}}var LA=K_(Pa),NA=K_(Ia);function Q_(s){let t=Re(s?.alignGaps,0);return(e,n,i,r)=>xo(e,n,(o,a,c,l,h,u,d,f,g,y,p)=>{[i,r]=Zu(c,i,r);let m=o.pxRound,x=B=>m(u(B,l,y,f)),v=B=>m(d(B,h,p,g)),_,E;l.ori==0?(_=Pa,E=LA):(_=Ia,E=NA);let w=l.dir*(l.ori==0?1:-1),b={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Ra},M=b.stroke,I=!1;if(r-i>=y*4){let B=it=>e.posToVal(it,l.key,!0),L=null,z=null,O,H,tt,X=x(a[w==1?i:r]),Z=x(a[i]),$=x(a[r]),at=B(w==1?Z+1:$-1);for(let it=w==1?i:r;it>=i&&it<=r;it+=w){let Y=a[it],nt=(w==1?Y<at:Y>at)?X:x(Y),lt=c[it];nt==X?lt!=null?(H=lt,L==null?(_(M,nt,v(H)),O=L=z=H):H<L?L=H:H>z&&(z=H)):lt===null&&(I=!0):(L!=null&&E(M,X,v(L),v(z),v(O),v(H)),lt!=null?(H=lt,_(M,nt,v(H)),L=z=O=H):(L=z=null,lt===null&&(I=!0)),X=nt,at=B(X+w))}L!=null&&L!=z&&tt!=X&&E(M,X,v(L),v(z),v(O),v(H))}else for(let B=w==1?i:r;B>=i&&B<=r;B+=w){let L=c[B];L===null?I=!0:L!=null&&_(M,x(a[B]),v(L))}let[C,D]=pm(e,n);if(o.fill!=null||C!=0){let B=b.fill=new Path2D(M),L=o.fillTo(e,n,o.min,o.max,C),z=v(L),O=x(a[i]),H=x(a[r]);w==-1&&([H,O]=[O,H]),_(B,H,z),_(B,O,z)}if(!o.spanGaps){let B=[];I&&B.push(...mm(a,c,i,r,w,x,t)),b.gaps=B=o.gaps(e,n,i,r,B),b.clip=Qu(B,l.ori,f,g,y,p)}return D!=0&&(b.band=D==2?[lr(e,n,i,r,M,-1),lr(e,n,i,r,M,1)]:lr(e,n,i,r,M,D)),b})}function DA(s){let t=Re(s.align,1),e=Re(s.ascDesc,!1),n=Re(s.alignGaps,0),i=Re(s.extend,!1);return(r,o,a,c)=>xo(r,o,(l,h,u,d,f,g,y,p,m,x,v)=>{[a,c]=Zu(u,a,c);let _=l.pxRound,{left:E,width:w}=r.bbox,b=Z=>_(g(Z,d,x,p)),M=Z=>_(y(Z,f,v,m)),I=d.ori==0?Pa:Ia,P={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Ra},C=P.stroke,D=d.dir*(d.ori==0?1:-1),B=M(u[D==1?a:c]),L=b(h[D==1?a:c]),z=L,O=L;i&&t==-1&&(O=E,I(C,O,B)),I(C,L,B);for(let Z=D==1?a:c;Z>=a&&Z<=c;Z+=D){let $=u[Z];if($==null)continue;let at=b(h[Z]),it=M($);t==1?I(C,at,B):I(C,z,it),I(C,at,it),B=it,z=at}let H=z;i&&t==1&&(H=E+w,I(C,H,B));let[tt,X]=pm(r,o);if(l.fill!=null||tt!=0){let Z=P.fill=new Path2D(C),$=l.fillTo(r,o,l.min,l.max,tt),at=M($);I(Z,H,at),I(Z,O,at)}if(!l.spanGaps){let Z=[];Z.push(...mm(h,u,a,c,D,b,n));let $=l.width*Ie/2,at=e||t==1?$:-$,it=e||t==-1?-$:$;Z.forEach(Y=>{Y[0]+=at,Y[1]+=it}),P.gaps=Z=l.gaps(r,o,a,c,Z),P.clip=Qu(Z,d.ori,p,m,x,v)}return X!=0&&(P.band=X==2?[lr(r,o,a,c,C,-1),lr(r,o,a,c,C,1)]:lr(r,o,a,c,C,X)),P})}function f_(s,t,e,n,i,r,o=Ze){if(s.length>1){let a=null;for(let c=0,l=1/0;c<s.length;c++)if(t[c]!==void 0){if(a!=null){let h=zn(s[c]-s[a]);h<l&&(l=h,o=zn(e(s[c],n,i,r)-e(s[a],n,i,r)))}a=c}}return o}function UA(s){s=s||ec;let t=Re(s.size,[.6,Ze,1]),e=s.align||0,n=s.gap||0,i=s.radius;i=i==null?[0,0]:typeof i=="number"?[i,0]:i;let r=Se(i),o=1-t[0],a=Re(t[1],Ze),c=Re(t[2],1),l=Re(s.disp,ec),h=Re(s.each,f=>{}),{fill:u,stroke:d}=l;return(f,g,y,p)=>xo(f,g,(m,x,v,_,E,w,b,M,I,P,C)=>{let D=m.pxRound,B=e,L=n*Ie,z=a*Ie,O=c*Ie,H,tt;_.ori==0?[H,tt]=r(f,g):[tt,H]=r(f,g);let X=_.dir*(_.ori==0?1:-1),Z=_.ori==0?nd:gm,$=_.ori==0?h:(Ct,Kt,le,Mt,We,Wt,$t)=>{h(Ct,Kt,le,We,Mt,$t,Wt)},at=Re(f.bands,cm).find(Ct=>Ct.series[0]==g),it=at!=null?at.dir:0,Y=m.fillTo(f,g,m.min,m.max,it),st=D(b(Y,E,C,I)),nt,lt,mt,Ut=P,Jt=D(m.width*Ie),Ot=!1,me=null,de=null,oe=null,an=null;u!=null&&(Jt==0||d!=null)&&(Ot=!0,me=u.values(f,g,y,p),de=new Map,new Set(me).forEach(Ct=>{Ct!=null&&de.set(Ct,new Path2D)}),Jt>0&&(oe=d.values(f,g,y,p),an=new Map,new Set(oe).forEach(Ct=>{Ct!=null&&an.set(Ct,new Path2D)})));let{x0:Ke,size:En}=l;if(Ke!=null&&En!=null){B=1,x=Ke.values(f,g,y,p),Ke.unit==2&&(x=x.map(le=>f.posToVal(M+le*P,_.key,!0)));let Ct=En.values(f,g,y,p);En.unit==2?lt=Ct[0]*P:lt=w(Ct[0],_,P,M)-w(0,_,P,M),Ut=f_(x,v,w,_,P,M,Ut),mt=Ut-lt+L}else Ut=f_(x,v,w,_,P,M,Ut),mt=Ut*o+L,lt=Ut-mt;mt<1&&(mt=0),Jt>=lt/2&&(Jt=0),mt<5&&(D=w_);let Ve=mt>0,Vn=Ut-mt-(Ve?Jt:0);lt=D(Jp(Vn,O,z)),nt=(B==0?lt/2:B==X?0:lt)-B*X*((B==0?L/2:0)+(Ve?Jt/2:0));let Ee={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},Dn=Ot?null:new Path2D,gn=null;if(at!=null)gn=f.data[at.series[1]];else{let{y0:Ct,y1:Kt}=l;Ct!=null&&Kt!=null&&(v=Kt.values(f,g,y,p),gn=Ct.values(f,g,y,p))}let Tn=H*lt,G=tt*lt;for(let Ct=X==1?y:p;Ct>=y&&Ct<=p;Ct+=X){let Kt=v[Ct];if(Kt==null)continue;if(gn!=null){let j=gn[Ct]??0;if(Kt-j==0)continue;st=b(j,E,C,I)}let le=_.distr!=2||l!=null?x[Ct]:Ct,Mt=w(le,_,P,M),We=b(Re(Kt,Y),E,C,I),Wt=D(Mt-nt),$t=D(wi(We,st)),N=D(ys(We,st)),T=$t-N;if(Kt!=null){let j=Kt<0?G:Tn,pt=Kt<0?Tn:G;Ot?(Jt>0&&oe[Ct]!=null&&Z(an.get(oe[Ct]),Wt,N+Vi(Jt/2),lt,wi(0,T-Jt),j,pt),me[Ct]!=null&&Z(de.get(me[Ct]),Wt,N+Vi(Jt/2),lt,wi(0,T-Jt),j,pt)):Z(Dn,Wt,N+Vi(Jt/2),lt,wi(0,T-Jt),j,pt),$(f,g,Ct,Wt-Jt/2,N,lt+Jt,T)}}return Jt>0?Ee.stroke=Ot?an:Dn:Ot||(Ee._fill=m.width==0?m._fill:m._stroke??m._fill,Ee.width=0),Ee.fill=Ot?de:Dn,Ee})}function FA(s,t){let e=Re(t?.alignGaps,0);return(n,i,r,o)=>xo(n,i,(a,c,l,h,u,d,f,g,y,p,m)=>{[r,o]=Zu(l,r,o);let x=a.pxRound,v=H=>x(d(H,h,p,g)),_=H=>x(f(H,u,m,y)),E,w,b;h.ori==0?(E=td,b=Pa,w=Z_):(E=ed,b=Ia,w=$_);let M=h.dir*(h.ori==0?1:-1),I=v(c[M==1?r:o]),P=I,C=[],D=[];for(let H=M==1?r:o;H>=r&&H<=o;H+=M)if(l[H]!=null){let X=c[H],Z=v(X);C.push(P=Z),D.push(_(l[H]))}let B={stroke:s(C,D,E,b,w,x),fill:null,clip:null,band:null,gaps:null,flags:Ra},L=B.stroke,[z,O]=pm(n,i);if(a.fill!=null||z!=0){let H=B.fill=new Path2D(L),tt=a.fillTo(n,i,a.min,a.max,z),X=_(tt);b(H,P,X),b(H,I,X)}if(!a.spanGaps){let H=[];H.push(...mm(c,l,r,o,M,v,e)),B.gaps=H=a.gaps(n,i,r,o,H),B.clip=Qu(H,h.ori,g,y,p,m)}return O!=0&&(B.band=O==2?[lr(n,i,r,o,L,-1),lr(n,i,r,o,L,1)]:lr(n,i,r,o,L,O)),B})}function kA(s){return FA(OA,s)}function OA(s,t,e,n,i,r){let o=s.length;if(o<2)return null;let a=new Path2D;if(e(a,s[0],t[0]),o==2)n(a,s[1],t[1]);else{let c=Array(o),l=Array(o-1),h=Array(o-1),u=Array(o-1);for(let d=0;d<o-1;d++)h[d]=t[d+1]-t[d],u[d]=s[d+1]-s[d],l[d]=h[d]/u[d];c[0]=l[0];for(let d=1;d<o-1;d++)l[d]===0||l[d-1]===0||l[d-1]>0!=l[d]>0?c[d]=0:(c[d]=3*(u[d-1]+u[d])/((2*u[d]+u[d-1])/l[d-1]+(u[d]+2*u[d-1])/l[d]),isFinite(c[d])||(c[d]=0));c[o-1]=l[o-2];for(let d=0;d<o-1;d++)i(a,s[d]+u[d]/3,t[d]+c[d]*u[d]/3,s[d+1]-u[d]/3,t[d+1]-c[d+1]*u[d]/3,s[d+1],t[d+1])}return a}var em=new Set;function p_(){for(let s of em)s.syncRect(!0)}Ca&&(mo(_T,Ma,p_),mo(yT,Ma,p_,!0),mo(qu,Ma,()=>{ei.pxRatio=Ie}));var BA=Q_(),zA=J_();function m_(s,t,e,n){return(n?[s[0],s[1]].concat(s.slice(2)):[s[0]].concat(s.slice(1))).map((r,o)=>nm(r,o,t,e))}function HA(s,t){return s.map((e,n)=>n==0?{}:Nn({},t,e))}function nm(s,t,e,n){return Nn({},t==0?e:n,s)}function ty(s,t,e){return t==null?Ta:[t,e]}var VA=ty;function GA(s,t,e){return t==null?Ta:Yu(t,e,am,!0)}function ey(s,t,e,n){return t==null?Ta:$u(t,e,s.scales[n].log,!1)}var WA=ey;function ny(s,t,e,n){return t==null?Ta:om(t,e,s.scales[n].log,!1)}var XA=ny;function qA(s,t,e,n,i){let r=wi(Yx(s),Yx(t)),o=t-s,a=_s(i/n*o,e);do{let c=e[a],l=n*c/o;if(l>=i&&r+(c<5?Ur.get(c):0)<=17)return[c,l]}while(++a<e.length);return[0,0]}function g_(s){let t,e;return s=s.replace(/(\d+)px/,(n,i)=>(t=Bn((e=+i)*Ie))+"px"),[s,t,e]}function YA(s){s.show&&[s.font,s.labelFont].forEach(t=>{let e=$e(t[2]*Ie,1);t[0]=t[0].replace(/[0-9.]+px/,e+"px"),t[1]=e})}function ei(s,t,e){let n={mode:Re(s.mode,1)},i=n.mode;function r(S,A,U,k){let q=A.valToPct(S);return k+U*(A.dir==-1?1-q:q)}function o(S,A,U,k){let q=A.valToPct(S);return k+U*(A.dir==-1?q:1-q)}function a(S,A,U,k){return A.ori==0?r(S,A,U,k):o(S,A,U,k)}n.valToPosH=r,n.valToPosV=o;let c=!1;n.status=0;let l=n.root=ts(tT);if(s.id!=null&&(l.id=s.id),Hi(l,s.class),s.title){let S=ts(iT,l);S.textContent=s.title}let h=xs("canvas"),u=n.ctx=h.getContext("2d"),d=ts(sT,l);mo("click",d,S=>{S.target===g&&(en!=To||ln!=Ao)&&Qn.click(n,S)},!0);let f=n.under=ts(rT,d);d.appendChild(h);let g=n.over=ts(oT,d);s=Aa(s);let y=+Re(s.pxAlign,1),p=d_(y);(s.plugins||[]).forEach(S=>{S.opts&&(s=S.opts(n,s)||s)});let m=s.ms||.001,x=n.series=i==1?m_(s.series||[],r_,h_,!1):HA(s.series||[null],c_),v=n.axes=m_(s.axes||[],s_,a_,!0),_=n.scales={},E=n.bands=s.bands||[];E.forEach(S=>{S.fill=Se(S.fill||null),S.dir=Re(S.dir,-1)});let w=i==2?x[1].facets[0].scale:x[0].scale,b={axes:Hs,series:xe},M=(s.drawOrder||["axes","series"]).map(S=>b[S]);function I(S){let A=S.distr==3?U=>ar(U>0?U:S.clamp(n,U,S.min,S.max,S.key)):S.distr==4?U=>Gp(U,S.asinh):S.distr==100?U=>S.fwd(U):U=>U;return U=>{let k=A(U),{_min:q,_max:Q}=S,dt=Q-q;return(k-q)/dt}}function P(S){let A=_[S];if(A==null){let U=(s.scales||ec)[S]||ec;if(U.from!=null){P(U.from);let k=Nn({},_[U.from],U,{key:S});k.valToPct=I(k),_[S]=k}else{A=_[S]=Nn({},S==w?W_:CA,U),A.key=S;let k=A.time,q=A.range,Q=Dr(q);if((S!=w||i==2&&!k)&&(Q&&(q[0]==null||q[1]==null)&&(q={min:q[0]==null?Wx:{mode:1,hard:q[0],soft:q[0]},max:q[1]==null?Wx:{mode:1,hard:q[1],soft:q[1]}},Q=!1),!Q&&Ku(q))){let dt=q;q=(xt,wt,Nt)=>wt==null?Ta:Yu(wt,Nt,dt)}A.range=Se(q||(k?VA:S==w?A.distr==3?WA:A.distr==4?XA:ty:A.distr==3?ey:A.distr==4?ny:GA)),A.auto=Se(Q?!1:A.auto),A.clamp=Se(A.clamp||RA),A._min=A._max=null,A.valToPct=I(A)}}}P("x"),P("y"),i==1&&x.forEach(S=>{P(S.scale)}),v.forEach(S=>{P(S.scale)});for(let S in s.scales)P(S);let C=_[w],D=C.distr,B,L;C.ori==0?(Hi(l,eT),B=r,L=o):(Hi(l,nT),B=o,L=r);let z={};for(let S in _){let A=_[S];(A.min!=null||A.max!=null)&&(z[S]={min:A.min,max:A.max},A.min=A.max=null)}let O=s.tzDate||(S=>new Date(Bn(S/m))),H=s.fmtDate||hm,tt=m==1?eA(O):sA(O),X=e_(O,t_(m==1?tA:iA,H)),Z=i_(O,n_(oA,H)),$=[],at=n.legend=Nn({},cA,s.legend),it=n.cursor=Nn({},mA,{drag:{y:i==2}},s.cursor),Y=at.show,st=it.show,nt=at.markers;at.idxs=$,nt.width=Se(nt.width),nt.dash=Se(nt.dash),nt.stroke=Se(nt.stroke),nt.fill=Se(nt.fill);let lt,mt,Ut,Jt=[],Ot=[],me,de=!1,oe={};if(at.live){let S=x[1]?x[1].values:null;de=S!=null,me=de?S(n,1,0):{_:0};for(let A in me)oe[A]=sm}if(Y)if(lt=xs("table",dT,l),Ut=xs("tbody",null,lt),at.mount(n,lt),de){mt=xs("thead",null,lt,Ut);let S=xs("tr",null,mt);xs("th",null,S);for(var an in me)xs("th",Ix,S).textContent=an}else Hi(lt,pT),at.live&&Hi(lt,fT);let Ke={show:!0},En={show:!1};function Ve(S,A){if(A==0&&(de||!at.live||i==2))return Ta;let U=[],k=xs("tr",mT,Ut,Ut.childNodes[A]);Hi(k,S.class),S.show||Hi(k,po);let q=xs("th",null,k);if(nt.show){let xt=ts(gT,q);if(A>0){let wt=nt.width(n,A);wt&&(xt.style.border=wt+"px "+nt.dash(n,A)+" "+nt.stroke(n,A)),xt.style.background=nt.fill(n,A)}}let Q=ts(Ix,q);S.label instanceof HTMLElement?Q.appendChild(S.label):Q.textContent=S.label,A>0&&(nt.show||(Q.style.color=S.width>0?nt.stroke(n,A):nt.fill(n,A)),Ee("click",q,xt=>{if(it._lock)return;ee(xt);let wt=x.indexOf(S);if((xt.ctrlKey||xt.metaKey)!=at.isolate){let Nt=x.some((Dt,kt)=>kt>0&&kt!=wt&&Dt.show);x.forEach((Dt,kt)=>{kt>0&&Ms(kt,Nt?kt==wt?Ke:En:Ke,!0,Pn.setSeries)})}else Ms(wt,{show:!S.show},!0,Pn.setSeries)},!1),ne&&Ee(Ux,q,xt=>{it._lock||(ee(xt),Ms(x.indexOf(S),Co,!0,Pn.setSeries))},!1));for(var dt in me){let xt=xs("td",xT,k);xt.textContent="--",U.push(xt)}return[k,U]}let Vn=new Map;function Ee(S,A,U,k=!0){let q=Vn.get(A)||{},Q=it.bind[S](n,A,U,k);Q&&(mo(S,A,q[S]=Q),Vn.set(A,q))}function Dn(S,A,U){let k=Vn.get(A)||{};for(let q in k)(S==null||q==S)&&($p(q,A,k[q]),delete k[q]);S==null&&Vn.delete(A)}let gn=0,Tn=0,G=0,Ct=0,Kt=0,le=0,Mt=Kt,We=le,Wt=G,$t=Ct,N=0,T=0,j=0,pt=0;n.bbox={};let ut=!1,bt=!1,vt=!1,rt=!1,ct=!1,_t=!1;function V(S,A,U){(U||S!=n.width||A!=n.height)&&ht(S,A),fe(!1),vt=!0,bt=!0,ni()}function ht(S,A){n.width=gn=G=S,n.height=Tn=Ct=A,Kt=le=0,St(),Yt();let U=n.bbox;N=U.left=uo(Kt*Ie,.5),T=U.top=uo(le*Ie,.5),j=U.width=uo(G*Ie,.5),pt=U.height=uo(Ct*Ie,.5)}let ot=3;function Et(){let S=!1,A=0;for(;!S;){A++;let U=So(A),k=Ss(A);S=A==ot||U&&k,S||(ht(n.width,n.height),bt=!0)}}function yt({width:S,height:A}){V(S,A)}n.setSize=yt;function St(){let S=!1,A=!1,U=!1,k=!1;v.forEach((q,Q)=>{if(q.show&&q._show){let{side:dt,_size:xt}=q,wt=dt%2,Nt=q.label!=null?q.labelSize:0,Dt=xt+Nt;Dt>0&&(wt?(G-=Dt,dt==3?(Kt+=Dt,k=!0):U=!0):(Ct-=Dt,dt==0?(le+=Dt,S=!0):A=!0))}}),vs[0]=S,vs[1]=U,vs[2]=A,vs[3]=k,G-=rs[1]+rs[3],Kt+=rs[3],Ct-=rs[2]+rs[0],le+=rs[0]}function Yt(){let S=Kt+G,A=le+Ct,U=Kt,k=le;function q(Q,dt){switch(Q){case 1:return S+=dt,S-dt;case 2:return A+=dt,A-dt;case 3:return U-=dt,U+dt;case 0:return k-=dt,k+dt}}v.forEach((Q,dt)=>{if(Q.show&&Q._show){let xt=Q.side;Q._pos=q(xt,Q._size),Q.label!=null&&(Q._lpos=q(xt,Q.labelSize))}})}if(it.dataIdx==null){let S=it.hover,A=S.skip=new Set(S.skip??[]);A.add(void 0);let U=S.prox=Se(S.prox),k=S.bias??=0;it.dataIdx=(q,Q,dt,xt)=>{if(Q==0)return dt;let wt=dt,Nt=U(q,Q,dt,xt)??Ze,Dt=Nt>=0&&Nt<Ze,kt=C.ori==0?G:Ct,ae=it.left,Ce=t[0],Ae=t[Q];if(A.has(Ae[dt])){wt=null;let be=null,Qt=null,jt;if(k==0||k==-1)for(jt=dt;be==null&&jt-- >0;)A.has(Ae[jt])||(be=jt);if(k==0||k==1)for(jt=dt;Qt==null&&jt++<Ae.length;)A.has(Ae[jt])||(Qt=jt);if(be!=null||Qt!=null)if(Dt){let sn=be==null?-1/0:B(Ce[be],C,kt,0),yn=Qt==null?1/0:B(Ce[Qt],C,kt,0),qn=ae-sn,Ge=yn-ae;qn<=Ge?qn<=Nt&&(wt=be):Ge<=Nt&&(wt=Qt)}else wt=Qt==null?be:be==null?Qt:dt-be<=Qt-dt?be:Qt}else Dt&&zn(ae-B(Ce[dt],C,kt,0))>Nt&&(wt=null);return wt}}let ee=S=>{it.event=S};it.idxs=$,it._lock=!1;let ft=it.points;ft.show=Se(ft.show),ft.size=Se(ft.size),ft.stroke=Se(ft.stroke),ft.width=Se(ft.width),ft.fill=Se(ft.fill);let Bt=n.focus=Nn({},s.focus||{alpha:.3},it.focus),ne=Bt.prox>=0,Rt=ne&&ft.one,ce=[],tn=[],di=[];function Oa(S,A){let U=ft.show(n,A);if(U instanceof HTMLElement)return Hi(U,uT),Hi(U,S.class),ks(U,-10,-10,G,Ct),g.insertBefore(U,ce[A]),U}function bo(S,A){if(i==1||A>0){let U=i==1&&_[S.scale].time,k=S.value;S.value=U?$x(k)?i_(O,n_(k,H)):k||Z:k||EA,S.label=S.label||(U?xA:gA)}if(Rt||A>0){S.width=S.width==null?1:S.width,S.paths=S.paths||BA||CT,S.fillTo=Se(S.fillTo||PA),S.pxAlign=+Re(S.pxAlign,y),S.pxRound=d_(S.pxAlign),S.stroke=Se(S.stroke||null),S.fill=Se(S.fill||null),S._stroke=S._fill=S._paths=S._focus=null;let U=TA(wi(1,S.width),1),k=S.points=Nn({},{size:U,width:wi(1,U*.2),stroke:S.stroke,space:U*2,paths:zA,_stroke:null,_fill:null},S.points);k.show=Se(k.show),k.filter=Se(k.filter),k.fill=Se(k.fill),k.stroke=Se(k.stroke),k.paths=Se(k.paths),k.pxAlign=S.pxAlign}if(Y){let U=Ve(S,A);Jt.splice(A,0,U[0]),Ot.splice(A,0,U[1]),at.values.push(null)}if(st){$.splice(A,0,null);let U=null;Rt?A==0&&(U=Oa(S,A)):A>0&&(U=Oa(S,A)),ce.splice(A,0,U),tn.splice(A,0,0),di.splice(A,0,0)}Xn("addSeries",A)}function Xd(S,A){A=A??x.length,S=i==1?nm(S,A,r_,h_):nm(S,A,{},c_),x.splice(A,0,S),bo(x[A],A)}n.addSeries=Xd;function _c(S){if(x.splice(S,1),Y){at.values.splice(S,1),Ot.splice(S,1);let A=Jt.splice(S,1)[0];Dn(null,A.firstChild),A.remove()}st&&($.splice(S,1),ce.splice(S,1)[0].remove(),tn.splice(S,1),di.splice(S,1)),Xn("delSeries",S)}n.delSeries=_c;let vs=[!1,!1,!1,!1];function Os(S,A){if(S._show=S.show,S.show){let U=S.side%2,k=_[S.scale];k==null&&(S.scale=U?x[1].scale:w,k=_[S.scale]);let q=k.time;S.size=Se(S.size),S.space=Se(S.space),S.rotate=Se(S.rotate),Dr(S.incrs)&&S.incrs.forEach(dt=>{!Ur.has(dt)&&Ur.set(dt,E_(dt))}),S.incrs=Se(S.incrs||(k.distr==2?JT:q?m==1?QT:nA:fo)),S.splits=Se(S.splits||(q&&k.distr==1?tt:k.distr==3?Kp:k.distr==4?bA:yA)),S.stroke=Se(S.stroke),S.grid.stroke=Se(S.grid.stroke),S.ticks.stroke=Se(S.ticks.stroke),S.border.stroke=Se(S.border.stroke);let Q=S.values;S.values=Dr(Q)&&!Dr(Q[0])?Se(Q):q?Dr(Q)?e_(O,t_(Q,H)):$x(Q)?rA(O,Q):Q||X:Q||_A,S.filter=Se(S.filter||(k.distr>=3&&k.log==10?SA:k.distr==3&&k.log==2?MA:S_)),S.font=g_(S.font),S.labelFont=g_(S.labelFont),S._size=S.size(n,null,A,0),S._space=S._rotate=S._incrs=S._found=S._splits=S._values=null,S._size>0&&(vs[A]=!0,S._el=ts(aT,d))}}function Bs(S,A,U,k){let[q,Q,dt,xt]=U,wt=A%2,Nt=0;return wt==0&&(xt||Q)&&(Nt=A==0&&!q||A==2&&!dt?Bn(s_.size/3):0),wt==1&&(q||dt)&&(Nt=A==1&&!Q||A==3&&!xt?Bn(a_.size/2):0),Nt}let Ba=n.padding=(s.padding||[Bs,Bs,Bs,Bs]).map(S=>Se(Re(S,Bs))),rs=n._padding=Ba.map((S,A)=>S(n,A,vs,0)),xn,Sn=null,Mn=null,ws=i==1?x[0].idxs:null,Ii=null,hr=!1;function za(S,A){if(t=S??[],n.data=n._data=t,i==2){xn=0;for(let U=1;U<x.length;U++)xn+=t[U][0].length}else{t.length==0&&(n.data=n._data=t=[[]]),Ii=t[0],xn=Ii.length;let U=t;if(D==2){U=t.slice();let k=U[0]=Array(xn);for(let q=0;q<xn;q++)k[q]=q}n._data=t=U}if(fe(!0),Xn("setData"),D==2&&(vt=!0),A!==!1){let U=C;U.auto(n,hr)?Ha():fr(w,U.min,U.max),rt=rt||it.left>=0,_t=!0,ni()}}n.setData=za;function Ha(){hr=!0;let S,A;i==1&&(xn>0?(Sn=ws[0]=0,Mn=ws[1]=xn-1,S=t[0][Sn],A=t[0][Mn],D==2?(S=Sn,A=Mn):S==A&&(D==3?[S,A]=$u(S,S,C.log,!1):D==4?[S,A]=om(S,S,C.log,!1):C.time?A=S+Bn(86400/m):[S,A]=Yu(S,A,am,!0))):(Sn=ws[0]=S=null,Mn=ws[1]=A=null)),fr(w,S,A)}let vo,ur,wo,R,W,et,J,K,Tt,Pt;function At(S,A,U,k,q,Q){S??=Nx,U??=cm,k??="butt",q??=Nx,Q??="round",S!=vo&&(u.strokeStyle=vo=S),q!=ur&&(u.fillStyle=ur=q),A!=wo&&(u.lineWidth=wo=A),Q!=W&&(u.lineJoin=W=Q),k!=et&&(u.lineCap=et=k),U!=R&&u.setLineDash(R=U)}function It(S,A,U,k){A!=ur&&(u.fillStyle=ur=A),S!=J&&(u.font=J=S),U!=K&&(u.textAlign=K=U),k!=Tt&&(u.textBaseline=Tt=k)}function Ht(S,A,U,k,q=0){if(k.length>0&&S.auto(n,hr)&&(A==null||A.min==null)){let Q=Re(Sn,0),dt=Re(Mn,k.length-1),xt=U.min==null?ST(k,Q,dt,q,S.distr==3):[U.min,U.max];S.min=ys(S.min,U.min=xt[0]),S.max=wi(S.max,U.max=xt[1])}}let se={min:null,max:null};function ge(){for(let k in _){let q=_[k];z[k]==null&&(q.min==null||z[w]!=null&&q.auto(n,hr))&&(z[k]=se)}for(let k in _){let q=_[k];z[k]==null&&q.from!=null&&z[q.from]!=null&&(z[k]=se)}z[w]!=null&&fe(!0);let S={};for(let k in z){let q=z[k];if(q!=null){let Q=S[k]=Aa(_[k],LT);if(q.min!=null)Nn(Q,q);else if(k!=w||i==2)if(xn==0&&Q.from==null){let dt=Q.range(n,null,null,k);Q.min=dt[0],Q.max=dt[1]}else Q.min=Ze,Q.max=-Ze}}if(xn>0){x.forEach((k,q)=>{if(i==1){let Q=k.scale,dt=z[Q];if(dt==null)return;let xt=S[Q];if(q==0){let wt=xt.range(n,xt.min,xt.max,Q);xt.min=wt[0],xt.max=wt[1],Sn=_s(xt.min,t[0]),Mn=_s(xt.max,t[0]),Mn-Sn>1&&(t[0][Sn]<xt.min&&Sn++,t[0][Mn]>xt.max&&Mn--),k.min=Ii[Sn],k.max=Ii[Mn]}else k.show&&k.auto&&Ht(xt,dt,k,t[q],k.sorted);k.idxs[0]=Sn,k.idxs[1]=Mn}else if(q>0&&k.show&&k.auto){let[Q,dt]=k.facets,xt=Q.scale,wt=dt.scale,[Nt,Dt]=t[q],kt=S[xt],ae=S[wt];kt!=null&&Ht(kt,z[xt],Q,Nt,Q.sorted),ae!=null&&Ht(ae,z[wt],dt,Dt,dt.sorted),k.min=dt.min,k.max=dt.max}});for(let k in S){let q=S[k],Q=z[k];if(q.from==null&&(Q==null||Q.min==null)){let dt=q.range(n,q.min==Ze?null:q.min,q.max==-Ze?null:q.max,k);q.min=dt[0],q.max=dt[1]}}}for(let k in S){let q=S[k];if(q.from!=null){let Q=S[q.from];if(Q.min==null)q.min=q.max=null;else{let dt=q.range(n,Q.min,Q.max,k);q.min=dt[0],q.max=dt[1]}}}let A={},U=!1;for(let k in S){let q=S[k],Q=_[k];if(Q.min!=q.min||Q.max!=q.max){Q.min=q.min,Q.max=q.max;let dt=Q.distr;Q._min=dt==3?ar(Q.min):dt==4?Gp(Q.min,Q.asinh):dt==100?Q.fwd(Q.min):Q.min,Q._max=dt==3?ar(Q.max):dt==4?Gp(Q.max,Q.asinh):dt==100?Q.fwd(Q.max):Q.max,A[k]=U=!0}}if(U){x.forEach((k,q)=>{i==2?q>0&&A.y&&(k._paths=null):A[k.scale]&&(k._paths=null)});for(let k in A)vt=!0,Xn("setScale",k);st&&it.left>=0&&(rt=_t=!0)}for(let k in z)z[k]=null}function zt(S){let A=Jp(Sn-1,0,xn-1),U=Jp(Mn+1,0,xn-1);for(;S[A]==null&&A>0;)A--;for(;S[U]==null&&U<xn-1;)U++;return[A,U]}function xe(){if(xn>0){let S=x.some(A=>A._focus)&&Pt!=Bt.alpha;S&&(u.globalAlpha=Pt=Bt.alpha),x.forEach((A,U)=>{if(U>0&&A.show&&(dn(U,!1),dn(U,!0),A._paths==null)){let k=Pt;Pt!=A.alpha&&(u.globalAlpha=Pt=A.alpha);let q=i==2?[0,t[U][0].length-1]:zt(t[U]);A._paths=A.paths(n,U,q[0],q[1]),Pt!=k&&(u.globalAlpha=Pt=k)}}),x.forEach((A,U)=>{if(U>0&&A.show){let k=Pt;Pt!=A.alpha&&(u.globalAlpha=Pt=A.alpha),A._paths!=null&&Fe(U,!1);{let q=A._paths!=null?A._paths.gaps:null,Q=A.points.show(n,U,Sn,Mn,q),dt=A.points.filter(n,U,Q,q);(Q||dt)&&(A.points._paths=A.points.paths(n,U,Sn,Mn,dt),Fe(U,!0))}Pt!=k&&(u.globalAlpha=Pt=k),Xn("drawSeries",U)}}),S&&(u.globalAlpha=Pt=1)}}function dn(S,A){let U=A?x[S].points:x[S];U._stroke=U.stroke(n,S),U._fill=U.fill(n,S)}function Fe(S,A){let U=A?x[S].points:x[S],{stroke:k,fill:q,clip:Q,flags:dt,_stroke:xt=U._stroke,_fill:wt=U._fill,_width:Nt=U.width}=U._paths;Nt=$e(Nt*Ie,3);let Dt=null,kt=Nt%2/2;A&&wt==null&&(wt=Nt>0?"#fff":xt);let ae=U.pxAlign==1&&kt>0;if(ae&&u.translate(kt,kt),!A){let Ce=N-Nt/2,Ae=T-Nt/2,be=j+Nt,Qt=pt+Nt;Dt=new Path2D,Dt.rect(Ce,Ae,be,Qt)}A?Ft(xt,Nt,U.dash,U.cap,wt,k,q,dt,Q):ke(S,xt,Nt,U.dash,U.cap,wt,k,q,dt,Dt,Q),ae&&u.translate(-kt,-kt)}function ke(S,A,U,k,q,Q,dt,xt,wt,Nt,Dt){let kt=!1;wt!=0&&E.forEach((ae,Ce)=>{if(ae.series[0]==S){let Ae=x[ae.series[1]],be=t[ae.series[1]],Qt=(Ae._paths||ec).band;Dr(Qt)&&(Qt=ae.dir==1?Qt[0]:Qt[1]);let jt,sn=null;Ae.show&&Qt&&ET(be,Sn,Mn)?(sn=ae.fill(n,Ce)||Q,jt=Ae._paths.clip):Qt=null,Ft(A,U,k,q,sn,dt,xt,wt,Nt,Dt,jt,Qt),kt=!0}}),kt||Ft(A,U,k,q,Q,dt,xt,wt,Nt,Dt)}let Un=Ra|tm;function Ft(S,A,U,k,q,Q,dt,xt,wt,Nt,Dt,kt){At(S,A,U,k,q),(wt||Nt||kt)&&(u.save(),wt&&u.clip(wt),Nt&&u.clip(Nt)),kt?(xt&Un)==Un?(u.clip(kt),Dt&&u.clip(Dt),we(q,dt),An(S,Q,A)):xt&tm?(we(q,dt),u.clip(kt),An(S,Q,A)):xt&Ra&&(u.save(),u.clip(kt),Dt&&u.clip(Dt),we(q,dt),u.restore(),An(S,Q,A)):(we(q,dt),An(S,Q,A)),(wt||Nt||kt)&&u.restore()}function An(S,A,U){U>0&&(A instanceof Map?A.forEach((k,q)=>{u.strokeStyle=vo=q,u.stroke(k)}):A!=null&&S&&u.stroke(A))}function we(S,A){A instanceof Map?A.forEach((U,k)=>{u.fillStyle=ur=k,u.fill(U)}):A!=null&&S&&u.fill(A)}function zs(S,A,U,k){let q=v[S],Q;if(k<=0)Q=[0,0];else{let dt=q._space=q.space(n,S,A,U,k),xt=q._incrs=q.incrs(n,S,A,U,k,dt);Q=qA(A,U,xt,k,dt)}return q._found=Q}function Rn(S,A,U,k,q,Q,dt,xt,wt,Nt){let Dt=dt%2/2;y==1&&u.translate(Dt,Dt),At(xt,dt,wt,Nt,xt),u.beginPath();let kt,ae,Ce,Ae,be=q+(k==0||k==3?-Q:Q);U==0?(ae=q,Ae=be):(kt=q,Ce=be);for(let Qt=0;Qt<S.length;Qt++)A[Qt]!=null&&(U==0?kt=Ce=S[Qt]:ae=Ae=S[Qt],u.moveTo(kt,ae),u.lineTo(Ce,Ae));u.stroke(),y==1&&u.translate(-Dt,-Dt)}function So(S){let A=!0;return v.forEach((U,k)=>{if(!U.show)return;let q=_[U.scale];if(q.min==null){U._show&&(A=!1,U._show=!1,fe(!1));return}else U._show||(A=!1,U._show=!0,fe(!1));let Q=U.side,dt=Q%2,{min:xt,max:wt}=q,[Nt,Dt]=zs(k,xt,wt,dt==0?G:Ct);if(Dt==0)return;let kt=q.distr==2,ae=U._splits=U.splits(n,k,xt,wt,Nt,Dt,kt),Ce=q.distr==2?ae.map(jt=>Ii[jt]):ae,Ae=q.distr==2?Ii[ae[1]]-Ii[ae[0]]:Nt,be=U._values=U.values(n,U.filter(n,Ce,k,Dt,Ae),k,Dt,Ae);U._rotate=Q==2?U.rotate(n,be,k,Dt):0;let Qt=U._size;U._size=es(U.size(n,be,k,S)),Qt!=null&&U._size!=Qt&&(A=!1)}),A}function Ss(S){let A=!0;return Ba.forEach((U,k)=>{let q=U(n,k,vs,S);q!=rs[k]&&(A=!1),rs[k]=q}),A}function Hs(){for(let S=0;S<v.length;S++){let A=v[S];if(!A.show||!A._show)continue;let U=A.side,k=U%2,q,Q,dt=A.stroke(n,S),xt=U==0||U==3?-1:1,[wt,Nt]=A._found;if(A.label!=null){let mi=A.labelGap*xt,Di=Bn((A._lpos+mi)*Ie);It(A.labelFont[0],dt,"center",U==2?"top":Lx),u.save(),k==1?(q=Q=0,u.translate(Di,Bn(T+pt/2)),u.rotate((U==3?-Xu:Xu)/2)):(q=Bn(N+j/2),Q=Di);let zr=v_(A.label)?A.label(n,S,wt,Nt):A.label;u.fillText(zr,q,Q),u.restore()}if(Nt==0)continue;let Dt=_[A.scale],kt=k==0?j:pt,ae=k==0?N:T,Ce=A._splits,Ae=Dt.distr==2?Ce.map(mi=>Ii[mi]):Ce,be=Dt.distr==2?Ii[Ce[1]]-Ii[Ce[0]]:wt,Qt=A.ticks,jt=A.border,sn=Qt.show?Qt.size:0,yn=Bn(sn*Ie),qn=Bn((A.alignTo==2?A._size-sn-A.gap:A.gap)*Ie),Ge=A._rotate*-Xu/180,bn=p(A._pos*Ie),Li=(yn+qn)*xt,pi=bn+Li;Q=k==0?pi:0,q=k==1?pi:0;let Wi=A.font[0],os=A.align==1?wa:A.align==2?zp:Ge>0?wa:Ge<0?zp:k==0?"center":U==3?zp:wa,Ts=Ge||k==1?"middle":U==2?"top":Lx;It(Wi,dt,os,Ts);let Ni=A.font[1]*A.lineGap,Xi=Ce.map(mi=>p(a(mi,Dt,kt,ae))),as=A._values;for(let mi=0;mi<as.length;mi++){let Di=as[mi];if(Di!=null){k==0?q=Xi[mi]:Q=Xi[mi],Di=""+Di;let zr=Di.indexOf(`
`)==-1?[Di]:Di.split(/\n/gm);for(let gi=0;gi<zr.length;gi++){let $m=zr[gi];Ge?(u.save(),u.translate(q,Q+gi*Ni),u.rotate(Ge),u.fillText($m,0,0),u.restore()):u.fillText($m,q,Q+gi*Ni)}}}Qt.show&&Rn(Xi,Qt.filter(n,Ae,S,Nt,be),k,U,bn,yn,$e(Qt.width*Ie,3),Qt.stroke(n,S),Qt.dash,Qt.cap);let As=A.grid;As.show&&Rn(Xi,As.filter(n,Ae,S,Nt,be),k,k==0?2:1,k==0?T:N,k==0?pt:j,$e(As.width*Ie,3),As.stroke(n,S),As.dash,As.cap),jt.show&&Rn([bn],[1],k==0?1:0,k==0?1:2,k==1?T:N,k==1?pt:j,$e(jt.width*Ie,3),jt.stroke(n,S),jt.dash,jt.cap)}Xn("drawAxes")}function fe(S){x.forEach((A,U)=>{U>0&&(A._paths=null,S&&(i==1?(A.min=null,A.max=null):A.facets.forEach(k=>{k.min=null,k.max=null})))})}let _n=!1,fi=!1,Oe=[];function Cn(){fi=!1;for(let S=0;S<Oe.length;S++)Xn(...Oe[S]);Oe.length=0}function ni(){_n||(BT(Lm),_n=!0)}function yc(S,A=!1){_n=!0,fi=A,S(n),Lm(),A&&Oe.length>0&&queueMicrotask(Cn)}n.batch=yc;function Lm(){if(ut&&(ge(),ut=!1),vt&&(Et(),vt=!1),bt){if(on(f,wa,Kt),on(f,"top",le),on(f,Jl,G),on(f,Kl,Ct),on(g,wa,Kt),on(g,"top",le),on(g,Jl,G),on(g,Kl,Ct),on(d,Jl,gn),on(d,Kl,Tn),h.width=Bn(gn*Ie),h.height=Bn(Tn*Ie),v.forEach(({_el:S,_show:A,_size:U,_pos:k,side:q})=>{if(S!=null)if(A){let Q=q===3||q===0?U:0,dt=q%2==1;on(S,dt?"left":"top",k-Q),on(S,dt?"width":"height",U),on(S,dt?"top":"left",dt?le:Kt),on(S,dt?"height":"width",dt?Ct:G),Zp(S,po)}else Hi(S,po)}),vo=ur=wo=W=et=J=K=Tt=R=null,Pt=1,Wa(!0),Kt!=Mt||le!=We||G!=Wt||Ct!=$t){fe(!1);let S=G/Wt,A=Ct/$t;if(st&&!rt&&it.left>=0){it.left*=S,it.top*=A,Mo&&ks(Mo,Bn(it.left),0,G,Ct),Eo&&ks(Eo,0,Bn(it.top),G,Ct);for(let U=0;U<ce.length;U++){let k=ce[U];k!=null&&(tn[U]*=S,di[U]*=A,ks(k,es(tn[U]),es(di[U]),G,Ct))}}if(nn.show&&!ct&&nn.left>=0&&nn.width>0){nn.left*=S,nn.width*=S,nn.top*=A,nn.height*=A;for(let U in Jd)on(Ro,U,nn[U])}Mt=Kt,We=le,Wt=G,$t=Ct}Xn("setSize"),bt=!1}gn>0&&Tn>0&&(u.clearRect(0,0,h.width,h.height),Xn("drawClear"),M.forEach(S=>S()),Xn("draw")),nn.show&&ct&&(bc(nn),ct=!1),st&&rt&&(Br(null,!0,!1),rt=!1),at.show&&at.live&&_t&&(Zd(),_t=!1),c||(c=!0,n.status=1,Xn("ready")),hr=!1,_n=!1}n.redraw=(S,A)=>{vt=A||!1,S!==!1?fr(w,C.min,C.max):ni()};function qd(S,A){let U=_[S];if(U.from==null){if(xn==0){let k=U.range(n,A.min,A.max,S);A.min=k[0],A.max=k[1]}if(A.min>A.max){let k=A.min;A.min=A.max,A.max=k}if(xn>1&&A.min!=null&&A.max!=null&&A.max-A.min<1e-16)return;S==w&&U.distr==2&&xn>0&&(A.min=_s(A.min,t[0]),A.max=_s(A.max,t[0]),A.min==A.max&&A.max++),z[S]=A,ut=!0,ni()}}n.setScale=qd;let Yd,jd,Mo,Eo,Nm,Dm,To,Ao,Um,Fm,en,ln,dr=!1,Qn=it.drag,Gn=Qn.x,Wn=Qn.y;st&&(it.x&&(Yd=ts(cT,g)),it.y&&(jd=ts(hT,g)),C.ori==0?(Mo=Yd,Eo=jd):(Mo=jd,Eo=Yd),en=it.left,ln=it.top);let nn=n.select=Nn({show:!0,over:!0,left:0,width:0,top:0,height:0},s.select),Ro=nn.show?ts(lT,nn.over?g:f):null;function bc(S,A){if(nn.show){for(let U in S)nn[U]=S[U],U in Jd&&on(Ro,U,S[U]);A!==!1&&Xn("setSelect")}}n.setSelect=bc;function Zy(S){if(x[S].show)Y&&Zp(Jt[S],po);else if(Y&&Hi(Jt[S],po),st){let U=Rt?ce[0]:ce[S];U!=null&&ks(U,-10,-10,G,Ct)}}function fr(S,A,U){qd(S,{min:A,max:U})}function Ms(S,A,U,k){A.focus!=null&&tb(S),A.show!=null&&x.forEach((q,Q)=>{Q>0&&(S==Q||S==null)&&(q.show=A.show,Zy(Q),i==2?(fr(q.facets[0].scale,null,null),fr(q.facets[1].scale,null,null)):fr(q.scale,null,null),ni())}),U!==!1&&Xn("setSeries",S,A),k&&Xa("setSeries",n,S,A)}n.setSeries=Ms;function $y(S,A){Nn(E[S],A)}function Jy(S,A){S.fill=Se(S.fill||null),S.dir=Re(S.dir,-1),A=A??E.length,E.splice(A,0,S)}function Ky(S){S==null?E.length=0:E.splice(S,1)}n.addBand=Jy,n.setBand=$y,n.delBand=Ky;function Qy(S,A){x[S].alpha=A,st&&ce[S]!=null&&(ce[S].style.opacity=A),Y&&Jt[S]&&(Jt[S].style.opacity=A)}let Vs,pr,Or,Co={focus:!0};function tb(S){if(S!=Or){let A=S==null,U=Bt.alpha!=1;x.forEach((k,q)=>{if(i==1||q>0){let Q=A||q==0||q==S;k._focus=A?null:Q,U&&Qy(q,Q?1:Bt.alpha)}}),Or=S,U&&ni()}}Y&&ne&&Ee(Fx,lt,S=>{it._lock||(ee(S),Or!=null&&Ms(null,Co,!0,Pn.setSeries))});function Es(S,A,U){let k=_[A];U&&(S=S/Ie-(k.ori==1?le:Kt));let q=G;k.ori==1&&(q=Ct,S=q-S),k.dir==-1&&(S=q-S);let Q=k._min,dt=k._max,xt=S/q,wt=Q+(dt-Q)*xt,Nt=k.distr;return Nt==3?Ea(10,wt):Nt==4?AT(wt,k.asinh):Nt==100?k.bwd(wt):wt}function eb(S,A){let U=Es(S,w,A);return _s(U,t[0],Sn,Mn)}n.valToIdx=S=>_s(S,t[0]),n.posToIdx=eb,n.posToVal=Es,n.valToPos=(S,A,U)=>_[A].ori==0?r(S,_[A],U?j:G,U?N:0):o(S,_[A],U?pt:Ct,U?T:0),n.setCursor=(S,A,U)=>{en=S.left,ln=S.top,Br(null,A,U)};function km(S,A){on(Ro,wa,nn.left=S),on(Ro,Jl,nn.width=A)}function Om(S,A){on(Ro,"top",nn.top=S),on(Ro,Kl,nn.height=A)}let Va=C.ori==0?km:Om,Ga=C.ori==1?km:Om;function nb(){if(Y&&at.live)for(let S=i==2?1:0;S<x.length;S++){if(S==0&&de)continue;let A=at.values[S],U=0;for(let k in A)Ot[S][U++].firstChild.nodeValue=A[k]}}function Zd(S,A){if(S!=null&&(S.idxs?S.idxs.forEach((U,k)=>{$[k]=U}):IT(S.idx)||$.fill(S.idx),at.idx=$[0]),Y&&at.live){for(let U=0;U<x.length;U++)(U>0||i==1&&!de)&&ib(U,$[U]);nb()}_t=!1,A!==!1&&Xn("setLegend")}n.setLegend=Zd;function ib(S,A){let U=x[S],k=S==0&&D==2?Ii:t[S],q;de?q=U.values(n,S,A)??oe:(q=U.value(n,A==null?null:k[A],S,A),q=q==null?oe:{_:q}),at.values[S]=q}function Br(S,A,U){Um=en,Fm=ln,[en,ln]=it.move(n,en,ln),it.left=en,it.top=ln,st&&(Mo&&ks(Mo,Bn(en),0,G,Ct),Eo&&ks(Eo,0,Bn(ln),G,Ct));let k,q=Sn>Mn;Vs=Ze,pr=null;let Q=C.ori==0?G:Ct,dt=C.ori==1?G:Ct;if(en<0||xn==0||q){k=it.idx=null;for(let xt=0;xt<x.length;xt++){let wt=ce[xt];wt!=null&&ks(wt,-10,-10,G,Ct)}ne&&Ms(null,Co,!0,S==null&&Pn.setSeries),at.live&&($.fill(k),_t=!0)}else{let xt,wt,Nt;i==1&&(xt=C.ori==0?en:ln,wt=Es(xt,w),k=it.idx=_s(wt,t[0],Sn,Mn),Nt=B(t[0][k],C,Q,0));let Dt=-10,kt=-10,ae=0,Ce=0,Ae=!0,be="",Qt="";for(let jt=i==2?1:0;jt<x.length;jt++){let sn=x[jt],yn=$[jt],qn=yn==null?null:i==1?t[jt][yn]:t[jt][1][yn],Ge=it.dataIdx(n,jt,k,wt),bn=Ge==null?null:i==1?t[jt][Ge]:t[jt][1][Ge];if(_t=_t||bn!=qn||Ge!=yn,$[jt]=Ge,jt>0&&sn.show){let Li=Ge==null?-10:Ge==k?Nt:B(i==1?t[0][Ge]:t[jt][0][Ge],C,Q,0),pi=bn==null?-10:L(bn,i==1?_[sn.scale]:_[sn.facets[1].scale],dt,0);if(ne&&bn!=null){let Wi=C.ori==1?en:ln,os=zn(Bt.dist(n,jt,Ge,pi,Wi));if(os<Vs){let Ts=Bt.bias;if(Ts!=0){let Ni=Es(Wi,sn.scale),Xi=bn>=0?1:-1,as=Ni>=0?1:-1;as==Xi&&(as==1?Ts==1?bn>=Ni:bn<=Ni:Ts==1?bn<=Ni:bn>=Ni)&&(Vs=os,pr=jt)}else Vs=os,pr=jt}}if(_t||Rt){let Wi,os;C.ori==0?(Wi=Li,os=pi):(Wi=pi,os=Li);let Ts,Ni,Xi,as,As,mi,Di=!0,zr=ft.bbox;if(zr!=null){Di=!1;let gi=zr(n,jt);Xi=gi.left,as=gi.top,Ts=gi.width,Ni=gi.height}else Xi=Wi,as=os,Ts=Ni=ft.size(n,jt);if(mi=ft.fill(n,jt),As=ft.stroke(n,jt),Rt)jt==pr&&Vs<=Bt.prox&&(Dt=Xi,kt=as,ae=Ts,Ce=Ni,Ae=Di,be=mi,Qt=As);else{let gi=ce[jt];gi!=null&&(tn[jt]=Xi,di[jt]=as,Gx(gi,Ts,Ni,Di),Hx(gi,mi,As),ks(gi,es(Xi),es(as),G,Ct))}}}}if(Rt){let jt=Bt.prox,sn=Or==null?Vs<=jt:Vs>jt||pr!=Or;if(_t||sn){let yn=ce[0];yn!=null&&(tn[0]=Dt,di[0]=kt,Gx(yn,ae,Ce,Ae),Hx(yn,be,Qt),ks(yn,es(Dt),es(kt),G,Ct))}}}if(nn.show&&dr)if(S!=null){let[xt,wt]=Pn.scales,[Nt,Dt]=Pn.match,[kt,ae]=S.cursor.sync.scales,Ce=S.cursor.drag;if(Gn=Ce._x,Wn=Ce._y,Gn||Wn){let{left:Ae,top:be,width:Qt,height:jt}=S.select,sn=S.scales[kt].ori,yn=S.posToVal,qn,Ge,bn,Li,pi,Wi=xt!=null&&Nt(xt,kt),os=wt!=null&&Dt(wt,ae);Wi&&Gn?(sn==0?(qn=Ae,Ge=Qt):(qn=be,Ge=jt),bn=_[xt],Li=B(yn(qn,kt),bn,Q,0),pi=B(yn(qn+Ge,kt),bn,Q,0),Va(ys(Li,pi),zn(pi-Li))):Va(0,Q),os&&Wn?(sn==1?(qn=Ae,Ge=Qt):(qn=be,Ge=jt),bn=_[wt],Li=L(yn(qn,ae),bn,dt,0),pi=L(yn(qn+Ge,ae),bn,dt,0),Ga(ys(Li,pi),zn(pi-Li))):Ga(0,dt)}else Kd()}else{let xt=zn(Um-Nm),wt=zn(Fm-Dm);if(C.ori==1){let ae=xt;xt=wt,wt=ae}Gn=Qn.x&&xt>=Qn.dist,Wn=Qn.y&&wt>=Qn.dist;let Nt=Qn.uni;Nt!=null?Gn&&Wn&&(Gn=xt>=Nt,Wn=wt>=Nt,!Gn&&!Wn&&(wt>xt?Wn=!0:Gn=!0)):Qn.x&&Qn.y&&(Gn||Wn)&&(Gn=Wn=!0);let Dt,kt;Gn&&(C.ori==0?(Dt=To,kt=en):(Dt=Ao,kt=ln),Va(ys(Dt,kt),zn(kt-Dt)),Wn||Ga(0,dt)),Wn&&(C.ori==1?(Dt=To,kt=en):(Dt=Ao,kt=ln),Ga(ys(Dt,kt),zn(kt-Dt)),Gn||Va(0,Q)),!Gn&&!Wn&&(Va(0,0),Ga(0,0))}if(Qn._x=Gn,Qn._y=Wn,S==null){if(U){if(Zm!=null){let[xt,wt]=Pn.scales;Pn.values[0]=xt!=null?Es(C.ori==0?en:ln,xt):null,Pn.values[1]=wt!=null?Es(C.ori==1?en:ln,wt):null}Xa(Hp,n,en,ln,G,Ct,k)}if(ne){let xt=U&&Pn.setSeries,wt=Bt.prox;Or==null?Vs<=wt&&Ms(pr,Co,!0,xt):Vs>wt?Ms(null,Co,!0,xt):pr!=Or&&Ms(pr,Co,!0,xt)}}_t&&(at.idx=k,Zd()),A!==!1&&Xn("setCursor")}let mr=null;Object.defineProperty(n,"rect",{get(){return mr==null&&Wa(!1),mr}});function Wa(S=!1){S?mr=null:(mr=g.getBoundingClientRect(),Xn("syncRect",mr))}function Bm(S,A,U,k,q,Q,dt){it._lock||dr&&S!=null&&S.movementX==0&&S.movementY==0||($d(S,A,U,k,q,Q,dt,!1,S!=null),S!=null?Br(null,!0,!0):Br(A,!0,!1))}function $d(S,A,U,k,q,Q,dt,xt,wt){if(mr==null&&Wa(!1),ee(S),S!=null)U=S.clientX-mr.left,k=S.clientY-mr.top;else{if(U<0||k<0){en=-10,ln=-10;return}let[Nt,Dt]=Pn.scales,kt=A.cursor.sync,[ae,Ce]=kt.values,[Ae,be]=kt.scales,[Qt,jt]=Pn.match,sn=A.axes[0].side%2==1,yn=C.ori==0?G:Ct,qn=C.ori==1?G:Ct,Ge=sn?Q:q,bn=sn?q:Q,Li=sn?k:U,pi=sn?U:k;if(Ae!=null?U=Qt(Nt,Ae)?a(ae,_[Nt],yn,0):-10:U=yn*(Li/Ge),be!=null?k=jt(Dt,be)?a(Ce,_[Dt],qn,0):-10:k=qn*(pi/bn),C.ori==1){let Wi=U;U=k,k=Wi}}wt&&(A==null||A.cursor.event.type==Hp)&&((U<=1||U>=G-1)&&(U=uo(U,G)),(k<=1||k>=Ct-1)&&(k=uo(k,Ct))),xt?(Nm=U,Dm=k,[To,Ao]=it.move(n,U,k)):(en=U,ln=k)}let Jd={width:0,height:0,left:0,top:0};function Kd(){bc(Jd,!1)}let zm,Hm,Vm,Gm;function Wm(S,A,U,k,q,Q,dt){dr=!0,Gn=Wn=Qn._x=Qn._y=!1,$d(S,A,U,k,q,Q,dt,!0,!1),S!=null&&(Ee(Vp,Yp,Xm,!1),Xa(Dx,n,To,Ao,G,Ct,null));let{left:xt,top:wt,width:Nt,height:Dt}=nn;zm=xt,Hm=wt,Vm=Nt,Gm=Dt}function Xm(S,A,U,k,q,Q,dt){dr=Qn._x=Qn._y=!1,$d(S,A,U,k,q,Q,dt,!1,!0);let{left:xt,top:wt,width:Nt,height:Dt}=nn,kt=Nt>0||Dt>0,ae=zm!=xt||Hm!=wt||Vm!=Nt||Gm!=Dt;if(kt&&ae&&bc(nn),Qn.setScale&&kt&&ae){let Ce=xt,Ae=Nt,be=wt,Qt=Dt;if(C.ori==1&&(Ce=wt,Ae=Dt,be=xt,Qt=Nt),Gn&&fr(w,Es(Ce,w),Es(Ce+Ae,w)),Wn)for(let jt in _){let sn=_[jt];jt!=w&&sn.from==null&&sn.min!=Ze&&fr(jt,Es(be+Qt,jt),Es(be,jt))}Kd()}else it.lock&&(it._lock=!it._lock,Br(A,!0,S!=null));S!=null&&(Dn(Vp,Yp),Xa(Vp,n,en,ln,G,Ct,null))}function sb(S,A,U,k,q,Q,dt){if(it._lock)return;ee(S);let xt=dr;if(dr){let wt=!0,Nt=!0,Dt=10,kt,ae;C.ori==0?(kt=Gn,ae=Wn):(kt=Wn,ae=Gn),kt&&ae&&(wt=en<=Dt||en>=G-Dt,Nt=ln<=Dt||ln>=Ct-Dt),kt&&wt&&(en=en<To?0:G),ae&&Nt&&(ln=ln<Ao?0:Ct),Br(null,!0,!0),dr=!1}en=-10,ln=-10,$.fill(null),Br(null,!0,!0),xt&&(dr=xt)}function qm(S,A,U,k,q,Q,dt){it._lock||(ee(S),Ha(),Kd(),S!=null&&Xa(kx,n,en,ln,G,Ct,null))}function Ym(){v.forEach(YA),V(n.width,n.height,!0)}mo(qu,Ma,Ym);let Po={};Po.mousedown=Wm,Po.mousemove=Bm,Po.mouseup=Xm,Po.dblclick=qm,Po.setSeries=(S,A,U,k)=>{let q=Pn.match[2];U=q(n,A,U),U!=-1&&Ms(U,k,!0,!1)},st&&(Ee(Dx,g,Wm),Ee(Hp,g,Bm),Ee(Ux,g,S=>{ee(S),Wa(!1)}),Ee(Fx,g,sb),Ee(kx,g,qm),em.add(n),n.syncRect=Wa);let vc=n.hooks=s.hooks||{};function Xn(S,A,U){fi?Oe.push([S,A,U]):S in vc&&vc[S].forEach(k=>{k.call(null,n,A,U)})}(s.plugins||[]).forEach(S=>{for(let A in S.hooks)vc[A]=(vc[A]||[]).concat(S.hooks[A])});let jm=(S,A,U)=>U,Pn=Nn({key:null,setSeries:!1,filters:{pub:jx,sub:jx},scales:[w,x[1]?x[1].scale:null],match:[Zx,Zx,jm],values:[null,null]},it.sync);Pn.match.length==2&&Pn.match.push(jm),it.sync=Pn;let Zm=Pn.key,Qd=X_(Zm);function Xa(S,A,U,k,q,Q,dt){Pn.filters.pub(S,A,U,k,q,Q,dt)&&Qd.pub(S,A,U,k,q,Q,dt)}Qd.sub(n);function rb(S,A,U,k,q,Q,dt){Pn.filters.sub(S,A,U,k,q,Q,dt)&&Po[S](null,A,U,k,q,Q,dt)}n.pub=rb;function ob(){Qd.unsub(n),em.delete(n),Vn.clear(),$p(qu,Ma,Ym),l.remove(),lt?.remove(),Xn("destroy")}n.destroy=ob;function tf(){Xn("init",s,t),za(t||s.data,!1),z[w]?qd(w,z[w]):Ha(),ct=nn.show&&(nn.width>0||nn.height>0),rt=_t=!0,V(s.width,s.height)}return x.forEach(bo),v.forEach(Os),e?e instanceof HTMLElement?(e.appendChild(l),tf()):e(n,tf):tf(),n}ei.assign=Nn;ei.fmtNum=lm;ei.rangeNum=Yu;ei.rangeLog=$u;ei.rangeAsinh=om;ei.orient=xo;ei.pxRatio=Ie;ei.join=OT;ei.fmtDate=hm,ei.tzDate=ZT;ei.sync=X_;{ei.addGap=IA,ei.clipGaps=Qu;let s=ei.paths={points:J_};s.linear=Q_,s.stepped=DA,s.bars=UA,s.spline=kA}var jA=s=>new RegExp(`^(${s}|${s==="R"?"right":"left"}).*(hip|knee|ankle|leg)`,"i");function xm(s,t,e){let n=s.rows(10),i=r=>Math.max(0,...s.pick(r,n).map(o=>Math.abs(o??0)));return s.names().filter(r=>r.startsWith(t)).map(r=>[i(r),r]).sort((r,o)=>o[0]-r[0]).slice(0,e).map(([,r])=>r)}var _m={Legs:s=>[["right leg [rad]","R","STATE.q."],["left leg [rad]","L","STATE.q."],["knees and ankles [N m]","","STATE.tau."]].map(([t,e,n])=>[t,s.joints.filter(i=>e?jA(e).test(i):/knee|ankle_p/i.test(i)).map(i=>n+i)]),"Feet forces":s=>{let t=s.names().filter(e=>e.startsWith("SHOWN.foot_force."));return[["vertical force [N]",t]].concat(t.map(e=>e.slice(17)).map(e=>[`${e.replaceAll("_"," ")} [N, N m]`,["fx","fy","tx","ty"].map(n=>`STATE.wrench.${e}.${n}`)]))},ZMP:()=>["x","y"].map(s=>[`${s} [m]`,["zmp_reference","zmp","dcm","com"].map(t=>`SHOWN.${t}.${s}`)]).concat([["ZMP inside [mm]",["SHOWN.margin_mm"]]]),"Tracking error":s=>[["commanded less measured [rad], the largest six",xm(s,"TRACKING.q.",6)]],"Two logs":s=>{let t=xm(s,"RESIDUAL.q.",6),e=t[0]?.slice(11);return[["left foot, vertical force [N]",["STATE.wrench.left_foot.fz","OTHER.wrench.left_foot.fz"]],[`${e??"joint"} [rad]`,e?[`STATE.q.${e}`,`OTHER.q.${e}`]:[]],["second less first [rad]",t]]},"Source difference":s=>[["standby less active [rad], the largest six",xm(s,"DIFFERENCE.q.",6)]]};function ic(s,t){let e=document.createElement("a");e.href=URL.createObjectURL(s),e.download=t,e.click(),setTimeout(()=>URL.revokeObjectURL(e.href),1e4)}var id=class{constructor(t,e,n){this.names=t,this.colour=n,this.canvas=Object.assign(document.createElement("canvas"),{width:Math.max(120,e.clientWidth),height:Math.max(60,e.clientHeight)}),this.canvas.setAttribute("role","img"),this.canvas.setAttribute("aria-label",`${t[0]} over ${t[1]}`),this.ctx=this.canvas.getContext("2d"),e.append(this.canvas)}destroy(){this.canvas.remove()}setScale(){}setData([,t,e]){let{ctx:n,canvas:i}=this,r=getComputedStyle(document.body);n.clearRect(0,0,i.width,i.height);let o=t.map((y,p)=>[e[p],y]).filter(([y,p])=>y!==null&&p!==null);if(this.points=o.length,o.length===0)return;let a=y=>{let p=o.map(_=>_[y]),[m,x]=[Math.min(...p),Math.max(...p)],v=.05*(x-m)||.001*Math.max(1,Math.abs(x));return[m-v,x+v]},[[c,l],[h,u]]=[a(0),a(1)],[d,f]=[52,24],g=([y,p])=>[d+(y-c)/(l-c)*(i.width-d-6),i.height-f-(p-h)/(u-h)*(i.height-f-6)];n.font='11px "DejaVu Sans", sans-serif',n.fillStyle=n.strokeStyle=r.getPropertyValue("--dim").trim(),n.lineWidth=1;for(let y=0;y<=4;++y){let[p,m]=[c+y/4*(l-c),h+y/4*(u-h)];n.textAlign=y===4?"right":"center",n.fillText(Number(p.toPrecision(3)),g([p,h])[0],i.height-8),n.textAlign="right",n.fillText(Number(m.toPrecision(3)),d-6,g([c,m])[1]+(y===4?10:4))}n.strokeRect(d,6,i.width-d-6,i.height-f-6),n.strokeStyle=n.fillStyle=this.colour,n.lineWidth=1.6,n.beginPath(),o.forEach((y,p)=>p===0?n.moveTo(...g(y)):n.lineTo(...g(y))),n.stroke(),n.beginPath(),n.arc(...g(o.at(-1)),3.5,0,2*Math.PI),n.fill()}};var sd=["#58c4ff","#ffb020","#ff5ac8","#3ecf8e","#b07cff","#ff6b6b","#e8edf4","#c9e265"],ZA=120,ym=40,iy=8,$A=3,sy="twinbus.plots",sc=/^(.+?)\s+(?:over|vs)\s+(.+)$/,Si=(s,t={},e=[])=>{let n=Object.assign(document.createElement(s),t);return n.append(...e),n},rd=class{constructor(t,e,n){this.box=t,this.history=e,this.lookBack=n,this.plots=[],this.held=null,this.drawnAt=0;let i=r=>t.querySelector(r);this.room=i(".plots"),this.search=i("input"),this.found=i(".found"),this.seconds=i("select"),i(".presets").append(...Object.keys(_m).map(r=>Si("button",{className:"chip",textContent:r,onclick:()=>this.preset(r)}))),this.layouts=i(".layouts"),this.layouts.onchange=()=>this.layout(this.layouts.value),i(".keep").onclick=()=>this.keep(),this.listLayouts(),i(".png").onclick=()=>this.png(),i(".csv").onclick=()=>this.csv(),this.search.oninput=()=>this.offer(),this.search.onkeydown=r=>{r.key==="Enter"&&this.found.firstChild&&this.found.firstChild.click()},this.search.onfocus=()=>this.offer(),this.search.onblur=()=>setTimeout(()=>{this.found.hidden=!0},200),this.room.ondragover=r=>r.preventDefault(),this.room.ondrop=r=>{r.preventDefault();let o=this.plots.find(a=>a.node.contains(r.target));this.put(r.dataTransfer.getData("text/plain"),o)},addEventListener("resize",()=>this.plots.forEach(r=>{r.chart?.destroy(),r.chart=null}))}get open(){return!this.box.hidden}toggle(t){this.box.hidden=!t,t&&this.plots.length===0&&this.preset("ZMP")}preset(t){this.clear();for(let[e,n]of _m[t](this.history))this.add(e,n);for(let e of this.box.querySelectorAll(".presets button"))e.classList.toggle("on",e.textContent===t)}kept(){try{return JSON.parse(localStorage.getItem(sy)??"{}")??{}}catch{return{}}}listLayouts(){let t=Object.keys(this.kept()).sort();this.layouts.replaceChildren(Si("option",{value:"",textContent:"kept \u2026"}),...t.map(e=>Si("option",{value:e,textContent:e}))),this.layouts.hidden=t.length===0}keep(t=prompt("Keep these plots under which name?",this.layouts.value)){if(!t)return;let e=this.kept();this.plots.length===0?delete e[t]:e[t]={seconds:this.seconds.value,plots:this.plots.map(n=>[n.title,n.names])};try{localStorage.setItem(sy,JSON.stringify(e))}catch{}this.listLayouts(),this.layouts.value=e[t]?t:""}layout(t){let e=this.kept()[t];if(e){this.clear(),this.seconds.value=e.seconds;for(let[n,i]of e.plots)this.add(n,i)}}clear(){for(let t of[...this.plots])this.remove(t)}remove(t){t.chart?.destroy(),t.node.remove(),this.plots=this.plots.filter(e=>e!==t),this.rebuild()}add(t,e){let n={title:t,names:e.slice(0,iy),chart:null},i=Si("button",{className:"close",textContent:"\xD7",title:"remove this plot",onclick:()=>this.remove(n)});return n.legend=Si("div",{className:"legend"}),n.area=Si("div",{className:"area"}),n.node=Si("div",{className:"plot"},[Si("header",{},[Si("b",{textContent:t}),i]),n.legend,n.area]),this.room.append(n.node),this.plots.push(n),this.rebuild(),n}put(t,e){if(sc.test(t)){this.add(t,[t]);return}if(!t.startsWith("=")&&!this.history.columns.has(t))return;let n=e??(this.plots.length<$A?null:this.plots.at(-1));if(!n||sc.test(n.names[0]??"")){this.add(t.startsWith("=")?t.slice(1).trim():t.split(".").slice(0,2).join("."),[t]);return}!n.names.includes(t)&&n.names.length<iy&&n.names.push(t),n.chart?.destroy(),n.chart=null}offerComputed(){let t=this.search.value.trim(),e=sc.exec(t);if(!t.startsWith("=")&&!e)return!1;let n=null;try{for(let o of e?e.slice(1):[t])Du(o,this.history)}catch(o){n=o.message}let i=e?e.slice(1).map(o=>this.history.columns.has(o)?o:`= ${o.replace(/^=\s*/,"")}`).join(" over "):t,r=Si("li",{textContent:n??`plot ${i}`,className:n?"more":""});return n||(r.onclick=()=>{this.put(i),this.search.blur()}),this.found.replaceChildren(r),this.found.hidden=!1,!0}offer(){if(this.offerComputed())return;let t=this.search.value.toLowerCase().split(/[\s.]+/).filter(Boolean),e=this.history.names().filter(n=>t.every(i=>n.toLowerCase().includes(i)));this.found.replaceChildren(...e.slice(0,ym).map(n=>{let i=Si("li",{textContent:n,draggable:!0});return i.ondragstart=r=>r.dataTransfer.setData("text/plain",n),i.onclick=()=>{this.put(n),this.search.blur()},i})),e.length>ym&&this.found.append(Si("li",{className:"more",textContent:`and ${e.length-ym} more`})),e.length===0&&this.found.append(Si("li",{className:"more",textContent:"nothing of that name was heard"})),this.found.hidden=!1}rebuild(){for(let t of this.plots)t.chart?.destroy(),t.chart=null}chart(t,e){let n=getComputedStyle(document.body),[i,r]=[n.getPropertyValue("--dim").trim(),n.getPropertyValue("--grid").trim()],o={stroke:i,grid:{stroke:r,width:1},ticks:{show:!1},font:'11px "DejaVu Sans", sans-serif'},a=t.names.map(c=>c.replace(/^(SHOWN|STATE|TRACKING|DIFFERENCE|RESIDUAL)\.(q\.|tau\.)?/,""));return t.legend.replaceChildren(...a.map((c,l)=>Si("span",{title:t.names[l]},[Si("i",{style:`background:${sd[l]}`}),c]))),new ei({width:Math.max(120,t.area.clientWidth),height:Math.max(60,t.area.clientHeight),legend:{show:!1},cursor:{sync:{key:"twinbus"},drag:{x:!1,y:!1},points:{size:6}},scales:{x:{time:!1}},axes:[{...o,size:24,values:(c,l)=>l.map(h=>`${+h.toFixed(2)} s`)},{...o,size:52}],series:[{},...t.names.map((c,l)=>({label:c,stroke:sd[l],width:1.6,points:{show:!1}}))],hooks:{setCursor:[c=>{this.held!==null&&c.cursor.idx!=null&&this.lookBack(c.data[0][c.cursor.idx])}],ready:[c=>{c.over.addEventListener("click",()=>{let l=c.posToVal(c.cursor.left,"x");this.seek?.(l)||(this.hold(this.held===null?this.history.last:null),this.held!==null&&this.lookBack(l))})}]}},e,t.area)}hold(t){this.held=t,t===null&&this.lookBack(null)}tick(){let t=performance.now();if(!this.open||t-this.drawnAt<ZA||this.history.count===0)return;this.drawnAt=t;let e=this.held??this.history.last,n=Number(this.seconds.value),i=this.history.rows(n,e),r=i.map(o=>this.history.time[o]);for(let o of this.plots){if(this.held!==null&&o.chart&&o.heldAt===e)continue;o.heldAt=this.held;let a=[r,...o.names.map(l=>this.history.pick(l,i))],c=sc.exec(o.names[0]??"");if(c){o.chart??=new id(c.slice(1),o.area,sd[0]),o.chart.setData([r,...c.slice(1).map(l=>this.history.pick(l,i))]);continue}o.chart?o.chart.setData(a,!1):o.chart=this.chart(o,a),o.chart.setScale("x",{min:e-n,max:e})}}png(){let t=this.plots.filter(a=>a.chart);if(t.length===0)return;let e=46,n=document.createElement("canvas");n.width=Math.max(...t.map(a=>a.chart.ctx.canvas.width)),n.height=t.reduce((a,c)=>a+c.chart.ctx.canvas.height+e,0);let i=n.getContext("2d"),r=getComputedStyle(document.body);i.fillStyle=r.getPropertyValue("--ground").trim(),i.fillRect(0,0,n.width,n.height);let o=0;for(let a of t){i.font='bold 14px "DejaVu Sans", sans-serif',i.fillStyle=r.getPropertyValue("--ink").trim(),i.fillText(a.title,10,o+18),i.font='12px "DejaVu Sans", sans-serif';let c=10;a.names.forEach((l,h)=>{i.fillStyle=sd[h],i.fillText(l,c,o+36),c+=i.measureText(l).width+14}),i.drawImage(a.chart.ctx.canvas,0,o+e),o+=a.chart.ctx.canvas.height+e}n.toBlob(a=>ic(a,"twinbus_plots.png"))}csv(){let t=[...new Set(this.plots.flatMap(o=>o.names).flatMap(o=>sc.exec(o)?.slice(1)??[o]))],e=this.history.rows(Number(this.seconds.value),this.held??this.history.last),n=t.map(o=>this.history.pick(o,e)),i=e.map((o,a)=>[this.history.time[o],...n.map(c=>c[a]??"")].join(",")),r=[["time_s",...t].join(","),...i].join(`
`)+`
`;this.lastCsv=r,ic(new Blob([r],{type:"text/csv"}),"twinbus_plots.csv")}};var JA=300,KA=500,ry=.2,QA=.2,od=class{constructor(t,e,n,i,r){Object.assign(this,{stage:t,canvas:e,robot:n,push:i,say:r,armed:!1,held:null,done:()=>{}}),this.ray=new to,this.arrow=new Pl(new F(1,0,0),new F,.1,16735581,.06,.04),this.arrow.visible=!1,t.scene.add(this.arrow),e.addEventListener("pointerdown",o=>this.take(o),!0),e.addEventListener("pointermove",o=>this.pull(o),!0),e.addEventListener("pointerup",o=>this.letGo(o),!0),e.addEventListener("pointercancel",()=>this.arm(!1),!0)}arm(t){return this.armed=t,this.held=null,this.arrow.visible=!1,document.body.classList.toggle("pushing",t),t?this.say("Pull at the robot in the picture: it is pushed that way."):this.done(),t}aim(t){let e=this.canvas.getBoundingClientRect();this.ray.setFromCamera(new Vt(2*(t.clientX-e.x)/e.width-1,1-2*(t.clientY-e.y)/e.height),this.stage.camera)}linkAt(){let t=null,e=QA;for(let[n,i]of Object.entries(this.robot.model.links)){if(i.parent?.jointType==="fixed")continue;let r=i.getWorldPosition(new F),o=this.ray.ray.distanceToPoint(r);o<e&&([t,e]=[{link:n,at:r},o])}return t}take(t){if(!(!this.armed||t.button!==0||!this.robot.model)){if(t.stopImmediatePropagation(),this.aim(t),this.held=this.linkAt(),!this.held){this.say("There is nothing of the robot there.");return}this.plane=new xi().setFromNormalAndCoplanarPoint(this.stage.camera.getWorldDirection(new F),this.held.at),this.force=new F,this.canvas.setPointerCapture(t.pointerId)}}pull(t){if(!this.held)return;t.stopImmediatePropagation(),this.aim(t);let e=this.ray.ray.intersectPlane(this.plane,new F);if(!e)return;let n=e.sub(this.held.at);this.force=n.clone().multiplyScalar(JA).clampLength(0,KA),this.arrow.position.copy(this.held.at),this.arrow.setDirection(n.clone().normalize()),this.arrow.setLength(Math.max(.05,n.length()),.06,.04),this.arrow.visible=!0}letGo(t){if(!this.held)return;t.stopImmediatePropagation();let{link:e}=this.held;this.force.length()>5&&(this.push({link:e,force:this.force.toArray(),point:[0,0,0],seconds:ry}),this.say(`${e} is pushed with ${this.force.length().toFixed(0)} N for ${ry} s.`)),this.arm(!1)}};var ad=class{constructor(t){this.canvas=t,this.recorder=null}start(){if(!window.MediaRecorder||!this.canvas.captureStream)return!1;let t=["video/webm;codecs=vp9","video/webm"].find(n=>MediaRecorder.isTypeSupported(n));if(!t)return!1;let e=[];return this.recorder=new MediaRecorder(this.canvas.captureStream(30),{mimeType:t,videoBitsPerSecond:6e6}),this.recorder.ondataavailable=n=>e.push(n.data),this.recorder.onstop=()=>ic(new Blob(e,{type:"video/webm"}),"twinbus.webm"),this.recorder.start(1e3),!0}stop(){this.recorder?.stop(),this.recorder=null}};function oy(s,t=Math.PI/3){let e=s.index?s.toNonIndexed():s,n=e.attributes.position,i=n.count,r;if(n.isBufferAttribute===!0&&n.itemSize===3&&n.normalized===!1)r=n.array;else{r=new Float64Array(i*3);for(let _=0;_<i;_++)r[3*_+0]=n.getX(_),r[3*_+1]=n.getY(_),r[3*_+2]=n.getZ(_)}let o=Math.cos(t),a=(1+1e-10)*100,c=i/3,l=new Float64Array(c*3);for(let _=0;_<c;_++){let E=9*_,w=r[E+0],b=r[E+1],M=r[E+2],I=r[E+3],P=r[E+4],C=r[E+5],D=r[E+6],B=r[E+7],L=r[E+8],z=D-I,O=B-P,H=L-C,tt=w-I,X=b-P,Z=M-C,$=O*Z-H*X,at=H*tt-z*Z,it=z*X-O*tt,Y=1/(Math.sqrt($*$+at*at+it*it)||1);l[3*_+0]=$*Y,l[3*_+1]=at*Y,l[3*_+2]=it*Y}let h=new Int32Array(i),u=new Float64Array(i*3),d=1;for(;d<i*2;)d<<=1;let f=d-1,g=new Int32Array(d),y=0;for(let _=0;_<i;_++){let E=3*_,w=Math.trunc(r[E+0]*a),b=Math.trunc(r[E+1]*a),M=Math.trunc(r[E+2]*a),I=(Math.imul(w,73856093)^Math.imul(b,19349663)^Math.imul(M,83492791))&f;for(;;){let P=g[I];if(P===0){let D=3*y;u[D+0]=w,u[D+1]=b,u[D+2]=M,g[I]=y+1,h[_]=y++;break}let C=3*(P-1);if(u[C+0]===w&&u[C+1]===b&&u[C+2]===M){h[_]=P-1;break}I=I+1&f}}let p=new Int32Array(y+1);for(let _=0;_<i;_++)p[h[_]+1]++;for(let _=0;_<y;_++)p[_+1]+=p[_];let m=new Int32Array(i),x=p.slice(0,y);for(let _=0;_<c;_++){let E=3*_;m[x[h[E+0]]++]=_,m[x[h[E+1]]++]=_,m[x[h[E+2]]++]=_}let v=new Float32Array(i*3);for(let _=0;_<c;_++){let E=3*_,w=l[E+0],b=l[E+1],M=l[E+2];for(let I=0;I<3;I++){let P=E+I,C=h[P],D=0,B=0,L=0;for(let O=p[C],H=p[C+1];O<H;O++){let tt=3*m[O],X=l[tt+0],Z=l[tt+1],$=l[tt+2];w*X+b*Z+M*$>o&&(D+=X,B+=Z,L+=$)}let z=1/(Math.sqrt(D*D+B*B+L*L)||1);v[3*P+0]=D*z,v[3*P+1]=B*z,v[3*P+2]=L*z}}return e.setAttribute("normal",new Xe(v,3,!1)),e}var tR=/^[og]\s*(.+)?/,eR=/^mtllib /,nR=/^usemtl /,iR=/^usemap /,ld=/\s+/,ay=new F,bm=new F,ly=new F,cy=new F,ns=new F,cd=new qt;function sR(){let s={objects:[],object:{},vertices:[],normals:[],colors:[],uvs:[],materials:{},materialLibraries:[],startObject:function(t,e){if(this.object&&this.object.fromDeclaration===!1){this.object.name=t,this.object.fromDeclaration=e!==!1;return}let n=this.object&&typeof this.object.currentMaterial=="function"?this.object.currentMaterial():void 0;if(this.object&&typeof this.object._finalize=="function"&&this.object._finalize(!0),this.object={name:t||"",fromDeclaration:e!==!1,geometry:{vertices:[],normals:[],colors:[],uvs:[],hasUVIndices:!1},materials:[],smooth:!0,startMaterial:function(i,r){let o=this._finalize(!1);o&&(o.inherited||o.groupCount<=0)&&this.materials.splice(o.index,1);let a={index:this.materials.length,name:i||"",mtllib:Array.isArray(r)&&r.length>0?r[r.length-1]:"",smooth:o!==void 0?o.smooth:this.smooth,groupStart:o!==void 0?o.groupEnd:0,groupEnd:-1,groupCount:-1,inherited:!1,clone:function(c){let l={index:typeof c=="number"?c:this.index,name:this.name,mtllib:this.mtllib,smooth:this.smooth,groupStart:0,groupEnd:-1,groupCount:-1,inherited:!1};return l.clone=this.clone.bind(l),l}};return this.materials.push(a),a},currentMaterial:function(){if(this.materials.length>0)return this.materials[this.materials.length-1]},_finalize:function(i){let r=this.currentMaterial();if(r&&r.groupEnd===-1&&(r.groupEnd=this.geometry.vertices.length/3,r.groupCount=r.groupEnd-r.groupStart,r.inherited=!1),i&&this.materials.length>1)for(let o=this.materials.length-1;o>=0;o--)this.materials[o].groupCount<=0&&this.materials.splice(o,1);return i&&this.materials.length===0&&this.materials.push({name:"",smooth:this.smooth}),r}},n&&n.name&&typeof n.clone=="function"){let i=n.clone(0);i.inherited=!0,this.object.materials.push(i)}this.objects.push(this.object)},finalize:function(){this.object&&typeof this.object._finalize=="function"&&this.object._finalize(!0)},parseVertexIndex:function(t,e){let n=parseInt(t,10);return(n>=0?n-1:n+e/3)*3},parseNormalIndex:function(t,e){let n=parseInt(t,10);return(n>=0?n-1:n+e/3)*3},parseUVIndex:function(t,e){let n=parseInt(t,10);return(n>=0?n-1:n+e/2)*2},addVertex:function(t,e,n){let i=this.vertices,r=this.object.geometry.vertices;r.push(i[t+0],i[t+1],i[t+2]),r.push(i[e+0],i[e+1],i[e+2]),r.push(i[n+0],i[n+1],i[n+2])},addVertexPoint:function(t){let e=this.vertices;this.object.geometry.vertices.push(e[t+0],e[t+1],e[t+2])},addVertexLine:function(t){let e=this.vertices;this.object.geometry.vertices.push(e[t+0],e[t+1],e[t+2])},addNormal:function(t,e,n){let i=this.normals,r=this.object.geometry.normals;r.push(i[t+0],i[t+1],i[t+2]),r.push(i[e+0],i[e+1],i[e+2]),r.push(i[n+0],i[n+1],i[n+2])},addFaceNormal:function(t,e,n){let i=this.vertices,r=this.object.geometry.normals;ay.fromArray(i,t),bm.fromArray(i,e),ly.fromArray(i,n),ns.subVectors(ly,bm),cy.subVectors(ay,bm),ns.cross(cy),ns.normalize(),r.push(ns.x,ns.y,ns.z),r.push(ns.x,ns.y,ns.z),r.push(ns.x,ns.y,ns.z)},addColor:function(t,e,n){let i=this.colors,r=this.object.geometry.colors;i[t]!==void 0&&r.push(i[t+0],i[t+1],i[t+2]),i[e]!==void 0&&r.push(i[e+0],i[e+1],i[e+2]),i[n]!==void 0&&r.push(i[n+0],i[n+1],i[n+2])},addUV:function(t,e,n){let i=this.uvs,r=this.object.geometry.uvs;r.push(i[t+0],i[t+1]),r.push(i[e+0],i[e+1]),r.push(i[n+0],i[n+1])},addDefaultUV:function(){let t=this.object.geometry.uvs;t.push(0,0),t.push(0,0),t.push(0,0)},addUVLine:function(t){let e=this.uvs;this.object.geometry.uvs.push(e[t+0],e[t+1])},addFace:function(t,e,n,i,r,o,a,c,l){let h=this.vertices.length,u=this.parseVertexIndex(t,h),d=this.parseVertexIndex(e,h),f=this.parseVertexIndex(n,h);if(this.addVertex(u,d,f),this.addColor(u,d,f),a!==void 0&&a!==""){let g=this.normals.length;u=this.parseNormalIndex(a,g),d=this.parseNormalIndex(c,g),f=this.parseNormalIndex(l,g),this.addNormal(u,d,f)}else this.addFaceNormal(u,d,f);if(i!==void 0&&i!==""){let g=this.uvs.length;u=this.parseUVIndex(i,g),d=this.parseUVIndex(r,g),f=this.parseUVIndex(o,g),this.addUV(u,d,f),this.object.geometry.hasUVIndices=!0}else this.addDefaultUV()},addPointGeometry:function(t){this.object.geometry.type="Points";let e=this.vertices.length;for(let n=0,i=t.length;n<i;n++){let r=this.parseVertexIndex(t[n],e);this.addVertexPoint(r),this.addColor(r)}},addLineGeometry:function(t,e){this.object.geometry.type="Line";let n=this.vertices.length,i=this.uvs.length;for(let r=0,o=t.length-1;r<o;r++)this.addVertexLine(this.parseVertexIndex(t[r],n)),this.addVertexLine(this.parseVertexIndex(t[r+1],n));for(let r=0,o=e.length-1;r<o;r++)this.addUVLine(this.parseUVIndex(e[r],i)),this.addUVLine(this.parseUVIndex(e[r+1],i))}};return s.startObject("",!1),s}var hd=class extends li{constructor(t){super(t),this.materials=null}load(t,e,n,i){let r=this,o=new Is(this.manager);o.setPriority(this.priority),o.setCache(this.cache),o.setPath(this.path),o.setRequestHeader(this.requestHeader),o.setWithCredentials(this.withCredentials),o.load(t,function(a){try{e(r.parse(a))}catch(c){i?i(c):console.error(c),r.manager.itemError(t)}},n,i)}setMaterials(t){return this.materials=t,this}parse(t){let e=new sR;t.indexOf(`\r
`)!==-1&&(t=t.replace(/\r\n/g,`
`)),t.indexOf(`\\
`)!==-1&&(t=t.replace(/\\\n/g,""));let n=t.split(`
`),i=[];for(let a=0,c=n.length;a<c;a++){let l=n[a].trimStart();if(l.length===0)continue;let h=l.charAt(0);if(h!=="#")if(h==="v"){let u=l.split(ld);switch(u[0]){case"v":e.vertices.push(parseFloat(u[1]),parseFloat(u[2]),parseFloat(u[3])),u.length>=7?(cd.setRGB(parseFloat(u[4]),parseFloat(u[5]),parseFloat(u[6]),Pe),e.colors.push(cd.r,cd.g,cd.b)):e.colors.push(void 0,void 0,void 0);break;case"vn":e.normals.push(parseFloat(u[1]),parseFloat(u[2]),parseFloat(u[3]));break;case"vt":e.uvs.push(parseFloat(u[1]),parseFloat(u[2]));break}}else if(h==="f"){let d=l.slice(1).trim().split(ld),f=[];for(let y=0,p=d.length;y<p;y++){let m=d[y];if(m.length>0){let x=m.split("/");f.push(x)}}let g=f[0];for(let y=1,p=f.length-1;y<p;y++){let m=f[y],x=f[y+1];e.addFace(g[0],m[0],x[0],g[1],m[1],x[1],g[2],m[2],x[2])}}else if(h==="l"){let u=l.substring(1).trim().split(ld),d=[],f=[];if(l.indexOf("/")===-1)d=u;else for(let g=0,y=u.length;g<y;g++){let p=u[g].split("/");p[0]!==""&&d.push(p[0]),p[1]!==""&&f.push(p[1])}e.addLineGeometry(d,f)}else if(h==="p"){let d=l.slice(1).trim().split(ld);e.addPointGeometry(d)}else if((i=tR.exec(l))!==null){let u=(" "+i[0].slice(1).trim()).slice(1);e.startObject(u)}else if(nR.test(l))e.object.startMaterial(l.substring(7).trim(),e.materialLibraries);else if(eR.test(l))e.materialLibraries.push(l.substring(7).trim());else if(iR.test(l))console.warn('THREE.OBJLoader: Rendering identifier "usemap" not supported. Textures must be defined in MTL files.');else if(h==="s"){if(i=l.split(" "),i.length>1){let d=i[1].trim().toLowerCase();e.object.smooth=d!=="0"&&d!=="off"}else e.object.smooth=!0;let u=e.object.currentMaterial();u&&(u.smooth=e.object.smooth)}else{if(l==="\0")continue;console.warn('THREE.OBJLoader: Unexpected line: "'+l+'"')}}e.finalize();let r=new Be;if(r.materialLibraries=[].concat(e.materialLibraries),!(e.objects.length===1&&e.objects[0].geometry.vertices.length===0)===!0)for(let a=0,c=e.objects.length;a<c;a++){let l=e.objects[a],h=l.geometry,u=l.materials,d=h.type==="Line",f=h.type==="Points",g=!1;if(h.vertices.length===0)continue;let y=new ue;y.setAttribute("position",new Xt(h.vertices,3)),h.normals.length>0&&y.setAttribute("normal",new Xt(h.normals,3)),h.colors.length>0&&(g=!0,y.setAttribute("color",new Xt(h.colors,3))),h.hasUVIndices===!0&&y.setAttribute("uv",new Xt(h.uvs,2));let p=[];for(let x=0,v=u.length;x<v;x++){let _=u[x],E=_.name+"_"+_.smooth+"_"+g,w=e.materials[E];if(this.materials!==null){if(w=this.materials.create(_.name),d&&w&&!(w instanceof pn)){let b=new pn;yi.prototype.copy.call(b,w),b.color.copy(w.color),w=b}else if(f&&w&&!(w instanceof ps)){let b=new ps({size:10,sizeAttenuation:!1});yi.prototype.copy.call(b,w),b.color.copy(w.color),b.map=w.map,w=b}}w===void 0&&(d?w=new pn:f?w=new ps({size:1,sizeAttenuation:!1}):w=new $i,w.name=_.name,w.flatShading=!_.smooth,w.vertexColors=g,e.materials[E]=w),p.push(w)}let m;if(p.length>1){for(let x=0,v=u.length;x<v;x++){let _=u[x];y.addGroup(_.groupStart,_.groupCount,x)}d?m=new Ti(y,p):f?m=new Js(y,p):m=new gt(y,p)}else d?m=new Ti(y,p[0]):f?m=new Js(y,p[0]):m=new gt(y,p[0]);m.name=l.name,r.add(m)}else if(e.vertices.length>0){let a=new ps({size:1,sizeAttenuation:!1}),c=new ue;c.setAttribute("position",new Xt(e.vertices,3)),e.colors.length>0&&e.colors[0]!==void 0&&(c.setAttribute("color",new Xt(e.colors,3)),a.vertexColors=!0);let l=new Js(c,a);r.add(l)}return r}};var ud=class extends li{constructor(t){super(t)}load(t,e,n,i){let r=this,o=new Is(this.manager);o.setPriority(this.priority),o.setCache(this.cache),o.setPath(this.path),o.setResponseType("arraybuffer"),o.setRequestHeader(this.requestHeader),o.setWithCredentials(this.withCredentials),o.load(t,function(a){try{e(r.parse(a))}catch(c){i?i(c):console.error(c),r.manager.itemError(t)}},n,i)}parse(t){function e(l){let h=new DataView(l),u=32/8*3+32/8*3*3+16/8,d=h.getUint32(80,!0);if(80+32/8+d*u===h.byteLength)return!0;let g=[115,111,108,105,100];for(let y=0;y<5;y++)if(n(g,h,y))return!1;return!0}function n(l,h,u){for(let d=0,f=l.length;d<f;d++)if(l[d]!==h.getUint8(u+d))return!1;return!0}function i(l){let h=new DataView(l),u=h.getUint32(80,!0),d,f,g,y=!1,p,m,x,v,_;for(let C=0;C<=70;C++)h.getUint32(C,!1)==1129270351&&h.getUint8(C+4)==82&&h.getUint8(C+5)==61&&(y=!0,p=new Float32Array(u*3*3),m=h.getUint8(C+6)/255,x=h.getUint8(C+7)/255,v=h.getUint8(C+8)/255,_=h.getUint8(C+9)/255);let E=84,w=50,b=new ue,M=new Float32Array(u*3*3),I=new Float32Array(u*3*3),P=new qt;for(let C=0;C<u;C++){let D=E+C*w,B=h.getFloat32(D,!0),L=h.getFloat32(D+4,!0),z=h.getFloat32(D+8,!0);if(y){let O=h.getUint16(D+48,!0);(O&32768)===0?(d=(O&31)/31,f=(O>>5&31)/31,g=(O>>10&31)/31):(d=m,f=x,g=v)}for(let O=1;O<=3;O++){let H=D+O*12,tt=C*3*3+(O-1)*3;M[tt]=h.getFloat32(H,!0),M[tt+1]=h.getFloat32(H+4,!0),M[tt+2]=h.getFloat32(H+8,!0),I[tt]=B,I[tt+1]=L,I[tt+2]=z,y&&(P.setRGB(d,f,g,Pe),p[tt]=P.r,p[tt+1]=P.g,p[tt+2]=P.b)}}return b.setAttribute("position",new Xe(M,3)),b.setAttribute("normal",new Xe(I,3)),y&&(b.setAttribute("color",new Xe(p,3)),b.hasColors=!0,b.alpha=_),b}function r(l){let h=new ue,u=/solid([\s\S]*?)endsolid/g,d=/facet([\s\S]*?)endfacet/g,f=/solid\s(.+)/,g=0,y=/[\s]+([+-]?(?:\d*)(?:\.\d*)?(?:[eE][+-]?\d+)?)/.source,p=new RegExp("vertex"+y+y+y,"g"),m=new RegExp("normal"+y+y+y,"g"),x=[],v=[],_=[],E=new F,w,b=0,M=0,I=0;for(;(w=u.exec(l))!==null;){M=I;let P=w[0],C=(w=f.exec(P))!==null?w[1]:"";for(_.push(C);(w=d.exec(P))!==null;){let L=0,z=0,O=w[0];for(;(w=m.exec(O))!==null;)E.x=parseFloat(w[1]),E.y=parseFloat(w[2]),E.z=parseFloat(w[3]),z++;for(;(w=p.exec(O))!==null;)x.push(parseFloat(w[1]),parseFloat(w[2]),parseFloat(w[3])),v.push(E.x,E.y,E.z),L++,I++;z!==1&&console.error("THREE.STLLoader: Something isn't right with the normal of face number "+g),L!==3&&console.error("THREE.STLLoader: Something isn't right with the vertices of face number "+g),g++}let D=M,B=I-M;h.userData.groupNames=_,h.addGroup(D,B,b),b++}return h.setAttribute("position",new Xt(x,3)),h.setAttribute("normal",new Xt(v,3)),h}function o(l){return typeof l!="string"?new TextDecoder().decode(l):l}function a(l){if(typeof l=="string"){let h=new Uint8Array(l.length);for(let u=0;u<l.length;u++)h[u]=l.charCodeAt(u)&255;return h.buffer||h}else return l}let c=a(t);return e(c)?i(c):r(o(t))}};var rc=class extends Ml{constructor(t){super(t)}parse(t){function e(O){switch(O.image_type){case d:case y:if(O.colormap_length>256||O.colormap_size!==24||O.colormap_type!==1)throw new Error("THREE.TGALoader: Invalid type colormap data for indexed type.");break;case f:case g:case p:case m:if(O.colormap_type)throw new Error("THREE.TGALoader: Invalid type colormap data for colormap type.");break;case u:throw new Error("THREE.TGALoader: No data.");default:throw new Error("THREE.TGALoader: Invalid type "+O.image_type)}if(O.width<=0||O.height<=0)throw new Error("THREE.TGALoader: Invalid image size.");if(O.pixel_size!==8&&O.pixel_size!==16&&O.pixel_size!==24&&O.pixel_size!==32)throw new Error("THREE.TGALoader: Invalid pixel size "+O.pixel_size)}function n(O,H,tt,X,Z){let $,at,it=tt.pixel_size>>3,Y=tt.width*tt.height*it;if(H&&(at=Z.subarray(X,X+=tt.colormap_length*(tt.colormap_size>>3))),O){$=new Uint8Array(Y);let st,nt,lt,mt=0,Ut=new Uint8Array(it);for(;mt<Y;)if(st=Z[X++],nt=(st&127)+1,st&128){for(lt=0;lt<it;++lt)Ut[lt]=Z[X++];for(lt=0;lt<nt;++lt)$.set(Ut,mt+lt*it);mt+=it*nt}else{for(nt*=it,lt=0;lt<nt;++lt)$[mt+lt]=Z[X++];mt+=nt}}else $=Z.subarray(X,X+=H?tt.width*tt.height:Y);return{pixel_data:$,palettes:at}}function i(O,H,tt,X,Z,$,at,it,Y){let st=Y,nt=P.colormap_index,lt,mt=0,Ut,Jt,Ot=P.width;for(Jt=H;Jt!==X;Jt+=tt)for(Ut=Z;Ut!==at;Ut+=$,mt++)lt=it[mt]-nt,O[(Ut+Ot*Jt)*4+3]=255,O[(Ut+Ot*Jt)*4+2]=st[lt*3+0],O[(Ut+Ot*Jt)*4+1]=st[lt*3+1],O[(Ut+Ot*Jt)*4+0]=st[lt*3+2];return O}function r(O,H,tt,X,Z,$,at,it){let Y,st=0,nt,lt,mt=P.width;for(lt=H;lt!==X;lt+=tt)for(nt=Z;nt!==at;nt+=$,st+=2)Y=it[st+0]+(it[st+1]<<8),O[(nt+mt*lt)*4+0]=(Y&31744)>>7,O[(nt+mt*lt)*4+1]=(Y&992)>>2,O[(nt+mt*lt)*4+2]=(Y&31)<<3,O[(nt+mt*lt)*4+3]=Y&32768?0:255;return O}function o(O,H,tt,X,Z,$,at,it){let Y=0,st,nt,lt=P.width;for(nt=H;nt!==X;nt+=tt)for(st=Z;st!==at;st+=$,Y+=3)O[(st+lt*nt)*4+3]=255,O[(st+lt*nt)*4+2]=it[Y+0],O[(st+lt*nt)*4+1]=it[Y+1],O[(st+lt*nt)*4+0]=it[Y+2];return O}function a(O,H,tt,X,Z,$,at,it){let Y=0,st,nt,lt=P.width;for(nt=H;nt!==X;nt+=tt)for(st=Z;st!==at;st+=$,Y+=4)O[(st+lt*nt)*4+2]=it[Y+0],O[(st+lt*nt)*4+1]=it[Y+1],O[(st+lt*nt)*4+0]=it[Y+2],O[(st+lt*nt)*4+3]=it[Y+3];return O}function c(O,H,tt,X,Z,$,at,it){let Y,st=0,nt,lt,mt=P.width;for(lt=H;lt!==X;lt+=tt)for(nt=Z;nt!==at;nt+=$,st++)Y=it[st],O[(nt+mt*lt)*4+0]=Y,O[(nt+mt*lt)*4+1]=Y,O[(nt+mt*lt)*4+2]=Y,O[(nt+mt*lt)*4+3]=255;return O}function l(O,H,tt,X,Z,$,at,it){let Y=0,st,nt,lt=P.width;for(nt=H;nt!==X;nt+=tt)for(st=Z;st!==at;st+=$,Y+=2)O[(st+lt*nt)*4+0]=it[Y+0],O[(st+lt*nt)*4+1]=it[Y+0],O[(st+lt*nt)*4+2]=it[Y+0],O[(st+lt*nt)*4+3]=it[Y+1];return O}function h(O,H,tt,X,Z){let $,at,it,Y,st,nt;switch((P.flags&x)>>v){default:case w:$=0,it=1,st=H,at=0,Y=1,nt=tt;break;case _:$=0,it=1,st=H,at=tt-1,Y=-1,nt=-1;break;case b:$=H-1,it=-1,st=-1,at=0,Y=1,nt=tt;break;case E:$=H-1,it=-1,st=-1,at=tt-1,Y=-1,nt=-1;break}if(B)switch(P.pixel_size){case 8:c(O,at,Y,nt,$,it,st,X);break;case 16:l(O,at,Y,nt,$,it,st,X);break;default:throw new Error("THREE.TGALoader: Format not supported.")}else switch(P.pixel_size){case 8:i(O,at,Y,nt,$,it,st,X,Z);break;case 16:r(O,at,Y,nt,$,it,st,X);break;case 24:o(O,at,Y,nt,$,it,st,X);break;case 32:a(O,at,Y,nt,$,it,st,X);break;default:throw new Error("THREE.TGALoader: Format not supported.")}return O}let u=0,d=1,f=2,g=3,y=9,p=10,m=11,x=48,v=4,_=0,E=1,w=2,b=3;if(t.length<19)throw new Error("THREE.TGALoader: Not enough data to contain header.");let M=0,I=new Uint8Array(t),P={id_length:I[M++],colormap_type:I[M++],image_type:I[M++],colormap_index:I[M++]|I[M++]<<8,colormap_length:I[M++]|I[M++]<<8,colormap_size:I[M++],origin:[I[M++]|I[M++]<<8,I[M++]|I[M++]<<8],width:I[M++]|I[M++]<<8,height:I[M++]|I[M++]<<8,pixel_size:I[M++],flags:I[M++]};if(e(P),P.id_length+M>t.length)throw new Error("THREE.TGALoader: No data.");M+=P.id_length;let C=!1,D=!1,B=!1;switch(P.image_type){case y:C=!0,D=!0;break;case d:D=!0;break;case p:C=!0;break;case f:break;case m:C=!0,B=!0;break;case g:B=!0;break}let L=new Uint8Array(P.width*P.height*4),z=n(C,D,P,M,I);return h(L,P.width,P.height,z.pixel_data,z.palettes),{data:L,width:P.width,height:P.height,flipY:!0,generateMipmaps:!0,minFilter:Ki}}};function Ci(s,t){let e=[],n=s.childNodes;for(let i=0,r=n.length;i<r;i++){let o=n[i];o.nodeName===t&&e.push(o)}return e}function rR(s){return s.length===0?[]:s.trim().split(/\s+/)}function ui(s){return s.length===0?[]:s.trim().split(/\s+/).map(parseFloat)}function dd(s){return s.length===0?[]:s.trim().split(/\s+/).map(t=>parseInt(t))}function $n(s){return s.substring(1)}var fd=class{constructor(){this.count=0}generateId(){return"three_default_"+this.count++}parse(t){if(t.length===0)return null;let e=new DOMParser().parseFromString(t,"application/xml"),n=Ci(e,"COLLADA")[0],i=e.getElementsByTagName("parsererror")[0];if(i!==void 0){let c=Ci(i,"div")[0],l;return c?l=c.textContent:l=this.parserErrorToText(i),console.error(`THREE.ColladaLoader: Failed to parse collada file.
`,l),null}let r=n.getAttribute("version");console.debug("THREE.ColladaLoader: File version",r);let o=this.parseAsset(Ci(n,"asset")[0]),a={animations:{},clips:{},controllers:{},images:{},effects:{},materials:{},cameras:{},lights:{},geometries:{},nodes:{},visualScenes:{},kinematicsModels:{},physicsModels:{},kinematicsScenes:{},joints:{}};return this.library=a,this.collada=n,this.parseLibrary(n,"library_animations","animation",this.parseAnimation.bind(this)),this.parseLibrary(n,"library_animation_clips","animation_clip",this.parseAnimationClip.bind(this)),this.parseLibrary(n,"library_controllers","controller",this.parseController.bind(this)),this.parseLibrary(n,"library_images","image",this.parseImage.bind(this)),this.parseLibrary(n,"library_effects","effect",this.parseEffect.bind(this)),this.parseLibrary(n,"library_materials","material",this.parseMaterial.bind(this)),this.parseLibrary(n,"library_cameras","camera",this.parseCamera.bind(this)),this.parseLibrary(n,"library_lights","light",this.parseLight.bind(this)),this.parseLibrary(n,"library_geometries","geometry",this.parseGeometry.bind(this)),this.parseLibrary(n,"library_nodes","node",this.parseNode.bind(this)),this.parseLibrary(n,"library_visual_scenes","visual_scene",this.parseVisualScene.bind(this)),this.parseLibrary(n,"library_joints","joint",this.parseLibraryJoint.bind(this)),this.parseLibrary(n,"library_kinematics_models","kinematics_model",this.parseKinematicsModel.bind(this)),this.parseLibrary(n,"library_physics_models","physics_model",this.parsePhysicsModel.bind(this)),this.parseLibrary(n,"scene","instance_kinematics_scene",this.parseKinematicsScene.bind(this)),{library:a,asset:o,collada:n}}parserErrorToText(t){let e=[],n=[t];for(;n.length;){let i=n.shift();i.nodeType===Node.TEXT_NODE?e.push(i.textContent):(e.push(`
`),n.push(...i.childNodes))}return e.join("").trim()}parseAsset(t){return{unit:this.parseAssetUnit(Ci(t,"unit")[0]),upAxis:this.parseAssetUpAxis(Ci(t,"up_axis")[0])}}parseAssetUnit(t){return t!==void 0&&t.hasAttribute("meter")===!0?parseFloat(t.getAttribute("meter")):1}parseAssetUpAxis(t){return t!==void 0?t.textContent:"Y_UP"}parseLibrary(t,e,n,i){let r=Ci(t,e)[0];if(r!==void 0){let o=Ci(r,n);for(let a=0;a<o.length;a++)i(o[a])}}parseAnimation(t){let e={sources:{},samplers:{},channels:{}},n=!1;for(let i=0,r=t.childNodes.length;i<r;i++){let o=t.childNodes[i];if(o.nodeType!==1)continue;let a;switch(o.nodeName){case"source":a=o.getAttribute("id"),e.sources[a]=this.parseSource(o);break;case"sampler":a=o.getAttribute("id"),e.samplers[a]=this.parseAnimationSampler(o);break;case"channel":a=o.getAttribute("target"),e.channels[a]=this.parseAnimationChannel(o);break;case"animation":this.parseAnimation(o),n=!0;break;default:}}n===!1&&(this.library.animations[t.getAttribute("id")||vi.generateUUID()]=e)}parseAnimationSampler(t){let e={inputs:{}};for(let n=0,i=t.childNodes.length;n<i;n++){let r=t.childNodes[n];if(r.nodeType===1&&r.nodeName==="input"){let o=$n(r.getAttribute("source")),a=r.getAttribute("semantic");e.inputs[a]=o}}return e}parseAnimationChannel(t){let e={},i=t.getAttribute("target").split("/"),r=i.shift(),o=i.shift(),a=o.indexOf("(")!==-1,c=o.indexOf(".")!==-1;if(c)i=o.split("."),o=i.shift(),e.member=i.shift();else if(a){let l=o.split("(");o=l.shift();for(let h=0;h<l.length;h++)l[h]=parseInt(l[h].replace(/\)/,""));e.indices=l}return e.id=r,e.sid=o,e.arraySyntax=a,e.memberSyntax=c,e.sampler=$n(t.getAttribute("source")),e}parseAnimationClip(t){let e={name:t.getAttribute("id")||"default",start:parseFloat(t.getAttribute("start")||0),end:parseFloat(t.getAttribute("end")||0),animations:[]};for(let n=0,i=t.childNodes.length;n<i;n++){let r=t.childNodes[n];r.nodeType===1&&r.nodeName==="instance_animation"&&e.animations.push($n(r.getAttribute("url")))}this.library.clips[t.getAttribute("id")]=e}parseController(t){let e={};for(let n=0,i=t.childNodes.length;n<i;n++){let r=t.childNodes[n];if(r.nodeType===1)switch(r.nodeName){case"skin":e.id=$n(r.getAttribute("source")),e.skin=this.parseSkin(r);break;case"morph":e.id=$n(r.getAttribute("source")),console.warn("THREE.ColladaLoader: Morph target animation not supported yet.");break}}this.library.controllers[t.getAttribute("id")]=e}parseSkin(t){let e={sources:{}};for(let n=0,i=t.childNodes.length;n<i;n++){let r=t.childNodes[n];if(r.nodeType===1)switch(r.nodeName){case"bind_shape_matrix":e.bindShapeMatrix=ui(r.textContent);break;case"source":let o=r.getAttribute("id");e.sources[o]=this.parseSource(r);break;case"joints":e.joints=this.parseJoints(r);break;case"vertex_weights":e.vertexWeights=this.parseVertexWeights(r);break}}return e}parseJoints(t){let e={inputs:{}};for(let n=0,i=t.childNodes.length;n<i;n++){let r=t.childNodes[n];if(r.nodeType===1&&r.nodeName==="input"){let o=r.getAttribute("semantic"),a=$n(r.getAttribute("source"));e.inputs[o]=a}}return e}parseVertexWeights(t){let e={inputs:{}};for(let n=0,i=t.childNodes.length;n<i;n++){let r=t.childNodes[n];if(r.nodeType===1)switch(r.nodeName){case"input":let o=r.getAttribute("semantic"),a=$n(r.getAttribute("source")),c=parseInt(r.getAttribute("offset"));e.inputs[o]={id:a,offset:c};break;case"vcount":e.vcount=dd(r.textContent);break;case"v":e.v=dd(r.textContent);break}}return e}parseImage(t){let e={init_from:Ci(t,"init_from")[0].textContent};this.library.images[t.getAttribute("id")]=e}parseEffect(t){let e={};for(let n=0,i=t.childNodes.length;n<i;n++){let r=t.childNodes[n];r.nodeType===1&&r.nodeName==="profile_COMMON"&&(e.profile=this.parseEffectProfileCOMMON(r))}this.library.effects[t.getAttribute("id")]=e}parseEffectProfileCOMMON(t){let e={surfaces:{},samplers:{}};for(let n=0,i=t.childNodes.length;n<i;n++){let r=t.childNodes[n];if(r.nodeType===1)switch(r.nodeName){case"newparam":this.parseEffectNewparam(r,e);break;case"technique":e.technique=this.parseEffectTechnique(r);break;case"extra":e.extra=this.parseEffectExtra(r);break}}return e}parseEffectNewparam(t,e){let n=t.getAttribute("sid");for(let i=0,r=t.childNodes.length;i<r;i++){let o=t.childNodes[i];if(o.nodeType===1)switch(o.nodeName){case"surface":e.surfaces[n]=this.parseEffectSurface(o);break;case"sampler2D":e.samplers[n]=this.parseEffectSampler(o);break}}}parseEffectSurface(t){let e={};for(let n=0,i=t.childNodes.length;n<i;n++){let r=t.childNodes[n];r.nodeType===1&&r.nodeName==="init_from"&&(e.init_from=r.textContent)}return e}parseEffectSampler(t){let e={};for(let n=0,i=t.childNodes.length;n<i;n++){let r=t.childNodes[n];r.nodeType===1&&r.nodeName==="source"&&(e.source=r.textContent)}return e}parseEffectTechnique(t){let e={};for(let n=0,i=t.childNodes.length;n<i;n++){let r=t.childNodes[n];if(r.nodeType===1)switch(r.nodeName){case"constant":case"lambert":case"blinn":case"phong":e.type=r.nodeName,e.parameters=this.parseEffectParameters(r);break;case"extra":e.extra=this.parseEffectExtra(r);break}}return e}parseEffectParameters(t){let e={};for(let n=0,i=t.childNodes.length;n<i;n++){let r=t.childNodes[n];if(r.nodeType===1)switch(r.nodeName){case"emission":case"diffuse":case"specular":case"bump":case"ambient":case"shininess":case"transparency":e[r.nodeName]=this.parseEffectParameter(r);break;case"transparent":e[r.nodeName]={opaque:r.hasAttribute("opaque")?r.getAttribute("opaque"):"A_ONE",data:this.parseEffectParameter(r)};break}}return e}parseEffectParameter(t){let e={};for(let n=0,i=t.childNodes.length;n<i;n++){let r=t.childNodes[n];if(r.nodeType===1)switch(r.nodeName){case"color":e[r.nodeName]=ui(r.textContent);break;case"float":e[r.nodeName]=parseFloat(r.textContent);break;case"texture":e[r.nodeName]={id:r.getAttribute("texture"),extra:this.parseEffectParameterTexture(r)};break}}return e}parseEffectParameterTexture(t){let e={technique:{}};for(let n=0,i=t.childNodes.length;n<i;n++){let r=t.childNodes[n];r.nodeType===1&&r.nodeName==="extra"&&this.parseEffectParameterTextureExtra(r,e)}return e}parseEffectParameterTextureExtra(t,e){for(let n=0,i=t.childNodes.length;n<i;n++){let r=t.childNodes[n];r.nodeType===1&&r.nodeName==="technique"&&this.parseEffectParameterTextureExtraTechnique(r,e)}}parseEffectParameterTextureExtraTechnique(t,e){for(let n=0,i=t.childNodes.length;n<i;n++){let r=t.childNodes[n];if(r.nodeType===1)switch(r.nodeName){case"repeatU":case"repeatV":case"offsetU":case"offsetV":e.technique[r.nodeName]=parseFloat(r.textContent);break;case"wrapU":case"wrapV":r.textContent.toUpperCase()==="TRUE"?e.technique[r.nodeName]=1:r.textContent.toUpperCase()==="FALSE"?e.technique[r.nodeName]=0:e.technique[r.nodeName]=parseInt(r.textContent);break;case"bump":e[r.nodeName]=this.parseEffectExtraTechniqueBump(r);break}}}parseEffectExtra(t){let e={};for(let n=0,i=t.childNodes.length;n<i;n++){let r=t.childNodes[n];r.nodeType===1&&r.nodeName==="technique"&&(e.technique=this.parseEffectExtraTechnique(r))}return e}parseEffectExtraTechnique(t){let e={};for(let n=0,i=t.childNodes.length;n<i;n++){let r=t.childNodes[n];if(r.nodeType===1)switch(r.nodeName){case"double_sided":e[r.nodeName]=parseInt(r.textContent);break;case"bump":e[r.nodeName]=this.parseEffectExtraTechniqueBump(r);break}}return e}parseEffectExtraTechniqueBump(t){let e={};for(let n=0,i=t.childNodes.length;n<i;n++){let r=t.childNodes[n];r.nodeType===1&&r.nodeName==="texture"&&(e[r.nodeName]={id:r.getAttribute("texture"),texcoord:r.getAttribute("texcoord"),extra:this.parseEffectParameterTexture(r)})}return e}parseMaterial(t){let e={name:t.getAttribute("name")};for(let n=0,i=t.childNodes.length;n<i;n++){let r=t.childNodes[n];r.nodeType===1&&r.nodeName==="instance_effect"&&(e.url=$n(r.getAttribute("url")))}this.library.materials[t.getAttribute("id")]=e}parseCamera(t){let e={name:t.getAttribute("name")};for(let n=0,i=t.childNodes.length;n<i;n++){let r=t.childNodes[n];r.nodeType===1&&r.nodeName==="optics"&&(e.optics=this.parseCameraOptics(r))}this.library.cameras[t.getAttribute("id")]=e}parseCameraOptics(t){for(let e=0;e<t.childNodes.length;e++){let n=t.childNodes[e];if(n.nodeName==="technique_common")return this.parseCameraTechnique(n)}return{}}parseCameraTechnique(t){let e={};for(let n=0;n<t.childNodes.length;n++){let i=t.childNodes[n];switch(i.nodeName){case"perspective":case"orthographic":e.technique=i.nodeName,e.parameters=this.parseCameraParameters(i);break}}return e}parseCameraParameters(t){let e={};for(let n=0;n<t.childNodes.length;n++){let i=t.childNodes[n];switch(i.nodeName){case"xfov":case"yfov":case"xmag":case"ymag":case"znear":case"zfar":case"aspect_ratio":e[i.nodeName]=parseFloat(i.textContent);break}}return e}parseLight(t){let e={};for(let n=0,i=t.childNodes.length;n<i;n++){let r=t.childNodes[n];r.nodeType===1&&r.nodeName==="technique_common"&&(e=this.parseLightTechnique(r))}this.library.lights[t.getAttribute("id")]=e}parseLightTechnique(t){let e={};for(let n=0,i=t.childNodes.length;n<i;n++){let r=t.childNodes[n];if(r.nodeType===1)switch(r.nodeName){case"directional":case"point":case"spot":case"ambient":e.technique=r.nodeName,e.parameters=this.parseLightParameters(r);break}}return e}parseLightParameters(t){let e={};for(let n=0,i=t.childNodes.length;n<i;n++){let r=t.childNodes[n];if(r.nodeType===1)switch(r.nodeName){case"color":let o=ui(r.textContent);e.color=new qt().fromArray(o),he.colorSpaceToWorking(e.color,Pe);break;case"falloff_angle":e.falloffAngle=parseFloat(r.textContent);break;case"quadratic_attenuation":let a=parseFloat(r.textContent);e.distance=a?Math.sqrt(1/a):0;break}}return e}parseGeometry(t){let e={name:t.getAttribute("name"),sources:{},vertices:{},primitives:[]},n=Ci(t,"mesh")[0];if(n!==void 0){for(let i=0;i<n.childNodes.length;i++){let r=n.childNodes[i];if(r.nodeType!==1)continue;let o=r.getAttribute("id");switch(r.nodeName){case"source":e.sources[o]=this.parseSource(r);break;case"vertices":e.vertices=this.parseGeometryVertices(r);break;case"polygons":case"lines":case"linestrips":case"polylist":case"triangles":e.primitives.push(this.parseGeometryPrimitive(r));break;default:}}this.library.geometries[t.getAttribute("id")]=e}}parseSource(t){let e={array:[],stride:3};for(let n=0;n<t.childNodes.length;n++){let i=t.childNodes[n];if(i.nodeType===1)switch(i.nodeName){case"float_array":e.array=ui(i.textContent);break;case"Name_array":e.array=rR(i.textContent);break;case"technique_common":let r=Ci(i,"accessor")[0];r!==void 0&&(e.stride=parseInt(r.getAttribute("stride")));break}}return e}parseGeometryVertices(t){let e={};for(let n=0;n<t.childNodes.length;n++){let i=t.childNodes[n];i.nodeType===1&&(e[i.getAttribute("semantic")]=$n(i.getAttribute("source")))}return e}parseGeometryPrimitive(t){let e={type:t.nodeName,material:t.getAttribute("material"),count:parseInt(t.getAttribute("count")),inputs:{},stride:0,hasUV:!1};for(let n=0,i=t.childNodes.length;n<i;n++){let r=t.childNodes[n];if(r.nodeType===1)switch(r.nodeName){case"input":let o=$n(r.getAttribute("source")),a=r.getAttribute("semantic"),c=parseInt(r.getAttribute("offset")),l=parseInt(r.getAttribute("set")),h=l>0?a+l:a;e.inputs[h]={id:o,offset:c},e.stride=Math.max(e.stride,c+1),a==="TEXCOORD"&&(e.hasUV=!0);break;case"vcount":e.vcount=dd(r.textContent);break;case"p":e.p=dd(r.textContent);break}}return e.type==="polygons"&&(e.vcount=[e.p.length/e.stride]),e}parseLibraryJoint(t){this.library.joints[t.getAttribute("id")]=this.parseKinematicsJoint(t)}parseKinematicsModel(t){let e={name:t.getAttribute("name")||"",joints:{},links:[]};for(let n=0;n<t.childNodes.length;n++){let i=t.childNodes[n];i.nodeType===1&&i.nodeName==="technique_common"&&this.parseKinematicsTechniqueCommon(i,e)}this.library.kinematicsModels[t.getAttribute("id")]=e}parseKinematicsTechniqueCommon(t,e){for(let n=0;n<t.childNodes.length;n++){let i=t.childNodes[n];if(i.nodeType===1)switch(i.nodeName){case"joint":e.joints[i.getAttribute("sid")]=this.parseKinematicsJoint(i);break;case"instance_joint":e.joints[i.getAttribute("sid")]=this.library.joints[$n(i.getAttribute("url"))];break;case"link":e.links.push(this.parseKinematicsLink(i));break}}}parseKinematicsJoint(t){let e;for(let n=0;n<t.childNodes.length;n++){let i=t.childNodes[n];if(i.nodeType===1)switch(i.nodeName){case"prismatic":case"revolute":e=this.parseKinematicsJointParameter(i);break}}return e}parseKinematicsJointParameter(t){let e={sid:t.getAttribute("sid"),name:t.getAttribute("name")||"",axis:new F,limits:{min:0,max:0},type:t.nodeName,static:!1,zeroPosition:0,middlePosition:0};for(let n=0;n<t.childNodes.length;n++){let i=t.childNodes[n];if(i.nodeType===1)switch(i.nodeName){case"axis":let r=ui(i.textContent);e.axis.fromArray(r);break;case"limits":let o=i.getElementsByTagName("max")[0],a=i.getElementsByTagName("min")[0];e.limits.max=parseFloat(o.textContent),e.limits.min=parseFloat(a.textContent);break}}return e.limits.min>=e.limits.max&&(e.static=!0),e.middlePosition=(e.limits.min+e.limits.max)/2,e}parseKinematicsLink(t){let e={sid:t.getAttribute("sid"),name:t.getAttribute("name")||"",attachments:[],transforms:[]};for(let n=0;n<t.childNodes.length;n++){let i=t.childNodes[n];if(i.nodeType===1)switch(i.nodeName){case"attachment_full":e.attachments.push(this.parseKinematicsAttachment(i));break;case"matrix":case"translate":case"rotate":e.transforms.push(this.parseKinematicsTransform(i));break}}return e}parseKinematicsAttachment(t){let e={joint:t.getAttribute("joint").split("/").pop(),transforms:[],links:[]};for(let n=0;n<t.childNodes.length;n++){let i=t.childNodes[n];if(i.nodeType===1)switch(i.nodeName){case"link":e.links.push(this.parseKinematicsLink(i));break;case"matrix":case"translate":case"rotate":e.transforms.push(this.parseKinematicsTransform(i));break}}return e}parseKinematicsTransform(t){let e={type:t.nodeName},n=ui(t.textContent);switch(e.type){case"matrix":e.obj=new Gt,e.obj.fromArray(n).transpose();break;case"translate":e.obj=new F,e.obj.fromArray(n);break;case"rotate":e.obj=new F,e.obj.fromArray(n),e.angle=vi.degToRad(n[3]);break}return e}parsePhysicsModel(t){let e={name:t.getAttribute("name")||"",rigidBodies:{}};for(let n=0;n<t.childNodes.length;n++){let i=t.childNodes[n];i.nodeType===1&&i.nodeName==="rigid_body"&&(e.rigidBodies[i.getAttribute("name")]={},this.parsePhysicsRigidBody(i,e.rigidBodies[i.getAttribute("name")]))}this.library.physicsModels[t.getAttribute("id")]=e}parsePhysicsRigidBody(t,e){for(let n=0;n<t.childNodes.length;n++){let i=t.childNodes[n];i.nodeType===1&&i.nodeName==="technique_common"&&this.parsePhysicsTechniqueCommon(i,e)}}parsePhysicsTechniqueCommon(t,e){for(let n=0;n<t.childNodes.length;n++){let i=t.childNodes[n];if(i.nodeType===1)switch(i.nodeName){case"inertia":e.inertia=ui(i.textContent);break;case"mass":e.mass=ui(i.textContent)[0];break}}}parseKinematicsScene(t){let e={bindJointAxis:[]};for(let n=0;n<t.childNodes.length;n++){let i=t.childNodes[n];i.nodeType===1&&i.nodeName==="bind_joint_axis"&&e.bindJointAxis.push(this.parseKinematicsBindJointAxis(i))}this.library.kinematicsScenes[$n(t.getAttribute("url"))]=e}parseKinematicsBindJointAxis(t){let e={target:t.getAttribute("target").split("/").pop()};for(let n=0;n<t.childNodes.length;n++){let i=t.childNodes[n];if(i.nodeType===1&&i.nodeName==="axis"){let r=i.getElementsByTagName("param")[0];e.axis=r.textContent;let o=e.axis.split("inst_").pop().split("axis")[0];e.jointIndex=o.substring(0,o.length-1)}}return e}prepareNodes(t){let e=t.getElementsByTagName("node");for(let n=0;n<e.length;n++){let i=e[n];i.hasAttribute("id")===!1&&i.setAttribute("id",this.generateId())}}parseNode(t){let e=new Gt,n=new F,i={name:t.getAttribute("name")||"",type:t.getAttribute("type"),id:t.getAttribute("id"),sid:t.getAttribute("sid"),matrix:new Gt,nodes:[],instanceCameras:[],instanceControllers:[],instanceLights:[],instanceGeometries:[],instanceNodes:[],transforms:{},transformData:{},transformOrder:[]};for(let r=0;r<t.childNodes.length;r++){let o=t.childNodes[r];if(o.nodeType!==1)continue;let a;switch(o.nodeName){case"node":i.nodes.push(o.getAttribute("id")),this.parseNode(o);break;case"instance_camera":i.instanceCameras.push($n(o.getAttribute("url")));break;case"instance_controller":i.instanceControllers.push(this.parseNodeInstance(o));break;case"instance_light":i.instanceLights.push($n(o.getAttribute("url")));break;case"instance_geometry":i.instanceGeometries.push(this.parseNodeInstance(o));break;case"instance_node":i.instanceNodes.push($n(o.getAttribute("url")));break;case"matrix":a=ui(o.textContent),i.matrix.multiply(e.fromArray(a).transpose());{let c=o.getAttribute("sid");i.transforms[c]=o.nodeName,i.transformData[c]={type:"matrix",array:a},i.transformOrder.push(c)}break;case"translate":a=ui(o.textContent),n.fromArray(a),i.matrix.multiply(e.makeTranslation(n.x,n.y,n.z));{let c=o.getAttribute("sid");i.transforms[c]=o.nodeName,i.transformData[c]={type:"translate",x:a[0],y:a[1],z:a[2]},i.transformOrder.push(c)}break;case"rotate":a=ui(o.textContent);{let c=vi.degToRad(a[3]);i.matrix.multiply(e.makeRotationAxis(n.fromArray(a),c));let l=o.getAttribute("sid");i.transforms[l]=o.nodeName,i.transformData[l]={type:"rotate",axis:[a[0],a[1],a[2]],angle:a[3]},i.transformOrder.push(l)}break;case"scale":a=ui(o.textContent),i.matrix.scale(n.fromArray(a));{let c=o.getAttribute("sid");i.transforms[c]=o.nodeName,i.transformData[c]={type:"scale",x:a[0],y:a[1],z:a[2]},i.transformOrder.push(c)}break;case"extra":break;default:}}return this.hasNode(i.id)?console.warn("THREE.ColladaLoader: There is already a node with ID %s. Exclude current node from further processing.",i.id):this.library.nodes[i.id]=i,i}parseNodeInstance(t){let e={id:$n(t.getAttribute("url")),materials:{},skeletons:[]};for(let n=0;n<t.childNodes.length;n++){let i=t.childNodes[n];switch(i.nodeName){case"bind_material":let r=i.getElementsByTagName("instance_material");for(let o=0;o<r.length;o++){let a=r[o],c=a.getAttribute("symbol"),l=a.getAttribute("target");e.materials[c]=$n(l)}break;case"skeleton":e.skeletons.push($n(i.textContent));break;default:break}}return e}parseVisualScene(t){let e={name:t.getAttribute("name"),children:[]};this.prepareNodes(t);let n=Ci(t,"node");for(let i=0;i<n.length;i++)e.children.push(this.parseNode(n[i]));this.library.visualScenes[t.getAttribute("id")]=e}hasNode(t){return this.library.nodes[t]!==void 0}};var pd=class{constructor(t,e,n,i){this.library=t,this.collada=e,this.textureLoader=n,this.tgaLoader=i,this.tempColor=new qt,this.animations=[],this.kinematics={},this.position=new F,this.scale=new F,this.quaternion=new ve,this.matrix=new Gt,this.deferredPivotAnimations={},this.transformNodes={}}compose(){let t=this.library;this.buildLibrary(t.animations,this.buildAnimation.bind(this)),this.buildLibrary(t.clips,this.buildAnimationClip.bind(this)),this.buildLibrary(t.controllers,this.buildController.bind(this)),this.buildLibrary(t.images,this.buildImage.bind(this)),this.buildLibrary(t.effects,this.buildEffect.bind(this)),this.buildLibrary(t.materials,this.buildMaterial.bind(this)),this.buildLibrary(t.cameras,this.buildCamera.bind(this)),this.buildLibrary(t.lights,this.buildLight.bind(this)),this.buildLibrary(t.geometries,this.buildGeometry.bind(this)),this.buildLibrary(t.visualScenes,this.buildVisualScene.bind(this)),this.setupAnimations(),this.setupKinematics();let e=this.parseScene(Ci(this.collada,"scene")[0]);return e.animations=this.animations,{scene:e,animations:this.animations,kinematics:this.kinematics}}buildLibrary(t,e){for(let n in t){let i=t[n];i.build=e(t[n])}}getBuild(t,e){return t.build!==void 0||(t.build=e(t)),t.build}isEmpty(t){return Object.keys(t).length===0}buildAnimation(t){let e=[],n=t.channels,i=t.samplers,r=t.sources,o=this.aggregateAnimationChannels(n,i,r);for(let a in o){let c=this.library.nodes[a];if(!c)continue;let l=o[a];if(this.hasPivotTransforms(c))this.collectDeferredPivotAnimation(a,l);else{let h=this.getNode(a),u=!1;for(let d in l){let f=c.transforms[d],g=c.transformData[d],y=l[d];switch(f){case"matrix":this.buildMatrixTracks(h,y,c,e);break;case"translate":this.buildTranslateTrack(h,y,g,e);break;case"rotate":u||(this.buildRotateTrack(h,d,y,g,c,e),u=!0);break;case"scale":this.buildScaleTrack(h,y,g,e);break}}}}return e}collectDeferredPivotAnimation(t,e){this.deferredPivotAnimations[t]||(this.deferredPivotAnimations[t]={});let n=this.deferredPivotAnimations[t];for(let i in e){n[i]||(n[i]={});for(let r in e[i])n[i][r]=e[i][r]}}hasPivotTransforms(t){let e=["rotatePivot","rotatePivotInverse","rotatePivotTranslation","scalePivot","scalePivotInverse","scalePivotTranslation"];for(let n of e)if(t.transforms[n]!==void 0)return!0;return!1}getAnimation(t){return this.getBuild(this.library.animations[t],this.buildAnimation.bind(this))}aggregateAnimationChannels(t,e,n){let i={};for(let r in t){if(!t.hasOwnProperty(r))continue;let o=t[r],a=e[o.sampler],c=a.inputs.INPUT,l=a.inputs.OUTPUT,h=n[c],u=n[l],d=a.inputs.INTERPOLATION,f=a.inputs.IN_TANGENT,g=a.inputs.OUT_TANGENT,y=d?n[d]:null,p=f?n[f]:null,m=g?n[g]:null,x=o.id,v=o.sid,_=o.member||"default";i[x]||(i[x]={}),i[x][v]||(i[x][v]={}),i[x][v][_]={times:h.array,values:u.array,stride:u.stride,arraySyntax:o.arraySyntax,indices:o.indices,interpolation:y?y.array:null,inTangent:p?p.array:null,outTangent:m?m.array:null,inTangentStride:p?p.stride:0,outTangentStride:m?m.stride:0}}return i}buildMatrixTracks(t,e,n,i){let r=n.matrix.clone().transpose(),o={};for(let l in e){let h=e[l],u=h.times,d=h.values,f=h.stride;for(let g=0,y=u.length;g<y;g++){let p=u[g],m=g*f;if(o[p]===void 0&&(o[p]={}),h.arraySyntax===!0){let x=d[m],v=h.indices[0]+4*h.indices[1];o[p][v]=x}else for(let x=0;x<f;x++)o[p][x]=d[m+x]}}let a=this.prepareAnimationData(o,r),c={name:t.uuid,keyframes:a};this.createKeyframeTracks(c,i)}buildTranslateTrack(t,e,n,i){if(e.default&&e.default.stride===3){let l=e.default,h=Array.from(l.times),u=Array.from(l.values),d=new ai(t.uuid+".position",h,u),f=this.getInterpolationInfo(e);this.applyInterpolation(d,f,e),i.push(d);return}let r=this.getTimesForAllAxes(e);if(r.length===0)return;let o=[],a=this.getInterpolationInfo(e);for(let l=0;l<r.length;l++){let h=r[l],u=this.getValueAtTime(e.X,h,n.x),d=this.getValueAtTime(e.Y,h,n.y),f=this.getValueAtTime(e.Z,h,n.z);o.push(u,d,f)}let c=new ai(t.uuid+".position",r,o);this.applyInterpolation(c,a),i.push(c)}buildRotateTrack(t,e,n,i,r,o){let a=n.ANGLE||n.default;if(!a)return;let c=Array.from(a.times);if(c.length===0)return;let l=[];for(let p of r.transformOrder)if(r.transforms[p]==="rotate"){let x=r.transformData[p];l.push({sid:p,axis:new F(x.axis[0],x.axis[1],x.axis[2]),defaultAngle:x.angle})}let h=new ve,u=new ve,d=new ve,f=[],g=this.getInterpolationInfo(n);for(let p=0;p<c.length;p++){let m=c[p];h.identity();for(let x of l){let v;x.sid===e?v=this.getValueAtTime(a,m,x.defaultAngle):v=x.defaultAngle;let _=vi.degToRad(v);d.setFromAxisAngle(x.axis,_),h.multiply(d)}p>0&&u.dot(h)<0&&(h.x=-h.x,h.y=-h.y,h.z=-h.z,h.w=-h.w),u.copy(h),f.push(h.x,h.y,h.z,h.w)}let y=new Ps(t.uuid+".quaternion",c,f);this.applyInterpolation(y,g),o.push(y)}buildScaleTrack(t,e,n,i){if(e.default&&e.default.stride===3){let l=e.default,h=Array.from(l.times),u=Array.from(l.values),d=new ai(t.uuid+".scale",h,u),f=this.getInterpolationInfo(e);this.applyInterpolation(d,f,e),i.push(d);return}let r=this.getTimesForAllAxes(e);if(r.length===0)return;let o=[],a=this.getInterpolationInfo(e);for(let l=0;l<r.length;l++){let h=r[l],u=this.getValueAtTime(e.X,h,n.x),d=this.getValueAtTime(e.Y,h,n.y),f=this.getValueAtTime(e.Z,h,n.z);o.push(u,d,f)}let c=new ai(t.uuid+".scale",r,o);this.applyInterpolation(c,a),i.push(c)}getTimesForAllAxes(t){let e=[];return t.X&&(e=e.concat(Array.from(t.X.times))),t.Y&&(e=e.concat(Array.from(t.Y.times))),t.Z&&(e=e.concat(Array.from(t.Z.times))),t.ANGLE&&(e=e.concat(Array.from(t.ANGLE.times))),t.default&&(e=e.concat(Array.from(t.default.times))),e=[...new Set(e)].sort((n,i)=>n-i),e}getValueAtTime(t,e,n){if(!t)return n;let i=t.times,r=t.values,o=t.interpolation;for(let a=0;a<i.length;a++){if(i[a]===e)return r[a];if(i[a]>e){if(a===0)return r[0];let c=a-1,l=a,h=i[c],u=i[l],d=r[c],f=r[l],g=o?o[c]:"LINEAR";if(g==="STEP")return d;if(g==="BEZIER"&&t.inTangent&&t.outTangent)return this.evaluateBezierComponent(t,c,l,h,u,e);{let y=(e-h)/(u-h);return d+y*(f-d)}}}return r[r.length-1]}evaluateBezierComponent(t,e,n,i,r,o){let a=t.values,c=t.inTangent,l=t.outTangent,h=t.inTangentStride||1,u=a[e],d=a[n],f,g,y,p;h===2?(f=l[e*2],g=l[e*2+1],y=c[n*2],p=c[n*2+1]):(f=i+(r-i)/3,g=l[e],y=r-(r-i)/3,p=c[n]);let m=(o-i)/(r-i);for(let b=0;b<8;b++){let M=m*m,I=M*m,P=1-m,C=P*P,B=C*P*i+3*C*m*f+3*P*M*y+I*r,L=3*C*(f-i)+6*P*m*(y-f)+3*M*(r-y);if(Math.abs(L)<1e-10)break;let z=B-o;if(Math.abs(z)<1e-10)break;m=m-z/L,m=Math.max(0,Math.min(1,m))}let x=m*m,v=x*m,_=1-m,E=_*_;return E*_*u+3*E*m*g+3*_*x*p+v*d}getInterpolationInfo(t){let e=["X","Y","Z","ANGLE","default"],n=null,i=!0;for(let r of e){let o=t[r];if(!o||!o.interpolation)continue;let a=o.interpolation;for(let c=0;c<a.length;c++){let l=a[c];n===null?n=l:l!==n&&(i=!1)}}return{type:n||"LINEAR",uniform:i}}applyInterpolation(t,e,n=null){if(e.type==="STEP"&&e.uniform)t.setInterpolation(Xr);else if(e.type==="BEZIER"&&e.uniform&&n){let i=n.default;i&&i.inTangent&&i.outTangent&&(t.setInterpolation(sl),t.settings={inTangents:new Float32Array(i.inTangent),outTangents:new Float32Array(i.outTangent)})}}prepareAnimationData(t,e){let n=[];for(let i in t)n.push({time:parseFloat(i),value:t[i]});n.sort((i,r)=>i.time-r.time);for(let i=0;i<16;i++)this.transformAnimationData(n,i,e.elements[i]);return n}createKeyframeTracks(t,e){let n=t.keyframes,i=t.name,r=[],o=[],a=[],c=[],l=this.position,h=this.quaternion,u=this.scale,d=this.matrix;for(let f=0,g=n.length;f<g;f++){let y=n[f],p=y.time,m=y.value;d.fromArray(m).transpose(),d.decompose(l,h,u),r.push(p),o.push(l.x,l.y,l.z),a.push(h.x,h.y,h.z,h.w),c.push(u.x,u.y,u.z)}return o.length>0&&e.push(new ai(i+".position",r,o)),a.length>0&&e.push(new Ps(i+".quaternion",r,a)),c.length>0&&e.push(new ai(i+".scale",r,c)),e}transformAnimationData(t,e,n){let i,r=!0,o,a;for(o=0,a=t.length;o<a;o++)i=t[o],i.value[e]===void 0?i.value[e]=null:r=!1;if(r===!0)for(o=0,a=t.length;o<a;o++)i=t[o],i.value[e]=n;else this.createMissingKeyframes(t,e)}createMissingKeyframes(t,e){let n,i;for(let r=0,o=t.length;r<o;r++){let a=t[r];if(a.value[e]===null){if(n=this.getPrev(t,r,e),i=this.getNext(t,r,e),n===null){a.value[e]=i.value[e];continue}if(i===null){a.value[e]=n.value[e];continue}this.interpolate(a,n,i,e)}}}getPrev(t,e,n){for(;e>=0;){let i=t[e];if(i.value[n]!==null)return i;e--}return null}getNext(t,e,n){for(;e<t.length;){let i=t[e];if(i.value[n]!==null)return i;e++}return null}interpolate(t,e,n,i){if(n.time-e.time===0){t.value[i]=e.value[i];return}t.value[i]=(t.time-e.time)*(n.value[i]-e.value[i])/(n.time-e.time)+e.value[i]}buildAnimationClip(t){let e=[],n=t.name,i=t.end-t.start||-1,r=t.animations;for(let o=0,a=r.length;o<a;o++){let c=this.getAnimation(r[o]);for(let l=0,h=c.length;l<h;l++)e.push(c[l])}return new aa(n,i,e)}getAnimationClip(t){return this.getBuild(this.library.clips[t],this.buildAnimationClip.bind(this))}buildController(t){let e={id:t.id},n=this.library.geometries[e.id];return t.skin!==void 0&&(e.skin=this.buildSkin(t.skin),n.sources.skinIndices=e.skin.indices,n.sources.skinWeights=e.skin.weights),e}buildSkin(t){let n={joints:[],indices:{array:[],stride:4},weights:{array:[],stride:4}},i=t.sources,r=t.vertexWeights,o=r.vcount,a=r.v,c=r.inputs.JOINT.offset,l=r.inputs.WEIGHT.offset,h=t.sources[t.joints.inputs.JOINT],u=t.sources[t.joints.inputs.INV_BIND_MATRIX],d=i[r.inputs.WEIGHT.id].array,f=0,g,y,p;for(g=0,p=o.length;g<p;g++){let x=o[g],v=[];for(y=0;y<x;y++){let _=a[f+c],E=a[f+l],w=d[E];v.push({index:_,weight:w}),f+=2}for(v.sort(m),y=0;y<4;y++){let _=v[y];_!==void 0?(n.indices.array.push(_.index),n.weights.array.push(_.weight)):(n.indices.array.push(0),n.weights.array.push(0))}}for(t.bindShapeMatrix?n.bindMatrix=new Gt().fromArray(t.bindShapeMatrix).transpose():n.bindMatrix=new Gt().identity(),g=0,p=h.array.length;g<p;g++){let x=h.array[g],v=new Gt().fromArray(u.array,g*u.stride).transpose();n.joints.push({name:x,boneInverse:v})}return n;function m(x,v){return v.weight-x.weight}}getController(t){return this.getBuild(this.library.controllers[t],this.buildController.bind(this))}buildImage(t){return t.build!==void 0?t.build:t.init_from}getImage(t){let e=this.library.images[t];return e!==void 0?this.getBuild(e,this.buildImage.bind(this)):(console.warn("THREE.ColladaLoader: Couldn't find image with ID:",t),null)}buildEffect(t){return t}getEffect(t){return this.getBuild(this.library.effects[t],this.buildEffect.bind(this))}getTextureLoader(t){let e,n=t.slice((t.lastIndexOf(".")-1>>>0)+2);return n=n.toLowerCase(),n==="tga"?e=this.tgaLoader:e=this.textureLoader,e}buildMaterial(t){let e=this.getEffect(t.url),n=e.profile.technique,i;switch(n.type){case"phong":case"blinn":i=new $i;break;case"lambert":i=new $r;break;default:i=new Qe;break}i.name=t.name||"";let r=this;function o(h,u=null){let d=e.profile.samplers[h.id],f=null;if(d!==void 0){let g=e.profile.surfaces[d.source];f=r.getImage(g.init_from)}else console.warn("THREE.ColladaLoader: Undefined sampler. Access image directly (see #12530)."),f=r.getImage(h.id);if(f!==null){let g=r.getTextureLoader(f);if(g!==void 0){let y=g.load(f),p=h.extra;if(p!==void 0&&p.technique!==void 0&&r.isEmpty(p.technique)===!1){let m=p.technique;y.wrapS=m.wrapU?ds:_i,y.wrapT=m.wrapV?ds:_i,y.offset.set(m.offsetU||0,m.offsetV||0),y.repeat.set(m.repeatU||1,m.repeatV||1)}else y.wrapS=ds,y.wrapT=ds;return u!==null&&(y.colorSpace=u),y}else return console.warn("THREE.ColladaLoader: Loader for texture %s not found.",f),null}else return console.warn("THREE.ColladaLoader: Couldn't create texture with ID:",h.id),null}let a=n.parameters;for(let h in a){let u=a[h];switch(h){case"diffuse":u.color&&i.color.fromArray(u.color),u.texture&&(i.map=o(u.texture,Pe));break;case"specular":u.color&&i.specular&&i.specular.fromArray(u.color),u.texture&&(i.specularMap=o(u.texture));break;case"bump":u.texture&&(i.normalMap=o(u.texture));break;case"ambient":u.texture&&(i.lightMap=o(u.texture,Pe));break;case"shininess":u.float&&i.shininess&&(i.shininess=u.float);break;case"emission":u.color&&i.emissive&&i.emissive.fromArray(u.color),u.texture&&(i.emissiveMap=o(u.texture,Pe));break}}he.colorSpaceToWorking(i.color,Pe),i.specular&&he.colorSpaceToWorking(i.specular,Pe),i.emissive&&he.colorSpaceToWorking(i.emissive,Pe);let c=a.transparent,l=a.transparency;if(l===void 0&&c&&(l={float:1}),c===void 0&&l&&(c={opaque:"A_ONE",data:{color:[1,1,1,1]}}),c&&l)if(c.data.texture)i.transparent=!0;else{let h=c.data.color;switch(c.opaque){case"A_ONE":i.opacity=h[3]*l.float;break;case"RGB_ZERO":i.opacity=1-h[0]*l.float;break;case"A_ZERO":i.opacity=1-h[3]*l.float;break;case"RGB_ONE":i.opacity=h[0]*l.float;break;default:console.warn('THREE.ColladaLoader: Invalid opaque type "%s" of transparent tag.',c.opaque)}i.opacity<1&&(i.transparent=!0)}if(n.extra!==void 0&&n.extra.technique!==void 0){let h=n.extra.technique;for(let u in h){let d=h[u];switch(u){case"double_sided":i.side=d===1?ci:Ls;break;case"bump":i.normalMap=o(d.texture),i.normalScale=new Vt(1,1);break}}}return i}getMaterial(t){return this.getBuild(this.library.materials[t],this.buildMaterial.bind(this))}buildCamera(t){let e;switch(t.optics.technique){case"perspective":e=new vn(t.optics.parameters.yfov,t.optics.parameters.aspect_ratio,t.optics.parameters.znear,t.optics.parameters.zfar);break;case"orthographic":let n=t.optics.parameters.ymag,i=t.optics.parameters.xmag,r=t.optics.parameters.aspect_ratio;i=i===void 0?n*r:i,n=n===void 0?i/r:n,i*=.5,n*=.5,e=new Kr(-i,i,n,-n,t.optics.parameters.znear,t.optics.parameters.zfar);break;default:e=new vn;break}return e.name=t.name||"",e}getCamera(t){let e=this.library.cameras[t];return e!==void 0?this.getBuild(e,this.buildCamera.bind(this)):(console.warn("THREE.ColladaLoader: Couldn't find camera with ID:",t),null)}buildLight(t){let e;switch(t.technique){case"directional":e=new Rr;break;case"point":e=new Rl;break;case"spot":e=new Al;break;case"ambient":e=new Cl;break}return t.parameters.color&&e.color.copy(t.parameters.color),t.parameters.distance&&(e.distance=t.parameters.distance),t.parameters.falloffAngle&&(e.angle=vi.degToRad(t.parameters.falloffAngle)),e}getLight(t){let e=this.library.lights[t];return e!==void 0?this.getBuild(e,this.buildLight.bind(this)):(console.warn("THREE.ColladaLoader: Couldn't find light with ID:",t),null)}groupPrimitives(t){let e={};for(let n=0;n<t.length;n++){let i=t[n];e[i.type]===void 0&&(e[i.type]=[]),e[i.type].push(i)}return e}checkUVCoordinates(t){let e=0;for(let n=0,i=t.length;n<i;n++)t[n].hasUV===!0&&e++;e>0&&e<t.length&&(t.uvsNeedsFix=!0)}buildGeometry(t){let e={},n=t.sources,i=t.vertices,r=t.primitives;if(r.length===0)return{};let o=this.groupPrimitives(r);for(let a in o){let c=o[a];this.checkUVCoordinates(c),e[a]=this.buildGeometryType(c,n,i)}return e}buildGeometryType(t,e,n){let i={},r={array:[],stride:0},o={array:[],stride:0},a={array:[],stride:0},c={array:[],stride:0},l={array:[],stride:0},h={array:[],stride:4},u={array:[],stride:4},d=new ue,f=[],g=0;for(let y=0;y<t.length;y++){let p=t[y],m=p.inputs,x=0;switch(p.type){case"lines":case"linestrips":x=p.count*2;break;case"triangles":x=p.count*3;break;case"polygons":case"polylist":for(let v=0;v<p.count;v++){let _=p.vcount[v];switch(_){case 3:x+=3;break;case 4:x+=6;break;default:x+=(_-2)*3;break}}break;default:console.warn("THREE.ColladaLoader: Unknown primitive type:",p.type)}d.addGroup(g,x,y),g+=x,p.material&&f.push(p.material),p.positionSource=e[n.POSITION],p.positionOffset=m.VERTEX.offset;for(let v in m){let _=m[v];switch(v){case"VERTEX":for(let E in n){let w=n[E];switch(E){case"POSITION":let b=r.array.length;if(this.buildGeometryData(p,e[w],_.offset,r.array),r.stride=e[w].stride,e.skinWeights&&e.skinIndices&&(this.buildGeometryData(p,e.skinIndices,_.offset,h.array),this.buildGeometryData(p,e.skinWeights,_.offset,u.array)),p.hasUV===!1&&t.uvsNeedsFix===!0){let M=(r.array.length-b)/r.stride;for(let I=0;I<M;I++)a.array.push(0,0)}break;case"NORMAL":this.buildGeometryData(p,e[w],_.offset,o.array),o.stride=e[w].stride;break;case"COLOR":this.buildGeometryData(p,e[w],_.offset,l.array,!0),l.stride=e[w].stride;break;case"TEXCOORD":this.buildGeometryData(p,e[w],_.offset,a.array),a.stride=e[w].stride;break;case"TEXCOORD1":this.buildGeometryData(p,e[w],_.offset,c.array),a.stride=e[w].stride;break;default:console.warn('THREE.ColladaLoader: Semantic "%s" not handled in geometry build process.',E)}}break;case"NORMAL":this.buildGeometryData(p,e[_.id],_.offset,o.array),o.stride=e[_.id].stride;break;case"COLOR":this.buildGeometryData(p,e[_.id],_.offset,l.array,!0),l.stride=e[_.id].stride;break;case"TEXCOORD":this.buildGeometryData(p,e[_.id],_.offset,a.array),a.stride=e[_.id].stride;break;case"TEXCOORD1":this.buildGeometryData(p,e[_.id],_.offset,c.array),c.stride=e[_.id].stride;break}}}return r.array.length>0&&d.setAttribute("position",new Xt(r.array,r.stride)),o.array.length>0&&d.setAttribute("normal",new Xt(o.array,o.stride)),l.array.length>0&&d.setAttribute("color",new Xt(l.array,l.stride)),a.array.length>0&&d.setAttribute("uv",new Xt(a.array,a.stride)),c.array.length>0&&d.setAttribute("uv1",new Xt(c.array,c.stride)),h.array.length>0&&d.setAttribute("skinIndex",new Xt(h.array,h.stride)),u.array.length>0&&d.setAttribute("skinWeight",new Xt(u.array,u.stride)),i.data=d,i.type=t[0].type,i.materialKeys=f,i}buildGeometryData(t,e,n,i,r=!1){let o=t.p,a=t.stride,c=t.vcount,l=t.positionSource,h=t.positionOffset,u=this.tempColor;function d(y){let p=o[y+n]*g,m=p+g;for(;p<m;p++)i.push(f[p]);if(r){let x=i.length-g;u.setRGB(i[x+0],i[x+1],i[x+2],Pe),i[x+0]=u.r,i[x+1]=u.g,i[x+2]=u.b}}let f=e.array,g=e.stride;if(t.vcount!==void 0){let y=0;for(let p=0,m=c.length;p<m;p++){let x=c[p];if(x===4){let v=y+a*0,_=y+a*1,E=y+a*2,w=y+a*3;d(v),d(_),d(w),d(_),d(E),d(w)}else if(x===3){let v=y+a*0,_=y+a*1,E=y+a*2;d(v),d(_),d(E)}else if(x>4){let v=[];for(let I=0;I<x;I++){let P=y+a*I+h,C=o[P]*l.stride,D=l.array[C],B=l.array[C+1],L=l.array[C+2];v.push(new F(D,B,L))}let _=new F,E=new us;E.a=v[0],E.b=v[1],E.c=v[2],E.getNormal(_);let w=[];if(Math.abs(_.x)>Math.abs(_.y)&&Math.abs(_.x)>Math.abs(_.z))for(let I=0;I<x;I++)w.push(new Vt(v[I].y,v[I].z));else if(Math.abs(_.y)>Math.abs(_.z))for(let I=0;I<x;I++)w.push(new Vt(v[I].x,v[I].z));else for(let I=0;I<x;I++)w.push(new Vt(v[I].x,v[I].y));let b=ra.isClockWise(w);b===!0&&w.reverse();let M=ra.triangulateShape(w,[]);for(let I=0;I<M.length;I++){let P=M[I],C,D,B;b===!1?(C=P[0],D=P[1],B=P[2]):(C=x-1-P[0],D=x-1-P[2],B=x-1-P[1]);let L=y+a*C,z=y+a*D,O=y+a*B;d(L),d(z),d(O)}}y+=a*x}}else for(let y=0,p=o.length;y<p;y+=a)d(y)}getGeometry(t){return this.getBuild(this.library.geometries[t],this.buildGeometry.bind(this))}buildKinematicsModel(t){return t.build!==void 0?t.build:t}getKinematicsModel(t){return this.getBuild(this.library.kinematicsModels[t],this.buildKinematicsModel.bind(this))}buildKinematicsScene(t){return t.build!==void 0?t.build:t}getKinematicsScene(t){return this.getBuild(this.library.kinematicsScenes[t],this.buildKinematicsScene.bind(this))}setupKinematics(){let t=Object.keys(this.library.kinematicsModels)[0],e=Object.keys(this.library.kinematicsScenes)[0],n=Object.keys(this.library.visualScenes)[0];if(t===void 0||e===void 0)return;let i=this.getKinematicsModel(t),r=this.getKinematicsScene(e),o=this.getVisualScene(n),a=r.bindJointAxis,c={},l=this.collada,h=this;for(let g=0,y=a.length;g<y;g++){let p=a[g],m=l.querySelector('[sid="'+p.target+'"]');if(m){let x=m.parentElement;u(p.jointIndex,x)}}function u(g,y){let p=y.getAttribute("name"),m=i.joints[g],x=h.buildTransformList(y);o.traverse(function(v){v.name===p&&(c[g]={object:v,transforms:x,joint:m,position:m.zeroPosition})})}let d=new Gt,f=this.matrix;this.kinematics={joints:i&&i.joints,getJointValue:function(g){let y=c[g];if(y)return y.position;console.warn("THREE.ColladaLoader: Joint "+g+" doesn't exist.")},setJointValue:function(g,y){let p=c[g];if(p){let m=p.joint;if(y>m.limits.max||y<m.limits.min)console.warn("THREE.ColladaLoader: Joint "+g+" value "+y+" outside of limits (min: "+m.limits.min+", max: "+m.limits.max+").");else if(m.static)console.warn("THREE.ColladaLoader: Joint "+g+" is static.");else{let x=p.object,v=m.axis,_=p.transforms;f.identity();for(let E=0;E<_.length;E++){let w=_[E];if(w.sid&&w.sid.indexOf(g)!==-1)switch(m.type){case"revolute":f.multiply(d.makeRotationAxis(v,vi.degToRad(y)));break;case"prismatic":f.multiply(d.makeTranslation(v.x*y,v.y*y,v.z*y));break;default:console.warn("THREE.ColladaLoader: Unknown joint type: "+m.type);break}else switch(w.type){case"matrix":f.multiply(w.obj);break;case"translate":f.multiply(d.makeTranslation(w.obj.x,w.obj.y,w.obj.z));break;case"scale":f.scale(w.obj);break;case"rotate":f.multiply(d.makeRotationAxis(w.obj,w.angle));break}}x.matrix.copy(f),x.matrix.decompose(x.position,x.quaternion,x.scale),c[g].position=y}}else console.warn("THREE.ColladaLoader: Joint "+g+" does not exist.")}}}buildTransformList(t){let e=[],n=this.collada.querySelector('[id="'+t.id+'"]');for(let i=0;i<n.childNodes.length;i++){let r=n.childNodes[i];if(r.nodeType!==1)continue;let o,a;switch(r.nodeName){case"matrix":o=ui(r.textContent);let c=new Gt().fromArray(o).transpose();e.push({sid:r.getAttribute("sid"),type:r.nodeName,obj:c});break;case"translate":case"scale":o=ui(r.textContent),a=new F().fromArray(o),e.push({sid:r.getAttribute("sid"),type:r.nodeName,obj:a});break;case"rotate":o=ui(r.textContent),a=new F().fromArray(o);let l=vi.degToRad(o[3]);e.push({sid:r.getAttribute("sid"),type:r.nodeName,obj:a,angle:l});break}}return e}buildSkeleton(t,e){let n=[],i=[],r,o,a;for(r=0;r<t.length;r++){let h=t[r],u;if(this.hasNode(h))u=this.getNode(h),this.buildBoneHierarchy(u,e,n);else if(this.hasVisualScene(h)){let f=this.library.visualScenes[h].children;for(let g=0;g<f.length;g++){let y=f[g];if(y.type==="JOINT"){let p=this.getNode(y.id);this.buildBoneHierarchy(p,e,n)}}}else console.error("THREE.ColladaLoader: Unable to find root bone of skeleton with ID:",h)}for(r=0;r<e.length;r++)for(o=0;o<n.length;o++)if(a=n[o],a.bone.name===e[r].name){i[r]=a,a.processed=!0;break}for(r=0;r<n.length;r++)a=n[r],a.processed===!1&&(i.push(a),a.processed=!0);let c=[],l=[];for(r=0;r<i.length;r++)a=i[r],c.push(a.bone),l.push(a.boneInverse);return new dl(c,l)}buildBoneHierarchy(t,e,n){t.traverse(function(i){if(i.isBone===!0){let r;for(let o=0;o<e.length;o++){let a=e[o];if(a.name===i.name){r=a.boneInverse;break}}r===void 0&&(r=new Gt),n.push({bone:i,boneInverse:r,processed:!1})}})}buildNode(t){let e=[],n=t.matrix,i=t.nodes,r=t.type,o=t.instanceCameras,a=t.instanceControllers,c=t.instanceLights,l=t.instanceGeometries,h=t.instanceNodes;for(let d=0,f=i.length;d<f;d++)e.push(this.getNode(i[d]));for(let d=0,f=o.length;d<f;d++){let g=this.getCamera(o[d]);g!==null&&e.push(g.clone())}for(let d=0,f=a.length;d<f;d++){let g=a[d],y=this.getController(g.id),p=this.getGeometry(y.id),m=this.buildObjects(p,g.materials),x=g.skeletons,v=y.skin.joints,_=this.buildSkeleton(x,v);for(let E=0,w=m.length;E<w;E++){let b=m[E];b.isSkinnedMesh&&(b.bind(_,y.skin.bindMatrix),b.normalizeSkinWeights()),e.push(b)}}for(let d=0,f=c.length;d<f;d++){let g=this.getLight(c[d]);g!==null&&e.push(g.clone())}for(let d=0,f=l.length;d<f;d++){let g=l[d],y=this.getGeometry(g.id),p=this.buildObjects(y,g.materials);for(let m=0,x=p.length;m<x;m++)e.push(p[m])}for(let d=0,f=h.length;d<f;d++)e.push(this.getNode(h[d]).clone());let u;if(i.length===0&&e.length===1)u=e[0];else{u=r==="JOINT"?new ea:new Be;for(let d=0;d<e.length;d++)u.add(e[d])}return u.name=r==="JOINT"?t.sid:t.name,r!=="JOINT"&&this.hasPivotTransforms(t)?this.wrapWithTransformHierarchy(u,t):(u.matrix.copy(n),u.matrix.decompose(u.position,u.quaternion,u.scale),u)}wrapWithTransformHierarchy(t,e){let n=e.id;this.transformNodes[n]={};let i=e.transformOrder,r=e.transformData,o=new Be;o.name=e.name;let a=o;for(let c=0;c<i.length;c++){let l=i[c],h=r[l],u=new Be;switch(u.name=e.name+"_"+l,h.type){case"translate":u.position.set(h.x,h.y,h.z);break;case"rotate":{let d=new F(h.axis[0],h.axis[1],h.axis[2]),f=vi.degToRad(h.angle);u.quaternion.setFromAxisAngle(d,f),u.userData.rotationAxis=d;break}case"scale":u.scale.set(h.x,h.y,h.z);break;case"matrix":{new Gt().fromArray(h.array).transpose().decompose(u.position,u.quaternion,u.scale);break}}this.transformNodes[n][l]=u,a.add(u),a=u}return a.add(t),o}resolveMaterialBinding(t,e){let n=[];for(let i=0,r=t.length;i<r;i++){let o=e[t[i]];o===void 0?(console.warn("THREE.ColladaLoader: Material with key %s not found. Apply fallback material.",t[i]),n.push(this.fallbackMaterial)):n.push(this.getMaterial(o))}return n}get fallbackMaterial(){return this._fallbackMaterial===void 0&&(this._fallbackMaterial=new Qe({name:li.DEFAULT_MATERIAL_NAME,color:16711935})),this._fallbackMaterial}buildObjects(t,e){let n=[];for(let i in t){let r=t[i],o=this.resolveMaterialBinding(r.materialKeys,e);if(o.length===0&&(i==="lines"||i==="linestrips"?o.push(new pn):o.push(new $i)),i==="lines"||i==="linestrips")for(let h=0,u=o.length;h<u;h++){let d=o[h];if(d.isMeshPhongMaterial===!0||d.isMeshLambertMaterial===!0){let f=new pn;f.color.copy(d.color),f.opacity=d.opacity,f.transparent=d.transparent,o[h]=f}}let a=r.data.attributes.skinIndex!==void 0,c=o.length===1?o[0]:o,l;switch(i){case"lines":l=new Ti(r.data,c);break;case"linestrips":l=new Fn(r.data,c);break;case"triangles":case"polygons":case"polylist":a?l=new ul(r.data,c):l=new gt(r.data,c);break}n.push(l)}return n}hasNode(t){return this.library.nodes[t]!==void 0}getNode(t){return this.getBuild(this.library.nodes[t],this.buildNode.bind(this))}buildVisualScene(t){let e=new Be;e.name=t.name;let n=t.children;for(let i=0;i<n.length;i++){let r=n[i];e.add(this.getNode(r.id))}return e}hasVisualScene(t){return this.library.visualScenes[t]!==void 0}getVisualScene(t){return this.getBuild(this.library.visualScenes[t],this.buildVisualScene.bind(this))}parseScene(t){let e=Ci(t,"instance_visual_scene")[0];return this.getVisualScene(this.parseId(e.getAttribute("url")))}parseId(t){return t.substring(1)}setupAnimations(){let t=this.library.clips;if(this.isEmpty(t)===!0){if(this.isEmpty(this.library.animations)===!1){let e=[];for(let n in this.library.animations){let i=this.getAnimation(n);for(let r=0,o=i.length;r<o;r++)e.push(i[r])}this.buildDeferredPivotAnimationTracks(e),this.animations.push(new aa("default",-1,e))}}else for(let e in t)this.animations.push(this.getAnimationClip(e))}buildDeferredPivotAnimationTracks(t){for(let e in this.deferredPivotAnimations){let n=this.library.nodes[e];if(!n)continue;let i=this.deferredPivotAnimations[e];this.buildTransformHierarchyTracks(e,i,n,t)}}buildTransformHierarchyTracks(t,e,n,i){let r=this.transformNodes[t];if(!r){console.warn("THREE.ColladaLoader: Transform hierarchy not found for node:",t);return}for(let o in e){let a=r[o];if(!a)continue;let c=n.transforms[o],l=n.transformData[o],h=e[o];switch(c){case"translate":this.buildHierarchyTranslateTrack(a,h,l,i);break;case"rotate":this.buildHierarchyRotateTrack(a,h,l,i);break;case"scale":this.buildHierarchyScaleTrack(a,h,l,i);break}}}buildHierarchyTranslateTrack(t,e,n,i){if(e.default&&e.default.stride===3){let l=e.default,h=new ai(t.uuid+".position",Array.from(l.times),Array.from(l.values)),u=this.getInterpolationInfo(e);this.applyInterpolation(h,u,e),i.push(h);return}let r=this.getTimesForAllAxes(e);if(r.length===0)return;let o=[],a=this.getInterpolationInfo(e);for(let l=0;l<r.length;l++){let h=r[l],u=this.getValueAtTime(e.X,h,n.x),d=this.getValueAtTime(e.Y,h,n.y),f=this.getValueAtTime(e.Z,h,n.z);o.push(u,d,f)}let c=new ai(t.uuid+".position",r,o);this.applyInterpolation(c,a),i.push(c)}buildHierarchyRotateTrack(t,e,n,i){let r=e.ANGLE||e.default;if(!r)return;let o=Array.from(r.times);if(o.length===0)return;let a=t.userData.rotationAxis||new F(n.axis[0],n.axis[1],n.axis[2]),c=new ve,l=new ve,h=[],u=this.getInterpolationInfo(e);for(let f=0;f<o.length;f++){let g=o[f],y=this.getValueAtTime(r,g,n.angle),p=vi.degToRad(y);c.setFromAxisAngle(a,p),f>0&&l.dot(c)<0&&(c.x=-c.x,c.y=-c.y,c.z=-c.z,c.w=-c.w),l.copy(c),h.push(c.x,c.y,c.z,c.w)}let d=new Ps(t.uuid+".quaternion",o,h);this.applyInterpolation(d,u),i.push(d)}buildHierarchyScaleTrack(t,e,n,i){if(e.default&&e.default.stride===3){let l=e.default,h=new ai(t.uuid+".scale",Array.from(l.times),Array.from(l.values)),u=this.getInterpolationInfo(e);this.applyInterpolation(h,u,e),i.push(h);return}let r=this.getTimesForAllAxes(e);if(r.length===0)return;let o=[],a=this.getInterpolationInfo(e);for(let l=0;l<r.length;l++){let h=r[l],u=this.getValueAtTime(e.X,h,n.x),d=this.getValueAtTime(e.Y,h,n.y),f=this.getValueAtTime(e.Z,h,n.z);o.push(u,d,f)}let c=new ai(t.uuid+".scale",r,o);this.applyInterpolation(c,a),i.push(c)}};var md=class extends li{load(t,e,n,i){let r=this,o=r.path===""?Qr.extractUrlBase(t):r.path,a=new Is(r.manager);a.setPriority(r.priority),a.setCache(r.cache),a.setPath(r.path),a.setRequestHeader(r.requestHeader),a.setWithCredentials(r.withCredentials),a.load(t,function(c){try{e(r.parse(c,o))}catch(l){i?i(l):console.error(l),r.manager.itemError(t)}},n,i)}parse(t,e){if(t.length===0)return{scene:new Yr};let i=new fd().parse(t);if(i===null)return null;let{library:r,asset:o,collada:a}=i,c=new Jr(this.manager);c.setPriority(this.priority),c.setCache(this.cache),c.setPath(this.resourcePath||e).setCrossOrigin(this.crossOrigin);let l;rc&&(l=new rc(this.manager),l.setPriority(this.priority),l.setCache(this.cache),l.setPath(this.resourcePath||e),l.setRequestHeader(this.requestHeader),l.setWithCredentials(this.withCredentials));let h=new pd(r,a,c,l),{scene:u,animations:d,kinematics:f}=h.compose();return u.animations=d,o.upAxis==="Z_UP"&&(console.warn("THREE.ColladaLoader: You are loading an asset with a Z-UP coordinate system. The loader just rotates the asset to transform it into Y-UP. The vertex data are not converted, see #24289."),u.rotation.set(-Math.PI/2,0,0)),u.scale.multiplyScalar(o.unit),{get animations(){return console.warn("THREE.ColladaLoader: Please access animations over scene.animations now."),d},kinematics:f,library:r,scene:u}}};var hy=new F,oR=new ti,gd=new Gt,Fr=new Gt,xd=new ve,_d=new F(1,1,1),yd=new F,La=class extends De{constructor(...t){super(...t),this.urdfNode=null,this.urdfName=""}copy(t,e){return super.copy(t,e),this.urdfNode=t.urdfNode,this.urdfName=t.urdfName,this}},bd=class extends La{constructor(...t){super(...t),this.isURDFCollider=!0,this.type="URDFCollider"}},vd=class extends La{constructor(...t){super(...t),this.isURDFVisual=!0,this.type="URDFVisual"}},oc=class extends La{constructor(...t){super(...t),this.isURDFLink=!0,this.type="URDFLink",this.name="",this.inertial={mass:0,origin:{xyz:[0,0,0],rpy:[0,0,0]},inertia:{ixx:0,ixy:0,ixz:0,iyy:0,iyz:0,izz:0}}}copy(t,e){return super.copy(t,e),this.inertial={mass:t.inertial.mass,origin:{xyz:[...t.inertial.origin.xyz],rpy:[...t.inertial.origin.rpy]},inertia:{...t.inertial.inertia}},this}},ac=class extends La{get jointType(){return this._jointType}set jointType(t){if(this.jointType!==t)switch(this._jointType=t,this.matrixWorldNeedsUpdate=!0,t){case"fixed":this.jointValue=[];break;case"continuous":case"revolute":case"prismatic":this.jointValue=new Array(1).fill(0);break;case"planar":this.jointValue=new Array(3).fill(0),this.axis=new F(0,0,1);break;case"floating":this.jointValue=new Array(6).fill(0);break}}get angle(){return this.jointValue[0]}constructor(...t){super(...t),this.isURDFJoint=!0,this.type="URDFJoint",this.name="",this.jointValue=null,this.jointType="fixed",this.axis=new F(1,0,0),this.limit={lower:0,upper:0,effort:0,velocity:0},this.ignoreLimits=!1,this.origPosition=null,this.origQuaternion=null,this.mimicJoints=[]}copy(t,e){return super.copy(t,e),this.jointType=t.jointType,this.axis=t.axis.clone(),this.limit.lower=t.limit.lower,this.limit.upper=t.limit.upper,this.limit.effort=t.limit.effort,this.limit.velocity=t.limit.velocity,this.ignoreLimits=!1,this.jointValue=[...t.jointValue],this.origPosition=t.origPosition?t.origPosition.clone():null,this.origQuaternion=t.origQuaternion?t.origQuaternion.clone():null,this.mimicJoints=[...t.mimicJoints],this}setJointValue(...t){t=t.map(n=>n===null?null:parseFloat(n)),(!this.origPosition||!this.origQuaternion)&&(this.origPosition=this.position.clone(),this.origQuaternion=this.quaternion.clone());let e=!1;switch(this.mimicJoints.forEach(n=>{e=n.updateFromMimickedJoint(...t)||e}),this.jointType){case"fixed":return e;case"continuous":case"revolute":{let n=t[0];return n==null||n===this.jointValue[0]?e:(!this.ignoreLimits&&this.jointType==="revolute"&&(n=Math.min(this.limit.upper,n),n=Math.max(this.limit.lower,n)),this.quaternion.setFromAxisAngle(this.axis,n).premultiply(this.origQuaternion),this.jointValue[0]!==n?(this.jointValue[0]=n,this.matrixWorldNeedsUpdate=!0,!0):e)}case"prismatic":{let n=t[0];return n==null||n===this.jointValue[0]?e:(this.ignoreLimits||(n=Math.min(this.limit.upper,n),n=Math.max(this.limit.lower,n)),this.position.copy(this.origPosition),hy.copy(this.axis).applyEuler(this.rotation),this.position.addScaledVector(hy,n),this.jointValue[0]!==n?(this.jointValue[0]=n,this.matrixWorldNeedsUpdate=!0,!0):e)}case"floating":return this.jointValue.every((n,i)=>t[i]===n||t[i]===null)?e:(this.jointValue[0]=t[0]!==null?t[0]:this.jointValue[0],this.jointValue[1]=t[1]!==null?t[1]:this.jointValue[1],this.jointValue[2]=t[2]!==null?t[2]:this.jointValue[2],this.jointValue[3]=t[3]!==null?t[3]:this.jointValue[3],this.jointValue[4]=t[4]!==null?t[4]:this.jointValue[4],this.jointValue[5]=t[5]!==null?t[5]:this.jointValue[5],Fr.compose(this.origPosition,this.origQuaternion,_d),xd.setFromEuler(oR.set(this.jointValue[3],this.jointValue[4],this.jointValue[5],"XYZ")),yd.set(this.jointValue[0],this.jointValue[1],this.jointValue[2]),gd.compose(yd,xd,_d),Fr.premultiply(gd),this.position.setFromMatrixPosition(Fr),this.rotation.setFromRotationMatrix(Fr),this.matrixWorldNeedsUpdate=!0,!0);case"planar":return this.jointValue.every((n,i)=>t[i]===n||t[i]===null)?e:(this.jointValue[0]=t[0]!==null?t[0]:this.jointValue[0],this.jointValue[1]=t[1]!==null?t[1]:this.jointValue[1],this.jointValue[2]=t[2]!==null?t[2]:this.jointValue[2],Fr.compose(this.origPosition,this.origQuaternion,_d),xd.setFromAxisAngle(this.axis,this.jointValue[2]),yd.set(this.jointValue[0],this.jointValue[1],0),gd.compose(yd,xd,_d),Fr.premultiply(gd),this.position.setFromMatrixPosition(Fr),this.rotation.setFromRotationMatrix(Fr),this.matrixWorldNeedsUpdate=!0,!0)}return e}},lc=class extends ac{constructor(...t){super(...t),this.type="URDFMimicJoint",this.mimicJoint=null,this.offset=0,this.multiplier=1}updateFromMimickedJoint(...t){let e=t.map(n=>n===null?null:n*this.multiplier+this.offset);return super.setJointValue(...e)}copy(t,e){return super.copy(t,e),this.mimicJoint=t.mimicJoint,this.offset=t.offset,this.multiplier=t.multiplier,this}},wd=class extends oc{constructor(...t){super(...t),this.isURDFRobot=!0,this.urdfNode=null,this.urdfRobotNode=null,this.robotName=null,this.links=null,this.joints=null,this.colliders=null,this.visual=null,this.frames=null}copy(t,e){super.copy(t,e),this.urdfRobotNode=t.urdfRobotNode,this.robotName=t.robotName,this.links={},this.joints={},this.colliders={},this.visual={},this.traverse(n=>{n.isURDFJoint&&n.urdfName in t.joints&&(this.joints[n.urdfName]=n),n.isURDFLink&&n.urdfName in t.links&&(this.links[n.urdfName]=n),n.isURDFCollider&&n.urdfName in t.colliders&&(this.colliders[n.urdfName]=n),n.isURDFVisual&&n.urdfName in t.visual&&(this.visual[n.urdfName]=n)});for(let n in this.joints)this.joints[n].mimicJoints=this.joints[n].mimicJoints.map(i=>this.joints[i.name]);return this.frames={...this.colliders,...this.visual,...this.links,...this.joints},this}getFrame(t){return this.frames[t]}setJointValue(t,...e){let n=this.joints[t];return n?n.setJointValue(...e):!1}setJointValues(t){let e=!1;for(let n in t){let i=t[n];Array.isArray(i)?e=this.setJointValue(n,...i)||e:e=this.setJointValue(n,i)||e}return e}};var vm=new ve,uy=new ti;function kr(s){return s?s.trim().split(/\s+/g).map(t=>parseFloat(t)):[0,0,0]}function dy(s,t,e=!1){e||s.rotation.set(0,0,0),uy.set(t[0],t[1],t[2],"ZYX"),vm.setFromEuler(uy),vm.multiply(s.quaternion),s.quaternion.copy(vm)}var wm=class{constructor(t){this.manager=t||fu,this.loadMeshCb=this.defaultMeshLoader.bind(this),this.parseVisual=!0,this.parseCollision=!1,this.packages="",this.workingPath="",this.fetchOptions={}}loadAsync(t){return new Promise((e,n)=>{this.load(t,e,null,n)})}load(t,e,n,i){let r=this.manager,o=Qr.extractUrlBase(t),a=this.manager.resolveURL(t);r.itemStart(a),fetch(a,this.fetchOptions).then(c=>{if(c.ok)return n&&n(null),c.text();throw new Error(`URDFLoader: Failed to load url '${a}' with error code ${c.status} : ${c.statusText}.`)}).then(c=>{let l=this.parse(c,this.workingPath||o);e(l),r.itemEnd(a)}).catch(c=>{i?i(c):console.error("URDFLoader: Error loading file.",c),r.itemError(a),r.itemEnd(a)})}parse(t,e=this.workingPath){let n=this.packages,i=this.loadMeshCb,r=this.parseVisual,o=this.parseCollision,a=this.manager,c={},l={},h={};function u(x){if(!/^package:\/\//.test(x))return e?e+x:x;let[v,_]=x.replace(/^package:\/\//,"").split(/\/(.+)/);if(typeof n=="string")return n.endsWith(v)?n+"/"+_:n+"/"+v+"/"+_;if(typeof n=="function")return n(v)+"/"+_;if(typeof n=="object")return v in n?n[v]+"/"+_:(console.error(`URDFLoader : ${v} not found in provided package list.`),null)}function d(x){let v;x instanceof Document?v=[...x.children]:x instanceof Element?v=[x]:v=[...new DOMParser().parseFromString(x,"text/xml").children];let _=v.filter(E=>E.nodeName==="robot").pop();return f(_)}function f(x){let v=[...x.children],_=v.filter(C=>C.nodeName.toLowerCase()==="link"),E=v.filter(C=>C.nodeName.toLowerCase()==="joint"),w=v.filter(C=>C.nodeName.toLowerCase()==="material"),b=new wd;b.robotName=x.getAttribute("name"),b.urdfRobotNode=x,w.forEach(C=>{let D=C.getAttribute("name");h[D]=p(C)});let M={},I={};_.forEach(C=>{let D=C.getAttribute("name"),B=x.querySelector(`child[link="${D}"]`)===null;c[D]=y(C,M,I,B?b:null)}),E.forEach(C=>{let D=C.getAttribute("name");l[D]=g(C)}),b.joints=l,b.links=c,b.colliders=I,b.visual=M;let P=Object.values(l);return P.forEach(C=>{C instanceof lc&&l[C.mimicJoint].mimicJoints.push(C)}),P.forEach(C=>{let D=new Set,B=L=>{if(D.has(L))throw new Error("URDFLoader: Detected an infinite loop of mimic joints.");D.add(L),L.mimicJoints.forEach(z=>{B(z)})};B(C)}),b.frames={...I,...M,...c,...l},b}function g(x){let v=[...x.children],_=x.getAttribute("type"),E,w=v.find(D=>D.nodeName.toLowerCase()==="mimic");w?(E=new lc,E.mimicJoint=w.getAttribute("joint"),E.multiplier=parseFloat(w.getAttribute("multiplier")||1),E.offset=parseFloat(w.getAttribute("offset")||0)):E=new ac,E.urdfNode=x,E.name=x.getAttribute("name"),E.urdfName=E.name,E.jointType=_;let b=null,M=null,I=[0,0,0],P=[0,0,0];v.forEach(D=>{let B=D.nodeName.toLowerCase();B==="origin"?(I=kr(D.getAttribute("xyz")),P=kr(D.getAttribute("rpy"))):B==="child"?M=c[D.getAttribute("link")]:B==="parent"?b=c[D.getAttribute("link")]:B==="limit"&&(E.limit.lower=parseFloat(D.getAttribute("lower")||E.limit.lower),E.limit.upper=parseFloat(D.getAttribute("upper")||E.limit.upper),E.limit.effort=parseFloat(D.getAttribute("effort")||E.limit.effort),E.limit.velocity=parseFloat(D.getAttribute("velocity")||E.limit.velocity))}),b.add(E),E.add(M),dy(E,P),E.position.set(I[0],I[1],I[2]);let C=v.filter(D=>D.nodeName.toLowerCase()==="axis")[0];if(C){let D=C.getAttribute("xyz").split(/\s+/g).map(B=>parseFloat(B));E.axis=new F(D[0],D[1],D[2]),E.axis.normalize()}return E}function y(x,v,_,E=null){E===null&&(E=new oc);let w=[...x.children];E.name=x.getAttribute("name"),E.urdfName=E.name,E.urdfNode=x;let b=w.find(M=>M.nodeName.toLowerCase()==="inertial");return b&&[...b.children].forEach(M=>{let I=M.nodeName.toLowerCase();I==="origin"?(E.inertial.origin.xyz=kr(M.getAttribute("xyz")),E.inertial.origin.rpy=kr(M.getAttribute("rpy"))):I==="mass"?E.inertial.mass=parseFloat(M.getAttribute("value"))||0:I==="inertia"&&(E.inertial.inertia.ixx=parseFloat(M.getAttribute("ixx"))||0,E.inertial.inertia.ixy=parseFloat(M.getAttribute("ixy"))||0,E.inertial.inertia.ixz=parseFloat(M.getAttribute("ixz"))||0,E.inertial.inertia.iyy=parseFloat(M.getAttribute("iyy"))||0,E.inertial.inertia.iyz=parseFloat(M.getAttribute("iyz"))||0,E.inertial.inertia.izz=parseFloat(M.getAttribute("izz"))||0)}),r&&w.filter(I=>I.nodeName.toLowerCase()==="visual").forEach(I=>{let P=m(I,h);if(E.add(P),I.hasAttribute("name")){let C=I.getAttribute("name");P.name=C,P.urdfName=C,v[C]=P}}),o&&w.filter(I=>I.nodeName.toLowerCase()==="collision").forEach(I=>{let P=m(I);if(E.add(P),I.hasAttribute("name")){let C=I.getAttribute("name");P.name=C,P.urdfName=C,_[C]=P}}),E}function p(x){let v=[...x.children],_=new $i;return _.name=x.getAttribute("name")||"",v.forEach(E=>{let w=E.nodeName.toLowerCase();if(w==="color"){let b=E.getAttribute("rgba").split(/\s/g).map(M=>parseFloat(M));_.color.setRGB(b[0],b[1],b[2]),_.opacity=b[3],_.transparent=b[3]<1,_.depthWrite=!_.transparent}else if(w==="texture"){let b=E.getAttribute("filename");if(b){let M=new Jr(a),I=u(b);_.map=M.load(I),_.map.colorSpace=Pe}}}),_}function m(x,v={}){let _=x.nodeName.toLowerCase()==="collision",E=[...x.children],w=null,b=E.filter(I=>I.nodeName.toLowerCase()==="material")[0];if(b){let I=b.getAttribute("name");I&&I in v?w=v[I]:w=p(b)}else w=new $i;let M=_?new bd:new vd;return M.urdfNode=x,E.forEach(I=>{let P=I.nodeName.toLowerCase();if(P==="geometry"){let C=I.children[0].nodeName.toLowerCase();if(C==="mesh"){let D=I.children[0].getAttribute("filename"),B=u(D);if(B!==null){let L=I.children[0].getAttribute("scale");if(L){let z=kr(L);M.scale.set(z[0],z[1],z[2])}i(B,a,w,(z,O)=>{O?console.error("URDFLoader: Error loading mesh.",O):z&&(z.position.set(0,0,0),z.quaternion.identity(),M.add(z))})}}else if(C==="box"){let D=new gt;D.geometry=new qe(1,1,1),D.material=w;let B=kr(I.children[0].getAttribute("size"));D.scale.set(B[0],B[1],B[2]),M.add(D)}else if(C==="sphere"){let D=new gt;D.geometry=new oi(1,30,30),D.material=w;let B=parseFloat(I.children[0].getAttribute("radius"))||0;D.scale.set(B,B,B),M.add(D)}else if(C==="cylinder"){let D=new gt;D.geometry=new Ye(1,1,1,30),D.material=w;let B=parseFloat(I.children[0].getAttribute("radius"))||0,L=parseFloat(I.children[0].getAttribute("length"))||0;D.scale.set(B,L,B),D.rotation.set(Math.PI/2,0,0),M.add(D)}}else if(P==="origin"){let C=kr(I.getAttribute("xyz")),D=kr(I.getAttribute("rpy"));M.position.set(C[0],C[1],C[2]),M.rotation.set(0,0,0),dy(M,D)}}),M}return d(t)}defaultMeshLoader(t,e,n,i){/\.stl$/i.test(t)?new ud(e).load(t,o=>{let a=new gt(o,n||new $i);i(a)},null,o=>i(null,o)):/\.dae$/i.test(t)?new md(e).load(t,o=>i(o.scene),null,o=>i(null,o)):console.warn(`URDFLoader: Could not load model at ${t}.
No loader available`)}},fy=wm;var aR=3*Math.PI/180,lR=.01,py=16723245,cR=16751903,hR=11032055;function my(s,t){let e=[];return s.forEach((n,i)=>{let{lower:r,upper:o}=n?.limit??{};if(!(o>r)||t[i]==null)return;let a=Math.min(t[i]-r,o-t[i]),c=n.jointType==="prismatic",l=a/(c?lR:aR),h=c?`${(1e3*a).toFixed(1)} mm`:`${(a*180/Math.PI).toFixed(1)}\xB0`;l<1&&e.push({name:n.name,link:n,left:a,share:l,words:h})}),e.sort((n,i)=>n.share-i.share)}var Sd=class{constructor(){this.shown=new Map}show(t,e,n){let i=new Map;for(let r of n)i.set(r.link,hR);for(let r of e)if(r.level)for(let o of[r.a,r.b]){let a=t.links[o];a&&i.get(a)!==py&&i.set(a,r.level==="touch"?py:cR)}for(let[r,o]of this.shown)i.get(r)!==o&&this.paint(r,null);for(let[r,o]of i)this.shown.get(r)!==o&&this.paint(r,o);this.shown=i}paint(t,e){let n=i=>{i!==t&&(i.isURDFJoint||i.isURDFLink)&&!(t.isURDFJoint&&i.parent===t)||(i.isMesh&&i.material.emissive&&(i.material.emissive.set(e??0),i.material.emissiveIntensity=e===null?1:.55),i.children.forEach(n))};n(t)}};var uR=.8;function dR(s){s.traverse(t=>{if(!t.isMesh)return;t.castShadow=!0,t.receiveShadow=!0,!mn&&t.geometry.type==="BufferGeometry"&&!t.geometry.index&&(t.geometry=oy(t.geometry,uR));let e=Array.isArray(t.material)?t.material[0]:t.material;if(!e?.isMeshPhongMaterial||e.map)return;let n=e.color.r+e.color.g+e.color.b<.6;t.material=Us({color:e.color,transparent:e.transparent,opacity:e.opacity,roughness:n?.5:.38,metalness:n?.35:.08})})}async function gy(){let s=await fetch(ho("robot.urdf"),{cache:"no-store"});if(!s.ok)throw new Error(`robot.urdf: ${s.status}`);let t=await s.text(),e=new la;e.setURLModifier(ho);let n=new fy(e);n.packages=o=>`/robot/package/${encodeURIComponent(o)}`,n.loadMeshCb=(o,a,c,l)=>{if(!/\.obj$/i.test(o)){n.defaultMeshLoader(o,a,c,l);return}new hd(a).load(o,h=>{h.traverse(u=>{u.isMesh&&c&&(u.material=c)}),l(h)},void 0,h=>l(null,h))},n.workingPath="/robot/";let i=new Promise(o=>{e.onLoad=o});e.itemStart("urdf");let r=n.parse(t,"/robot/");return e.itemEnd("urdf"),{model:r,meshes:i}}var Md=class{constructor(t){this.scene=t,this.model=null,this.joints=[],this.whole=!1,this.begun=gy().catch(()=>null)}async load(t,e){let{begun:n}=this;this.begun=null;let{model:i,meshes:r}=await n??await gy();this.model&&this.scene.remove(this.model),this.whole=!1,this.model=i,this.joints=t.map(o=>i.joints[o]??null);for(let o of this.joints)o&&(o.ignoreLimits=!0);this.tint=new Sd,this.scene.add(i),await r,dR(i),e(i),mn&&Tu(i),this.whole=this.model===i}warn(t,e){if(!this.model)return[];let n=my(this.joints,t);return this.tint.show(this.model,e,n),n}pose(t,e){this.model&&(this.model.position.set(e[0],e[1],e[2]),this.model.quaternion.set(e[4],e[5],e[6],e[3]),t.forEach((n,i)=>this.joints[i]?.setJointValue(n??0)))}dim(t){!this.model||this.pale===t||(this.pale=t,this.model.traverse(e=>{e.isMesh&&(e.material.transparent=t,e.material.opacity=t?.45:1)}))}};var xy=Math.PI/180;function ye(s,t={},e=[]){let n=Object.assign(document.createElement(s),t);return n.append(...e),n}var Na=s=>s.map(t=>ye("option",{value:t,textContent:t})),_y=(s,t,e)=>ye("input",{type:"number",value:s,step:t,title:e,className:"narrow"}),Sm=([s,t],[e,n])=>s===e&&t===n||s===n&&t===e,Ed=class{constructor(t,{near:e,send:n,toast:i}){Object.assign(this,{box:t,near:e,send:n,toast:i}),this.choices=null,this.joints={},this.pushes=[],this.unchecked=[],this.base={}}get open(){return!this.box.hidden}async toggle(t){if(this.box.hidden=!t,document.body.classList.toggle("setting-up",t),!(!t||this.choices))try{this.choices=await(await fetch(ho("setup.json"))).json();let e=await fetch(ho("setup/now.json"));this.build(e.ok?await e.json():{})}catch(e){this.choices=null,this.toast(`Cannot set up: ${e.message}`)}}build(t){let{scenes:e,engines:n,poses:i,joints:r,links:o,unchecked:a}=this.choices;this.scene=ye("select",{ariaLabel:"scene",onchange:()=>this.show()},Na(e.map(u=>u.name))),this.about=ye("p",{className:"hint"}),this.engine=ye("select",{ariaLabel:"engine"},[ye("option",{value:"",textContent:"the scene's engine"}),...Na(n)]),this.pose=ye("select",{ariaLabel:"posture",onchange:()=>{this.joints={},this.showJoints()}},[ye("option",{value:"",textContent:"the scene's posture"}),...Na(Object.keys(i))]),this.filter=ye("input",{type:"search",placeholder:"joint: knee, waist \u2026",oninput:()=>this.showJoints()}),this.jointRows=ye("div",{className:"rows"}),this.pushRows=ye("div",{className:"rows"}),this.first=ye("select",{ariaLabel:"first link"},Na(o)),this.second=ye("select",{ariaLabel:"second link"},Na(o)),this.second.selectedIndex=Math.min(1,o.length-1),this.pairRows=ye("div",{className:"rows"}),this.nearRows=ye("div",{className:"rows"});let c=ye("button",{textContent:"Leave out",onclick:()=>this.leaveOut([this.first.value,this.second.value])});c.id="leave-out";let l=ye("button",{textContent:"Start anew",onclick:()=>this.start()});l.id="start-anew";let h=u=>ye("h2",{textContent:u});this.box.replaceChildren(ye("section",{},[h("Scene"),this.scene,this.engine,this.about]),ye("section",{},[h("Posture at the start"),this.pose,this.filter,this.jointRows]),ye("section",{},[h("Pushes"),this.pushRows,ye("button",{id:"add-push",textContent:"+ push",onclick:()=>{this.pushes.push({link:o[0],at:3,impulse:[30,0,0]}),this.showPushes()}})]),ye("section",{},[h("Pairs that are not checked"),this.pairRows,ye("div",{className:"line"},[this.first,this.second,c]),this.nearRows]),ye("section",{className:"end"},[l,ye("p",{className:"hint",textContent:"The simulated robot starts anew, its controller and guard with it; the log goes on."})])),this.scene.value=e.some(u=>u.name===t.scene)?t.scene:"stand",this.engine.value=t.engine??"",this.pose.value=t.pose??"",this.joints={...t.joints},this.pushes=(t.pushes??[]).map(u=>({...u})),this.unchecked=(t.unchecked??a).map(u=>[...u]),this.known=r,this.show(),this.showJoints(),this.showPushes(),this.showPairs()}show(){this.about.textContent=this.choices.scenes.find(t=>t.name===this.scene.value)?.about??""}showJoints(){this.base=this.choices.poses[this.pose.value||"half_sitting"]??{};let t=this.filter.value.trim().toLowerCase().split(/\s+/),e=this.known.filter(({name:n})=>t.every(i=>n.toLowerCase().includes(i)));this.jointRows.replaceChildren(...e.map(({name:n,lower:i,upper:r})=>{let o=this.joints[n]??this.base[n]??0,a=ye("output",{textContent:`${(o/xy).toFixed(1)}\xB0`}),c=ye("input",{type:"range",min:i,max:r,step:.001,value:o,title:n});return c.oninput=()=>{this.joints[n]=Number(c.value),a.textContent=`${(c.value/xy).toFixed(1)}\xB0`},ye("label",{className:"joint"},[ye("span",{textContent:n}),c,a])}))}showPushes(){this.pushRows.replaceChildren(...this.pushes.map((t,e)=>{let n=ye("select",{ariaLabel:"pushed link",onchange:()=>{t.link=n.value}},Na(this.choices.links));n.value=t.link;let i=_y(t.at,.1,"seconds after the start");i.oninput=()=>{t.at=Number(i.value)};let r=["forward","left","up"].map((o,a)=>{let c=_y(t.impulse[a],5,`impulse ${o} [N s]`);return c.oninput=()=>{t.impulse[a]=Number(c.value)},c});return ye("div",{className:"line push"},[n,i,"s",...r,"N s",this.cross(()=>{this.pushes.splice(e,1),this.showPushes()})])}))}cross(t){return ye("button",{className:"close",textContent:"\xD7",title:"take away",onclick:t})}leaveOut(t){t[0]===t[1]||this.unchecked.some(e=>Sm(t,e))||(this.unchecked.push(t),this.showPairs())}showPairs(){this.pairRows.replaceChildren(...this.unchecked.map((e,n)=>ye("div",{className:"line pair-out"},[ye("span",{textContent:e.join(" \u2013 ")}),this.cross(()=>{this.unchecked.splice(n,1),this.showPairs()})]))),this.unchecked.length===0&&(this.pairRows.textContent="Every pair is checked but neighbours.");let t=this.near().filter(({a:e,b:n})=>[e,n].every(i=>this.choices.links.includes(i))&&!this.unchecked.some(i=>Sm([e,n],i)));this.nearRows.replaceChildren(...t.slice(0,3).map(({a:e,b:n,mm:i})=>ye("div",{className:"line"},[ye("span",{textContent:`near now: ${e} \u2013 ${n}, ${i.toFixed(0)} mm`}),ye("button",{textContent:"Leave out",onclick:()=>this.leaveOut([e,n])})])))}posture(t){return!this.open||!this.choices?null:t.map(e=>this.joints[e]??this.base[e]??0)}start(){let t={scene:this.scene.value,engine:this.engine.value,pose:this.pose.value,joints:this.joints,pushes:this.pushes},e=this.choices.unchecked;(e.length!==this.unchecked.length||this.unchecked.some(i=>!e.some(r=>Sm(i,r))))&&(t.unchecked=this.unchecked),this.send({do:"setup",setup:t})||this.toast("The viewer does not answer.")}};var yy={type:"change"},Em={type:"start"},vy={type:"end"},Td=new Cs,by=new xi,fR=Math.cos(70*vi.DEG2RAD),Hn=new F,Pi=2*Math.PI,Le={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},Mm=1e-6,Ad=class extends eo{constructor(t,e=null){super(t,e),this.state=Le.NONE,this.target=new F,this.cursor=new F,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:Cr.ROTATE,MIDDLE:Cr.DOLLY,RIGHT:Cr.PAN},this.touches={ONE:Pr.ROTATE,TWO:Pr.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new F,this._lastQuaternion=new ve,this._lastTargetPosition=new F,this._quat=new ve().setFromUnitVectors(t.up,new F(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new ua,this._sphericalDelta=new ua,this._scale=1,this._panOffset=new F,this._rotateStart=new Vt,this._rotateEnd=new Vt,this._rotateDelta=new Vt,this._panStart=new Vt,this._panEnd=new Vt,this._panDelta=new Vt,this._dollyStart=new Vt,this._dollyEnd=new Vt,this._dollyDelta=new Vt,this._dollyDirection=new F,this._mouse=new Vt,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=mR.bind(this),this._onPointerDown=pR.bind(this),this._onPointerUp=gR.bind(this),this._onContextMenu=SR.bind(this),this._onMouseWheel=yR.bind(this),this._onKeyDown=bR.bind(this),this._onTouchStart=vR.bind(this),this._onTouchMove=wR.bind(this),this._onMouseDown=xR.bind(this),this._onMouseMove=_R.bind(this),this._interceptControlDown=MR.bind(this),this._interceptControlUp=ER.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(t){this._cursorStyle=t,t==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(t){super.connect(t),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=Le.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(t){t.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=t}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(yy),this.update(),this.state=Le.NONE}pan(t,e){this._pan(t,e),this.update()}dollyIn(t){this._dollyIn(t),this.update()}dollyOut(t){this._dollyOut(t),this.update()}rotateLeft(t){this._rotateLeft(t),this.update()}rotateUp(t){this._rotateUp(t),this.update()}update(t=null){let e=this.object.position;Hn.copy(e).sub(this.target),Hn.applyQuaternion(this._quat),this._spherical.setFromVector3(Hn),this.autoRotate&&this.state===Le.NONE&&this._rotateLeft(this._getAutoRotationAngle(t)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let n=this.minAzimuthAngle,i=this.maxAzimuthAngle;isFinite(n)&&isFinite(i)&&(n<-Math.PI?n+=Pi:n>Math.PI&&(n-=Pi),i<-Math.PI?i+=Pi:i>Math.PI&&(i-=Pi),n<=i?this._spherical.theta=Math.max(n,Math.min(i,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(n+i)/2?Math.max(n,this._spherical.theta):Math.min(i,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(Hn.setFromSpherical(this._spherical),Hn.applyQuaternion(this._quatInverse),e.copy(this.target).add(Hn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=Hn.length();o=this._clampDistance(a*this._scale);let c=a-o;this.object.position.addScaledVector(this._dollyDirection,c),this.object.updateMatrixWorld(),r=!!c}else if(this.object.isOrthographicCamera){let a=new F(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let c=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=c!==this.object.zoom;let l=new F(this._mouse.x,this._mouse.y,0);l.unproject(this.object),this.object.position.sub(l).add(a),this.object.updateMatrixWorld(),o=Hn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(Td.origin.copy(this.object.position),Td.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(Td.direction))<fR?this.object.lookAt(this.target):(by.setFromNormalAndCoplanarPoint(this.object.up,this.target),Td.intersectPlane(by,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>Mm||8*(1-this._lastQuaternion.dot(this.object.quaternion))>Mm||this._lastTargetPosition.distanceToSquared(this.target)>Mm?(this.dispatchEvent(yy),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(t){return t!==null?Pi/60*this.autoRotateSpeed*t:Pi/60/60*this.autoRotateSpeed}_getZoomScale(t){let e=Math.abs(t*.01);return Math.pow(.95,this.zoomSpeed*e)}_rotateLeft(t){this._sphericalDelta.theta-=t}_rotateUp(t){this._sphericalDelta.phi-=t}_panLeft(t,e){Hn.setFromMatrixColumn(e,0),Hn.multiplyScalar(-t),this._panOffset.add(Hn)}_panUp(t,e){this.screenSpacePanning===!0?Hn.setFromMatrixColumn(e,1):(Hn.setFromMatrixColumn(e,0),Hn.crossVectors(this.object.up,Hn)),Hn.multiplyScalar(t),this._panOffset.add(Hn)}_pan(t,e){let n=this.domElement;if(this.object.isPerspectiveCamera){let i=this.object.position;Hn.copy(i).sub(this.target);let r=Hn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*t*r/n.clientHeight,this.object.matrix),this._panUp(2*e*r/n.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(t*(this.object.right-this.object.left)/this.object.zoom/n.clientWidth,this.object.matrix),this._panUp(e*(this.object.top-this.object.bottom)/this.object.zoom/n.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(t,e){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let n=this.domElement.getBoundingClientRect(),i=t-n.left,r=e-n.top,o=n.width,a=n.height;this._mouse.x=i/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(t){return Math.max(this.minDistance,Math.min(this.maxDistance,t))}_handleMouseDownRotate(t){this._rotateStart.set(t.clientX,t.clientY)}_handleMouseDownDolly(t){this._updateZoomParameters(t.clientX,t.clientY),this._dollyStart.set(t.clientX,t.clientY)}_handleMouseDownPan(t){this._panStart.set(t.clientX,t.clientY)}_handleMouseMoveRotate(t){this._rotateEnd.set(t.clientX,t.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(Pi*this._rotateDelta.x/e.clientHeight),this._rotateUp(Pi*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(t){this._dollyEnd.set(t.clientX,t.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(t){this._panEnd.set(t.clientX,t.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(t){this._updateZoomParameters(t.clientX,t.clientY),t.deltaY<0?this._dollyIn(this._getZoomScale(t.deltaY)):t.deltaY>0&&this._dollyOut(this._getZoomScale(t.deltaY)),this.update()}_handleKeyDown(t){let e=!1;switch(t.code){case this.keys.UP:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(Pi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),e=!0;break;case this.keys.BOTTOM:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(-Pi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),e=!0;break;case this.keys.LEFT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(Pi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),e=!0;break;case this.keys.RIGHT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(-Pi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),e=!0;break}e&&(t.preventDefault(),this.update())}_handleTouchStartRotate(t){if(this._pointers.length===1)this._rotateStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),i=.5*(t.pageY+e.y);this._rotateStart.set(n,i)}}_handleTouchStartPan(t){if(this._pointers.length===1)this._panStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),i=.5*(t.pageY+e.y);this._panStart.set(n,i)}}_handleTouchStartDolly(t){let e=this._getSecondPointerPosition(t),n=t.pageX-e.x,i=t.pageY-e.y,r=Math.sqrt(n*n+i*i);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enablePan&&this._handleTouchStartPan(t)}_handleTouchStartDollyRotate(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enableRotate&&this._handleTouchStartRotate(t)}_handleTouchMoveRotate(t){if(this._pointers.length==1)this._rotateEnd.set(t.pageX,t.pageY);else{let n=this._getSecondPointerPosition(t),i=.5*(t.pageX+n.x),r=.5*(t.pageY+n.y);this._rotateEnd.set(i,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(Pi*this._rotateDelta.x/e.clientHeight),this._rotateUp(Pi*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(t){if(this._pointers.length===1)this._panEnd.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),i=.5*(t.pageY+e.y);this._panEnd.set(n,i)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(t){let e=this._getSecondPointerPosition(t),n=t.pageX-e.x,i=t.pageY-e.y,r=Math.sqrt(n*n+i*i);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(t.pageX+e.x)*.5,a=(t.pageY+e.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enablePan&&this._handleTouchMovePan(t)}_handleTouchMoveDollyRotate(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enableRotate&&this._handleTouchMoveRotate(t)}_addPointer(t){this._pointers.push(t.pointerId)}_removePointer(t){delete this._pointerPositions[t.pointerId];for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId){this._pointers.splice(e,1);return}}_isTrackingPointer(t){for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId)return!0;return!1}_trackPointer(t){let e=this._pointerPositions[t.pointerId];e===void 0&&(e=new Vt,this._pointerPositions[t.pointerId]=e),e.set(t.pageX,t.pageY)}_getSecondPointerPosition(t){let e=t.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[e]}_customWheelEvent(t){let e=t.deltaMode,n={clientX:t.clientX,clientY:t.clientY,deltaY:t.deltaY};switch(e){case 1:n.deltaY*=16;break;case 2:n.deltaY*=100;break}return t.ctrlKey&&!this._controlActive&&(n.deltaY*=10),n}};function pR(s){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(s.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(s)&&(this._addPointer(s),s.pointerType==="touch"?this._onTouchStart(s):this._onMouseDown(s),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function mR(s){this.enabled!==!1&&(s.pointerType==="touch"?this._onTouchMove(s):this._onMouseMove(s))}function gR(s){switch(this._removePointer(s),this._pointers.length){case 0:this.domElement.releasePointerCapture(s.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(vy),this.state=Le.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let t=this._pointers[0],e=this._pointerPositions[t];this._onTouchStart({pointerId:t,pageX:e.x,pageY:e.y});break}}function xR(s){let t;switch(s.button){case 0:t=this.mouseButtons.LEFT;break;case 1:t=this.mouseButtons.MIDDLE;break;case 2:t=this.mouseButtons.RIGHT;break;default:t=-1}switch(t){case Cr.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(s),this.state=Le.DOLLY;break;case Cr.ROTATE:if(s.ctrlKey||s.metaKey||s.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(s),this.state=Le.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(s),this.state=Le.ROTATE}break;case Cr.PAN:if(s.ctrlKey||s.metaKey||s.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(s),this.state=Le.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(s),this.state=Le.PAN}break;default:this.state=Le.NONE}this.state!==Le.NONE&&this.dispatchEvent(Em)}function _R(s){switch(this.state){case Le.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(s);break;case Le.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(s);break;case Le.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(s);break}}function yR(s){this.enabled===!1||this.enableZoom===!1||this.state!==Le.NONE||(s.preventDefault(),this.dispatchEvent(Em),this._handleMouseWheel(this._customWheelEvent(s)),this.dispatchEvent(vy))}function bR(s){this.enabled!==!1&&this._handleKeyDown(s)}function vR(s){switch(this._trackPointer(s),this._pointers.length){case 1:switch(this.touches.ONE){case Pr.ROTATE:if(this.enableRotate===!1){this.state=Le.NONE;break}this._handleTouchStartRotate(s),this.state=Le.TOUCH_ROTATE;break;case Pr.PAN:if(this.enablePan===!1){this.state=Le.NONE;break}this._handleTouchStartPan(s),this.state=Le.TOUCH_PAN;break;default:this.state=Le.NONE}break;case 2:switch(this.touches.TWO){case Pr.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(s),this.state=Le.TOUCH_DOLLY_PAN;break;case Pr.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(s),this.state=Le.TOUCH_DOLLY_ROTATE;break;default:this.state=Le.NONE}break;default:this.state=Le.NONE}this.state!==Le.NONE&&this.dispatchEvent(Em)}function wR(s){switch(this._trackPointer(s),this.state){case Le.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(s),this.update();break;case Le.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(s),this.update();break;case Le.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(s),this.update();break;case Le.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(s),this.update();break;default:this.state=Le.NONE}}function SR(s){this.enabled!==!1&&s.preventDefault()}function MR(s){s.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function ER(s){s.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var TR=1/1100,AR=1.4,RR=new F(0,1,0);function CR(s){let t={color:s,depthTest:!1,transparent:!0,opacity:.9};return mn?new Qe(t):new nr({...t,emissive:s,emissiveIntensity:.45,roughness:.5})}var cc=class extends Be{constructor(t,e){super();let n=CR(e),i=mn?6:16;this.shafts=new Sr(new Ye(.008,.008,1,i).translate(0,.5,0),n,t),this.heads=new Sr(new ia(.022,.055,i).translate(0,.0275,0),n,t);for(let r of[this.shafts,this.heads])r.renderOrder=9,r.frustumCulled=!1,this.add(r);this.show([],1,0)}show(t,e,n){let i=new F,r=new F,o=new ve,a=new F,c=new Gt,l=0;for(let h of t){if(l===this.shafts.instanceMatrix.count)break;i.fromArray(h,0),r.fromArray(h,3);let u=Math.min(r.length()*TR*e,AR);!(u>.005)||r.length()<n||(o.setFromUnitVectors(RR,r.normalize()),this.shafts.setMatrixAt(l,c.compose(i,o,a.set(1,u,1))),this.heads.setMatrixAt(l,c.compose(i.addScaledVector(r,u),o,a.set(1,1,1))),++l)}for(let h of[this.shafts,this.heads])h.count=l,h.visible=l>0,h.instanceMatrix.needsUpdate=!0}};var Rd=60,PR=[2,8],wy=19,Cd=class extends gt{constructor(t,e){super(new Qs(Rd,Rd),new nr({roughness:.95,depthWrite:!1})),this.anisotropy=e,this.receiveShadow=!0,this.renderOrder=-1,this.paint(t)}paint(t){this.material.map?.dispose(),this.material.map=this.tile(t),this.material.needsUpdate=!0}tile(t){let e=document.createElement("canvas"),n=e.width=e.height=512,i=e.getContext("2d");i.fillStyle=t.floor,i.fillRect(0,0,n,n);let r=(a,c,l)=>{i.fillStyle=l;for(let h=0;h<=n;h+=a)i.fillRect(h-c/2,0,c,n),i.fillRect(0,h-c/2,n,c)};r(n/4,3,t.thin),r(n,8,t.thick);let o=new pl(e);return o.wrapS=o.wrapT=ds,o.repeat.set(Rd,Rd),o.anisotropy=this.anisotropy,o.colorSpace=Pe,o}},Pd=class extends Be{constructor(t){super();let e=new tr(0,1.5*wy,32,12);e.setAttribute("color",new Xe(new Float32Array(3*e.attributes.position.count),3)),this.disc=new gt(e,new Qe({vertexColors:!0,depthWrite:!1})),this.disc.renderOrder=-2,this.lines=[.25,1].map((n,i)=>{let r=new Ti(IR(n,PR[i]),new pn({depthWrite:!1}));return r.renderOrder=-1,this.add(r),r}),this.add(this.disc),this.paint(t)}paint(t){let e=new qt(t.floor),n=new qt(t.sky),i=new qt,{position:r,color:o}=this.disc.geometry.attributes;for(let a=0;a<r.count;++a){let c=Math.min(1,Math.hypot(r.getX(a),r.getY(a))/wy);i.lerpColors(e,n,c),o.setXYZ(a,i.r,i.g,i.b)}o.needsUpdate=!0,this.lines[0].material.color.set(t.thin),this.lines[1].material.color.set(t.thick)}};function IR(s,t){let e=[];for(let n=-t;n<=t;n+=s)if(!(s<1&&n%1===0))for(let i=-t;i<t;i+=4)e.push(n,i,0,n,i+4,0,i,n,0,i+4,n,0);return new ue().setAttribute("position",new Xt(e,3))}var LR=.005,Sy=.015,NR=s=>s!=null&&s.every(t=>t!==null);function My(s,t,e){let n=new gt(new tr(s,t,32),new Qe({color:e,depthTest:!1,transparent:!0}));return n.renderOrder=10,n.visible=!1,n}var Id=class{constructor(t){this.soles=[0,1,2,3,4,5].map(()=>{let e=new ue;e.setAttribute("position",new Xe(new Float32Array(12),3));let n=new jr(e,new pn({color:9417689,depthTest:!1,transparent:!0}));return n.frustumCulled=!1,n.renderOrder=8,n}),this.reference=My(.036,.041,16777215),this.dcm=My(.008,.02,8189392),t.add(...this.soles,this.reference,this.dcm)}show(t){this.soles.forEach((e,n)=>{let i=t.soles[n];i?.length===1&&(i=[[1,1],[-1,1],[-1,-1],[1,-1]].map(([r,o])=>[i[0][0]+Sy*r,i[0][1]+Sy*o,i[0][2]])),e.visible=i?.length===4,e.visible&&(i.forEach((r,o)=>e.geometry.attributes.position.setXYZ(o,r[0],r[1],r[2]+.002)),e.geometry.attributes.position.needsUpdate=!0,e.material.color.set(t.loaded[n]?5817599:9148328),e.material.opacity=t.loaded[n]?1:.5)});for(let[e,n]of[[this.reference,t.zmp_reference],[this.dcm,t.dcm]])e.visible=NR(n)&&t.polygon.length>0,e.visible&&e.position.set(n[0],n[1],(n[2]??0)+LR)}};var Tm=class{constructor(t){this.domElement=t,this.shadowMap={},this.capabilities={getMaxAnisotropy:()=>1};for(let e of["setPixelRatio","setSize","setViewport","render"])this[e]=()=>{}}getPixelRatio(){return 1}getSize(t){return t.set(innerWidth,innerHeight)}setAnimationLoop(t){let e=()=>{t(),requestAnimationFrame(e)};requestAnimationFrame(e)}};function Ey(s){try{let t=new xu({canvas:s,antialias:!mn});return t.debug.checkShaderErrors=!1,t}catch{return document.body.classList.add("no-3d"),new Tm(s)}}var Am=mn?16:32,DR=16747100,Ty=5817599,UR=16777215,Ay=[7307669,6452362,8096928];function Cy({shape:s,size:[t,e,n]}){return s===1?new qe(t,e,n):s===2?new oi(t,Am,Am/2):s===3?new Ye(t,t,e,Am).rotateX(Math.PI/2):null}function hc(s,t){s.position.set(t[0],t[1],t[2]),s.quaternion.set(t[4],t[5],t[6],t[3])}function Ry(s,t,e){for(let n of s.children)n.geometry.dispose();s.clear(),t.forEach((n,i)=>{let r=Cy(n),o=r?new gt(r,e(i)):new gt;o.castShadow=o.receiveShadow=!0,hc(o,n.pose),s.add(o)})}var Ld=class{constructor(t){this.obstacles=new Be,this.terrain=new Be,this.loose=new Be,this.held=new Be,this.steps=new Be,t.add(this.obstacles,this.terrain,this.loose,this.held,this.steps),this.grip=new pn({color:DR,depthTest:!1}),this.wood=Us({color:13208124,roughness:.7,transparent:!0,opacity:.88}),this.ground=Us({color:16777215,roughness:.95}),this.bodies=[14263361,6268791,12151133,9273282].map(e=>Us({color:e,roughness:.6})),this.sole=new Qe({color:Ty,transparent:!0,opacity:.35,depthTest:!1}),this.next=new Qe({color:Ty,transparent:!0,opacity:.7,depthTest:!1}),this.dot=new Qe({color:UR,transparent:!0,opacity:.9,depthTest:!1}),this.box=new qe(1,1,1),this.ball=new oi(1,8,6)}show({obstacles:t,terrain:e=[],loose:n=[],held:i=[]}){Ry(this.obstacles,t,()=>this.wood),this.lay(e),Ry(this.loose,n,r=>this.bodies[r%this.bodies.length]);for(let r of this.held.children)r.geometry.dispose();this.held.clear();for(let r of i){let o=Cy(r);if(!o)continue;let a=new Ti(new _l(o),this.grip);o.dispose(),a.renderOrder=11,hc(a,r.pose),a.updateMatrix(),a.userData={link:r.link,inLink:a.matrix.clone()},a.matrixAutoUpdate=!1,this.held.add(a)}}carry(t){for(let e of this.held.children){let n=t?.links[e.userData.link];e.visible=n!==void 0,n&&(n.updateWorldMatrix(!0,!1),e.matrix.multiplyMatrices(n.matrixWorld,e.userData.inLink))}}lay(t){for(let r of this.terrain.children)r.dispose();if(this.terrain.clear(),t.length===0)return;let e=new Sr(this.box,this.ground,t.length),n=new De,i=new qt;t.forEach(({size:r,pose:o},a)=>{hc(n,o),n.scale.set(...r),n.updateMatrix(),e.setMatrixAt(a,n.matrix),e.setColorAt(a,i.set(Ay[a%Ay.length]))}),e.receiveShadow=!0,e.frustumCulled=!1,this.terrain.add(e)}move({loose:t,footsteps:e=[]}){for(t?.forEach((n,i)=>{this.loose.children[i]&&hc(this.loose.children[i],n)});this.steps.children.length<e.length;)this.steps.add(new gt(this.box,this.sole));this.steps.children.forEach((n,i)=>{let r=e[i];if(n.visible=r!==void 0,!r)return;let[o,a,c]=r.size,l=r.shape===1;n.geometry=l?this.box:this.ball,n.material=l?i===0?this.next:this.sole:this.dot,l?n.scale.set(o,a,c):n.scale.setScalar(o),n.renderOrder=l?6:9,hc(n,r.pose)})}};var FR=120,kR=70,OR=12,BR=200,zR=.85,HR=.75,Rm={sky:1317670,floor:"#1c2634",thin:"#2b394c",thick:"#4d6685",ambient:1.5},VR={sky:14673904,floor:"#cfd8e3",thin:"#bcc8d6",thick:"#93a5ba",ambient:2.2};function uc(s,t,e={}){let n=new ue;n.setAttribute("position",new Xe(new Float32Array(3*s),3));let i=e.segments?Ti:jr,r=new i(n,new pn({color:t,transparent:!0,opacity:e.opacity??1}));return r.frustumCulled=!1,r}function Da(s,t,e=0){let n=s.geometry.attributes.position,i=Math.min(t.length,n.count);for(let r=0;r<i;++r)n.setXYZ(r,t[r][0],t[r][1],t[r][2]+e);s.geometry.setDrawRange(0,i),n.needsUpdate=!0}var Nd=class{constructor(t){this.renderer=Ey(t),this.renderer.shadowMap.enabled=!mn,this.renderer.shadowMap.type=no,this.renderer.toneMapping=mn?Ji:Ll,this.renderer.toneMappingExposure=1.15,this.scene=new Yr,this.scene.background=new qt(1317670),mn||(this.scene.fog=new ll(1317670,7,19)),this.camera=new vn(38,1,.05,60),this.camera.up.set(0,0,1),this.camera.position.set(2.55,1.55,1.3),this.controls=new Ad(this.camera,t),this.controls.target.set(0,0,.74),this.first={z:.74,from:this.camera.position.clone().sub(this.controls.target),scale:1},this.controls.enableDamping=!0,this.controls.minDistance=.5,this.controls.maxDistance=14,this.tookIn=!1,this.turned=!1,this.controls.addEventListener("start",()=>{this.tookIn=this.turned=!0}),this.follow=!0,this.arrowScale=1,this.leastForce=5,this.pixels=mn?HR:Math.min(devicePixelRatio,2),this.slowFrames=0,this.fine=new URLSearchParams(location.hash.slice(1)).has("fine"),this.light(),this.ground(),this.overlays(),this.shapes=new Ld(this.scene),addEventListener("resize",()=>this.resize()),this.resize()}light(){this.sky=new El(13624319,2830136,1.5),this.scene.add(this.sky);let t=new Rr(8369407,1);t.position.set(-4,-3,3),this.scene.add(t),this.sun=new Rr(16773855,2.6),this.sun.castShadow=!0,this.sun.shadow.mapSize.set(2048,2048),Object.assign(this.sun.shadow.camera,{left:-1.7,right:1.7,top:1.9,bottom:-1.7,near:1,far:12}),this.sun.shadow.bias=-3e-4,this.sun.shadow.normalBias=.012,this.sun.shadow.radius=4,this.scene.add(this.sun,this.sun.target)}ground(){this.floor=mn?new Pd(Rm):new Cd(Rm,this.renderer.capabilities.getMaxAnisotropy()),this.scene.add(this.floor);let t=uc(2,15026253,{segments:!0});Da(t,[[0,0,.002],[.5,0,.002]]);let e=uc(2,4116366,{segments:!0});Da(e,[[0,0,.002],[0,.5,.002]]),this.scene.add(t,e)}theme(t){let e=t?VR:Rm;this.scene.background.set(e.sky),this.scene.fog?.color.set(e.sky),this.sky.intensity=e.ambient,this.floor.paint(e)}overlays(){this.forces=new cc(8,3718648),this.push=new cc(1,16747069),this.balance=new Be,this.support=new gt(new ue,new Qe({color:4116366,transparent:!0,opacity:.34,side:ci,depthWrite:!1})),this.support.geometry.setAttribute("position",new Xe(new Float32Array(36),3)),this.support.frustumCulled=!1,this.rim=uc(12,4116366),this.zmp=new Be;let t=new gt(new xl(.014,24),new Qe({color:16734920,depthTest:!1})),e=new gt(new tr(.024,.03,32),new Qe({color:16734920,depthTest:!1}));for(let n of[t,e])n.renderOrder=10;this.zmp.add(t,e),this.com=new gt(new oi(.03,20,14),new Qe({color:16765503,depthTest:!1,transparent:!0,opacity:.85})),this.com.renderOrder=11,this.plumb=uc(2,16765503,{segments:!0,opacity:.7}),this.plumb.material.depthTest=!1,this.balance.add(this.support,this.rim,this.zmp,this.com,this.plumb),this.markers=new Id(this.balance),this.pairs=uc(12,16756768,{segments:!0}),this.pairs.material.depthTest=!1,this.pairs.renderOrder=12,this.scene.add(this.forces,this.push,this.balance,this.pairs)}resize(){this.renderer.setPixelRatio(this.pixels),this.renderer.setSize(innerWidth,innerHeight,!1),this.camera.aspect=innerWidth/innerHeight,this.camera.updateProjectionMatrix()}show(t){this.forces.show(t.forces,this.arrowScale,this.leastForce),this.push.show(t.push?[t.push]:[],this.arrowScale,this.leastForce),this.showBalance(t),this.markers.show(t),this.shapes.move(t);let e=t.pairs.filter(i=>i.mm<FR);Da(this.pairs,e.flatMap(i=>[i.from,i.to]));let n=e.some(i=>i.level==="touch")?16731469:e.some(i=>i.level)?16756768:9417689;this.pairs.material.color.set(n),this.follow&&this.followTo(t.base)}showBalance(t){let e=t.polygon,n=[];for(let o=1;o+1<e.length;++o)n.push(e[0],e[o],e[o+1]);this.support.geometry.attributes.position.count<n.length&&this.support.geometry.setAttribute("position",new Xe(new Float32Array(3*n.length),3)),Da(this.support,n,.003),Da(this.rim,e,.004);let i=t.margin_mm===null?5817599:t.margin_mm>20?4116366:t.margin_mm>5?16756768:16731469;this.support.material.color.set(i),this.rim.material.color.set(i);let r=o=>o.every(a=>a!==null);this.zmp.visible=e.length>0&&r(t.zmp),this.zmp.visible&&this.zmp.position.set(t.zmp[0],t.zmp[1],.006),this.com.visible=this.plumb.visible=r(t.com)&&!this.fixed,this.com.visible&&(this.com.position.set(...t.com),Da(this.plumb,[t.com,[t.com[0],t.com[1],.005]]))}get onTop(){return[this.forces,this.push,this.balance,this.pairs,this.shapes.steps]}takeIn(t){let e=({pose:n})=>Math.hypot(n[0]-this.controls.target.x,n[1]-this.controls.target.y)<4;this.tookIn||!t.loose?.some(e)||(this.tookIn=!0,this.first.from.multiplyScalar(1.7),this.lookFrom(this.first.scale))}fitTo(t){t.updateMatrixWorld(!0);let e=new Oi().setFromObject(t);if(this.turned||e.isEmpty())return;let n=Math.min(4,Math.max(.3,.5*e.getSize(new F).length()/zR)),i=Math.abs(n-1)<.12;this.controls.target.z=i?this.first.z:.5*(Math.max(0,e.min.z)+e.max.z),this.lookFrom(i?1:n)}lookFrom(t){this.first.scale=t,this.camera.position.copy(this.first.from).multiplyScalar(t).add(this.controls.target),this.controls.minDistance=Math.min(.5,.5*t),this.controls.maxDistance=14*Math.max(1,2*t),this.scene.fog&&Object.assign(this.scene.fog,{near:7*Math.max(1,t),far:19*Math.max(1,t)})}followTo(t){let e=new F(t[0]-this.controls.target.x,t[1]-this.controls.target.y,0),n=performance.now(),i=n-(this.followedAt??n);this.followedAt=n,e.length()<3&&e.multiplyScalar(1-Math.exp(-i/BR)),this.controls.target.add(e),this.camera.position.add(e)}spare(){if(this.fine)return;let t=performance.now();this.slowFrames=t-(this.drawnAt??t)>kR?this.slowFrames+1:0,this.drawnAt=t,!(this.slowFrames<OR||document.hidden)&&(this.slowFrames=0,this.pixels>.6?(this.pixels=Math.max(.6,.7*this.pixels),this.resize()):this.sun.castShadow=!1)}drawFirst(t){let e=this.scene.children.filter(n=>n.visible&&!n.isLight&&n!==this.floor&&n!==t);for(let n of e)n.visible=!1;this.draw();for(let n of e)n.visible=!0}draw(){this.spare(),this.controls.update();let t=this.controls.target;this.sun.position.set(t.x+2.2,t.y-1.6,4.6),this.sun.target.position.set(t.x,t.y,.6),this.renderer.render(this.scene,this.camera)}};function GR(){try{return localStorage.getItem("theme")}catch{return null}}var Dd=class{constructor(t){this.change=t;let e=new URLSearchParams(location.hash.slice(1)).get("theme");this.set((e??GR()??"dark")==="light")}set(t){this.light=t,document.body.classList.toggle("light",t);try{localStorage.setItem("theme",t?"light":"dark")}catch{}this.change(t)}toggle(){this.set(!this.light)}};var Me=s=>document.getElementById(s);var WR={switch:"switches",stop:"stops",fall:"falls",guard:"guard",missed:"missed ticks",message:"messages"},XR=[.05,.1,.25,.5,1,2,4,8,16],dc=(s,t)=>Object.assign(document.createElement("option"),{value:s,textContent:t}),Cm=s=>{let t=Math.floor(s/60);return t>0?`${t}:${(s-60*t).toFixed(3).padStart(6,"0")}`:s.toFixed(3)},qR=s=>s<1e9?`${(s/1e6).toFixed(0)} MB`:`${(s/1e9).toFixed(1)} GB`,Ud=class{constructor(t,{jumped:e,fill:n,toast:i}){Object.assign(this,{send:t,jumped:e,fill:n,toast:i}),this.state=null,this.marks=[],this.dragging=!1,this.askedAt=0,this.wanted=null,Me("tl-speed").append(...XR.map(a=>dc(a,`\xD7 ${a}`))),Me("tl-kind").append(dc("","all events"),...Object.entries(WR).map(([a,c])=>dc(a,c)));let r=(a,c)=>{Me(a).onclick=()=>{c(),Me(a).blur()}};r("tl-play",()=>this.toggle()),r("tl-back",()=>this.step(-1)),r("tl-on",()=>this.step(1)),r("tl-in",()=>this.mark("in")),r("tl-out",()=>this.mark("out")),r("tl-loop",()=>this.loop()),r("tl-last",()=>this.jump(-1)),r("tl-next",()=>this.jump(1)),Me("tl-speed").onchange=()=>{this.send({do:"speed",x:Number(Me("tl-speed").value)}),Me("tl-speed").blur()},Me("tl-kind").onchange=()=>{this.drawMarks(),Me("tl-kind").blur()},Me("tl-log").onchange=()=>{this.send({do:"open",log:Me("tl-log").value}),Me("tl-log").blur()},Me("tl-beside").onchange=()=>{this.send({do:"beside",log:Me("tl-beside").value,shift:0}),Me("tl-beside").blur()},Me("tl-shift").onchange=()=>this.send({do:"beside",log:this.state?.beside?.log??"",shift:Number(Me("tl-shift").value)||0});let o=Me("tl-line");o.onpointerdown=a=>{o.setPointerCapture(a.pointerId),this.dragging=!0,this.drag(a)},o.onpointermove=a=>{this.dragging&&this.drag(a)},o.onpointerup=o.onpointercancel=()=>{this.dragging=!1}}get active(){return this.state!==null}replay(t){let e=this.state===null,n=this.state?.log!==t.log,i=!e&&(n||this.state.jumps!==t.jumps);this.state=t,e&&document.body.classList.add("replaying"),(e||i)&&(i&&this.jumped(),clearTimeout(this.fillTimer),this.fillTimer=setTimeout(this.fill,250)),this.draw()}seek(t){this.state&&(this.wanted=Math.max(0,Math.min(t,this.state.duration)),this.tick())}tick(){let t=performance.now();this.wanted===null||t-this.askedAt<60||(this.askedAt=t,this.send({do:"seek",s:this.wanted}),this.wanted=null)}drag(t){let e=Me("tl-line").getBoundingClientRect();this.seek((t.clientX-e.left)/e.width*this.state.duration)}toggle(){this.send({do:this.state?.playing?"pause":"play"})}step(t){this.send({do:"step",by:t})}loop(){this.send({do:"loop",on:!this.state?.loop})}mark(t){let e={in:this.state.in,out:this.state.out};e[t]=e[t]!==null&&Math.abs(e[t]-this.state.position)<.001?null:this.state.position,e.in!==null&&e.out!==null&&e.out<=e.in&&(e[t==="in"?"out":"in"]=null),this.send({do:"mark",...e})}chosen(){let t=Me("tl-kind").value;return this.marks.filter(e=>!t||e[1]===t)}jump(t){let e=this.state.position,n=.004,i=this.chosen(),r=t>0?i.find(o=>o[0]>e+n):i.findLast(o=>o[0]<e-n);if(!r){this.toast(t>0?"No such event after this.":"No such event before this.");return}this.send({do:"pause"}),this.seek(r[0]),this.toast(r[2])}showMarks(t){this.marks=t.marks,this.leftOut=t.left_out,this.drawMarks()}drawMarks(){if(!this.state)return;let t=e=>`${100*e/Math.max(this.state.duration,1e-6)}%`;Me("tl-marks").replaceChildren(...this.chosen().map(([e,n,i])=>{let r=Object.assign(document.createElement("i"),{className:`mark-${n}`,title:`${Cm(e)} s  ${i}`});return r.style.left=t(e),r})),this.marksOf=`${this.state.log} ${this.state.duration}`}shelf(t){t.trouble&&this.toast(t.trouble);let e=JSON.stringify(t.logs.map(i=>[i.log,i.bytes]));if(e===this.shelfKey)return;this.shelfKey=e,this.logs=t.logs;let n=()=>t.logs.map(i=>dc(i.log,`${i.log} \xB7 ${qR(i.bytes)}`));Me("tl-log").replaceChildren(...n()),Me("tl-beside").replaceChildren(dc("","no second log"),...n()),this.state&&this.draw()}fileOf(t){return this.logs?.find(e=>e.log===t)?.file??t}nameOf(t){return this.logs?.find(e=>e.log===t||e.file===t)?.log??t}draw(){let t=this.state,e=(l,h)=>{let u=Me(l);u.textContent!==h&&(u.textContent=h)};e("tl-play",t.playing?"\u275A\u275A":"\u25B6"),e("tl-time",Cm(t.position)),e("tl-all",`of ${Cm(t.duration)} s`);let n=t.began_us>1e15?new Date((t.began_us+1e6*t.position)/1e3).toLocaleTimeString():"";e("tl-clock",n);let i=t.damage.places>0?`${t.damage.places} damaged places, ${t.damage.bytes} bytes`:"";e("tl-note",[t.scanned<1?`looking for events: ${Math.floor(100*t.scanned)} %`:"",i,t.beside&&!t.beside.shown?"the second log has nothing here":"",this.leftOut?`${this.leftOut} more events`:""].filter(Boolean).join(" \xB7 "));let r=l=>`${100*l/Math.max(t.duration,1e-6)}%`,o=this.dragging&&this.wanted!==null?this.wanted:t.position;Me("tl-head").style.left=r(o);let a=t.in??0,c=t.out??t.duration;Object.assign(Me("tl-range").style,{left:r(a),width:r(c-a)}),Me("tl-range").classList.toggle("marked",t.in!==null||t.out!==null),Me("tl-loop").classList.toggle("on",t.loop),Me("tl-in").classList.toggle("on",t.in!==null),Me("tl-out").classList.toggle("on",t.out!==null);for(let[l,h]of[["tl-speed",String(t.speed)],["tl-log",t.log],["tl-beside",t.beside?.log??""]])Me(l).value!==h&&document.activeElement!==Me(l)&&(Me(l).value=h);Me("tl-shift").parentElement.hidden=!t.beside,document.activeElement!==Me("tl-shift")&&(Me("tl-shift").value=t.beside?.shift??0),this.marksOf!==`${t.log} ${t.duration}`&&this.drawMarks()}};var re=s=>document.getElementById(s),YR=1,Py=2,jR=1500,ZR=80,$R=300,JR=1500,KR=3e3;document.body.classList.toggle("plain",mn);var Je=new Nd(re("view")),Mi=new Md(Je.scene),gc=new ya(Je.scene,16765503),Vd=new ya(Je.scene,16735581),xc=new ya(Je.scene,16751903);xc.wanted=!0;var kd=new bu(Je.scene),Te=new zu(s=>Kn.send(s)),bs=new Uu,Ei=new rd(re("plot-box"),bs,Xy),Iy=new ad(re("view")),Gd=new Mu(re("eye")),He=new Ud(s=>Kn.send(s),{jumped:()=>{bs.clear(),Te.forget()},fill:()=>{Ei.open&&Kn.send({do:"fill",seconds:Number(Ei.seconds.value)})},toast:s=>Te.toast(s)});Ei.seek=s=>He.active?(Kn.send({do:"pause"}),He.seek(s),!0):!1;function Vy(s){Mi.pose(s.q,s.base),Je.fitTo(Bd),Bd=null}var Fa={joints:[],hands:[]},ss=null,Bd=null,Im=0,Ly=-1/0,Ny=-1/0,Dy=-1/0,Ua=null,Od=null,mc={drawn:0,first:null},Uy=!1,Fy=!1,Kn=new Bu({connected:s=>{s||Te.connected(!1)},hello:s=>{Fa=s,String(bs.joints)!==String(s.joints)&&bs.clear(),bs.joints=s.joints,Te.hello(s),Je.fixed=s.fixed,ka.enabled=s.trusted&&!He.active,_o.allow(ka.enabled),Mi.load(s.joints,t=>{if(Mi.model!==t)return;let e=t.clone();for(let n of[gc,Vd,xc])n.adopt(e,s.joints);Bd=t,ss&&Vy(ss)}).then(jy).catch(t=>Te.toast(`The robot cannot be shown: ${t.message}`))},live:s=>{ss=s,Im=performance.now(),Te.connected(!0)},signals:s=>{Fa.joints.length!==0&&ky(s,ss)},replay:s=>{let t=!He.active;He.replay(s),Te.replaying(s),Im=performance.now(),Te.connected(!0),t&&(ka.enabled=!1,_o.allow(!1))},marks:s=>He.showMarks(s),shelf:s=>{if(He.shelf(s),!Fy&&He.active){Fy=!0;for(let t of xx(He))Kn.send(t)}},past:s=>{if(s.jumps===He.state?.jumps){bs.clear();for(let[t,e]of s.rows)ky(t,e);Ei.rebuild()}},status:s=>Te.status(s),scene:s=>{Je.shapes.show(s),Je.takeIn(s)},camera:s=>Gd.picture(s),recording:s=>tC(s),path:s=>{Od=s,s.status!=="ok"&&Te.toast(`No arm path: ${s.status}.`)},note:s=>Te.toast(s.text),refused:()=>Te.refused()});function ky(s,t){let{type:e,time:n,log_s:i,...r}=s,o=t??{};r.SHOWN={base:o.base?.slice(0,3),com:o.com,zmp:o.zmp,zmp_reference:o.zmp_reference,dcm:o.dcm,margin_mm:o.margin_mm,foot_force:Object.fromEntries((o.feet??[]).map((a,c)=>[a,o.foot_force[c]]))},bs.add(i??n,r,t)}function Wd(){if(He.active){He.toggle();return}ka.release();let s=performance.now(),t=s-Dy<KR?Py:YR;Dy=s,Kn.send({do:"stop",kind:t})?Te.toast(t===Py?"Stop (hold) sent.":"Stop sent. Once more: hold at once."):Te.toast("STOP COULD NOT BE SENT: use ./twinbus stop or the robot's own switch.")}var zd=new Ed(re("setup"),{near:()=>ss?.pairs??[],send:s=>Kn.send(s),toast:s=>Te.toast(s)}),_o=new Hu(re("parts"),Mi,{send:s=>Kn.send(s),toast:s=>Te.toast(s)}),ka=new Fu(re("joystick"),re("speed"),s=>Kn.send({do:"walk",...s}),()=>{Te.mode!=="walk"&&Kn.send({do:"mode",mode:"walk"})}),Gy=new vu(ka,Wd,re("pad")),Wy=new Nu(Je,re("view"),(s,t)=>{Kn.send({do:"reach",side:s,at:t}),Te.toast(`The ${s} hand is asked to go there.`)}),Oy=[...document.querySelectorAll("#reach button")];for(let s of Oy)s.onclick=()=>{let t=Wy.offer(s.dataset.side,ss?.hands);for(let e of Oy)e.classList.toggle("on",t&&e===s);re("reach-note").hidden=!t,re("reach-note").textContent="Drag the handle in the picture; the hand goes where you let go.",s.blur()};re("stop").onpointerdown=Wd;re("stop").onkeydown=s=>{s.key==="Enter"&&!s.repeat&&Wd()};re("clear").onclick=()=>Kn.send({do:"clear"});var Pm=s=>{Kn.send({do:"sim",...s})||Te.toast("The viewer process does not answer.")},cr={pause:()=>Pm({action:Te.paused?"go":"pause"}),step:s=>Pm({action:"step",ticks:s}),slow:()=>Pm({action:"pace",pace:Te.slowed?1:.1}),reset:()=>Kn.send({do:"reset"})},Hd=new od(Je,re("view"),Mi,s=>Kn.send({do:"push",...s}),s=>Te.toast(s)),yo=(s,t)=>{re(s).onclick=()=>{t(),re(s).blur()}};yo("sim-pause",cr.pause);yo("sim-step",()=>cr.step(1));yo("sim-ten",()=>cr.step(50));yo("sim-slow",cr.slow);yo("sim-reset",cr.reset);yo("anew",cr.reset);yo("sim-push",()=>re("sim-push").classList.toggle("on",Hd.arm(!Hd.armed)));Hd.done=()=>re("sim-push").classList.remove("on");function is(s,t){let e=re(s);return e.onclick=()=>{t(e.classList.toggle("on")),e.blur()},()=>e.onclick()}function Xy(s){Ua=s===null?null:bs.pictureAt(s),document.body.classList.toggle("past",Ua!==null),re("past").hidden=Ua===null,Ua&&(re("past-text").textContent=`Looking back: robot time ${Ua.time.toFixed(2)} s. The robot goes on.`)}var qy=new Dd(s=>{Je.theme(s),Ei.rebuild(),re("light").textContent=s?"dark":"light"});re("light").onclick=()=>{qy.toggle(),re("light").blur()};re("present").onclick=()=>Ei.hold(null);var Jn={follow:is("follow",s=>{Je.follow=s}),forces:is("show-forces",s=>{Je.forces.visible=s}),balance:is("show-balance",s=>{Je.balance.visible=s}),command:is("show-command",s=>{gc.wanted=s}),standby:is("show-standby",s=>{Vd.wanted=s,s&&!ss?.standby&&Te.toast("No standby source is heard: ./twinbus up --stack both has one.")}),plots:is("show-plots",s=>{Ei.toggle(s),s?He.active&&He.fill():Ei.hold(null)}),other:is("show-other",s=>{xc.wanted=s}),panels:is("show-panels",s=>document.body.classList.toggle("no-panels",!s)),setup:is("show-setup",s=>{s&&_o.open&&Jn.parts(),zd.toggle(s)}),parts:is("show-parts",s=>{s&&zd.open&&Jn.setup(),_o.toggle(s)}),eye:is("show-eye",s=>Gd.toggle(s)),record:is("record",s=>{re("record").classList.toggle("recording",s),s?Iy.start()||Te.toast("This browser cannot record."):Iy.stop()})},[By,fc]=re("arrow-scale").querySelectorAll("input");By.oninput=()=>{Je.arrowScale=2**Number(By.value)};fc.oninput=()=>{Je.leastForce=Number(fc.value),re("arrow-least").textContent=`${fc.value} N`,fc.title=`forces under ${fc.value} N are not drawn`};re("record-log").onclick=()=>{Kn.send({do:"record",on:!re("record-log").classList.contains("recording")})||Te.toast("The viewer does not answer."),re("record-log").blur()};var QR=0;function tC({on:s,text:t}){re("record-log").classList.toggle("recording",s),re("record-log").textContent=s?"end the log":"log",QR++>0&&t&&Te.toast(t)}re("more").onclick=()=>{let s=document.querySelector("footer nav").classList.toggle("open");re("more").setAttribute("aria-expanded",String(s)),re("more").textContent=s?"less":"more \u2026",re("more").blur()};function pc(s){He.active?s():Te.toast("For recordings: ./twinbus view shows one.")}function zy(s,t){He.active&&(t.shiftKey?He.seek(He.state.position+s):He.step(s))}async function Yy(){let s=mx(Je,Ei,He);window.history.replaceState(null,"",s);let t=!0;try{await navigator.clipboard.writeText(s)}catch{t=!1}Te.toast(t?"The address of this view is copied.":"The address of this view is in the address bar.")}re("link").onclick=()=>{Yy(),re("link").blur()};var Fd=s=>()=>{!He.active&&Te.trusted&&s()},Hy=new ku([["f","F","camera follows the robot",Jn.follow],["c","C","contact forces",Jn.forces],["b","B","soles, support, ZMP, CoM, DCM",Jn.balance],["g","G","ghost of the commanded posture",Jn.command],["j","J","ghost of the standby source",Jn.standby],["p","P","plots",Jn.plots],["l","L","look back, and to now again",()=>{Ei.held!==null?Ei.hold(null):(Ei.hold(bs.last),Xy(bs.last))}],["h","H","panels at the sides",Jn.panels],["t","T","dark or light",()=>qy.toggle()],["n","N","ghost of the second log",Jn.other],["y","Y","the address of this view",Yy],["ArrowLeft","\u2190 \u2192","recording: the state before, the next (with shift a second)",s=>zy(-1,s)],["ArrowRight","","",s=>zy(1,s)],["[","[ ]","recording: the event before, the next",()=>pc(()=>He.jump(-1))],["]","","",()=>pc(()=>He.jump(1))],["i","I O","recording: the loop begins here, ends here",()=>pc(()=>He.mark("in"))],["o","","",()=>pc(()=>He.mark("out"))],["k","K","recording: loop",()=>pc(()=>He.loop())],["m","M","simulated world: pause, go on",Fd(cr.pause)],[".",". ,","simulated world: one tick, a tenth of a second",Fd(()=>cr.step(1))],[",","","",Fd(()=>cr.step(50))],["x","X","push the simulated robot: pull at it in the picture",Fd(()=>re("sim-push").onclick())],["s","S","set up: scene, posture, pushes, checked pairs",Jn.setup],["q","Q","links and joints: what is drawn, a slider for each joint",Jn.parts],["e","E","what the robot's camera sees",Jn.eye],["r","R","record a log, and end it",()=>{He.active||re("record-log").onclick()}],["v","V","record a video of the view",Jn.record]],Wd,re("keys"));re("help").onclick=()=>{Hy.sheet.hidden=!Hy.sheet.hidden,re("help").blur()};function eC(){if(Uy&&(mc.first??=performance.now()),ss){let s=performance.now();s-Im>jR&&s-Ly<$R&&Te.connected(!1),Ly=s;let t=Ua?.live??ss;Mi.pose(t.q,t.base),Bd&&Mi.whole&&Vy(t),Je.shapes.carry(Mi.model),Mi.dim(!Te.online||t.age_ms===null||t.age_ms>500||t.role==="parked");let e=Mi.warn(t.q,t.pairs);Od&&Mi.whole&&(kd.show(Od,gc.model,Fa.hands,ss,Fa.joints),Od=null),gc.pose(t.command,t.base),Vd.pose(t.standby?.q,t.base),xc.pose(t.other?.q??zd.posture(Fa.joints)??_o.posture(Fa.joints,t.q),t.other?.base??t.base),Je.show(t),_o.tick(t.q),s-Ny>=ZR&&(Ny=s,Te.live(ss),Te.limits(e))}kd.tick(),Gy.tick(),Ei.tick(),He.tick(),Gd.tick(Je,Mi.model,[...Je.onTop,kd.group]),mc.drawn===0?Je.drawFirst(Mi.model):Je.draw(),++mc.drawn,Uy=ss!==null&&Mi.whole}Px(Jn.panels);gx(Je,Ei)&&Jn.plots();Wl().get("follow")==="0"&&Jn.follow();function jy(){mc.drawn===0&&Je.renderer.setAnimationLoop(eC)}setTimeout(jy,JR);Kn.connect();globalThis.twinbus={figures:mc,link:Kn,history:bs,plots:Ei,stage:Je,robot:Mi,commanded:gc,standby:Vd,armPath:kd,joystick:ka,target:Wy,timeline:He,other:xc,setup:zd,parts:_o,eye:Gd,chips:Jn,panels:Te,pad:Gy,pusher:Hd};
