#include <cstdio>
#include <cstdlib>
#include <vector>
#include "bench/calibration/simulated_recording.hpp"
using namespace tandem; using namespace tandem::bench;
int main(int argc,char**argv){ int n=argc>1?atoi(argv[1]):5; double mx[5]={};double nees=0; std::vector<double> per(7,0);
 for(int s=1;s<=n;s++){ RecordingOptions o; PairOptions po; if(argc>2){po.way_m=po.turn_rad=atof(argv[2]);} if(argc>3)o.range_deviation_m=atof(argv[3]); if(argc>4)o.slip_share=atof(argv[4]); if(argc>5)o.wheel_noise_m=atof(argv[5]); auto r=simulated_recording(s,o); auto pairs=motion_pairs(r.drive,po,[](double){return true;}); auto c=calibrated(r.drive.odometry,pairs,r.start); auto e=errors_of(c,r);
  printf("%d pairs %zu wheels %.4f%% laser %.2f mm %.3f deg clock %.2f ms nees %.2f spread %.4f %.4f %.4f\n",s,pairs.size(),100*e.wheels_share,1000*e.laser_m,e.laser_deg,1000*e.clock_s,e.nees,c.spread(0),c.spread(1),c.spread(2));
  double v[5]={e.wheels_share,e.laser_m,e.laser_deg,e.clock_s,0}; for(int i=0;i<4;i++) mx[i]=std::max(mx[i],v[i]); nees+=e.nees;
  double off[7]={c.wheels.left_wheel_scale-r.wheels.left_wheel_scale,c.wheels.right_wheel_scale-r.wheels.right_wheel_scale,c.wheels.track_scale-r.wheels.track_scale,c.base_from_laser.x-r.base_from_laser.x,c.base_from_laser.y-r.base_from_laser.y,turn_between(r.base_from_laser.heading,c.base_from_laser.heading),c.laser_clock_s-r.laser_clock_s};
  for(int i=0;i<7;i++){per[i]+=off[i]*off[i]/c.covariance(i,i);} 
  for(int i=0;i<7;i++)printf(" %+.2g(%.2g)",off[i],sqrt(c.covariance(i,i)));
 printf("\n");
 }
 printf("max wheels %.3f%% laser %.2f mm %.3f deg clock %.2f ms; nees %.3f; per",100*mx[0],1000*mx[1],mx[2],1000*mx[3],nees/n); for(double p:per)printf(" %.2f",p/n); printf("\n");}
