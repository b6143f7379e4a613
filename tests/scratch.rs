use infoscene::form_factor::*; use infoscene::geometry::Patch; use glam::DVec3;
fn pts(s:&str)->Vec<DVec3>{ s.split(' ').map(|c|{let v:Vec<f64>=c.split(',').map(|x|x.parse().unwrap()).collect();DVec3::new(v[0],v[1],v[2])}).collect()}
#[test] fn rows(){
 for l in std::fs::read_to_string("/tmp/ff.txt").unwrap().lines(){
  let f:Vec<&str>=l.split('|').collect();
  let (p,q)=(Patch::try_new(pts(f[1])),Patch::try_new(pts(f[2])));
  let (p,q)=match (p,q){(Ok(p),Ok(q))=>(Polygon::new(&p),Polygon::new(&q)),(a,b)=>{println!("{} {:?} {:?}",f[0],a.err(),b.err());continue}};
  let x:f64=f[3].parse().unwrap();
  let t=std::time::Instant::now();
  let mut r=p.exchange_area(&q,1e-12);
  for _ in 0..100 { r=p.exchange_area(&q,1e-12); }
  let t=t.elapsed().as_secs_f64()/101.0*1e6;
  match r{Ok(a)=>{let v=a.exchange.value;println!("{:28} {:.3e} err {:.1e} bound {:.1e} {} {:.2}us {}",f[0],x,(v-x).abs()/x,a.exchange.error_bound/x,a.route.name(),t,if (v-x).abs()>a.exchange.error_bound+2e-16*x {"VIOLATION"} else {""})},Err(e)=>println!("{} {e}",f[0])}
 }
}
