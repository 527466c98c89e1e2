% octave_pinv.m SCENE...: the way of the paper in GNU Octave: dense A, pinv, classical RK4 of constant step.
1;

function scene = read_scene(path)
  scene = struct("r", zeros(3, 0), "v", zeros(3, 0), "far", zeros(3, 0), "watched", zeros(3, 0));
  for line = strsplit(strtrim(fileread(path)), "\n")
    [word, rest] = strtok(line{1});
    numbers = sscanf(rest, "%f");
    switch word
      case "to"
        scene.to = numbers;
      case "mass"
        scene.r(:, end + 1) = numbers(1:3);
        scene.v(:, end + 1) = numbers(4:6);
      case "far"
        scene.far = numbers;
      case "watch"
        scene.watched(:, end + 1) = numbers;
    end
  end
end

function rate = rates(y, masses, far)
  r = reshape(y(1:3*masses), 3, masses);
  v = reshape(y(3*masses+1:end), 3, masses);
  rod = diff([zeros(3, 1), r, far], 1, 2);
  speed = diff([zeros(3, 1), v, zeros(size(far))], 1, 2);
  rods = columns(rod);
  a = zeros(rods, 3*masses);
  for k = 1:rods
    if k <= masses
      a(k, 3*k-2:3*k) = rod(:, k)';
    end
    if k > 1
      a(k, 3*k-5:3*k-3) = -rod(:, k)';
    end
  end
  b = -sum(speed.^2, 1)';
  free = repmat([0; 0; -9.81], masses, 1);
  rate = [y(3*masses+1:end); free + pinv(a) * (b - a*free)];
end

function y = rk4(y, masses, far, h, steps)
  for i = 1:steps
    k1 = rates(y, masses, far);
    k2 = rates(y + h/2*k1, masses, far);
    k3 = rates(y + h/2*k2, masses, far);
    k4 = rates(y + h*k3, masses, far);
    y += h/6*(k1 + 2*k2 + 2*k3 + k4);
  end
end

patience = 1;  % seconds: steps are not made finer once a run takes longer
for path = argv()'
  scene = read_scene(path{1});
  [~, name] = fileparts(path{1});
  masses = columns(scene.r);
  steps = 64;
  do
    begin = cputime();
    y = rk4([scene.r(:); scene.v(:)], masses, scene.far, scene.to/steps, steps);
    seconds = cputime() - begin;
    r = reshape(y(1:3*masses), 3, masses);
    error = 0;
    for w = scene.watched
      error = max(error, abs(r(w(2) + 1, w(1) + 1) - w(3)));
    end
    printf("%s\tOctave, rk4 with pinv\t%d\t%.4g\t%.3g\n", name, steps, seconds, error);
    steps *= 2;
  until seconds > patience
end
