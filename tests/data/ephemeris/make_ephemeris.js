// Makes sun_moon.csv and lunar_eclipses.csv with Astronomy Engine 2.1.19 (Don Cross, MIT), which shares
// neither series nor code with libnova: npm pack astronomy-engine@2.1.19, unpack, then
//   node make_ephemeris.js package/astronomy.js
const A = require(require('path').resolve(process.argv[2]));
const fs = require('fs');
const path = require('path');

// The numbers of a linear congruential generator (Numerical Recipes): the same rows every time.
let state = 2026;
const random = () => (state = (Math.imul(state, 1664525) + 1013904223) >>> 0) / 4294967296;

const fixed = (x, n) => x.toFixed(n);
const rows = ['utc_s,latitude_deg,longitude_deg,sun_azimuth,sun_elevation,moon_azimuth,moon_elevation,' +
              'moon_lit,libration_latitude,libration_longitude'];
const places = [[90, 0], [-90, 0], [89.9, 37], [-89.9, -120], [0, 180], [10, -180], [-45, 179.99], [66.6, -180]];
for (let i = 0; i < 240; ++i) {
  // 200 rows from 1950 to 2100; then the rest of 1600 to 2200.
  const years = i < 200 ? [1950, 2100] : i < 220 ? [1600, 1950] : [2100, 2200];
  const from = Date.UTC(years[0], 0, 1), to = Date.UTC(years[1], 11, 31);
  const utc = Math.round((from + (to - from) * random()) / 1000);
  const [latitude, longitude] =
      i % 10 == 0 ? places[(i / 10) % places.length]
                  : [Math.asin(2 * random() - 1) * 180 / Math.PI, 360 * random() - 180];
  const date = new Date(utc * 1000), observer = new A.Observer(latitude, longitude, 0);
  const row = [utc, fixed(latitude, 6), fixed(longitude, 6)];
  for (const body of ['Sun', 'Moon']) {
    const place = A.Equator(body, date, observer, true, true);
    const seen = A.Horizon(date, observer, place.ra, place.dec, null);
    row.push(fixed(seen.azimuth, 4), fixed(seen.altitude, 4));
  }
  row.push(fixed(A.Illumination('Moon', date).phase_fraction, 5));
  const libration = A.Libration(date);
  row.push(fixed(libration.elat, 3), fixed(libration.elon, 3));
  rows.push(row.join(','));
}
fs.writeFileSync(path.join(__dirname, 'sun_moon.csv'), rows.join('\n') + '\n');

const eclipses = ['peak_utc_s,kind,penumbral_min,partial_min,total_min'];
let eclipse = A.SearchLunarEclipse(new Date(Date.UTC(2020, 0, 1)));
for (let i = 0; i < 20; ++i) {
  eclipses.push([Math.round(eclipse.peak.date.getTime() / 1000), eclipse.kind, fixed(eclipse.sd_penum, 2),
                 fixed(eclipse.sd_partial, 2), fixed(eclipse.sd_total, 2)].join(','));
  eclipse = A.NextLunarEclipse(eclipse.peak);
}
fs.writeFileSync(path.join(__dirname, 'lunar_eclipses.csv'), eclipses.join('\n') + '\n');
